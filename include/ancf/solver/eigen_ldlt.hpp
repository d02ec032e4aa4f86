// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Eigen's sparse factorisation of symmetric matrices.

#pragma once

#include <ancf/solver/direct_solver.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <Eigen/OrderingMethods>

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
class BasicEigenLdlt final : public detail::DirectSolver {
public:
    /// @param singular_rcond  see default_singular_rcond; 0 refuses zero pivots only.
    /// @throws InvalidArgument for one outside of [0, 1).
    explicit BasicEigenLdlt(double singular_rcond = default_singular_rcond)
        : DirectSolver(singular_rcond) {}

    /// The lower half is read.
    [[nodiscard]] Storage storage() const noexcept override { return Storage::lower; }

    [[nodiscard]] std::string_view name() const noexcept override { return "eigen-ldlt"; }

private:
    struct Factors;  // Eigen's class

    void analyze_pattern(const SparseMatrix& lower) override;
    [[nodiscard]] FactorReport factorize_values(const SparseMatrix& lower) override;
    void substitute(const VectorX& b, VectorX& x) const override;

    detail::Hidden<Factors> ldlt_{nullptr, nullptr};
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
