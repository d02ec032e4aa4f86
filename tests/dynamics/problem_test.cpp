// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/constants.hpp>
#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/leapfrog.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <dynamics/scenes.hpp>
#include <support/catch.hpp>
#include <support/dense.hpp>
#include <support/random_state.hpp>

#include <cmath>
#include <limits>

namespace problem_test {

using namespace ancf::test;
using ancf::Field;
using ancf::NodeId;
using ancf::Redundancy;
using ancf::Request;
using ancf::Start;
using ancf::State;
using ancf::Status;
using ancf::VectorX;

using ancf::pi;

/// A drag -c v on one node and a follower-like force that depends on its place.
struct Drag {
    NodeId node;
    double coefficient;
    ancf::Coupling coupling() const { return {{node, Field::r}}; }
    void evaluate(const ancf::LoadState& at, ancf::LoadResult& out) const {
        out.force = -coefficient * at.v;
        out.damping = -coefficient * ancf::MatrixX::Identity(3, 3);
    }
};

/// Two bars on a link, their middle node on a path: constraints that are curved and move.
struct Rich {
    Chain scene = chain(3, {0.0, 0.0, 0.0}, {1.5, 0.3, 0.0});
    Rich() {
        auto& model = scene.model;
        model.add(ancf::Distance<3>(scene.first(), Vector3(0.0, 0.4, 0.1), std::sqrt(0.17)));
        model.add(ancf::Distance<3>(
            scene.nodes[1], scene.nodes[3],
            {[](double t) { return 2.0 / 3.0 * std::sqrt(2.34) + 0.1 * std::sin(2.0 * t); },
             [](double t) { return 0.2 * std::cos(2.0 * t); },
             [](double t) { return -0.4 * std::sin(2.0 * t); }}));
        model.prescribe(scene.nodes[2], Field::r, 2, sine(0.2, 1.5).value, sine(0.2, 1.5).rate,
                        sine(0.2, 1.5).acceleration);
        model.set_gravity({0.0, -9.81, 0.0});
        model.add(Drag{scene.nodes[1], 0.3});
    }
};

/// Brings the rates of a scene on its constraints.
void make_consistent(ancf::DynamicProblem& problem, ancf::State& state) {
    VectorX q, v;
    problem.numbering().gather_free(state.q, q);
    problem.numbering().gather_free(state.v, v);
    REQUIRE(problem.project(state.time, q, v));
    problem.store(state.time, q, v, VectorX::Zero(problem.multipliers()));
}

TEST_CASE("problem: a free scene under gravity accelerates with g", "[dynamics]") {
    Chain scene = chain(4, {0.3, -0.2, 0.5}, {1.0, 0.4, 0.9});
    scene.model.set_gravity({1.0, -9.0, 2.0});
    ancf::DynamicProblem problem(scene.model);
    const ancf::Start start = problem.start();
    REQUIRE(start.status == Status::converged);
    for (int node = 0; node < 5; ++node) {
        const Vector3 error = start.acceleration.segment<3>(3 * node) - Vector3(1.0, -9.0, 2.0);
        CHECK(error.norm() <= 1e-11);  // 2.3e-12 measured: the round-off of the bars' length
    }
}

TEST_CASE("problem: energies of no evaluation are refused", "[dynamics][bad-input]") {
    Chain scene = chain(2, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    ancf::DynamicProblem problem(scene.model);
    CHECK_THROWS_AS(problem.energies(), ancf::InvalidArgument);
    (void)problem.start();
    CHECK(problem.energies().kinetic == 0.0);
}

TEST_CASE("problem: an inconsistent start is refused with the constraint and its size",
          "[dynamics]") {
    Chain scene = chain(2, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    auto& model = scene.model;
    model.add(ancf::Pin<3>(scene.last(), Vector3(1.0, 0.0, 0.0)));
    model.add(ancf::Distance<3>(scene.first(), Vector3(0.0, 0.5, 0.0), 0.5));
    const auto start = [&] { return ancf::DynamicProblem(model).start(); };
    CHECK(start().status == Status::converged);

    SECTION("coordinates") {
        model.set_value(scene.first(), Field::r, {0.0, -1e-3, 0.0});
        CHECK(start().status == Status::inconsistent);
        CHECK_THAT(start().message, ContainsSubstring("distance between node 0") &&
                                        ContainsSubstring("|g| = 0.001"));
    }
    SECTION("rates") {
        model.set_rate(scene.last(), Field::r, {0.0, 1e-3, 0.0});
        CHECK(start().status == Status::inconsistent);
        CHECK_THAT(start().message, ContainsSubstring("pin of node 2") &&
                                        ContainsSubstring("|G v + g_t| = 0.001") &&
                                        ContainsSubstring("by set_rate"));
    }
    SECTION("rates along the constraint are welcome") {
        model.set_rate(scene.first(), Field::r, {1.0, 0.0, 0.5});
        CHECK(start().status == Status::converged);
    }
    SECTION("a link whose length changes at once") {
        model.add(ancf::Distance<3>(
            scene.nodes[0], scene.nodes[1],
            ancf::Motion{[](double t) { return 0.5 + t; }, [](double) { return 1.0; },
                         [](double) { return 0.0; }}));
        CHECK(start().status == Status::inconsistent);
        CHECK_THAT(start().message, ContainsSubstring("distance between node 0 and node 1"));
    }
    SECTION("a support that prescribes another place") {
        model.prescribe(
            scene.nodes[1], Field::r, 2, [](double) { return 0.1; }, [](double) { return 0.0; },
            [](double) { return 0.0; });
        CHECK(start().status == Status::inconsistent);
        CHECK_THAT(start().message, ContainsSubstring("component 2, of node 1") &&
                                        ContainsSubstring("prescribes 0.1"));
    }
    SECTION("a held coordinate that moves") {
        model.fix(scene.nodes[1], Field::r, 2);
        model.set_rate(scene.nodes[1], Field::r, {0.0, 0.0, 2.0});
        CHECK(start().status == Status::inconsistent);
        CHECK_THAT(start().message, ContainsSubstring("moves it at 2"));
    }
    SECTION("a state that is no number") {
        model.state().q[4] = std::numeric_limits<double>::quiet_NaN();
        CHECK(start().status == Status::not_finite);
    }
}

TEST_CASE("DynamicProblem: a scene at rest starts where constraints take its load whole",
          "[dynamics]") {
    Chain scene = chain(2, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    const Vector3 load(0.3, -0.7, 0.2);
    scene.model.add(ancf::Pin<3>(scene.first(), Vector3(0.0, 0.0, 0.0)));
    scene.model.add(ancf::Pin<3>(scene.last(), Vector3(1.0, 0.0, 0.0)));
    scene.model.add(ancf::Force<3>(scene.last(), load));
    const ancf::Start start = ancf::DynamicProblem(scene.model).start();
    INFO(start.message);
    REQUIRE(start.status == Status::converged);
    CHECK(start.acceleration.norm() <= 1e-12);  // round-off of 0.8 N on half a kilogram
    CHECK((start.multipliers.tail(3) - load).norm() <= 1e-14);
}

TEST_CASE("problem: redundant constraints are named, or solved with the least multipliers",
          "[dynamics]") {
    Chain scene = chain(2, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    auto& model = scene.model;
    model.set_gravity({0.0, -10.0, 0.0});
    model.add(ancf::Pin<3>(scene.first(), Vector3(0.0, 0.0, 0.0)));
    model.add(ancf::Distance<3>(scene.last(), Vector3(1.0, 2.0, 0.0), 2.0));
    model.add(ancf::FixedCoordinate<3>(scene.first(), Field::r, 1, 0.0));
    model.add(ancf::Distance<3>(scene.last(), Vector3(1.0, 3.0, 0.0), 3.0));

    const ancf::Start refused = ancf::DynamicProblem(model).start();
    CHECK(refused.status == Status::redundant);
    CHECK_THAT(refused.message,
               ContainsSubstring("constraint 2 (fixed r, component 1, of node 0), equation 0") &&
                   ContainsSubstring("constraint 3 (distance between node 2") &&
                   ContainsSubstring("ProblemOptions::redundancy"));

    ancf::ProblemOptions options;
    options.redundancy = Redundancy::minimum_norm;
    ancf::DynamicProblem problem(model, options);
    const ancf::Start start = problem.start();
    REQUIRE(start.status == Status::converged);
    REQUIRE(problem.left_out() == std::vector<int>{4, 5});
    const State state = problem.state(0.0, start.q, start.v, start.multipliers);
    // the pin and the fixed coordinate share the weight at node 0, the two links that at node 2
    CHECK(state.multipliers[1] == Approx(state.multipliers[4]).epsilon(1e-12));
    CHECK(state.multipliers[3] == Approx(state.multipliers[5]).epsilon(1e-12));
    // the middle falls with 15 m/s^2: 2.5 N of weight at an end, less 1.25 N of inertia, shared
    CHECK(state.multipliers[1] == Approx(-0.625).epsilon(1e-12));

    // the same motion as without the repetitions
    Chain lean = chain(2, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    lean.model.set_gravity({0.0, -10.0, 0.0});
    lean.model.add(ancf::Pin<3>(lean.first(), Vector3(0.0, 0.0, 0.0)));
    lean.model.add(ancf::Distance<3>(lean.last(), Vector3(1.0, 2.0, 0.0), 2.0));
    const ancf::Start expected = ancf::DynamicProblem(lean.model).start();
    CHECK(distance(start.acceleration, expected.acceleration) <= 1e-12);
    CHECK(state.multipliers[1] + state.multipliers[4] ==
          Approx(expected.multipliers[1]).epsilon(1e-12));

    // equations left out are 1 on the diagonal and ask their multiplier to vanish
    VectorX lambda = start.multipliers;
    lambda[5] = 0.25;
    REQUIRE_FALSE(problem.evaluate(0.0, start.q, start.v, lambda, Request::tangent));
    CHECK(problem.constraint_residual()[5] == 0.25);
    const int row = problem.size() + 5;
    CHECK(problem.tangent().coeff(row, row) == 1.0);
    CHECK(ancf::MatrixX(problem.tangent()).row(row).cwiseAbs().sum() == 1.0);
}

TEST_CASE(
    "problem: a motion ends where an equation that was left out no longer follows from the rest",
    "[dynamics]") {
    // two links in a line hold the bars; each is tangent to the other there. They fell by 0.45 m
    int checked = 0;
    const auto check = [&](const auto& run) {
        Chain scene = chain(2, {0.0, 0.0, 0.0}, {0.0, -1.0, 0.0});
        scene.model.add(ancf::Distance<3>(scene.first(), Vector3(1.0, 0.0, 0.0), 1.0));
        scene.model.add(ancf::Distance<3>(scene.first(), Vector3(-1.0, 0.0, 0.0), 1.0));
        scene.model.set_gravity({0.0, -9.81, 0.0});
        ancf::ProblemOptions options;
        options.redundancy = Redundancy::minimum_norm;
        ancf::DynamicProblem problem(scene.model, options);
        const ancf::DynamicsReport report = run(problem, until(0.3));
        CAPTURE(report.message);
        CHECK(report.status == Status::inconsistent);
        CHECK_THAT(report.message, ContainsSubstring("constraint 1 (distance"));
        CHECK(report.time < 0.15);
        CHECK(report.violation < 0.01);
        ++checked;
    };
    const auto check_implicit = [&](const auto& integrator) {
        check([&](ancf::DynamicProblem& problem, const ancf::Schedule& schedule) {
            ancf::EigenLu solver;
            return integrator.integrate(problem, solver, schedule);
        });
    };
    check_implicit(ancf::GeneralizedAlpha());
    check_implicit(ancf::EnergyMomentum());
    check_implicit(ancf::RadauIIA());
    check([](ancf::DynamicProblem& problem, const ancf::Schedule& schedule) {
        return ancf::DynamicsReport(ancf::Leapfrog().integrate(problem, schedule));
    });
    CHECK(checked == 4);
}

TEST_CASE("problem: a constraint on held coordinates alone is redundant", "[dynamics]") {
    Chain scene = chain(1, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    scene.model.pin(scene.first());
    scene.model.add(ancf::Pin<3>(scene.first(), Vector3(0.0, 0.0, 0.0)));
    CHECK(ancf::DynamicProblem(scene.model).start().status == Status::redundant);
}

TEST_CASE("problem: projection reaches round-off by the least change in the mass norm",
          "[dynamics]") {
    const auto seed = GENERATE(range(0U, 10U));
    INFO("seed " << seed);
    Random random(seed);
    Rich rich;
    ancf::DynamicProblem problem(rich.scene.model);
    VectorX q, v;
    problem.numbering().gather_free(rich.scene.model.state().q, q);
    const VectorX rest = q;
    v.resize(q.size());
    for (double& value : q) value += random.uniform(-0.02, 0.02);
    for (double& value : v) value = random.uniform(-1.0, 1.0);
    const VectorX off = q;
    const VectorX fast = v;
    REQUIRE(problem.project(0.3, q, v));
    problem.evaluate_constraints(0.3, q, v);
    CHECK(problem.constraints().largest_violation() <= 1e-15);
    CHECK(problem.constraints().largest_rate() <= 2e-15);
    CHECK(distance(q, off) > 1e-4);

    // M (v - fast) is a combination of the rows of G: what moves freely is untouched
    const VectorX impulse = problem.compact_mass() * (v - fast);
    VectorX along(problem.multipliers());
    ancf::MatrixX rows(problem.size(), problem.multipliers());
    for (int k = 0; k < problem.multipliers(); ++k) {
        VectorX column = VectorX::Zero(problem.size());
        problem.constraints().add_transpose_product(VectorX::Unit(problem.multipliers(), k), 1.0,
                                                    column);
        rows.col(k) = column;
    }
    along = ancf::test::solved(rows.transpose() * rows, rows.transpose() * impulse);
    CHECK((impulse - rows * along).norm() <= 1e-12 * impulse.norm());
}

TEST_CASE("problem: accelerations and jerk keep a moving scene on its constraints", "[dynamics]") {
    Rich rich;
    auto& model = rich.scene.model;
    ancf::DynamicProblem problem(model);
    Random random(4);
    for (double& value : model.state().v) value = random.uniform(-1.0, 1.0);
    make_consistent(problem, model.state());
    const ancf::Start start = problem.start();
    REQUIRE(start.status == Status::converged);

    // along q + s v + s^2 a/2 + s^3 j/6 the constraints hold to fourth order
    VectorX jerk;
    REQUIRE(problem.jerk(start, 1e-4, jerk) == Status::converged);
    const auto violation = [&](double s) {
        const VectorX q =
            start.q + s * start.v + 0.5 * s * s * start.acceleration + s * s * s / 6.0 * jerk;
        problem.evaluate_constraints(s, q, start.v);
        return problem.constraints().largest_violation();
    };
    CHECK(violation(1e-2) <= 2e-6);  // 1.3e-6 measured: s^4/24 times the fourth derivative
    CHECK(violation(1e-2) / violation(5e-3) == Approx(16.0).epsilon(0.2));

    // and the jerk is the change of the accelerations
    const double s = 1e-4;
    VectorX after, before, lambda;
    for (const double sign : {1.0, -1.0}) {
        const double h = sign * s;
        const VectorX q = start.q + h * start.v + 0.5 * h * h * start.acceleration;
        const VectorX v = start.v + h * start.acceleration + 0.5 * h * h * jerk;
        REQUIRE(problem.accelerations(h, q, v, sign > 0.0 ? after : before, lambda) ==
                Status::converged);
    }
    CHECK(distance((after - before) / (2.0 * s), jerk) <= 1e-5 * jerk.cwiseAbs().maxCoeff());
}

TEST_CASE("problem: force and constraints have the tangent and damping as derivatives",
          "[dynamics]") {
    Rich rich;
    auto& model = rich.scene.model;
    ancf::DynamicProblem problem(model);
    Random random(9);
    const int n = problem.size();
    const int m = problem.multipliers();
    VectorX q, v(n), lambda(m);
    problem.numbering().gather_free(model.state().q, q);
    for (double& value : q) value += random.uniform(-0.1, 0.1);
    for (double& value : v) value = random.uniform(-1.0, 1.0);
    for (double& value : lambda) value = random.uniform(-10.0, 10.0);
    REQUIRE_FALSE(problem.evaluate(0.2, q, v, lambda, Request::tangent_and_damping));
    const ancf::MatrixX tangent = problem.tangent();
    const ancf::MatrixX damping = problem.damping();
    const auto residual = [&](const VectorX& at_q, const VectorX& at_v, const VectorX& at_lambda) {
        REQUIRE_FALSE(problem.evaluate(0.2, at_q, at_v, at_lambda, Request::force));
        VectorX r(n + m);
        r << problem.force(), problem.constraint_residual();
        return r;
    };
    const double h = 1e-5;
    for (int j = 0; j < n + m; ++j) {
        VectorX step = VectorX::Zero(n), change = VectorX::Zero(m);
        (j < n ? step[j] : change[j - n]) = h;
        const VectorX slope =
            (residual(q + step, v, lambda + change) - residual(q - step, v, lambda - change)) /
            (2.0 * h);
        CHECK(distance(slope, tangent.col(j)) <= 1e-5);  // differences; entries up to 2e3
        if (j >= n) continue;
        const VectorX rate =
            (residual(q, v + step, lambda) - residual(q, v - step, lambda)) / (2.0 * h);
        CHECK(distance(rate, damping.col(j)) <= 1e-7);
    }
    CHECK(damping.norm() > 0.1);
}

TEST_CASE("problem: velocity-level terms are derivatives of G^T mu and of G v", "[dynamics]") {
    Rich rich;
    auto& model = rich.scene.model;
    ancf::DynamicProblem problem(model);
    Random random(2);
    const int n = problem.size();
    const int m = problem.multipliers();
    VectorX q, v(n), mu(m);
    problem.numbering().gather_free(model.state().q, q);
    for (double& value : v) value = random.uniform(-1.0, 1.0);
    for (double& value : mu) value = random.uniform(-1.0, 1.0);
    ancf::SparseMatrix out;
    problem.evaluate_constraints(0.2, q, v);
    problem.velocity_level(mu, out);
    const ancf::MatrixX dense = out;
    const double h = 1e-6;
    for (int j = 0; j < n; ++j) {
        VectorX force[2], rate[2];
        for (const int side : {0, 1}) {
            problem.evaluate_constraints(0.2, q + (side == 0 ? h : -h) * VectorX::Unit(n, j), v);
            force[side] = VectorX::Zero(n);
            problem.constraints().add_transpose_product(mu, 1.0, force[side]);
            rate[side] = problem.constraints().rate();
        }
        CHECK(distance((force[0] - force[1]) / (2.0 * h), dense.col(j).head(n)) <= 1e-8);
        CHECK(distance((rate[0] - rate[1]) / (2.0 * h), dense.col(j).tail(m)) <= 1e-8);
    }
    CHECK(dense.topRows(n).norm() > 0.1);
    CHECK(dense.bottomRows(m).norm() > 0.1);
}

TEST_CASE("problem: energies change by the powers of loads, drives and constraints", "[dynamics]") {
    Rich rich;
    auto& model = rich.scene.model;
    ancf::DynamicProblem problem(model);
    Random random(5);
    for (double& value : model.state().v) value = random.uniform(-1.0, 1.0);
    make_consistent(problem, model.state());
    const ancf::Start start = problem.start();
    REQUIRE(start.status == Status::converged);
    const double h = 1e-4;
    const auto stored = [&](double s) {
        const ancf::Energies at =
            problem.energies(s, start.q + s * start.v + 0.5 * s * s * start.acceleration,
                             start.v + s * start.acceleration, start.multipliers);
        return at.kinetic + at.strain;
    };
    const ancf::Energies now = problem.energies(0.0, start.q, start.v, start.multipliers);
    const double change = (stored(h) - stored(-h)) / (2.0 * h);
    // each far above what the last line but one can miss
    CHECK(std::abs(now.constraint_power) > 0.01);  // 0.018 measured
    CHECK(std::abs(now.load_power) > 0.1);
    CHECK(change == Approx(now.load_power + now.constraint_power).epsilon(1e-6));
    CHECK(now.total() == now.kinetic + now.strain + now.potential);
}

TEST_CASE("problem: a driven support acts as the same motion held by a multiplier", "[dynamics]") {
    const auto build = [](bool support) {
        Chain scene = chain(3, {0.0, 0.0, 0.0}, {1.2, 0.0, 0.0});
        const ancf::Motion lift = sine(0.3, 2.0);
        auto& model = scene.model;
        if (support)
            model.prescribe(scene.first(), Field::r, 1, lift.value, lift.rate, lift.acceleration);
        else
            model.add(ancf::FixedCoordinate<3>(scene.first(), Field::r, 1, lift));
        model.set_rate(scene.first(), Field::r, {0.0, lift.rate(0.0), 0.0});
        return scene;
    };
    Chain held = build(true), bound = build(false);
    ancf::DynamicProblem reduced(held.model), whole(bound.model);
    const ancf::Start a = reduced.start();
    const ancf::Start b = whole.start();
    REQUIRE(a.status == Status::converged);
    REQUIRE(b.status == Status::converged);
    VectorX expected;  // without the driven coordinate
    expected.resize(b.acceleration.size() - 1);
    expected << b.acceleration[0], b.acceleration.tail(b.acceleration.size() - 2);
    CHECK(distance(a.acceleration, expected) <= 1e-12);
    // the power of the support's reaction is that of the multiplier
    CHECK(reduced.energies(0.0, a.q, a.v, a.multipliers).constraint_power ==
          Approx(whole.energies(0.0, b.q, b.v, b.multipliers).constraint_power).margin(1e-12));

    // and so is its force, later in the motion
    const State later = reduced.raw_state(0.3, a.q, a.v);
    VectorX forces, acceleration, lambda;
    REQUIRE(reduced.reactions(later, forces) == Status::converged);
    REQUIRE(whole.accelerations(0.3, later.q, later.v, acceleration, lambda) == Status::converged);
    CHECK(std::abs(lambda[0]) > 0.01);
    CHECK(forces[held.model.coordinate(held.first(), Field::r) + 1] ==
          Approx(-lambda[0]).epsilon(1e-11));
    CHECK((forces.array() != 0.0).count() == 1);
    CHECK_THROWS_AS(reduced.reactions({}, forces), ancf::InvalidArgument);

    held.model.prescribe(held.last(), Field::r, 0, [](double) { return 1.2; });
    CHECK_THROWS_WITH(ancf::DynamicProblem(held.model),
                      ContainsSubstring("needs its rate and acceleration"));
}

TEST_CASE("problem: reactions are those of the state, wherever its supports stand", "[dynamics]") {
    Chain scene = chain(2, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    scene.model.pin(scene.first());
    scene.model.pin(scene.last());
    ancf::DynamicProblem problem(scene.model);
    const double stretch = 1.2;
    scene.model.set_value(scene.nodes[1], Field::r, {0.5 * stretch, 0.0, 0.0});
    scene.model.set_value(scene.last(), Field::r, {stretch, 0.0, 0.0});
    VectorX forces;
    REQUIRE(problem.reactions(scene.model.state(), forces) == Status::converged);
    const double pull = 500.0 * 0.5 * (stretch * stretch - 1.0) * stretch;  // of Green's strain
    CHECK(forces[scene.model.coordinate(scene.first(), Field::r)] == Approx(-pull).epsilon(1e-14));
    CHECK(forces[scene.model.coordinate(scene.last(), Field::r)] == Approx(pull).epsilon(1e-14));

    // a run that an observer asks for them goes on where its supports were
    VectorX q, lambda, fresh, after;
    problem.numbering().gather_free(scene.model.state().q, q);
    const VectorX v = VectorX::Zero(q.size());
    REQUIRE(ancf::DynamicProblem(scene.model).accelerations(0.0, q, v, fresh, lambda) ==
            Status::converged);
    REQUIRE(fresh.norm() <= 1e-9);
    REQUIRE(problem.accelerations(0.0, q, v, after, lambda) == Status::converged);
    CHECK(after.norm() > 1.0);
}

TEST_CASE("problem: frequencies of a bar row are those of its closed form", "[dynamics]") {
    const int bars = 8;
    const double stiffness = 500.0, line_density = 2.0, length = 0.25;
    Chain scene = chain(bars, {0.0, 0.0, 0.0}, {bars * length, 0.0, 0.0}, stiffness, line_density);
    const bool clamped = GENERATE(true, false);
    for (const NodeId node : scene.nodes) {
        scene.model.fix(node, Field::r, 1);
        scene.model.fix(node, Field::r, 2);
    }
    if (clamped) scene.model.fix(scene.first(), Field::r, 0);
    ancf::DynamicProblem problem(scene.model);
    VectorX q;
    problem.numbering().gather_free(scene.model.state().q, q);
    // consistent mass: w^2 = 6 EA/(m l^2) (1 - cos b)/(2 + cos b)
    const auto frequency = [&](double b) {
        return std::sqrt(6.0 * stiffness / (line_density * length * length) * (1.0 - std::cos(b)) /
                         (2.0 + std::cos(b)));
    };
    const double lowest = clamped ? frequency(0.5 * pi / bars) : frequency(pi / bars);
    const double highest = clamped ? frequency((bars - 0.5) * pi / bars) : frequency(pi);
    CHECK(problem.lowest_frequency(0.0, q) == Approx(lowest).epsilon(1e-4));
    CHECK(problem.highest_frequency(0.0, q) == Approx(highest).epsilon(0.03));
}

TEST_CASE("problem: round-off moves nothing", "[dynamics]") {
    Chain scene = chain(4, {0.1, 0.2, 0.3}, {1.3, 0.7, -0.4});
    scene.model.pin(scene.first());
    ancf::DynamicProblem at_rest(scene.model);
    Start start = at_rest.start();
    REQUIRE(start.status == Status::converged);
    CHECK(at_rest.motion_frequency(start) == 0.0);
    CHECK(at_rest.force_scale(start) == 0.0);

    scene.model.set_gravity({0.0, -9.81, 0.0});
    ancf::DynamicProblem falling(scene.model);
    start = falling.start();
    const double length = falling.length_scale();
    CHECK(falling.motion_frequency(start) >= std::sqrt(9.81 / length));
    CHECK(falling.force_scale(start) > 1.0);

    scene.model.set_gravity({0.0, 0.0, 0.0});
    scene.model.set_rate(scene.last(), Field::r, {0.0, 0.0, 2.0});
    ancf::DynamicProblem thrown(scene.model);
    CHECK(thrown.motion_frequency(thrown.start()) == Approx(2.0 / length));
}

TEST_CASE("problem: a link between points that coincide is refused by name", "[dynamics]") {
    Chain scene = chain(2, {0.0, 0.0, 0.0}, {2.0, 0.0, 0.0});
    const ancf::Motion growing{[](double t) { return t; }, [](double) { return 1.0; },
                               [](double) { return 0.0; }};
    scene.model.add(ancf::Distance<3>(scene.first(), Vector3(0.0, 0.0, 0.0), growing));
    ancf::DynamicProblem problem(scene.model);
    const Start start = problem.start();
    CHECK(start.status == Status::inconsistent);
    CHECK_THAT(start.message, ContainsSubstring("coincide"));
}

TEST_CASE("problem: a load that is no number at the start is named", "[dynamics]") {
    Chain scene = falling();
    scene.model.add(ancf::Force<3>(scene.last(), {0.0, 1.0, 0.0}),
                    [](double) { return std::numeric_limits<double>::quiet_NaN(); });
    ancf::DynamicProblem problem(scene.model);
    const Start start = problem.start();
    CHECK(start.status == Status::not_finite);
    CHECK_THAT(start.message, ContainsSubstring("the force of load 0 is not finite"));
}

/// A force whose stiffness is no number from a time on.
struct Unknown {
    NodeId node;
    double from;

    [[nodiscard]] ancf::Coupling coupling() const { return {{node, Field::r}}; }
    void evaluate(const ancf::LoadState& at, ancf::LoadResult& out) const {
        if (at.time >= from) out.stiffness(0, 0) = std::numeric_limits<double>::quiet_NaN();
    }
};

TEST_CASE("Leapfrog: a stiffness that is no number ends a run", "[dynamics][leapfrog]") {
    Chain scene = falling();
    scene.model.add(Unknown{scene.last(), GENERATE(0.0, 0.5)});
    ancf::DynamicProblem problem(scene.model);
    const auto report = ancf::Leapfrog().integrate(problem, until(1.0));
    CHECK(report.status == Status::not_finite);
    CHECK_THAT(report.message, ContainsSubstring("stiffness and mass is no number"));
}

/// Gives results of another size, and says so of none.
struct Resizing {
    NodeId node;
    bool jacobian;

    [[nodiscard]] ancf::Coupling coupling() const { return {{node, Field::r}}; }
    [[nodiscard]] int equations() const { return 1; }
    [[nodiscard]] std::string name() const { return "resizing"; }
    void evaluate(const ancf::ConstraintState&, ancf::ConstraintResult& out) const {
        if (jacobian)
            out.jacobian.setZero(2, 1);
        else
            out.violation.setZero(2);
    }
};

TEST_CASE("problem: a constraint that changes the size of its results is refused", "[dynamics]") {
    Chain scene = falling();
    scene.model.add(Resizing{scene.last(), GENERATE(false, true)});
    ancf::DynamicProblem problem(scene.model);
    CHECK_THROWS_WITH(problem.start(),
                      ContainsSubstring("constraint resizing of 1 equations on 3 coordinates"));
}

TEST_CASE("problem: a mechanism without stiffness has no frequency", "[dynamics]") {
    Chain scene = chain(1, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    scene.model.add(ancf::Distance<3>(scene.first(), scene.last(), 1.0));
    ancf::DynamicProblem problem(scene.model);
    VectorX q;
    problem.numbering().gather_free(scene.model.state().q, q);
    CHECK(problem.highest_frequency(0.0, q) > 0.0);
    CHECK(problem.lowest_frequency(0.0, q) == 0.0);
}

TEST_CASE("problem: options that cannot be meant are refused", "[dynamics]") {
    Chain scene = chain(1, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    ancf::ProblemOptions options;
    options.consistency = 0.0;
    CHECK_THROWS_AS(ancf::DynamicProblem(scene.model, options), ancf::InvalidArgument);
    options = {};
    options.redundancy_tolerance = -1.0;
    CHECK_THROWS_AS(ancf::DynamicProblem(scene.model, options), ancf::InvalidArgument);
    options = {};
    options.storage = ancf::Storage::lower;
    scene.model.add(ancf::Distance<3>(scene.first(), scene.last(), 1.0));
    CHECK_THROWS_AS(ancf::DynamicProblem(scene.model, options), ancf::InvalidArgument);
}

TEST_CASE("problem: vectors of another size are refused", "[dynamics]") {
    Chain scene = chain(1, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 1.0, 1.0);
    scene.model.add(ancf::FixedCoordinate<3>(scene.last(), Field::r, 1, 0.0));
    ancf::DynamicProblem problem(scene.model);
    const ancf::VectorX x = ancf::VectorX::Zero(problem.size());
    const ancf::VectorX lambda = ancf::VectorX::Zero(problem.multipliers() + 1);
    ancf::VectorX solved;
    ancf::SparseMatrix matrix;
    CHECK_THROWS_WITH(problem.solve_mass(x.head(1), solved), ContainsSubstring("solve_mass"));
    const auto says = ContainsSubstring("expected 1 multipliers, got 2");
    CHECK_THROWS_WITH(problem.store(0.0, x, x, lambda), says);
    CHECK_THROWS_WITH(problem.velocity_level(lambda, matrix), says);
    CHECK_THROWS_WITH(problem.project_accelerations(0.0, x, x, solved),
                      ContainsSubstring("accelerations, got 0"));
}

TEST_CASE("problem: a scene with a node of no mass is refused", "[dynamics]") {
    Chain scene = chain(1, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 1.0, 0.0);
    CHECK_THROWS_WITH(ancf::DynamicProblem(scene.model),
                      ContainsSubstring("not positive definite"));
}

TEST_CASE("schedules: times ascend between start and end", "[dynamics]") {
    const ancf::Schedule schedule = ancf::equal_intervals(1.0, 0.25, 0.1);
    REQUIRE(schedule.times.size() == 4);
    CHECK(schedule.times[2] == Approx(1.2));
    CHECK(schedule.times[3] == 1.25);
    CHECK(ancf::equal_intervals(0.0, 1.2, 0.05).times.size() == 25);
    CHECK(ancf::equal_intervals(0.0, 0.0, 0.05).times.size() == 1);
    CHECK_THROWS_AS(ancf::equal_intervals(0.0, -1.0, 0.1), ancf::InvalidArgument);
    CHECK_THROWS_AS(ancf::equal_intervals(0.0, 1.0, 0.0), ancf::InvalidArgument);
    ancf::Schedule wrong;
    wrong.end = -1.0;
    CHECK_THROWS_AS(wrong.check(0.0), ancf::InvalidArgument);
    wrong.end = 1.0;
    wrong.times = {0.5, 0.2};
    CHECK_THROWS_AS(wrong.check(0.0), ancf::InvalidArgument);
    wrong.times = {0.5, 1.2};
    CHECK_THROWS_AS(wrong.check(0.0), ancf::InvalidArgument);
}

TEST_CASE("schedules: one before the time that statics left says where that time stands",
          "[dynamics]") {
    const auto told = ContainsSubstring("State::time; statics leaves its load factor there");
    CHECK_THROWS_WITH(ancf::equal_intervals(0.0, 0.5, 0.1).check(1.0), told);
    CHECK_THROWS_WITH(ancf::equal_intervals(0.0, 2.0, 0.1).check(1.0), told);
}

}  // namespace problem_test
