// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Eigen's sparse direct solvers, for a build that has nothing else.
///
/// Both estimate the condition, so that a matrix that is singular but for round-off is found out.

#pragma once

#include <ancf/error.hpp>
#include <ancf/solver/conditioning.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>

namespace ancf {

/// L D L^T of a symmetric matrix without pivoting, ordered by minimum degree.
///
/// For positive definite matrices, and for indefinite ones that are far from singular in every
/// leading part of that order; saddle points are for EigenLu. `negative_pivots` counts the negative
/// eigenvalues.
class EigenLdlt {
public:
    static constexpr Storage storage = Storage::lower;  ///< the lower half is read

    EigenLdlt() = default;

    /// @param singular_rcond  see default_singular_rcond; 0 refuses zero pivots only.
    explicit EigenLdlt(double singular_rcond) : singular_rcond_(singular_rcond) {
        detail::require_singular_rcond(singular_rcond);
    }

    /// @throws InvalidArgument unless square, compressed and lower.
    void analyze(const SparseMatrix& lower);

    /// Factorises in the pattern analysed.
    /// @throws InvalidArgument if its size or the number of entries in a column differs.
    [[nodiscard]] FactorReport factorize(const SparseMatrix& lower);

    /// Solves A x = b. @throws InvalidArgument unless factorised and b has its size.
    void solve(const VectorX& b, VectorX& x) const;

    /// The word that tables print.
    [[nodiscard]] static constexpr std::string_view name() noexcept { return "eigen-ldlt"; }

private:
    using Ldlt = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<int>>;

    [[nodiscard]] FactorReport examine(const SparseMatrix& lower) const;

    std::unique_ptr<Ldlt> ldlt_;
    detail::SolverStage stage_;
    double singular_rcond_ = default_singular_rcond;
};

/// L U of any square matrix with partial pivoting, columns ordered by COLAMD, rows scaled first.
class EigenLu {
public:
    static constexpr Storage storage = Storage::full;  ///< all entries are read

    EigenLu() = default;

    /// @param singular_rcond  see default_singular_rcond; 0 refuses zero pivots only.
    explicit EigenLu(double singular_rcond) : singular_rcond_(singular_rcond) {
        detail::require_singular_rcond(singular_rcond);
    }

    /// @throws InvalidArgument unless square and compressed.
    void analyze(const SparseMatrix& matrix);

    /// Factorises in the pattern analysed.
    /// @throws InvalidArgument if its size or the number of entries in a column differs.
    [[nodiscard]] FactorReport factorize(const SparseMatrix& matrix);

    /// Solves A x = b. @throws InvalidArgument unless factorised and b has its size.
    void solve(const VectorX& b, VectorX& x) const;

    /// The word that tables print.
    [[nodiscard]] static constexpr std::string_view name() noexcept { return "eigen-lu"; }

private:
    using Lu = Eigen::SparseLU<SparseMatrix, Eigen::COLAMDOrdering<int>>;

    void scale_rows(const SparseMatrix& matrix);
    void substitute(const VectorX& b, VectorX& x) const;

    std::unique_ptr<Lu> lu_;
    SparseMatrix scaled_;
    VectorX row_scale_;
    detail::SolverStage stage_;
    double singular_rcond_ = default_singular_rcond;
};

inline void EigenLdlt::analyze(const SparseMatrix& lower) {
    detail::require_storage(name(), lower, storage);
    stage_.reset();
    ldlt_ = std::make_unique<Ldlt>();
    if (lower.cols() > 0) ldlt_->analyzePattern(lower);
    stage_.analysed(lower);
}

inline FactorReport EigenLdlt::factorize(const SparseMatrix& lower) {
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

inline FactorReport EigenLdlt::examine(const SparseMatrix& lower) const {
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

inline void EigenLdlt::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    x = b.size() > 0 ? VectorX(ldlt_->solve(b)) : b;
}

inline void EigenLu::analyze(const SparseMatrix& matrix) {
    detail::require_storage(name(), matrix, storage);
    stage_.reset();
    lu_ = std::make_unique<Lu>();
    scaled_ = matrix;
    if (matrix.cols() > 0) lu_->analyzePattern(scaled_);
    stage_.analysed(matrix);
}

inline FactorReport EigenLu::factorize(const SparseMatrix& matrix) {
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

inline void EigenLu::scale_rows(const SparseMatrix& matrix) {
    row_scale_ = VectorX::Zero(matrix.rows());
    for (int column = 0; column < matrix.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
            row_scale_[entry.row()] = std::max(row_scale_[entry.row()], std::abs(entry.value()));
    row_scale_ = (row_scale_.array() > 0.0).select(row_scale_.cwiseInverse(), 1.0);
    scaled_ = row_scale_.asDiagonal() * matrix;
}

inline void EigenLu::substitute(const VectorX& b, VectorX& x) const {
    const VectorX scaled = row_scale_.cwiseProduct(b);
    x = lu_->solve(scaled);
}

inline void EigenLu::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    if (b.size() > 0) {
        substitute(b, x);
    } else {
        x = b;
    }
}

}  // namespace ancf
