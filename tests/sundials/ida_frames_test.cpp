// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// SUNDIALS on frames of stiff joints: IDA keeps long steps and the spin, explicit steps agree.

#include <ancf/constants.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/sundials/explicit.hpp>
#include <ancf/sundials/ida.hpp>

#include <support/catch.hpp>

#include <cmath>

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

TEST_CASE("ida: a stiff frame with joints keeps its spin", "[sundials][ida][spin]") {
    constexpr double spin = 10.0, end = 2.0;
    PlanarModel model;
    const auto built = frame<CrossSectionBeam<2>>(
        model, {{Material::isotropic(1e11, 0.3, 1000.0), rectangle(0.1, 0.1)}},
        {{-0.5, 0.0}, {0.5, 0.0}, {0.0, 0.4}}, {{0, 1}, {1, 2}, {2, 0}});
    model.set_rigid_rates({0.0, 0.0}, spin);
    DynamicProblem problem(model);
    ancf::sundials::IdaOptions options;
    options.tolerance = 1e-7;
    const auto report =
        ancf::sundials::Ida(options).integrate(problem, equal_intervals(0.0, end, end));
    REQUIRE(report.status == Status::converged);
    const Vector<double, 2> along =
        model.position(built.joints[1]) - model.position(built.joints[0]);
    const double late = std::remainder(std::atan2(along[1], along[0]) - spin * end, 2.0 * pi);
    CHECK(std::abs(late) <= 1e-3);  // 1.5e-4; 3e-2 by IDA's own test of convergence
    CHECK(report.energy_drift <= 1e-4 * report.kinetic_largest);  // 4e-6; 6e-3
}

}  // namespace ida_frames_test
