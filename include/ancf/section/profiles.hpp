// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Hollow rectangle and I-section: exact moments, engineering formulas for torsion and shear.
///
/// Moments are those of the sharp-cornered shape, exact. Torsion constants are approximate; the
/// accuracy stated was measured against finite-difference solutions of Saint-Venant's problem for
/// the same shapes. Shear correction: the energy of the thin-walled shear flow, which is Cowper
/// (1966) at Poisson's ratio zero. A better number replaces them by with_torsion_constant() and
/// with_shear_correction().

#pragma once

#include <ancf/section/section.hpp>

namespace ancf {

/// Returns a rectangle with a centred rectangular hole, centred.
///
/// J = 4 A_m^2/(closed integral ds/t) + sum L t^3/3 over the four walls (Bredt with the walls' own
/// torsion), A_m and L along the wall's middle. It is low because of the corners: by 2 % for walls
/// of 1/20 of the side, 4 % for 1/10, 6 % for 1/5, up to 7 % where two walls are four times as
/// thick as the others. Thicker walls are refused, as the formula then exceeds the solid's J.
/// @param width, inner_width    outer and inner extent along z, m, 0 < inner < outer
/// @param height, inner_height  outer and inner extent along y, m, 0 < inner < outer
/// @pre no wall is thicker than 1/4 of the shorter outer side
/// @throws InvalidArgument naming the value that is out of range or not finite.
[[nodiscard]] Section hollow_rectangle(double width, double height, double inner_width,
                                       double inner_height);

/// Returns an I-section, centred: the web along y in the middle, one flange at either end of it.
///
/// J = 2/3 b t_f^3 + h_w t_w^3/3 + 2 alpha D^4 - 0.42 t_f^4 with D = (t_f^2 + t_w^2/4)/t_f and
/// alpha = -0.042 + 0.2204 t_w/t_f - 0.0725 (t_w/t_f)^2 (El Darwish and Johnston, Torsion of
/// structural shapes, J. Struct. Div. ASCE 91 (1965); no fillets). Within 1.5 % for t_w <= t_f up
/// to a quarter of the width. For t_w = 2 t_f it is high: by 2.5 % for webs up to a fifth of the
/// width in a height of twice the width, by up to 13 % in stout sections. For t_f of half the width
/// it is low by up to 8 %. Thicker flanges are refused, as J then becomes too small, at last
/// negative.
/// @param width   of the flanges, along z, m, > 0
/// @param height  overall, along y, m, > 0
/// @param web_thickness     t_w along z, m, 0 < t_w < width and at most 2 t_f, the formula's range
/// @param flange_thickness  t_f along y, m, 0 < t_f < height/2 and at most width/2
/// @throws InvalidArgument naming the value that is out of range or not finite.
[[nodiscard]] Section i_section(double width, double height, double web_thickness,
                                double flange_thickness);

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/section/profiles.ipp>  // IWYU pragma: export
#endif
