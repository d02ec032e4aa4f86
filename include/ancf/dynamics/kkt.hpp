// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The saddle-point systems [M G^T; G 0] of consistent starts and projections, and redundant rows.
///
/// A factorisation is kept while the matrix has the same values.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/solver/sparse_ldlt.hpp>
#include <ancf/types.hpp>

namespace ancf::detail {

/// A factorised saddle point [A G^T; G D] of fixed pattern, A symmetric and positive definite, D
/// zero or, in the rows of equations left out, one.
///
/// A few equations, well independent of each other, are eliminated last: where A is the same, only
/// their rows of L are computed anew.
///
/// Of many that would fill L. There, and where equations nearly depend on each other, each zero of
/// D is factorised as -e_i, e_i a small share of (G diag(A)^-1 G^T)_ii: the matrix is then
/// quasi-definite, so that L D L^T exists in every order (Vanderbei, SIAM J. Optim. 5, 1995).
/// Refinement takes the share away again: a step leaves share/s of the error, s the smallest
/// eigenvalue of S = G A^-1 G^T scaled by its diagonal. Where that is too slow the share is made
/// smaller; s below about 1e-14, a row independent of the others by less than 1e-7 of its length,
/// is singular. Where A is not positive definite the factorisation may break down or be inaccurate.
class KktSystem {
public:
    /// Takes the pattern, of either storage and with the whole diagonal; values that are zero now
    /// and later are welcome.
    /// @param rows    number of rows of A; those of G follow.
    /// @param blocks  of each row its block, from 0: a node, a constraint; none: each row alone.
    /// @throws InvalidArgument where an entry of the diagonal is not stored.
    void analyze(const SparseMatrix& pattern, int rows, List<int> blocks = {});

    /// Factorises, unless the values are those already factorised. Reads the lower half.
    /// @pre the pattern is that of analyze.
    [[nodiscard]] Status factorize(const SparseMatrix& matrix);

    /// Solves with refinement until it gains no more, with smaller shares where it ends too early.
    /// @pre the last factorize converged.
    /// @return singular where the equations do not hold to 1e-10.
    [[nodiscard]] Status solve(const VectorX& b, VectorX& x);

private:
    static constexpr int most_last = 12;
    static constexpr double least_pivot = 1e-6;  // of those, relative
    static constexpr double largest_share = 1e-8, smallest_share = 1e-13;

    // Solves, and returns the larger residual of the two parts, relative to |matrix| |x| + |b|,
    // rows and unknowns scaled.
    [[nodiscard]] double refine(const VectorX& b, VectorX& x) const;
    [[nodiscard]] double relative_residual(const VectorX& b, const VectorX& x,
                                           VectorX& residual) const;
    [[nodiscard]] bool factorize_values();

    int rows_ = 0;
    List<int> blocks_;
    int last_ = 0;  // equations that are eliminated last, all or none
    double share_ = largest_share;
    SparseMatrix matrix_;  // lower half, without zeros where there is no G
    List<int> slots_;      // where its values stand in the pattern
    List<int> zeros_;      // where those zeros stand
    VectorX scales_;       // of the unknowns
    VectorX sizes_[2];     // of each row sum |entry| scale, over the columns of A, and others
    List<double> factorised_;
    SparseLdlt ldlt_;
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/kkt.ipp>  // IWYU pragma: export
#endif
