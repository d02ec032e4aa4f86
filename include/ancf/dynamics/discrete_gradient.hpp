// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Forces of a step that do exactly the work by which an energy changes, without moving momenta.
///
/// With the middle e_m of a step, the change De and its part D that no rigid motion at e_m
/// explains, u the mean of both ends without their turn, S the symmetric part of half that turn
/// (HalfTurn) and x the nodal vectors of e_m:
///
///     f = f_0 + s W D,   f_0 = S grad U(u) + W (mu x x),   s = (U(e_1) - U(e_0) - f_0.De)/(D.W D).
///
/// f.De = U(e_1) - U(e_0), and f has neither a resultant nor a moment. docs/theory-dynamics.md.

#pragma once

#include <ancf/dynamics/rigid_modes.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/list.hpp>
#include <ancf/model/element_group.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ancf::detail {

/// What a step needs of one element, and the memory to compute it; of its dofs() coordinates.
struct StepForce {
    double energy = 0.0;                                              ///< U(e_1), J
    double force[ElementGroup::max_dofs];                             ///< f
    double tangent[ElementGroup::max_dofs * ElementGroup::max_dofs];  ///< df/de_1, by columns
    RigidModes modes;                                                 ///< at the middle
};

/// How much of the tangent is wanted.
enum class StepTangent {
    none,
    symmetric,  ///< K(u)/2: what a solver of symmetric matrices can take
    exact       ///< with the derivative of s W D, unsymmetric
};

/// Below this size of D, relative to an element, s is set to zero: what U's third derivative makes
/// of it is then below the round-off of U.
inline constexpr double smallest_change = 1e-8;

/// One element over a step, in the frame of its middle.
struct TurnedStep {
    int dofs, dimension;
    HalfTurn half;
    /// x and d of every nodal vector: at the middle, and half of its change.
    std::array<Vector<double, 3>, 2 * field_count> at, by;
    std::array<Vector<double, 3>, 2 * field_count> arm;       ///< X (u_1 - u_0)
    std::array<Vector<double, 3>, 2 * field_count> gradient;  ///< g = grad U(u)
    Vector<double, 3> spin;                                   ///< mu = J^-1 kappa

    [[nodiscard]] int vectors() const noexcept { return dofs / dimension; }

    /// Returns R^T v.
    [[nodiscard]] Vector<double, 3> back(const Vector<double, 3>& v) const {
        return half.symmetric(v) - half.skew(v);
    }

    /// Adds a nodal vector to coordinates.
    void add(double* e, int k, const Vector<double, 3>& v) const {
        for (int i = 0; i < dimension; ++i) e[dimension * k + i] += v[i];
    }
};

/// Replaces g by f_0 = S g + W (mu x x). f_0 has neither a resultant nor a moment.
inline void turned_force(TurnedStep& step, StepForce& out) {
    Vector<double, 3> moment = Vector<double, 3>::Zero();
    for (int k = 0; k < step.vectors(); ++k) {
        step.gradient[k] = out.modes.component(out.force, k);
        const Vector<double, 3> turned = step.half.symmetric(step.gradient[k]);
        moment -= 0.5 * cross(step.arm[k], turned);
        for (int i = 0; i < step.dimension; ++i) out.force[step.dimension * k + i] = turned[i];
    }
    step.spin = out.modes.spin_of(moment);
    for (int k = 0; k < step.vectors(); ++k) {
        step.add(out.force, k, out.modes.weight_of(k) * cross(step.spin, step.at[k]));
    }
}

