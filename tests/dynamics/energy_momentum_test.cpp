// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/dynamics/discrete_gradient.hpp>
#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/momentum.hpp>
#include <ancf/dynamics/rigid_modes.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/output/state_file.hpp>
#include <ancf/solver/eigen_solver.hpp>

#include <dynamics/scenes.hpp>
#include <support/bar.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
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

TEST_CASE("rigid modes: what is left of a change has neither resultant nor moment", "[dynamics]") {
    Random random(1);
    const auto is_position = [](int k) { return k % 2 == 0; };
    const int length_power[] = {1, 0, 1, 0};
    ancf::Vector<double, 12> e = random.vector<12>(), change = random.vector<12>();
    ancf::detail::RigidModes modes;
    modes.set(3, 4, e.data(), length_power, 0.3);
    ancf::Vector<double, 12> rest, force;
    modes.without(change.data(), rest.data());
    for (int i = 0; i < 12; ++i) force[i] = modes.weight(i) * rest[i];
    Vector3 resultant = Vector3::Zero(), moment = Vector3::Zero();
    for (int k = 0; k < 4; ++k) {
        if (is_position(k)) resultant += force.segment<3>(3 * k);
        moment += ancf::cross(Vector3(e.segment<3>(3 * k)), Vector3(force.segment<3>(3 * k)));
    }
    CHECK(resultant.norm() <= 1e-14);
    CHECK(moment.norm() <= 1e-14);
    CHECK(rest.norm() > 0.1);
    CHECK(change.dot(force) == Approx(rest.dot(force)).epsilon(1e-13));

    // a rigid motion leaves nothing
    ancf::Vector<double, 12> rigid;
    const Vector3 shift = random.vector<3>(), turn = random.vector<3>();
    for (int k = 0; k < 4; ++k) {
        rigid.segment<3>(3 * k) = ancf::cross(turn, Vector3(e.segment<3>(3 * k)));
        if (is_position(k)) rigid.segment<3>(3 * k) += shift;
    }
    modes.without(rigid.data(), rest.data());
    CHECK(rest.norm() <= 1e-14);
}

TEST_CASE("rigid modes: in the plane the derivative of what is left is that of its differences",
          "[dynamics]") {
    Random random(3);
    using E = ancf::Vector<double, 8>;
    const int length_power[] = {1, 0, 1, -1};
    const E before = random.vector<8>(), after = random.vector<8>();
    ancf::detail::RigidModes modes;
    const auto rest_of = [&](const E& end) {
        const E middle = 0.5 * (before + end), change = end - before;
        E rest;
        modes.set(2, 4, middle.data(), length_power, 0.3);
        modes.without(change.data(), rest.data());
        return rest;
    };
    const E rest = rest_of(after), change = after - before;
    ancf::Matrix<double, 8> derivative;
    modes.derivative_of_without(change.data(), rest.data(), derivative.data());
    const double h = 1e-6;
    for (int j = 0; j < 8; ++j) {
        const E slope =
            (rest_of(after + h * E::Unit(j)) - rest_of(after - h * E::Unit(j))) / (2 * h);
        CHECK((slope - derivative.col(j)).norm() <= 1e-8);
    }
}

