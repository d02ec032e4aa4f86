// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Constant mass of a straight element whose position is r = r0(x) + y r_y(x) + z r_z(x).
///
/// Source: [Dufva2006, Eqs. 33, 34] for a section of any moments. The centre line is Hermite's, of
/// third or fifth degree, the slopes across are linear. Every vector pair (f, g) of the nodes
/// contributes a scalar weight times the identity: M = W (x) I.

#pragma once

#include <ancf/element/hermite.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/section/moments.hpp>
#include <ancf/types.hpp>

namespace ancf {

/// How the inertia of turning sections is spread: int rho (y r_y + z r_z)^2 dV.
enum class RotaryInertia {
    consistent,  ///< of slopes interpolated linearly, [Dufva2006, Eq. 34]
    /// By the trapezoidal rule, at the nodes. Slopes between nodes turn with the centre line, not
    /// linearly: where rotary inertia counts, frequencies are far closer than with the other, until
    /// the meshes are fine. docs/theory-modal.md.
    lumped
};

/// Returns the mass weights W = int rho s^T s dV, s the row of shape functions in the order
/// [r, r_x, r_y, r_z]_i, [r, r_x, r_y, r_z]_j cut to the first FieldsPerNode fields of each node;
/// slopes with rates have r_xy after them, a quintic line r_xx last.
///
/// FieldsPerNode, r_xy and r_xx not counted, is 2 for a cable, 3 in the plane, 4 in space.
/// @tparam Rates  whether r_y is cubic, by its rates r_xy: in the plane
/// @param density  rho, kg/m^3
/// @param moments  of the section; area, first and second moments are used
/// @param length   l, m
/// @param points   of the integration; 4, for a quintic 6, are exact for a straight element
/// @param metric   ds/dx as a function of xi, 1 for a straight element
/// @return kg between positions, times m for each slope and m^2 for each rate of a pair
template <int FieldsPerNode, class Line = CubicLine, bool Rates = false, class Metric>
[[nodiscard]] auto mass_weights(double density, const Moments& moments, double length, int points,
                                const Metric& metric) {
    static_assert(FieldsPerNode >= 2 && FieldsPerNode <= 4 && (!Rates || FieldsPerNode == 3));
    // integrals of the products of 1, y and z over the section
    const double section[3][3] = {{moments.area, moments.y, moments.z},
                                  {moments.y, moments.yy, moments.yz},
                                  {moments.z, moments.yz, moments.zz}};
    constexpr int before = FieldsPerNode + (Rates ? 1 : 0);  // of r_xx
    constexpr int fields = before + Line::fields - CubicLine::fields;
    constexpr int size = 2 * fields;
    Matrix<double, size> weights = Matrix<double, size>::Zero();
    for (const QuadraturePoint& point : gauss_quadrature(points)) {
        const auto line = Line::value(point.xi, length);
        double shape[size];
        for (int node = 0; node < 2; ++node) {
            double* const of_node = shape + node * fields;
            of_node[0] = node == 0 ? 1.0 - line[0] : line[0];
            of_node[1] = line[1 + static_cast<unsigned>(node)];
            for (int slope = 2; slope < FieldsPerNode; ++slope)
                of_node[slope] = node == 0 ? 1.0 - point.xi : point.xi;
            if constexpr (Rates) {
                const auto cubic = hermite(point.xi, length);
                of_node[2] = cubic[2 * static_cast<unsigned>(node)];
                of_node[3] = cubic[1 + 2 * static_cast<unsigned>(node)];
            }
            if constexpr (fields > before) of_node[before] = line[3 + static_cast<unsigned>(node)];
        }
        // which of 1, y and z a field is multiplied by
        const auto factor = [](int field) {
            return field < 2 || field == before ? 0 : Rates ? 1 : field - 1;
        };
        const double scale = density * length * point.weight * metric(point.xi);
        for (int a = 0; a < size; ++a)
            for (int b = 0; b < size; ++b)
                weights(a, b) +=
                    scale * section[factor(a % fields)][factor(b % fields)] * shape[a] * shape[b];
    }
    return weights;
}

/// Returns the mass weights of a straight element.
template <int FieldsPerNode, class Line = CubicLine, bool Rates = false>
[[nodiscard]] auto mass_weights(double density, const Moments& moments, double length) {
    return mass_weights<FieldsPerNode, Line, Rates>(density, moments, length, Line::vectors + 1,
                                                    [](double) { return 1.0; });
}

/// Moves the weights between slopes across of different nodes to the node of their row:
/// RotaryInertia::lumped. Those of each node add up to what they did.
template <int FieldsPerNode, int Size>
void lump_rotary_inertia(Matrix<double, Size>& weights) {
    constexpr int fields = Size / 2;
    for (int a = 0; a < Size; ++a) {
        const int own = a - a % fields, other = fields - own;
        if (a % fields < 2 || a % fields >= FieldsPerNode) continue;
        for (int field = 2; field < FieldsPerNode; ++field) {
            weights(a, own + field) += weights(a, other + field);
            weights(a, other + field) = 0.0;
        }
    }
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
        const double mass = weights(a, 0) + weights(a, Vectors / 2);
        for (int i = 0; i < Dimension; ++i) force[Dimension * a + i] = mass * g[i];
    }
    return force;
}

}  // namespace ancf
