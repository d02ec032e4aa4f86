// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Loads and drives that act for a while after a rest, under IDA.

#include <ancf/sundials/ida.hpp>

#include <support/pulses.hpp>

namespace sundials_pulses_test {

using namespace ancf;
using namespace ancf::test;

TEST_CASE("pulses: IDA sees what acts for longer than its first step after a rest", "[ida]") {
    const auto form = GENERATE(sundials::Form::index3, sundials::Form::gear_gupta_leimkuhler);
    CAPTURE(static_cast<int>(form));
    constexpr double end = 0.6;  // sooner than pulse_end: the second form follows every vibration
    check_pulses([&](Pulse& scene, double max_step) {
        DynamicProblem problem(scene.model);
        sundials::IdaOptions options;
        options.form = form;
        options.tolerance = 1e-8;
        options.first_step = 1e-4;
        if (max_step < end) options.max_step = max_step;
        Schedule schedule;
        schedule.end = end;
        const auto report = sundials::Ida(options).integrate(problem, schedule);
        REQUIRE(report.status == Status::converged);
        return report;
    });
}

}  // namespace sundials_pulses_test
