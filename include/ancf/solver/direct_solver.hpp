// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the solvers by one sparse factorisation share: the order of calls, empty systems, and the
/// condition, so that a matrix that is singular but for round-off is found out.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

namespace ancf::detail {

/// A linear solver by a sparse factorisation. A derived class brings its three phases, and is never
/// asked for an empty one.
class DirectSolver : public LinearSolver {
public:
    /// @throws InvalidArgument unless square, compressed and of the storage.
    ANCF_INLINE_VIRTUAL void analyze(const SparseMatrix& matrix) final;

    /// Factorises in the pattern analysed.
    /// @throws InvalidArgument if its size or the number of entries in a column differs.
    [[nodiscard]] ANCF_INLINE_VIRTUAL FactorReport factorize(const SparseMatrix& matrix) final;

    /// Solves A x = b. @throws InvalidArgument unless factorised and b has its size.
    ANCF_INLINE_VIRTUAL void solve(const VectorX& b, VectorX& x) const final;

protected:
    /// @param singular_rcond  see default_singular_rcond; 0 refuses zero pivots only.
    /// @throws InvalidArgument for one outside of [0, 1).
    explicit DirectSolver(double singular_rcond);

    [[nodiscard]] double singular_rcond() const noexcept { return singular_rcond_; }

private:
    /// The symbolic phase: takes the pattern of a matrix.
    virtual void analyze_pattern(const SparseMatrix& matrix) = 0;

    /// The numerical phase. A report without the condition is completed by one solution.
    [[nodiscard]] virtual FactorReport factorize_values(const SparseMatrix& matrix) = 0;

    /// The solution by the factors. b and x may be the same vector.
    virtual void substitute(const VectorX& b, VectorX& x) const = 0;

    double singular_rcond_;
    SolverStage stage_;
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/solver/direct_solver.ipp>  // IWYU pragma: export
#endif
