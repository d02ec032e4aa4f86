// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The blocks of a chain, found from the pattern of a symmetric matrix.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/list.hpp>
#include <ancf/types.hpp>

#include <string_view>
#include <type_traits>

namespace ancf::detail {

/// Unknowns in the widest block.
inline constexpr int widest_compiled_block = 24;

/// Returns the smallest compiled width that holds `widest`, which is at most the widest.
[[nodiscard]] constexpr int fitting_width(int widest) noexcept {
    return widest <= 6 ? 6 : widest <= 12 ? 12 : widest_compiled_block;
}

/// Returns action(std::integral_constant<int, N>()) with the N that a fitting_width() is.
template <class Action>
auto with_block_width(int width, const Action& action) {
    if (width == 6) return action(std::integral_constant<int, 6>());
    if (width == 12) return action(std::integral_constant<int, 12>());
    return action(std::integral_constant<int, widest_compiled_block>());
}

/// Where the blocks of a chain start, and how wide the panels are.
struct BlockLayout {
    List<int> starts = {0};  ///< first column of each block, and the size of the matrix
    List<char> dense;        ///< 1 where a panel is full and contiguous in the matrix
    int width = 0;           ///< of the panels, not less than any block

    [[nodiscard]] int blocks() const noexcept { return static_cast<int>(starts.size()) - 1; }
    [[nodiscard]] int start(int block) const noexcept { return starts[block]; }
    [[nodiscard]] int size(int block) const noexcept { return start(block + 1) - start(block); }
    /// Returns the number of scalars in all panels.
    [[nodiscard]] Eigen::Index panel_entries() const noexcept {
        return Eigen::Index{2} * width * width * blocks();
    }
};

/// Returns starts of blocks that couple with their neighbours only, and the size at the end.
///
/// The first block is the set of columns that reach as far as the first one; each block ends where
/// the profile of the block before it does.
/// @param matrix  of symmetric pattern, all of it or its lower half.
/// @param rows    of the leading part that is looked at.
[[nodiscard]] List<int> chain_starts(const SparseMatrix& matrix, int rows);

/// Returns those of all of a matrix.
[[nodiscard]] inline List<int> chain_starts(const SparseMatrix& matrix) {
    return chain_starts(matrix, static_cast<int>(matrix.cols()));
}

/// Returns the size of the largest block.
[[nodiscard]] int widest_block(const List<int>& starts);

/// Returns the layout of a chain in panels of the given width.
/// @param outer  where each column of its lower half begins, and their end.
[[nodiscard]] BlockLayout block_layout(const int* outer, const List<int>& starts, int width);

/// Returns the layout of a chain in panels of the narrowest compiled width that holds its blocks.
/// @param solver  for the message
/// @throws InvalidArgument for a block that is too wide.
[[nodiscard]] BlockLayout chain_layout(std::string_view solver, const SparseMatrix& lower);

/// Returns whether the columns of all blocks that are not dense stay within their panel. Dense ones
/// do if they have as many entries as when they were found dense.
[[nodiscard]] bool stays_within(const SparseMatrix& lower, const BlockLayout& layout);

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/solver/block_tridiagonal_layout.ipp>  // IWYU pragma: export
#endif
