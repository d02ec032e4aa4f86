// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Loads and drives that jump within an adaptive run.

#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <support/catch.hpp>
#include <support/jumps.hpp>

namespace jumps_test {

using namespace ancf;
using namespace ancf::test;

// Without an end of steps at jumps the errors were 20, 1300, 31, 180 and 3200 tolerances.
TEST_CASE("jumps: adaptive runs begin anew behind them", "[dynamics]") {
    struct Case {
        int method;  // generalized-alpha, stages of Radau
        double tolerance, most;
    };
    const Case c = GENERATE(Case{0, 1e-4, 10.0}, Case{0, 1e-7, 150.0}, Case{3, 1e-5, 1.0},
                            Case{3, 1e-8, 5.0}, Case{5, 1e-8, 5.0});
    CAPTURE(c.method, c.tolerance);
    check_jumps(
        [&](PlanarModel& model, double end) {
            DynamicProblem problem(model);
            EigenLu solver;
            Schedule schedule;
            schedule.end = end;
            const auto integrate = [&] {
                if (c.method == 0) {
                    GeneralizedAlphaOptions options;
                    options.tolerance = c.tolerance;
                    return GeneralizedAlpha(options).integrate(problem, solver, schedule);
                }
                RadauOptions options;
                options.stages = c.method;
                options.tolerance = c.tolerance;
                return RadauIIA(options).integrate(problem, solver, schedule);
            };
            const DynamicsReport report = integrate();
            REQUIRE(report.status == Status::converged);
        },
        c.most * c.tolerance);
}

TEST_CASE("jumps: noise is taken for none", "[dynamics]") {
    NoisyScene scene;
    DynamicProblem problem(scene.model);
    EigenLu solver;
    Schedule schedule;
    schedule.end = 0.1;
    RadauOptions options;
    options.tolerance = 1e-4;
    const DynamicsReport report = RadauIIA(options).integrate(problem, solver, schedule);
    CHECK(report.status == Status::converged);
    // a step for each change that time resolves would make 1e12
    CHECK(report.steps < 2000);
}

}  // namespace jumps_test
