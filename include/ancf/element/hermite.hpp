// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Interpolation along the element: cubic Hermite for the centre line, linear for the slopes
/// across.
///
/// Source: [Dufva2006, Eqs. 3, 4]. With xi = x/l in [0, 1]; derivatives are with respect to x.

#pragma once

#include <array>

namespace ancf {

/// Weights of (r_i, r_x,i, r_j, r_x,j) in the centre line r0(x), or in one of its derivatives.
template <class Scalar = double>
using HermiteWeights = std::array<Scalar, 4>;

/// Returns the weights of r0; those of the slopes are lengths, m.
template <class Scalar>
[[nodiscard]] constexpr HermiteWeights<Scalar> hermite(Scalar xi, Scalar length) noexcept {
    return {1.0 - xi * xi * (3.0 - 2.0 * xi), length * xi * (1.0 - xi) * (1.0 - xi),
            xi * xi * (3.0 - 2.0 * xi), length * xi * xi * (xi - 1.0)};
}

/// Returns the weights of dr0/dx; those of the positions are 1/m.
template <class Scalar>
[[nodiscard]] constexpr HermiteWeights<Scalar> hermite_first(Scalar xi, Scalar length) noexcept {
    const Scalar bubble = 6.0 * xi * (1.0 - xi) / length;
    return {-bubble, (1.0 - xi) * (1.0 - 3.0 * xi), bubble, xi * (3.0 * xi - 2.0)};
}

/// Returns the weights of d2r0/dx2; those of the positions are 1/m^2, those of the slopes 1/m.
template <class Scalar>
[[nodiscard]] constexpr HermiteWeights<Scalar> hermite_second(Scalar xi, Scalar length) noexcept {
    const Scalar line = (6.0 - 12.0 * xi) / (length * length);
    return {-line, (6.0 * xi - 4.0) / length, line, (6.0 * xi - 2.0) / length};
}

}  // namespace ancf
