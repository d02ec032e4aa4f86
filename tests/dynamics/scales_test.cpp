// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <support/scales.hpp>

#include <cmath>
#include <cstdlib>

namespace dynamics_scales_test {

using namespace ancf::test;
using ancf::Status;

/// Integrates a copy of a scene to a time in its own units.
template <class Integrator>
ancf::DynamicsReport run(ancf::Scene model, const Integrator& integrator, double end) {
    ancf::DynamicProblem problem(model);
    ancf::EigenLu solver;
    ancf::Schedule schedule;
    schedule.end = end;
    return integrator.integrate(problem, solver, schedule);
}

ancf::GeneralizedAlpha generalized_alpha(const Scale& scale, double step, double tolerance) {
    ancf::GeneralizedAlphaOptions options;
    options.step = step * scale.time;
    options.min_step *= scale.time;
    options.tolerance = tolerance;
    return ancf::GeneralizedAlpha(options);
}

ancf::RadauIIA radau(const Scale& scale, int stages, double step, double tolerance) {
    ancf::RadauOptions options;
    options.stages = stages;
    options.step = step * scale.time;
    options.min_step *= scale.time;
    options.tolerance = tolerance;
    return ancf::RadauIIA(options);
}

ancf::EnergyMomentum energy_momentum(const Scale& scale, double step) {
    ancf::EnergyMomentumOptions options;
    options.step = step * scale.time;
    return ancf::EnergyMomentum(options);
}

/// Checks that a scene moves in the same steps in any units.
/// @param apart   by how much the iterations may differ
/// @param run_at  the run in given units
template <class Run>
void check_scales(double base, long apart, const Run& run_at) {
    const ancf::DynamicsReport one = run_at(Scale{});
    REQUIRE(one.status == Status::converged);
    int checked = 0;
    for (const Scale& scale : powers_of(base)) {
        INFO(scale);
        const ancf::DynamicsReport other = run_at(scale);
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
template <class Make>
void check_integrators(const Make& make, double step, double base, bool exactly) {
    const double end = 10.0 * step;
    check_scales(base, exactly ? 0 : 1, [&](const Scale& s) {
        return run(make(s), generalized_alpha(s, step, 0.0), end * s.time);
    });
    check_scales(base, exactly ? 0 : 1, [&](const Scale& s) {
        return run(make(s), generalized_alpha(s, step, 1e-5), end * s.time);
    });
    for (const int stages : {3, 5})
        check_scales(base, exactly ? 0 : 1, [&](const Scale& s) {
            return run(make(s), radau(s, stages, step, 1e-5), end * s.time);
        });
    // steps of fixed length iterate down to the noise of round-off: one more or less in a step
    for (const int stages : {3, 5})
        check_scales(base, exactly ? 0 : 10, [&](const Scale& s) {
            return run(make(s), radau(s, stages, step, 0.0), end * s.time);
        });
    // so does energy-momentum
    check_scales(base, exactly ? 0 : 10, [&](const Scale& s) {
        return run(make(s), energy_momentum(s, step), end * s.time);
    });
}

TEST_CASE("scales: integrators take the same steps and iterations in any units",
          "[dynamics][scales]") {
    for (const double base : {2.0, 1e9}) {
        CAPTURE(base);
        const bool exactly = base == 2.0;
        check_integrators([](const Scale& s) { return cantilever(s); }, 1e-4, base, exactly);
        check_integrators([](const Scale& s) { return linkage(s); }, 2e-4, base, exactly);
        check_integrators([](const Scale& s) { return elbow(s); }, 2e-4, base, exactly);
    }
}

TEST_CASE("scales: a small cantilever moves in the steps of a large one", "[dynamics][scales]") {
    // of the same material: times and lengths in proportion, forces as their square
    const auto at = [](double size) { return Scale{size, size * size * size, size}; };
    const auto fixed = run(cantilever(at(1.0)), generalized_alpha(at(1.0), 1e-4, 0.0), 0.02);
    REQUIRE(fixed.steps == 200);
    const auto adaptive = run(cantilever(at(1.0)), generalized_alpha(at(1.0), 1e-4, 1e-4), 0.02);
    REQUIRE(adaptive.status == Status::converged);
    for (const double size : {1e-2, 1e-3, 1e-4, 1e-6, 1e-9}) {
        CAPTURE(size);
        const Scale scale = at(size);
        const auto small =
            run(cantilever(scale), generalized_alpha(scale, 1e-4, 0.0), 0.02 * scale.time);
        CHECK(small.status == Status::converged);
        CHECK(small.steps == 200);
        CHECK(small.iterations == fixed.iterations);
        CHECK(small.convergence_failures == 0);
        const auto varied =
            run(cantilever(scale), generalized_alpha(scale, 1e-4, 1e-4), 0.02 * scale.time);
        CHECK(varied.status == Status::converged);
        CHECK(varied.steps == adaptive.steps);
        CHECK(varied.convergence_failures == adaptive.convergence_failures);
    }
}

TEST_CASE("scales: what holds a start to be at rest does not depend on units",
          "[dynamics][scales]") {
    for (const double time : {1e-9, 1.0, 1e9}) {
        Scale scale;
        scale.time = time;
        ancf::PlanarModel model = cantilever(scale);
        model.set_rate({4}, ancf::Field::r, {0.0, 1.0 / time});
        model.set_rate({0}, ancf::Field::r, {0.0, 1e-7 / time});  // of a clamped node
        ancf::DynamicProblem problem(model);
        CHECK(problem.start().status == Status::inconsistent);
        model.set_rate({0}, ancf::Field::r, {0.0, 1e-9 / time});
        CHECK(problem.start().status == Status::converged);
    }
}

}  // namespace dynamics_scales_test
