// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Loads and drives that jump within a run of IDA and ARKODE.

#include <ancf/dynamics/problem.hpp>
#include <ancf/sundials/explicit.hpp>
#include <ancf/sundials/ida.hpp>

#include <support/catch.hpp>
#include <support/jumps.hpp>

namespace sundials_jumps_test {

using namespace ancf;
using namespace ancf::test;

/// Runs by an integrator with a tolerance; the error is below so many of them.
template <class Integrator, class Options>
void check(Options options, double tolerance, double most, bool joint) {
    options.tolerance = tolerance;
    check_jumps(
        [&](PlanarModel& model, double end) {
            DynamicProblem problem(model);
            Schedule schedule;
            schedule.end = end;
            const auto report = Integrator(options).integrate(problem, schedule);
            REQUIRE(report.status == Status::converged);
        },
        most * tolerance, joint);
}

// Without an end of steps at jumps the errors were 340 and 5200 tolerances, of the second form 22.
TEST_CASE("jumps: IDA begins anew behind them", "[ida]") {
    sundials::IdaOptions options;
    check<sundials::Ida>(options, 1e-5, 100.0, true);
    check<sundials::Ida>(options, 1e-8, 3000.0, true);
    options.form = sundials::Form::gear_gupta_leimkuhler;
    check<sundials::Ida>(options, 1e-5, 20.0, true);
}

// Without an end of steps at jumps the error was 62 tolerances.
TEST_CASE("jumps: Explicit begins anew behind them", "[explicit]") {
    check<sundials::Explicit>(sundials::ExplicitOptions(), 1e-6, 0.1, false);
}

// Steps that passed over both corners of a steep ramp left 25 tolerances.
TEST_CASE("jumps: steps of Explicit end at corners", "[explicit]") {
    constexpr double tolerance = 1e-8, width = 1.0 / 4096.0;  // s
    const Amplitude ramp = tabular_amplitude({{0.125, 0.0}, {0.125 + width, 1.0}});
    PushedBeam scene(ramp), exact(ramp);
    run_exactly(exact.model);
    DynamicProblem problem(scene.model);
    sundials::ExplicitOptions options;
    options.tolerance = tolerance;
    Schedule schedule;
    schedule.end = JumpScene::end;
    REQUIRE(sundials::Explicit(options).integrate(problem, schedule).status == Status::converged);
    CHECK(apart(scene, exact) <= 0.01 * tolerance);
}

TEST_CASE("jumps: outputs may stand at one, and runs end there", "[ida][explicit]") {
    for (const double jump : {0.0371, 0.0625, 0.1}) {
        CAPTURE(jump);
        Schedule schedule;
        schedule.end = 0.1;
        schedule.times = {0.005, jump};
        int seen = 0;
        schedule.observe = [&](const Snapshot&) { ++seen; };
        PushedBeam first(acts_from(jump)), second(acts_from(jump));
        DynamicProblem one(first.model), two(second.model);
        // IDA refused the time, Explicit ended as diverged
        const auto ida = sundials::Ida().integrate(one, schedule);
        CHECK(ida.status == Status::converged);
        const auto steps = sundials::Explicit().integrate(two, schedule);
        CHECK(steps.status == Status::converged);
        CHECK(ida.time == 0.1);
        CHECK(steps.time == 0.1);
        CHECK(seen == 4);
        CHECK((first.model.position(first.beam.last()) - second.model.position(second.beam.last()))
                  .norm() <= 1e-3);
    }
}

TEST_CASE("jumps: IDA takes noise for none", "[ida]") {
    PushedBeam scene(noise());
    DynamicProblem problem(scene.model);
    Schedule schedule;
    schedule.end = 0.1;
    sundials::IdaOptions options;
    options.max_steps = 50'000;
    CHECK(sundials::Ida(options).integrate(problem, schedule).status == Status::converged);
}

}  // namespace sundials_jumps_test
