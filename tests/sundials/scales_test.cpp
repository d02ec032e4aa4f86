// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/sundials/explicit.hpp>
#include <ancf/sundials/ida.hpp>

#include <support/scales.hpp>

#include <cmath>
#include <cstdlib>
#include <vector>

namespace ida_scales_test {

using namespace ancf::test;
using ancf::Status;

template <class Make>
ancf::sundials::IdaReport run(const Make& make, const Scale& scale, double end) {
    auto model = make(scale);
    ancf::DynamicProblem problem(model);
    ancf::sundials::IdaOptions options;
    options.tolerance = 1e-6;
    ancf::Schedule schedule;
    schedule.end = end * scale.time;
    return ancf::sundials::Ida(options).integrate(problem, schedule);
}

template <class Make>
void check(const Make& make, double end) {
    const auto one = run(make, Scale{}, end);
    REQUIRE(one.status == Status::converged);
    int checked = 0;
    for (const double base : {2.0, 1e3, 1e9})
        for (const Scale& scale : powers_of(base)) {
            INFO(scale);
            const auto other = run(make, scale, end);
            CAPTURE(other.message);
            CHECK(other.status == Status::converged);
            CHECK(other.order == one.order);
            CHECK(other.steps == one.steps);
            CHECK(std::abs(other.iterations - one.iterations) <= (base == 2.0 ? 0 : 1));
            CHECK(other.convergence_failures == one.convergence_failures);
            ++checked;
        }
    CHECK(checked == 33);
}

TEST_CASE("scales: IDA takes the same steps and iterations in any units", "[ida][scales]") {
    check([](const Scale& s) { return cantilever(s); }, 1e-4);
    check([](const Scale& s) { return linkage(s); }, 2e-3);
    check([](const Scale& s) { return elbow(s); }, 2e-3);
    // at rest, without a force that would set the scale of its multipliers
    check([](const Scale& s) { return elbow(s, 0.0); }, 2e-3);
}

/// What a run did, and where the last node came to in the scene's own units.
struct Outcome {
    ancf::sundials::IdaReport report;
    double tip = 0.0;
};

template <class Make>
Outcome reach(const Make& make, const Scale& scale, double end, ancf::sundials::Form form) {
    auto model = make(scale);
    ancf::DynamicProblem problem(model);
    ancf::sundials::IdaOptions options;
    options.tolerance = 1e-6;
    options.form = form;
    ancf::Schedule schedule;
    schedule.end = end * scale.time;
    Outcome outcome{ancf::sundials::Ida(options).integrate(problem, schedule)};
    outcome.tip = model.position({model.nodes() - 1})[1] / scale.length;
    return outcome;
}

/// Checks that a scene moves in the same steps in any units: to the bit where they are powers of 2.
template <class Make>
void check_alike(const Make& make, double end, ancf::sundials::Form form, double base) {
    const Outcome one = reach(make, Scale{}, end, form);
    REQUIRE(one.report.status == Status::converged);
    int checked = 0;
    for (const Scale& scale : powers_of(base)) {
        INFO(scale);
        const Outcome other = reach(make, scale, end, form);
        CAPTURE(other.report.message);
        CHECK(other.report.status == Status::converged);
        CHECK(other.report.order == one.report.order);
        CHECK(other.report.steps == one.report.steps);
        CHECK(other.report.rejected == one.report.rejected);
        CHECK(other.report.convergence_failures == one.report.convergence_failures);
        if (base == 2.0) {
            CHECK(other.report.iterations == one.report.iterations);
            CHECK(other.report.largest_step == one.report.largest_step * scale.time);
            CHECK(other.tip == one.tip);
        } else {
            // none measured in runs of some hundred steps, 14 in those of thousands
            CHECK(std::abs(other.report.iterations - one.report.iterations) <=
                  (one.report.steps < 1000 ? 1 : 15));
            CHECK(std::abs(other.tip - one.tip) <= 1e-7);  // measured 2e-8 in 3857 steps
        }
        ++checked;
    }
    CHECK(checked == 11);
}

TEST_CASE("scales: IDA moves scenes alike in any units, by both forms", "[ida][scales]") {
    using ancf::sundials::Form;
    const auto free_tip = [](const Scale& s) { return cantilever(s); };
    const auto linked = [](const Scale& s) { return linkage(s); };
    const auto welded = [](const Scale& s) { return elbow(s); };
    const Form ggl = Form::gear_gupta_leimkuhler;
    for (const double base : {2.0, 1e3, 1e9}) {
        CAPTURE(base);
        check_alike(free_tip, 2e-5, ggl, base);  // 56 steps
        check_alike(linked, 4e-4, ggl, base);    // 249
        check_alike(welded, 4e-4, ggl, base);    // 212
    }
    SECTION("a thousand steps of the second form") {
        for (const double base : {2.0, 1e9}) check_alike(welded, 2e-3, ggl, base);
    }
    SECTION("thousands of steps of index 3") {
        for (const double base : {2.0, 1e9}) check_alike(welded, 8e-3, Form::index3, base);
    }
}

TEST_CASE("scales: explicit steps are the same bits in units that differ by powers of two",
          "[explicit][scales]") {
    const auto reach_tip = [](const Scale& scale, double& tip) {
        auto model = cantilever(scale);
        ancf::DynamicProblem problem(model);
        ancf::Schedule schedule;
        schedule.end = 3e-4 * scale.time;  // the frequency is estimated again
        const auto report = ancf::sundials::Explicit().integrate(problem, schedule);
        CHECK(report.status == Status::converged);
        tip = model.position({model.nodes() - 1})[1] / scale.length;
        return report;
    };
    double tip = 0.0, other_tip = 0.0;
    const auto one = reach_tip(Scale{}, tip);
    int checked = 0;
    for (const Scale& scale : powers_of(2.0)) {
        INFO(scale);
        const auto other = reach_tip(scale, other_tip);
        CHECK(other.highest_frequency * scale.time == one.highest_frequency);
        CHECK(other.steps == one.steps);
        CHECK(other_tip == tip);
        ++checked;
    }
    CHECK(checked == 11);
}

TEST_CASE("Ida: runs of any length reach their end and show the way", "[ida]") {
    const auto seen_in = [](double start, double duration) {
        ancf::PlanarModel model = cantilever(Scale{});
        model.state().time = start;
        ancf::DynamicProblem problem(model);
        ancf::Schedule schedule;
        schedule.end = start + duration;
        schedule.times = {start, schedule.end};
        ancf::VectorX first, last;
        schedule.observe = [&](const ancf::Snapshot& at) {
            (first.size() == 0 ? first : last) = at.state.v;
        };
        const auto report = ancf::sundials::Ida().integrate(problem, schedule);
        CHECK(report.status == Status::converged);
        CHECK(report.time == schedule.end);
        CHECK(report.steps >= 1);
        REQUIRE(last.size() == first.size());
        return (last - first).norm();
    };
    for (const double duration : {1e-6, 1e-10, 1e-14, 1e-20}) {
        CAPTURE(duration);
        CHECK(seen_in(0.0, duration) > 0.0);
        if (1.0 + duration > 1.0) CHECK(seen_in(1.0, duration) > 0.0);
    }
}

TEST_CASE("Ida: what steps leave of a run in round-off is no step", "[ida]") {
    for (const double left : {1e-8, 1e-10, 1e-12}) {
        CAPTURE(left);
        ancf::PlanarModel model = cantilever(Scale{});
        ancf::DynamicProblem problem(model);
        ancf::sundials::IdaOptions options;
        constexpr double step = 1e-8;
        options.first_step = options.max_step = step;
        ancf::Schedule schedule;
        schedule.end = (100.0 + left) * step;
        schedule.times = {(100.0 + 0.5 * left) * step, schedule.end};
        std::vector<double> seen;
        schedule.observe = [&](const ancf::Snapshot& at) { seen.push_back(at.state.time); };
        const auto report = ancf::sundials::Ida(options).integrate(problem, schedule);
        CHECK(report.status == Status::converged);
        CHECK(report.time == schedule.end);
        CHECK(report.steps == (left > 1e-9 ? 101 : 100));
        CHECK(seen == schedule.times);
    }
}

}  // namespace ida_scales_test
