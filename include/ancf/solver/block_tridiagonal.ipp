// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/error.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/block_tridiagonal_kernel.hpp>

namespace ancf {

ANCF_INLINE void BlockTridiagonal::analyze_pattern(const SparseMatrix& lower) {
    layout_ = detail::chain_layout(name(), lower);
    panels_.resize(layout_.panel_entries());
}

ANCF_INLINE FactorReport BlockTridiagonal::factorize_values(const SparseMatrix& lower) {
    detail::require(detail::stays_within(lower, layout_), name(), " analysed another pattern");
    roots_.resize(lower.cols());
    probe_.resize(lower.cols());
    const detail::PivotSummary summary = detail::factorize_chain<double>(
        layout_, {lower.outerIndexPtr(), lower.innerIndexPtr(), lower.valuePtr()}, panels_.data(),
        roots_.data(), probe_.data());
    FactorReport report;
    if (summary.failed_column >= 0) {
        detail::report_failure(lower, summary.failed_column, report);
        return report;
    }
    report.negative_pivots = summary.negative;
    if (!summary.complete) return report;  // the base finds the condition by a solution
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
    detail::solve_chain(layout_, panels_.data(), x.data());
}

}  // namespace ancf
