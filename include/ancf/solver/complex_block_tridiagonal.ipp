// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of complex_block_tridiagonal.hpp.

#pragma once

#include <ancf/error.hpp>
#include <ancf/solver/block_tridiagonal_kernel.hpp>
#include <ancf/solver/complex_block_tridiagonal.hpp>
#include <ancf/solver/linear_solver.hpp>

#include <cmath>

namespace ancf {

ANCF_INLINE void ComplexBlockTridiagonal::analyze(const SparseMatrix& pattern) {
    detail::require_storage(name(), pattern, Storage::lower);
    layout_ = detail::chain_layout(name(), pattern);
    outer_.assign(pattern.outerIndexPtr(), pattern.outerIndexPtr() + pattern.cols() + 1);
    inner_.assign(pattern.innerIndexPtr(), pattern.innerIndexPtr() + pattern.nonZeros());
    panels_.resize(layout_.panel_entries());
}

ANCF_INLINE Status
ComplexBlockTridiagonal::factorize(const std::vector<std::complex<double>>& values) {
    detail::require(values.size() == inner_.size(), name(), ": expected ", inner_.size(),
                    " values, got ", values.size());
    for (const std::complex<double>& value : values)
        if (!std::isfinite(value.real()) || !std::isfinite(value.imag())) return Status::not_finite;
    const detail::PivotSummary summary = detail::factorize_chain<std::complex<double>>(
        layout_, {outer_.data(), inner_.data(), values.data()}, panels_.data(), nullptr, nullptr);
    return summary.failed_column >= 0 ? Status::singular : Status::converged;
}

ANCF_INLINE void ComplexBlockTridiagonal::solve(ComplexVectorX& b) const {
    detail::solve_chain(layout_, panels_.data(), b.data());
}

}  // namespace ancf
