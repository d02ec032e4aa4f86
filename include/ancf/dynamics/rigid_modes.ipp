// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of rigid_modes.hpp.

#pragma once

#include <ancf/dynamics/rigid_modes.hpp>

#include <algorithm>
#include <cmath>

namespace ancf::detail {

ANCF_INLINE Vector<double, 3> RigidModes::component(const double* x, std::size_t k) const {
    const double* const at = x + static_cast<std::size_t>(dimension_) * k;
    return {at[0], at[1], dimension_ == 3 ? at[2] : 0.0};
}

ANCF_INLINE void RigidModes::subtract(std::size_t k, const Vector<double, 3>& turn,
                                      const Vector<double, 3>& shift, double* x) const {
    double* const at = x + static_cast<std::size_t>(dimension_) * k;
    const Vector<double, 3> turned = cross(turn, vectors_[k].value);
    for (int i = 0; i < dimension_; ++i) {
        at[i] -= turned[i];
        if (vectors_[k].position) at[i] -= shift[i];
    }
}

ANCF_INLINE void RigidModes::set(int dimension, int count, const double* e, const int* length_power,
                                 double slope_weight) {
    dimension_ = dimension;
    positions_ = 0.0;
    vectors_.resize(static_cast<std::size_t>(count));
    Vector<double, 3> centroid = Vector<double, 3>::Zero();
    for (std::size_t k = 0; k < vectors_.size(); ++k) {
        NodalVector& vector = vectors_[k];
        vector.value = component(e, k);
        vector.position = length_power[k] > 0;
        vector.weight = slope_weight;
        if (length_power[k] < 0) vector.weight *= slope_weight;
        if (!vector.position) continue;
        vector.weight = 1.0;
        centroid += vector.value;
        positions_ += 1.0;
    }
    if (positions_ > 0.0) centroid /= positions_;
    Matrix<double, 3> inertia = Matrix<double, 3>::Zero();
    for (NodalVector& vector : vectors_) {
        Vector<double, 3>& x = vector.value;
        if (vector.position) x -= centroid;
        const double square = vector.weight * (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        if (dimension == 2) {  // about the normal alone
            for (int i = 0; i < 3; ++i) inertia(i, i) += square;
            continue;
        }
        for (int i = 0; i < 3; ++i) {
            inertia(i, i) += square;
            for (int j = 0; j < 3; ++j) inertia(i, j) -= vector.weight * x[i] * x[j];
        }
    }
    // a turn that moves nothing (a straight cable's about itself) has no inertia
    const double floor = 1e-15 * (inertia(0, 0) + inertia(1, 1) + inertia(2, 2));
    for (int i = 0; i < 3; ++i) inertia(i, i) += floor > 0.0 ? floor : 1.0;
    inertia_ = SmallCholesky<3>(inertia);
    // constant, so that it has no derivative
    for (int i = 0; i < 3; ++i) inertia(i, i) += 1e-6 * slope_weight;
    firm_inertia_ = SmallCholesky<3>(inertia);
}

ANCF_INLINE Vector<double, 3> RigidModes::moment_of(const double* change) const {
    Vector<double, 3> moment = Vector<double, 3>::Zero();
    for (std::size_t k = 0; k < vectors_.size(); ++k)
        moment += vectors_[k].weight * cross(vectors_[k].value, component(change, k));
    return moment;
}

ANCF_INLINE Vector<double, 3> RigidModes::shift_of(const double* change) const {
    Vector<double, 3> shift = Vector<double, 3>::Zero();
    for (std::size_t k = 0; k < vectors_.size(); ++k)
        if (vectors_[k].position) shift += component(change, k);
    if (positions_ > 0.0) shift /= positions_;
    return shift;
}

ANCF_INLINE Vector<double, 3> RigidModes::turn_of(const double* change) const {
    return inertia_.solve(moment_of(change));
}

ANCF_INLINE Vector<double, 3> RigidModes::firm_turn_of(const double* change) const {
    return firm_inertia_.solve(moment_of(change));
}

ANCF_INLINE void RigidModes::derivative_of_firm_turn(const double* change,
                                                     const Vector<double, 3>& turn,
                                                     double* out) const {
    const Vector<double, 3> shift = shift_of(change);
    for (std::size_t k = 0; k < vectors_.size(); ++k) {
        const NodalVector& vector = vectors_[k];
        Vector<double, 3> left = component(change, k) - cross(turn, vector.value);
        if (vector.position) left -= shift;
        for (int i = 0; i < dimension_; ++i) {
            // one vector alone changes, by d
            Vector<double, 3> d = Vector<double, 3>::Zero();
            d[i] = 1.0;
            const Vector<double, 3> kept = d - 0.5 * cross(turn, d);
            const Vector<double, 3> moment =
                vector.weight * (cross(vector.value, kept) + 0.5 * cross(d, left));
            const Vector<double, 3> rate = firm_inertia_.solve(moment);
            for (int a = 0; a < 3; ++a) *out++ = rate[a];
        }
    }
}

ANCF_INLINE void RigidModes::without(const double* change, double* rest) const {
    const Vector<double, 3> shift = shift_of(change);
    const Vector<double, 3> turn = turn_of(change);
    std::copy_n(change, static_cast<std::size_t>(dimension_) * vectors_.size(), rest);
    for (std::size_t k = 0; k < vectors_.size(); ++k) subtract(k, turn, shift, rest);
}

ANCF_INLINE void RigidModes::derivative_of_without(const double* change, const double* rest,
                                                   double* out) const {
    const Vector<double, 3> y = turn_of(change);
    const std::size_t size = static_cast<std::size_t>(dimension_) * vectors_.size();
    for (std::size_t k = 0; k < vectors_.size(); ++k)
        for (int i = 0; i < dimension_; ++i) {
            // one vector alone changes, by d: what is left of (I - Y/2) d, and the turn of C d/2
            const NodalVector& vector = vectors_[k];
            Vector<double, 3> d = Vector<double, 3>::Zero();
            d[i] = 1.0;
            const Vector<double, 3> kept = d - 0.5 * cross(y, d);
            const Vector<double, 3> moment = vector.weight * cross(vector.value, kept) +
                                             0.5 * vector.weight * cross(d, component(rest, k));
            const Vector<double, 3> turn = inertia_.solve(moment);
            Vector<double, 3> shift = Vector<double, 3>::Zero();
            if (vector.position) shift = kept / positions_;
            std::fill_n(out, size, 0.0);
            for (int j = 0; j < dimension_; ++j)
                out[static_cast<std::size_t>(dimension_) * k + static_cast<std::size_t>(j)] =
                    kept[j];
            for (std::size_t j = 0; j < vectors_.size(); ++j) subtract(j, turn, shift, out);
            out += size;
        }
}

ANCF_INLINE HalfTurn::HalfTurn(const Vector<double, 3>& turn)
    : a_(std::sqrt(1.0 + 0.25 * turn.dot(turn))), over_(1.0 / a_), stretch_(a_ / (1.0 + a_)) {
    half_ = 0.5 * over_ * turn;
}

ANCF_INLINE Vector<double, 3> HalfTurn::symmetric_rate(int b, const Vector<double, 3>& v) const {
    // S = (I + y y^T/(4 (1 + a)))/a with y = 2 a half_ and da/dy_b = half_/2
    const double fall = 0.5 * half_[b], share = 0.25 / (1.0 + a_);
    const double along = 2.0 * a_ * half_.dot(v);
    Vector<double, 3> out = 2.0 * a_ * share * (v[b] - 4.0 * share * fall * along) * half_;
    out[b] += share * along;
    return over_ * (out - fall * symmetric(v));
}

ANCF_INLINE Vector<double, 3> HalfTurn::skew_rate(int b, const Vector<double, 3>& v) const {
    Vector<double, 3> axis = Vector<double, 3>::Zero();
    axis[b] = 1.0;
    return 0.5 * over_ * (cross(axis, v) - half_[b] * skew(v));
}

}  // namespace ancf::detail
