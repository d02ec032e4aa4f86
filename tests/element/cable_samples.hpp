// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Cables of moderate slenderness for tests, curves to make curved ones of, and the energy by its
/// definition.

#pragma once

#include <ancf/element/cable/cable.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/section/section.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace ancf::test {

inline constexpr double cable_length = 0.7;  // m

inline Material cable_material() { return Material::isotropic(2e7, 0.3, 7800.0); }
inline Section cable_section() { return circle(0.05); }

template <class Element>
Element straight_cable(const CableOptions& options = {}) {
    return {cable_material(), cable_section(), cable_length, options};
}

/// A helix about Z through the origin; without pitch an arc in the plane of X and Y.
struct Helix {
    double radius;
    double pitch;        ///< rise per radian
    double start = 0.2;  ///< angle of the first node

    [[nodiscard]] double slant() const { return std::hypot(radius, pitch); }
    [[nodiscard]] double curvature() const { return radius / (slant() * slant()); }

    /// Returns the nodal coordinates of the piece between two arc lengths, slopes of unit length.
    template <int Dimension>
    [[nodiscard]] Vector<double, 4 * Dimension> coordinates(double from, double to) const {
        Vector<double, 4 * Dimension> e;
        int at = 0;
        for (const double s : {from, to}) {
            const double angle = start + s / slant();
            const Vector<double, 3> r(radius * std::sin(angle), radius * (1.0 - std::cos(angle)),
                                      pitch * angle);
            const Vector<double, 3> t =
                Vector<double, 3>(radius * std::cos(angle), radius * std::sin(angle), pitch) /
                slant();
            e.template segment<Dimension>(at) = r.head<Dimension>();
            e.template segment<Dimension>(at + Dimension) = t.head<Dimension>();
            at += 2 * Dimension;
        }
        return e;
    }
};

/// A line with an inflection: parallel slopes at its ends, aside of each other.
template <int Dimension>
Vector<double, 4 * Dimension> inflected_coordinates() {
    Vector<double, 4 * Dimension> e = Vector<double, 4 * Dimension>::Zero();
    e[Dimension] = e[3 * Dimension] = 1.0;
    e[2 * Dimension] = 0.66;
    e[2 * Dimension + 1] = 0.2;
    return e;
}

/// Returns U of a straight cable by its definition at the stations of its rule, from the Hermite
/// polynomials.
/// @param strain  of the stretch |r'|
template <int Dimension, class Strain>
double defined_energy(const Vector<double, 4 * Dimension>& e, const Rule& rule,
                      const Strain& strain) {
    const double axial = cable_material().young * cable_section().moments().area;
    const double bending = cable_material().young * cable_section().moments().yy;
    double sum = 0.0;
    for (const RuleStation& station : rule.stations()) {
        const auto first = hermite_first(station.xi, cable_length),
                   second = hermite_second(station.xi, cable_length);
        Vector<double, 3> p = Vector<double, 3>::Zero(), v = p;
        for (int a = 0; a < 4; ++a) {
            p.head<Dimension>() +=
                first[static_cast<std::size_t>(a)] * e.template segment<Dimension>(Dimension * a);
            v.head<Dimension>() +=
                second[static_cast<std::size_t>(a)] * e.template segment<Dimension>(Dimension * a);
        }
        const double eps = strain(p.norm());
        const double kappa = cross(p, v).norm() / std::pow(p.norm(), 3);
        sum += 0.5 * cable_length *
               (station.weight(StrainGroup::axial) * axial * eps * eps +
                station.weight(StrainGroup::bending) * bending * kappa * kappa);
    }
    return sum;
}

/// Returns one of the rules that a cable is tried with, from 0 to 4.
inline const Rule& cable_rule_of(int place) {
    static const std::vector<Rule> rules{cable_rule(), Rule::mixed(), Rule::lobatto3(),
                                         Rule::gauss(3), Rule::gauss(5)};
    return rules[static_cast<std::size_t>(place)];
}

}  // namespace ancf::test
