// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A direct solver for chains: each node couples only with the next one.
///
/// A = L D L^T block by block, without pivoting and without fill outside the blocks, in the given
/// order of the unknowns. Cost and memory grow linearly with the number of nodes.

#pragma once

#include <ancf/error.hpp>
#include <ancf/solver/block_tridiagonal_kernel.hpp>
#include <ancf/solver/block_tridiagonal_layout.hpp>
#include <ancf/solver/conditioning.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ancf {

/// Solves symmetric systems whose unknowns form a chain of narrow blocks.
///
/// The blocks are found from the pattern: unknowns numbered along the chain, 12 per node or fewer,
/// nodes of different size side by side, clamped ends, three-node elements. Positive definite
/// matrices are the purpose. An indefinite one is factorised as well and its negative eigenvalues
/// are counted, but without pivoting: where a pivot vanishes it counts as singular.
class BlockTridiagonal {
public:
    static constexpr Storage storage = Storage::lower;  ///< the lower half is read
    static constexpr int max_block = 24;  ///< unknowns in the widest block that is accepted

    BlockTridiagonal() = default;

    /// @param singular_rcond  see default_singular_rcond; 0 refuses zero pivots only.
    explicit BlockTridiagonal(double singular_rcond) : singular_rcond_(singular_rcond) {
        detail::require_singular_rcond(singular_rcond);
    }

    /// Returns true if analyze accepts the pattern of the lower half.
    [[nodiscard]] static bool accepts(const SparseMatrix& lower) {
        return detail::widest_block(detail::chain_starts(lower)) <= max_block;
    }

    /// @throws InvalidArgument unless square, compressed, lower, and of blocks up to max_block.
    void analyze(const SparseMatrix& lower);

    /// Factorises in the pattern analysed.
    /// @throws InvalidArgument if its size or the number of entries in a column differs.
    [[nodiscard]] FactorReport factorize(const SparseMatrix& lower);

    /// Solves A x = b. @throws InvalidArgument unless factorised and b has its size.
    void solve(const VectorX& b, VectorX& x) const;

    /// The word that tables print.
    [[nodiscard]] static constexpr std::string_view name() noexcept { return "block-tridiagonal"; }

    /// Number of blocks along the chain.
    [[nodiscard]] int blocks() const noexcept { return layout_.blocks(); }

    /// Width to which blocks are filled up: the one of the compiled widths that fits.
    [[nodiscard]] int width() const noexcept { return layout_.width; }

private:
    using Widths = std::integer_sequence<int, 6, 12, max_block>;

    // Returns the smallest compiled width that holds `widest`, which is at most max_block.
    template <int... Width>
    static int fitting_width(int widest, std::integer_sequence<int, Width...>) {
        int fitting = max_block;
        ((fitting = widest <= Width ? std::min(fitting, Width) : fitting), ...);
        return fitting;
    }

    // Calls action(std::integral_constant<int, N>()) with the N of the layout.
    template <class Action, int... Width>
    void with_width(Action&& action, std::integer_sequence<int, Width...>) const {
        ((layout_.width == Width ? action(std::integral_constant<int, Width>()) : void()), ...);
    }

    void solve_in_place(VectorX& x) const;

    detail::BlockLayout layout_;
    detail::SolverStage stage_;
    VectorX panels_;
    VectorX roots_;  // of the diagonal, see conditioning.hpp
    VectorX probe_;
    double singular_rcond_ = default_singular_rcond;
};

inline void BlockTridiagonal::analyze(const SparseMatrix& lower) {
    detail::require_storage(name(), lower, storage);
    const std::vector<int> starts = detail::chain_starts(lower);
    const int widest = detail::widest_block(starts);
    detail::require(widest <= max_block, name(), " needs a chain of blocks of at most ", max_block,
                    " unknowns, got a block of ", widest);
    stage_.reset();
    layout_ = detail::block_layout(lower, starts, fitting_width(widest, Widths()));
    const Eigen::Index width = layout_.width;
    panels_.resize(2 * width * width * layout_.blocks());
    stage_.analysed(lower);
}

inline FactorReport BlockTridiagonal::factorize(const SparseMatrix& lower) {
    stage_.begin_factorisation(name(), lower);
    detail::require(detail::stays_within(lower, layout_), name(), " analysed another pattern");
    roots_.resize(lower.cols());
    probe_.resize(lower.cols());
    detail::PivotSummary summary;
    with_width(
        [&](auto width) {
            using Kernel = detail::BlockKernel<width()>;
            summary =
                Kernel::factorize(layout_, lower, panels_.data(), roots_.data(), probe_.data());
            if (summary.complete || summary.failed_column >= 0) return;
            detail::symmetric_roots(lower, roots_);
            summary.weights = detail::probe_load(roots_, probe_);
            summary.energy = Kernel::probe_energy(layout_, panels_.data(), probe_.data());
        },
        Widths());
    FactorReport report;
    if (summary.failed_column >= 0) {
        detail::report_failure(lower, summary.failed_column, report);
    } else {
        report.negative_pivots = summary.negative;
        report.rcond = detail::rcond_by_energy(summary.weights, summary.energy);
        if (!(report.rcond > singular_rcond_)) {
            detail::probe_load(roots_, probe_);
            solve_in_place(probe_);
            detail::report_failure(lower, detail::softest_unknown(roots_, probe_), report);
        }
    }
    return stage_.finished(report);
}

inline void BlockTridiagonal::solve_in_place(VectorX& x) const {
    with_width(
        [&](auto width) { detail::BlockKernel<width()>::solve(layout_, panels_.data(), x.data()); },
        Widths());
}

inline void BlockTridiagonal::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    if (&x != &b) x = b;
    solve_in_place(x);
}

}  // namespace ancf
