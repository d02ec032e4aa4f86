// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Interpolation along the element: cubic or quintic Hermite for the centre line, linear for the
/// slopes across.
///
/// Source: [Dufva2006, Eqs. 3, 4]; the quintic is docs/theory-quintic.md. With xi = x/l in [0, 1];
/// derivatives are with respect to x.

#pragma once

#include <array>

namespace ancf {

namespace detail {

/// Into how many parts an element is cut where its line is looked at between stations; an odd
/// number: the middle of a fold lies inside a part.
inline constexpr int line_parts = 7;

}  // namespace detail

/// Weights of (r_i, r_x,i, r_j, r_x,j) in the centre line r0(x), or in one of its derivatives.
using HermiteWeights = std::array<double, 4>;

/// Returns the weights of r0; those of the slopes are lengths, m.
[[nodiscard]] constexpr HermiteWeights hermite(double xi, double length) noexcept {
    return {1.0 - xi * xi * (3.0 - 2.0 * xi), length * xi * (1.0 - xi) * (1.0 - xi),
            xi * xi * (3.0 - 2.0 * xi), length * xi * xi * (xi - 1.0)};
}

/// Returns the weights of dr0/dx; those of the positions are 1/m.
[[nodiscard]] constexpr HermiteWeights hermite_first(double xi, double length) noexcept {
    const double bubble = 6.0 * xi * (1.0 - xi) / length;
    return {-bubble, (1.0 - xi) * (1.0 - 3.0 * xi), bubble, xi * (3.0 * xi - 2.0)};
}

/// Returns the weights of d2r0/dx2; those of the positions are 1/m^2, those of the slopes 1/m.
[[nodiscard]] constexpr HermiteWeights hermite_second(double xi, double length) noexcept {
    const double line = (6.0 - 12.0 * xi) / (length * length);
    return {-line, (6.0 * xi - 4.0) / length, line, (6.0 * xi - 2.0) / length};
}

/// A cubic centre line, by the positions and slopes r_x of its ends: [Dufva2006, Eq. 3].
///
/// Its weights belong to (D, g_i, g_j), D = r_j - r_i and g = r_x.
struct CubicLine {
    static constexpr int vectors = 3;             ///< that weights belong to
    static constexpr int fields = 2;              ///< of a node: r, r_x
    using Weights = std::array<double, vectors>;  ///< of one derivative

    /// Returns the weights of r0 - r_i; those of the slopes are lengths, m.
    [[nodiscard]] static constexpr Weights value(double xi, double length) noexcept {
        const auto w = hermite(xi, length);
        return {w[2], w[1], w[3]};
    }
    /// Returns the weights of dr0/dx; that of D is 1/m.
    [[nodiscard]] static constexpr Weights first(double xi, double length) noexcept {
        const auto w = hermite_first(xi, length);
        return {w[2], w[1], w[3]};
    }
    /// Returns the weights of d2r0/dx2; that of D is 1/m^2, those of the slopes 1/m.
    [[nodiscard]] static constexpr Weights second(double xi, double length) noexcept {
        const auto w = hermite_second(xi, length);
        return {w[2], w[1], w[3]};
    }
};

/// A quintic centre line, by positions, slopes r_x and second derivatives r_xx of its ends.
///
/// Its weights belong to (D, g_i, g_j, k_i, k_j), k = r_xx.
struct QuinticLine {
    static constexpr int vectors = 5;             ///< that weights belong to
    static constexpr int fields = 3;              ///< of a node: r, r_x, r_xx
    using Weights = std::array<double, vectors>;  ///< of one derivative

    /// Returns the weights of r0 - r_i: lengths for the slopes, squares of them for r_xx.
    [[nodiscard]] static constexpr Weights value(double xi, double length) noexcept {
        const double x = xi, x2 = x * x, x3 = x2 * x, rest = 1.0 - x, rest3 = rest * rest * rest;
        const double square = 0.5 * length * length;
        return {x3 * (10.0 - x * (15.0 - 6.0 * x)), length * x * rest3 * (1.0 + 3.0 * x),
                -length * x3 * rest * (4.0 - 3.0 * x), square * x2 * rest3,
                square * x3 * rest * rest};
    }
    /// Returns the weights of dr0/dx; that of D is 1/m, those of r_xx are lengths.
    [[nodiscard]] static constexpr Weights first(double xi, double length) noexcept {
        const double x = xi, rest = 1.0 - x, bubble = x * x * rest * rest;
        return {30.0 * bubble / length, rest * rest * (1.0 + x * (2.0 - 15.0 * x)),
                -x * x * (12.0 - x * (28.0 - 15.0 * x)),
                0.5 * length * x * rest * rest * (2.0 - 5.0 * x),
                0.5 * length * x * x * rest * (3.0 - 5.0 * x)};
    }
    /// Returns the weights of d2r0/dx2; that of D is 1/m^2, those of the slopes 1/m.
    [[nodiscard]] static constexpr Weights second(double xi, double length) noexcept {
        const double x = xi, rest = 1.0 - x;
        return {60.0 * x * rest * (1.0 - 2.0 * x) / (length * length),
                -12.0 * x * rest * (3.0 - 5.0 * x) / length,
                -12.0 * x * rest * (2.0 - 5.0 * x) / length, rest * (1.0 - x * (8.0 - 10.0 * x)),
                x * (3.0 - x * (12.0 - 10.0 * x))};
    }
};

}  // namespace ancf
