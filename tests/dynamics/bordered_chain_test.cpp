// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/solver/bordered_chain.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>

#include <dynamics/scenes.hpp>
#include <support/driven_arm.hpp>

#include <functional>
#include <memory>

namespace bordered_chain_motion_test {

using namespace ancf::test;
using ancf::BorderedChain;
using ancf::Scene;
using ancf::Status;

/// Runs a scene by both solvers and returns how far the ends are apart.
template <class Integrator>
double apart(const Integrator& integrator, const std::function<std::unique_ptr<Scene>()>& make,
             double end, bool by_chain) {
    const auto scene = make(), other = make();
    ancf::DynamicProblem problem(*scene), same(*other);
    BorderedChain solver;
    ancf::EigenLu general;
    const auto report = integrator.integrate(problem, solver, until(end));
    const auto expected = integrator.integrate(same, general, until(end));
    CAPTURE(report.message, expected.message);
    REQUIRE(report.status == Status::converged);
    REQUIRE(expected.status == Status::converged);
    CHECK(report.steps == expected.steps);
    CHECK(solver.is_chain());
    CHECK(solver.by_chain() == by_chain);
    return distance(scene->state().q, other->state().q);
}

/// A ring of bars in space: a chain whose ends a constraint joins, on a link.
std::unique_ptr<Scene> necklace() {
    Chain scene = chain(30, {0.0, 0.0, 0.0}, {3.0, 0.0, 0.0});
    for (int k = 0; k <= 30; ++k) {
        const double turn = 2.0 * ancf::pi * k / 30.0;
        scene.model.set_value(scene.nodes[static_cast<std::size_t>(k)], ancf::Field::r,
                              Vector3(0.47 * std::cos(turn), 0.47 * std::sin(turn), 0.0));
    }
    scene.model.add(ancf::Pin<3>(scene.first(), scene.last()));
    scene.model.add(ancf::Distance<3>(scene.nodes[0], Vector3(0.47, 0.0, 0.6), 0.6));
    scene.model.set_gravity({0.0, -9.81, 0.0});
    return std::make_unique<ancf::Model>(std::move(scene.model));
}

/// Bars from a support to a link at their last node.
std::unique_ptr<Scene> bridge() {
    Chain scene = chain(12, {0.0, 0.0, 0.0}, {1.2, 0.0, 0.0});
    scene.model.pin(scene.first());
    scene.model.add(ancf::Distance<3>(scene.last(), Vector3(1.2, 0.5, 0.0), 0.5));
    scene.model.set_gravity({0.0, -9.81, 0.0});
    return std::make_unique<ancf::Model>(std::move(scene.model));
}

std::unique_ptr<Scene> swinging() { return std::make_unique<ancf::Model>(swing().model); }

template <int Dimension>
std::unique_ptr<Scene> driven() {
    return std::make_unique<ancf::BasicModel<Dimension>>(
        std::move(Driven<Dimension>(smooth_turn(1.0)).model));
}

TEST_CASE("BorderedChain: motions are those of a general solver", "[dynamics]") {
    ancf::GeneralizedAlphaOptions fixed, adaptive;
    fixed.step = 1e-3;
    adaptive.tolerance = 1e-5;
    ancf::RadauOptions radau;
    radau.tolerance = 1e-6;
    ancf::EnergyMomentumOptions energy;
    energy.step = 1e-3;
    for (const auto& make : {necklace, bridge, swinging, driven<2>, driven<3>}) {
        CHECK(apart(ancf::GeneralizedAlpha(fixed), make, 0.05, true) <= 1e-12);
        CHECK(apart(ancf::GeneralizedAlpha(adaptive), make, 0.05, true) <= 1e-12);
        CHECK(apart(ancf::RadauIIA(radau), make, 0.05, true) <= 1e-12);
    }
    // its tangent is not symmetric
    CHECK(apart(ancf::EnergyMomentum(energy), swinging, 0.05, false) <= 1e-12);
}

TEST_CASE("BorderedChain: equilibria are those of a general solver", "[dynamics]") {
    // a beam that a joint alone holds: the chain has no stiffness against its turn
    Driven<2> one(smooth_turn(1.0)), other(smooth_turn(1.0));
    BorderedChain solver;
    ancf::EigenLu general;
    for (Driven<2>* arm : {&one, &other}) arm->model.state().time = 0.7;
    CHECK(ancf::solve_statics(one.model, solver).status == Status::converged);
    CHECK(solver.is_chain());
    CHECK_FALSE(solver.by_chain());
    CHECK(ancf::solve_statics(other.model, general).status == Status::converged);
    CHECK(distance(one.model.state().q, other.model.state().q) <= 1e-12);
}

}  // namespace bordered_chain_motion_test
