// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of complex_block_tridiagonal.hpp.

#pragma once

#include <ancf/error.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/block_tridiagonal_kernel.hpp>
#include <ancf/solver/block_tridiagonal_layout.hpp>
#include <ancf/solver/complex_block_tridiagonal.hpp>
#include <ancf/solver/linear_solver.hpp>

#include <cmath>

namespace ancf {

ANCF_INLINE void ComplexBlockTridiagonal::analyze(const SparseMatrix& pattern) {
    detail::require_storage(name(), pattern, Storage::lower);
    const std::vector<int> starts = detail::chain_starts(pattern);
    const int widest = detail::widest_block(starts);
    detail::require(widest <= BlockTridiagonal::max_block, name(),
                    " needs a chain of blocks of at most ", BlockTridiagonal::max_block,
                    " unknowns, got a block of ", widest);
    layout_ =
        detail::block_layout(pattern, starts, detail::fitting_width(widest, detail::BlockWidths()));
    outer_.assign(pattern.outerIndexPtr(), pattern.outerIndexPtr() + pattern.cols() + 1);
    inner_.assign(pattern.innerIndexPtr(), pattern.innerIndexPtr() + pattern.nonZeros());
    const Eigen::Index width = layout_.width;
    panels_.resize(2 * width * width * layout_.blocks());
}

ANCF_INLINE Status
ComplexBlockTridiagonal::factorize(const std::vector<std::complex<double>>& values) {
    detail::require(values.size() == inner_.size(), name(), ": expected ", inner_.size(),
                    " values, got ", values.size());
    for (const std::complex<double>& value : values)
        if (!std::isfinite(value.real()) || !std::isfinite(value.imag())) return Status::not_finite;
    int failed = -1;
    detail::with_block_width(
        layout_.width,
        [&](auto width) {
            using Kernel = detail::BlockKernel<width(), std::complex<double>>;
            failed = Kernel::factorize(layout_, {outer_.data(), inner_.data(), values.data()},
                                       panels_.data(), nullptr, nullptr)
                         .failed_column;
        },
        detail::BlockWidths());
    return failed >= 0 ? Status::singular : Status::converged;
}

ANCF_INLINE void ComplexBlockTridiagonal::solve(ComplexVectorX& b) const {
    detail::with_block_width(
        layout_.width,
        [&](auto width) {
            detail::BlockKernel<width(), std::complex<double>>::solve(layout_, panels_.data(),
                                                                      b.data());
        },
        detail::BlockWidths());
}

}  // namespace ancf
