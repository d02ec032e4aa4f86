// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of half_turn.hpp.

#pragma once

#include <ancf/dynamics/half_turn.hpp>

#include <cmath>

namespace ancf::detail {

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