TEST_CASE("discrete gradient: its work is the change of the energy, and its tangent its derivative",
          "[dynamics]") {
    const auto seed = GENERATE(range(0U, 10U));
    INFO("seed " << seed);
    Random random(seed);
    const Bar<3> bar(3.0, 1.0, 1.0);
    ancf::GroupOf<Bar<3>> group;
    group.prototypes.push_back(bar);
    using E = Bar<3>::Coordinates;
    E e0 = random.vector<6>(), e1 = e0 + 0.3 * random.vector<6>();
    const double before = bar.energy(e0);
    ancf::detail::StepForce step, beside;
    ancf::detail::step_force(group, 0, e0.data(), e1.data(), before,
                             ancf::detail::StepTangent::exact, step);
    const E force = Eigen::Map<const E>(step.force);
    const auto tangent = Eigen::Map<const ancf::Matrix<double, 6>>(step.tangent);
    CHECK(force.dot(e1 - e0) == Approx(bar.energy(e1) - before).margin(1e-14));
    CHECK(step.energy == bar.energy(e1));
    const double h = 1e-6;
    for (int j = 0; j < 6; ++j) {
        E slope = E::Zero();
        for (const double sign : {1.0, -1.0}) {
            const E end = e1 + sign * h * E::Unit(j);
            ancf::detail::step_force(group, 0, e0.data(), end.data(), before,
                                     ancf::detail::StepTangent::none, beside);
            slope += sign / (2.0 * h) * Eigen::Map<const E>(beside.force);
        }
        CHECK((slope - tangent.col(j)).norm() <= 1e-7 * (1.0 + slope.norm()));
    }
    // the correction is there: the middle's gradient alone misses the energy
    const E middle = bar.force(E(0.5 * (e0 + e1)));
    CHECK(std::abs(middle.dot(e1 - e0) - (bar.energy(e1) - before)) > 1e-10);
}

TEST_CASE("discrete gradient: a turn of any size strains nothing", "[dynamics]") {
    // The mean of both ends of a turn is smaller than they are by cos(angle/2). Evaluated there, a
    // bar that keeps its length was compressed by EA angle^2/8, and what corrected the work of
    // that force changed its direction with every change of length, however small.
    const double stiffness = 3.0;
    const Bar<3> bar(stiffness, 1.0, 1.0);
    ancf::GroupOf<Bar<3>> group;
    group.prototypes.push_back(bar);
    const Vector3 along = Vector3(2.0, -1.0, 2.0) / 3.0, across = Vector3(2.0, 2.0, -1.0) / 3.0;
    int checked = 0;
    for (const double angle : {0.01, 0.3, 1.5})
        for (const double strain : {0.0, 1e-6, -1e-6, 1e-3}) {
            ancf::Vector<double, 6> e0, e1;
            e0 << Vector3(1.0, 2.0, 3.0), Vector3(1.0, 2.0, 3.0) + along;
            const Vector3 end = std::cos(angle) * along + std::sin(angle) * across;
            e1 << Vector3(1.1, 2.0, 3.0), Vector3(1.1, 2.0, 3.0) + (1.0 + strain) * end;
            ancf::detail::StepForce step;
            ancf::detail::step_force(group, 0, e0.data(), e1.data(), bar.energy(e0),
                                     ancf::detail::StepTangent::none, step);
            // that of the mean strain times cos(angle/2); without strain 6e-7 EA angle^2 measured
            const double force = Eigen::Map<const Vector3>(step.force).norm();
            CHECK(force <= stiffness * (0.6 * std::abs(strain) + 1e-6 * angle * angle));
            CHECK(force >= 0.3 * stiffness * std::abs(strain));
            ++checked;
        }
    CHECK(checked == 12);
}

TEST_CASE("half turn: it brings both ends of a turn to the middle", "[dynamics]") {
    const Vector3 axis = Vector3(2.0, 3.0, 6.0) / 7.0, x(0.3, -1.2, 0.7);
    int checked = 0;
    for (const double angle : {1e-3, 0.4, 2.0}) {
        const Vector3 y = 2.0 * std::tan(0.5 * angle) * axis;
        const ancf::detail::HalfTurn half(y);
        const auto turned = [&](double by) {
            return Vector3(std::cos(by) * x + std::sin(by) * ancf::cross(axis, x) +
                           (1.0 - std::cos(by)) * axis.dot(x) * axis);
        };
        CHECK((half.symmetric(x) + half.skew(x) - turned(0.5 * angle)).norm() <= 1e-14);
        CHECK((half.symmetric(x) - half.skew(x) - turned(-0.5 * angle)).norm() <= 1e-14);
        const double h = 1e-6;
        for (int b = 0; b < 3; ++b) {
            const ancf::detail::HalfTurn more(y + h * Vector3::Unit(b)),
                less(y - h * Vector3::Unit(b));
            const Vector3 symmetric = (more.symmetric(x) - less.symmetric(x)) / (2.0 * h);
            const Vector3 skew = (more.skew(x) - less.skew(x)) / (2.0 * h);
            CHECK((symmetric - half.symmetric_rate(b, x)).norm() <= 1e-9);
            CHECK((skew - half.skew_rate(b, x)).norm() <= 1e-9);
            ++checked;
        }
    }
    CHECK(checked == 9);
}

