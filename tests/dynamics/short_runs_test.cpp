// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/momentum.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <dynamics/scenes.hpp>

#include <cmath>
#include <limits>
#include <vector>

namespace short_runs_test {

using namespace ancf::test;
using ancf::Status;

/// Runs the swing for a duration with a step of a second and checks what it does on the way:
/// q = q_0 + v_0 t and v = v_0 + a_0 t, to first order.
template <class Integrator>
void check_run(const Integrator& integrator, double duration) {
    CAPTURE(duration);
    Chain scene = swing();
    ancf::DynamicProblem problem(scene.model);
    const ancf::Start start = problem.start();
    ancf::EigenLu solver;
    ancf::Schedule schedule = until(duration);
    schedule.times = {0.0, 0.5 * duration, duration};
    std::vector<ancf::State> seen;
    schedule.observe = [&](const ancf::Snapshot& at) { seen.push_back(at.state); };
    const auto report = integrator.integrate(problem, solver, schedule);
    CAPTURE(report.message);
    REQUIRE(report.status == Status::converged);
    CHECK(report.steps >= 1);
    CHECK(report.time == duration);
    CHECK(scene.model.state().time == duration);
    REQUIRE(seen.size() == 3);
    int moved = 0;
    for (std::size_t k = 0; k < seen.size(); ++k) {
        const double t = schedule.times[k];
        CHECK(seen[k].time == t);
        ancf::VectorX q, v;
        problem.numbering().gather_free(seen[k].q, q);
        problem.numbering().gather_free(seen[k].v, v);
        // round-off, and what the next derivatives add; between steps v is the derivative of a
        // cubic through q, so that the round-off of q counts by its slope
        const double slope = k == 1 ? 3e-16 / duration : 0.0;  // 7e-17 measured
        CHECK(distance(q, start.q + t * start.v) <= 10.0 * t * t + 4e-16);
        CHECK(distance(v, start.v + t * start.acceleration) <= 100.0 * t * t + 2e-15 + slope);
        moved += k > 0 && v != start.v ? 1 : 0;
    }
    CHECK(moved == 2);
}

TEST_CASE("A run far shorter than its step moves to its end and shows the way", "[dynamics]") {
    ancf::GeneralizedAlphaOptions adaptive;
    adaptive.tolerance = 1e-6;
    adaptive.step = 1.0;
    adaptive.min_step = std::numeric_limits<double>::min();
    ancf::GeneralizedAlphaOptions fixed;
    fixed.step = 1.0;
    ancf::EnergyMomentumOptions conserving;
    conserving.step = 1.0;
    // above and below 1e-9 of the step
    for (const double duration : {1e-6, 1e-8, 2e-10, 1e-12}) {
        check_run(ancf::GeneralizedAlpha(fixed), duration);
        check_run(ancf::GeneralizedAlpha(adaptive), duration);
        check_run(ancf::EnergyMomentum(conserving), duration);
    }
}

TEST_CASE("A run without duration takes no step and shows its start", "[dynamics]") {
    const auto check = [](const auto& integrator) {
        Chain scene = swing();
        ancf::DynamicProblem problem(scene.model);
        ancf::EigenLu solver;
        ancf::Schedule schedule = until(0.0);
        schedule.times = {0.0, 0.0};
        int seen = 0;
        schedule.observe = [&](const ancf::Snapshot&) { ++seen; };
        const auto report = integrator.integrate(problem, solver, schedule);
        CHECK(report.status == Status::converged);
        CHECK(report.steps == 0);
        CHECK(seen == 2);
        // and can be continued
        const auto next = integrator.integrate(problem, solver, until(1e-3), report.memory);
        CHECK(next.status == Status::converged);
        CHECK(next.steps == 1);
    };
    check(ancf::GeneralizedAlpha());
    check(ancf::EnergyMomentum());
}

/// Checks multipliers at the end of a run whose last step is tiny, or the only one, and within it.
/// @param margin  relative to those of the state at the end
template <class Integrator>
void check_multipliers(const Integrator& integrator, double margin) {
    const auto run = [&](ancf::Scene& model, const ancf::Schedule& schedule) {
        ancf::DynamicProblem problem(model);
        ancf::EigenLu solver;
        REQUIRE(integrator.integrate(problem, solver, schedule).status == Status::converged);
    };
    std::vector<double> ends;  // of steps
    ancf::Schedule whole = until(0.5);
    whole.progress = [&](double time, double) {
        ends.push_back(time);
        return true;
    };
    Chain scene = swing();
    run(scene.model, whole);
    REQUIRE(ends.size() > 2);
    const double before = ends[ends.size() - 2];
    for (const double from : {before, 0.0})
        for (const double rest : {1e-3, 1e-5, 1e-7, 1e-9}) {
            CAPTURE(from, rest);
            Chain longer = swing();
            ancf::VectorX between;
            ancf::Schedule schedule = until(from + rest);
            schedule.times = {from + 0.5 * rest};
            schedule.observe = [&](const ancf::Snapshot& at) { between = at.state.multipliers; };
            run(longer.model, schedule);
            const ancf::VectorX own = ancf::DynamicProblem(longer.model).start().multipliers;
            CHECK(distance(longer.model.state().multipliers, own) <= margin * own.norm());
            CHECK(distance(between, own) <= margin * own.norm());
        }
}

TEST_CASE("Multipliers at the end of a tiny last step are those of the motion", "[dynamics]") {
    for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
        CAPTURE(tolerance);
        ancf::GeneralizedAlphaOptions options;
        options.tolerance = tolerance;
        check_multipliers(ancf::GeneralizedAlpha(options), 0.05);
        ancf::RadauOptions stages;
        stages.tolerance = tolerance;
        check_multipliers(ancf::RadauIIA(stages), 0.05);
        stages.stages = 5;
        check_multipliers(ancf::RadauIIA(stages), 0.05);
    }
    ancf::EnergyMomentumOptions options;
    options.step = 5e-3;
    check_multipliers(ancf::EnergyMomentum(options), 0.05);
}