/// Makes K(u) the derivative of turned_force() with respect to the later end.
/// @param turn    y.
/// @param whole   e_1 - e_0.
inline void add_turn_tangent(const TurnedStep& step, const Vector<double, 3>& turn,
                             const double* whole, StepForce& out) {
    constexpr int most = ElementGroup::max_dofs;
    const int dofs = step.dofs, dimension = step.dimension, vectors = step.vectors();
    const int first_axis = dimension == 2 ? 2 : 0;
    double turn_rate[3 * most];
    out.modes.derivative_of_firm_turn(whole, turn, turn_rate);
    // by y: of g, of S g but for g, and of kappa but for S g
    double gradient_rate[3][most] = {}, turned_rate[3][most] = {};
    Vector<double, 3> moment_rate[3];
    for (int b = first_axis; b < 3; ++b) {
        moment_rate[b].setZero();
        for (int k = 0; k < vectors; ++k) {
            const Vector<double, 3>&x = step.at[k], &d = step.by[k], &g = step.gradient[k];
            const Vector<double, 3> mean =
                step.half.symmetric_rate(b, x) - step.half.skew_rate(b, d);
            for (int j = 0; j < dimension; ++j)
                for (int i = 0; i < dofs; ++i)
                    gradient_rate[b][i] += out.tangent[dofs * (dimension * k + j) + i] * mean[j];
            step.add(turned_rate[b], k, step.half.symmetric_rate(b, g));
            const Vector<double, 3> change =
                2.0 * (step.half.symmetric_rate(b, d) - step.half.skew_rate(b, x));
            const Vector<double, 3> moved =
                step.half.skew(change) +
                step.half.skew_rate(b, 2.0 * (step.half.symmetric(d) - step.half.skew(x)));
            moment_rate[b] -= 0.5 * cross(moved, step.half.symmetric(g));
        }
    }
    double tangent[most * most];
    for (int m = 0; m < vectors; ++m)
        for (int j = 0; j < dimension; ++j) {
            const double* const by_turn = turn_rate + 3 * (dimension * m + j);
            double* const column = tangent + dofs * (dimension * m + j);
            const Vector<double, 3> unit = Vector<double, 3>::Unit(j);
            const Vector<double, 3> back = step.back(unit);
            double rate[most];  // of g
            for (int i = 0; i < dofs; ++i) {
                rate[i] = 0.0;
                for (int l = 0; l < dimension; ++l)
                    rate[i] += 0.5 * out.tangent[dofs * (dimension * m + l) + i] * back[l];
                for (int b = first_axis; b < 3; ++b) rate[i] += gradient_rate[b][i] * by_turn[b];
            }
            Vector<double, 3> moment =
                -0.5 * cross(step.half.skew(back), step.half.symmetric(step.gradient[m]));
            for (int b = first_axis; b < 3; ++b) moment += by_turn[b] * moment_rate[b];
            for (int k = 0; k < vectors; ++k) {
                Vector<double, 3> turned = step.half.symmetric(out.modes.component(rate, k));
                for (int b = first_axis; b < 3; ++b)
                    turned += by_turn[b] * out.modes.component(turned_rate[b], k);
                moment -= 0.5 * cross(step.arm[k], turned);
                for (int i = 0; i < dimension; ++i) column[dimension * k + i] = turned[i];
            }
            // x moves by half a unit: the inertia and the arms with it
            const double weight = out.modes.weight_of(m);
            const Vector<double, 3>& x = step.at[m];
            const Vector<double, 3> arm = 0.5 * weight * cross(step.spin, unit);
            moment -= 0.5 * weight * cross(unit, cross(step.spin, x)) + cross(x, arm);
            const Vector<double, 3> spin = out.modes.spin_of(moment);
            for (int k = 0; k < vectors; ++k) {
                step.add(column, k, out.modes.weight_of(k) * cross(spin, step.at[k]));
                if (out.modes.is_position(m) && out.modes.is_position(k))
                    step.add(column, k, -arm / out.modes.positions());
            }
            step.add(column, m, arm);
        }
    std::copy_n(tangent, dofs * dofs, out.tangent);
}

/// Adds the derivative of s W D to that of the gradient.
/// @param end     grad U(e_1).
/// @param square  D.W D.
inline void add_correction_tangent(int dofs, const double* end, const double* change,
                                   const double* rest, double square, double s, StepForce& step) {
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

/// Evaluates one element, given by its prototype, over a step.
/// @param before  U(e_0), J.
inline void step_force(const ElementGroup& group, int prototype, const double* e0, const double* e1,
                       double before, StepTangent wanted, StepForce& out) {
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
    TurnedStep step{dofs, dimension, HalfTurn(turn), {}, {}, {}, {}, {}};
    const Vector<double, 3> shift = 0.5 * out.modes.shift_of(change);
    for (int k = 0; k < step.vectors(); ++k) {
        Vector<double, 3>&x = step.at[k], &d = step.by[k];
        x = out.modes.vector(k);
        d = 0.5 * out.modes.component(change, k);
        if (out.modes.is_position(k)) d -= shift;
        Vector<double, 3> mean;
        step.half.middle(x, d, mean, step.arm[k]);
        step.add(middle, k, mean - x);
    }
    out.energy = group.energy(prototype, e1);
    if (wanted == StepTangent::none)
        group.force(prototype, middle, out.force);
    else
        group.evaluate(prototype, middle, out.force, out.tangent);
    turned_force(step, out);
    if (wanted == StepTangent::exact) add_turn_tangent(step, turn, change, out);
    if (wanted == StepTangent::symmetric)
        for (int i = 0; i < dofs * dofs; ++i) out.tangent[i] *= 0.5;
    out.modes.without(change, rest);
    double square = 0.0, work = 0.0, round_off = 0.0;
    for (int k = 0; k < step.vectors(); ++k)
        for (int i = dimension * k; i < dimension * (k + 1); ++i) {
            square += rest[i] * out.modes.weight_of(k) * rest[i];
            work += out.force[i] * change[i];
            round_off += std::abs(out.force[i]) * std::max(std::abs(e0[i]), std::abs(e1[i]));
        }
    round_off *= std::numeric_limits<double>::epsilon();  // of U
    const double missed = out.energy - before - work;
    if (!(square > smallest_change * smallest_change * length * length)) return;
    if (std::abs(missed) <= round_off) return;  // NaN goes on into the force
    const double s = missed / square;
    if (wanted == StepTangent::exact) {
        double end[most];
        group.force(prototype, e1, end);
        add_correction_tangent(dofs, end, change, rest, square, s, out);
    }
    for (int k = 0; k < step.vectors(); ++k)
        step.add(out.force, k, s * out.modes.weight_of(k) * out.modes.component(rest, k));
}

/// Corrects the middle's gradient G_m of one function of a few nodal vectors to the discrete
/// gradient.
/// @param difference    g(q_1) - g(q_0).
/// @param length_power  of each vector's unit.
/// @param invariant     whether rigid motions leave g as it is: then the correction moves no
///                      momentum.
inline void correct_gradient(int dimension, double difference, const VectorX& middle,
                             const VectorX& change, bool invariant, const List<int>& length_power,
                             double length, VectorX& gradient) {
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
