// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// The leapfrog: order, energy, stable steps, and how a run starts, fails and ends.

#include <ancf/dynamics/leapfrog.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/loads/damping.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>

#include <dynamics/scenes.hpp>
#include <support/catch.hpp>
#include <support/driven_arm.hpp>
#include <support/scaled_motions.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace leapfrog_test {

using namespace ancf;
using namespace ancf::test;
using ancf::test::Chain;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

LeapfrogOptions fixed(double step) {
    LeapfrogOptions options;
    options.step = step;
    return options;
}

LeapfrogReport run(Scene& model, const LeapfrogOptions& options, const Schedule& schedule) {
    DynamicProblem problem(model);
    return Leapfrog(options).integrate(problem, schedule);
}

/// Two soft bars that hang on a pin and are thrown out of the plane of gravity; they vibrate at up
/// to 35 rad/s.
Chain soft_chain() {
    Chain scene = chain(2, {0.0, 0.0, 0.0}, {1.2, 0.0, 0.0}, 20.0);
    scene.model.pin(scene.first());
    scene.model.set_gravity({0.0, -2.0, 0.0});
    scene.model.set_rate(scene.last(), Field::r, {0.0, 0.0, 0.7});
    return scene;
}

/// A force across a bar that turns with it: it has no potential.
struct Thrust {
    NodeId first, second;
    double stiffness;  // N/m, of the bar's length

    [[nodiscard]] Coupling coupling() const { return {{first, Field::r}, {second, Field::r}}; }
    void evaluate(const LoadState& state, LoadResult& out) const {
        out.force[3] -= stiffness * (state.q[4] - state.q[1]);
        out.force[4] += stiffness * (state.q[3] - state.q[0]);
    }
};

/// The same with a pin that is driven, a force that grows and one that follows a bar.
Chain driven_chain() {
    Chain scene = chain(2, {0.0, 0.0, 0.0}, {1.2, 0.0, 0.0}, 20.0);
    const Motion motion = sine(0.05, 4.0);
    scene.model.prescribe(scene.first(), Field::r, 1, motion.value, motion.rate,
                          motion.acceleration);
    scene.model.fix(scene.first(), Field::r, 0);
    scene.model.fix(scene.first(), Field::r, 2);
    scene.model.set_rate(scene.first(), Field::r, {0.0, 0.2, 0.0});
    scene.model.set_gravity({0.0, -2.0, 0.0});
    scene.model.add(Force<3>(scene.last(), {0.0, 0.0, 1.0}),
                    [](double t) { return std::sin(3.0 * t); });
    scene.model.add(Thrust{scene.nodes[1], scene.last(), 4.0});
    return scene;
}

/// Two soft bars on a link, thrown out of the plane of gravity.
Chain soft_swing() {
    Chain scene = chain(2, {0.0, -0.5, 0.0}, {1.2, -0.5, 0.0}, 20.0);
    scene.model.add(Distance<3>(scene.first(), Vector3(0.0, 0.0, 0.0), 0.5));
    scene.model.set_gravity({0.0, -2.0, 0.0});
    for (const NodeId node : scene.nodes) scene.model.set_rate(node, Field::r, {0.0, 0.0, 0.7});
    return scene;
}

/// The same on a link that grows, with its first node driven along a wall.
Chain driven_swing() {
    Chain scene = soft_swing();
    const Motion motion = sine(0.05, 4.0);
    scene.model.prescribe(scene.first(), Field::r, 2, motion.value, motion.rate,
                          motion.acceleration);
    scene.model.set_rate(scene.first(), Field::r, {0.0, 0.0, 0.2});
    const auto grown = [](double t) { return 0.7 + 0.1 * std::sin(2.0 * t) * std::sin(2.0 * t); };
    scene.model.add(Distance<3>(scene.last(), Vector3(1.2, -0.5, -0.7),
                                Motion{grown, [](double t) { return 0.2 * std::sin(4.0 * t); },
                                       [](double t) { return 0.8 * std::cos(4.0 * t); }}));
    scene.model.set_rate(scene.last(), Field::r, {0.5, 0.0, 0.0});
    scene.model.add(Thrust{scene.nodes[1], scene.last(), 4.0});
    return scene;
}

/// Two beams of one soft element each that a hinge joins.
struct Elbows {
    Model model;
};

Elbows soft_elbows() {
    Elbows scene;
    const auto add = [&](const Vector3& from, const Vector3& to) {
        return straight_beam<CrossSectionBeam<3>>(
            scene.model, Material::from_moduli(1e5, 4e4, 5540.0), rectangle(0.1, 0.1), from, to, 1);
    };
    const Vector3 middle(0.8, 0.0, 0.0);
    const auto first = add(Vector3(0.0, 0.0, 0.0), middle);
    const auto second = add(middle, middle + Vector3(0.0, 0.0, 0.8));
    scene.model.pin(first.first());
    scene.model.add(Revolute(scene.model, first.last(), second.first(), Vector3(1.0, 1.0, 0.0)));
    scene.model.set_gravity({0.0, -2.0, 0.0});
    return scene;
}

