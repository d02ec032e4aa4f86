// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Eigen's sparse factorisation of any square matrix.

#pragma once

#include <ancf/solver/direct_solver.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <Eigen/OrderingMethods>

#include <string_view>

namespace ancf {

/// L U of any square matrix with partial pivoting, columns ordered by COLAMD, rows scaled first:
/// the order of pivots of a scene's tangent depends on no unit.
///
/// A template so that only a program that makes one compiles Eigen's factorisation.
/// @tparam Ordering  Eigen's, of the columns
template <class Ordering>
class BasicEigenLu final : public detail::DirectSolver {
public:
    /// @param singular_rcond  see default_singular_rcond; 0 refuses zero pivots only.
    /// @throws InvalidArgument for one outside of [0, 1).
    explicit BasicEigenLu(double singular_rcond = default_singular_rcond)
        : DirectSolver(singular_rcond) {}

    /// All entries are read.
    [[nodiscard]] Storage storage() const noexcept override { return Storage::full; }

    [[nodiscard]] std::string_view name() const noexcept override { return "eigen-lu"; }

private:
    struct Factors;  // Eigen's class

    void analyze_pattern(const SparseMatrix& matrix) override;
    [[nodiscard]] FactorReport factorize_values(const SparseMatrix& matrix) override;
    void substitute(const VectorX& b, VectorX& x) const override;

    detail::Hidden<Factors> lu_{nullptr, nullptr};
    SparseMatrix scaled_;
    VectorX row_scale_;
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
