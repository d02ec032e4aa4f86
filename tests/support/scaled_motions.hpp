// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Motions of scenes in any units, by any integrator and solver.

#pragma once

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/solver/linear_solver.hpp>

#include <support/scales.hpp>

#include <cmath>
#include <cstdlib>

namespace ancf::test {

/// Integrates a copy of a scene to a time in its own units.
template <class Integrator>
DynamicsReport run(Scene model, LinearSolver&& solver, const Integrator& integrator, double end) {
    DynamicProblem problem(model);
    Schedule schedule;
    schedule.end = end;
    return integrator.integrate(problem, solver, schedule);
}

[[nodiscard]] inline GeneralizedAlpha generalized_alpha(const Scale& scale, double step,
                                                        double tolerance) {
    GeneralizedAlphaOptions options;
    options.step = step * scale.time;
    options.min_step *= scale.time;
    options.tolerance = tolerance;
    return GeneralizedAlpha(options);
}

[[nodiscard]] inline RadauIIA radau(const Scale& scale, int stages, double step, double tolerance) {
    RadauOptions options;
    options.stages = stages;
    options.step = step * scale.time;
    options.min_step *= scale.time;
    options.tolerance = tolerance;
    return RadauIIA(options);
}

[[nodiscard]] inline EnergyMomentum energy_momentum(const Scale& scale, double step) {
    EnergyMomentumOptions options;
    options.step = step * scale.time;
    return EnergyMomentum(options);
}

/// Checks that a scene moves in the same steps in any units.
/// @param apart   by how much the iterations may differ
/// @param run_at  the run in given units
template <class Run>
void check_scales(double base, long apart, const Run& run_at) {
    const DynamicsReport one = run_at(Scale{});
    REQUIRE(one.status == Status::converged);
    int checked = 0;
    for (const Scale& scale : powers_of(base)) {
        INFO(scale);
        const DynamicsReport other = run_at(scale);
        CAPTURE(other.message);
        CHECK(other.status == Status::converged);
        CHECK(other.steps == one.steps);
        CHECK(other.rejected == one.rejected);
        CHECK(other.convergence_failures == one.convergence_failures);
        CHECK(std::abs(other.iterations - one.iterations) <= apart);
        CHECK(other.kinetic_largest / (scale.force() * scale.length) ==
              Approx(one.kinetic_largest).epsilon(1e-6));
        ++checked;
    }
    CHECK(checked == 11);
}

/// All integrators on one scene, for 10 steps.
template <class Solver, class Make>
void check_integrators(const Make& make, double step, double base, bool exactly) {
    const double end = 10.0 * step;
    check_scales(base, exactly ? 0 : 1, [&](const Scale& s) {
        return run(make(s), Solver(), generalized_alpha(s, step, 0.0), end * s.time);
    });
    check_scales(base, exactly ? 0 : 1, [&](const Scale& s) {
        return run(make(s), Solver(), generalized_alpha(s, step, 1e-5), end * s.time);
    });
    for (const double tolerance : {1e-5, 0.0})
        for (const int stages : {3, 5})
            check_scales(base, exactly ? 0 : 1, [&](const Scale& s) {
                return run(make(s), Solver(), radau(s, stages, step, tolerance), end * s.time);
            });
    check_scales(base, exactly ? 0 : 1, [&](const Scale& s) {
        return run(make(s), Solver(), energy_momentum(s, step), end * s.time);
    });
}

}  // namespace ancf::test