/// A soft beam in the plane whose root is turned.
struct Crank {
    PlanarModel model;
};

Crank soft_crank() {
    Crank scene;
    const auto beam = straight_beam<CrossSectionBeam<2>>(
        scene.model, Material::from_moduli(2e5, 8e4, 1000.0), rectangle(0.1, 0.1),
        Vector<double, 2>(0.0, 0.0), Vector<double, 2>(0.6, 0.0), 1);
    scene.model.add(PlanarWeld(scene.model, beam.first(),
                               Motion{[](double t) { return 1.0 - std::cos(4.0 * t); },
                                      [](double t) { return 4.0 * std::sin(4.0 * t); },
                                      [](double t) { return 16.0 * std::cos(4.0 * t); }}));
    return scene;
}

struct Error {
    double q = 0.0, v = 0.0, lambda = 0.0;
};

/// Returns the largest errors at fifty times within half a second, most of them between steps.
template <class Make>
Error error_of(const Make& make, const std::vector<State>& exact, const LeapfrogOptions& options) {
    auto scene = make();
    Schedule schedule = equal_intervals(0.0, 0.5, 0.01);
    schedule.times.erase(schedule.times.begin());
    Error error;
    std::size_t seen = 0;
    schedule.observe = [&](const Snapshot& at) {
        error.q = std::max(error.q, distance(at.state.q, exact[seen].q));
        error.v = std::max(error.v, distance(at.state.v, exact[seen].v));
        if (exact[seen].multipliers.size() > 0)
            error.lambda =
                std::max(error.lambda, distance(at.state.multipliers, exact[seen].multipliers));
        CHECK(at.violation <= 1e-14);
        CHECK(at.violation_rate <= 1e-13);
        ++seen;
    };
    const LeapfrogReport report = run(scene.model, options, schedule);
    CAPTURE(report.message);
    REQUIRE(report.status == Status::converged);
    REQUIRE(seen == exact.size());
    CHECK(distance(scene.model.state().q, exact.back().q) <= error.q);
    return error;
}

template <class Make>
void check_order(const Make& make, double largest = 1e-6, int steps = 60) {
    auto scene = make();
    const std::vector<State> exact = by_runge_kutta(scene.model, 0.5, 10000, 50);
    const Error coarse = error_of(make, exact, fixed(0.5 / steps)),
                fine = error_of(make, exact, fixed(0.25 / steps));
    CAPTURE(coarse.q, fine.q, coarse.v, fine.v, coarse.lambda, fine.lambda);
    CHECK(std::log2(coarse.q / fine.q) == Approx(4.0).margin(0.2));
    CHECK(std::log2(coarse.v / fine.v) == Approx(4.0).margin(0.2));
    CHECK(fine.q <= largest);
    if (coarse.lambda == 0.0) return;
    CHECK(std::log2(coarse.lambda / fine.lambda) == Approx(4.0).margin(0.4));
}

TEST_CASE("Leapfrog: it is of fourth order, at steps and between them", "[dynamics][leapfrog]") {
    check_order(soft_chain);
}

TEST_CASE("Leapfrog: it is of fourth order with what is driven in time", "[dynamics][leapfrog]") {
    check_order(driven_chain);
}

TEST_CASE("Leapfrog: it is of fourth order with links and joints, driven ones too",
          "[dynamics][leapfrog][constraint]") {
    check_order(soft_swing);
    check_order(driven_swing, 1e-5);
    check_order(soft_elbows, 1e-5, 100);
    check_order(soft_crank, 1e-5, 200);
}

TEST_CASE("Leapfrog: a step takes two forces", "[dynamics][leapfrog]") {
    for (Chain (*make)() : {soft_chain, soft_swing}) {
        Chain scene = make(), other = make();
        LeapfrogOptions options = fixed(0.01);
        options.follow_energy = false;
        const long few = run(scene.model, options, until(0.5)).evaluations;
        const long many = run(other.model, options, until(1.5)).evaluations;
        CHECK(many - few == 200);
        CHECK(few <= 110);
    }
}

/// Returns by how much the error of energy, its root mean square over four starts, grows from the
/// first tenth of 2000 s to the last one: hundreds of swings and thousands.
double growth_of_energy_error(Chain (*make)()) {
    // largest errors of chaotic motions differ by half from start to start
    double early = 0.0, late = 0.0;
    int seen = 0;
    for (const double more : {0.0, 0.01, 0.02, 0.03}) {
        Chain scene = make();
        scene.model.set_rate(scene.last(), Field::r, {0.0, 0.0, 0.7 + more});
        Schedule schedule = equal_intervals(0.0, 2000.0, 0.2);
        double start = 0.0, first = 0.0, last = 0.0;
        schedule.observe = [&](const Snapshot& at) {
            if (at.state.time == 0.0) start = at.energies.total();
            const double error = std::pow(at.energies.total() - start, 2);
            if (at.state.time <= 200.0) first += error;
            if (at.state.time >= 1800.0) last += error;
            ++seen;
        };
        const LeapfrogReport report = run(scene.model, fixed(0.02), schedule);
        REQUIRE(report.status == Status::converged);
        CHECK(report.violation <= 1e-11);
        CHECK(report.violation_rate <= 1e-6);
        CHECK(report.energy_drift <= 1e-2 * report.kinetic_largest);  // 6e-3
        early += first / std::pow(report.kinetic_largest, 2);
        late += last / std::pow(report.kinetic_largest, 2);
    }
    CHECK(seen == 4 * 10001);
    return std::sqrt(late / early);
}

