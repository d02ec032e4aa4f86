// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The section forces that are in equilibrium with an element's nodal forces: docs/theory.md,
/// "Section forces".

#pragma once

#include <ancf/element/evaluation.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/element/hermite.hpp>
#include <ancf/element/requirement.hpp>
#include <ancf/types.hpp>

#include <type_traits>

namespace ancf {

namespace detail {

/// Returns a vector of the plane or of space, in space.
template <int Dimension>
[[nodiscard]] Vector<double, 3> in_space(const Vector<double, Dimension>& v) {
    Vector<double, 3> out = Vector<double, 3>::Zero();
    for (int k = 0; k < Dimension; ++k) out[k] = v[k];
    return out;
}

/// Returns dr/dx at xi; along the chord of elements without r_x.
template <class Element>
[[nodiscard]] Vector<double, 3> line_slope(const Element& element,
                                           const typename Element::Coordinates& e, double xi) {
    constexpr int d = Element::dimension, second = Element::dofs / 2;
    const auto vector = [&](int node, Field field) {
        return in_space<d>(e.template segment<d>(node * second + d * Element::fields.rank(field)));
    };
    const Vector<double, 3> chord = vector(1, Field::r) - vector(0, Field::r);
    if constexpr (!Element::fields.contains(Field::r_x)) {
        return chord;
    } else {
        constexpr bool quintic = Element::fields.contains(Field::r_xx);
        using Line = std::conditional_t<quintic, QuinticLine, CubicLine>;
        const auto w = Line::first(xi, parameter_length(element));
        Vector<double, 3> slope =
            w[0] * chord + w[1] * vector(0, Field::r_x) + w[2] * vector(1, Field::r_x);
        if constexpr (quintic)
            slope += w[3] * vector(0, Field::r_xx) + w[4] * vector(1, Field::r_xx);
        return slope;
    }
}

}  // namespace detail

/// Returns what the section at xi transmits, by equilibrium with the forces at the nodes.
///
/// Of an element's generalised force f = dU/de the force on position and the moment of the slopes
/// at the second node are what the rest of the scene exerts there. Nothing else acts on the
/// element, so its sections transmit the force f_r2 and the moment
/// sum a_2 x f_a2 + (r_2 - r(xi)) x f_r2 about the centre line. In statics these balance loads at
/// nodes to round-off on any mesh, at clamps and beside point loads too; forces along the element
/// count at its nodes, so the force is that of its middle, and the moment of a load q per length
/// is off by q l^2/12 at the nodes of a cubic line, by nothing at xi = 0.211 and 0.789. The
/// element's own section_forces are those of the strains.
///
/// In motion both leave out the viscous stress of add_kelvin_voigt, and these the inertia of the
/// part of the element beyond the section. What a support or a joint bears has all of it:
/// TimeSeries::add_reaction.
/// @param e   nodal coordinates.
/// @param xi  from 0 to 1.
template <class Element>
[[nodiscard]] SectionForces transmitted_forces(const Element& element,
                                               const typename Element::Coordinates& e, double xi) {
    constexpr int d = Element::dimension, second = Element::dofs / 2;
    const typename Element::Coordinates f = element.force(e);
    const auto vector = [](const typename Element::Coordinates& of, int at) {
        return detail::in_space<d>(of.template segment<d>(at));
    };
    const auto place = [&](double y, double z) {
        return detail::in_space<d>(Vector<double, d>(element.position(e, xi, y, z)));
    };
    const Vector<double, 3> force = vector(f, second), centre = place(0.0, 0.0);
    Vector<double, 3> moment = cross(Vector<double, 3>(vector(e, second) - centre), force);
    for (int at = second + d; at < Element::dofs; at += d)
        moment += cross(vector(e, at), vector(f, at));

    const Vector<double, 3> slope = detail::line_slope(element, e, xi), t = slope / slope.norm();
    Vector<double, 3> n(-t[1], t[0], 0.0);
    if constexpr (d == 3) {
        const auto unit_normal = [&](const Vector<double, 3>& a) -> Vector<double, 3> {
            const Vector<double, 3> normal = a - t.dot(a) * t;
            return normal / normal.norm();
        };
        const Vector<double, 3> of_z = unit_normal(place(0.0, 1.0) - centre);
        const Vector<double, 3> middle = unit_normal(place(1.0, 0.0) - centre) + cross(of_z, t);
        n = middle / middle.norm();
    }
    const Vector<double, 3> c = cross(t, n);
    return {force.dot(t), force.dot(n), force.dot(c), moment.dot(t), moment.dot(n), moment.dot(c)};
}

}  // namespace ancf
