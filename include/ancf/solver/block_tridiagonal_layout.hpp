// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The blocks of a chain, found from the pattern of a symmetric matrix.

#pragma once

#include <ancf/types.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ancf::detail {

/// Where the blocks of a chain start, and how wide the panels are.
struct BlockLayout {
    std::vector<int> starts = {0};  ///< first column of each block, and the size of the matrix
    std::vector<char> dense;        ///< 1 where a panel is full and contiguous in the matrix
    int width = 0;                  ///< of the panels, not less than any block

    [[nodiscard]] int blocks() const noexcept { return static_cast<int>(starts.size()) - 1; }
    [[nodiscard]] int start(int block) const noexcept {
        return starts[static_cast<std::size_t>(block)];
    }
    [[nodiscard]] int size(int block) const noexcept { return start(block + 1) - start(block); }
};

/// Returns for each column of a lower half the end of its profile: one more than the last row
/// reached by it or by a column before it.
[[nodiscard]] inline std::vector<int> profile_ends(const SparseMatrix& lower) {
    std::vector<int> ends(static_cast<std::size_t>(lower.cols()));
    const int* outer = lower.outerIndexPtr();
    const int* inner = lower.innerIndexPtr();
    int end = 0;
    for (int column = 0; column < static_cast<int>(lower.cols()); ++column) {
        end = std::max(end, column + 1);
        if (outer[column + 1] > outer[column])
            end = std::max(end, inner[outer[column + 1] - 1] + 1);
        ends[static_cast<std::size_t>(column)] = end;
    }
    return ends;
}

/// Returns starts of blocks that couple with their neighbours only, and the size at the end.
///
/// The first block is the set of columns that reach as far as the first one; each block ends where
/// the profile of the block before it does.
[[nodiscard]] inline std::vector<int> chain_starts(const SparseMatrix& lower) {
    const std::vector<int> ends = profile_ends(lower);
    const int size = static_cast<int>(ends.size());
    std::vector<int> starts = {0};
    int reach = 0;  // of the block before: rows that the next block has to hold
    while (starts.back() < size) {
        const int first = starts.back();
        int end = reach;
        if (end <= first) {  // nothing before couples with what follows: a new chain
            const int own = ends[static_cast<std::size_t>(first)];
            end = first + 1;
            while (end < own && ends[static_cast<std::size_t>(end)] == own) ++end;
            if (end == own) end = first + (own - first + 1) / 2;  // dense: two halves
        }
        reach = ends[static_cast<std::size_t>(end - 1)];
        starts.push_back(end);
    }
    return starts;
}

/// Returns the size of the largest block.
[[nodiscard]] inline int widest_block(const std::vector<int>& starts) {
    int widest = 0;
    for (std::size_t k = 1; k < starts.size(); ++k)
        widest = std::max(widest, starts[k] - starts[k - 1]);
    return widest;
}

/// Joins neighbouring blocks as long as they fit into panels of the given width.
[[nodiscard]] inline std::vector<int> joined_blocks(const std::vector<int>& starts, int width) {
    std::vector<int> joined = {0};
    for (std::size_t k = 1; k < starts.size(); ++k) {
        const bool fits = joined.size() > 1 && starts[k] - joined[joined.size() - 2] <= width;
        if (fits) {
            joined.back() = starts[k];
        } else {
            joined.push_back(starts[k]);
        }
    }
    return joined;
}

/// Returns the layout of a chain in panels of the given width.
[[nodiscard]] inline BlockLayout block_layout(const SparseMatrix& lower,
                                              const std::vector<int>& starts, int width) {
    BlockLayout layout;
    layout.starts = joined_blocks(starts, width);
    layout.width = width;
    layout.dense.assign(static_cast<std::size_t>(layout.blocks()), 0);
    const int* outer = lower.outerIndexPtr();
    for (int block = 0; block + 1 < layout.blocks(); ++block) {
        bool dense = layout.size(block) == width && layout.size(block + 1) == width;
        for (int j = 0; dense && j < width; ++j) {
            const int* column = outer + layout.start(block) + j;
            dense = column[1] - column[0] == 2 * width - j;
        }
        layout.dense[static_cast<std::size_t>(block)] = dense ? 1 : 0;
    }
    return layout;
}

/// Returns whether the columns of all blocks that are not dense stay within their panel. Dense ones
/// do if they have as many entries as when they were found dense.
[[nodiscard]] inline bool stays_within(const SparseMatrix& lower, const BlockLayout& layout) {
    const int* outer = lower.outerIndexPtr();
    const int* inner = lower.innerIndexPtr();
    for (int block = 0; block < layout.blocks(); ++block) {
        if (layout.dense[static_cast<std::size_t>(block)] != 0) continue;
        const int end = layout.start(std::min(block + 2, layout.blocks()));
        for (int column = layout.start(block); column < layout.start(block + 1); ++column)
            for (int slot = outer[column]; slot < outer[column + 1]; ++slot)
                if (inner[slot] < column || inner[slot] >= end) return false;
    }
    return true;
}

}  // namespace ancf::detail