TEST_CASE("Leapfrog: the energy of a long run does not drift", "[dynamics][leapfrog]") {
    CHECK(growth_of_energy_error(soft_chain) <= 1.4);  // 1.07
}

TEST_CASE("Leapfrog: nor does it with a link", "[dynamics][leapfrog][constraint]") {
    CHECK(growth_of_energy_error(soft_swing) <= 1.4);  // 1.02
}

/// Checks that a scene moves as another one with an equation more, which is left out.
void check_left_out(Chain& scene, Chain& more, double margin) {
    ProblemOptions options;
    options.redundancy = Redundancy::minimum_norm;
    DynamicProblem problem(more.model, options);
    REQUIRE(Leapfrog(fixed(0.01)).integrate(problem, until(0.5)).status == Status::converged);
    REQUIRE(run(scene.model, fixed(0.01), until(0.5)).status == Status::converged);
    CHECK(distance(scene.model.state().q, more.model.state().q) <= margin);
}

TEST_CASE("Leapfrog: of equations that repeat each other one is left out",
          "[dynamics][leapfrog][constraint]") {
    Chain scene = soft_swing(), twice = soft_swing();
    twice.model.add(Distance<3>(twice.first(), Vector3(0.0, 0.0, 0.0), 0.5));
    CHECK(run(twice.model, fixed(0.01), until(0.5)).status == Status::redundant);
    check_left_out(scene, twice, 1e-12);
    const double force = scene.model.state().multipliers[0];
    for (const double share : twice.model.state().multipliers)
        CHECK(share == Approx(0.5 * force).epsilon(1e-9));
}

TEST_CASE("Leapfrog: an equation between supports alone is left out too",
          "[dynamics][leapfrog][constraint]") {
    Chain scene = soft_chain(), held = soft_chain();
    held.model.add(Distance<3>(held.first(), Vector3(0.0, 1.0, 0.0), 1.0));
    check_left_out(scene, held, 1e-14);
    CHECK(held.model.state().multipliers[0] == 0.0);
}

TEST_CASE("Leapfrog: who looks on changes no step", "[dynamics][leapfrog][constraint]") {
    int seen = 0;
    const auto end = [&](std::vector<double> times) {
        Chain scene = soft_swing();
        for (const NodeId node : scene.nodes) scene.model.set_rate(node, Field::r, {0.0, 0.0, 3.0});
        Schedule schedule = until(4.0);
        schedule.times = std::move(times);
        schedule.observe = [&](const Snapshot&) { ++seen; };
        REQUIRE(run(scene.model, {}, schedule).status == Status::converged);
        return scene.model.state().q;
    };
    CHECK(distance(end({}), end(equal_intervals(0.0, 4.0, 0.1).times)) <= 1e-10);
    CHECK(seen == 41);
}

TEST_CASE("Leapfrog: bars between links rest", "[dynamics][leapfrog][constraint]") {
    Chain scene = chain(3, {0.0, 0.0, 0.0}, {1.2, 0.3, 0.0}, 2e4);
    for (std::size_t k = 1; k < scene.nodes.size(); ++k)
        scene.model.add(
            Distance<3>(scene.nodes[k - 1], scene.nodes[k], Vector3(1.2, 0.3, 0.0).norm() / 3));
    const VectorX before = scene.model.state().q;
    const LeapfrogReport report = run(scene.model, fixed(2e-3), until(1.0));
    CHECK(report.status == Status::converged);
    CHECK(distance(scene.model.state().q, before) <= 1e-13);
}

TEST_CASE("Leapfrog: a light node on a taut link is moved in steps that are stable",
          "[dynamics][leapfrog][constraint][stability]") {
    // the link's force makes the light end stiff across it
    Chain scene = chain(1, {0.0, -0.05, 0.0}, {0.0, -1.05, 0.0}, 20.0, 0.01);
    scene.model.add(Distance<3>(scene.first(), Vector3(0.0, 0.0, 0.0), 0.05));
    scene.model.add(Force<3>(scene.last(), {0.0, -5.0, 0.0}));
    scene.model.set_rate(scene.last(), Field::r, {0.1, 0.0, 0.0});
    const LeapfrogReport report = run(scene.model, {}, until(5.0));
    CHECK(report.status == Status::converged);
    CHECK(report.energy_drift <= 0.2 * report.kinetic_largest);
}

