// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The polynomial of q, v and v' at two or three times: output between steps of high order.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/types.hpp>

#include <vector>

namespace ancf::detail {

/// Coordinates, rates and accelerations at a time.
struct Knot {
    double time = 0.0;  ///< s
    VectorX q, v, acceleration;
};

/// Interpolates at a time: of k knots the polynomial of degree 3k - 1, and its derivative.
///
/// Newton's form by divided differences, times measured by the distance of the last two knots.
/// @param knots  at least two, of different times.
void interpolate(const std::vector<Knot>& knots, double time, VectorX& q, VectorX& v);

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/hermite.ipp>  // IWYU pragma: export
#endif
