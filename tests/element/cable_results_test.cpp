// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What a cable tells of itself: places, tangent, curvature, section forces.

#include <ancf/element/cable/cable.hpp>

#include <element/cable_samples.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/random_state.hpp>

#include <cmath>
#include <cstdint>

namespace cable_results_test {

using namespace ancf;
using test::cable_length;
using test::cable_material;
using test::cable_section;

const double axial = cable_material().young * cable_section().moments().area;
const double bending = cable_material().young * cable_section().moments().yy;

TEMPLATE_TEST_CASE("Cable: the Jacobian of the position is its complex-step derivative",
                   "[element][cable][results]", Cable<2>, Cable<3>) {
    const auto element = test::straight_cable<TestType>();
    int count = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed, ++count) {
        test::Random random(seed);
        const auto e = test::random_state(element, random);
        const double xi = random.uniform(0.0, 1.0), y = random.uniform(-0.1, 0.1),
                     z = random.uniform(-0.1, 0.1);
        const auto position = test::complex_step_jacobian(
            [&](const auto& c) { return element.position(c, xi, y, z); }, e);
        CHECK(test::relative_error(element.position_jacobian(e, xi, y, z), position) <= 1e-13);
        const auto rate = test::random_state(element, random);
        CHECK(test::relative_error(element.velocity(e, rate, xi, y, z), (position * rate).eval()) <=
              1e-13);
        CHECK(std::abs(element.tangent(e, xi).norm() - 1.0) <= 1e-15);
        // the section stands normal to the tangent, at the distance of its point
        const auto arm = (element.position(e, xi, y, z) - element.position(e, xi)).eval();
        const double distance = TestType::dimension == 2 ? std::abs(y) : std::hypot(y, z);
        CHECK(std::abs(arm.dot(element.tangent(e, xi))) <= 1e-14);
        CHECK(std::abs(arm.norm() - distance) <= 1e-14);
    }
    CHECK(count == 100);
}

TEST_CASE(
    "Cable: in space the section of a line in the plane stands as in the plane, whatever its "
    "direction",
    "[element][cable][results]") {
    const auto plane = test::straight_cable<Cable<2>>();
    const auto space = test::straight_cable<Cable<3>>();
    for (int k = 0; k < 48; ++k) {
        const Matrix<double, 2> turn = test::rotation(k * 3.14159265358979 / 24.0);
        const auto e = test::moved<Cable<2>>(test::reference_coordinates(plane), turn,
                                             Vector<double, 2>(0.3, 0.4));
        Vector<double, 12> lifted = Vector<double, 12>::Zero();
        for (int a = 0; a < 4; ++a) lifted.segment<2>(3 * a) = e.segment<2>(2 * a);
        const auto flat = plane.position(e, 0.5, 0.02);
        CHECK((space.position(lifted, 0.5, 0.02, 0.03) - Vector<double, 3>(flat[0], flat[1], 0.03))
                  .norm() <= 1e-14);
    }
}

TEMPLATE_TEST_CASE("Cable: ends of the element are its nodes", "[element][cable][results]",
                   Cable<2>, Cable<3>) {
    constexpr int dimension = TestType::dimension;
    const auto element = test::straight_cable<TestType>();
    test::Random random(3);
    const auto e = test::random_state(element, random);
    const auto slope = e.template segment<dimension>(3 * dimension).eval();
    CHECK((element.position(e, 0.0) - e.template head<dimension>()).norm() <= 1e-15);
    CHECK((element.position(e, 1.0) - e.template segment<dimension>(2 * dimension)).norm() <=
          1e-15);
    CHECK((element.tangent(e, 1.0) - slope / slope.norm()).norm() <= 1e-15);
}

TEMPLATE_TEST_CASE("Cable: a stretched bar transmits E A eps times its stretch",
                   "[element][cable][results]", Cable<2>, Cable<3>) {
    const auto element = test::straight_cable<TestType>();
    const Cable<TestType::dimension, EngineeringAxial> linear(cable_material(), cable_section(),
                                                              cable_length);
    const double stretch = 1.1;
    const typename TestType::Coordinates e = stretch * test::reference_coordinates(element);
    const double green = 0.5 * (stretch * stretch - 1.0);
    for (const double xi : {0.0, 0.3, 1.0}) {
        CHECK(element.axial_strain(e, xi) == Approx(green).epsilon(1e-13));
        CHECK(element.section_forces(e, xi).axial ==
              Approx(axial * green * stretch).epsilon(1e-13));
        CHECK(element.stress(e, xi)[0] == Approx(cable_material().young * green).epsilon(1e-13));
        CHECK(linear.axial_strain(e, xi) == Approx(stretch - 1.0).epsilon(1e-13));
        CHECK(linear.section_forces(e, xi).axial == Approx(axial * (stretch - 1.0)).epsilon(1e-13));
        CHECK(element.curvature(e, xi).norm() == 0.0);
    }
    // the same force stands at the nodes
    CHECK(element.force(e)[2 * TestType::dimension] ==
          Approx(axial * green * stretch).epsilon(1e-13));
}

