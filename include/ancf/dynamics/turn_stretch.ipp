// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of turn_stretch.hpp.

#pragma once

#include <ancf/dynamics/turn_stretch.hpp>

#include <cmath>

namespace ancf::detail {

ANCF_INLINE TurnStretch::TurnStretch(const Vector<double, 3>& turn) : turn_(turn) {
    const double quarter = 0.25 * (turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2]);
    across_ = std::sqrt(1.0 + quarter);
    const double share = 0.25 / (1.0 + across_);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double product = share * turn[i] * turn[j];
            // a - 1 to every digit
            excess_(i, j) = (i == j ? quarter / (1.0 + across_) : 0.0) - product;
            inverse_(i, j) = ((i == j ? 1.0 : 0.0) + product) / across_;
        }
}

ANCF_INLINE Matrix<double, 3> TurnStretch::product_rate(int k) const {
    const double share = 0.25 / (1.0 + across_);
    const double fall = 4.0 * share * share * turn_[k] / (4.0 * across_);
    Matrix<double, 3> out;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            out(i, j) = -fall * turn_[i] * turn_[j];
            if (i == k) out(i, j) += share * turn_[j];
            if (j == k) out(i, j) += share * turn_[i];
        }
    return out;
}

ANCF_INLINE Matrix<double, 3> TurnStretch::rate(int a) const {
    Matrix<double, 3> out = product_rate(a);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            out(i, j) = (i == j ? turn_[a] / (4.0 * across_) : 0.0) - out(i, j);
    return out;
}

ANCF_INLINE Matrix<double, 3> TurnStretch::inverse_rate(int a) const {
    Matrix<double, 3> out = product_rate(a);
    const double fall = turn_[a] / (4.0 * across_);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) out(i, j) = (out(i, j) - fall * inverse_(i, j)) / across_;
    return out;
}

}  // namespace ancf::detail
