// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Eigen's sparse factorisation of any square matrix.
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

/// L U of any square matrix with partial pivoting, columns ordered by COLAMD, rows scaled first:
/// the order of pivots of a scene's tangent depends on no unit.
///
/// A template so that only a program that makes one compiles Eigen's factorisation.
/// @tparam Ordering  Eigen's, of the columns
template <class Ordering>
class BasicEigenLu final : public LinearSolver {
public:
    BasicEigenLu() = default;

    /// @param singular_rcond  see default_singular_rcond; 0 refuses zero pivots only.
    explicit BasicEigenLu(double singular_rcond) : singular_rcond_(singular_rcond) {
        detail::require_singular_rcond(singular_rcond);
    }

    /// All entries are read.
    [[nodiscard]] Storage storage() const noexcept override { return Storage::full; }

    /// @throws InvalidArgument unless square and compressed.
    void analyze(const SparseMatrix& matrix) override;

    /// Factorises in the pattern analysed.
    /// @throws InvalidArgument if its size or the number of entries in a column differs.
    [[nodiscard]] FactorReport factorize(const SparseMatrix& matrix) override;

    /// Solves A x = b. @throws InvalidArgument unless factorised and b has its size.
    void solve(const VectorX& b, VectorX& x) const override;

    /// The word that tables print.
    [[nodiscard]] std::string_view name() const noexcept override { return "eigen-lu"; }

private:
    struct Factors;  // Eigen's class
    struct Free {
        void operator()(Factors* factors) const noexcept;
    };

    void scale_rows(const SparseMatrix& matrix);
    void substitute(const VectorX& b, VectorX& x) const;

    std::unique_ptr<Factors, Free> lu_;
    SparseMatrix scaled_;
    VectorX row_scale_;
    detail::SolverStage stage_;
    double singular_rcond_ = default_singular_rcond;
};

/// The factorisation of any square matrix, columns ordered by COLAMD.
using EigenLu = BasicEigenLu<Eigen::COLAMDOrdering<int>>;

#if defined(ANCF_COMPILED)
extern template class BasicEigenLu<Eigen::COLAMDOrdering<int>>;
#endif

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/eigen_lu.ipp>  // IWYU pragma: export
#endif
