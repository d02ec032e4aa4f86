// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Cables whose stress-free state is a curve.

#include <ancf/element/cable/cable.hpp>

#include <element/cable_curved_samples.hpp>
#include <element/property_checks.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/dense.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace cable_curved_test {

using namespace ancf;
using test::AnyElement;
using test::cable_length;
using test::cable_material;
using test::cable_section;
using test::curved;
using test::disturbed;
using test::for_each_curved;
using test::Helix;
using test::Random;
using test::rules;

const double axial = cable_material().young * cable_section().moments().area;
const double bending = cable_material().young * cable_section().moments().yy;

void check_no_force(const AnyElement& element, const VectorX& reference) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const int dimension = element.shape.dimension;
        Random random(seed);
        const MatrixX turn = test::random_rotation(dimension, random);
        const VectorX e = test::moved(element.shape, reference, turn, random.vector(dimension));
        CHECK(element.force(e).norm() <= 1e-14 * axial);  // asked for 1e-12; measured 2e-15
        CHECK(std::abs(element.energy(e)) <= 1e-15 * axial * cable_length);
    }
}

void check_rigid_modes(const AnyElement& element, const VectorX& reference) {
    const int dimension = element.shape.dimension;
    const int motions = dimension == 3 ? 6 : 3;
    VectorX scale = VectorX::Constant(element.shape.dofs(), 1.0 / cable_length);
    scale.segment(0, dimension).setOnes();
    scale.segment(2 * dimension, dimension).setOnes();
    const MatrixX tangent =
        scale.asDiagonal() * element.evaluate(reference).tangent * scale.asDiagonal();
    VectorX values = test::eigenvalues(tangent);
    values /= values.maxCoeff();
    CHECK(values.head(motions).cwiseAbs().maxCoeff() <= 1e-14);
    CHECK(values(motions) >= 1e-4);  // bending, (radius/length)^2; measured 1e-3
}

TEMPLATE_TEST_CASE("Cable: a curved element has no force in its reference, however moved",
                   "[element][cable][curved]", Cable<2>, Cable<3>, (Cable<2, EngineeringAxial>),
                   (Cable<3, EngineeringAxial>)) {
    CHECK(for_each_curved<TestType>(check_no_force) >= 12);
}

TEMPLATE_TEST_CASE("Cable: a curved element at rest has the zero eigenvalues of a rigid body",
                   "[element][cable][curved]", Cable<2>, Cable<3>) {
    CHECK(for_each_curved<TestType>(check_rigid_modes) >= 12);
}

TEST_CASE(
    "Cable: curved in the plane, the spatial element has the planar energy until its curvature "
    "turns over",
    "[element][cable][curved][plane]") {
    int count = 0;
    for (const Rule& rule : rules()) {
        for (const double radius : {1.0, 5.0}) {
            const Helix arc{radius, 0.0};
            const auto flat = arc.coordinates<2>(0.0, cable_length);
            const auto plane = curved<Cable<2>>(flat, rule);
            const auto space = curved<Cable<3>>(arc.coordinates<3>(0.0, cable_length), rule);
            for (std::uint64_t seed = 0; seed < 20; ++seed) {
                test::Random random(seed);
                const Vector<double, 8> e = flat + 0.02 / radius * random.vector<8>();
                Vector<double, 12> lifted = Vector<double, 12>::Zero();
                for (int a = 0; a < 4; ++a) lifted.segment<2>(3 * a) = e.segment<2>(2 * a);
                CHECK(space.energy(lifted) == Approx(plane.energy(e)).epsilon(1e-10));
                ++count;
            }
        }
    }
    CHECK(count == 160);
}

TEST_CASE("Cable: bent to another arc, a curved element has the energy of the change",
          "[element][cable][curved]") {
    // arcs so flat that Hermite lines are arcs; equal lengths, so that only the curvature changes
    const double before = 0.02, after = 0.05;
    const auto reference = Helix{1.0 / before, 0.0}.coordinates<3>(0.0, cable_length);
    const auto e = Helix{1.0 / after, 0.0}.coordinates<3>(0.0, cable_length);
    const double expected = 0.5 * bending * (after - before) * (after - before) * cable_length;
    CHECK(curved<Cable<3>>(reference).energy(e) == Approx(expected).epsilon(1e-4));
    CHECK(curved<Cable<3>>(reference).moment(e, 0.3)[2] ==
          Approx(bending * (after - before)).epsilon(1e-3));
    // wound to a helix of that curvature it spins free: the resultant of its sections has no twist
    // to pay for
    const Helix helix{0.5 / after, 0.5 / after};
    REQUIRE(helix.curvature() == Approx(after));
    CHECK(curved<Cable<3>>(reference).energy(helix.coordinates<3>(0.0, cable_length)) ==
          Approx(expected).epsilon(1e-3));
}

