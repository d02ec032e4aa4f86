// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Eigen's sparse factorisation of symmetric matrices.
///
/// It estimates the condition, so that a matrix that is singular but for round-off is found out.

#pragma once

#include <ancf/solver/conditioning.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <Eigen/OrderingMethods>

#include <memory>
#include <string_view>

namespace ancf {

/// L D L^T of a symmetric matrix without pivoting, ordered by minimum degree.
///
/// For positive definite matrices, and for indefinite ones that are far from singular in every
/// leading part of that order; saddle points are for EigenLu. `negative_pivots` counts the negative
/// eigenvalues.
///
/// A template so that only a program that makes one compiles Eigen's factorisation.
/// @tparam Ordering  Eigen's, of the unknowns
template <class Ordering>
class BasicEigenLdlt final : public LinearSolver {
public:
    BasicEigenLdlt() = default;

    /// @param singular_rcond  see default_singular_rcond; 0 refuses zero pivots only.
    explicit BasicEigenLdlt(double singular_rcond) : singular_rcond_(singular_rcond) {
        detail::require_singular_rcond(singular_rcond);
    }

    /// The lower half is read.
    [[nodiscard]] Storage storage() const noexcept override { return Storage::lower; }

    /// @throws InvalidArgument unless square, compressed and lower.
    void analyze(const SparseMatrix& lower) override;

    /// Factorises in the pattern analysed.
    /// @throws InvalidArgument if its size or the number of entries in a column differs.
    [[nodiscard]] FactorReport factorize(const SparseMatrix& lower) override;

    /// Solves A x = b. @throws InvalidArgument unless factorised and b has its size.
    void solve(const VectorX& b, VectorX& x) const override;

    /// The word that tables print.
    [[nodiscard]] std::string_view name() const noexcept override { return "eigen-ldlt"; }

private:
    struct Factors;  // Eigen's class
    struct Free {
        void operator()(Factors* factors) const noexcept;
    };

    [[nodiscard]] FactorReport examine(const SparseMatrix& lower) const;

    std::unique_ptr<Factors, Free> ldlt_;
    detail::SolverStage stage_;
    double singular_rcond_ = default_singular_rcond;
};

/// The factorisation of a symmetric matrix, ordered by minimum degree.
using EigenLdlt = BasicEigenLdlt<Eigen::AMDOrdering<int>>;

#if defined(ANCF_COMPILED)
extern template class BasicEigenLdlt<Eigen::AMDOrdering<int>>;
#endif

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/eigen_ldlt.ipp>  // IWYU pragma: export
#endif
