// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the continuum beam reports at a point and of a section, against the definitions.

#include <ancf/element/continuum/beam.hpp>

#include <element/continuum_beam_reference.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <Eigen/Geometry>

#include <cmath>
#include <iterator>

namespace continuum_beam_results_test {

using namespace ancf;
using test::Brick;
using Vector3 = Vector<double, 3>;

constexpr ContinuumMaterial all_laws[] = {ContinuumMaterial::diagonal, ContinuumMaterial::hooke,
                                          ContinuumMaterial::enhanced};

/// Returns a symmetric tensor as [xx, yy, zz, yz, xz, xy], the last three times `factor`.
Vector<double, 6> listed(const Matrix<double, 3>& t, double factor) {
    Vector<double, 6> list;
    list << t(0, 0), t(1, 1), t(2, 2), factor * t(1, 2), factor * t(0, 2), factor * t(0, 1);
    return list;
}

Matrix<double, 3> green(const Matrix<double, 3>& f) {
    return 0.5 * (f.transpose() * f - Matrix<double, 3>::Identity());
}

TEST_CASE("ContinuumBeam: position is r0 + y r_y + z r_z and its Jacobian the derivative",
          "[element][continuum][results]") {
    const auto element = test::element_of(test::odd_brick(ContinuumMaterial::diagonal));
    test::Random random(3);
    const Vector<double, 24> e = test::random_state(element, random);
    const Vector<double, 24> rate = test::random_state(element, random);
    const double y = 0.07, z = -0.04;
    CHECK((element.position(e, 0.0, y, z) -
           (e.segment<3>(0) + y * e.segment<3>(6) + z * e.segment<3>(9)))
              .norm() <= 1e-15);
    CHECK((element.position(e, 1.0, y, z) -
           (e.segment<3>(12) + y * e.segment<3>(18) + z * e.segment<3>(21)))
              .norm() <= 1e-15);
    const double xi = 0.3, step = 1e-5;
    const Matrix<double, 3> f = test::deformation_gradient(e, 0.7, xi * 0.7, y, z);
    Matrix<double, 3> slopes;
    slopes.col(0) = (element.position(e, xi + step, y, z) - element.position(e, xi - step, y, z)) /
                    (2.0 * step * 0.7);
    slopes.col(1) = (element.position(e, xi, y + step, z) - element.position(e, xi, y - step, z)) /
                    (2.0 * step);
    slopes.col(2) = (element.position(e, xi, y, z + step) - element.position(e, xi, y, z - step)) /
                    (2.0 * step);
    CHECK((slopes - f).norm() <= 1e-8);  // central difference
    CHECK((element.directors(e, xi) - f.rightCols<2>()).norm() <= 1e-14);

    // Linear in e: the Jacobian gives the value itself and the velocity.
    CHECK((element.position_jacobian(e, xi, y, z) * e - element.position(e, xi, y, z)).norm() <=
          1e-15);
    CHECK((element.velocity(e, rate, xi, y, z) - element.position(rate, xi, y, z)).norm() <= 1e-15);
    const auto axis = element.position_jacobian(e, xi);
    const Vector<double, 3> d_y = (element.position_jacobian(e, xi, 1.0, 0.0) - axis) * e,
                            d_z = (element.position_jacobian(e, xi, 0.0, 1.0) - axis) * e;
    CHECK((d_y - f.col(1)).norm() + (d_z - f.col(2)).norm() <= 1e-14);
}

TEST_CASE("ContinuumBeam: strain and stress at a point equal the tensors of the definition",
          "[element][continuum][results]") {
    const auto law = GENERATE(from_range(std::begin(all_laws), std::end(all_laws)));
    INFO(to_string(law));
    const Brick brick = test::odd_brick(law);
    const auto element = test::element_of(brick);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        test::Random random(seed);
        const Vector<double, 24> e = test::random_state(element, random);
        const double xi = random.uniform(0.0, 1.0), y = random.uniform(-0.1, 0.1),
                     z = random.uniform(-0.1, 0.1);
        const Matrix<double, 3> strain =
            green(test::deformation_gradient(e, brick.length, xi * brick.length, y, z));
        Matrix<double, 3> stress =
            test::brick_stress(brick, strain, law == ContinuumMaterial::hooke);
        if (law == ContinuumMaterial::enhanced) {
            const Matrix<double, 3> axis = green(test::deformation_gradient(
                e, brick.length, xi * brick.length, brick.y + brick.height / 2.0,
                brick.z + brick.width / 2.0));
            stress +=
                test::brick_stress(brick, axis, true) - test::brick_stress(brick, axis, false);
        }
        CHECK((element.green_strain(e, xi, y, z) - listed(strain, 2.0)).norm() <=
              1e-13 * strain.norm());
        CHECK((element.stress(e, xi, y, z) - listed(stress, 1.0)).norm() <= 1e-13 * stress.norm());
    }
}

