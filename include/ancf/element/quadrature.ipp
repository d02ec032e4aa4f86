// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/constants.hpp>
#include <ancf/element/quadrature.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>

#include <cmath>
#include <cstddef>
#include <utility>

namespace ancf {

ANCF_INLINE Quadrature gauss_quadrature(int points) {
    detail::require(points >= 1 && points <= 16, "Gauss: points must lie in [1, 16], got ", points);
    Quadrature quadrature(static_cast<std::size_t>(points));
    for (int k = 0; k < points; ++k) {
        // Newton's method on Legendre's polynomial P_n, by its three-term recurrence.
        double x = -std::cos(pi * (k + 0.75) / (points + 0.5));
        double slope = 1.0;
        for (int iteration = 0; iteration < 8; ++iteration) {
            double previous = 1.0;
            double value = x;
            for (int n = 2; n <= points; ++n) {
                const double next = ((2 * n - 1) * x * value - (n - 1) * previous) / n;
                previous = value;
                value = next;
            }
            slope = points * (x * value - previous) / (x * x - 1.0);
            x -= value / slope;
        }
        if (2 * k + 1 == points) x = 0.0;
        quadrature[k] = {0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope)};
    }
    return quadrature;
}

ANCF_INLINE Quadrature lobatto_quadrature(int points) {
    detail::require(points >= 2 && points <= 5, "Lobatto: points must lie in [2, 5], got ", points);
    if (points == 2) return {{0.0, 0.5}, {1.0, 0.5}};
    if (points == 3) return {{0.0, 1.0 / 6.0}, {0.5, 2.0 / 3.0}, {1.0, 1.0 / 6.0}};
    if (points == 4) {
        const double x = 0.5 / std::sqrt(5.0);
        return {{0.0, 1.0 / 12.0}, {0.5 - x, 5.0 / 12.0}, {0.5 + x, 5.0 / 12.0}, {1.0, 1.0 / 12.0}};
    }
    const double x = 0.5 * std::sqrt(3.0 / 7.0);
    return {{0.0, 0.05},
            {0.5 - x, 49.0 / 180.0},
            {0.5, 16.0 / 45.0},
            {0.5 + x, 49.0 / 180.0},
            {1.0, 0.05}};
}

ANCF_INLINE Rule Rule::paper() { return uniform("paper", gauss_quadrature(4)); }

ANCF_INLINE Rule Rule::gauss(int points) {
    return uniform("gauss" + std::to_string(points), gauss_quadrature(points));
}

ANCF_INLINE Rule Rule::lobatto3() { return uniform("lobatto3", lobatto_quadrature(3)); }

ANCF_INLINE Rule Rule::mixed() {
    const Quadrature rest = gauss_quadrature(2);
    return grouped("mixed", lobatto_quadrature(3), rest, rest, rest);
}

ANCF_INLINE Rule Rule::quintic() {
    const Quadrature rest = gauss_quadrature(4);
    return grouped("quintic", lobatto_quadrature(5), rest, rest, rest);
}

ANCF_INLINE Rule Rule::grouped(std::string name, const Quadrature& axial, const Quadrature& bending,
                               const Quadrature& shear, const Quadrature& torsion) {
    Rule rule;
    rule.name_ = std::move(name);
    rule.insert(axial, StrainGroup::axial);
    rule.insert(bending, StrainGroup::bending);
    rule.insert(shear, StrainGroup::shear);
    rule.insert(torsion, StrainGroup::torsion);
    return rule;
}

ANCF_INLINE Rule Rule::named(std::string_view name) {
    if (name == "paper") return paper();
    if (name == "lobatto3") return lobatto3();
    if (name == "mixed") return mixed();
    if (name == "quintic") return quintic();
    for (int points = 3; points <= 6; ++points) {
        if (name == "gauss" + std::to_string(points)) return gauss(points);
    }
    std::string list;
    for (const std::string_view known : names())
        list.append(list.empty() ? "" : ", ").append(known);
    detail::reject("unknown rule \"", name, "\", expected one of ", list);
}

ANCF_INLINE List<std::string_view> Rule::names() {
    return {"paper", "gauss3", "gauss4", "gauss5", "gauss6", "lobatto3", "mixed", "quintic"};
}

ANCF_INLINE Rule Rule::uniform(std::string name, const Quadrature& all) {
    return grouped(std::move(name), all, all, all, all);
}

ANCF_INLINE void Rule::insert(const Quadrature& quadrature, StrainGroup group) {
    detail::require(!quadrature.empty(), "a quadrature must have at least one point, got none");
    double sum = 0.0;
    for (const QuadraturePoint& point : quadrature) {
        detail::require(point.xi >= 0.0 && point.xi <= 1.0, "xi must lie in [0, 1], got ",
                        point.xi);
        detail::require_positive("weight", point.weight);
        sum += point.weight;
        std::size_t place = 0;
        while (place < stations_.size() && stations_[place].xi < point.xi) ++place;
        if (place == stations_.size() || stations_[place].xi > point.xi) {
            stations_.push_back({});
            for (std::size_t k = stations_.size() - 1; k > place; --k)
                stations_[k] = stations_[k - 1];
            stations_[place] = {point.xi, {}};
        }
        stations_[place].weights[static_cast<unsigned>(group)] += point.weight;
    }
    detail::require(std::abs(sum - 1.0) < 1e-12, "weights must have the sum 1, got ", sum);
}

namespace detail {

ANCF_INLINE void require_points(const Rule& rule, StrainGroup group, const char* name, int least) {
    require(rule.points(group) >= least, "rule \"", rule.name(), "\": the ", name,
            " term needs at least ", least,
            " points, else the element has a mode without energy; got ", rule.points(group));
}

}  // namespace detail

}  // namespace ancf