TEST_CASE("Leapfrog: joints are driven by any angle", "[dynamics][leapfrog][constraint]") {
    for (const double angle : {1.0, 10.0}) {
        const Motion motion = smooth_turn(angle);
        DrivenArm arm(motion);
        Schedule schedule = equal_intervals(0.0, 1.0, 1.0 / 64);
        TurnCounter counter(arm, motion);
        schedule.observe = [&](const Snapshot& seen) { counter.see(seen.state); };
        const LeapfrogReport report = run(arm.model, {}, schedule);
        CAPTURE(report.message);
        CHECK(report.status == Status::converged);
        CHECK(std::abs(counter.turned() - angle) <= 1e-9);
        CHECK(counter.farthest() <= 1e-9);
        CHECK(arm.wound() <= 0.5);
    }
    // a joint that is driven too far in a step says so
    DrivenArm arm(Motion{[](double t) { return t > 1e-5 ? 2.0 : 0.0; }, [](double) { return 0.0; },
                         [](double) { return 0.0; }});
    const LeapfrogReport report = run(arm.model, {}, until(1e-3));
    CHECK(report.status == Status::max_iterations);
    CHECK_THAT(report.message, ContainsSubstring("is driven by 2 rad"));
}

TEST_CASE("Leapfrog: the default's steps are stable where fast modes move",
          "[dynamics][leapfrog][stability]") {
    for (const double stiffness : {200.0, 500.0}) {  // strains up to 4 %
        CAPTURE(stiffness);
        Chain scene = chain(3, {0.0, 0.0, 0.0}, {1.2, 0.0, 0.0}, stiffness);
        scene.model.pin(scene.first());
        scene.model.set_gravity({0.0, -2.0, 0.0});
        scene.model.set_rate(scene.last(), Field::r, {0.0, 0.0, 0.7});
        const LeapfrogReport report = run(scene.model, {}, until(60.0));
        CHECK(report.status == Status::converged);
        CHECK(report.energy_drift <= 0.5 * report.kinetic_largest);
    }
}

