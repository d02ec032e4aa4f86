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

namespace ancf::detail {

/// Returns the determinant of [p, r_y] or [p, r_y, r_z].
template <int Dimension>
[[nodiscard]] double orientation(const Matrix<double, Dimension>& triad) noexcept {
    if constexpr (Dimension == 2) {
        return triad(0, 0) * triad(1, 1) - triad(1, 0) * triad(0, 1);
    } else {
        return triad.col(2).dot(cross<double>(triad.col(0), triad.col(1)));
    }
}

/// Tells whether an element is upright all along: its slopes turn by less than 120 degrees from
/// node to node (their linear interpolation then keeps half of their length), its tangent by less
/// than 90 degrees from seventh to seventh of the element, and there tangent and slopes are longer
/// than 1e-6 and right-handed, det > 1e-6 of the product of their lengths.
///
/// @tparam Line   CubicLine or QuinticLine
/// @param e       finite; [r, r_x, r_y] of both nodes in the plane, with r_z in space; then r_xx of
///                a quintic line
/// @param length  m, that the parameter of the slopes r_x runs through
template <int Dimension, class Line = CubicLine>
[[nodiscard]] bool upright(const Vector<double, 2 * Dimension*(Dimension - 1 + Line::fields)>& e,
                           double length) noexcept {
    using Point = Vector<double, Dimension>;
    constexpr double least = 1e-6;
    constexpr int node = Dimension * (Dimension - 1 + Line::fields);
    const auto at = [&](int first) -> Point { return e.template segment<Dimension>(first); };
    for (int slope = 2; slope <= Dimension; ++slope) {
        const Point first = at(Dimension * slope), last = at(node + Dimension * slope);
        if (!(first.dot(last) > -0.5 * first.norm() * last.norm())) return false;
    }
    Point before = Point::Zero();
    for (int k = 0; k <= line_parts; ++k) {
        const double xi = static_cast<double>(k) / line_parts;
        const auto weights = Line::first(xi, length);
        Point p = weights[0] * (at(node) - at(0)) + weights[1] * at(Dimension) +
                  weights[2] * at(node + Dimension);
        if constexpr (Line::fields > CubicLine::fields)
            p += weights[3] * at(node - Dimension) + weights[4] * at(2 * node - Dimension);
        Matrix<double, Dimension> triad;
        triad.col(0) = p;
        for (int slope = 2; slope <= Dimension; ++slope)
            triad.col(slope - 1) =
                (1.0 - xi) * at(Dimension * slope) + xi * at(node + Dimension * slope);
        double lengths = 1.0;
        for (int c = 0; c < Dimension; ++c) {
            const double norm = triad.col(c).norm();
            if (!(norm > least)) return false;
            lengths *= norm;
        }
        if (!(orientation(triad) > least * lengths)) return false;
        if (k > 0 && !(p.dot(before) > 0.0)) return false;
        before = p;
    }
    return true;
}

}  // namespace ancf::detail