/// Checks a step of an element that turns by an angle and strains by about `strain`.
template <class Element>
void check_turned_step(const Element& element, const typename Element::Coordinates& rest,
                       double angle, double strain, unsigned seed) {
    constexpr int dofs = Element::dofs, dimension = Element::dimension;
    using E = typename Element::Coordinates;
    Random random(seed);
    ancf::GroupOf<Element> group;
    group.prototypes.push_back(element);
    const E e0 = rest + strain * random.vector<dofs>();
    E e1 = e0 + strain * random.vector<dofs>();
    const Vector3 axis = dimension == 2 ? Vector3(0, 0, 1) : Vector3(2.0, 3.0, 6.0) / 7.0;
    for (int k = 0; k < dofs; k += dimension) {
        Vector3 x = Vector3::Zero();
        for (int i = 0; i < dimension; ++i) x[i] = e1[k + i];
        const Vector3 turned = std::cos(angle) * x + std::sin(angle) * ancf::cross(axis, x) +
                               (1.0 - std::cos(angle)) * axis.dot(x) * axis;
        for (int i = 0; i < dimension; ++i) e1[k + i] = turned[i];
    }
    const double before = element.energy(e0);
    ancf::detail::StepForce step, beside;
    const auto evaluate = [&](const E& end, ancf::detail::StepTangent wanted,
                              ancf::detail::StepForce& out) {
        ancf::detail::step_force(group, 0, e0.data(), end.data(), before, wanted, out);
    };
    evaluate(e1, ancf::detail::StepTangent::exact, step);
    const E force = Eigen::Map<const E>(step.force);
    const E middle = 0.5 * (e0 + e1);
    const double size = force.norm();
    CHECK(std::abs(force.dot(e1 - e0) - (element.energy(e1) - before)) <= 1e-13 * size);
    Vector3 resultant = Vector3::Zero(), moment = Vector3::Zero();
    for (int k = 0; k < dofs; k += dimension) {
        Vector3 f = Vector3::Zero(), x = Vector3::Zero();
        for (int i = 0; i < dimension; ++i) {
            f[i] = force[k + i];
            x[i] = middle[k + i];
        }
        const auto field = Element::fields.at(k / dimension % Element::fields.count());
        if (field == Field::r) resultant += f;
        moment += ancf::cross(x, f);
    }
    CHECK(resultant.norm() <= 1e-13 * size);
    CHECK(moment.norm() <= 1e-13 * size);
    const double h = 1e-6;
    const auto tangent = Eigen::Map<const ancf::Matrix<double, dofs>>(step.tangent);
    for (int j = 0; j < dofs; ++j) {
        E slope = E::Zero();
        for (const double sign : {1.0, -1.0}) {
            evaluate(E(e1 + sign * h * E::Unit(j)), ancf::detail::StepTangent::none, beside);
            slope += sign / (2.0 * h) * Eigen::Map<const E>(beside.force);
        }
        CHECK((slope - tangent.col(j)).norm() <= 1e-6 * tangent.norm());
    }
}

TEST_CASE("discrete gradient: beams keep energy and momenta over a turn, with an exact tangent",
          "[dynamics]") {
    const double angle = GENERATE(0.0, 0.03, 0.7), strain = GENERATE(1e-3, 3e-2);
    CAPTURE(angle, strain);
    const auto material = ancf::Material::isotropic(100.0, 0.3, 1.0);
    const auto section = ancf::rectangle(0.2, 0.1);
    ancf::CrossSectionBeam<3>::Coordinates space;
    space << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.8, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    check_turned_step(ancf::CrossSectionBeam<3>(material, section, 0.8), space, angle, strain, 1);
    ancf::CrossSectionBeam<2>::Coordinates plane;
    plane << 0, 0, 1, 0, 0, 1, 0.8, 0, 1, 0, 0, 1;
    check_turned_step(ancf::CrossSectionBeam<2>(material, section, 0.8), plane, angle, strain, 2);
    ancf::Cable<3>::Coordinates cable;
    cable << 0, 0, 0, 1, 0, 0, 0.8, 0, 0, 1, 0, 0;
    check_turned_step(ancf::Cable<3>(material, ancf::rectangle(0.1, 0.1), 0.8), cable, angle,
                      strain, 3);
}

