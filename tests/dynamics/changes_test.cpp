// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Density, stiffness and rest length that change between runs and within them, against scenes
/// that are built with the new values.

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/momentum.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>

#include <dynamics/scenes.hpp>
#include <support/bar.hpp>
#include <support/catch.hpp>

#include <algorithm>
#include <cmath>

namespace changes_test {

using namespace ancf::test;
using ancf::DynamicsReport;
using ancf::Field;
using ancf::NodeId;
using ancf::Schedule;
using ancf::Start;
using ancf::State;
using ancf::Status;
using ancf::VectorX;

constexpr double bar_length = 0.5, stiffness = 500.0;  // a length without round-off

/// A chain of three bars that swings from a pin.
Chain pendulum(double density, double stiff = stiffness) {
    Chain scene = chain(3, {0.0, 0.0, 0.0}, {3.0 * bar_length, 0.0, 0.0}, stiff, density);
    scene.model.pin(scene.first());
    scene.model.set_gravity({0.0, -9.81, 0.0});
    return scene;
}

DynamicsReport run(ancf::DynamicProblem& problem, bool conserving, const Schedule& schedule,
                   const ancf::Memory& memory = {}) {
    ancf::EigenLu solver;
    if (conserving)
        return ancf::EnergyMomentum().integrate(problem, solver, schedule, memory);  // 1 ms
    return ancf::GeneralizedAlpha().integrate(problem, solver, schedule, memory);
}

TEST_CASE("changes: a density changed between two runs moves the mass of the second",
          "[dynamics]") {
    const bool conserving = GENERATE(false, true);
    Chain changed = pendulum(1.0);
    const State start = changed.model.state();
    ancf::DynamicProblem problem(changed.model);
    REQUIRE(run(problem, conserving, until(0.05)).status == Status::converged);
    changed.model.state() = start;
    changed.model.prototype<Bar<3>>(0) = Bar<3>(stiffness, 3.0, bar_length);
    REQUIRE(run(problem, conserving, until(0.2)).status == Status::converged);

    Chain fresh = pendulum(3.0);
    ancf::DynamicProblem other(fresh.model);
    REQUIRE(run(other, conserving, until(0.2)).status == Status::converged);
    CHECK(problem.mass().sum() == other.mass().sum());
    CHECK(changed.model.state().q == fresh.model.state().q);
    CHECK(changed.model.state().v == fresh.model.state().v);

    Chain light = pendulum(1.0);
    ancf::DynamicProblem old(light.model);
    REQUIRE(run(old, conserving, until(0.2)).status == Status::converged);
    CHECK(distance(light.model.state().q, fresh.model.state().q) > 1e-3);
}

TEST_CASE("changes: a motion goes on from a change like a scene built in that state",
          "[dynamics]") {
    const bool conserving = GENERATE(false, true);
    Chain changed = pendulum(1.0);
    ancf::DynamicProblem problem(changed.model);
    const DynamicsReport first = run(problem, conserving, until(0.1));
    REQUIRE(first.status == Status::converged);
    const State middle = changed.model.state();
    changed.model.prototype<Bar<3>>(0) = Bar<3>(2.0 * stiffness, 3.0, 1.1 * bar_length);
    CHECK_THROWS_WITH(run(problem, conserving, until(0.2), first.memory),
                      ContainsSubstring("another scene"));
    REQUIRE(run(problem, conserving, until(0.2)).status == Status::converged);

    Chain fresh = chain(3, {0.0, 0.0, 0.0}, {3.3 * bar_length, 0.0, 0.0}, 2.0 * stiffness, 3.0);
    fresh.model.pin(fresh.first());
    fresh.model.set_gravity({0.0, -9.81, 0.0});
    fresh.model.state() = middle;
    ancf::DynamicProblem other(fresh.model);
    REQUIRE(run(other, conserving, until(0.2)).status == Status::converged);
    // rest length and scale of the scene differ: by round-off, measured 0
    CHECK(distance(changed.model.state().q, fresh.model.state().q) <= 1e-11);
    CHECK(momentum(problem, changed.model.state()).linear[1] ==
          Approx(momentum(other, fresh.model.state()).linear[1]).epsilon(1e-10));
}

/// A force that has a potential and does not say so.
struct Push {
    NodeId node;
    static constexpr bool constant_force = true;
    ancf::Coupling coupling() const { return {{node, Field::r}}; }
    void evaluate(const ancf::LoadState& /*state*/, ancf::LoadResult& out) const {
        out.force[1] = 1.0;
    }
};

TEST_CASE("changes: a memory is refused where a scene at rest gets a load without potential",
          "[dynamics]") {
    const bool conserving = GENERATE(false, true);
    Chain before = pendulum(1.0);
    before.model.set_gravity({0.0, 0.0, 0.0});
    ancf::DynamicProblem problem(before.model);
    const DynamicsReport first = run(problem, conserving, until(0.01));
    REQUIRE(first.status == Status::converged);
    ancf::Model after = before.model;  // no rate and so no power tells of the load
    after.add(Push{before.last()});
    ancf::DynamicProblem other(after);
    CHECK_THROWS_WITH(run(other, conserving, until(0.02), first.memory),
                      ContainsSubstring("another scene"));
}

TEST_CASE("changes: a memory is refused even where the energies are those before the change",
          "[dynamics]") {
    Chain scene = pendulum(1.0);
    scene.model.set_gravity({0.0, 0.0, 0.0});  // nothing moves, nothing is strained
    ancf::DynamicProblem problem(scene.model);
    const DynamicsReport first = run(problem, false, until(0.01));
    REQUIRE(first.status == Status::converged);
    const State middle = scene.model.state();
    CHECK(run(problem, false, until(0.02), first.memory).status == Status::converged);
    scene.model.state() = middle;
    const bool heavier = GENERATE(true, false);
    scene.model.prototype<Bar<3>>(0) =
        heavier ? Bar<3>(stiffness, 2.0, bar_length) : Bar<3>(2.0 * stiffness, 1.0, bar_length);
    CHECK_THROWS_WITH(run(problem, false, until(0.02), first.memory),
                      ContainsSubstring("mass or stiffness has changed"));
}

TEST_CASE("changes: a memory is refused where only a drive has changed", "[dynamics]") {
    // generalized-alpha went on from the accelerations of the scene before: with steps of 1 ms off
    // by 1e-3 m, by the first power of the step
    const bool conserving = GENERATE(false, true);
    const bool by_joint = GENERATE(false, true);
    const auto scene = [&](double acceleration) {
        // rests until 0.1 s
        const auto since = [](double t) { return std::max(t - 0.1, 0.0); };
        const auto value = [=](double t) { return 0.5 * acceleration * since(t) * since(t); };
        const auto rate = [=](double t) { return acceleration * since(t); };
        const auto second = [=](double t) { return t < 0.1 ? 0.0 : acceleration; };
        Chain made = chain(3, {0.0, 0.0, 0.0}, {3.0 * bar_length, 0.0, 0.0}, stiffness, 1.0);
        made.model.set_gravity({0.0, -9.81, 0.0});
        if (by_joint)
            made.model.add(ancf::FixedCoordinate<3>(made.first(), Field::r, 0,
                                                    ancf::Motion{value, rate, second}));
        else
            made.model.prescribe(made.first(), Field::r, 0, value, rate, second);
        for (const int k : {1, 2}) made.model.fix(made.first(), Field::r, k);
        return made;
    };
    Chain first = scene(0.0);
    ancf::DynamicProblem problem(first.model);
    const DynamicsReport before = run(problem, conserving, until(0.1));
    REQUIRE(before.status == Status::converged);
    const auto go_on = [&](double acceleration, const ancf::Memory& memory) {
        Chain next = scene(acceleration);
        next.model.state() = first.model.state();
        ancf::DynamicProblem other(next.model);
        return run(other, conserving, until(0.2), memory).status;
    };
    CHECK_THROWS_WITH(go_on(20.0, before.memory), ContainsSubstring("a drive or the place"));
    CHECK(go_on(20.0, {}) == Status::converged);
    CHECK(go_on(0.0, before.memory) == Status::converged);
}

TEST_CASE("changes: within a run they act from the next step on", "[dynamics]") {
    constexpr double middle = 0.1;
    const auto change = [](Chain& scene) {
        scene.model.prototype<Bar<3>>(scene.model.make_own_prototype<Bar<3>>(1)) =
            Bar<3>(2.0 * stiffness, 5.0, bar_length);
        scene.model.set_gravity({1.0, -5.0, 0.0});
        scene.model.add_mass(scene.last(), 0.3);
    };
    Chain within = pendulum(1.0);
    ancf::DynamicProblem problem(within.model);
    Schedule schedule = until(0.2);
    bool done = false;
    schedule.progress = [&](double time, double) {
        if (time > middle - 1e-6 && !done) change(within);
        done = time > middle - 1e-6;
        return true;
    };
    ancf::EnergyMomentumOptions options;
    options.follow_energy = GENERATE(false, true);  // which evaluates the problem between steps
    ancf::EigenLu solver;
    const ancf::EnergyMomentum method(options);
    REQUIRE(method.integrate(problem, solver, schedule).status == Status::converged);
    REQUIRE(done);

    Chain parts = pendulum(1.0);
    ancf::DynamicProblem other(parts.model);
    REQUIRE(run(other, true, until(middle)).status == Status::converged);
    change(parts);
    REQUIRE(run(other, true, until(0.2)).status == Status::converged);
    // one-step method: the second start changes only the prediction
    CHECK(distance(within.model.state().q, parts.model.state().q) <= 1e-11);
    Chain unchanged = pendulum(1.0);
    ancf::DynamicProblem third(unchanged.model);
    REQUIRE(run(third, true, until(0.2)).status == Status::converged);
    CHECK(distance(unchanged.model.state().q, parts.model.state().q) > 1e-3);
}

TEST_CASE("changes: gravity and masses at nodes set after the problem was made count",
          "[dynamics]") {
    Chain scene = chain(3, {0.0, 0.0, 0.0}, {1.2, 0.0, 0.0});
    ancf::DynamicProblem problem(scene.model);
    const double before = problem.mass().sum();
    scene.model.set_gravity({0.0, -3.0, 2.0});
    scene.model.add_mass(scene.last(), 0.7);
    const Start start = problem.start();
    REQUIRE(start.status == Status::converged);
    CHECK(problem.mass().sum() - before == Approx(3.0 * 0.7));  // a mass in three directions
    for (int node = 0; node < 4; ++node)
        CHECK((start.acceleration.segment<3>(3 * node) - Vector3(0.0, -3.0, 2.0)).norm() <= 1e-11);
}

TEST_CASE("changes: a problem refuses a model whose nodes, supports or loads have changed",
          "[dynamics]") {
    Chain scene = pendulum(1.0);
    ancf::DynamicProblem problem(scene.model);
    const Start start = problem.start();
    REQUIRE(start.status == Status::converged);
    SECTION("a load") { scene.model.add(ancf::Force<3>(scene.last(), {1.0, 0.0, 0.0})); }
    SECTION("a support") { scene.model.fix(scene.last(), Field::r, 1); }
    SECTION("a node") { scene.model.add_node({5.0, 0.0, 0.0}); }
    CHECK_THROWS_WITH(problem.start(), ContainsSubstring("make a new"));
    CHECK_THROWS_WITH(
        problem.evaluate(0.0, start.q, start.v, start.multipliers, ancf::Request::force),
        ContainsSubstring("make a new"));
    CHECK_THROWS_AS(run(problem, false, until(0.1)), ancf::InvalidArgument);
}

TEST_CASE("changes: a mass that is no longer positive is refused at every call", "[dynamics]") {
    Chain scene = pendulum(1.0);
    ancf::DynamicProblem problem(scene.model);
    scene.model.prototype<Bar<3>>(0) = Bar<3>(stiffness, -1.0, bar_length);
    CHECK_THROWS_WITH(problem.start(), ContainsSubstring("not positive definite"));
    CHECK_THROWS_WITH(problem.start(), ContainsSubstring("not positive definite"));
}

TEST_CASE("changes: a softer bar of a chain takes the stretch that statics gives it", "[statics]") {
    Chain scene = chain(3, {0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, 100.0);
    scene.model.pin(scene.first());
    for (const NodeId node : scene.nodes)
        for (const int k : {1, 2}) scene.model.fix(node, Field::r, k);
    constexpr double pull = 12.0;
    scene.model.add(ancf::Force<3>(scene.last(), {pull, 0.0, 0.0}));
    const auto stretch = [](double EA) {  // EA (lam^2 - 1)/2 lam = pull
        double lam = 1.0;
        for (int k = 0; k < 50; ++k)
            lam -=
                (0.5 * EA * lam * (lam * lam - 1.0) - pull) / (0.5 * EA * (3.0 * lam * lam - 1.0));
        return lam;
    };
    ancf::EigenLu solver;
    REQUIRE(solve_statics(scene.model, solver).status == Status::converged);
    CHECK(scene.model.position(scene.last())[0] == Approx(3.0 * stretch(100.0)).epsilon(1e-12));
    scene.model.prototype<Bar<3>>(scene.model.make_own_prototype<Bar<3>>(1)) =
        Bar<3>(20.0, 1.0, 1.0);
    REQUIRE(solve_statics(scene.model, solver).status == Status::converged);
    CHECK(scene.model.position(scene.nodes[1])[0] == Approx(stretch(100.0)).epsilon(1e-12));
    CHECK(scene.model.position(scene.nodes[2])[0] ==
          Approx(stretch(100.0) + stretch(20.0)).epsilon(1e-12));
    CHECK(scene.model.position(scene.nodes[3])[0] ==
          Approx(2.0 * stretch(100.0) + stretch(20.0)).epsilon(1e-12));
}

}  // namespace changes_test
