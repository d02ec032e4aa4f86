// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/list.hpp>
#include <ancf/solver/sparse_ldlt.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ancf::detail {

ANCF_INLINE SparseMatrix compressed(int size, const List<MatrixEntry>& entries) {
    // sorted by row, then by column: two passes that keep the order of equals
    const auto sorted = [size](const List<MatrixEntry>& from, int MatrixEntry::*key) {
        List<std::size_t> next(static_cast<std::size_t>(size) + 1, 0);
        for (const MatrixEntry& entry : from) ++next[entry.*key + 1];
        for (std::size_t k = 1; k < next.size(); ++k) next[k] += next[k - 1];
        List<MatrixEntry> to(from.size());
        for (const MatrixEntry& entry : from) to[next[entry.*key]++] = entry;
        return to;
    };
    List<MatrixEntry> all = sorted(sorted(entries, &MatrixEntry::row), &MatrixEntry::column);
    std::size_t kept = 0;
    for (const MatrixEntry& entry : all) {
        MatrixEntry* const last = kept > 0 ? &all[kept - 1] : nullptr;
        if (last != nullptr && last->row == entry.row && last->column == entry.column)
            last->value += entry.value;
        else
            all[kept++] = entry;
    }
    SparseMatrix matrix(size, size);
    matrix.resizeNonZeros(static_cast<int>(kept));
    int* outer = matrix.outerIndexPtr();
    std::fill_n(outer, size + 1, 0);
    for (std::size_t k = 0; k < kept; ++k) {
        ++outer[all[k].column + 1];
        matrix.innerIndexPtr()[k] = all[k].row;
        matrix.valuePtr()[k] = all[k].value;
    }
    for (int j = 0; j < size; ++j) outer[j + 1] += outer[j];
    return matrix;
}

ANCF_INLINE List<int> blocks_of(const Numbering& numbering, int equations) {
    List<int> blocks;
    const List<int>& sizes = numbering.block_sizes();
    for (std::size_t block = 0; block < sizes.size(); ++block)
        blocks.resize(blocks.size() + static_cast<std::size_t>(sizes[block]),
                      static_cast<int>(block));
    blocks.resize(static_cast<std::size_t>(equations));
    return blocks;
}

/// Returns the blocks in an order of elimination that keeps fill small: always one of those with
/// the fewest neighbours, the last one that came to have so few.
[[nodiscard]] ANCF_INLINE List<int> minimum_degree(List<List<int>> neighbours) {
    List<List<int>> waiting(neighbours.size() + 1);  // by degree, some out of date
    for (int k = static_cast<int>(neighbours.size()) - 1; k >= 0; --k)
        waiting[neighbours[k].size()].push_back(k);
    List<int> seen(neighbours.size(), -1);
    List<char> gone(neighbours.size(), 0);
    List<int> order;
    order.reserve(neighbours.size());
    int stamp = 0;
    for (std::size_t degree = 0; degree < waiting.size();) {
        if (waiting[degree].empty()) {
            ++degree;
            continue;
        }
        const int block = waiting[degree].back();
        waiting[degree].pop_back();
        if (gone[block] != 0 || neighbours[block].size() != degree) continue;
        gone[block] = 1;
        order.push_back(block);
        const List<int> clique = std::exchange(neighbours[block], {});
        for (const int one : clique) {
            List<int>& own = neighbours[one];
            seen[one] = seen[block] = ++stamp;
            std::size_t kept = 0;
            for (const int other : own) {
                if (other == block) continue;
                seen[other] = stamp;
                own[kept++] = other;
            }
            own.resize(kept);
            for (const int other : clique)
                if (seen[other] != stamp) own.push_back(other);
            waiting[own.size()].push_back(one);
            degree = std::min(degree, own.size());
        }
    }
    return order;
}

/// Returns the blocks that each block shares an entry with.
[[nodiscard]] ANCF_INLINE List<List<int>> coupled_blocks(const SparseMatrix& matrix,
                                                         const List<int>& blocks) {
    const int count = blocks.empty() ? 0 : *std::max_element(blocks.begin(), blocks.end()) + 1;
    List<List<int>> neighbours(static_cast<std::size_t>(count));
    for (int j = 0; j < matrix.cols(); ++j)
        for (int k = matrix.outerIndexPtr()[j]; k < matrix.outerIndexPtr()[j + 1]; ++k) {
            const int a = blocks[matrix.innerIndexPtr()[k]];
            const int b = blocks[j];
            if (a == b) continue;
            List<int>& of_a = neighbours[a];
            std::size_t found = of_a.size();  // most likely among the last
            while (found > 0 && of_a[found - 1] != b) --found;
            if (found > 0) continue;
            of_a.push_back(b);
            neighbours[b].push_back(a);
        }
    return neighbours;
}

