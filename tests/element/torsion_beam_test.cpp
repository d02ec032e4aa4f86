// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The torsion beam: the properties of every element, closed forms, and its limits.

#include <ancf/constants.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/section/section.hpp>

#include <element/mixed_checks.hpp>
#include <element/property_checks.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/dense.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace torsion_beam_test {

using namespace ancf;

constexpr double density = 7800.0, range = 0.7;

Material sample_material() { return Material::from_moduli(2e7, 0.8e7, density); }
Section sample_section() { return rectangle(0.1, 0.2); }

TorsionBeam sample(const char* rule = "mixed") {
    return {sample_material(), sample_section(), range, {Rule::named(rule)}};
}

/// What the mass knows of the section: the polar moment, all of it on r_y.
Moments polar_moments() {
    const Moments m = sample_section().moments();
    Moments polar;
    polar.area = m.area;
    polar.yy = m.yy + m.zz;
    return polar;
}

/// The ends' positions and frames as coordinates.
TorsionBeam::Coordinates coordinates(const Vector<double, 3>& end, const Matrix<double, 3>& frame) {
    TorsionBeam::Coordinates e = TorsionBeam::Coordinates::Zero();
    e[3] = e[7] = 1.0;
    e.segment<3>(9) = end;
    e.segment<3>(12) = frame.col(0);
    e.segment<3>(15) = frame.col(1);
    return e;
}

/// Twisted, bent, skew and distorted references.
std::vector<TorsionBeam::Coordinates> references() {
    using V = Vector<double, 3>;
    test::Random random(3);
    std::vector<TorsionBeam::Coordinates> all{
        coordinates({range, 0, 0}, test::rotation(V(0.7, 0, 0))),
        coordinates({std::sin(range), 1.0 - std::cos(range), 0}, test::rotation(V(0, 0, range))),
        coordinates({0.8 * range, 0.3 * range, -0.35 * range}, test::rotation(V(0.5, 0.6, 0.4)))};
    all.push_back(all[2] + 0.1 * random.vector<18>());
    return all;
}

TEST_CASE("torsion beam: it has the properties of every element",
          "[element][torsion][properties]") {
    for (const char* rule : {"mixed", "paper", "lobatto3"}) {
        INFO("rule " << rule);
        const auto element = sample(rule);
        test::check_zero_at_rest(element);
        test::check_rigid_invariance(element);
        test::check_derivatives(element);
        test::check_zero_modes(element);
        test::check_turning(element);
        test::check_mass(element, density, polar_moments());
        test::check_gravity(element, density, polar_moments());
        test::check_planar(element);
    }
    test::check_admissible(sample());
}

TEST_CASE(
    "torsion beam: a curved or twisted reference has no force, six free motions and exact "
    "derivatives",
    "[element][torsion][curved]") {
    const double axial = sample_material().young * sample_section().moments().area;
    double force = 0.0, derivative = 0.0, rigid = 0.0, least = 1.0;
    for (const auto& reference : references()) {
        const TorsionBeam element(sample_material(), sample_section(), reference, range);
        TorsionBeam::Coordinates scale = TorsionBeam::Coordinates::Constant(1.0 / range);
        scale.segment<3>(0).setOnes();
        scale.segment<3>(9).setOnes();
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            test::Random random(seed);
            const auto turn = test::random_rotation<3>(random);
            const Vector<double, 3> shift = range * random.vector<3>();
            const auto moved = test::moved<TorsionBeam>(reference, turn, shift);
            force = std::max(force, element.force(moved).norm() / axial);
            const Matrix<double, 18> tangent =
                scale.asDiagonal() * element.evaluate(moved).tangent * scale.asDiagonal();
            VectorX values = test::eigenvalues(tangent);
            values /= values.maxCoeff();
            rigid = std::max(rigid, values.head(6).cwiseAbs().maxCoeff());
            least = std::min(least, values(6));
            const TorsionBeam::Coordinates bent = reference + 0.15 * random.vector<18>();
            const auto e = test::moved<TorsionBeam>(bent, turn, shift);
            const auto evaluation = element.evaluate(e);
            derivative = std::max(
                {derivative,
                 test::relative_error(evaluation.force,
                                      test::complex_step_gradient(
                                          [&](const auto& z) { return element.energy(z); }, e)),
                 test::relative_error(evaluation.tangent,
                                      test::complex_step_jacobian(
                                          [&](const auto& z) { return element.force(z); }, e))});
        }
    }
    CHECK(force <= 1e-13);  // asked for 1e-12
    CHECK(derivative <= 1e-12);
    CHECK(rigid <= 1e-13);
    CHECK(least >= 1e-5);
}

