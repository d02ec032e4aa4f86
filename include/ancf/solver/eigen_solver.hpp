// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Eigen's sparse direct solvers, for a build that has nothing else.
///
/// Both estimate the condition, so that a matrix that is singular but for round-off is found out.
/// They are templates of the order of elimination, so that a program compiles only those it uses.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/error.hpp>
#include <ancf/solver/conditioning.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>

namespace ancf {

/// L D L^T of a symmetric matrix without pivoting.
///
/// For positive definite matrices, and for indefinite ones that are far from singular in every
/// leading part of that order; saddle points are for EigenLu. `negative_pivots` counts the negative
/// eigenvalues.
template <class Ordering>
class EigenLdltWith {
public:
    static constexpr Storage storage = Storage::lower;  ///< the lower half is read

    EigenLdltWith() = default;

    /// @param singular_rcond  see default_singular_rcond; 0 refuses zero pivots only.
    explicit EigenLdltWith(double singular_rcond) : singular_rcond_(singular_rcond) {
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
    using Ldlt = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Ordering>;

    [[nodiscard]] FactorReport examine(const SparseMatrix& lower) const;

    std::unique_ptr<Ldlt> ldlt_;
    detail::SolverStage stage_;
    double singular_rcond_ = default_singular_rcond;
};

/// L U of any square matrix with partial pivoting, rows scaled first: the order of pivots of a
/// scene's tangent depends on no unit.
template <class Ordering>
class EigenLuWith {
public:
    static constexpr Storage storage = Storage::full;  ///< all entries are read

    EigenLuWith() = default;

    /// @param singular_rcond  see default_singular_rcond; 0 refuses zero pivots only.
    explicit EigenLuWith(double singular_rcond) : singular_rcond_(singular_rcond) {
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
    using Lu = Eigen::SparseLU<SparseMatrix, Ordering>;

    void scale_rows(const SparseMatrix& matrix);
    void substitute(const VectorX& b, VectorX& x) const;

    std::unique_ptr<Lu> lu_;
    SparseMatrix scaled_;
    VectorX row_scale_;
    detail::SolverStage stage_;
    double singular_rcond_ = default_singular_rcond;
};

using EigenLdlt = EigenLdltWith<Eigen::AMDOrdering<int>>;  ///< ordered by minimum degree
using EigenLu = EigenLuWith<Eigen::COLAMDOrdering<int>>;   ///< ordered by COLAMD

template <class Ordering>
void EigenLdltWith<Ordering>::analyze(const SparseMatrix& lower) {
    detail::require_storage(name(), lower, storage);
    stage_.reset();
    ldlt_ = std::make_unique<Ldlt>();
    if (lower.cols() > 0) ldlt_->analyzePattern(lower);
    stage_.analysed(lower);
}

template <class Ordering>
FactorReport EigenLdltWith<Ordering>::factorize(const SparseMatrix& lower) {
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
FactorReport EigenLdltWith<Ordering>::examine(const SparseMatrix& lower) const {
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
void EigenLdltWith<Ordering>::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    x = b.size() > 0 ? VectorX(ldlt_->solve(b)) : b;
}

template <class Ordering>
void EigenLuWith<Ordering>::analyze(const SparseMatrix& matrix) {
    detail::require_storage(name(), matrix, storage);
    stage_.reset();
    lu_ = std::make_unique<Lu>();
    scaled_ = matrix;
    if (matrix.cols() > 0) lu_->analyzePattern(scaled_);
    stage_.analysed(matrix);
}

template <class Ordering>
FactorReport EigenLuWith<Ordering>::factorize(const SparseMatrix& matrix) {
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
void EigenLuWith<Ordering>::scale_rows(const SparseMatrix& matrix) {
    // entries of a row compare where each unknown is measured by its own scale
    const VectorX scales = detail::unit_scales(matrix);
    row_scale_ = VectorX::Zero(matrix.rows());
    for (int column = 0; column < matrix.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
            row_scale_[entry.row()] =
                std::max(row_scale_[entry.row()], std::abs(entry.value()) * scales[column]);
    row_scale_ = (row_scale_.array() > 0.0).select(row_scale_.cwiseInverse(), 1.0);
    scaled_ = row_scale_.asDiagonal() * matrix;
}

template <class Ordering>
void EigenLuWith<Ordering>::substitute(const VectorX& b, VectorX& x) const {
    const VectorX scaled = row_scale_.cwiseProduct(b);
    x = lu_->solve(scaled);
}

template <class Ordering>
void EigenLuWith<Ordering>::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    if (b.size() > 0) {
        substitute(b, x);
    } else {
        x = b;
    }
}

}  // namespace ancf
