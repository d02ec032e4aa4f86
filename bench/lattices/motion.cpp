// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A lattice of 1024 members that falls about a hinge, or flies free, by each integrator, and 20
/// modes of it.

#include "lattice.hpp"

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/momentum.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/modal.hpp>
#include <ancf/suitesparse/cholmod.hpp>

#if ANCF_WITH_SUNDIALS
#include <ancf/sundials/ida.hpp>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>

namespace ancf::bench {
namespace {

using Point3 = Vector<double, 3>;

constexpr int length = 26, width = 4;  // joints

enum class Held { clamped, hinge, free };

/// A beam of 6.25 m along X, made of bars: clamped at its first face, on a hinge about Y there, or
/// free, turning and swinging in bending.
struct Swing {
    Model model;
    int members;

    explicit Swing(Held held) {
        const Lattice lattice{length, width, width};
        const auto built = frame<CrossSectionBeam<3>>(model, {Lattice::bar()}, lattice.points(),
                                                      lattice.members(1));
        members = static_cast<int>(built.members.size());
        for (int j = 0; j < width; ++j)
            for (int k = 0; k < width; ++k) {
                const NodeId joint = built.joints[static_cast<std::size_t>(lattice.place(0, j, k))];
                if (held == Held::clamped)
                    model.clamp(joint);
                else if (held == Held::hinge && k == 0)
                    model.pin(joint);
            }
        if (held == Held::hinge) model.set_gravity({0.0, 0.0, -9.81});
        if (held != Held::free) return;
        for (int node = 0; node < model.nodes(); ++node) set_going({node});
    }

private:
    // A rigid motion, and sections of the beam that move across and turn with it.
    void set_going(NodeId node) {
        constexpr double size = Lattice::cell * (length - 1), bending = 0.05;  // m, m/s
        const Point3 turn(0.05, 0.1, -0.08), at = model.position(node);        // 1/s
        const double place = 2.0 * at[0] / size - 1.0;
        const Point3 section(0.0, -4.0 * bending * place / size, 0.0);  // turns besides
        for (const Field field : {Field::r, Field::r_x, Field::r_y, Field::r_z}) {
            const int first = model.layout().index({node, field});
            if (first < 0) continue;
            const Point3 value = model.value(node, field);
            Point3 rate = cross(turn, value) + cross(section, value);
            if (field == Field::r)
                rate = cross(turn, at) + cross(section, Point3(0.0, at[1], at[2])) +
                       Point3(0.3, -0.2, bending * place * place);
            model.state().v.segment<3>(first) = rate;
        }
    }
};

/// How a run is called and goes.
struct Run {
    const char* integrator;
    Held held;
    double bound;  // step, s, or tolerance
    double duration;
    Storage storage = Storage::lower;
};

/// Lets the lattice move; `integrate` takes the problem and the schedule.
template <class Integrate>
bool move(const Run& run, bool csv, const Integrate& integrate) {
    Swing scene(run.held);
    ProblemOptions problem_options;
    problem_options.storage = run.storage;
    DynamicProblem problem(scene.model, problem_options);
    const Momentum before = momentum(problem, scene.model.state());
    const double start = seconds();
    const DynamicsReport report =
        integrate(problem, equal_intervals(0.0, run.duration, run.duration));
    const double took = seconds() - start;
    const Momentum after = momentum(problem, scene.model.state());
    const bool free = run.held == Held::free;
    char slide[16] = "";
    if (free)
        std::snprintf(slide, sizeof slide, "%.2e",
                      std::max((after.linear - before.linear).norm() / before.linear.norm(),
                               (after.angular - before.angular).norm() / before.angular.norm()));
    std::printf(csv ? "%s,%s,%g,%d,%ld,%ld,%.2e,%s,%.4f,%.1f\n"
                    : "%-18s %-6s %8g %8d %6ld %8ld %10.2e %10s %9.4f %8.1f\n",
                run.integrator, free ? "free" : "hinge", run.bound, scene.members, report.steps,
                report.factorisations, report.energy_drift / report.kinetic_largest, slide,
                report.time, took);
    std::fflush(stdout);
    if (report.status == Status::converged) return true;
    std::printf("%s: %s\n", run.integrator, report.message.c_str());
    return false;
}

/// Lets the lattice move by an integrator that takes a linear solver.
template <class Integrator, class Options>
bool swing(const Run& run, const Options& options, bool csv) {
    return move(run, csv, [&](DynamicProblem& problem, const Schedule& schedule) {
        suitesparse::Cholmod solver;
        return Integrator(options).integrate(problem, solver, schedule);
    });
}

bool swing_all(Held held, double duration, bool csv) {
    bool good = true;
    for (const double step : {5e-3, 2.5e-3}) {
        GeneralizedAlphaOptions options;
        options.step = step;
        const Run run{"generalized-alpha", held, step, duration};
        good = swing<GeneralizedAlpha>(run, options, csv) && good;
    }
    for (const double step : {5e-3, 2.5e-3}) {
        EnergyMomentumOptions options;
        options.step = step;
        const Run run{"energy-momentum", held, step, duration};
        good = swing<EnergyMomentum>(run, options, csv) && good;
    }
    RadauOptions options;
    options.tolerance = 1e-4;
    good = swing<RadauIIA>({"radau", held, options.tolerance, duration}, options, csv) && good;
#if ANCF_WITH_SUNDIALS
    for (const double tolerance : {1e-4, 1e-6}) {
        sundials::IdaOptions ida;
        ida.tolerance = tolerance;
        good = move({"ida", held, tolerance, duration, Storage::full}, csv,
                    [&](DynamicProblem& problem, const Schedule& schedule) -> DynamicsReport {
                        return sundials::Ida(ida).integrate(problem, schedule);
                    }) &&
               good;
    }
#endif
    return good;
}

bool modes(bool csv) {
    Swing scene(Held::clamped);
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
        csv ? "modes,clamped,%.4f,%d,%d,,%.2e,,%.4f,%.1f\n"
            : "20 modes from %.4f Hz, %d members, %d iterations, residual %.2e, to %.4f Hz, "
              "%.1f s\n",
        report.modes.front().frequency(), scene.members, report.iterations,
        report.modes.back().residual, report.modes.back().frequency(), took);
    return true;
}

}  // namespace

bool run_motion(double duration, bool csv) {
    if (csv)
        std::printf(
            "integrator,held,bound,members,steps,factorisations,drift,momenta,reached,seconds\n");
    else
        std::printf("%-18s %-6s %8s %8s %6s %8s %10s %10s %9s %8s\n", "integrator", "held", "step",
                    "members", "steps", "factors", "drift", "momenta", "reached", "seconds");
    bool good = modes(csv);
    for (const Held held : {Held::hinge, Held::free}) good = swing_all(held, duration, csv) && good;
    return good;
}

}  // namespace ancf::bench
