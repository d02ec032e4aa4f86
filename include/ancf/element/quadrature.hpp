// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Integration along the element: points on [0, 1] and named rules made of them.
///
/// A rule gives every group of strain-energy terms its own quadrature. Stations that several groups
/// share are evaluated once, so a uniform rule costs its number of points.

#pragma once

#include <ancf/constants.hpp>
#include <ancf/error.hpp>
#include <ancf/records.hpp>

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ancf {

/// A point of a quadrature on the unit interval; the weights of a quadrature sum to 1.
struct QuadraturePoint {
    double xi;      ///< in [0, 1]
    double weight;  ///< 1
};

using Quadrature = detail::Records<QuadraturePoint>;  ///< points with their weights

/// Returns Gauss and Legendre's quadrature, exact for polynomials of degree 2 points - 1.
/// @throws InvalidArgument unless 1 <= points <= 16.
[[nodiscard]] Quadrature gauss_quadrature(int points);

/// Returns Lobatto's quadrature, end points included, exact for degree 2 points - 3.
/// @throws InvalidArgument unless 2 <= points <= 5.
[[nodiscard]] Quadrature lobatto_quadrature(int points);

/// A group of terms of the energy density. A term is a product of two generalised strains:
/// both axial (eps eps); any other two of e_xx; both a shear at the axis (g g); any other of 2e_xy
/// or 2e_xz.
enum class StrainGroup : unsigned { axial, bending, shear, torsion };

inline constexpr int strain_group_count = 4;  ///< number of strain groups

/// A place along the element with its weight for each group; a weight of zero leaves the group out.
struct RuleStation {
    double xi;                                       ///< place in [0, 1]
    std::array<double, strain_group_count> weights;  ///< by strain group; 0: not taken there

    /// Returns the weight for a strain group, of unit length.
    [[nodiscard]] double weight(StrainGroup group) const noexcept {
        return weights[static_cast<unsigned>(group)];
    }

    /// Tells whether only the axial term is integrated here.
    [[nodiscard]] bool axial_only() const noexcept {
        return weight(StrainGroup::bending) == 0.0 && weight(StrainGroup::shear) == 0.0 &&
               weight(StrainGroup::torsion) == 0.0;
    }
};

/// A named choice of the stations along an element.
class Rule {
public:
    /// Four Gauss points: the rule that reproduces [Dufva2006].
    [[nodiscard]] static Rule paper() { return uniform("paper", gauss_quadrature(4)); }

    /// Gauss points for every group. Two leave a beam element with one spurious axial mode.
    /// @throws InvalidArgument unless there are 1 to 16.
    [[nodiscard]] static Rule gauss(int points) {
        return uniform("gauss" + std::to_string(points), gauss_quadrature(points));
    }

    /// Three Lobatto points for every group.
    [[nodiscard]] static Rule lobatto3() { return uniform("lobatto3", lobatto_quadrature(3)); }

    /// The axial term EA eps^2/2 by three Lobatto points, everything else by two Gauss points:
    /// relieves the axial-bending locking of uniform rules.
    [[nodiscard]] static Rule mixed() {
        const Quadrature rest = gauss_quadrature(2);
        return grouped("mixed", lobatto_quadrature(3), rest, rest, rest);
    }

    /// The axial term by five Lobatto points, everything else by four Gauss points: the least that
    /// leaves a quintic centre line no mode without energy, see QuinticLine.
    [[nodiscard]] static Rule quintic() {
        const Quadrature rest = gauss_quadrature(4);
        return grouped("quintic", lobatto_quadrature(5), rest, rest, rest);
    }

    /// A rule of one quadrature per group.
    /// @throws InvalidArgument unless points lie in [0, 1] and weights are positive with sum 1.
    [[nodiscard]] static Rule grouped(std::string name, const Quadrature& axial,
                                      const Quadrature& bending, const Quadrature& shear,
                                      const Quadrature& torsion);

    /// Returns the rule of a name listed by names().
    /// @throws InvalidArgument listing the names.
    [[nodiscard]] static Rule named(std::string_view name);

    /// Returns the names that named() knows.
    [[nodiscard]] static std::vector<std::string_view> names() {
        return {"paper", "gauss3", "gauss4", "gauss5", "gauss6", "lobatto3", "mixed", "quintic"};
    }

    /// Returns the word that command lines use.
    [[nodiscard]] const std::string& name() const noexcept { return name_; }

    /// Returns the stations in ascending order of xi.
    [[nodiscard]] const detail::Records<RuleStation>& stations() const noexcept {
        return stations_;
    }

    /// Returns at how many stations a group is integrated.
    [[nodiscard]] int points(StrainGroup group) const noexcept {
        int count = 0;
        for (const RuleStation& station : stations_) count += station.weight(group) != 0.0 ? 1 : 0;
        return count;
    }

private:
    [[nodiscard]] static Rule uniform(std::string name, const Quadrature& all) {
        return grouped(std::move(name), all, all, all, all);
    }

    void insert(const Quadrature& quadrature, StrainGroup group);

    std::string name_;
    detail::Records<RuleStation> stations_;
};

inline Quadrature gauss_quadrature(int points) {
    detail::require(points >= 1 && points <= 16, "points must lie in [1, 16], got ", points);
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
        quadrature[static_cast<std::size_t>(k)] = {0.5 * (1.0 + x),
                                                   1.0 / ((1.0 - x * x) * slope * slope)};
    }
    return quadrature;
}

inline Quadrature lobatto_quadrature(int points) {
    detail::require(points >= 2 && points <= 5, "points must lie in [2, 5], got ", points);
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

inline void Rule::insert(const Quadrature& quadrature, StrainGroup group) {
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

inline Rule Rule::grouped(std::string name, const Quadrature& axial, const Quadrature& bending,
                          const Quadrature& shear, const Quadrature& torsion) {
    Rule rule;
    rule.name_ = std::move(name);
    rule.insert(axial, StrainGroup::axial);
    rule.insert(bending, StrainGroup::bending);
    rule.insert(shear, StrainGroup::shear);
    rule.insert(torsion, StrainGroup::torsion);
    return rule;
}

inline Rule Rule::named(std::string_view name) {
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

namespace detail {

/// Throws if a group of terms has so few points that a motion of the element has no energy.
inline void require_points(const Rule& rule, StrainGroup group, const char* name, int least) {
    require(rule.points(group) >= least, "rule \"", rule.name(), "\": the ", name,
            " term needs at least ", least,
            " points, else the element has a mode without energy; got ", rule.points(group));
}

}  // namespace detail

}  // namespace ancf
