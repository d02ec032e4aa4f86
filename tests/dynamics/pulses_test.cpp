// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Loads and drives that act for a while after a rest, under integrators whose steps have grown in
/// it.

#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <support/pulses.hpp>

namespace pulses_test {

using namespace ancf;
using namespace ancf::test;

TEST_CASE("pulses: adaptive steps see what acts for longer than the first step after a rest",
          "[dynamics]") {
    const int method = GENERATE(0, 3, 5);  // generalized-alpha, stages of Radau
    const bool goes_on = GENERATE(false, true);
    CAPTURE(method, goes_on);
    check_pulses([&](Pulse& scene, double max_step) {
        DynamicProblem problem(scene.model);
        EigenLu solver;
        Schedule schedule;
        const auto integrate = [&](const Memory& memory) {
            if (method == 0) {
                GeneralizedAlphaOptions options;
                options.tolerance = 1e-7;
                options.max_step = max_step;
                return GeneralizedAlpha(options).integrate(problem, solver, schedule, memory);
            }
            RadauOptions options;
            options.stages = method;
            options.max_step = max_step;
            return RadauIIA(options).integrate(problem, solver, schedule, memory);
        };
        Memory memory;
        if (goes_on) {  // with the steps that have grown
            schedule.end = 0.4;
            memory = integrate(memory).memory;
        }
        schedule.end = pulse_end;
        const auto report = integrate(memory);
        REQUIRE(report.status == Status::converged);
        return report;
    });
}

}  // namespace pulses_test
