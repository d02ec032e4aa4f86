// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// SUNDIALS on frames: stiff joints do not hold IDA's step down, and explicit steps agree with it.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/sundials/explicit.hpp>
#include <ancf/sundials/ida.hpp>

#include <support/catch.hpp>

namespace ida_frames_test {

using namespace ancf;

/// A rubber corner that falls about its first joint.
struct Falling {
    Model model;
    Frame<CrossSectionBeam<3>> built;

    Falling() {
        built = frame<CrossSectionBeam<3>>(
            model, {{Material::from_moduli(0.7e6, 2.6923e5, 1100.0), rectangle(0.05, 0.05)}},
            {{0, 0, 0}, {0.6, 0, 0}, {0.6, 0.6, 0}, {0.6, 0, 0.4}}, {{0, 1}, {1, 2}, {1, 3}});
        model.pin(built.joints[0]);
        model.set_gravity({0.0, -9.81, 0.0});
    }

    [[nodiscard]] Vector<double, 3> tip() const { return model.position(built.joints[2]); }
};

ancf::sundials::IdaReport fall(ancf::sundials::Order order) {
    Falling scene;
    DynamicProblem problem(scene.model);
    ancf::sundials::IdaOptions options;
    options.tolerance = 1e-6;
    options.order = order;
    return ancf::sundials::Ida(options).integrate(problem, equal_intervals(0.0, 0.2, 0.2));
}

TEST_CASE("ida: takes order two for a frame of stiff joints, in fewer steps", "[sundials][ida]") {
    const ancf::sundials::IdaReport chosen = fall(ancf::sundials::Order::automatic);
    const ancf::sundials::IdaReport other = fall(ancf::sundials::Order::five);
    REQUIRE(chosen.status == Status::converged);
    REQUIRE(other.status == Status::converged);
    CHECK(chosen.order == 2);
    CHECK(2 * chosen.steps < other.steps);
}

TEST_CASE("explicit: a frame of attached members moves as by IDA", "[sundials][explicit]") {
    Falling by_ida, explicitly;
    DynamicProblem implicit_problem(by_ida.model), problem(explicitly.model);
    ancf::sundials::IdaOptions fine;
    fine.tolerance = 1e-8;
    const Schedule schedule = equal_intervals(0.0, 0.1, 0.1);
    REQUIRE(ancf::sundials::Ida(fine).integrate(implicit_problem, schedule).status ==
            Status::converged);
    const auto report = ancf::sundials::Explicit().integrate(problem, schedule);
    INFO(report.message);
    REQUIRE(report.status == Status::converged);
    const Vector<double, 3> start(0.6, 0.6, 0.0);
    CHECK((explicitly.tip() - start).norm() > 0.01);
    CHECK((explicitly.tip() - by_ida.tip()).norm() <= 1e-6);  // 1.2e-7
    CHECK(explicitly.tip() == explicitly.model.position(explicitly.built.members[1].last()));
}

}  // namespace ida_frames_test
