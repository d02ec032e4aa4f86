// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/constants.hpp>
#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/momentum.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/output/state_file.hpp>
#include <ancf/solver/eigen_solver.hpp>

#include <dynamics/scenes.hpp>
#include <support/bar.hpp>
#include <support/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace energy_momentum_test {

using namespace ancf::test;
using ancf::DynamicsReport;
using ancf::EnergyMomentum;
using ancf::EnergyMomentumOptions;
using ancf::Field;
using ancf::NodeId;
using ancf::Schedule;
using ancf::Snapshot;
using ancf::Status;
using ancf::VectorX;

EnergyMomentumOptions steps(double step) {
    EnergyMomentumOptions options;
    options.step = step;
    return options;
}

DynamicsReport run(ancf::Model& model, double step, const Schedule& schedule,
                   const ancf::Memory& memory = {}) {
    ancf::DynamicProblem problem(model);
    ancf::EigenLu solver;
    return EnergyMomentum(steps(step)).integrate(problem, solver, schedule, memory);
}

/// A hardening spring to a point: its potential is of fourth order.
struct Spring {
    NodeId node;
    Vector3 place;
    double stiffness;
    ancf::Coupling coupling() const { return {{node, Field::r}}; }
    void evaluate(const ancf::LoadState& at, ancf::LoadResult& out) const {
        const Vector3 d = at.q - place;
        out.potential = 0.25 * stiffness * d.squaredNorm() * d.squaredNorm();
        out.force = -stiffness * d.squaredNorm() * d;
        out.stiffness = -stiffness * (d.squaredNorm() * ancf::Matrix<double, 3>::Identity() +
                                      2.0 * d * d.transpose());
    }
};

/// A floor that pushes a node up along Y where it is below zero.
struct Floor {
    NodeId node;
    double stiffness;  // N/m
    static constexpr bool symmetric_stiffness = true;
    ancf::Coupling coupling() const { return {{node, Field::r}}; }
    void evaluate(const ancf::LoadState& at, ancf::LoadResult& out) const {
        const double depth = std::min(at.q[1], 0.0);
        out.potential = 0.5 * stiffness * depth * depth;
        out.force[1] = -stiffness * depth;
        if (depth < 0.0) out.stiffness(1, 1) = -stiffness;
    }
};

/// Pushes two nodes apart where they are nearer than a length.
struct Stop {
    NodeId a, b;
    double stiffness, length;  // N/m, m
    static constexpr bool symmetric_stiffness = true;
    ancf::Coupling coupling() const { return {{a, Field::r}, {b, Field::r}}; }
    void evaluate(const ancf::LoadState& at, ancf::LoadResult& out) const {
        const Vector3 d = at.q.head<3>() - at.q.tail<3>();
        const double r = d.norm(), pressed = std::min(r - length, 0.0);
        out.potential = 0.5 * stiffness * pressed * pressed;
        if (pressed == 0.0) return;
        const Vector3 n = d / r;
        out.force << -stiffness * pressed * n, stiffness * pressed * n;
        const ancf::Matrix<double, 3> across =
            ancf::Matrix<double, 3>::Identity() - n * n.transpose();
        const ancf::Matrix<double, 3> k = -stiffness * (n * n.transpose() + pressed / r * across);
        out.stiffness << k, -k, -k, k;
    }
};

/// A spring to the origin, with a damper beside it: the potential is that of the spring.
struct DampedSpring {
    NodeId node;
    double stiffness, damping;  // N/m, N s/m
    static constexpr bool symmetric_stiffness = true;
    ancf::Coupling coupling() const { return {{node, Field::r}}; }
    void evaluate(const ancf::LoadState& at, ancf::LoadResult& out) const {
        out.force = -stiffness * at.q - damping * at.v;
        out.stiffness = -stiffness * ancf::Matrix<double, 3>::Identity();
        out.damping = -damping * ancf::Matrix<double, 3>::Identity();
        out.potential = 0.5 * stiffness * at.q.squaredNorm();
    }
};

