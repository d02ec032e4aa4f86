// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Constant mass of a straight element whose position is r = r0(x) + y r_y(x) + z r_z(x).
///
/// Source: [Dufva2006, Eqs. 33, 34] for a section of any moments. The centre line is cubic Hermite,
/// the slopes are linear. Every vector pair (f, g) of the nodes contributes a scalar weight times
/// the identity: M = W (x) I.

#pragma once

#include <ancf/element/hermite.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/section/moments.hpp>
#include <ancf/types.hpp>

#include <array>

namespace ancf {

/// Returns the mass weights W = int rho s^T s dV, s the row of shape functions in the order
/// [r, r_x, r_y, r_z]_i, [r, r_x, r_y, r_z]_j cut to the first FieldsPerNode fields of each node.
///
/// FieldsPerNode is 2 for a cable, 3 in the plane, 4 in space.
/// @param density  rho, kg/m^3
/// @param moments  of the section; area, first and second moments are used
/// @param length   l, m
/// @param points   of the integration; 4 are exact for a straight element
/// @param metric   ds/dx as a function of xi, 1 for a straight element
/// @return kg between positions, kg m between a position and a slope, kg m^2 between slopes
template <int FieldsPerNode, class Metric>
[[nodiscard]] Matrix<double, 2 * FieldsPerNode> mass_weights(double density, const Moments& moments,
                                                             double length, int points,
                                                             const Metric& metric) {
    static_assert(FieldsPerNode >= 2 && FieldsPerNode <= 4);
    // Of the shape functions s = (centre line) + y (slopes) + z (slopes), which factor belongs to a
    // field.
    const double section[3][3] = {{moments.area, moments.y, moments.z},
                                  {moments.y, moments.yy, moments.yz},
                                  {moments.z, moments.yz, moments.zz}};
    constexpr int size = 2 * FieldsPerNode;
    Matrix<double, size> weights = Matrix<double, size>::Zero();
    for (const QuadraturePoint& point : gauss_quadrature(points)) {
        const auto line = hermite(point.xi, length);
        const std::array<double, 8> shape{line[0], line[1], 1.0 - point.xi, 1.0 - point.xi,
                                          line[2], line[3], point.xi,       point.xi};
        const double scale = density * length * point.weight * metric(point.xi);
        for (int a = 0; a < size; ++a) {
            for (int b = 0; b < size; ++b) {
                const int field_a = a % FieldsPerNode, field_b = b % FieldsPerNode;
                const double shape_a =
                    shape[static_cast<unsigned>(4 * (a / FieldsPerNode) + field_a)];
                const double shape_b =
                    shape[static_cast<unsigned>(4 * (b / FieldsPerNode) + field_b)];
                const int factor_a = field_a < 2 ? 0 : field_a - 1,
                          factor_b = field_b < 2 ? 0 : field_b - 1;
                weights(a, b) += scale * section[factor_a][factor_b] * shape_a * shape_b;
            }
        }
    }
    return weights;
}

/// Returns the mass weights of a straight element.
template <int FieldsPerNode>
[[nodiscard]] Matrix<double, 2 * FieldsPerNode> mass_weights(double density, const Moments& moments,
                                                             double length) {
    return mass_weights<FieldsPerNode>(density, moments, length, 4, [](double) { return 1.0; });
}

/// Returns the mass matrix M = W (x) I of Dimension-vectors from its weights.
template <int Dimension, int Vectors>
[[nodiscard]] Matrix<double, Dimension * Vectors> mass_matrix(
    const Matrix<double, Vectors>& weights) {
    Matrix<double, Dimension* Vectors> mass = Matrix<double, Dimension * Vectors>::Zero();
    for (int a = 0; a < Vectors; ++a) {
        for (int b = 0; b < Vectors; ++b) {
            for (int k = 0; k < Dimension; ++k)
                mass(Dimension * a + k, Dimension * b + k) = weights(a, b);
        }
    }
    return mass;
}

/// Returns the nodal force of gravity: M times the coordinates whose positions are g and whose
/// slopes are 0.
/// @param weights  mass weights, the positions at rows 0 and Vectors/2
/// @param g        acceleration of gravity, m/s^2
/// @return N for positions, N m for slopes
template <int Dimension, int Vectors>
[[nodiscard]] Vector<double, Dimension * Vectors> gravity_force(
    const Matrix<double, Vectors>& weights, const Vector<double, Dimension>& g) {
    Vector<double, Dimension * Vectors> force;
    for (int a = 0; a < Vectors; ++a) {
        force.template segment<Dimension>(Dimension * a) =
            (weights(a, 0) + weights(a, Vectors / 2)) * g;
    }
    return force;
}

}  // namespace ancf
