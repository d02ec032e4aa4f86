// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A lattice of 1024 members that falls about a hinge, by three integrators, and 20 modes of it.

#include "lattice.hpp"

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/modal.hpp>
#include <ancf/suitesparse/cholmod.hpp>

#include <cstddef>
#include <cstdio>
#include <string>

namespace ancf::bench {
namespace {

constexpr int length = 26, width = 4;  // joints

/// A beam of 6.25 m along X, made of bars, on a hinge about Y or clamped at its first face.
struct Swing {
    Model model;
    int members;

    explicit Swing(bool clamped) {
        const Lattice lattice{length, width, width};
        const auto built = frame<CrossSectionBeam<3>>(model, {Lattice::bar()}, lattice.points(),
                                                      lattice.members(1));
        members = static_cast<int>(built.members.size());
        for (int j = 0; j < width; ++j)
            for (int k = 0; k < width; ++k) {
                const NodeId joint = built.joints[static_cast<std::size_t>(lattice.place(0, j, k))];
                if (clamped)
                    model.clamp(joint);
                else if (k == 0)
                    model.pin(joint);
            }
        if (!clamped) model.set_gravity({0.0, 0.0, -9.81});
    }
};

struct Row {
    const char* integrator;
    double bound;  // step, s, or tolerance
    double took;   // s
    int members;
    DynamicsReport report;
};

bool print(const Row& row, bool csv) {
    const DynamicsReport& of = row.report;
    std::printf(
        csv ? "%s,%g,%d,%ld,%ld,%.2e,%.4f,%.1f\n" : "%-18s %8g %8d %6ld %8ld %10.2e %9.4f %8.1f\n",
        row.integrator, row.bound, row.members, of.steps, of.factorisations,
        of.energy_drift / of.kinetic_largest, of.time, row.took);
    std::fflush(stdout);
    if (of.status == Status::converged) return true;
    std::printf("%s: %s\n", row.integrator, of.message.c_str());
    return false;
}

template <class Integrator, class Options>
bool swing(const char* name, double bound, const Options& options, double duration, bool csv) {
    Swing scene(false);
    ProblemOptions problem_options;
    problem_options.storage = Storage::lower;
    DynamicProblem problem(scene.model, problem_options);
    suitesparse::Cholmod solver;
    const double start = seconds();
    DynamicsReport report =
        Integrator(options).integrate(problem, solver, equal_intervals(0.0, duration, duration));
    return print({name, bound, seconds() - start, scene.members, std::move(report)}, csv);
}

bool modes(bool csv) {
    Swing scene(true);
    suitesparse::Cholmod solver;
    ModalOptions options;
    options.count = 20;
    const double start = seconds();
    const ModalReport report = natural_modes(scene.model, solver, options);
    const double took = seconds() - start;
    if (report.status != Status::converged) {
        std::printf("modes: %s\n", report.message.c_str());
        return false;
    }
    std::printf(
        csv ? "modes,%.4f,%d,%d,,%.2e,%.4f,%.1f\n"
            : "20 modes from %.4f Hz, %d members, %d iterations, residual %.2e, to %.4f Hz, "
              "%.1f s\n",
        report.modes.front().frequency(), scene.members, report.iterations,
        report.modes.back().residual, report.modes.back().frequency(), took);
    return true;
}

}  // namespace

bool run_motion(double duration, bool csv) {
    if (csv)
        std::printf("integrator,bound,members,steps,factorisations,drift,reached,seconds\n");
    else
        std::printf("%-18s %8s %8s %6s %8s %10s %9s %8s\n", "integrator", "step", "members",
                    "steps", "factors", "drift", "reached", "seconds");
    bool good = modes(csv);
    for (const double step : {5e-3, 2.5e-3}) {
        GeneralizedAlphaOptions options;
        options.step = step;
        good = swing<GeneralizedAlpha>("generalized-alpha", step, options, duration, csv) && good;
    }
    for (const double step : {5e-3, 2.5e-3}) {
        EnergyMomentumOptions options;
        options.step = step;
        good = swing<EnergyMomentum>("energy-momentum", step, options, duration, csv) && good;
    }
    RadauOptions options;
    options.tolerance = 1e-4;
    return swing<RadauIIA>("radau", options.tolerance, options, duration, csv) && good;
}

}  // namespace ancf::bench
