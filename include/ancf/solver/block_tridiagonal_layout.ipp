// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/solver/block_tridiagonal_layout.hpp>

#include <algorithm>
#include <cstddef>

namespace ancf::detail {

/// Returns for each of the leading columns the end of its profile: one more than the last of the
/// leading rows reached by it or by a column before it.
ANCF_INLINE List<int> profile_ends(const SparseMatrix& matrix, int rows) {
    List<int> ends(static_cast<std::size_t>(rows));
    const int* outer = matrix.outerIndexPtr();
    const int* inner = matrix.innerIndexPtr();
    int end = 0;
    for (int column = 0; column < rows; ++column) {
        int last = outer[column + 1];
        while (last > outer[column] && inner[last - 1] >= rows) --last;
        end = std::max(end, column + 1);
        if (last > outer[column]) end = std::max(end, inner[last - 1] + 1);
        ends[column] = end;
    }
    return ends;
}

ANCF_INLINE List<int> chain_starts(const SparseMatrix& matrix, int rows) {
    const List<int> ends = profile_ends(matrix, rows);
    List<int> starts = {0};
    int reach = 0;  // of the block before: rows that the next block has to hold
    while (starts.back() < rows) {
        const int first = starts.back();
        int end = reach;
        if (end <= first) {  // nothing before couples with what follows: a new chain
            const int own = ends[first];
            end = first + 1;
            while (end < own && ends[end] == own) ++end;
            if (end == own) end = first + (own - first + 1) / 2;  // dense: two halves
        }
        reach = ends[end - 1];
        starts.push_back(end);
    }
    return starts;
}

ANCF_INLINE int widest_block(const List<int>& starts) {
    int widest = 0;
    for (std::size_t k = 1; k < starts.size(); ++k)
        widest = std::max(widest, starts[k] - starts[k - 1]);
    return widest;
}

ANCF_INLINE BlockLayout block_layout(const int* outer, const List<int>& starts, int width) {
    BlockLayout layout;
    List<int>& joined = layout.starts;  // neighbours, as long as they fit into a panel
    for (std::size_t k = 1; k < starts.size(); ++k) {
        if (joined.size() > 1 && starts[k] - joined[joined.size() - 2] <= width) joined.pop_back();
        joined.push_back(starts[k]);
    }
    layout.width = width;
    layout.dense.assign(static_cast<std::size_t>(layout.blocks()), 0);
    for (int block = 0; block + 1 < layout.blocks(); ++block) {
        bool dense = layout.size(block) == width && layout.size(block + 1) == width;
        for (int j = 0; dense && j < width; ++j) {
            const int* column = outer + layout.start(block) + j;
            dense = column[1] - column[0] == 2 * width - j;
        }
        layout.dense[block] = dense ? 1 : 0;
    }
    return layout;
}

ANCF_INLINE BlockLayout chain_layout(std::string_view solver, const SparseMatrix& lower) {
    const List<int> starts = chain_starts(lower);
    const int widest = widest_block(starts);
    require(widest <= widest_compiled_block, solver, " needs a chain of blocks of at most ",
            widest_compiled_block, " unknowns, got a block of ", widest);
    return block_layout(lower.outerIndexPtr(), starts, fitting_width(widest));
}

ANCF_INLINE bool stays_within(const SparseMatrix& lower, const BlockLayout& layout) {
    const int* outer = lower.outerIndexPtr();
    const int* inner = lower.innerIndexPtr();
    for (int block = 0; block < layout.blocks(); ++block) {
        if (layout.dense[block] != 0) continue;
        const int end = layout.start(std::min(block + 2, layout.blocks()));
        for (int column = layout.start(block); column < layout.start(block + 1); ++column)
            for (int slot = outer[column]; slot < outer[column + 1]; ++slot)
                if (inner[slot] < column || inner[slot] >= end) return false;
    }
    return true;
}

}  // namespace ancf::detail