ANCF_INLINE bool SparseLdlt::factorize(const SparseMatrix& lower, const List<int>& blocks, int last,
                                       bool to_end) {
    const int* outer = lower.outerIndexPtr();
    const int* inner = lower.innerIndexPtr();
    const int *outer_end = outer + lower.cols() + 1, *inner_end = inner + outer[lower.cols()];
    if (blocks != blocks_ || last != last_ || to_end != to_end_ ||
        !std::equal(outer, outer_end, outer_.begin(), outer_.end()) ||
        !std::equal(inner, inner_end, inner_.begin(), inner_.end())) {
        outer_.clear();  // until all is known
        blocks_ = blocks;
        last_ = last;
        to_end_ = to_end;
        complete_ = false;
        inner_.assign(inner, inner_end);
        order(lower);
        permute(outer);
        analyze();
        outer_.assign(outer, outer_end);
    }
    const int first = take_values(lower.valuePtr());
    return eliminate(complete_ ? first : 0);
}

/// Takes the values of a matrix; returns the first row with another one than before.
ANCF_INLINE int SparseLdlt::take_values(const double* values) {
    int first = size();
    for (int k = size() - 1; k >= 0; --k)
        for (std::size_t e = upper_first_[k]; e < upper_first_[k + 1]; ++e) {
            if (values[from_[e]] != upper_value_[e]) first = k;
            upper_value_[e] = values[from_[e]];
        }
    return first;
}

/// Finds the order of elimination.
ANCF_INLINE void SparseLdlt::order(const SparseMatrix& lower) {
    List<List<int>> neighbours = coupled_blocks(lower, blocks_);
    List<char> waits(neighbours.size(), 0);
    for (std::size_t row = blocks_.size() - last_; row < blocks_.size(); ++row)
        waits[blocks_[row]] = 1;
    List<List<int>> awaited(neighbours.size());
    for (std::size_t block = 0; last_ > 0 && block < neighbours.size(); ++block) {
        List<int>& of = neighbours[block];
        const auto is_last = [&](int other) { return waits[other] != 0; };
        of.erase(std::remove_if(of.begin(), of.end(), is_last), of.end());
        if (waits[block] != 0) awaited[block] = std::exchange(of, {});
    }
    const List<int> sequence = minimum_degree(std::move(neighbours));
    const auto end = 2 * static_cast<int>(sequence.size());
    List<int> turn(sequence.size());  // even, of blocks that wait odd or the end
    for (int k = 0; k < end; k += 2) turn[sequence[k / 2]] = k;
    for (std::size_t block = 0; block < turn.size(); ++block) {
        if (waits[block] == 0) continue;
        turn[block] = to_end_ ? end : 0;
        for (const int other : awaited[block]) turn[block] = std::max(turn[block], turn[other] + 1);
    }
    List<List<int>> rows(static_cast<std::size_t>(end) + 1);  // at each turn
    for (std::size_t row = 0; row < blocks_.size(); ++row)
        rows[turn[blocks_[row]]].push_back(static_cast<int>(row));
    order_.clear();
    place_.assign(blocks_.size(), -1);
    for (const List<int>& at_turn : rows)
        for (const int row : at_turn) {
            place_[row] = static_cast<int>(order_.size());
            order_.push_back(row);
        }
}