/// A bar that weighs less than its mass, as in water.
struct Buoyant : Bar<3> {
    double share;
    Buoyant(const Bar<3>& bar, double share_) : Bar<3>(bar), share(share_) {}
    [[nodiscard]] Coordinates gravity(const Vector3& g) const { return share * Bar<3>::gravity(g); }
};

/// A force that counts how often its derivatives are asked for.
struct Counted {
    NodeId node;
    long* asked;
    ancf::Coupling coupling() const { return {{node, Field::r}}; }
    void evaluate(const ancf::LoadState& at, ancf::LoadResult& out) const {
        *asked += at.derivatives ? 1 : 0;
        out.potential = at.q[0];
        out.force[0] = -1.0;
    }
};

/// A link that counts how often more than its terms is asked for.
struct CountedLink {
    ancf::Distance<3> held;
    long* asked;
    ancf::Coupling coupling() const { return held.coupling(); }
    int equations() const { return held.equations(); }
    std::string name() const { return held.name(); }
    void terms(const VectorX& q, double time, ancf::ConstraintTerms<double>& out) const {
        held.terms(q, time, out);
    }
    void evaluate(const ancf::ConstraintState& at, ancf::ConstraintResult& out) const {
        ++*asked;
        held.evaluate(at, out);
    }
};

/// Largest relative change of both momenta over a run of a free scene.
double momentum_drift(ancf::Model& model, double step, double end, DynamicsReport& report) {
    ancf::DynamicProblem problem(model);
    const ancf::Momentum start = momentum(problem, model.state());
    double largest = 0.0;
    Schedule schedule = ancf::equal_intervals(0.0, end, 10.0 * step);
    schedule.observe = [&](const Snapshot& at) {
        const ancf::Momentum now = momentum(problem, at.state);
        largest = std::max({largest, (now.linear - start.linear).norm() / start.linear.norm(),
                            (now.angular - start.angular).norm() / start.angular.norm()});
    };
    ancf::EigenLu solver;
    report = EnergyMomentum(steps(step)).integrate(problem, solver, schedule);
    return largest;
}

TEST_CASE("energy-momentum: a thin quintic column swings without shorter steps", "[dynamics]") {
    constexpr double side = 0.0035, length = 1.0;
    const auto material = ancf::Material::isotropic(1e8, 0.3, 1000.0);
    ancf::Model model;
    const auto column = ancf::straight_beam<ancf::QuinticBeam<>>(
        model, material, ancf::rectangle(1.5 * side, side), {0, 0, 0}, {length, 0, 0}, 6);
    model.pin(column.first());
    model.fix(column.last(), Field::r, 1);
    model.fix(column.last(), Field::r, 2);
    model.fix(column.first(), Field::r_y, 2);
    const double bending = material.young * 1.5 * std::pow(side, 4) / 12.0;
    const double euler = std::pow(ancf::pi / length, 2) * bending;
    model.add(ancf::Force<3>(column.last(), {-0.3 * euler, 0.0, 0.0}));
    const double frequency = std::pow(ancf::pi / length, 2) *
                             std::sqrt(bending / (material.density * 1.5 * side * side));
    for (const NodeId node : column.nodes) {  // half a wave of 0.001 m
        const double x = ancf::pi * model.position(node)[0] / length;
        const double speed = 0.001 * frequency;
        model.set_rate(node, Field::r, {0.0, speed * std::sin(x), 0.0});
        model.set_rate(node, Field::r_x, {0.0, speed * ancf::pi / length * std::cos(x), 0.0});
        model.set_rate(node, Field::r_y, {-speed * ancf::pi / length * std::cos(x), 0.0, 0.0});
    }
    Schedule schedule;
    schedule.end = 0.5 * ancf::pi / frequency;
    const auto report = run(model, schedule.end / 100.0, schedule);
    REQUIRE(report.status == Status::converged);
    CHECK(report.convergence_failures == 0);  // 161 where 1e-11 was the bound
    CHECK(report.energy_drift < 1e-10 * report.kinetic_largest);
}

