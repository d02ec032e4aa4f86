// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// L D L^T of a sparse symmetric matrix: the mass matrix and the saddle points of starts and
/// projections.
///
/// Row by row in the order of approximate minimum degree, pivots of either sign (Davis, ACM
/// Transactions on Mathematical Software 31, 2005, Algorithm 849). Of Eigen it needs the ordering
/// alone, so that a program's unit compiles little.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/types.hpp>

#include <vector>

namespace ancf::detail {

/// The factors of one matrix. Without pivoting: for definite or quasi-definite matrices.
class SparseLdlt {
public:
    /// Orders the unknowns of a pattern and finds that of L.
    /// @param lower  the lower half, compressed; what stands above the diagonal is not read.
    void analyze(const SparseMatrix& lower);

    /// Factorises values in the pattern analysed.
    /// @return false for a pivot that is zero; the factors are then of no use.
    [[nodiscard]] bool factorize(const SparseMatrix& lower);

    /// Returns the smallest pivot, positive where the matrix is positive definite; infinite where
    /// there is none, NaN where one is.
    [[nodiscard]] double smallest_pivot() const noexcept;

    /// Solves A x = b; b and x may be the same vector.
    void solve(const VectorX& b, VectorX& x) const;

private:
    // The upper half of a matrix in the order of elimination, by columns.
    struct Upper {
        std::vector<int> start, row;
        std::vector<double> value;
    };

    [[nodiscard]] Upper permuted(const SparseMatrix& lower) const;
    [[nodiscard]] double eliminate(int column, const Upper& upper);

    std::vector<int> place_;        // of each unknown in the order of elimination
    std::vector<int> parent_;       // in the tree of elimination, -1 of a root
    std::vector<int> start_, row_;  // L by columns, without its unit diagonal
    std::vector<double> value_;     // of L
    std::vector<double> pivot_;     // D
    std::vector<int> filled_;       // entries of each column of L so far
    std::vector<double> work_;      // a row of L while it is computed
    std::vector<int> pattern_, mark_;
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/sparse_ldlt.ipp>  // IWYU pragma: export
#endif
