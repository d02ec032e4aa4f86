// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/assembly/block_pattern.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace ancf {

ANCF_INLINE BlockPattern::BlockPattern(const List<int>& sizes, const List<BlockPair>& pairs,
                                       Storage storage)
    : storage_(storage), first_(sizes.size() + 1, 0) {
    const auto blocks = sizes.size();
    for (std::size_t k = 0; k < blocks; ++k) first_[k + 1] = first_[k] + sizes[k];

    // row blocks of every column block, both directions, the diagonal included
    const auto visit = [&](const auto& couple) {
        for (std::size_t k = 0; k < blocks; ++k) couple(k, static_cast<int>(k));
        for (const BlockPair& pair : pairs) {
            const bool lower = storage == Storage::lower;
            if (!lower || pair.second >= pair.first)
                couple(static_cast<std::size_t>(pair.first), pair.second);
            if (!lower || pair.first >= pair.second)
                couple(static_cast<std::size_t>(pair.second), pair.first);
        }
    };
    List<std::size_t> end(blocks + 1, 0);
    visit([&](std::size_t column, int) { ++end[column + 1]; });
    for (std::size_t k = 0; k < blocks; ++k) end[k + 1] += end[k];
    List<int> rows(end[blocks]);
    visit([&](std::size_t column, int row) { rows[end[column]++] = row; });

    height_.assign(blocks, 0);
    start_.assign(blocks + 1, 0);
    neighbour_first_.assign(blocks + 1, 0);
    neighbours_.reserve(rows.size());
    neighbour_offset_.reserve(rows.size());
    std::int64_t values = 0;
    std::size_t first = 0;
    for (std::size_t column = 0; column < blocks; first = end[column++]) {
        std::sort(rows.data() + first, rows.data() + end[column]);
        for (std::size_t k = first; k < end[column]; ++k) {
            if (k > first && rows[k] == rows[k - 1]) continue;
            neighbours_.push_back(rows[k]);
            neighbour_offset_.push_back(height_[column]);
            height_[column] += sizes[rows[k]];
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

ANCF_INLINE SparseMatrix BlockPattern::matrix() const {
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

ANCF_INLINE int BlockPattern::base(int row_block, int column_block) const {
    const auto column = static_cast<std::size_t>(column_block);
    const auto begin = neighbours_.begin() + neighbour_first_[column];
    const auto end = neighbours_.begin() + neighbour_first_[column + 1];
    const auto found = std::lower_bound(begin, end, row_block);
    detail::require(found != end && *found == row_block, "BlockPattern: blocks ", row_block,
                    " and ", column_block, " are not coupled");
    return start_[column] + neighbour_offset_[found - neighbours_.begin()];
}

}  // namespace ancf
