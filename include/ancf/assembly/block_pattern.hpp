// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The sparsity pattern of a system of blocks, and where each block's values stand.
///
/// Rows and columns are grouped in blocks (the unknowns of a node, the equations of a constraint).
/// Coupled blocks are stored whole, so one integer per coupled pair finds every value of the pair.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/list.hpp>
#include <ancf/types.hpp>

namespace ancf {

/// Two coupled blocks.
struct BlockPair {
    int first;   ///< one
    int second;  ///< the other, or the same
};

/// Pattern and value slots of a symmetric structure of blocks.
class BlockPattern {
public:
    BlockPattern() = default;

    /// @param sizes   number of rows of each block, zero allowed.
    /// @param pairs   coupled blocks (a, b), in any order and repetition; a block couples to
    ///                itself.
    /// @param storage `lower` keeps rows at or below the diagonal.
    BlockPattern(const List<int>& sizes, const List<BlockPair>& pairs, Storage storage);

    /// Returns which part is stored.
    [[nodiscard]] Storage storage() const noexcept { return storage_; }

    /// Returns the number of rows.
    [[nodiscard]] int size() const noexcept { return first_.back(); }

    /// Returns the first row of a block.
    [[nodiscard]] int first(int block) const { return first_[block]; }

    /// Returns the first row of every block.
    [[nodiscard]] const int* first_rows() const noexcept { return first_.data(); }
    /// Returns the number of stored rows in the first column of every block.
    [[nodiscard]] const int* heights() const noexcept { return height_.data(); }

    /// Returns the index of the first value of a block column; the number of blocks gives the end.
    [[nodiscard]] int first_value(int block) const { return start_[block]; }

    /// Returns a matrix of this pattern with zero values.
    [[nodiscard]] SparseMatrix matrix() const;

    /// Returns whether the values of (row block, column block) are stored.
    [[nodiscard]] bool stored(int row_block, int column_block) const noexcept {
        return storage_ == Storage::full || row_block >= column_block;
    }

    /// Returns the handle of a stored, coupled pair of blocks for `slot`.
    [[nodiscard]] int base(int row_block, int column_block) const;

    /// Returns how far the values of column `column` of a block lie from its first column's,
    /// for a row counted within the row block: value index = base + column_offset + row.
    [[nodiscard]] int column_offset(int block, int column) const {
        const int height = height_[block];
        return storage_ == Storage::full ? column * height
                                         : column * (height - 1) - column * (column - 1) / 2;
    }

private:
    Storage storage_ = Storage::full;
    List<int> first_ = {0};       // first row of each block
    List<int> height_;            // stored rows in a block's first column
    List<int> start_ = {0};       // value index of each block column's first value
    List<int> neighbour_first_;   // into neighbours_, per block
    List<int> neighbours_;        // row blocks stored in each block column, ascending
    List<int> neighbour_offset_;  // rows before that row block in the first column
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/assembly/block_pattern.ipp>
#endif
