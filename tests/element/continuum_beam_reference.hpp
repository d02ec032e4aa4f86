// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The continuum beam straight from its definition: volume points, full tensors, no closed form.

#pragma once

#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/section/material.hpp>
#include <ancf/types.hpp>

namespace ancf::test {

/// A rectangle of given sides whose lower corner lies at (y, z), with two shear correction factors.
struct Brick {
    double length, height, width;  ///< along x, y, z
    double y, z;                   ///< of the lower corner
    double k_y, k_z;
    Material material;
    ContinuumMaterial law;
};

/// Returns the deformation gradient [dr/dx, dr/dy, dr/dz] of the shape functions S1 to S8.
inline Matrix<double, 3> deformation_gradient(const Vector<double, 24>& e, double length, double x,
                                              double y, double z) {
    const double xi = x / length;
    const double d1 = (-6.0 * xi + 6.0 * xi * xi) / length, d2 = 1.0 - 4.0 * xi + 3.0 * xi * xi;
    const double d6 = -2.0 * xi + 3.0 * xi * xi;
    const auto vector = [&](int i) { return Vector<double, 3>(e.segment<3>(3 * i)); };
    Matrix<double, 3> f;
    f.col(0) = d1 * (vector(0) - vector(4)) + d2 * vector(1) + d6 * vector(5) +
               y / length * (vector(6) - vector(2)) + z / length * (vector(7) - vector(3));
    f.col(1) = (1.0 - xi) * vector(2) + xi * vector(6);
    f.col(2) = (1.0 - xi) * vector(3) + xi * vector(7);
    return f;
}

/// Returns the second Piola-Kirchhoff stress of a Green strain by Hooke's law (shear correction on
/// xy and xz) or by the diagonal law.
inline Matrix<double, 3> brick_stress(const Brick& brick, const Matrix<double, 3>& strain,
                                      bool hooke) {
    const double young = brick.material.young, mu = brick.material.shear;
    const double nu = young / (2.0 * mu) - 1.0;
    const double lambda = young * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
    Matrix<double, 3> stress;
    if (hooke) {
        stress = lambda * strain.trace() * Matrix<double, 3>::Identity() + 2.0 * mu * strain;
    } else {
        stress = (brick.k_y + brick.k_z) * mu * strain;
        for (int i = 0; i < 3; ++i) stress(i, i) = young * strain(i, i);
    }
    stress(0, 1) = stress(1, 0) = 2.0 * brick.k_y * mu * strain(0, 1);
    stress(0, 2) = stress(2, 0) = 2.0 * brick.k_z * mu * strain(0, 2);
    return stress;
}

/// Returns the strain energy density S : E/2.
inline double brick_density(const Brick& brick, const Matrix<double, 3>& f, bool hooke) {
    const Matrix<double, 3> strain = 0.5 * (f.transpose() * f - Matrix<double, 3>::Identity());
    return 0.5 * brick_stress(brick, strain, hooke).cwiseProduct(strain).sum();
}

/// Returns the strain energy by 4 Gauss points along the axis and 4 x 4, which are exact, across.
inline double brick_energy(const Brick& brick, const Vector<double, 24>& e) {
    const double area = brick.height * brick.width;
    const double y_c = brick.y + brick.height / 2.0, z_c = brick.z + brick.width / 2.0;
    const Quadrature points = gauss_quadrature(4);
    double energy = 0.0;
    for (const auto& [xi, weight] : points) {
        const double x = xi * brick.length;
        double density = 0.0;
        for (const auto& [eta, weight_y] : points)
            for (const auto& [zeta, weight_z] : points) {
                const auto f = deformation_gradient(
                    e, brick.length, x, brick.y + eta * brick.height, brick.z + zeta * brick.width);
                density += weight_y * weight_z *
                           brick_density(brick, f, brick.law == ContinuumMaterial::hooke);
            }
        if (brick.law == ContinuumMaterial::enhanced) {
            const auto f = deformation_gradient(e, brick.length, x, y_c, z_c);
            density += brick_density(brick, f, true) - brick_density(brick, f, false);
        }
        energy += weight * brick.length * area * density;
    }
    return energy;
}

/// Returns the library's element of the same body.
inline ContinuumBeam<3> element_of(const Brick& brick, const Rule& rule = Rule::paper()) {
    const Section section =
        offset(rectangle(brick.width, brick.height).with_shear_correction(brick.k_y, brick.k_z),
               brick.y + brick.height / 2.0, brick.z + brick.width / 2.0);
    return {brick.material, section, brick.length, {rule, brick.law}};
}

/// Returns a body with no symmetry: off its axis, two shear correction factors.
inline Brick odd_brick(ContinuumMaterial law) {
    return {0.7, 0.2, 0.1, -0.08, -0.03, 0.8, 0.9, Material::isotropic(2e7, 0.3, 7800.0), law};
}

/// Returns the same body with its centre on the axis.
inline Brick centred_brick(ContinuumMaterial law) {
    return {0.7, 0.2, 0.1, -0.1, -0.05, 0.8, 0.9, Material::isotropic(2e7, 0.3, 7800.0), law};
}

}  // namespace ancf::test
