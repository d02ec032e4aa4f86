// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/section/moments.hpp>
#include <ancf/section/profiles.hpp>

namespace ancf {

namespace detail {

/// Returns the shear correction factor along the webs of a thin-walled box or I-section:
/// k = 10 (1 + 3 m)^2/(12 + 72 m + 150 m^2 + 90 m^3 + 30 n^2 (m + m^2)) (Cowper 1966, nu = 0).
/// @param flange_to_web  m, area of all flanges to area of all webs, 1
/// @param aspect         n, width to height between the walls' middles, 1
ANCF_INLINE double web_shear_correction(double flange_to_web, double aspect) noexcept {
    const double m = flange_to_web;
    const double flow =
        12.0 + m * (72.0 + m * (150.0 + 90.0 * m)) + 30.0 * aspect * aspect * m * (1.0 + m);
    return 10.0 * (1.0 + 3.0 * m) * (1.0 + 3.0 * m) / flow;
}

}  // namespace detail

ANCF_INLINE Section hollow_rectangle(double width, double height, double inner_width,
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

ANCF_INLINE Section i_section(double width, double height, double web_thickness,
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
    detail::require(flange_thickness <= width / 2.0 * (1.0 + 1e-12),
                    "flange_thickness must be at most half the width ", width, ", got ",
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
