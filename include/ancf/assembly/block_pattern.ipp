// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// BlockPattern: definitions.

#pragma once

#include <ancf/assembly/block_pattern.hpp>
#include <ancf/error.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace ancf {

ANCF_INLINE BlockPattern::BlockPattern(const std::vector<int>& sizes,
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
    return start_[column] +
           neighbour_offset_[static_cast<std::size_t>(found - neighbours_.begin())];
}

}  // namespace ancf