TEST_CASE("energy-momentum: a spinning free chain keeps energy and momenta", "[dynamics]") {
    const double step = GENERATE(1e-3, 1e-2);
    Chain scene = chain(4, {0.2, 0.1, 0.0}, {1.2, 0.4, 0.3});
    scene.model.set_rigid_rates({0.3, -0.2, 0.1}, {0.5, 3.0, 4.0});
    scene.model.set_rate(scene.nodes[2], Field::r, {0.5, 1.0, -1.0});
    DynamicsReport report;
    const double drift = momentum_drift(scene.model, step, 2.0, report);
    REQUIRE(report.status == Status::converged);
    CHECK(drift <= 1e-12);
    CHECK(report.energy_drift <= 1e-11 * report.kinetic_largest);
}

TEST_CASE("energy-momentum: links inside a free chain move no momentum either", "[dynamics]") {
    Chain scene = chain(4, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 200.0);
    scene.model.add(ancf::Distance<3>(scene.nodes[0], scene.nodes[2], 0.5));
    scene.model.add(ancf::Distance<3>(scene.nodes[1], scene.nodes[4], 0.75));
    scene.model.set_rigid_rates({0.3, -0.2, 0.1}, {0.0, 1.0, 5.0});
    DynamicsReport report;
    const double drift = momentum_drift(scene.model, 5e-3, 2.0, report);
    REQUIRE(report.status == Status::converged);
    CHECK(drift <= 1e-12);
    CHECK(report.energy_drift <= 1e-10 * report.kinetic_largest);
    CHECK(report.violation <= 1e-13);
}

TEST_CASE("energy-momentum: energy on a link and on a spring of fourth order", "[dynamics]") {
    Chain scene = swing();
    scene.model.add(Spring{scene.last(), {1.0, 0.5, 0.2}, 20.0});
    const DynamicsReport report = run(scene.model, 4e-3, until(10.0));
    REQUIRE(report.status == Status::converged);
    CHECK(report.energy_drift <= 1e-10 * report.kinetic_largest);
    CHECK(report.violation <= 1e-13);
    CHECK(report.violation_rate <= 0.5);  // held at positions alone
}

TEST_CASE("energy-momentum: energy over the steps in which a mass meets and leaves a floor",
          "[dynamics]") {
    ancf::Model model;
    const NodeId ball = model.add_node({0.0, 0.1, 0.0});
    model.add_mass(ball, 1.0);
    model.set_gravity({0.0, -9.81, 0.0});
    model.add(Floor{ball, 1e4});
    const auto report = run(model, 1e-3, ancf::equal_intervals(0.0, 2.0, 2.0));
    REQUIRE(report.status == Status::converged);
    // round-off of 2000 steps: 2e-13 J of 0.99 J; 1.2e-3 J where the middle of a step decides
    CHECK(report.energy_drift < 2e-12);
    CHECK(model.position(ball)[1] > -0.05);  // thrown back: without the floor it falls 19.6 m
}

TEST_CASE("energy-momentum: a stop between free masses keeps energy and momenta", "[dynamics]") {
    ancf::Model model;
    const NodeId a = model.add_node({-0.5, 0.02, 0.0}), b = model.add_node({0.5, -0.02, 0.01});
    model.add_mass(a, 1.0);
    model.add_mass(b, 2.5);
    model.set_rate(a, Field::r, {2.0, 0.1, 0.0});
    model.set_rate(b, Field::r, {-1.0, 0.3, 0.2});
    model.add(Stop{a, b, 1e4, 0.2});  // they meet at 0.27 s
    DynamicsReport report;
    // measured 3.4e-14; 2e-3 where the load counts as one that changes under rigid motions
    CHECK(momentum_drift(model, 1e-3, 0.6, report) < 1e-12);
    REQUIRE(report.status == Status::converged);
    CHECK(model.velocity(a)[0] < -1.0);  // they have met
    CHECK(report.energy_drift < 5e-12);  // measured 5e-13 J of 3.4 J
}

