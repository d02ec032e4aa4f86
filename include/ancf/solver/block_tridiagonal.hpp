// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A direct solver for chains: each node couples only with the next one.
///
/// A = L D L^T block by block, without pivoting and without fill outside the blocks, in the given
/// order of the unknowns. Cost and memory grow linearly with the number of nodes.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/solver/block_tridiagonal_layout.hpp>
#include <ancf/solver/block_widths.hpp>
#include <ancf/solver/conditioning.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <string_view>

namespace ancf {

/// Solves symmetric systems whose unknowns form a chain of narrow blocks.
///
/// The blocks are found from the pattern: unknowns numbered along the chain, 12 per node or fewer,
/// nodes of different size side by side, clamped ends, three-node elements. Positive definite
/// matrices are the purpose. An indefinite one is factorised as well and its negative eigenvalues
/// are counted, but without pivoting: where a pivot vanishes it counts as singular.
class BlockTridiagonal final : public LinearSolver {
public:
    /// Unknowns in the widest block that is accepted.
    static constexpr int max_block = detail::widest_compiled_block;

    BlockTridiagonal() = default;

    /// @param singular_rcond  see default_singular_rcond; 0 refuses zero pivots only.
    explicit BlockTridiagonal(double singular_rcond) : singular_rcond_(singular_rcond) {
        detail::require_singular_rcond(singular_rcond);
    }

    /// Returns true if analyze accepts the pattern of the lower half.
    [[nodiscard]] static bool accepts(const SparseMatrix& lower) {
        return detail::widest_block(detail::chain_starts(lower)) <= max_block;
    }

    /// The lower half is read.
    [[nodiscard]] Storage storage() const noexcept override { return Storage::lower; }

    /// @throws InvalidArgument unless square, compressed, lower, and of blocks up to max_block.
    ANCF_INLINE_VIRTUAL void analyze(const SparseMatrix& lower) override;

    /// Factorises in the pattern analysed.
    /// @throws InvalidArgument if its size or the number of entries in a column differs.
    [[nodiscard]] ANCF_INLINE_VIRTUAL FactorReport factorize(const SparseMatrix& lower) override;

    /// Solves A x = b. @throws InvalidArgument unless factorised and b has its size.
    ANCF_INLINE_VIRTUAL void solve(const VectorX& b, VectorX& x) const override;

    /// "block-tridiagonal".
    [[nodiscard]] std::string_view name() const noexcept override { return "block-tridiagonal"; }

    /// Number of blocks along the chain.
    [[nodiscard]] int blocks() const noexcept { return layout_.blocks(); }

    /// Width to which blocks are filled up: the one of the compiled widths that fits.
    [[nodiscard]] int width() const noexcept { return layout_.width; }

private:
    void solve_in_place(VectorX& x) const;

    detail::BlockLayout layout_;
    detail::SolverStage stage_;
    VectorX panels_;
    VectorX roots_;  // of the diagonal, see conditioning.hpp
    VectorX probe_;
    double singular_rcond_ = default_singular_rcond;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/block_tridiagonal.ipp>  // IWYU pragma: export
#endif
