// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/dynamics/discrete_gradient.hpp>
#include <ancf/dynamics/rigid_modes.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/group_of.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>

#include <dynamics/scenes.hpp>
#include <support/bar.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace discrete_gradient_test {

using namespace ancf::test;
using ancf::Field;
using ancf::VectorX;

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

/// Checks a step of one straight element that turns by an angle and strains by about `strain`.
template <class Element>
void check_turned_step(const ancf::Section& section, double angle, double strain, unsigned seed) {
    constexpr int dofs = Element::dofs, dimension = Element::dimension;
    using E = typename Element::Coordinates;
    using Point = ancf::Vector<double, dimension>;
    Random random(seed);
    ancf::BasicModel<dimension> model;
    ancf::straight_beam<Element>(model, ancf::Material::isotropic(100.0, 0.3, 1.0), section,
                                 Point(Point::Zero()), Point(0.8 * Point::Unit(0)), 1);
    const ancf::GroupOf<Element>& group = model.template group<Element>();
    const Element& element = group.element(0);
    const E rest = model.state().q;
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
    const auto section = ancf::rectangle(0.2, 0.1);
    check_turned_step<ancf::CrossSectionBeam<3>>(section, angle, strain, 1);
    check_turned_step<ancf::CrossSectionBeam<2>>(section, angle, strain, 2);
    check_turned_step<ancf::Cable<3>>(ancf::rectangle(0.1, 0.1), angle, strain, 3);
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

}  // namespace discrete_gradient_test