TEST_CASE("energy-momentum: loads give derivatives where a matrix is built alone", "[dynamics]") {
    Chain scene = swing();
    long asked = 0;
    scene.model.add(Counted{scene.last(), &asked});
    const DynamicsReport report = run(scene.model, 1e-3, until(0.02));
    REQUIRE(report.status == Status::converged);
    CHECK(report.iterations > report.jacobians);
    // one more for the highest frequency, one for the report's memory; 268 if always
    CHECK(asked == report.jacobians + 2);
}

TEST_CASE("energy-momentum: second order", "[dynamics]") {
    VectorX exact;
    double before = 0.0;
    int orders = 0;
    for (const double step : {1e-4, 4e-3, 2e-3, 1e-3}) {
        Chain scene = swing();
        REQUIRE(run(scene.model, step, until(0.5)).status == Status::converged);
        const VectorX& q = scene.model.state().q;
        if (exact.size() == 0) {
            exact = q;
            continue;
        }
        const double error = distance(q, exact);
        if (before > 0.0) {
            CHECK(std::log2(before / error) == Approx(2.0).margin(0.2));
            ++orders;
        }
        before = error;
    }
    CHECK(orders == 2);
}

TEST_CASE("energy-momentum: free fall is exact", "[dynamics]") {
    Chain scene = chain(3, {0.0, 0.0, 0.0}, {0.6, 0.5, 0.7});
    const Vector3 gravity(1.0, -9.0, 2.0);
    scene.model.set_gravity(gravity);
    REQUIRE(run(scene.model, 1e-3, until(0.3)).status == Status::converged);
    const ancf::State& state = scene.model.state();
    for (int node = 0; node < 4; ++node)
        CHECK((state.v.segment<3>(3 * node) / state.time - gravity).norm() <= 1e-10);
}

TEST_CASE("energy-momentum: a load with a potential keeps what its rates take", "[dynamics]") {
    const double stiffness = 100.0, damping = 1.0, mass = 1.0, end = 1.0;
    ancf::Model model;
    const NodeId node = model.add_node({1, 0, 0});
    model.add_mass(node, mass);
    model.add(DampedSpring{node, stiffness, damping});
    REQUIRE(run(model, 1e-3, ancf::equal_intervals(0.0, end, end)).status == Status::converged);
    const double decay = 0.5 * damping / mass,
                 frequency = std::sqrt(stiffness / mass - decay * decay);
    const double expected =
        std::exp(-decay * end) *
        (std::cos(frequency * end) + decay / frequency * std::sin(frequency * end));
    // second order: 3.1e-5; without the damper -0.31
    CHECK(std::abs(model.position(node)[0] - expected) < 1e-4);
}

TEST_CASE("energy-momentum: gravity is what an element gives", "[dynamics]") {
    const double share = 0.25, end = 1.0;
    ancf::Model model;
    const NodeId a = model.add_node({0, 0, 0}), b = model.add_node({1, 0, 0});
    model.connect<Buoyant>(model.add_prototype(Buoyant(Bar<3>(10.0, 1.0, 1.0), share)), a, b);
    model.set_gravity({0, 0, -9.81});
    const auto report = run(model, 0.1, ancf::equal_intervals(0.0, end, end));
    REQUIRE(report.status == Status::converged);
    // free fall is exact: round-off of 1e-15; by its mass it would fall by 4.905 m
    CHECK(std::abs(model.position(b)[2] + 0.5 * share * 9.81 * end * end) < 1e-12);
    CHECK(report.energy_drift < 1e-11);
}