TEST_CASE("Cable: a straight reference given as coordinates is the straight element",
          "[element][cable][curved]") {
    const auto straight = test::straight_cable<Cable<3>>();
    test::Random random(11);
    const auto turn = test::random_rotation<3>(random);
    const auto reference =
        test::moved<Cable<3>>(test::reference_coordinates(straight), turn, random.vector<3>());
    const auto given = curved<Cable<3>>(reference);
    CHECK(given.length() == Approx(cable_length).epsilon(1e-15));
    CHECK(test::relative_error(given.mass(), straight.mass()) <= 1e-14);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        test::Random state(seed);
        const auto e = test::random_state(straight, state);
        CHECK(test::relative_error(given.evaluate(e).tangent, straight.evaluate(e).tangent) <=
              1e-13);
        CHECK(test::relative_error(given.force(e), straight.force(e)) <= 1e-13);
    }
}

TEMPLATE_TEST_CASE("Cable: a parameter of another speed leaves the element as it is",
                   "[element][cable][curved]", Cable<2>, Cable<3>) {
    // the same curve, its parameter twice as fast: slopes are halved and the range doubled
    constexpr int dimension = TestType::dimension;
    const auto reference = Helix{1.0, 0.3}.coordinates<dimension>(0.0, cable_length);
    const auto halved = [](typename TestType::Coordinates e) {
        e.template segment<dimension>(dimension) *= 0.5;
        e.template tail<dimension>() *= 0.5;
        return e;
    };
    const auto slow = curved<TestType>(reference);
    const TestType fast(cable_material(), cable_section(), halved(reference), 2.0 * cable_length);
    CHECK(fast.length() == Approx(slow.length()).epsilon(1e-14));
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        test::Random random(seed);
        const typename TestType::Coordinates e =
            disturbed(test::shape_of<TestType>(), reference, random, 0.2);
        CHECK(fast.energy(halved(e)) == Approx(slow.energy(e)).epsilon(1e-12));
        CHECK(fast.axial_strain(halved(e), 0.3) ==
              Approx(slow.axial_strain(e, 0.3)).epsilon(1e-12));
        CHECK((fast.curvature(halved(e), 0.3) - slow.curvature(e, 0.3)).norm() <= 1e-12);
    }
}

TEMPLATE_TEST_CASE("Cable: mass and weight of a curved element are those of its arc",
                   "[element][cable][curved]", Cable<2>, Cable<3>) {
    constexpr int dimension = TestType::dimension;
    const Helix arc{3.0, 0.0, 0.0};
    const auto reference = arc.coordinates<dimension>(0.0, cable_length);
    const auto element = curved<TestType>(reference);
    const double mass =
        cable_material().density * cable_section().moments().area * element.length();
    // a cubic is no circle: on 0.23 radian they differ by 4e-6
    CHECK(element.length() == Approx(cable_length).epsilon(1e-5));
    const Vector<double, dimension> g = 9.81 * Vector<double, dimension>::Unit(1);
    const auto weight = element.gravity(g);
    CHECK(weight[1] + weight[2 * dimension + 1] == Approx(9.81 * mass).epsilon(1e-13));
    // the work on the reference is that on its centroid
    const double angle = cable_length / arc.radius;
    const double height = arc.radius * (1.0 - std::sin(angle) / angle);
    CHECK(weight.dot(reference) == Approx(9.81 * mass * height).epsilon(1e-3));
    // rotary inertia about the centre of the circle
    typename TestType::Coordinates rate = TestType::Coordinates::Zero();
    for (int a = 0; a < 4; ++a) {
        Vector<double, 2> r = reference.template segment<2>(dimension * a);
        if (a % 2 == 0) r[1] -= arc.radius;
        rate[dimension * a] = -r[1];
        rate[dimension * a + 1] = r[0];
    }
    CHECK(rate.dot(element.mass() * rate) == Approx(mass * arc.radius * arc.radius).epsilon(1e-5));
}

TEST_CASE("Cable: pulling a curved element straight ends in no singularity",
          "[element][cable][curved]") {
    const auto element = curved<Cable<3>>(Helix{1.0, 0.0}.coordinates<3>(0.0, cable_length));
    const auto straight = test::reference_coordinates(element);
    const auto evaluation = element.evaluate(straight);
    CHECK(std::isfinite(evaluation.energy));
    CHECK(evaluation.force.allFinite());
    CHECK(evaluation.tangent.allFinite());
    CHECK(evaluation.energy == Approx(0.5 * bending * cable_length).epsilon(0.02));
}

}  // namespace cable_curved_test