TEST_CASE("Cable: curvature and moment of a bent line", "[element][cable][results]") {
    // r = (x, c x^2/2): r' = (1, c x), kappa = c/(1 + c^2 x^2)^(3/2), exactly a Hermite polynomial
    const double c = 0.8;
    const auto plane = test::straight_cable<Cable<2>>();
    const auto space = test::straight_cable<Cable<3>>();
    Vector<double, 8> e;
    e << 0.0, 0.0, 1.0, 0.0, cable_length, 0.5 * c * cable_length * cable_length, 1.0,
        c * cable_length;
    test::Random random(2);
    const Matrix<double, 3> turn = test::random_rotation<3>(random);
    Vector<double, 12> turned;
    for (int a = 0; a < 4; ++a)
        turned.segment<3>(3 * a) = turn * Vector<double, 3>(e[2 * a], e[2 * a + 1], 0.0);
    for (const double xi : {0.0, 0.4, 1.0}) {
        const double slope = c * xi * cable_length, stretch = std::sqrt(1.0 + slope * slope);
        const double kappa = c / std::pow(stretch, 3), moment = bending * kappa / stretch;
        const double green = 0.5 * slope * slope;
        CHECK(plane.curvature(e, xi)[0] == Approx(kappa).epsilon(1e-13));
        CHECK(plane.moment(e, xi)[0] == Approx(moment).epsilon(1e-13));
        CHECK((space.curvature(turned, xi) - kappa * turn.col(2)).norm() <= 1e-13 * kappa);
        CHECK((space.moment(turned, xi) - moment * turn.col(2)).norm() <= 1e-13 * moment);
        const SectionForces flat = plane.section_forces(e, xi),
                            solid = space.section_forces(turned, xi);
        CHECK(flat.moment_z == Approx(moment).epsilon(1e-13));
        CHECK(flat.axial == Approx(axial * green * stretch - moment * kappa).epsilon(1e-12));
        CHECK(solid.axial == Approx(flat.axial).epsilon(1e-12));
        CHECK(std::hypot(solid.moment_y, solid.moment_z) == Approx(moment).epsilon(1e-13));
        // fibres on the inner side, at y > 0, are compressed
        CHECK(plane.stress(e, xi, 0.01)[0] ==
              Approx(cable_material().young * (green - 0.01 * kappa)).epsilon(1e-12));
    }
}

TEST_CASE("Cable: stress in space is that of bending about the moment's axis",
          "[element][cable][results]") {
    const auto element = test::straight_cable<Cable<3>>();
    int count = 0;
    for (std::uint64_t seed = 0; seed < 50; ++seed, ++count) {
        test::Random random(seed);
        const auto e = test::random_state(element, random);
        const double xi = random.uniform(0.0, 1.0), y = 0.02, z = -0.03;
        const Vector<double, 3> arm = element.position(e, xi, y, z) - element.position(e, xi);
        // e_xx changes by t . (kappa x arm)
        const double bent =
            element.tangent(e, xi).dot(cross(Vector<double, 3>(element.curvature(e, xi)), arm));
        const double expected = cable_material().young * (element.axial_strain(e, xi) + bent);
        CHECK(element.stress(e, xi, y, z)[0] == Approx(expected).epsilon(1e-11));
    }
    CHECK(count == 50);
}

TEMPLATE_TEST_CASE_SIG("Cable: the force on a slope is the moment at that end",
                       "[element][cable][results]", ((int Dimension), Dimension), 2, 3) {
    // uniform bending: stations see the same moment as the end, so that the virtual work of an end
    // moment is exact
    const double kappa = 0.01;  // of an arc so flat that the Hermite line is one to 1e-9
    const auto element = test::straight_cable<Cable<Dimension>>();
    const test::Helix arc{1.0 / kappa, 0.0, 0.0};
    const auto e = arc.template coordinates<Dimension>(0.0, cable_length);
    const auto force = element.force(e);
    const Vector<double, Dimension> slope = e.template tail<Dimension>();
    Vector<double, Dimension> normal = Vector<double, Dimension>::Zero();
    normal[0] = -slope[1];
    normal[1] = slope[0];
    CHECK(force.template tail<Dimension>().dot(normal) == Approx(bending * kappa).epsilon(1e-4));
    const auto moment = element.moment(e, 1.0);
    CHECK(moment[moment.size() - 1] == Approx(bending * kappa).epsilon(1e-4));
}

}  // namespace cable_results_test
