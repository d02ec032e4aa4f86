// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Saint-Venant torsion constants J: a torque T twists a free-to-warp bar by T/(G J) per length.
///
/// The rectangle's is the classical series (Timoshenko and Goodier, Theory of Elasticity, article
/// on torsion of rectangular bars), summed to round-off.

#pragma once

namespace ancf {

/// Returns the torsion constant of a solid rectangle, m^4.
///
/// With sides a >= b:  J = a b^3 (1/3 - 64 b/(pi^5 a) sum_{n odd} tanh(n pi a/(2 b))/n^5). The sum
/// of 1/n^5 is taken exactly (31 zeta(5)/32), what remains falls as exp(-n pi a/b): relative error
/// below 1e-15 at any aspect ratio.
/// @param width, height  sides, m, > 0; the order does not matter.
/// @throws InvalidArgument naming a side that is not positive or not finite.
[[nodiscard]] double rectangle_torsion_constant(double width, double height);

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/section/torsion.ipp>  // IWYU pragma: export
#endif
