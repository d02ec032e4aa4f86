// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/solver/eigen_ldlt.hpp>

#include <Eigen/SparseCholesky>

namespace ancf {

template <class Ordering>
struct BasicEigenLdlt<Ordering>::Factors
    : Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Ordering> {};

template <class Ordering>
void BasicEigenLdlt<Ordering>::analyze_pattern(const SparseMatrix& lower) {
    ldlt_ = detail::hidden<Factors>();
    ldlt_->analyzePattern(lower);
}

template <class Ordering>
FactorReport BasicEigenLdlt<Ordering>::factorize_values(const SparseMatrix& lower) {
    if (!detail::all_finite(lower)) return {Status::not_finite};
    ldlt_->factorize(lower);
    FactorReport report;
    report.negative_pivots = 0;
    const auto& pivots = ldlt_->vectorD();
    for (Eigen::Index k = 0; k < pivots.size(); ++k) {
        if (pivots[k] == 0.0) return {Status::singular, ldlt_->permutationPinv().indices()[k]};
        report.negative_pivots += pivots[k] < 0.0 ? 1 : 0;
    }
    return report;
}

template <class Ordering>
void BasicEigenLdlt<Ordering>::substitute(const VectorX& b, VectorX& x) const {
    x = ldlt_->solve(b);
}

#if defined(ANCF_SOURCE)
template class BasicEigenLdlt<Eigen::AMDOrdering<int>>;
#endif

}  // namespace ancf