TEST_CASE("RadauIIA: within a run shorter than half a step multipliers follow the motion",
          "[dynamics]") {
    // those of the end were seen at all times, off by up to 1.6 times their size
    ancf::RadauOptions options;
    options.stages = GENERATE(3, 5);
    Chain scene = swing();
    scene.model.add(ancf::Force<3>(scene.first(), {0.0, -10.0, 0.0}),
                    [](double t) { return std::sin(2e3 * t); });
    ancf::DynamicProblem problem(scene.model);
    ancf::EigenLu solver;
    ancf::Schedule schedule = until(4e-4);
    schedule.times = {1e-4, 2e-4, 3e-4};
    std::vector<ancf::State> seen;
    schedule.observe = [&](const ancf::Snapshot& at) { seen.push_back(at.state); };
    const auto report = ancf::RadauIIA(options).integrate(problem, solver, schedule);
    REQUIRE(report.status == Status::converged);
    REQUIRE(report.steps == 1);
    REQUIRE(seen.size() == 3);
    for (const ancf::State& state : seen) {
        CAPTURE(state.time);
        scene.model.state() = state;
        const ancf::VectorX own = problem.start().multipliers;
        CHECK(distance(state.multipliers, own) <= 0.1 * own.norm());  // 0.06
    }
}

TEST_CASE("Equal intervals longer than the run still have both ends", "[dynamics]") {
    for (const double interval : {1.0, 1e3, 1e10, 1e300}) {
        CAPTURE(interval);
        const ancf::Schedule schedule = ancf::equal_intervals(2.0, 1e-3, interval);
        CHECK(schedule.times == std::vector<double>{2.0, 2.0 + 1e-3});
    }
}