TEST_CASE("Leapfrog: steps up to the stable one are stable", "[dynamics][leapfrog][stability]") {
    // a bar that vibrates along itself by a millionth of its length
    Chain scene = chain(1, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    scene.model.pin(scene.first());
    scene.model.set_rate(scene.last(), Field::r, {1e-5, 0.0, 0.0});
    DynamicProblem problem(scene.model);
    const double frequency = problem.highest_frequency(0.0, problem.start().q);
    CHECK(frequency == Approx(std::sqrt(3.0 * 500.0)).epsilon(1e-6));
    const double stable = std::sqrt(12.0) / frequency;
    const auto drift = [&](double step, int steps) {
        Chain again = chain(1, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
        again.model.pin(again.first());
        again.model.set_rate(again.last(), Field::r, {1e-5, 0.0, 0.0});
        const LeapfrogReport report = run(again.model, fixed(step), until(steps * step));
        CHECK(report.status == Status::converged);
        CHECK(report.stable_step == Approx(stable).epsilon(1e-3));
        return report.energy_drift / report.energy_start;
    };
    for (const double share : {0.1, 0.5, 0.9, 0.99}) {
        CAPTURE(share);
        CHECK(drift(share * stable, 4000) <= 1.01 * drift(share * stable, 400));
    }
    CHECK(drift(0.1 * stable, 400) <= 1e-3);
}

TEST_CASE("Leapfrog: its steps are the longest below the share of the stable one",
          "[dynamics][leapfrog][stability]") {
    for (const double share : {0.3, 0.6}) {
        Chain scene = soft_chain();
        LeapfrogOptions options;
        options.stable_share = share;
        const LeapfrogReport report = run(scene.model, options, until(2.0));
        CHECK(report.status == Status::converged);
        CHECK(report.largest_step <= report.stable_step);
        CHECK(report.smallest_step >= 0.4 * share * report.stable_step);
        CHECK(report.energy_drift <= share * report.kinetic_largest);
    }
}

/// A bar whose end is pulled to three times its length within a second.
Chain stretched() {
    Chain scene = chain(2, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    scene.model.pin(scene.first());
    for (const int k : {1, 2}) scene.model.fix(scene.last(), Field::r, k);
    scene.model.prescribe(
        scene.last(), Field::r, 0, [](double t) { return 1.0 + 2.0 * t * t; },
        [](double t) { return 4.0 * t; }, [](double) { return 4.0; });
    return scene;
}

TEST_CASE("Leapfrog: a scene that stiffens takes shorter steps",
          "[dynamics][leapfrog][stability]") {
    Chain scene = stretched();
    LeapfrogOptions options;
    options.stable_interval = 10;
    const LeapfrogReport report = run(scene.model, options, until(1.0));
    CHECK(report.status == Status::converged);
    CHECK(report.smallest_step < 0.6 * report.largest_step);
    CHECK(report.smallest_step <= report.stable_step);
    Chain same = stretched();
    const LeapfrogReport late = run(same.model, fixed(0.9 * std::sqrt(12.0) / 90.0), until(1.0));
    CHECK(late.status == Status::diverged);
    CHECK(late.steps > 0);
    CHECK(late.time < 1.0);
    CHECK_THAT(late.message, ContainsSubstring("is above the stable one of"));
    CHECK(same.model.state().time == late.time);
}

TEST_CASE("Leapfrog: steps do not grow where a scene softens for a while",
          "[dynamics][leapfrog][stability]") {
    // there and back within a second
    Chain scene = chain(2, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    scene.model.pin(scene.first());
    for (const int k : {1, 2}) scene.model.fix(scene.last(), Field::r, k);
    const double turn = std::acos(-1.0);
    scene.model.prescribe(
        scene.last(), Field::r, 0, [=](double t) { return 2.0 - std::cos(2.0 * turn * t); },
        [=](double t) { return 2.0 * turn * std::sin(2.0 * turn * t); },
        [=](double t) { return 4.0 * turn * turn * std::cos(2.0 * turn * t); });
    Schedule schedule = until(1.0);
    double last = 0.0, before = 0.0;
    schedule.progress = [&](double time, double) {
        last = time - before;
        before = time;
        return true;
    };
    const LeapfrogReport report = run(scene.model, {}, schedule);
    CHECK(report.status == Status::converged);
    CHECK(report.largest_step > 2.0 * report.smallest_step);
    CHECK(last < 1.1 * report.smallest_step);
    CHECK(report.stable_step > 4.0 * last);
}

TEST_CASE("Leapfrog: a part that becomes the stiffest of a scene shortens the steps",
          "[dynamics][leapfrog][stability]") {
    LeapfrogOptions options;
    options.stable_share = 0.1;
    Chain alone = stretched();
    const double expected = run(alone.model, options, until(1.0)).stable_step;
    // another bar, twice as stiff at first and by itself
    Chain scene = stretched();
    const int prototype = scene.model.add_prototype(Bar<3>(1000.0, 1.0, 0.5));
    const NodeId foot = scene.model.add_node({0.0, 5.0, 0.0});
    const NodeId end = scene.model.add_node({0.5, 5.0, 0.0});
    scene.model.connect<Bar<3>>(prototype, foot, end);
    scene.model.pin(foot);
    const LeapfrogReport report = run(scene.model, options, until(1.0));
    CHECK(report.status == Status::converged);
    CHECK(report.stable_step == Approx(expected).epsilon(0.01));
    CHECK(report.smallest_step < 0.6 * report.largest_step);
}

TEST_CASE("Leapfrog: a bar without stiffness where it starts is moved in steps all the same",
          "[dynamics][leapfrog][stability]") {
    // straight, between two walls that its end glides along, and thrown across itself
    for (const double speed : {1.0, 30.0}) {
        CAPTURE(speed);
        Chain scene = chain(1, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
        scene.model.pin(scene.first());
        scene.model.fix(scene.last(), Field::r, 0);
        scene.model.set_rate(scene.last(), Field::r, {0.0, speed, 0.0});
        const LeapfrogReport report = run(scene.model, {}, until(5.0));
        CHECK(report.status == Status::converged);
        CHECK(report.energy_drift <= 0.2 * report.kinetic_largest);
    }
}

TEST_CASE("Leapfrog: a fixed step above the stable one is refused", "[dynamics][leapfrog]") {
    Chain scene = soft_chain();
    Schedule schedule = until(1.0);
    int seen = 0;
    schedule.times = {0.0, 0.5};
    schedule.observe = [&](const Snapshot&) { ++seen; };
    const LeapfrogReport report = run(scene.model, fixed(0.2), schedule);
    CHECK(report.status == Status::diverged);
    CHECK(report.steps == 0);
    CHECK(seen == 1);
    CHECK_THAT(report.message, ContainsSubstring("0.2 s is above the stable one of"));
}

TEST_CASE("Leapfrog: the paper's pendulum passes the known heights", "[dynamics][leapfrog]") {
    Model model;
    const auto beam = straight_beam<CrossSectionBeam<3>>(
        model, Material::from_moduli(0.7e6, 2.6923e5, 5540.0),
        rectangle(0.05, 0.05).with_shear_correction(5.0 / 6.0, 5.0 / 6.0), {0.0, 0.0, 0.0},
        {1.2, 0.0, 0.0}, 4, CrossSectionOptions::paper());
    model.pin(beam.first());
    model.set_gravity({0.0, -9.81, 0.0});
    const int tip = model.coordinate(beam.last(), Field::r);
    Schedule schedule = until(1.2);
    schedule.times = {0.2, 0.5, 0.8, 1.2};
    std::vector<double> heights;
    schedule.observe = [&](const Snapshot& at) { heights.push_back(at.state.q[tip + 1]); };
    const LeapfrogReport report = run(model, fixed(1e-3), schedule);
    REQUIRE(report.status == Status::converged);
    REQUIRE(heights.size() == 4);
    const double exact[] = {-0.194023, -1.303027, -0.766241, 0.170784};  // in time, to 1e-6
    for (std::size_t k = 0; k < 4; ++k) CHECK(std::abs(heights[k] - exact[k]) <= 5e-6);
    CHECK(report.energy_drift <= 1e-4 * report.kinetic_largest);
    CHECK(report.factorisations == 0);
}

TEST_CASE("Leapfrog: damping is refused with what to take instead", "[dynamics][leapfrog][input]") {
    Chain damped = soft_chain();
    damped.model.add(Force<3>(damped.last(), {0.0, 1.0, 0.0}));
    MatrixX D = MatrixX::Zero(3, 3);
    D.data()[0] = 1e-9;  // however small, and switched on later
    damped.model.add(LinearDamping({{damped.last(), Field::r}}, D),
                     [](double t) { return t > 1.0 ? 1.0 : 0.0; });
    for (const char* name : {"load 1 depends on rates", "sundials::Explicit"})
        CHECK_THROWS_WITH(run(damped.model, {}, until(0.1)), ContainsSubstring(name));
    CHECK_THROWS_AS(run(damped.model, {}, until(0.1)), InvalidArgument);
}

TEST_CASE("Leapfrog: options, schedules and scenes that cannot be meant are refused",
          "[dynamics][leapfrog][input]") {
    const auto refused = [](auto change, const std::string& name) {
        LeapfrogOptions options;
        change(options);
        CHECK_THROWS_WITH(Leapfrog(options), ContainsSubstring(name));
        CHECK_THROWS_AS(Leapfrog(options), InvalidArgument);
    };
    for (const double value : {-1.0, nan, infinity})
        refused([&](LeapfrogOptions& o) { o.step = value; }, "step");
    for (const double share : {0.0, 1.0, -0.5, nan})
        refused([&](LeapfrogOptions& o) { o.stable_share = share; }, "stable_share");
    refused([](LeapfrogOptions& o) { o.stable_interval = 0; }, "stable_interval");
    refused([](LeapfrogOptions& o) { o.max_steps = -1; }, "max_steps");

    Chain scene = soft_chain();
    CHECK_THROWS_AS(run(scene.model, {}, until(-1.0)), InvalidArgument);
    CHECK_THROWS_WITH(run(scene.model, fixed(1e-18), until(1.0)),
                      ContainsSubstring("resolution of time"));
    for (const NodeId node : scene.nodes) scene.model.pin(node);
    CHECK_THROWS_WITH(run(scene.model, {}, until(1.0)), ContainsSubstring("no free coordinate"));
}

TEST_CASE("Leapfrog: a run of no length reports its start, a huge step is cut to the run",
          "[dynamics][leapfrog]") {
    for (const double step : {0.0, 1e-3, 1e6}) {
        Chain scene = soft_chain();
        Schedule schedule = until(0.0);
        schedule.times = {0.0};
        int seen = 0;
        schedule.observe = [&](const Snapshot&) { ++seen; };
        const LeapfrogReport none = run(scene.model, fixed(step), schedule);
        CHECK(none.status == Status::converged);
        CHECK(none.steps == 0);
        CHECK(seen == 1);
        const LeapfrogReport one = run(scene.model, fixed(step), until(1e-3));
        CHECK(one.status == Status::converged);
        CHECK(one.steps == 1);
        CHECK(scene.model.state().time == 1e-3);
    }
}

TEST_CASE("Leapfrog: more than max_steps are refused before they are taken",
          "[dynamics][leapfrog]") {
    Chain scene = soft_chain();
    LeapfrogOptions options;
    options.max_steps = 10;
    const LeapfrogReport report = run(scene.model, options, until(10.0));
    CHECK(report.status == Status::max_iterations);
    CHECK(report.steps == 0);
    CHECK_THAT(report.message, ContainsSubstring("max_steps is 10; a stiff scene is one for"));
}

/// A load that is no number when it is asked for the n-th time, or below a height.
struct Lapse {
    NodeId node;
    int at;
    double height;
    std::shared_ptr<int> calls = std::make_shared<int>(0);

    [[nodiscard]] Coupling coupling() const { return {{node, Field::r}}; }
    void evaluate(const LoadState& state, LoadResult& out) const {
        if (++*calls == at || state.q[1] < height) out.force[1] = nan;
    }
};

TEST_CASE("Leapfrog: a step into what cannot be evaluated is taken again, shorter",
          "[dynamics][leapfrog][failure]") {
    Chain scene = soft_chain(), same = soft_chain();
    scene.model.add(Lapse{scene.last(), 40, -10.0});
    LeapfrogOptions options;
    options.follow_energy = false;
    options.stable_share = 0.3;
    const LeapfrogReport once = run(scene.model, options, until(1.0));
    CHECK(once.status == Status::converged);
    CHECK(once.convergence_failures == 1);
    CHECK(!once.fault);
    REQUIRE(run(same.model, options, until(1.0)).status == Status::converged);
    CHECK(distance(scene.model.state().q, same.model.state().q) <= 1e-3);

    for (const int at : {37, 38, 39, 40, 41}) {  // each force of a step, and of a beginning
        Chain linked = soft_swing(), whole = soft_swing();
        linked.model.add(Lapse{linked.last(), at, -10.0});
        const LeapfrogReport cut = run(linked.model, options, until(1.0));
        CHECK(cut.status == Status::converged);
        CHECK(cut.convergence_failures == 1);
        REQUIRE(run(whole.model, options, until(1.0)).status == Status::converged);
        CHECK(distance(linked.model.state().q, whole.model.state().q) <= 1e-3);
    }

    Chain falling = soft_chain();
    falling.model.add(Lapse{falling.last(), 0, -0.1});
    const LeapfrogReport stopped = run(falling.model, {}, until(2.0));
    CHECK(stopped.status == Status::not_finite);
    CHECK(stopped.convergence_failures >= 12);
    CHECK_THAT(stopped.message, ContainsSubstring("force of load 0 is not finite"));
    CHECK(falling.model.state().time == stopped.time);
    CHECK(falling.model.state().q.allFinite());
    Chain cut = soft_chain();
    cut.model.add(Lapse{cut.last(), 0, -0.1});
    const LeapfrogReport at_once = run(cut.model, fixed(0.01), until(2.0));
    CHECK(at_once.status == Status::not_finite);
    CHECK(at_once.convergence_failures == 1);
}

/// A load that has no value within a time, from the first instant on if not said otherwise.
struct Gone {
    NodeId node;
    double from = 0.0, to = infinity;

    [[nodiscard]] Coupling coupling() const { return {{node, Field::r}}; }
    void evaluate(const LoadState& state, LoadResult& out) const {
        if (state.time > from && state.time < to) out.force[1] = nan;
    }
};

TEST_CASE("Leapfrog: where the first step fails the multipliers are those of the start",
          "[dynamics][leapfrog][constraint][failure]") {
    for (const double step : {0.0, 0.01}) {
        Chain scene = soft_swing();
        for (const NodeId node : scene.nodes) scene.model.set_rate(node, Field::r, {0.0, 0.0, 3.0});
        const VectorX start = DynamicProblem(scene.model).start().multipliers;
        scene.model.add(Gone{scene.last()});
        CHECK(run(scene.model, fixed(step), until(0.5)).status == Status::not_finite);
        CHECK(distance(scene.model.state().multipliers, start) <= 1e-12);
    }
}

TEST_CASE("Leapfrog: a load without a value between steps alone is no fault",
          "[dynamics][leapfrog][constraint][failure]") {
    Chain scene = soft_swing();
    scene.model.add(Gone{scene.last(), 0.497, 0.4985});
    Schedule schedule = until(0.5);
    schedule.times = {0.498};
    int seen = 0;
    schedule.observe = [&](const Snapshot& at) { seen += at.state.q.allFinite() ? 1 : 0; };
    const LeapfrogReport report = run(scene.model, fixed(0.01), schedule);
    CHECK(report.status == Status::converged);
    CHECK(!report.fault);
    CHECK(seen == 1);
}

TEST_CASE("Leapfrog: a callback stops a run", "[dynamics][leapfrog]") {
    Chain scene = soft_chain();
    Schedule schedule = until(1.0);
    schedule.progress = [](double time, double) { return time < 0.1; };
    const LeapfrogReport stopped = run(scene.model, fixed(0.01), schedule);
    CHECK(stopped.status == Status::stopped);
    CHECK(stopped.time >= 0.1);
    CHECK(scene.model.state().time == stopped.time);
}

TEST_CASE("Leapfrog: a run goes on where another one ended", "[dynamics][leapfrog]") {
    Chain (*const make)() = GENERATE(soft_chain, soft_swing);
    const auto error = [make](int parts, double step) {
        Chain exact = make(), scene = make();
        REQUIRE(run(exact.model, fixed(1e-3), until(1.0)).status == Status::converged);
        for (int k = 1; k <= parts; ++k)
            REQUIRE(run(scene.model, fixed(step), until(static_cast<double>(k) / parts)).status ==
                    Status::converged);
        return distance(scene.model.state().q, exact.model.state().q);
    };
    CHECK(error(1, 0.01) <= 2e-6);
    CHECK(error(5, 0.01) <= 3.0 * error(1, 0.01));
    CHECK(error(5, 0.005) <= error(5, 0.01) / 12.0);  // of fourth order as well
}

/// Three stiff bars that swing.
Chain stiff_chain() {
    Chain scene = chain(3, {0.0, 0.0, 0.0}, {1.2, 0.0, 0.0}, 2e4);
    scene.model.pin(scene.first());
    scene.model.set_gravity({0.0, -2.0, 0.0});
    return scene;
}

TEST_CASE("Leapfrog: many short runs of the longest steps stay stable",
          "[dynamics][leapfrog][stability]") {
    LeapfrogOptions options;
    options.stable_share = 0.8;
    for (const double duration : {0.005, 0.01, 0.02}) {  // 3 to 9 steps
        CAPTURE(duration);
        Chain scene = stiff_chain();
        double drift = 0.0, start = 0.0, kinetic = 0.0;
        for (int k = 1; k <= 500; ++k) {
            const LeapfrogReport report = run(scene.model, options, until(k * duration));
            REQUIRE(report.status == Status::converged);
            if (k == 1) start = report.energy_start;
            drift = std::max(drift, std::abs(report.energy_start - start));
            kinetic = std::max(kinetic, report.kinetic_largest);
        }
        CHECK(drift <= 0.02 * kinetic);  // fast vibrations are damped where runs meet
    }
}

TEST_CASE("Leapfrog: an observer changes the mass of a scene on a link",
          "[dynamics][leapfrog][constraint]") {
    const auto end = [](double step) {
        Chain scene = soft_swing();
        Schedule schedule = until(0.4);
        schedule.times = {0.2};
        schedule.observe = [&](const Snapshot&) {
            scene.model.set_gravity({3.0, 0.0, 0.0});
            scene.model.prototype<Bar<3>>(0) = Bar<3>(20.0, 1.5, 0.6);
        };
        REQUIRE(run(scene.model, fixed(step), schedule).status == Status::converged);
        return scene.model.state().q;
    };
    const VectorX exact = end(5e-4);
    const double coarse = distance(end(1e-2), exact), fine = distance(end(5e-3), exact);
    CAPTURE(coarse, fine);
    CHECK(fine <= coarse / 12.0);
    CHECK(fine <= 1e-5);
}

TEST_CASE("Leapfrog: what an observer changes holds from the next step on",
          "[dynamics][leapfrog]") {
    const auto end = [](double step, double changed_at) {
        Chain scene = stiff_chain();
        Schedule schedule = until(1.0);
        schedule.times = {changed_at};
        schedule.observe = [&](const Snapshot&) { scene.model.set_gravity({3.0, 0.0, 0.0}); };
        REQUIRE(run(scene.model, fixed(step), schedule).status == Status::converged);
        return scene.model.state().q;
    };
    for (const double time : {0.0, 0.5}) {
        const VectorX exact = end(1.25e-4, time);
        const double coarse = distance(end(2e-3, time), exact),
                     fine = distance(end(1e-3, time), exact);
        CAPTURE(coarse, fine);
        CHECK(fine <= coarse / 6.0);
        CHECK(fine <= 1e-5);
    }
    Chain stiffer = stiff_chain();
    Schedule schedule = until(1.0);
    schedule.times = {0.5};
    schedule.observe = [&](const Snapshot&) {
        stiffer.model.prototype<Bar<3>>(0) = Bar<3>(2e6, 1.0, 0.4);
    };
    const LeapfrogReport report = run(stiffer.model, {}, schedule);
    CHECK(report.status == Status::converged);
    CHECK(report.smallest_step < 0.2 * report.largest_step);
}

TEST_CASE("Leapfrog: a scene that is touched in every step stays stable", "[dynamics][leapfrog]") {
    const auto run_touched = [](bool touches) {
        Model model;
        const auto beam =
            straight_beam<CrossSectionBeam<3>>(model, Material::isotropic(2e6, 0.3, 1200.0),
                                               rectangle(0.05, 0.05), {0, 0, 0}, {1, 0, 0}, 3);
        model.clamp(beam.first());
        model.set_gravity({0, 0, -9.81});
        Schedule schedule;
        schedule.end = 0.2;
        if (touches)
            schedule.progress = [&](double, double) {
                model.set_gravity({0, 0, -9.81});  // the same
                return true;
            };
        REQUIRE(run(model, {}, schedule).status == Status::converged);
        return model.state().q;
    };
    // it was off by 0.12 m: every new beginning excited the fastest vibrations
    CHECK((run_touched(true) - run_touched(false)).cwiseAbs().maxCoeff() < 1e-3);
}

TEST_CASE("Leapfrog: steps that vanish in the round-off of time are refused",
          "[dynamics][leapfrog]") {
    Chain scene = stiff_chain();
    scene.model.state().time = 1e14;
    const LeapfrogReport report = run(scene.model, {}, until(1e14 + 1.0));
    CHECK(report.status == Status::step_too_small);
    CHECK(report.steps == 0);
    CHECK_THAT(report.message, ContainsSubstring("resolution of time"));
}

TEST_CASE("Leapfrog: it takes the same steps in any units", "[dynamics][leapfrog][scales]") {
    for (const double base : {2.0, 1e9})
        check_scales(base, 0, [](const Scale& s) {
            PlanarModel model = cantilever(s);
            return run(model, {}, until(1e-4 * s.time));
        });
    check_scales(2.0, 0, [](const Scale& s) {
        PlanarModel model = linkage(s);
        return run(model, {}, until(1e-4 * s.time));
    });
    check_scales(2.0, 0, [](const Scale& s) {
        Model model = elbow(s);
        return run(model, {}, until(1e-4 * s.time));
    });
}

}  // namespace leapfrog_test
