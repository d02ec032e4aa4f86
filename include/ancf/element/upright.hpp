// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Whether the coordinates of a shear-deformable element make a beam at all.
///
/// The energy is an integral by stations; it cannot see what happens between them. A slope that
/// turns over inside an element leaves no strain at the stations, and Newton's method finds such
/// states.

#pragma once

#include <ancf/element/hermite.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>

namespace ancf::detail {

/// Returns the determinant of the columns [p, r_y] or [p, r_y, r_z].
[[nodiscard]] inline double orientation(const double (&v)[2][2]) noexcept {
    return v[0][0] * v[1][1] - v[0][1] * v[1][0];
}
[[nodiscard]] inline double orientation(const double (&v)[3][3]) noexcept {
    return v[2][0] * (v[0][1] * v[1][2] - v[0][2] * v[1][1]) +
           v[2][1] * (v[0][2] * v[1][0] - v[0][0] * v[1][2]) +
           v[2][2] * (v[0][0] * v[1][1] - v[0][1] * v[1][0]);
}

/// Tells whether an element is upright all along: its slopes turn by less than 120 degrees from
/// node to node (their linear interpolation then keeps half of their length), its tangent by less
/// than 90 degrees from seventh to seventh of the element, and there tangent and slopes are longer
/// than 1e-6 and right-handed, det > 1e-6 of the product of their lengths.
///
/// @tparam Line   CubicLine or QuinticLine
/// @param e       finite; [r, r_x, r_y] of both nodes in the plane, with r_z in space; r_xx of a
///                quintic line is the last of a node
/// @param length  m, that the parameter of the slopes r_x runs through
template <int Dimension, class Line = CubicLine, int Dofs>
[[nodiscard]] bool upright(const Vector<double, Dofs>& e, double length) noexcept {
    static_assert(Dofs >= 2 * Dimension * (Dimension - 1 + Line::fields));
    constexpr double least = 1e-6;
    constexpr int node = Dofs / 2;
    const auto product = [](const double* a, const double* b) {
        double sum = 0.0;
        for (int i = 0; i < Dimension; ++i) sum += a[i] * b[i];
        return sum;
    };
    const auto size = [&](const double* a) { return std::sqrt(product(a, a)); };
    for (int slope = 2; slope <= Dimension; ++slope) {
        const double *first = e.data() + Dimension * slope, *last = first + node;
        if (!(product(first, last) > -0.5 * size(first) * size(last))) return false;
    }
    double before[Dimension] = {};
    for (int k = 0; k <= line_parts; ++k) {
        const double xi = static_cast<double>(k) / line_parts;
        const auto weights = Line::first(xi, length);
        double triad[Dimension][Dimension];  // columns
        for (int i = 0; i < Dimension; ++i) {
            double& p = triad[0][i];
            p = weights[0] * (e[node + i] - e[i]) + weights[1] * e[Dimension + i] +
                weights[2] * e[node + Dimension + i];
            if constexpr (Line::fields > CubicLine::fields)
                p +=
                    weights[3] * e[node - Dimension + i] + weights[4] * e[2 * node - Dimension + i];
            for (int slope = 2; slope <= Dimension; ++slope)
                triad[slope - 1][i] =
                    (1.0 - xi) * e[Dimension * slope + i] + xi * e[node + Dimension * slope + i];
        }
        double lengths = 1.0;
        for (const auto& column : triad) {
            const double norm = size(column);
            if (!(norm > least)) return false;
            lengths *= norm;
        }
        if (!(orientation(triad) > least * lengths)) return false;
        if (k > 0 && !(product(triad[0], before) > 0.0)) return false;
        std::copy_n(triad[0], Dimension, before);
    }
    return true;
}

}  // namespace ancf::detail