/// Moves the swing from end to end with the memory of the run before, in steps of 1e-3 s; returns
/// the last report.
template <class Integrator>
ancf::DynamicsReport check_ends(const Integrator& integrator, const std::vector<double>& ends) {
    Chain scene = swing();
    ancf::DynamicProblem problem(scene.model);
    ancf::EigenLu solver;
    ancf::DynamicsReport report;
    for (const double steps : ends) {
        CAPTURE(steps);
        const double end = 1e-3 * steps;
        ancf::Schedule schedule = until(end);
        schedule.times = {end};
        double seen = -1.0;
        schedule.observe = [&](const ancf::Snapshot& at) { seen = at.state.time; };
        report = integrator.integrate(problem, solver, schedule, report.memory);
        CAPTURE(report.message);
        REQUIRE(report.status == Status::converged);
        CHECK(report.time == end);
        CHECK(seen == end);
        CHECK(scene.model.state().time == end);
    }
    return report;
}

TEST_CASE("A run ends at its end, however close that is to a point of the grid", "[dynamics]") {
    ancf::GeneralizedAlphaOptions alpha;
    ancf::EnergyMomentumOptions middle;
    ancf::RadauOptions radau;
    alpha.step = middle.step = radau.step = 1e-3;
    radau.tolerance = 0.0;
    // ahead of points of the grid and behind them; the third from a time that an end beyond the
    // grid would have passed
    const std::vector<double> ends{1.0 - 5e-10, 2.0 - 5e-10, 2.0 - 3e-10, 3.0 + 5e-10, 4.0};
    check_ends(ancf::GeneralizedAlpha(alpha), ends);
    check_ends(ancf::EnergyMomentum(middle), ends);
    check_ends(ancf::RadauIIA(radau), ends);
    alpha.tolerance = radau.tolerance = 1e-6;
    check_ends(ancf::GeneralizedAlpha(alpha), ends);
    check_ends(ancf::RadauIIA(radau), ends);
}

/// Runs bars that fall and get a blow, from a time on, with adaptive steps.
template <class Options, class Integrator>
ancf::DynamicsReport run_late(Options options, double start, double tolerance) {
    Chain scene = falling();
    scene.model.state().time = start;
    scene.model.add(ancf::Force<3>(scene.last(), {0.0, 20.0, 0.0}),
                    [=](double time) { return time > start + 0.0103 ? 1.0 : 0.0; });
    options.tolerance = tolerance;
    ancf::DynamicProblem problem(scene.model);
    ancf::EigenLu solver;
    ancf::Schedule schedule = until(start + 0.05);
    int steps = 0;
    schedule.progress = [&](double, double) { return ++steps < 5000; };
    return Integrator(options).integrate(problem, solver, schedule);
}

template <class Options, class Integrator>
void check_late(const Options& options) {
    const auto run = run_late<Options, Integrator>;
    const auto early = run(options, 0.0, 1e-9), late = run(options, 1e6, 1e-9);
    CHECK(early.status == Status::converged);
    CHECK(late.status == Status::converged);
    CHECK(late.steps < 2 * early.steps);
    const auto endless = run(options, 1e6, 1e-300);
    CHECK(endless.status == Status::step_too_small);
    CHECK_THAT(endless.message, ContainsSubstring("the step fell below 3.55271e-09 s"));
}

TEST_CASE("Adaptive steps late in time grow after a blow, and end where time resolves none",
          "[dynamics]") {
    check_late<ancf::GeneralizedAlphaOptions, ancf::GeneralizedAlpha>({});
    check_late<ancf::RadauOptions, ancf::RadauIIA>({});
}

TEST_CASE("Fixed steps late in time stay on their grid", "[dynamics]") {
    constexpr double start = 1e9, step = 6e-6;  // s; the round-off of the time is 1.2e-7 s
    const auto check = [&](const auto& integrator) {
        Chain scene = swing();
        scene.model.state().time = start;
        ancf::DynamicProblem problem(scene.model);
        ancf::EigenLu solver;
        const auto report = integrator.integrate(problem, solver, until(start + 300.0 * step));
        CHECK(report.status == Status::converged);
        CHECK(report.steps == 300);
        CHECK(report.factorisations <= 3);
    };
    ancf::GeneralizedAlphaOptions alpha;
    ancf::EnergyMomentumOptions middle;
    ancf::RadauOptions radau;
    alpha.step = middle.step = radau.step = step;
    radau.tolerance = 0.0;
    check(ancf::GeneralizedAlpha(alpha));
    check(ancf::EnergyMomentum(middle));
    check(ancf::RadauIIA(radau));
}

