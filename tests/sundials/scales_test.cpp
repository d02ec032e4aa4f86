// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/sundials/ida.hpp>

#include <support/scales.hpp>

#include <cmath>
#include <cstdlib>

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
            CHECK(std::abs(other.iterations - one.iterations) <= 1);
            CHECK(other.convergence_failures == one.convergence_failures);
            ++checked;
        }
    CHECK(checked == 27);
}

TEST_CASE("scales: IDA takes the same steps and iterations in any units", "[ida][scales]") {
    check([](const Scale& s) { return cantilever(s); }, 1e-4);
    check([](const Scale& s) { return linkage(s); }, 2e-3);
    check([](const Scale& s) { return elbow(s); }, 2e-3);
    // at rest, without a force that would set the scale of its multipliers
    check([](const Scale& s) { return elbow(s, 0.0); }, 2e-3);
}

TEST_CASE("Ida: runs of any length reach their end and show the way", "[ida]") {
    const auto seen_in = [](double start, double duration) {
        PlanarScene model = cantilever(Scale{});
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

}  // namespace ida_scales_test
