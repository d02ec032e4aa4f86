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
///
/// A template so that only a program that asks for modes compiles the eigenvalue solver.
/// @tparam Dense  MatrixX
template <class Dense>
class Subspace {
public:
    /// @param solver  has A factorised.
    Subspace(const SparseMatrix& A, const SparseMatrix& B, const LinearSolver& solver);

    /// Iterates until no wanted value changes by more than the tolerance, relative, and the
    /// round-off of x^T A x.
    /// @param free  number of coordinates, at least 1; the rest of the unknowns are multipliers
    /// @return      singular where x^T A x is negative for a vector that the block contains, or is
    ///              round-off for its slowest mode: then A moves something without resistance
    [[nodiscard]] Status run(int free, int count, double tolerance, int max_iterations);

    /// Returns |B x - th A x|/(th |A x|) of mode k.
    [[nodiscard]] double residual(Eigen::Index k) const;

    VectorX values;  ///< by falling magnitude
    Dense vectors;   ///< columns, x^T A x = 1
    int iterations = 0;

private:
    // Returns fixed mixtures of all modes: results repeat bit for bit.
    [[nodiscard]] Dense mixtures(Eigen::Index count);
    // Refills a block that lost vectors to a far slower mode: new mixtures, without the modes that
    // it has.
    void complete(Eigen::Index width);
    // Solves A x = b, with constraints refined once. What a solution leaves of G x, times large
    // multipliers, can make x^T A x negative.
    void solve(const VectorX& b, VectorX& x) const;
    // Tells whether a vector without these modes is more than round-off.
    [[nodiscard]] bool above_round_off(const Dense& x) const;
    [[nodiscard]] Dense product(const SparseMatrix& matrix, const Dense& x) const;
    // Returns the round-off of x^T A x of the first vectors, eps |x|^T |A| |x|.
    [[nodiscard]] VectorX noise(Eigen::Index count) const;
    // Tells whether x^T A x = 1 of the first vector is below its round-off, multipliers aside.
    [[nodiscard]] bool slides(int free) const;
    // Solves the problem on the span of the vectors; those that add nothing are left out. Returns
    // false where the metric is not positive on the span, or nothing is left.
    [[nodiscard]] bool reduce(int count);

    const SparseMatrix& A_;
    const SparseMatrix& B_;
    SparseMatrix magnitude_;
    const LinearSolver& solver_;
    VectorX scales_;
    double draw_ = 0.5;  // of the mixtures
    bool constrained_ = false;
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/solver/subspace.ipp>
#endif
