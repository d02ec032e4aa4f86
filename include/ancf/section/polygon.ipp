// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/section/moments.hpp>
#include <ancf/section/polygon.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace ancf {

namespace detail {

/// Returns the cross product (b - a) x (c - a): twice the signed area of the triangle.
ANCF_INLINE double turn(SectionPoint a, SectionPoint b, SectionPoint c) noexcept {
    return (b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y);
}

/// Tells whether c, known to lie on the line through a and b, lies between them.
ANCF_INLINE bool within(SectionPoint a, SectionPoint b, SectionPoint c) noexcept {
    return std::min(a.y, b.y) <= c.y && c.y <= std::max(a.y, b.y) && std::min(a.z, b.z) <= c.z &&
           c.z <= std::max(a.z, b.z);
}

/// Tells whether the segments a-b and c-d have a point in common.
ANCF_INLINE bool intersect(SectionPoint a, SectionPoint b, SectionPoint c,
                           SectionPoint d) noexcept {
    const double abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
    const auto opposite = [](double s, double t) {
        return (s > 0.0 && t < 0.0) || (s < 0.0 && t > 0.0);
    };
    if (opposite(abc, abd) && opposite(cda, cdb)) return true;
    return (abc == 0.0 && within(a, b, c)) || (abd == 0.0 && within(a, b, d)) ||
           (cda == 0.0 && within(c, d, a)) || (cdb == 0.0 && within(c, d, b));
}

/// Throws unless the points bound an area without touching or crossing themselves.
ANCF_INLINE void require_simple(const List<SectionPoint>& points) {
    const std::size_t count = points.size();
    require(count >= 3, "a polygon needs at least 3 points, got ", count);
    for (std::size_t i = 0; i < count; ++i) {
        require_finite("y of every polygon point", points[i].y);
        require_finite("z of every polygon point", points[i].z);
    }
    for (std::size_t i = 0; i < count; ++i) {
        const SectionPoint a = points[i], b = points[(i + 1) % count], c = points[(i + 2) % count];
        require(a.y != b.y || a.z != b.z, "polygon points ", i, " and ", (i + 1) % count,
                " coincide at (", a.y, ", ", a.z, ")");
        const bool backwards = (b.y - a.y) * (c.y - b.y) + (b.z - a.z) * (c.z - b.z) < 0.0;
        require(turn(a, b, c) != 0.0 || !backwards, "polygon edge folds back at point ",
                (i + 1) % count);
    }
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 2; j < count; ++j) {
            if (i == 0 && j + 1 == count) continue;  // neighbours share a point
            const std::size_t after = (j + 1) % count;
            require(!intersect(points[i], points[i + 1], points[j], points[after]),
                    "a polygon must not touch or cross itself: edge ", i, "-", i + 1,
                    " meets edge ", j, "-", after);
        }
}

/// Adds the signed moments of the triangle (origin, p, q).
ANCF_INLINE void add_triangle(MomentTable& table, SectionPoint p, SectionPoint q) noexcept {
    constexpr std::array<double, 7> factorial{1.0, 1.0, 2.0, 6.0, 24.0, 120.0, 720.0};
    const double cross = p.y * q.z - p.z * q.y;
    for (std::size_t i = 0; i <= 4; ++i)
        for (std::size_t j = 0; i + j <= 4; ++j) {
            double sum = 0.0;
            for (std::size_t a = 0; a <= i; ++a)
                for (std::size_t b = 0; b <= j; ++b)
                    sum += binomial[i][a] * binomial[j][b] * power(p.y, static_cast<int>(a)) *
                           power(q.y, static_cast<int>(i - a)) * power(p.z, static_cast<int>(b)) *
                           power(q.z, static_cast<int>(j - b)) * factorial[a + b] *
                           factorial[i + j - a - b];
            table[i][j] += cross * sum / factorial[i + j + 2];
        }
}

}  // namespace detail

ANCF_INLINE Section polygon(const List<SectionPoint>& points, SectionPoint origin) {
    detail::require_finite("y of the polygon's origin", origin.y);
    detail::require_finite("z of the polygon's origin", origin.z);
    detail::require_simple(points);
    SectionPoint mean{0.0, 0.0};
    for (const SectionPoint& point : points) {
        mean.y += point.y / static_cast<double>(points.size());
        mean.z += point.z / static_cast<double>(points.size());
    }
    detail::MomentTable table{};
    List<SectionPoint> outline;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SectionPoint p = points[i], q = points[(i + 1) % points.size()];
        detail::add_triangle(table, {p.y - mean.y, p.z - mean.z}, {q.y - mean.y, q.z - mean.z});
        outline.push_back({p.y - origin.y, p.z - origin.z});
    }
    if (table[0][0] < 0.0) {  // clockwise
        for (auto& row : table)
            for (double& value : row) value = -value;
        std::reverse(outline.begin(), outline.end());
    }
    detail::require_positive("the polygon's area", table[0][0]);
    const Moments moments =
        translated(detail::from_table(table), mean.y - origin.y, mean.z - origin.z);
    detail::require_positive("the polygon's int y^2 dA", moments.yy);
    detail::require_positive("the polygon's int z^2 dA", moments.zz);
    return {moments, std::move(outline)};
}

}  // namespace ancf
