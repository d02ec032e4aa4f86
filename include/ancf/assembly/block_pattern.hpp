// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The sparsity pattern of a system of blocks, and where each block's values stand.
///
/// Rows and columns are grouped in blocks (the unknowns of a node, the equations of a constraint).
/// Coupled blocks are stored whole, so one integer per coupled pair finds every value of the pair.

#pragma once

#include <ancf/error.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace ancf {

/// Pattern and value slots of a symmetric structure of blocks.
class BlockPattern {
public:
    BlockPattern() = default;

    /// @param sizes   number of rows of each block, zero allowed.
    /// @param pairs   coupled blocks (a, b), in any order and repetition; a block couples to
    ///                itself.
    /// @param storage `lower` keeps rows at or below the diagonal.
    BlockPattern(const std::vector<int>& sizes, std::vector<std::pair<int, int>> pairs,
                 Storage storage);

    /// Returns which part is stored.
    [[nodiscard]] Storage storage() const noexcept { return storage_; }

    /// Returns the number of rows.
    [[nodiscard]] int size() const noexcept { return first_.back(); }

    /// Returns the first row of a block.
    [[nodiscard]] int first(int block) const { return first_[static_cast<std::size_t>(block)]; }

    /// Returns the index of the first value of a block column; the number of blocks gives the end.
    [[nodiscard]] int first_value(int block) const {
        return start_[static_cast<std::size_t>(block)];
    }

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
        const int height = height_[static_cast<std::size_t>(block)];
        return storage_ == Storage::full ? column * height
                                         : column * (height - 1) - column * (column - 1) / 2;
    }

private:
    Storage storage_ = Storage::full;
    std::vector<int> first_ = {0};       // first row of each block
    std::vector<int> height_;            // stored rows in a block's first column
    std::vector<int> start_ = {0};       // value index of each block column's first value
    std::vector<int> neighbour_first_;   // into neighbours_, per block
    std::vector<int> neighbours_;        // row blocks stored in each block column, ascending
    std::vector<int> neighbour_offset_;  // rows before that row block in the first column
};

inline BlockPattern::BlockPattern(const std::vector<int>& sizes,
                                  std::vector<std::pair<int, int>> pairs, Storage storage)
    : storage_(storage), first_(sizes.size() + 1, 0) {
    const auto blocks = sizes.size();
    for (std::size_t k = 0; k < blocks; ++k) first_[k + 1] = first_[k] + sizes[k];

    // sorted (column block, row block), both directions, the diagonal included
    const std::size_t given = pairs.size();
    pairs.reserve(2 * given + blocks);
    for (std::size_t k = 0; k < given; ++k) pairs.emplace_back(pairs[k].second, pairs[k].first);
    for (std::size_t k = 0; k < blocks; ++k) pairs.emplace_back(k, k);
    if (storage == Storage::lower)
        pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                                   [](const auto& pair) { return pair.second < pair.first; }),
                    pairs.end());
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

    height_.assign(blocks, 0);
    start_.assign(blocks + 1, 0);
    neighbour_first_.assign(blocks + 1, 0);
    neighbours_.reserve(pairs.size());
    neighbour_offset_.reserve(pairs.size());
    std::size_t next = 0;
    std::int64_t values = 0;
    for (std::size_t column = 0; column < blocks; ++column) {
        for (; next < pairs.size() && pairs[next].first == static_cast<int>(column); ++next) {
            neighbours_.push_back(pairs[next].second);
            neighbour_offset_.push_back(height_[column]);
            height_[column] += sizes[static_cast<std::size_t>(pairs[next].second)];
        }
        neighbour_first_[column + 1] = static_cast<int>(neighbours_.size());
        const std::int64_t width = sizes[column];
        values += width * height_[column];
        if (storage == Storage::lower) values -= width * (width - 1) / 2;
        detail::require(values <= std::numeric_limits<int>::max(),
                        "BlockPattern: the matrix has more values than a 32-bit index can count");
        start_[column + 1] = static_cast<int>(values);
    }
}

inline SparseMatrix BlockPattern::matrix() const {
    SparseMatrix result(size(), size());
    result.resizeNonZeros(start_.back());
    int* outer = result.outerIndexPtr();
    int* inner = result.innerIndexPtr();
    int at = 0;
    for (std::size_t column = 0; column + 1 < first_.size(); ++column) {
        const auto begin = static_cast<std::size_t>(neighbour_first_[column]);
        const auto end = static_cast<std::size_t>(neighbour_first_[column + 1]);
        for (int j = first_[column]; j < first_[column + 1]; ++j) {
            outer[j] = at;
            for (std::size_t k = begin; k < end; ++k) {
                const auto row = static_cast<std::size_t>(neighbours_[k]);
                const int from =
                    storage_ == Storage::lower ? std::max(first_[row], j) : first_[row];
                for (int i = from; i < first_[row + 1]; ++i) inner[at++] = i;
            }
        }
    }
    outer[size()] = at;
    std::fill_n(result.valuePtr(), at, 0.0);
    return result;
}

inline int BlockPattern::base(int row_block, int column_block) const {
    const auto column = static_cast<std::size_t>(column_block);
    const auto begin = neighbours_.begin() + neighbour_first_[column];
    const auto end = neighbours_.begin() + neighbour_first_[column + 1];
    const auto found = std::lower_bound(begin, end, row_block);
    detail::require(found != end && *found == row_block, "BlockPattern: blocks ", row_block,
                    " and ", column_block, " are not coupled");
    return start_[column] +
           neighbour_offset_[static_cast<std::size_t>(found - neighbours_.begin())];
}

}  // namespace ancf
