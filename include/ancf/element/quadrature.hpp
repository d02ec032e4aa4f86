// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Integration along the element: points on [0, 1] and named rules made of them.
///
/// A rule gives every group of strain-energy terms its own quadrature. Stations that several groups
/// share are evaluated once, so a uniform rule costs its number of points.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/list.hpp>

#include <array>
#include <string>
#include <string_view>

namespace ancf {

/// A point of a quadrature on the unit interval; the weights of a quadrature sum to 1.
struct QuadraturePoint {
    double xi;      ///< in [0, 1]
    double weight;  ///< 1
};

using Quadrature = List<QuadraturePoint>;  ///< points with their weights

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
    [[nodiscard]] static Rule paper();

    /// Gauss points for every group. Two leave a beam element with one spurious axial mode.
    /// @throws InvalidArgument unless there are 1 to 16.
    [[nodiscard]] static Rule gauss(int points);

    /// Three Lobatto points for every group.
    [[nodiscard]] static Rule lobatto3();

    /// The axial term EA eps^2/2 by three Lobatto points, everything else by two Gauss points:
    /// relieves the axial-bending locking of uniform rules.
    [[nodiscard]] static Rule mixed();

    /// The axial term by five Lobatto points, everything else by four Gauss points: the least that
    /// leaves a quintic centre line no mode without energy, see QuinticLine.
    [[nodiscard]] static Rule quintic();

    /// A rule of one quadrature per group.
    /// @throws InvalidArgument unless points lie in [0, 1] and weights are positive with sum 1.
    [[nodiscard]] static Rule grouped(std::string name, const Quadrature& axial,
                                      const Quadrature& bending, const Quadrature& shear,
                                      const Quadrature& torsion);

    /// Returns the rule of a name listed by names().
    /// @throws InvalidArgument listing the names.
    [[nodiscard]] static Rule named(std::string_view name);

    /// Returns the names that named() knows.
    [[nodiscard]] static List<std::string_view> names();

    /// Returns the word that command lines use.
    [[nodiscard]] const std::string& name() const noexcept { return name_; }

    /// Returns the stations in ascending order of xi.
    [[nodiscard]] const List<RuleStation>& stations() const noexcept { return stations_; }

    /// Returns at how many stations a group is integrated.
    [[nodiscard]] int points(StrainGroup group) const noexcept {
        int count = 0;
        for (const RuleStation& station : stations_) count += station.weight(group) != 0.0 ? 1 : 0;
        return count;
    }

private:
    [[nodiscard]] static Rule uniform(std::string name, const Quadrature& all);

    void insert(const Quadrature& quadrature, StrainGroup group);

    std::string name_;
    List<RuleStation> stations_;
};

namespace detail {

/// Throws if a group of terms has so few points that a motion of the element has no energy.
void require_points(const Rule& rule, StrainGroup group, const char* name, int least);

}  // namespace detail

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/element/quadrature.ipp>
#endif
