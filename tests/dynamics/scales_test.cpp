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
