// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Driven joints under IDA: the angle is reached with its turns, or the run ends with the reason.

#include <ancf/constants.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/sundials/ida.hpp>

#include <support/catch.hpp>
#include <support/driven_arm.hpp>
#include <support/twisted_beam.hpp>

namespace ida_driven_joints_test {

using namespace ancf;
using ancf::sundials::Form;
using ancf::sundials::Ida;
using ancf::sundials::IdaOptions;

TEMPLATE_TEST_CASE("Ida: an arm turns by the angle driven, from any first step", "[ida][joints]",
                   test::DrivenArm, test::DrivenCrank) {
    int checked = 0;
    for (const double angle : {0.1, 1.7, pi, 4.0, 10.0, 4.0 * pi, 20.0})
        for (const int steps : {1, 2, 4, 16})
            for (const Form form : {Form::index3, Form::gear_gupta_leimkuhler}) {
                CAPTURE(angle, steps, form == Form::index3);
                const Motion motion = test::smooth_turn(angle);
                TestType arm(motion);
                DynamicProblem problem(arm.model);
                IdaOptions options;
                options.tolerance = 1e-3;
                options.form = form;
                options.first_step = 1.0 / steps;
                Schedule schedule = equal_intervals(0.0, 1.0, 1.0 / 64);
                test::TurnCounter counter(arm, motion);
                schedule.observe = [&](const Snapshot& seen) { counter.see(seen.state); };
                const auto report = Ida(options).integrate(problem, schedule);
                ++checked;
                INFO(report.message);
                REQUIRE(report.status == Status::converged);
                CHECK(std::abs(counter.turned() - angle) <= 1e-9);
                CHECK(counter.farthest() <= pi / 12.0);
                CHECK(arm.off(angle) <= 1e-9);
                CHECK(arm.wound() <= 0.5);
            }
    CHECK(checked == 56);
}

TEST_CASE("Ida: a motion that twists an element by too much ends, or says which one",
          "[ida][joints]") {
    const bool energy = GENERATE(false, true), pass = GENERATE(false, true);
    Model model = test::twisted_beam(5.0);
    DynamicProblem problem(model);
    IdaOptions options;
    options.tolerance = 1e-4;
    options.max_step = 1e-2;
    options.follow_energy = energy;
    Schedule schedule = equal_intervals(0.0, 1.0, 1.0);
    schedule.pass_degenerate = pass;
    test::check_left_range(Ida(options).integrate(problem, schedule), !pass, 0.64);
}

TEST_CASE("Ida: a driven angle that jumps ends the motion and names the joint", "[ida][joints]") {
    const Motion jump{[](double t) { return t > 0.5 ? 4.0 : 0.0; }, [](double) { return 0.0; },
                      [](double) { return 0.0; }};
    test::DrivenArm arm(jump);
    DynamicProblem problem(arm.model);
    const auto report = Ida().integrate(problem, equal_intervals(0.0, 1.0, 1.0));
    CHECK(report.status == Status::step_too_small);
    CHECK_THAT(report.message, ContainsSubstring("planar weld of node 0 and space"));
    CHECK_THAT(report.message, ContainsSubstring("driven by 4 rad"));
    CHECK(report.time <= 0.5);
}

}  // namespace ida_driven_joints_test
