// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Any simple polygon as a section: moments to fourth order by Green's theorem, exact but for
/// round-off.

#pragma once

#include <ancf/list.hpp>
#include <ancf/section/section.hpp>

namespace ancf {

/// Returns the section bounded by a polygon; shear correction and torsion constant are unset.
///
/// Every edge (p, q) adds the triangle (origin, p, q), of signed area (p x q)/2, over which
/// int y^i z^j dA = (p x q) sum_a sum_b C(i,a) C(j,b) p_y^a q_y^(i-a) p_z^b q_z^(j-b) (a+b)!
/// (i+j-a-b)!/(i+j+2)!. The sums are taken about the vertices' mean and moved to the reference axis
/// afterwards.
///
///     const auto trapezium = ancf::polygon({{0, -0.02}, {0, 0.02}, {0.05, 0.01}, {0.05, -0.01}});
///
/// @param points  at least three corners (y, z), m, in order, either way round; the first is not
///         repeated at the end.
/// @param origin  where the reference axis runs, in the points' coordinates, m.
/// @throws InvalidArgument naming the points if there are too few, one is not finite, two
///         neighbours coincide, or the boundary touches or crosses itself.
[[nodiscard]] Section polygon(const List<SectionPoint>& points, SectionPoint origin = {0.0, 0.0});

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/section/polygon.ipp>  // IWYU pragma: export
#endif