TEST_CASE("A whole step follows a very short one at once", "[dynamics]") {
    int checked = 0;
    // of the short step the multipliers, g/h^2, are round-off
    const auto check = [&](const auto& integrator) {
        for (const double part : {3e-2, 3e-6, 3e-10}) {
            CAPTURE(part);
            const auto report = check_ends(integrator, {1.0, 1.0 + part, 2.0 + part});
            CHECK(report.steps == 1);
            CHECK(report.convergence_failures == 0);
            ++checked;
        }
    };
    for (const int stages : {3, 5}) {
        CAPTURE(stages);
        ancf::RadauOptions radau;
        radau.step = 1e-3;
        radau.tolerance = 0.0;
        radau.stages = stages;
        check(ancf::RadauIIA(radau));
    }
    ancf::GeneralizedAlphaOptions alpha;
    ancf::EnergyMomentumOptions middle;
    alpha.step = middle.step = 1e-3;
    check(ancf::GeneralizedAlpha(alpha));
    check(ancf::EnergyMomentum(middle));
    CHECK(checked == 12);
}

/// Moves the swing by a whole number of steps, by a tiny part of one and by a whole one again, each
/// with the memory of the run before; checks the multipliers of every end and what the last costs.
/// @param margin  relative to those of the state at the end
template <class Integrator>
void check_tiny_run(const Integrator& integrator, double margin) {
    for (const double part : {1e-3, 1e-6, 1e-9}) {
        CAPTURE(part);
        Chain scene = swing();
        ancf::DynamicProblem problem(scene.model);
        ancf::EigenLu solver;
        ancf::DynamicsReport report;
        for (const double end : {0.1, 0.1 + 1e-3 * part, 0.101 + 1e-3 * part}) {
            CAPTURE(end);
            report = integrator.integrate(problem, solver, until(end), report.memory);
            REQUIRE(report.status == Status::converged);
            const ancf::VectorX own = problem.start().multipliers;
            CHECK(distance(scene.model.state().multipliers, own) <= margin * own.norm());
        }
        CHECK(report.steps == 1);
        CHECK(report.rejected == 0);
        CHECK(report.convergence_failures == 0);
    }
}

TEST_CASE("A run of one tiny step that goes on ends with the multipliers of its state",
          "[dynamics]") {
    // they were off by 40 to 3e15 times their size, and 25 to 40 % after the next step, for which
    // RadauIIA by tolerance took 4 to 28
    ancf::GeneralizedAlphaOptions alpha;
    ancf::EnergyMomentumOptions middle;
    ancf::RadauOptions radau;
    alpha.step = middle.step = radau.step = 1e-3;
    for (const double tolerance : {0.0, 1e-5}) {
        CAPTURE(tolerance);
        alpha.tolerance = radau.tolerance = tolerance;
        check_tiny_run(ancf::GeneralizedAlpha(alpha), 0.02);
        for (const int stages : {3, 5}) {
            CAPTURE(stages);
            radau.stages = stages;
            check_tiny_run(ancf::RadauIIA(radau), 0.02);
        }
    }
    check_tiny_run(ancf::EnergyMomentum(middle), 0.02);
}

TEST_CASE("EnergyMomentum takes a whole step after a tiny one of a stiff scene", "[dynamics]") {
    // it took 128 parts, as the change of the rates in the tiny step is round-off
    Chain scene = swing();
    scene.model.prototype<Bar<3>>(0) = Bar<3>(5e6, 1.0, 0.4);
    ancf::DynamicProblem problem(scene.model);
    ancf::EigenLu solver;
    ancf::DynamicsReport report;
    for (const double end : {0.01, 0.01 + 1e-13, 0.011})
        report = ancf::EnergyMomentum().integrate(problem, solver, until(end), report.memory);
    CAPTURE(report.message);
    REQUIRE(report.status == Status::converged);
    CHECK(report.steps == 1);
    CHECK(report.convergence_failures == 0);
}

