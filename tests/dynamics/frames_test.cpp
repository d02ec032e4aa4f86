// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// The integrators of this folder on a frame of attached members: momenta, energy, agreement with
// each other, a joint that is driven, and a constraint on a joint.

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/momentum.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <dynamics/scenes.hpp>
#include <support/catch.hpp>

#include <algorithm>
#include <cmath>

namespace dynamic_frames_test {

using namespace ancf;
using namespace ancf::test;
using Element = CrossSectionBeam<3>;

/// A rubber L with a branch, free in space or held by what a test adds.
struct Rubber {
    Model model;
    Frame<Element> frame;

    Rubber() {
        const auto rubber = Material::from_moduli(0.7e6, 2.6923e5, 1100.0);
        frame = ancf::frame<Element>(model, {{rubber, rectangle(0.05, 0.05)}},
                                     {{0, 0, 0}, {0.6, 0, 0}, {0.6, 0.6, 0}, {0.6, 0, 0.4}},
                                     {{0, 1, 0, 2}, {1, 2, 0, 2}, {1, 3, 0, 1}});
    }
};

TEST_CASE("dynamic frames: a free one keeps momenta and energy by energy-momentum", "[dynamics]") {
    Rubber scene;
    scene.model.set_rigid_rates(Vector3(0.3, -0.2, 0.1), Vector3(1.0, 2.0, -1.5));
    scene.model.set_rate(scene.frame.joints[2], Field::r, {0.5, 1.0, -0.4});  // and it is shaken
    DynamicProblem problem(scene.model);
    const auto energy = [](const Energies& e) { return e.kinetic + e.strain; };
    EnergyMomentumOptions options;
    options.step = 0.01;
    Schedule schedule = equal_intervals(0.0, 0.5, 0.05);
    const Momentum before = momentum(problem, scene.model.state());
    double first = 0.0, drift = 0.0, slide = 0.0;
    int seen = 0;
    schedule.observe = [&](const Snapshot& at) {
        if (seen++ == 0) first = energy(at.energies);
        drift = std::max(drift, std::abs(energy(at.energies) - first));
        const Momentum now = momentum(problem, at.state);
        slide = std::max({slide, (now.linear - before.linear).norm() / before.linear.norm(),
                          (now.angular - before.angular).norm() / before.angular.norm()});
    };
    EigenLu solver;
    const auto report = EnergyMomentum(options).integrate(problem, solver, schedule);
    INFO(report.message);
    REQUIRE(report.status == Status::converged);
    CHECK(seen >= 10);
    CHECK(first > 0.1);
    CHECK(drift <= 1e-13 * first);  // 4e-15 and 4e-16, round-off
    CHECK(slide <= 1e-13);
}

TEST_CASE("dynamic frames: integrators agree, attached ends follow", "[dynamics]") {
    enum class Method { alpha, energy, radau };
    const auto tip = [](Method method, double step) {
        Rubber scene;
        scene.model.set_gravity({0, 0, -9.81});
        scene.model.clamp(scene.frame.joints[0]);
        DynamicProblem problem(scene.model);
        EigenLu solver;
        if (method == Method::radau) {
            RadauOptions options;
            options.tolerance = step;
            REQUIRE(RadauIIA(options).integrate(problem, solver, until(0.2)).status ==
                    Status::converged);
        } else if (method == Method::alpha) {
            GeneralizedAlphaOptions options;
            options.step = step;
            REQUIRE(GeneralizedAlpha(options).integrate(problem, solver, until(0.2)).status ==
                    Status::converged);
        } else {
            EnergyMomentumOptions options;
            options.step = step;
            REQUIRE(EnergyMomentum(options).integrate(problem, solver, until(0.2)).status ==
                    Status::converged);
        }
        const NodeId joint = scene.frame.joints[2];
        CHECK((scene.model.position(joint) - scene.model.position(scene.frame.members[1].last()))
                  .norm() == 0.0);
        CHECK(scene.model.velocity(joint) == scene.model.velocity(scene.frame.members[1].last()));
        return scene.model.position(joint);
    };
    const Vector3 fine = tip(Method::alpha, 5e-4);
    CHECK((tip(Method::alpha, 2e-3) - fine).norm() <= 2e-3);
    CHECK((tip(Method::energy, 1e-3) - fine).norm() <= 2e-3);
    CHECK((tip(Method::radau, 1e-5) - fine).norm() <= 1e-5);  // 3.6e-6, the error of the steps
    CHECK(fine[2] < -0.05);
}

TEST_CASE("dynamic frames: a driven joint and a constraint on an attached node", "[dynamics]") {
    Rubber scene;
    Model& model = scene.model;
    const NodeId foot = scene.frame.joints[0];
    model.clamp(foot);
    model.prescribe(
        foot, Field::r, 2, [](double t) { return 0.05 * (1.0 - std::cos(10.0 * t)); },
        [](double t) { return 0.5 * std::sin(10.0 * t); },
        [](double t) { return 5.0 * std::cos(10.0 * t); });
    model.add(Distance<3>(scene.frame.members[1].last(), Vector3(0.6, 1.2, 0.0), 0.6));
    DynamicProblem problem(model);
    EigenLu solver;
    GeneralizedAlphaOptions options;
    options.step = 2e-3;
    const auto report = GeneralizedAlpha(options).integrate(problem, solver, until(0.3));
    INFO(report.message);
    REQUIRE(report.status == Status::converged);
    CHECK(model.position(scene.frame.members[0].first())[2] ==
          Approx(0.05 * (1.0 - std::cos(3.0))).epsilon(1e-12));
    const Vector3 rod = model.position(scene.frame.joints[2]) - Vector3(0.6, 1.2, 0.0);
    CHECK(rod.norm() == Approx(0.6).epsilon(1e-9));
    VectorX forces;
    REQUIRE(problem.reactions(model.state(), forces) == Status::converged);
    CHECK(std::abs(forces[model.coordinate(foot, Field::r) + 2]) > 0.1);
    CHECK(forces[model.coordinate(scene.frame.members[0].first(), Field::r) + 2] == 0.0);
}

}  // namespace dynamic_frames_test
