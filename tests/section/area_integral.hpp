// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Brute force over plane areas: points and weights that integrate any polynomial of sixth degree.
///
/// Independent of the library's closed forms: product Gauss-Legendre on mapped squares, trapezoidal
/// in angle.

#pragma once

#include <ancf/section/moments.hpp>
#include <ancf/section/section.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ancf::test {

/// A quadrature point of an area; weights may be negative where an area is taken away.
struct AreaPoint {
    double y, z, weight;
};

using Area = std::vector<AreaPoint>;

/// The five-point Gauss rule on [0, 1]: abscissa, weight.
inline const std::array<std::array<double, 2>, 5>& gauss5() {
    static const auto rule = [] {
        const double r = 2.0 * std::sqrt(10.0 / 7.0);
        const double a = std::sqrt(5.0 - r) / 3.0, b = std::sqrt(5.0 + r) / 3.0;
        const double u = (322.0 + 13.0 * std::sqrt(70.0)) / 1800.0;
        const double v = (322.0 - 13.0 * std::sqrt(70.0)) / 1800.0;
        return std::array<std::array<double, 2>, 5>{{{(1.0 - b) / 2.0, v},
                                                     {(1.0 - a) / 2.0, u},
                                                     {0.5, 64.0 / 225.0},
                                                     {(1.0 + a) / 2.0, u},
                                                     {(1.0 + b) / 2.0, v}}};
    }();
    return rule;
}

/// The parallelogram spanned at a by the edges to b and c; signed by orientation.
inline Area parallelogram(SectionPoint a, SectionPoint b, SectionPoint c) {
    const SectionPoint u{b.y - a.y, b.z - a.z}, v{c.y - a.y, c.z - a.z};
    Area points;
    for (const auto& [s, ws] : gauss5())
        for (const auto& [t, wt] : gauss5())
            points.push_back({a.y + s * u.y + t * v.y, a.z + s * u.z + t * v.z,
                              ws * wt * (u.y * v.z - u.z * v.y)});
    return points;
}

/// The triangle a, b, c; signed by orientation.
inline Area triangle(SectionPoint a, SectionPoint b, SectionPoint c) {
    const SectionPoint u{b.y - a.y, b.z - a.z}, v{c.y - b.y, c.z - b.z};
    Area points;
    for (const auto& [s, ws] : gauss5())
        for (const auto& [t, wt] : gauss5())
            points.push_back({a.y + s * (u.y + t * v.y), a.z + s * (u.z + t * v.z),
                              ws * wt * s * (u.y * v.z - u.z * v.y)});
    return points;
}

/// The rectangle [y0, y1] x [z0, z1].
inline Area box(double y0, double y1, double z0, double z1) {
    return parallelogram({y0, z0}, {y1, z0}, {y0, z1});
}

/// The ring between two radii about the origin.
inline Area annulus(double inner, double outer) {
    constexpr int angles = 16;  // trapezoidal: exact for harmonics below 16
    Area points;
    for (const auto& [s, ws] : gauss5())
        for (int k = 0; k < angles; ++k) {
            const double radius = inner + s * (outer - inner);
            const double angle = 2.0 * std::acos(-1.0) * (k + 0.5) / angles;
            points.push_back({radius * std::cos(angle), radius * std::sin(angle),
                              ws * (outer - inner) * radius * 2.0 * std::acos(-1.0) / angles});
        }
    return points;
}

/// Joins two areas.
inline Area operator+(Area a, const Area& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Returns the integral of f(y, z) over an area.
template <class Function>
double integral(const Area& area, const Function& f) {
    double sum = 0.0;
    for (const auto& [y, z, weight] : area) sum += weight * f(y, z);
    return sum;
}

inline Moments moments_of(const Area& area) {
    ancf::detail::MomentTable table{};
    for (std::size_t i = 0; i <= 4; ++i)
        for (std::size_t j = 0; i + j <= 4; ++j)
            table[i][j] = integral(area, [&](double y, double z) {
                return std::pow(y, static_cast<int>(i)) * std::pow(z, static_cast<int>(j));
            });
    return ancf::detail::from_table(table);
}

/// Returns the largest difference of two sets of moments, each of order n relative to area r^n with
/// the polar radius r of the second set.
inline double difference(const Moments& a, const Moments& b) {
    const double radius = std::sqrt(b.polar() / b.area);
    const auto s = ancf::detail::to_table(a), t = ancf::detail::to_table(b);
    double largest = 0.0;
    for (std::size_t i = 0; i <= 4; ++i)
        for (std::size_t j = 0; i + j <= 4; ++j)
            largest = std::max(largest, std::abs(s[i][j] - t[i][j]) /
                                            (b.area * std::pow(radius, static_cast<int>(i + j))));
    return largest;
}

}  // namespace ancf::test
