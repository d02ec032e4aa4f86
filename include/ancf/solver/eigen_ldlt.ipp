// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of eigen_ldlt.hpp.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/solver/eigen_ldlt.hpp>

#include <Eigen/SparseCholesky>

namespace ancf {

template <class Ordering>
struct BasicEigenLdlt<Ordering>::Factors
    : Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Ordering> {};

template <class Ordering>
void BasicEigenLdlt<Ordering>::Free::operator()(Factors* factors) const noexcept {
    delete factors;
}

template <class Ordering>
void BasicEigenLdlt<Ordering>::analyze(const SparseMatrix& lower) {
    detail::require_storage(name(), lower, storage());
    stage_.reset();
    ldlt_.reset(new Factors);
    if (lower.cols() > 0) ldlt_->analyzePattern(lower);
    stage_.analysed(lower);
}

template <class Ordering>
FactorReport BasicEigenLdlt<Ordering>::factorize(const SparseMatrix& lower) {
    stage_.begin_factorisation(name(), lower);
    FactorReport report;
    if (!detail::all_finite(lower)) {
        report.status = Status::not_finite;
    } else if (lower.cols() > 0) {
        ldlt_->factorize(lower);
        report = examine(lower);
    } else {
        report.rcond = 1.0;
        report.negative_pivots = 0;
    }
    return stage_.finished(report);
}

template <class Ordering>
FactorReport BasicEigenLdlt<Ordering>::examine(const SparseMatrix& lower) const {
    FactorReport report;
    report.negative_pivots = 0;
    const auto& pivots = ldlt_->vectorD();
    for (Eigen::Index k = 0; k < pivots.size(); ++k) {
        if (pivots[k] == 0.0) {
            detail::report_failure(lower, ldlt_->permutationPinv().indices()[k], report);
            return report;
        }
        report.negative_pivots += pivots[k] < 0.0 ? 1 : 0;
    }
    const auto substitute = [&](const VectorX& b, VectorX& x) { x = ldlt_->solve(b); };
    detail::report_condition(lower, singular_rcond_, substitute, report);
    return report;
}

template <class Ordering>
void BasicEigenLdlt<Ordering>::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    x = b.size() > 0 ? VectorX(ldlt_->solve(b)) : b;
}

#if defined(ANCF_SOURCE)
template class BasicEigenLdlt<Eigen::AMDOrdering<int>>;
#endif

}  // namespace ancf
