// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of block_tridiagonal.hpp.

#pragma once

#include <ancf/error.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/block_tridiagonal_kernel.hpp>
#include <ancf/solver/block_tridiagonal_layout.hpp>
#include <ancf/solver/direct_solver.hpp>

#include <vector>

namespace ancf {

ANCF_INLINE void BlockTridiagonal::analyze_pattern(const SparseMatrix& lower) {
    const std::vector<int> starts = detail::chain_starts(lower);
    const int widest = detail::widest_block(starts);
    detail::require(widest <= max_block, name(), " needs a chain of blocks of at most ", max_block,
                    " unknowns, got a block of ", widest);
    layout_ =
        detail::block_layout(lower, starts, detail::fitting_width(widest, detail::BlockWidths()));
    const Eigen::Index width = layout_.width;
    panels_.resize(2 * width * width * layout_.blocks());
}

ANCF_INLINE FactorReport BlockTridiagonal::factorize_values(const SparseMatrix& lower) {
    detail::require(detail::stays_within(lower, layout_), name(), " analysed another pattern");
    roots_.resize(lower.cols());
    probe_.resize(lower.cols());
    detail::PivotSummary summary;
    detail::with_block_width(
        layout_.width,
        [&](auto width) {
            using Kernel = detail::BlockKernel<width()>;
            summary = Kernel::factorize(
                layout_, {lower.outerIndexPtr(), lower.innerIndexPtr(), lower.valuePtr()},
                panels_.data(), roots_.data(), probe_.data());
            if (summary.complete || summary.failed_column >= 0) return;
            detail::symmetric_roots(lower, roots_);
            summary.weights = detail::probe_load(roots_, probe_);
            summary.energy = Kernel::probe_energy(layout_, panels_.data(), probe_.data());
        },
        detail::BlockWidths());
    FactorReport report;
    if (summary.failed_column >= 0) {
        detail::report_failure(lower, summary.failed_column, report);
        return report;
    }
    report.negative_pivots = summary.negative;
    report.rcond = detail::rcond_by_energy(summary.weights, summary.energy);
    if (!(report.rcond > singular_rcond())) {
        detail::probe_load(roots_, probe_);
        substitute(probe_, probe_);
        detail::report_failure(lower, detail::softest_unknown(roots_, probe_), report);
    }
    return report;
}

ANCF_INLINE void BlockTridiagonal::substitute(const VectorX& b, VectorX& x) const {
    if (&x != &b) x = b;
    detail::with_block_width(
        layout_.width,
        [&](auto width) { detail::BlockKernel<width()>::solve(layout_, panels_.data(), x.data()); },
        detail::BlockWidths());
}

}  // namespace ancf