TEST_CASE("Adaptive steps see a pulse after a rest by max_step, or where a run begins with it",
          "[dynamics]") {
    // a push of 5 ms gives the end of free bars a rate; steps that grew at rest pass over it
    constexpr double begin = 0.5, length = 5e-3;
    const auto push = [&](const auto& integrator, bool split) {
        Chain scene = chain(3, {0.0, 0.0, 0.0}, {1.2, 0.0, 0.0});
        scene.model.add(ancf::Force<3>(scene.last(), {0.0, 4.0, 0.0}),
                        [&](double t) { return t >= begin && t < begin + length ? 1.0 : 0.0; });
        ancf::DynamicProblem problem(scene.model);
        ancf::EigenLu solver;
        if (split)
            REQUIRE(integrator.integrate(problem, solver, until(begin)).status ==
                    Status::converged);
        REQUIRE(integrator.integrate(problem, solver, until(1.0)).status == Status::converged);
        return momentum(problem, scene.model.state()).linear[1];
    };
    int checked = 0;  // the end of the push is met to the tolerance: 6 % measured
    for (const bool split : {false, true}) {
        CAPTURE(split);
        const double most = split ? 1.0 : 2e-3;
        ancf::GeneralizedAlphaOptions alpha;
        alpha.tolerance = 1e-6;
        alpha.max_step = most;
        CHECK(push(ancf::GeneralizedAlpha(alpha), split) == Approx(4.0 * length).epsilon(0.1));
        for (const int stages : {3, 5}) {
            ancf::RadauOptions radau;
            radau.stages = stages;
            radau.max_step = most;
            CHECK(push(ancf::RadauIIA(radau), split) == Approx(4.0 * length).epsilon(0.1));
            ++checked;
        }
    }
    CHECK(checked == 4);
}

TEST_CASE("Runs that end shortly beside the grid go on as one does", "[dynamics]") {
    // each ends by a step of a twentieth or a hundredth: as converged they ended 1.6 m off
    ancf::GeneralizedAlphaOptions options;
    options.step = 1e-3;
    const ancf::GeneralizedAlpha integrator(options);
    for (const double duration : {1.05e-3, 1.001e-2}) {
        CAPTURE(duration);
        Chain parts = swing(), whole = swing();
        ancf::DynamicProblem problem(parts.model), other(whole.model);
        ancf::EigenLu solver;
        ancf::Memory memory;
        for (double end = duration; end < 0.25; end += duration) {
            const auto report = integrator.integrate(problem, solver, until(end), memory);
            CAPTURE(end, report.message);
            REQUIRE(report.status == Status::converged);
            memory = report.memory;
        }
        const ancf::State& reached = parts.model.state();
        REQUIRE(integrator.integrate(other, solver, until(reached.time)).status ==
                Status::converged);
        const ancf::VectorX& force = whole.model.state().multipliers;
        CHECK(distance(reached.q, whole.model.state().q) <= 1e-5);
        CHECK(distance(reached.multipliers, force) <= 1e-3 * force.norm());
    }
}

TEST_CASE("Radau's shortest steps take corrections that no longer shrink for round-off",
          "[dynamics]") {
    // each run ends by a step of 1e-10 s; in one of 280 the corrections shrank by less than
    // a hundredth, which ended it as diverged
    ancf::RadauOptions options;
    options.tolerance = 0.0;
    options.step = 1e-3;
    const ancf::RadauIIA integrator(options);
    Chain scene = swing();
    ancf::DynamicProblem problem(scene.model);
    ancf::EigenLu solver;
    int runs = 0;
    for (; runs < 300; ++runs) {
        CAPTURE(runs);
        const double end = scene.model.state().time + 1.0000001e-3;
        REQUIRE(integrator.integrate(problem, solver, until(end)).status == Status::converged);
    }
    CHECK(runs == 300);
}

}  // namespace short_runs_test