TEST_CASE("energy-momentum: a driven end does the work that the energy gains", "[dynamics]") {
    Chain scene = chain(3, {0.0, 0.0, 0.0}, {1.2, 0.0, 0.0});
    auto& model = scene.model;
    const ancf::Motion lift = sine(0.3, 4.0);
    model.prescribe(scene.first(), Field::r, 1, lift.value, lift.rate, lift.acceleration);
    model.set_rate(scene.first(), Field::r, {0.0, lift.rate(0.0), 0.0});
    double work = 0.0, last = 0.0, before = 0.0, first = 0.0, final = 0.0;
    Schedule schedule = ancf::equal_intervals(0.0, 0.3, 1e-3);
    schedule.observe = [&](const Snapshot& at) {
        if (at.state.time > 0.0)
            work += 0.5 * (last + at.energies.constraint_power) * (at.state.time - before);
        else
            first = at.energies.total();
        last = at.energies.constraint_power;
        before = at.state.time;
        final = at.energies.total();
    };
    REQUIRE(run(model, 1e-3, schedule).status == Status::converged);
    CHECK(std::abs(work) > 0.05);
    CHECK(final - first == Approx(work).epsilon(1e-4));  // 1e-5 measured: trapezoidal rule
}

TEST_CASE("energy-momentum: a restarted run continues bit for bit", "[dynamics]") {
    Chain whole = swing(), parts = swing();
    const DynamicsReport first = run(parts.model, 2e-3, until(0.3));
    std::stringstream file;
    ancf::write_state(file, {parts.model.state(), first.memory});
    const ancf::SavedState saved = ancf::read_state(file);
    Chain resumed = swing();
    resumed.model.state() = saved.state;
    REQUIRE(run(resumed.model, 2e-3, until(0.6), saved.memory).status == Status::converged);
    REQUIRE(run(whole.model, 2e-3, until(0.6)).status == Status::converged);
    CHECK(resumed.model.state().time == whole.model.state().time);
    CHECK(resumed.model.state().q == whole.model.state().q);
    CHECK(resumed.model.state().v == whole.model.state().v);
    CHECK(resumed.model.state().multipliers == whole.model.state().multipliers);

    ancf::Memory other = first.memory;
    other.integrator = "generalized_alpha";
    CHECK_THROWS_AS(run(resumed.model, 2e-3, until(1.0), other), ancf::InvalidArgument);
}

TEST_CASE("energy-momentum: a symmetric solver finds the same motion", "[dynamics]") {
    Chain scene = falling(), other = falling();
    ancf::EigenLu lu;
    ancf::EigenLdlt ldlt;
    const EnergyMomentum method(steps(1e-3));
    for (const DynamicsReport& report : {fall(scene, method, lu), fall(other, method, ldlt)}) {
        REQUIRE(report.status == Status::converged);
        CHECK(report.energy_drift <= 1e-12 * report.kinetic_largest);
    }
    CHECK(distance(scene.model.state().q, other.model.state().q) <= 1e-11);
}

TEST_CASE("energy-momentum: repeated constraints change nothing but their multipliers",
          "[dynamics]") {
    Chain once = swing(), twice = swing();
    twice.model.add(ancf::Distance<3>(twice.first(), Vector3(0.0, 0.0, 0.0), 0.5));
    REQUIRE(run(once.model, 2e-3, until(0.2)).status == Status::converged);
    ancf::ProblemOptions options;
    options.redundancy = ancf::Redundancy::minimum_norm;
    ancf::DynamicProblem problem(twice.model, options);
    ancf::EigenLu solver;
    const DynamicsReport report =
        EnergyMomentum(steps(2e-3)).integrate(problem, solver, until(0.2));
    REQUIRE(report.status == Status::converged);
    CHECK(distance(twice.model.state().q, once.model.state().q) <= 1e-11);
    const VectorX& shared = twice.model.state().multipliers;
    CHECK(shared[0] == Approx(shared[1]).epsilon(1e-10));
}

TEST_CASE("energy-momentum: asks constraints for their stiffness where it makes a matrix alone",
          "[dynamics]") {
    Chain scene = chain(3, {0.0, -0.5, 0.0}, {1.2, -0.5, 0.0});
    long asked = 0;
    scene.model.add(
        CountedLink{ancf::Distance<3>(scene.first(), Vector3(0.0, 0.0, 0.0), 0.5), &asked});
    scene.model.set_gravity({0.0, -9.81, 0.0});
    const DynamicsReport report = run(scene.model, 2e-3, until(0.2));
    REQUIRE(report.status == Status::converged);
    CHECK(report.evaluations > 200);
    CHECK(asked <= report.jacobians + 20);  // at start and end; measured 5 more
}

