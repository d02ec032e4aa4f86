// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of eigen_lu.hpp.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <Eigen/SparseLU>

namespace ancf {

template <class Ordering>
struct BasicEigenLu<Ordering>::Factors : Eigen::SparseLU<SparseMatrix, Ordering> {};

template <class Ordering>
void BasicEigenLu<Ordering>::Free::operator()(Factors* factors) const noexcept {
    delete factors;
}

template <class Ordering>
void BasicEigenLu<Ordering>::analyze(const SparseMatrix& matrix) {
    detail::require_storage(name(), matrix, storage());
    stage_.reset();
    lu_.reset(new Factors);
    scaled_ = matrix;
    if (matrix.cols() > 0) lu_->analyzePattern(scaled_);
    stage_.analysed(matrix);
}

template <class Ordering>
FactorReport BasicEigenLu<Ordering>::factorize(const SparseMatrix& matrix) {
    stage_.begin_factorisation(name(), matrix);
    FactorReport report;
    if (!detail::all_finite(matrix)) {
        report.status = Status::not_finite;
    } else if (matrix.cols() > 0) {
        scale_rows(matrix);
        lu_->factorize(scaled_);
        const auto substitute = [&](const VectorX& right, VectorX& x) {
            this->substitute(right, x);
        };
        if (lu_->info() == Eigen::Success) {
            detail::report_condition(matrix, singular_rcond_, substitute, report);
        } else {
            detail::report_failure(matrix, -1, report);
        }
    } else {
        report.rcond = 1.0;
    }
    return stage_.finished(report);
}

template <class Ordering>
void BasicEigenLu<Ordering>::scale_rows(const SparseMatrix& matrix) {
    row_scale_ = detail::row_scales(matrix, detail::unit_scales(matrix));
    scaled_ = row_scale_.asDiagonal() * matrix;
}

template <class Ordering>
void BasicEigenLu<Ordering>::substitute(const VectorX& b, VectorX& x) const {
    const VectorX scaled = row_scale_.cwiseProduct(b);
    x = lu_->solve(scaled);
}

template <class Ordering>
void BasicEigenLu<Ordering>::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    if (b.size() > 0) {
        substitute(b, x);
    } else {
        x = b;
    }
}

#if defined(ANCF_SOURCE)
template class BasicEigenLu<Eigen::COLAMDOrdering<int>>;
#endif

}  // namespace ancf
