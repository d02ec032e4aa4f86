// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/constants.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/section/section.hpp>

#include <algorithm>
#include <cmath>

namespace ancf {

ANCF_INLINE double rectangle_torsion_constant(double width, double height) {
    detail::require_positive("width", width);
    detail::require_positive("height", height);
    constexpr double zeta5 = 1.03692775514336992633;
    const double a = std::max(width, height);
    const double b = std::min(width, height);
    double sum = 31.0 / 32.0 * zeta5;
    for (int n = 1; n <= 15; n += 2)  // exp(-15 pi) < 1e-20
        sum -= 2.0 / ((std::exp(n * pi * (a / b)) + 1.0) * std::pow(n, 5));
    return a * b * b * b * (1.0 / 3.0 - 64.0 * (b / a) / std::pow(pi, 5) * sum);
}

namespace detail {

ANCF_INLINE List<SectionPoint> rectangle_outline(double width, double height) {
    const double y = height / 2.0;
    const double z = width / 2.0;
    return {{-y, -z}, {y, -z}, {y, z}, {-y, z}};
}

ANCF_INLINE List<SectionPoint> circle_outline(double radius) {
    constexpr int count = 48;
    List<SectionPoint> points;
    for (int k = 0; k < count; ++k) {
        const double angle = 2.0 * pi * k / count;
        points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return points;
}

ANCF_INLINE Moments rectangle_moments(double width, double height) noexcept {
    const double w2 = width * width;
    const double h2 = height * height;
    Moments m;
    m.area = width * height;
    m.yy = m.area * h2 / 12.0;
    m.zz = m.area * w2 / 12.0;
    m.yyyy = m.area * h2 * h2 / 80.0;
    m.yyzz = m.area * h2 * w2 / 144.0;
    m.zzzz = m.area * w2 * w2 / 80.0;
    return m;
}

/// Returns the moments of a centred circle, radius in m.
ANCF_INLINE Moments circle_moments(double radius) noexcept {
    const double r2 = radius * radius;
    Moments m;
    m.area = pi * r2;
    m.yy = m.zz = m.area * r2 / 4.0;
    m.yyyy = m.zzzz = m.area * r2 * r2 / 8.0;
    m.yyzz = m.area * r2 * r2 / 24.0;
    return m;
}

ANCF_INLINE Moments hollowed(Moments outer, const Moments& hole) noexcept {
    outer.area -= hole.area;
    outer.yy -= hole.yy;
    outer.zz -= hole.zz;
    outer.yyyy -= hole.yyyy;
    outer.yyzz -= hole.yyzz;
    outer.zzzz -= hole.zzzz;
    return outer;
}

/// Returns the image of a square that has the centroid and the radii of gyration of the moments.
ANCF_INLINE List<SectionPoint> equivalent_outline(const Moments& moments) {
    const Moments centred = centroidal(moments);
    const double half = std::sqrt(3.0);  // a square of this half side has unit radii of gyration
    const double yy = std::sqrt(centred.yy / centred.area);
    const double zy = centred.yz / centred.area / yy;
    const double zz = std::sqrt(centred.zz / centred.area - zy * zy);
    List<SectionPoint> points;
    for (const auto& [u, v] :
         {SectionPoint{-half, -half}, {half, -half}, {half, half}, {-half, half}})
        points.push_back(
            {moments.y / moments.area + yy * u, moments.z / moments.area + zy * u + zz * v});
    return points;
}

}  // namespace detail

ANCF_INLINE Section Section::from_moments(const Moments& moments) {
    validate(moments);
    return {moments, detail::equivalent_outline(moments)};
}

ANCF_INLINE double Section::torsion_constant() const {
    detail::require(
        torsion_constant_ > 0.0,
        "torsion_constant of this section is unset: give it by with_torsion_constant(J)");
    return torsion_constant_;
}

ANCF_INLINE const double* Section::shear_correction() const {
    detail::require(
        shear_correction_[0] > 0.0,
        "shear_correction of this section is unset: give it by with_shear_correction(k_y, k_z)");
    return shear_correction_;
}

ANCF_INLINE Section Section::with_shear_correction(double k_y, double k_z) const {
    detail::require_positive("shear_correction_y", k_y);
    detail::require_positive("shear_correction_z", k_z);
    Section section = *this;
    section.shear_correction_[0] = k_y;
    section.shear_correction_[1] = k_z;
    return section;
}

ANCF_INLINE Section Section::with_torsion_constant(double torsion_constant) const {
    detail::require_positive("torsion_constant", torsion_constant);
    Section section = *this;
    section.torsion_constant_ = torsion_constant;
    return section;
}

ANCF_INLINE Section Section::with_shear_centre(SectionPoint point) const {
    detail::require_finite("shear centre y", point.y);
    detail::require_finite("shear centre z", point.z);
    Section section = *this;
    section.has_shear_centre_ = true;
    section.shear_centre_ = point;
    return section;
}

ANCF_INLINE Section Section::with_mass_moments(const Moments& moments) const {
    validate(moments);
    Section section = *this;
    section.mass_moments_ = moments;
    return section;
}

ANCF_INLINE Section Section::with_outline(List<SectionPoint> outline) const {
    for (const SectionPoint& point : outline)
        detail::require(std::isfinite(point.y) && std::isfinite(point.z),
                        "Section: points of the outline must be finite, got (", point.y, ", ",
                        point.z, ")");
    Section section = *this;
    section.outline_ = std::move(outline);
    return section;
}

ANCF_INLINE Section rectangle(double width, double height) {
    const double torsion = rectangle_torsion_constant(width, height);
    Section section = Section::from_moments(detail::rectangle_moments(width, height));
    for (double& k : section.shear_correction_) k = 5.0 / 6.0;
    section.torsion_constant_ = torsion;
    section.outline_ = detail::rectangle_outline(width, height);
    return section;
}

ANCF_INLINE Section circle(double radius) {
    detail::require_positive("radius", radius);
    const Moments moments = detail::circle_moments(radius);
    return Section::from_moments(moments)
        .with_shear_correction(6.0 / 7.0, 6.0 / 7.0)
        .with_torsion_constant(moments.polar())
        .with_outline(detail::circle_outline(radius));
}

ANCF_INLINE Section tube(double outer_radius, double inner_radius) {
    detail::require_positive("outer_radius", outer_radius);
    detail::require_positive("inner_radius", inner_radius);
    detail::require(inner_radius < outer_radius, "inner_radius must be less than outer_radius ",
                    outer_radius, ", got ", inner_radius);
    const Moments moments = detail::hollowed(detail::circle_moments(outer_radius),
                                             detail::circle_moments(inner_radius));
    const double m2 = detail::power(inner_radius / outer_radius, 2);
    const double k = 6.0 * (1.0 + m2) * (1.0 + m2) / (7.0 * (1.0 + m2) * (1.0 + m2) + 20.0 * m2);
    return Section::from_moments(moments)
        .with_shear_correction(k, k)
        .with_torsion_constant(moments.polar())
        .with_outline(detail::circle_outline(outer_radius));
}

ANCF_INLINE Section offset(const Section& section, double dy, double dz) {
    detail::require_finite("offset dy", dy);
    detail::require_finite("offset dz", dz);
    Section moved = section;
    moved.moments_ = translated(section.moments_, dy, dz);
    moved.mass_moments_ = translated(section.mass_moments_, dy, dz);
    moved.shear_centre_ = {section.shear_centre_.y + dy, section.shear_centre_.z + dz};
    for (SectionPoint& point : moved.outline_) point = {point.y + dy, point.z + dz};
    return moved;
}

}  // namespace ancf