/// Finds where each value of the lower half stands in the upper half of the permuted matrix.
ANCF_INLINE void SparseLdlt::permute(const int* outer) {
    const auto visit = [&](const auto& entry) {
        for (int j = 0; j < size(); ++j)
            for (int k = outer[j]; k < outer[j + 1]; ++k) {
                const int i = inner_[k];
                if (i < j) continue;
                const int a = place_[i];
                const int b = place_[j];
                entry(std::min(a, b), static_cast<std::size_t>(std::max(a, b)), k);
            }
    };
    upper_first_.assign(order_.size() + 1, 0);
    visit([&](int, std::size_t column, int) { ++upper_first_[column + 1]; });
    for (std::size_t k = 0; k < order_.size(); ++k) upper_first_[k + 1] += upper_first_[k];
    upper_row_.resize(upper_first_.back());
    upper_value_.resize(upper_first_.back());
    from_.resize(upper_first_.back());
    List<std::size_t> next = upper_first_;
    visit([&](int row, std::size_t column, int slot) {
        upper_row_[next[column]] = row;
        from_[next[column]++] = slot;
    });
}

/// Finds the elimination tree and how long each column of L is.
ANCF_INLINE void SparseLdlt::analyze() {
    const int rows = size();
    parent_.assign(order_.size(), -1);
    List<int> seen(order_.size(), -1);
    first_.assign(order_.size() + 1, 0);
    int* const parent = parent_.data();
    for (int k = 0; k < rows; ++k) {
        seen[k] = k;
        for (std::size_t e = upper_first_.data()[k]; e < upper_first_.data()[k + 1]; ++e)
            for (int i = upper_row_[e]; seen.data()[i] != k; i = parent[i]) {
                if (parent[i] < 0) parent[i] = k;
                ++first_.data()[i + 1];
                seen.data()[i] = k;
            }
    }
    for (std::size_t k = 0; k < order_.size(); ++k) first_[k + 1] += first_[k];
    row_.resize(first_.back());
    value_.resize(first_.back());
}

/// Computes L and D, a row of L after the other, from a row on: those before are there.
ANCF_INLINE bool SparseLdlt::eliminate(int from) {
    const int rows = size();
    pivots_.resize(order_.size());
    List<double> work(order_.size(), 0.0);
    List<int> seen(order_.size(), -1), pattern(order_.size()), path(order_.size());
    List<std::size_t> end = first_;
    double* const y = work.data();
    int* const row = row_.data();
    double* const value = value_.data();
    for (int i = 0; i < from; ++i)
        end.data()[i] =
            std::lower_bound(row + first_.data()[i], row + first_.data()[i + 1], from) - row;
    complete_ = false;
    for (int k = from; k < rows; ++k) {
        int top = rows;
        seen.data()[k] = k;
        for (std::size_t e = upper_first_.data()[k]; e < upper_first_.data()[k + 1]; ++e) {
            int i = upper_row_[e];
            y[i] += upper_value_[e];
            int length = 0;
            for (; seen.data()[i] != k; i = parent_.data()[i]) {
                path.data()[length++] = i;
                seen.data()[i] = k;
            }
            while (length > 0) pattern.data()[--top] = path.data()[--length];
        }
        double pivot = std::exchange(y[k], 0.0);
        for (; top < rows; ++top) {
            const int i = pattern.data()[top];
            const double yi = std::exchange(y[i], 0.0);
            std::size_t& last = end.data()[i];
            for (std::size_t e = first_.data()[i]; e < last; ++e) y[row[e]] -= value[e] * yi;
            const double entry = yi / pivots_.data()[i];
            pivot -= entry * yi;
            row[last] = k;
            value[last++] = entry;
        }
        if (pivot == 0.0 || !std::isfinite(pivot)) return false;
        pivots_.data()[k] = pivot;
    }
    matrix_row_.resize(row_.size());
    for (std::size_t e = 0; e < row_.size(); ++e) matrix_row_[e] = order_[row_[e]];
    complete_ = true;
    return true;
}

ANCF_INLINE void SparseLdlt::solve(VectorX& x) const {
    double* const y = x.data();
    const int* const row = matrix_row_.data();
    const double* const value = value_.data();
    for (int k = 0; k < size(); ++k) {
        const double from = y[order_.data()[k]];
        for (std::size_t e = first_.data()[k]; e < first_.data()[k + 1]; ++e)
            y[row[e]] -= value[e] * from;
    }
    for (int k = size() - 1; k >= 0; --k) {
        double sum = y[order_.data()[k]] / pivots_.data()[k];
        for (std::size_t e = first_.data()[k]; e < first_.data()[k + 1]; ++e)
            sum -= value[e] * y[row[e]];
        y[order_.data()[k]] = sum;
    }
}

}  // namespace ancf::detail
