// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/eigen_lu.hpp>

#include <support/scaled_motions.hpp>

namespace dynamics_scales_test {

using namespace ancf::test;
using ancf::Status;
using Lu = ancf::EigenLu;

TEST_CASE("scales: integrators take the same steps and iterations in any units",
          "[dynamics][scales]") {
    for (const double base : {2.0, 1e9}) {
        CAPTURE(base);
        const bool exactly = base == 2.0;
        check_integrators<Lu>([](const Scale& s) { return cantilever(s); }, 1e-4, base, exactly);
        check_integrators<Lu>([](const Scale& s) { return linkage(s); }, 2e-4, base, exactly);
        check_integrators<Lu>([](const Scale& s) { return elbow(s); }, 2e-4, base, exactly);
    }
}

TEST_CASE("scales: a small cantilever moves in the steps of a large one", "[dynamics][scales]") {
    // of the same material: times and lengths in proportion, forces as their square
    const auto at = [](double size) { return Scale{size, size * size * size, size}; };
    const auto fixed = run(cantilever(at(1.0)), Lu(), generalized_alpha(at(1.0), 1e-4, 0.0), 0.02);
    REQUIRE(fixed.steps == 200);
    const auto adaptive =
        run(cantilever(at(1.0)), Lu(), generalized_alpha(at(1.0), 1e-4, 1e-4), 0.02);
    REQUIRE(adaptive.status == Status::converged);
    for (const double size : {1e-2, 1e-3, 1e-4, 1e-6, 1e-9}) {
        CAPTURE(size);
        const Scale scale = at(size);
        const auto small =
            run(cantilever(scale), Lu(), generalized_alpha(scale, 1e-4, 0.0), 0.02 * scale.time);
        CHECK(small.status == Status::converged);
        CHECK(small.steps == 200);
        CHECK(small.iterations == fixed.iterations);
        CHECK(small.convergence_failures == 0);
        const auto varied =
            run(cantilever(scale), Lu(), generalized_alpha(scale, 1e-4, 1e-4), 0.02 * scale.time);
        CHECK(varied.status == Status::converged);
        CHECK(varied.steps == adaptive.steps);
        CHECK(varied.convergence_failures == adaptive.convergence_failures);
    }
}

/// A slender steel cantilever at rest, without load, that stands at (x, 0).
[[nodiscard]] ancf::PlanarModel remote(double x) {
    ancf::PlanarModel model;
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<2>>(
        model, Scale().material(2.07e11, 0.3, 7850.0), ancf::rectangle(0.01, 0.01), {x, 0.0},
        {x + 1.0, 0.0}, 4);
    model.clamp(beam.first());
    return model;
}

/// Runs it for 100 steps, which are to be whole and to need one matrix.
template <class Integrator>
void check_remote(const Integrator& integrator, double x, double step, long factors,
                  long iterations) {
    CAPTURE(x, step);
    const auto report = run(remote(x), Lu(), integrator, 100.0 * step);
    CHECK(report.status == Status::converged);
    CHECK(report.steps == 100);
    CHECK(report.convergence_failures == 0);
    CHECK(report.iterations <= iterations);
    CHECK(report.factorisations == factors);
}

TEST_CASE("scales: a scene at rest stays there, however far from the origin, by one matrix",
          "[dynamics][scales]") {
    int checked = 0;
    for (const double x : {0.0, 1e3, 1e6})
        for (const double step : {1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2}) {
            // 200, 300, 281 and 294 iterations measured
            check_remote(generalized_alpha({}, step, 0.0), x, step, 1, 200);
            check_remote(energy_momentum({}, step), x, step, 1, 300);
            check_remote(radau({}, 3, step, 0.0), x, step, 2, 300);
            check_remote(radau({}, 5, step, 0.0), x, step, 3, 300);
            ++checked;
        }
    CHECK(checked == 18);
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
