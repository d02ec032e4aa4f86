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

#include <ancf/assembly/assembly.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_ldlt.hpp>

#include <CLI/CLI.hpp>

#include <counting.hpp>
#include <peak.hpp>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using namespace ancf;

struct Settings {
    bool csv = false;
    int repeats = 200;
    int elements = 1000;
};

struct Cost {
    std::string element;
    int coordinates;    ///< of an element
    long operations;    ///< of force and tangent
    double evaluation;  ///< of force and tangent, ns
    double assembly;    ///< of the scene's force and tangent, us
    double solution;    ///< factorisation and solution, us
};

/// Returns nanoseconds of one call: the least of many runs.
template <class Call>
double nanoseconds(const Call& call, int calls, int repeats) {
    double best = 1e9;
    for (int repeat = 0; repeat < repeats; ++repeat) {
        const double start = bench::detail::now();
        for (int k = 0; k < calls; ++k) call();
        best = std::min(best, bench::detail::now() - start);
    }
    return best / calls * 1e9;
}

volatile double sink;

/// Returns an element's options with the rule "mixed".
template <class Element>
typename Element::Options mixed() {
    typename Element::Options options;
    options.rule = Rule::mixed();
    return options;
}

template <class Element>
Cost measure(const char* name, const Settings& settings,
             const typename Element::Options& options = mixed<Element>()) {
    using Point = Vector<double, Element::dimension>;
    BasicModel<Element::dimension> model;
    const auto material = Material::isotropic(2e11, 0.3, 7800.0);
    const Point from = Point::Zero(), to = Point::Unit(0) * 0.1 * settings.elements;
    const auto beam = straight_beam<Element>(model, material, rectangle(0.02, 0.02), from, to,
                                             settings.elements, options);
    model.clamp(beam.first());
    State& state = model.state();
    for (int k = 0; k < state.q.size(); ++k) state.q[k] += 1e-3 * ((k * 37) % 11 - 5);

    Cost cost{name, Element::dofs, 0, 0.0, 0.0, 0.0};
    const Element& element = model.template group<Element>().element(0);
    typename Element::Coordinates e = model.template element_coordinates<Element>(1);
    Vector<bench::Counting, Element::dofs> counted;
    for (int k = 0; k < Element::dofs; ++k) counted[k] = e[k];
    bench::Counting::reset();
    sink = element.evaluate(counted).energy.value();
    cost.operations = bench::Counting::operations();
    cost.evaluation = nanoseconds(
        [&] {
            const auto evaluation = element.evaluate(e);
            e[0] += 1e-12 * evaluation.force[1] / (1.0 + evaluation.tangent(1, 1));
        },
        20, settings.repeats);
    sink = e[0];

    EigenLdlt solver;
    Assembly assembly(model, solver.storage());
    solver.analyze(assembly.tangent());
    const VectorX rest = VectorX::Zero(state.q.size());
    const int repeats = std::max(3, settings.repeats / 20);
    const auto assemble = [&] {
        if (assembly.evaluate({state.q, rest, state.multipliers, {0.0, 1.0}}, Request::tangent))
            std::fprintf(stderr, "%s: the state is not admissible\n", name);
    };
    cost.assembly = nanoseconds(assemble, 1, repeats) * 1e-3;
    VectorX residual, correction;
    assembly.residual(residual);
    const auto solve = [&] {
        if (solver.factorize(assembly.tangent()).status != Status::converged)
            std::fprintf(stderr, "%s: the tangent has no factors\n", name);
        solver.solve(residual, correction);
        sink = correction[0];
    };
    cost.solution = nanoseconds(solve, 1, repeats) * 1e-3;
    return cost;
}

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
    measure<CrossSectionBeam<3>>("", settings);  // the first runs warm the processor up
    const Cost beam = measure<CrossSectionBeam<3>>("CrossSectionBeam<3>", settings);
    report(
        settings,
        {measure<Cable<2>>("Cable<2>", settings, {}), measure<Cable<3>>("Cable<3>", settings, {}),
         measure<CrossSectionBeam<2>>("CrossSectionBeam<2>", settings),
         measure<PlanarQuinticBeam<>>("PlanarQuinticBeam<>", settings, {}),
         measure<TorsionBeam>("TorsionBeam", settings), beam,
         measure<CrossSectionBeam<3, Geodesic>>("CrossSectionBeam<3, Geodesic>", settings),
         measure<QuinticBeam<>>("QuinticBeam<>", settings, {})},
        beam);
    return 0;
}
