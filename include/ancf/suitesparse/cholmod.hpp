// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// CHOLMOD: sparse Cholesky factorisation of a symmetric matrix, analysed once, factorised often.
///
/// Silent: it prints nothing and installs no handler. Matrices are read in place, without a copy.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/solver/direct_solver.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

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
/// Solutions are not for two threads at once: it keeps a workspace.
class Cholmod final : public ancf::detail::DirectSolver {
public:
    /// @throws InvalidArgument for a singular_rcond outside of [0, 1).
    explicit Cholmod(const CholmodOptions& options = {})
        : DirectSolver(options.singular_rcond), options_(options) {}

    /// The lower half is read.
    [[nodiscard]] Storage storage() const noexcept override { return Storage::lower; }

    [[nodiscard]] std::string_view name() const noexcept override { return "cholmod"; }

    /// Whether the analysis chose dense blocks.
    [[nodiscard]] bool supernodal() const noexcept;

private:
    class Session;  // the state of CHOLMOD

    ANCF_INLINE_VIRTUAL void analyze_pattern(const SparseMatrix& lower) override;
    [[nodiscard]] ANCF_INLINE_VIRTUAL FactorReport
    factorize_values(const SparseMatrix& lower) override;
    ANCF_INLINE_VIRTUAL void substitute(const VectorX& b, VectorX& x) const override;

    CholmodOptions options_;
    ancf::detail::Hidden<Session> session_{nullptr, nullptr};
};

}  // namespace ancf::suitesparse

#if !defined(ANCF_COMPILED)
#include <ancf/suitesparse/cholmod.ipp>  // IWYU pragma: export
#endif
