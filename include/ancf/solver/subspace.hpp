// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Subspace iteration for eigenvalues of largest magnitude, with a factorised matrix as metric:
/// docs/theory-modal.md. [Bathe and Wilson, J. Eng. Mech. Div. 98 (1972)]

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

namespace ancf::detail {

/// Largest eigenvalues of B x = th A x by subspace iteration with Rayleigh's quotients.
class Subspace {
public:
    /// @param scales  of the unknowns, as many as A has rows: displacements of one size
    /// @param solver  has A factorised, or a matrix with the same solutions of A x = B y
    ANCF_LAZY Subspace(const SparseMatrix& A, const SparseMatrix& B, VectorX scales,
                       const LinearSolver& solver);

    /// Iterates until no wanted value changes by more than the tolerance, relative, and the
    /// round-off of x^T A x.
    /// @param free  number of coordinates, at least 1; the rest of the unknowns are multipliers
    /// @return      singular where x^T A x is negative for a vector that the block contains, or is
    ///              round-off for a wanted mode: then A moves something without resistance
    ANCF_LAZY [[nodiscard]] Status run(int free, int count, double tolerance, int max_iterations);

    /// Returns |B x - th A x|/(th |A x|) of mode k.
    ANCF_LAZY [[nodiscard]] double residual(Eigen::Index k) const;

    /// Returns the round-off of x^T A x of some vectors, eps |x|^T |A| |x|.
    ANCF_LAZY [[nodiscard]] VectorX noise(const MatrixX& of) const;

    VectorX values;   ///< by falling magnitude, of a pair of either sign the positive one first
    MatrixX vectors;  ///< columns, x^T A x = 1
    int iterations = 0;

private:
    // Returns fixed mixtures of all modes: results repeat bit for bit.
    ANCF_LAZY [[nodiscard]] MatrixX mixtures(Eigen::Index count);
    // Refills a block that lost vectors to a far slower mode: new mixtures, without the modes that
    // it has.
    ANCF_LAZY void complete(Eigen::Index width);
    // Solves A x = b, with constraints refined once. What a solution leaves of G x, times large
    // multipliers, can make x^T A x negative.
    ANCF_LAZY void solve(const VectorX& b, VectorX& x) const;
    // Tells whether a vector without these modes is more than round-off.
    ANCF_LAZY [[nodiscard]] bool above_round_off(const MatrixX& x) const;
    // One instance of each product for all calls: they are most of what this class compiles.
    ANCF_LAZY [[nodiscard]] static MatrixX times(const MatrixX& a, const MatrixX& b);
    ANCF_LAZY [[nodiscard]] static MatrixX transposed_times(const MatrixX& a, const MatrixX& b);
    ANCF_LAZY [[nodiscard]] MatrixX product(const SparseMatrix& matrix, const MatrixX& x) const;
    // Tells whether x^T A x = 1 of a wanted vector is below its round-off, multipliers aside.
    ANCF_LAZY [[nodiscard]] bool slides(int free, Eigen::Index count) const;
    // Solves the problem on the span of the vectors; those that add nothing are left out. Returns
    // false where the metric is not positive on the span, or nothing is left.
    ANCF_LAZY [[nodiscard]] bool reduce(int count);

    const SparseMatrix& A_;
    const SparseMatrix& B_;
    SparseMatrix magnitude_;
    VectorX scales_;
    const LinearSolver& solver_;
    double draw_ = 0.5;  // of the mixtures
    bool constrained_ = false;
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/solver/subspace.ipp>
#endif
