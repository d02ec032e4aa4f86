// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What a scene pays for the elements it is made of: cables and beams, in the plane and in space,
/// at equal mesh.
///
/// For each element the time and the operations of one force and tangent, and the time of one
/// Newton step (assembly, factorisation, solution) of a cantilever; beside them the ratio to the
/// spatial cross-section beam and that of the coordinates. Cables and quintic beams by their own
/// rules, all others by the rule "mixed"; factorisation by Eigen's sparse L D L^T.
///
///     element_cost --csv > element_cost.csv

#include <CLI/CLI.hpp>

#include <element_cost/measure.hpp>

#include <cstdio>
#include <vector>

namespace {

using namespace ancf::bench::element_cost;

/// @param reference  what the ratios divide: what it takes over what an element takes
void report(const Settings& settings, const std::vector<Cost>& costs, const Cost& reference) {
    std::puts(
        settings.csv
            ? "element,coordinates,operations,evaluation_ns,assembly_us,solution_us,step_us,"
              "coordinates_ratio,operations_ratio,evaluation_ratio,step_ratio"
            : "element                        coords  operations  force+tangent, ns  assembly, us  "
              "solution, us  step, us   ratio of coords  operations  force+tangent  step");
    for (const Cost& cost : costs) {
        const double step = cost.assembly + cost.solution;
        std::printf(
            settings.csv
                ? "\"%s\",%d,%ld,%.1f,%.1f,%.1f,%.1f,%.3f,%.3f,%.3f,%.3f\n"
                : "%-30s %6d %11ld %18.1f %13.1f %13.1f %9.1f %17.2f %11.2f %14.2f %5.2f\n",
            cost.element.c_str(), cost.coordinates, cost.operations, cost.evaluation, cost.assembly,
            cost.solution, step, static_cast<double>(reference.coordinates) / cost.coordinates,
            static_cast<double>(reference.operations) / static_cast<double>(cost.operations),
            reference.evaluation / cost.evaluation,
            (reference.assembly + reference.solution) / step);
    }
}

}  // namespace

int main(int argc, char** argv) {
    Settings settings;
    CLI::App app("The cost of elements at equal mesh.");
    app.add_flag("--csv", settings.csv, "comma-separated values");
    app.add_option("--repeats", settings.repeats, "runs to take the least of")
        ->check(CLI::Range(1, 1'000'000));
    app.add_option("--elements", settings.elements, "elements of the cantilever")
        ->check(CLI::Range(2, 1'000'000));
    CLI11_PARSE(app, argc, argv);
    plane(settings);  // the first runs warm the processor up
    std::vector<Cost> costs = plane(settings);
    const std::vector<Cost> spatial = space(settings);
    costs.insert(costs.end(), spatial.begin(), spatial.end());
    report(settings, costs, spatial.front());
    return 0;
}