TEST_CASE("ContinuumBeam: section forces are the resultants of the traction F S e_x",
          "[element][continuum][results]") {
    const auto law = GENERATE(from_range(std::begin(all_laws), std::end(all_laws)));
    INFO(to_string(law));
    const Brick brick = test::odd_brick(law);
    const auto element = test::element_of(brick);
    const double area = brick.height * brick.width;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        test::Random random(seed);
        const Vector<double, 24> e = test::random_state(element, random);
        const double x = random.uniform(0.0, 1.0) * brick.length;
        Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
        const auto add = [&](double weight, double y, double z, bool hooke) {
            const Matrix<double, 3> f = test::deformation_gradient(e, brick.length, x, y, z);
            const Vector3 traction = f * test::brick_stress(brick, green(f), hooke).col(0);
            force += weight * traction;
            moment += weight * Vector3(y * f.col(1) + z * f.col(2)).cross(traction);
        };
        for (const auto& [eta, weight_y] : gauss_quadrature(4))
            for (const auto& [zeta, weight_z] : gauss_quadrature(4))
                add(weight_y * weight_z * area, brick.y + eta * brick.height,
                    brick.z + zeta * brick.width, law == ContinuumMaterial::hooke);
        if (law == ContinuumMaterial::enhanced) {
            add(area, brick.y + brick.height / 2.0, brick.z + brick.width / 2.0, true);
            add(-area, brick.y + brick.height / 2.0, brick.z + brick.width / 2.0, false);
        }
        const SectionForces at = element.section_forces(e, x / brick.length);
        const Matrix<double, 3> axis = test::deformation_gradient(e, brick.length, x, 0.0, 0.0);
        const Vector3 t = axis.col(0).normalized();
        CHECK(at.axial == Approx(force.dot(t)).epsilon(1e-10));
        CHECK(at.torque == Approx(moment.dot(t)).epsilon(1e-10).margin(1e-10 * moment.norm()));
        CHECK(std::hypot(at.axial, at.shear_y, at.shear_z) == Approx(force.norm()).epsilon(1e-12));
        CHECK(std::hypot(at.torque, at.moment_y, at.moment_z) ==
              Approx(moment.norm()).epsilon(1e-12));
        CHECK(
            at.shear_y * at.moment_y + at.shear_z * at.moment_z + at.axial * at.torque ==
            Approx(force.dot(moment)).epsilon(1e-10).margin(1e-10 * force.norm() * moment.norm()));
    }
}