TEST_CASE("torsion beam: uniform bending about any axis and uniform twist are exact",
          "[element][torsion]") {
    const auto element = sample("paper");
    const double E = sample_material().young,
                 GJ = sample_material().shear * sample_section().torsion_constant();
    const Moments m = sample_section().moments();
    // small, so that the Hermite line is the arc to (angle)^4/720
    const double angle = 0.02;
    const double skew = GENERATE(0.0, 0.5, 0.785398, 1.3);
    const Vector<double, 3> axis(0.0, std::sin(skew), std::cos(skew));
    const Vector<double, 3> inward = cross(axis, Vector<double, 3>(1, 0, 0));
    const double radius = range / angle;
    const auto bent = coordinates(
        radius * (std::sin(angle) * Vector<double, 3>(1, 0, 0) + (1.0 - std::cos(angle)) * inward),
        test::rotation(angle * axis));
    const double k = angle / range;
    const double EI =
        E * (m.yy * std::cos(skew) * std::cos(skew) + m.zz * std::sin(skew) * std::sin(skew));
    CHECK(element.energy(bent) == Approx(0.5 * EI * k * k * range).epsilon(1e-5));
    CHECK(element.section_forces(bent, 0.3).moment_z ==
          Approx(E * m.yy * k * std::cos(skew)).epsilon(1e-4));
    CHECK(element.section_forces(bent, 0.3).moment_y ==
          Approx(E * m.zz * k * std::sin(skew)).margin(1e-4 * E * m.zz * k));
    const double turn = 2.5, om = turn / range;
    const auto twisted = coordinates({range, 0, 0}, test::rotation(Vector<double, 3>(turn, 0, 0)));
    CHECK(element.energy(twisted) == Approx(0.5 * GJ * om * om * range).epsilon(1e-13));
    CHECK(element.section_forces(twisted, 0.6).torque == Approx(GJ * om).epsilon(1e-13));
    CHECK(element.admissible(twisted));
    for (const double beyond : {2.7, pi, 3.5})
        CHECK_FALSE(element.admissible(
            coordinates({range, 0, 0}, test::rotation(Vector<double, 3>(beyond, 0, 0)))));
    CHECK(element.stress(bent, 0.3, 0.05)[0] ==
          Approx(-E * 0.05 * k * std::cos(skew)).epsilon(2e-3).margin(1e-3 * E * k));
}

TEST_CASE("torsion beam: the mixed tangent has the stresses of linearised strains",
          "[element][torsion][tangent]") {
    test::check_mixed_tangent(sample());
}

TEST_CASE("torsion beam: places, their derivatives and velocities agree", "[element][torsion]") {
    const auto element = sample();
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        test::Random random(seed);
        const auto e = test::random_state(element, random);
        const double xi = random.uniform(0.0, 1.0), y = 0.04, z = -0.07;
        const auto jacobian = test::complex_step_jacobian(
            [&](const auto& s) { return element.position(s, xi, y, z); }, e);
        CHECK(test::relative_error(element.position_jacobian(e, xi, y, z), jacobian) <= 1e-13);
        const TorsionBeam::Coordinates rate = random.vector<18>();
        CHECK((element.velocity(e, rate, xi, y, z) - jacobian * rate).norm() <= 1e-13);
        const Matrix<double, 3, 2> d = element.directors(e, xi);
        CHECK((d.transpose() * d - Matrix<double, 2>::Identity()).norm() <= 1e-14);
    }
    const auto rest = test::reference_coordinates(element);
    CHECK((element.position(rest, 0.25, 0.03, 0.02) - Vector<double, 3>(0.25 * range, 0.03, 0.02))
              .norm() <= 1e-15);
}

TEST_CASE("torsion beam: what it cannot be made of is refused", "[element][torsion][bad-input]") {
    const Material m = sample_material();
    CHECK_THROWS_AS(TorsionBeam(m, sample_section(), 0.0), InvalidArgument);
    CHECK_THROWS_AS(TorsionBeam(m, sample_section(), -1.0), InvalidArgument);
    CHECK_THROWS_AS(TorsionBeam(m, offset(sample_section(), 0.01, 0.0), range), InvalidArgument);
    CHECK_THROWS_AS(TorsionBeam(m, offset(sample_section(), 0.0, 0.01), range), InvalidArgument);
    CHECK_THROWS_AS(TorsionBeam(m, sample_section(), range, {Rule::gauss(2)}), InvalidArgument);
    auto broken = references()[0];
    broken.segment<3>(15) = broken.segment<3>(12);
    CHECK_THROWS_AS(TorsionBeam(m, sample_section(), broken, range), InvalidArgument);
    broken[3] = std::nan("");
    CHECK_THROWS_AS(TorsionBeam(m, sample_section(), broken, range), InvalidArgument);
}

}  // namespace torsion_beam_test