TEST_CASE("rigid modes: the derivative of the turn that fits is that of its differences",
          "[dynamics]") {
    Random random(5);
    using E = ancf::Vector<double, 12>;
    const int length_power[] = {1, 0, 1, 0};
    const E before = random.vector<12>(), after = before + 0.3 * random.vector<12>();
    ancf::detail::RigidModes modes;
    const auto turn_of = [&](const E& end) {
        const E middle = 0.5 * (before + end), change = end - before;
        modes.set(3, 4, middle.data(), length_power, 0.3);
        return modes.firm_turn_of(change.data());
    };
    const Vector3 turn = turn_of(after);
    const E change = after - before;
    ancf::Matrix<double, 3, 12> derivative;
    modes.derivative_of_firm_turn(change.data(), turn, derivative.data());
    const double h = 1e-6;
    for (int j = 0; j < 12; ++j) {
        const Vector3 slope =
            (turn_of(after + h * E::Unit(j)) - turn_of(after - h * E::Unit(j))) / (2.0 * h);
        CHECK((slope - derivative.col(j)).norm() <= 1e-8);
    }
}

TEST_CASE("energy-momentum: a spinning free chain keeps energy and momenta", "[dynamics]") {
    const double step = GENERATE(1e-3, 1e-2);
    Chain scene = chain(4, {0.2, 0.1, 0.0}, {1.2, 0.4, 0.3});
    spin(scene.model, {0.5, 3.0, 4.0}, {0.3, -0.2, 0.1});
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
    spin(scene.model, {0.0, 1.0, 5.0}, {0.3, -0.2, 0.1});
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

TEST_CASE("energy-momentum: loads give derivatives where a matrix is built alone", "[dynamics]") {
    Chain scene = swing();
    long asked = 0;
    scene.model.add(Counted{scene.last(), &asked});
    const DynamicsReport report = run(scene.model, 1e-3, until(0.02));
    REQUIRE(report.status == Status::converged);
    CHECK(report.iterations > report.jacobians);
    CHECK(asked == report.jacobians + 1);  // one more for the report's memory; 268 if always
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

TEST_CASE("energy-momentum: a step too long is taken in parts, on the same grid", "[dynamics]") {
    Chain scene = swing();
    spin(scene.model, {0.0, 0.0, 40.0}, {0.0, 0.0, 0.0});
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
    spin(scene.model, {0.0, 0.0, 40.0}, {0.0, 0.0, 0.0});
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

TEST_CASE("rigid modes: of more vectors than a word has bits", "[dynamics]") {
    VectorX e(3 * 70), change(3 * 70);
    for (int i = 0; i < e.size(); ++i) {
        e[i] = std::sin(1.0 * i * i);
        change[i] = std::cos(2.0 * i * i);
    }
    std::vector<int> length_power(70, 0);
    std::fill_n(length_power.begin(), 35, 1);
    ancf::detail::RigidModes modes;
    modes.set(3, 70, e.data(), length_power.data(), 0.5);
    VectorX rest(3 * 70);
    modes.without(change.data(), rest.data());
    CHECK(modes.turn_of(rest.data()).norm() <= 1e-12);
    Vector3 shift = Vector3::Zero();
    for (int k = 0; k < 35; ++k) shift += rest.segment<3>(3 * k);
    CHECK(shift.norm() <= 1e-12);
    CHECK(rest.norm() > 1e-3);
    for (int k = 35; k < 70; ++k) CHECK(modes.weight(3 * k) == 0.5);
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
