// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of jacobian_map.hpp.

#pragma once

#include <ancf/sundials/jacobian_map.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ancf::sundials::detail {

ANCF_INLINE void JacobianMap::append(const SparseMatrix& pattern, int column, int from, int to,
                                     int shift, std::vector<sunindextype>& place) {
    for (int k = pattern.outerIndexPtr()[column]; k < pattern.outerIndexPtr()[column + 1]; ++k) {
        const int row = pattern.innerIndexPtr()[k];
        if (row < from || row >= to) continue;
        place[k] = static_cast<sunindextype>(inner_.size());
        inner_.push_back(static_cast<sunindextype>(row) + shift);
    }
}

ANCF_INLINE JacobianMap::JacobianMap(const SparseMatrix& pattern, int n, Form form)
    : n_(n), form_(form) {
    const int all = static_cast<int>(pattern.cols());
    const int m = all - n;
    const bool stabilised = form == Form::gear_gupta_leimkuhler;
    static_cast<void>(checked_index(2 * pattern.cols(), "unknowns"));  // and so every row of J fits
    const auto count = static_cast<std::size_t>(pattern.nonZeros());
    motion_.assign(count, -1);
    rate_.assign(count, -1);
    kinematic_.assign(count, -1);
    kinematic_v_.assign(count, -1);
    for (int j = 0; j < n; ++j) {  // q
        if (stabilised)
            append(pattern, j, 0, n, 0, kinematic_);
        else
            append_unit(j);
        append(pattern, j, 0, all, n, motion_);
        if (stabilised) append(pattern, j, n, all, n + m, kinematic_);
        close_column();
    }
    for (int j = 0; j < n; ++j) {  // v
        if (stabilised)
            append(pattern, j, 0, n, 0, kinematic_v_);
        else
            append_unit(j);
        append(pattern, j, 0, n, n, rate_);
        if (stabilised) append(pattern, j, n, all, n + m, kinematic_v_);
        close_column();
    }
    for (int j = n; j < all; ++j) {  // lambda
        append(pattern, j, 0, all, n, motion_);
        close_column();
    }
    for (int j = n; stabilised && j < all; ++j) {  // mu
        append(pattern, j, 0, n, 0, kinematic_);
        append(pattern, j, n, all, n + m, kinematic_);
        close_column();
    }
}

ANCF_INLINE void JacobianMap::fill(const JacobianParts& parts, double c, sunindextype* outer,
                                   sunindextype* inner, double* values) const noexcept {
    std::copy(outer_.begin(), outer_.end(), outer);
    std::copy(inner_.begin(), inner_.end(), inner);
    const SparseMatrix& pattern = parts.tangent;
    const double* tangent = parts.tangent.valuePtr();
    const double* mass = parts.mass.valuePtr();
    const double* damping = parts.damping != nullptr ? parts.damping->valuePtr() : nullptr;
    if (form_ == Form::index3)
        for (int j = 0; j < n_; ++j) {
            values[outer_[j]] = c;
            values[outer_[n_ + j]] = -1.0;
        }
    for (std::size_t k = 0; k < motion_.size(); ++k) {
        values[motion_[k]] = tangent[k];
        if (rate_[k] >= 0) values[rate_[k]] = c * mass[k] + (damping != nullptr ? damping[k] : 0.0);
    }
    if (form_ == Form::index3) return;
    const double* level = parts.velocity_level->valuePtr();
    for (int j = 0; j < static_cast<int>(pattern.cols()); ++j)
        for (int at = pattern.outerIndexPtr()[j]; at < pattern.outerIndexPtr()[j + 1]; ++at) {
            const auto k = static_cast<std::size_t>(at);
            const bool inertia = j < n_ && pattern.innerIndexPtr()[at] < n_;
            const bool of_q = j < n_;
            values[kinematic_[k]] = of_q ? level[k] + (inertia ? c * mass[k] : 0.0) : tangent[k];
            if (of_q) values[kinematic_v_[k]] = inertia ? -mass[k] : tangent[k];
        }
}

}  // namespace ancf::sundials::detail
