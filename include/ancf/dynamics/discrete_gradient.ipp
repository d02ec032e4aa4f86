// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of discrete_gradient.hpp.

#pragma once

#include <ancf/dynamics/discrete_gradient.hpp>
#include <ancf/element/fields.hpp>

#include <algorithm>

namespace ancf::detail {

/// Below this size of D, relative to an element, s is set to zero: what U's third derivative makes
/// of it is then below the round-off of U.
inline constexpr double smallest_change = 1e-8;

/// Adds the derivative of s W D to K(e_m)/2.
/// @param end     grad U(e_1).
/// @param square  D.W D.
ANCF_INLINE void add_correction_tangent(int dofs, const double* end, const double* change,
                                        const double* rest, double square, double s,
                                        StepForce& step) {
    double rest_rate[ElementGroup::max_dofs * ElementGroup::max_dofs];
    double weighted[ElementGroup::max_dofs];
    step.modes.derivative_of_without(change, rest, rest_rate);
    for (int i = 0; i < dofs; ++i) weighted[i] = step.modes.weight(i) * rest[i];
    for (int j = 0; j < dofs; ++j) {
        // d(U_1 - f.De)/de_1 = grad U(e_1) - f - K De/2, and K is symmetric
        double* const column = step.tangent + dofs * j;
        const double* const rest_column = rest_rate + dofs * j;
        double rate = end[j] - step.force[j];
        for (int i = 0; i < dofs; ++i)
            rate -= column[i] * change[i] + 2.0 * s * rest_column[i] * weighted[i];
        for (int i = 0; i < dofs; ++i)
            column[i] += weighted[i] * rate / square + s * step.modes.weight(i) * rest_column[i];
    }
}

ANCF_INLINE void step_force(const ElementGroup& group, int prototype, const double* e0,
                            const double* e1, double before, StepTangent wanted, StepForce& out) {
    constexpr int most = ElementGroup::max_dofs;
    const int dofs = group.dofs();
    double middle[most], change[most], rest[most];
    for (int i = 0; i < dofs; ++i) {
        middle[i] = 0.5 * (e0[i] + e1[i]);
        change[i] = e1[i] - e0[i];
    }
    out.energy = group.energy(prototype, e1);
    if (wanted == StepTangent::none) {
        group.force(prototype, middle, out.force);
    } else {
        group.evaluate(prototype, middle, out.force, out.tangent);
        for (int i = 0; i < dofs * dofs; ++i) out.tangent[i] *= 0.5;
    }
    const double length = group.length(prototype);
    const int per_node = group.fields().count();
    int power[2 * field_count];
    for (int k = 0; k < 2 * per_node; ++k) power[k] = length_power(group.fields().at(k % per_node));
    out.modes.set(dofs / (2 * per_node), 2 * per_node, middle, power, length * length);
    out.modes.without(change, rest);
    double square = 0.0, work = 0.0;
    for (int i = 0; i < dofs; ++i) {
        square += rest[i] * out.modes.weight(i) * rest[i];
        work += out.force[i] * change[i];
    }
    if (!(square > smallest_change * smallest_change * length * length)) return;
    const double s = (out.energy - before - work) / square;
    if (wanted == StepTangent::exact) {
        double end[most];
        group.force(prototype, e1, end);
        add_correction_tangent(dofs, end, change, rest, square, s, out);
    }
    for (int i = 0; i < dofs; ++i) out.force[i] += s * out.modes.weight(i) * rest[i];
}

ANCF_INLINE void correct_gradient(int dimension, double difference, const VectorX& middle,
                                  const VectorX& change, bool invariant,
                                  const std::vector<int>& length_power, double length,
                                  VectorX& gradient) {
    RigidModes modes;
    modes.set(dimension, static_cast<int>(length_power.size()), middle.data(), length_power.data(),
              length * length);
    VectorX rest = change;
    if (invariant) modes.without(change.data(), rest.data());
    double square = 0.0, work = 0.0;
    for (int i = 0; i < rest.size(); ++i) {
        square += rest[i] * modes.weight(i) * rest[i];
        work += gradient[i] * change[i];
    }
    if (!(square > smallest_change * smallest_change * length * length)) return;
    const double s = (difference - work) / square;
    for (int i = 0; i < rest.size(); ++i) gradient[i] += s * modes.weight(i) * rest[i];
}

}  // namespace ancf::detail
