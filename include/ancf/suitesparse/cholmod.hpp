// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// CHOLMOD: sparse Cholesky factorisation of a symmetric matrix, analysed once, factorised often.
///
/// Silent: it prints nothing and installs no handler. Matrices are read in place, without a copy.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/solver/conditioning.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <memory>
#include <string_view>

namespace ancf::suitesparse {

/// How CHOLMOD factorises.
enum class CholmodMode {
    automatic,   ///< CHOLMOD picks one of the two by the work per entry of the factor
    simplicial,  ///< L D L^T entry by entry: also for indefinite matrices far from singular
    supernodal   ///< L L^T in dense blocks: positive definite matrices only
};

/// How CHOLMOD orders the unknowns.
enum class CholmodOrdering {
    natural,   ///< as they are numbered: free of fill for a chain numbered along it
    amd,       ///< minimum degree: the general choice
    automatic  ///< the best of those that CHOLMOD tries
};

/// How Cholmod works.
struct CholmodOptions {
    CholmodMode mode = CholmodMode::automatic;        ///< L D L^T or L L^T
    CholmodOrdering ordering = CholmodOrdering::amd;  ///< order of elimination
    double singular_rcond = default_singular_rcond;   ///< 0 refuses zero pivots only
    /// Lets OpenMP have threads within CHOLMOD. Versions before 4 start four of them on any machine
    /// for loops of a microsecond, which takes up to twice as long. A BLAS of POSIX threads has its
    /// threads anyway; one of OpenMP needs `true` for them. Of no effect but on Linux.
    bool threads = false;
};

/// Solves symmetric systems by CHOLMOD.
///
/// A matrix that is not positive definite has the status singular and the column where it failed;
/// simplicial, it is factorised as long as no pivot vanishes, and the negative pivots are counted.
class Cholmod final : public LinearSolver {
public:
    /// @throws InvalidArgument for a singular_rcond outside of [0, 1).
    explicit Cholmod(const CholmodOptions& options = {}) : options_(options) {
        ancf::detail::require_singular_rcond(options.singular_rcond);
    }

    /// The lower half is read.
    [[nodiscard]] Storage storage() const noexcept override { return Storage::lower; }

    /// @throws InvalidArgument unless square, compressed and lower.
    ANCF_INLINE_VIRTUAL void analyze(const SparseMatrix& lower) override;

    /// Factorises in the pattern analysed.
    /// @throws InvalidArgument if its size or the number of entries in a column differs.
    [[nodiscard]] ANCF_INLINE_VIRTUAL FactorReport factorize(const SparseMatrix& lower) override;

    /// Solves A x = b. @throws InvalidArgument unless factorised and b has its size.
    /// @note not for two threads at once: it keeps a workspace.
    ANCF_INLINE_VIRTUAL void solve(const VectorX& b, VectorX& x) const override;

    /// The word that tables print.
    [[nodiscard]] std::string_view name() const noexcept override { return "cholmod"; }

    /// Whether the analysis chose dense blocks.
    [[nodiscard]] bool supernodal() const noexcept;

private:
    class Session;  // the state of CHOLMOD
    struct Finish {
        void operator()(Session* session) const noexcept;
    };

    void substitute(const VectorX& b, VectorX& x) const;

    CholmodOptions options_;
    std::unique_ptr<Session, Finish> session_;
    ancf::detail::SolverStage stage_;
};

}  // namespace ancf::suitesparse

#if !defined(ANCF_COMPILED)
#include <ancf/suitesparse/cholmod.ipp>  // IWYU pragma: export
#endif