TEST_CASE("energy-momentum: a step too long is taken in parts, on the same grid", "[dynamics]") {
    Chain scene = swing();
    scene.model.set_rigid_rates({0.0, 0.0, 0.0}, {0.0, 0.0, 40.0});
    const DynamicsReport report = run(scene.model, 0.1, until(0.3));
    REQUIRE(report.status == Status::converged);
    CHECK(report.convergence_failures > 0);
    CHECK(report.smallest_step < 0.1);
    CHECK(report.time == Approx(0.3).epsilon(1e-14));
    CHECK(report.energy_drift <= 1e-10 * report.kinetic_largest);
}

TEST_CASE("energy-momentum: a run stopped within a step taken in parts goes on from there",
          "[dynamics]") {
    Chain scene = chain(3, {0.0, 0.0, 0.0}, {1.2, 0.0, 0.0}, 5e5);
    const Vector3 gravity(1.0, -9.0, 2.0);
    scene.model.set_gravity(gravity);
    scene.model.set_rigid_rates({0.0, 0.0, 0.0}, {0.0, 0.0, 40.0});
    scene.model.set_rate(scene.nodes[2], Field::r, {0.5, 1.0, -1.0});
    const auto linear_momentum = [&]() -> Vector3 {
        ancf::DynamicProblem problem(scene.model);
        return momentum(problem, scene.model.state()).linear;
    };
    const Vector3 start = linear_momentum();
    Schedule schedule = until(0.3);
    schedule.progress = [](double, double) { return false; };
    const DynamicsReport first = run(scene.model, 0.1, schedule);
    REQUIRE(first.status == Status::stopped);
    REQUIRE(first.time < 0.09);
    const DynamicsReport second = run(scene.model, 0.1, until(0.3), first.memory);
    REQUIRE(second.status == Status::converged);
    CHECK(second.time == Approx(0.3).epsilon(1e-14));
    // the clock and the state have moved by the same: dp = m g t, m = 1.2 kg
    CHECK((linear_momentum() - start - 1.2 * 0.3 * gravity).norm() <= 1e-9);
}

TEST_CASE("energy-momentum: names a load that is no number", "[dynamics]") {
    Chain scene = swing();
    scene.model.add(ancf::Force<3>(scene.last(), {1.0, 0.0, 0.0}), [](double t) {
        return t >= 0.05 ? std::numeric_limits<double>::quiet_NaN() : 1.0;
    });
    const DynamicsReport report = run(scene.model, 1e-3, until(0.1));
    CHECK(report.status == Status::not_finite);
    CHECK_THAT(report.message, ContainsSubstring("the force of load 0 is not finite"));
}

TEST_CASE("energy-momentum: stops on request, refuses what cannot be meant", "[dynamics]") {
    Chain scene = swing();
    Schedule schedule = until(0.5);
    schedule.progress = [](double time, double) { return time < 0.0999; };
    const DynamicsReport report = run(scene.model, 1e-3, schedule);
    CHECK(report.status == Status::stopped);
    CHECK(scene.model.state().time == Approx(0.1));

    CHECK_THROWS_AS(EnergyMomentum(steps(0.0)), ancf::InvalidArgument);
    CHECK_THROWS_AS(EnergyMomentum(steps(-1e-3)), ancf::InvalidArgument);
    EnergyMomentumOptions options;
    options.max_iterations = 0;
    CHECK_THROWS_AS(EnergyMomentum(options), ancf::InvalidArgument);
    CHECK_THROWS_AS(run(scene.model, 1e-3, until(0.05)), ancf::InvalidArgument);
    scene.model.set_value(scene.first(), Field::r, {0.0, -2.0, 0.0});
    CHECK(run(scene.model, 1e-3, until(1.0)).status == Status::inconsistent);
}

}  // namespace energy_momentum_test
