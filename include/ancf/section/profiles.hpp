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

#include <ancf/error.hpp>
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
/// structural shapes, J. Struct. Div. ASCE 91 (1965); no fillets). Within 1.5 % for t_w <= t_f,
/// 2.5 % for t_w = 2 t_f.
/// @param width   of the flanges, along z, m, > 0
/// @param height  overall, along y, m, > 0
/// @param web_thickness     t_w along z, m, 0 < t_w < width and at most 2 t_f, the formula's range
/// @param flange_thickness  t_f along y, m, 0 < t_f < height/2
/// @throws InvalidArgument naming the value that is out of range or not finite.
[[nodiscard]] Section i_section(double width, double height, double web_thickness,
                                double flange_thickness);

namespace detail {

/// Returns the shear correction factor along the webs of a thin-walled box or I-section:
/// k = 10 (1 + 3 m)^2/(12 + 72 m + 150 m^2 + 90 m^3 + 30 n^2 (m + m^2)) (Cowper 1966, nu = 0).
/// @param flange_to_web  m, area of all flanges to area of all webs, 1
/// @param aspect         n, width to height between the walls' middles, 1
inline double web_shear_correction(double flange_to_web, double aspect) noexcept {
    const double m = flange_to_web;
    const double flow =
        12.0 + m * (72.0 + m * (150.0 + 90.0 * m)) + 30.0 * aspect * aspect * m * (1.0 + m);
    return 10.0 * (1.0 + 3.0 * m) * (1.0 + 3.0 * m) / flow;
}

}  // namespace detail

inline Section hollow_rectangle(double width, double height, double inner_width,
                                double inner_height) {
    detail::require_positive("width", width);
    detail::require_positive("height", height);
    detail::require_positive("inner_width", inner_width);
    detail::require_positive("inner_height", inner_height);
    detail::require(inner_width < width, "inner_width must be less than width ", width, ", got ",
                    inner_width);
    detail::require(inner_height < height, "inner_height must be less than height ", height,
                    ", got ", inner_height);

    const double web = (width - inner_width) / 2.0;       // thickness of the walls along y
    const double flange = (height - inner_height) / 2.0;  // thickness of the walls along z
    const double thickest = 0.25 * (width < height ? width : height);
    detail::require(web <= thickest * (1.0 + 1e-12) && flange <= thickest * (1.0 + 1e-12),
                    "the walls of a hollow rectangle must be no thicker than 1/4 of the shorter "
                    "side, ",
                    thickest, ", got ", web, " along y and ", flange, " along z");
    const double b = (width + inner_width) / 2.0;
    const double h = (height + inner_height) / 2.0;
    const double torsion = 2.0 * b * b * h * h / (b / flange + h / web) +
                           2.0 / 3.0 * (b * detail::power(flange, 3) + h * detail::power(web, 3));
    const double m = b * flange / (h * web);
    return Section::from_moments(
               detail::hollowed(detail::rectangle_moments(width, height),
                                detail::rectangle_moments(inner_width, inner_height)))
        .with_shear_correction(detail::web_shear_correction(m, b / h),
                               detail::web_shear_correction(1.0 / m, h / b))
        .with_torsion_constant(torsion)
        .with_outline(detail::rectangle_outline(width, height));
}

inline Section i_section(double width, double height, double web_thickness,
                         double flange_thickness) {
    detail::require_positive("width", width);
    detail::require_positive("height", height);
    detail::require_positive("web_thickness", web_thickness);
    detail::require_positive("flange_thickness", flange_thickness);
    detail::require(web_thickness < width, "web_thickness must be less than width ", width,
                    ", got ", web_thickness);
    detail::require(flange_thickness < height / 2.0,
                    "flange_thickness must be less than half the height ", height, ", got ",
                    flange_thickness);
    detail::require(web_thickness <= 2.0 * flange_thickness,
                    "web_thickness must be at most twice flange_thickness ", flange_thickness,
                    ", got ", web_thickness);

    const double web_height = height - 2.0 * flange_thickness;
    const double ratio = web_thickness / flange_thickness;
    const double alpha = -0.042 + ratio * (0.2204 - 0.0725 * ratio);
    const double circle =
        flange_thickness * (1.0 + ratio * ratio / 4.0);  // inscribed where web and flange meet
    const double torsion = 2.0 / 3.0 * width * detail::power(flange_thickness, 3) +
                           web_height * detail::power(web_thickness, 3) / 3.0 +
                           2.0 * alpha * detail::power(circle, 4) -
                           0.42 * detail::power(flange_thickness, 4);
    const double h = height - flange_thickness;
    const double flanges = 2.0 * width * flange_thickness;
    const double k_y = detail::web_shear_correction(flanges / (h * web_thickness), width / h);
    const double k_z = 5.0 / 6.0 * flanges /
                       (flanges + web_height * web_thickness);  // the flanges as two rectangles
    const double y = height / 2.0, z = width / 2.0, inner_y = web_height / 2.0,
                 inner_z = web_thickness / 2.0;
    return Section::from_moments(
               detail::hollowed(
                   detail::rectangle_moments(width, height),
                   detail::hollowed(detail::rectangle_moments(width, web_height),
                                    detail::rectangle_moments(web_thickness, web_height))))
        .with_shear_correction(k_y, k_z)
        .with_torsion_constant(torsion)
        .with_outline({{-y, -z},
                       {-inner_y, -z},
                       {-inner_y, -inner_z},
                       {inner_y, -inner_z},
                       {inner_y, -z},
                       {y, -z},
                       {y, z},
                       {inner_y, z},
                       {inner_y, inner_z},
                       {-inner_y, inner_z},
                       {-inner_y, z},
                       {-y, z}});
}

}  // namespace ancf
