// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Forces of a step that do exactly the work by which an energy changes, without moving momenta.
///
/// With the middle e_m of a step, the change De and its part D that no rigid motion at e_m
/// explains:
///
///     f = grad U(e_m) + s W D,    s = (U(e_1) - U(e_0) - grad U(e_m).De)/(D.W D).
///
/// f.De = U(e_1) - U(e_0), and s W D has neither a resultant nor a moment. docs/theory-dynamics.md.

#pragma once

#include <ancf/dynamics/rigid_modes.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/types.hpp>

namespace ancf::detail {

/// Below this size of D, relative to an element, s is set to zero: what U's third derivative makes
/// of it is then below the round-off of U.
inline constexpr double smallest_change = 1e-8;

/// What a step needs of one element.
template <int Dofs>
struct StepForce {
    double energy;                 ///< U(e_1), J
    Vector<double, Dofs> force;    ///< f
    Matrix<double, Dofs> tangent;  ///< df/de_1
};

/// How much of the tangent is wanted.
enum class StepTangent {
    none,
    symmetric,  ///< K(e_m)/2: what a solver of symmetric matrices can take
    exact       ///< with the derivative of s W D, unsymmetric
};

/// Evaluates one element over a step.
/// @param before  U(e_0), J.
template <class Element>
[[nodiscard]] StepForce<Element::dofs> step_force(const Element& element,
                                                  const typename Element::Coordinates& e0,
                                                  const typename Element::Coordinates& e1,
                                                  double before, StepTangent wanted) {
    using Coordinates = typename Element::Coordinates;
    constexpr int per_node = Element::fields.count();
    StepForce<Element::dofs> out;
    const Coordinates middle = 0.5 * (e0 + e1);
    const Coordinates change = e1 - e0;
    out.energy = element.energy(e1);
    if (wanted == StepTangent::none) {
        out.force = element.force(middle);
    } else {
        const auto at_middle = element.evaluate(middle);
        out.force = at_middle.force;
        out.tangent = 0.5 * at_middle.tangent;
    }
    const double length = element.length();
    const RigidModes<Element::dimension, Element::dofs> modes(
        middle, [](int k) { return length_power(Element::fields.at(k % per_node)); },
        length * length);
    const Coordinates rest = modes.without(change);
    const Coordinates weighted = modes.weights().cwiseProduct(rest);
    const double square = rest.dot(weighted);
    if (!(square > smallest_change * smallest_change * length * length)) return out;
    const double s = (out.energy - before - out.force.dot(change)) / square;
    if (wanted == StepTangent::exact) {
        const Coordinates end = element.force(e1);
        const auto rest_rate = modes.derivative_of_without(change, rest);
        // d(U_1 - f.De)/de_1 = grad U(e_1) - f - K De/2, and K is symmetric
        Coordinates rate = end - out.force;
        for (int j = 0; j < Element::dofs; ++j)
            for (int i = 0; i < Element::dofs; ++i)
                rate[j] -= out.tangent(i, j) * change[i] + 2.0 * s * rest_rate(i, j) * weighted[i];
        for (int j = 0; j < Element::dofs; ++j)
            for (int i = 0; i < Element::dofs; ++i)
                out.tangent(i, j) +=
                    weighted[i] * rate[j] / square + s * modes.weights()[i] * rest_rate(i, j);
    }
    out.force += s * weighted;
    return out;
}

/// Corrects the middle's gradient G_m of one function of a few nodal vectors to the discrete
/// gradient.
/// @param difference  g(q_1) - g(q_0).
/// @param invariant   whether rigid motions leave g as it is: then the correction moves no
///                    momentum.
template <int Dimension, class Power>
void correct_gradient(double difference, const VectorX& middle, const VectorX& change,
                      bool invariant, const Power& length_power, double length, VectorX& gradient) {
    const RigidModes<Dimension, Eigen::Dynamic> modes(middle, length_power, length * length);
    const VectorX rest = invariant ? modes.without(change) : change;
    const VectorX weighted = modes.weights().cwiseProduct(rest);
    const double square = rest.dot(weighted);
    if (!(square > smallest_change * smallest_change * length * length)) return;
    gradient += (difference - gradient.dot(change)) / square * weighted;
}

}  // namespace ancf::detail
