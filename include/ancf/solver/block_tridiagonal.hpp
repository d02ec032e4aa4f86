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
#include <ancf/solver/direct_solver.hpp>
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
class BlockTridiagonal final : public detail::DirectSolver {
public:
    /// Unknowns in the widest block that is accepted.
    static constexpr int max_block = detail::widest_compiled_block;

    /// @param singular_rcond  see default_singular_rcond; 0 refuses zero pivots only.
    /// @throws InvalidArgument for one outside of [0, 1).
    explicit BlockTridiagonal(double singular_rcond = default_singular_rcond)
        : DirectSolver(singular_rcond) {}

    /// Returns true if analyze accepts the pattern of the lower half.
    [[nodiscard]] static bool accepts(const SparseMatrix& lower) {
        return detail::widest_block(detail::chain_starts(lower)) <= max_block;
    }

    /// The lower half is read.
    [[nodiscard]] Storage storage() const noexcept override { return Storage::lower; }

    [[nodiscard]] std::string_view name() const noexcept override { return "block-tridiagonal"; }

    /// Number of blocks along the chain.
    [[nodiscard]] int blocks() const noexcept { return layout_.blocks(); }

    /// Width to which blocks are filled up: the one of the compiled widths that fits.
    [[nodiscard]] int width() const noexcept { return layout_.width; }

private:
    ANCF_INLINE_VIRTUAL void analyze_pattern(const SparseMatrix& lower) override;
    [[nodiscard]] ANCF_INLINE_VIRTUAL FactorReport
    factorize_values(const SparseMatrix& lower) override;
    ANCF_INLINE_VIRTUAL void substitute(const VectorX& b, VectorX& x) const override;

    detail::BlockLayout layout_;
    VectorX panels_;
    VectorX roots_;  // of the diagonal, see direct_solver.hpp
    VectorX probe_;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/block_tridiagonal.ipp>  // IWYU pragma: export
#endif