TEST_CASE("ContinuumBeam: section forces have the signs of beam theory",
          "[element][continuum][results]") {
    const double side = 0.1, young = 2e7, curvature = 1e-4, length = 0.7;
    const ContinuumBeam<3> element(Material::isotropic(young, 0.3, 7800.0),
                                   rectangle(side, 2.0 * side).with_shear_correction(0.8, 0.9),
                                   length);
    const Vector<double, 24> rest = test::reference_coordinates(element);
    const double inertia_z = side * std::pow(2.0 * side, 3) / 12.0;  // int y^2 dA
    const double inertia_y = std::pow(side, 3) * 2.0 * side / 12.0;  // int z^2 dA

    // The axis bends up, towards +y: fibres at y > 0 shorten.
    Vector<double, 24> e = rest;
    e.segment<3>(12) += Vector3(0.0, curvature * length * length / 2.0, 0.0);
    e(16) = curvature * length;   // r_x
    e(18) = -curvature * length;  // r_y
    CHECK(element.section_forces(e, 0.5).moment_z ==
          Approx(young * inertia_z * curvature).epsilon(1e-3));
    // Towards +z: fibres at z > 0 shorten, int z sigma < 0.
    e = rest;
    e.segment<3>(12) += Vector3(0.0, 0.0, curvature * length * length / 2.0);
    e(17) = curvature * length;
    e(21) = -curvature * length;
    CHECK(element.section_forces(e, 0.5).moment_y ==
          Approx(-young * inertia_y * curvature).epsilon(1e-3));
    // The far end turns from y to z.
    e = rest;
    e(20) = curvature * length;
    e(22) = -curvature * length;
    const double shear = Material::isotropic(young, 0.3, 7800.0).shear;
    CHECK(element.section_forces(e, 0.5).torque ==
          Approx(shear * (0.8 * inertia_y + 0.9 * inertia_z) * curvature).epsilon(1e-3));
    // The far end moves up while the sections stay upright.
    e = rest;
    e.segment<3>(12) += Vector3(0.0, curvature * length, 0.0);
    e(4) = e(16) = curvature;
    CHECK(element.section_forces(e, 0.5).shear_y ==
          Approx(0.8 * shear * 2.0 * side * side * curvature).epsilon(1e-3));
    e = rest;
    e.segment<3>(12) += Vector3(0.0, 0.0, curvature * length);
    e(5) = e(17) = curvature;
    CHECK(element.section_forces(e, 0.5).shear_z ==
          Approx(0.9 * shear * 2.0 * side * side * curvature).epsilon(1e-3));
}

TEST_CASE("ContinuumBeam: in the plane results are those of the spatial element",
          "[element][continuum][results]") {
    const Material material = Material::isotropic(2e7, 0.3, 7800.0);
    const ContinuumBeam<2> plane(material, offset(rectangle(0.1, 0.2), 0.02, 0.0), 0.7);
    const ContinuumBeam<3> space(material, offset(rectangle(0.1, 0.2), 0.02, 0.0), 0.7);
    test::Random random(11);
    const Vector<double, 12> e = test::random_state(plane, random);
    Vector<double, 24> lifted = Vector<double, 24>::Zero();
    for (int vector = 0; vector < 6; ++vector)
        lifted.segment<2>(12 * (vector / 3) + 3 * (vector % 3)) = e.segment<2>(2 * vector);
    lifted(11) = lifted(23) = 1.0;
    const double xi = 0.4, y = 0.05;
    CHECK((plane.position(e, xi, y) - space.position(lifted, xi, y).head<2>()).norm() <= 1e-15);
    CHECK((plane.directors(e, xi).col(0) - space.directors(lifted, xi).col(0).head<2>()).norm() <=
          1e-15);
    const Vector<double, 6> strain = space.green_strain(lifted, xi, y),
                            stress = space.stress(lifted, xi, y);
    CHECK((plane.green_strain(e, xi, y) - Vector3(strain(0), strain(1), strain(5))).norm() <=
          1e-14);
    CHECK((plane.stress(e, xi, y) - Vector3(stress(0), stress(1), stress(5))).norm() <=
          1e-14 * stress.norm());
    const SectionForces flat = plane.section_forces(e, xi),
                        solid = space.section_forces(lifted, xi);
    CHECK(flat.axial == Approx(solid.axial).epsilon(1e-12));
    CHECK(flat.shear_y == Approx(solid.shear_y).epsilon(1e-12));
    CHECK(flat.moment_z == Approx(solid.moment_z).epsilon(1e-12));
    CHECK(plane.admissible(e) == space.admissible(lifted));
}

}  // namespace continuum_beam_results_test
