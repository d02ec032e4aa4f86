// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A pendulum that a step turns by far more than it strains: energy-momentum beside
/// generalized-alpha at equal steps, in turn. CSV on stdout.
///
/// The rubber pendulum of [Dufva2006, section 5.1] of a material `stiffer` times as stiff. The
/// error is the largest distance of the tip from a reference solution at a hundred times; the
/// reference is generalized-alpha without damping and with steps a hundredth as long.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/error.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints/points.hpp>
#include <ancf/model/model.hpp>
#include <ancf/output/csv.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>

#include <integrators.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace {

using Point = ancf::Vector<double, 3>;

/// What is measured.
struct Case {
    double stiffer = 1e5;
    double link = 0.0;  // m; 0: pinned
    double step = 1e-3;
    double duration = 5.0;
    int elements = 4;
    int repeats = 5;
};

/// What a run gave.
struct Run {
    ancf::DynamicsReport report;
    std::vector<Point> tips;
    double seconds = 0.0;  // of one processor
};

Run run(const Case& problem, bool energy_momentum, double step, double rho) {
    ancf::Model model;
    const auto material =
        ancf::Material::from_moduli(0.7e6 * problem.stiffer, 2.6923e5 * problem.stiffer, 5540.0);
    const auto section = ancf::rectangle(0.05, 0.05).with_shear_correction(5.0 / 6.0, 5.0 / 6.0);
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
        model, material, section, Point::Zero(), {1.2, 0.0, 0.0}, problem.elements,
        ancf::CrossSectionOptions::paper());
    if (problem.link > 0.0)
        model.add(ancf::Distance<3>(beam.first(), Point(0.0, problem.link, 0.0), problem.link));
    else
        model.pin(beam.first());
    model.set_gravity({0.0, -9.81, 0.0});
    const int tip = model.coordinate(beam.last(), ancf::Field::r);

    Run result;
    ancf::Schedule schedule =
        ancf::equal_intervals(0.0, problem.duration, problem.duration / 100.0);
    schedule.observe = [&](const ancf::Snapshot& seen) {
        result.tips.push_back(seen.state.q.segment<3>(tip));
    };
    ancf::DynamicProblem of_model(model);
    const auto general = ancf::bench::solver_named(ancf::bench::general_solver);
    ancf::LinearSolver& solver = *general;
    const std::clock_t began = std::clock();
    if (energy_momentum) {
        ancf::EnergyMomentumOptions options;
        options.step = step;
        result.report = ancf::EnergyMomentum(options).integrate(of_model, solver, schedule);
    } else {
        ancf::GeneralizedAlphaOptions options;
        options.step = step;
        options.rho = rho;
        result.report = ancf::GeneralizedAlpha(options).integrate(of_model, solver, schedule);
    }
    result.seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
    return result;
}

double error(const Run& got, const Run& exact) {
    double largest = 0.0;
    for (std::size_t k = 0; k < std::min(got.tips.size(), exact.tips.size()); ++k)
        largest = std::max(largest, (got.tips[k] - exact.tips[k]).norm());
    return largest;
}

void measure(const Case& problem) {
    const Run exact = run(problem, false, 0.01 * problem.step, 1.0);
    ancf::detail::require(exact.report.status == ancf::Status::converged,
                          "the reference failed: ", exact.report.message);
    std::vector<std::vector<Run>> runs(2);
    for (int k = 0; k < problem.repeats; ++k)
        for (const bool energy_momentum : {false, true})
            runs[energy_momentum ? 1 : 0].push_back(
                run(problem, energy_momentum, problem.step, 0.8));
    ancf::CsvWriter csv(std::cout,
                        {"integrator", "step", "steps", "failed", "linear_solves", "factorisations",
                         "energy_drift", "error", "cpu_least", "cpu_median", "status"});
    for (std::vector<Run>& all : runs) {
        std::sort(all.begin(), all.end(),
                  [](const Run& a, const Run& b) { return a.seconds < b.seconds; });
        const ancf::DynamicsReport& report = all.front().report;
        csv.row(&all == runs.data() ? "generalized-alpha 0.8" : "energy-momentum", problem.step,
                report.steps, report.convergence_failures, report.iterations, report.factorisations,
                report.energy_drift / report.kinetic_largest, error(all.front(), exact),
                all.front().seconds, all[all.size() / 2].seconds, to_string(report.status));
    }
}

}  // namespace

int main(int argc, char** argv) {
    Case problem;
    CLI::App app("A stiff pendulum by energy-momentum and generalized-alpha: CSV on stdout.");
    app.add_option("--stiffer", problem.stiffer, "than rubber, times")->check(CLI::PositiveNumber);
    app.add_option("--link", problem.link, "length of a massless link, m; 0: pinned")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--step", problem.step, "s")->check(CLI::PositiveNumber);
    app.add_option("--duration", problem.duration, "s")->check(CLI::PositiveNumber);
    app.add_option("--elements", problem.elements, "number of elements")
        ->check(CLI::Range(1, 1000));
    app.add_option("--repeats", problem.repeats, "of each run")->check(CLI::Range(1, 1000));
    app.add_flag("--csv", "comma-separated values, which it always prints");
    CLI11_PARSE(app, argc, argv);
    try {
        measure(problem);
    } catch (const std::exception& failure) {
        std::cerr << failure.what() << '\n';
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
