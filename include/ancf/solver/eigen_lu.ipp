// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <Eigen/SparseLU>

namespace ancf {

template <class Ordering>
struct BasicEigenLu<Ordering>::Factors : Eigen::SparseLU<SparseMatrix, Ordering> {};

template <class Ordering>
void BasicEigenLu<Ordering>::analyze_pattern(const SparseMatrix& matrix) {
    lu_ = detail::hidden<Factors>();
    scaled_ = matrix;
    lu_->analyzePattern(scaled_);
}

template <class Ordering>
FactorReport BasicEigenLu<Ordering>::factorize_values(const SparseMatrix& matrix) {
    if (!detail::all_finite(matrix)) return {Status::not_finite};
    row_scale_ = detail::row_scales(matrix, detail::unit_scales(matrix));
    scaled_ = matrix;
    for (int k = 0; k < detail::entries(matrix); ++k)
        scaled_.valuePtr()[k] *= row_scale_[matrix.innerIndexPtr()[k]];
    lu_->factorize(scaled_);
    return {lu_->info() == Eigen::Success ? Status::converged : Status::singular};
}

template <class Ordering>
void BasicEigenLu<Ordering>::substitute(const VectorX& b, VectorX& x) const {
    const VectorX scaled = row_scale_.cwiseProduct(b);
    x = lu_->solve(scaled);
}

#if defined(ANCF_SOURCE)
template class BasicEigenLu<Eigen::COLAMDOrdering<int>>;
#endif

}  // namespace ancf
