// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of discrete_gradient.hpp.

#pragma once

#include <ancf/dynamics/discrete_gradient.hpp>
#include <ancf/dynamics/turn_stretch.hpp>
#include <ancf/element/fields.hpp>

#include <algorithm>

namespace ancf::detail {

/// Below this size of D, relative to an element, s is set to zero: what U's third derivative makes
/// of it is then below the round-off of U.
inline constexpr double smallest_change = 1e-8;

/// Writes A^-1 g of every nodal vector of a gradient in its place.
ANCF_INLINE void turn_gradient(int dofs, int dimension, const Matrix<double, 3>& inverse,
                               double* gradient) {
    for (int first = 0; first < dofs; first += dimension) {
        double g[3];
        for (int i = 0; i < dimension; ++i) g[i] = gradient[first + i];
        for (int i = 0; i < dimension; ++i) {
            gradient[first + i] = 0.0;
            for (int j = 0; j < dimension; ++j) gradient[first + i] += inverse(i, j) * g[j];
        }
    }
}

/// Makes K(z) the derivative of A^-1 grad U(z) with respect to the later end, where
/// z = centroid + A (e_m - centroid).
/// @param gradient  grad U(z).
ANCF_INLINE void add_stretch_tangent(int dofs, int dimension, const TurnStretch& stretch,
                                     const Vector<double, 3>& turn, const double* change,
                                     const double* gradient, StepForce& step) {
    constexpr int most = ElementGroup::max_dofs;
    double turn_rate[3 * most], moved[3][most] = {}, rates[3][most];
    step.modes.derivative_of_firm_turn(change, turn, turn_rate);
    for (int a = 0; a < 3; ++a) {
        if (dimension == 2 && a < 2) continue;
        // dA/dy_a (e_m - centroid), K of it, and d(A^-1)/dy_a grad U
        const Matrix<double, 3> rate = stretch.rate(a), inverse_rate = stretch.inverse_rate(a);
        for (int first = 0; first < dofs; first += dimension) {
            const Vector<double, 3>& x = step.modes.vector(first / dimension);
            for (int j = 0; j < dimension; ++j) {
                double p = 0.0;
                for (int i = 0; i < dimension; ++i) p += rate(j, i) * x[i];
                const double* const column = step.tangent + dofs * (first + j);
                for (int i = 0; i < dofs; ++i) moved[a][i] += column[i] * p;
            }
            for (int i = 0; i < dimension; ++i) {
                rates[a][first + i] = 0.0;
                for (int j = 0; j < dimension; ++j)
                    rates[a][first + i] += inverse_rate(i, j) * gradient[first + j];
            }
        }
        turn_gradient(dofs, dimension, stretch.inverse(), moved[a]);
        for (int i = 0; i < dofs; ++i) moved[a][i] += rates[a][i];
    }
    for (int first = 0; first < dofs; first += dimension) {
        double* const column = step.tangent + dofs * first;
        for (int i = 0; i < dofs; ++i) {
            double k[3];
            for (int j = 0; j < dimension; ++j) k[j] = 0.5 * column[dofs * j + i];
            for (int j = 0; j < dimension; ++j) {
                double sum = k[j];
                for (int l = 0; l < dimension; ++l) sum += k[l] * stretch.excess()(l, j);
                column[dofs * j + i] = sum;
            }
        }
        for (int j = 0; j < dimension; ++j) {
            turn_gradient(dofs, dimension, stretch.inverse(), column + dofs * j);
            for (int a = dimension == 2 ? 2 : 0; a < 3; ++a) {
                const double y = turn_rate[3 * (first + j) + a];
                for (int i = 0; i < dofs; ++i) column[dofs * j + i] += y * moved[a][i];
            }
        }
    }
}

/// Adds the derivative of s W D to that of the gradient.
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
        // d(U_1 - f.De)/de_1 = grad U(e_1) - f - (df/de_1)^T De
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
    const double length = group.length(prototype);
    const int per_node = group.fields().count();
    const int dimension = dofs / (2 * per_node);
    int power[2 * field_count];
    for (int k = 0; k < 2 * per_node; ++k) power[k] = length_power(group.fields().at(k % per_node));
    out.modes.set(dimension, 2 * per_node, middle, power, length * length);
    const Vector<double, 3> turn = out.modes.firm_turn_of(change);
    const TurnStretch stretch(turn);
    for (int i = 0; i < dofs; ++i) {
        const Vector<double, 3>& x = out.modes.vector(i / dimension);
        for (int j = 0; j < dimension; ++j) middle[i] += stretch.excess()(i % dimension, j) * x[j];
    }
    out.energy = group.energy(prototype, e1);
    if (wanted == StepTangent::none) {
        group.force(prototype, middle, out.force);
    } else {
        group.evaluate(prototype, middle, out.force, out.tangent);
        if (wanted == StepTangent::exact)
            add_stretch_tangent(dofs, dimension, stretch, turn, change, out.force, out);
        else
            for (int i = 0; i < dofs * dofs; ++i) out.tangent[i] *= 0.5;
    }
    turn_gradient(dofs, dimension, stretch.inverse(), out.force);
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
