// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of sparse_ldlt.hpp.

#pragma once

#include <ancf/dynamics/sparse_ldlt.hpp>

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace ancf::detail {

ANCF_INLINE SparseLdlt::Upper SparseLdlt::permuted(const SparseMatrix& lower) const {
    const auto size = static_cast<int>(lower.cols());
    const auto visit = [&](const auto& take) {
        for (int j = 0; j < size; ++j)
            for (int k = lower.outerIndexPtr()[j]; k < lower.outerIndexPtr()[j + 1]; ++k) {
                const int i = lower.innerIndexPtr()[k];
                if (i < j) continue;
                const int a = place_[static_cast<std::size_t>(i)];
                const int b = place_[static_cast<std::size_t>(j)];
                take(std::min(a, b), static_cast<std::size_t>(std::max(a, b)), lower.valuePtr()[k]);
            }
    };
    Upper upper;
    upper.start.assign(static_cast<std::size_t>(size) + 1, 0);
    visit([&](int, std::size_t column, double) { ++upper.start[column + 1]; });
    for (std::size_t j = 0; j < static_cast<std::size_t>(size); ++j)
        upper.start[j + 1] += upper.start[j];
    upper.row.resize(static_cast<std::size_t>(upper.start.back()));
    upper.value.resize(upper.row.size());
    std::vector<int> next = upper.start;
    visit([&](int row, std::size_t column, double value) {
        const auto slot = static_cast<std::size_t>(next[column]++);
        upper.row[slot] = row;
        upper.value[slot] = value;
    });
    return upper;
}

ANCF_INLINE void SparseLdlt::analyze(const SparseMatrix& lower) {
    const auto size = static_cast<std::size_t>(lower.cols());
    place_.assign(size, 0);
    parent_.assign(size, -1);
    pivot_.assign(size, 0.0);
    work_.assign(size, 0.0);
    pattern_.assign(size, 0);
    mark_.assign(size, -1);
    filled_.assign(size, 0);
    start_.assign(size + 1, 0);
    if (size > 0) {
        Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
        Eigen::AMDOrdering<int>()(lower, order);
        for (std::size_t k = 0; k < size; ++k)
            place_[static_cast<std::size_t>(order.indices()[static_cast<Eigen::Index>(k)])] =
                static_cast<int>(k);
    }
    // the entries of row k of L are the nodes below k on the paths from those of A's row to the root
    const Upper upper = permuted(lower);
    for (std::size_t k = 0; k < size; ++k) {
        const int row = static_cast<int>(k);
        mark_[k] = row;
        for (int at = upper.start[k]; at < upper.start[k + 1]; ++at) {
            auto i = static_cast<std::size_t>(upper.row[static_cast<std::size_t>(at)]);
            while (mark_[i] != row) {
                if (parent_[i] < 0) parent_[i] = row;
                ++start_[i + 1];
                mark_[i] = row;
                i = static_cast<std::size_t>(parent_[i]);
            }
        }
    }
    for (std::size_t k = 0; k < size; ++k) start_[k + 1] += start_[k];
    row_.resize(static_cast<std::size_t>(start_.back()));
    value_.resize(row_.size());
}

ANCF_INLINE bool SparseLdlt::factorize(const SparseMatrix& lower) {
    const Upper upper = permuted(lower);
    std::fill(filled_.begin(), filled_.end(), 0);
    std::fill(mark_.begin(), mark_.end(), -1);
    std::fill(work_.begin(), work_.end(), 0.0);
    for (std::size_t k = 0; k < pivot_.size(); ++k) {
        pivot_[k] = eliminate(static_cast<int>(k), upper);
        if (pivot_[k] == 0.0) return false;
    }
    return true;
}

/// Computes a row of L by a sparse triangular solution with the rows before it; returns its pivot.
ANCF_INLINE double SparseLdlt::eliminate(int k, const Upper& upper) {
    // rows in the order of the tree, the last found first
    auto top = static_cast<int>(pattern_.size());
    int* const pattern = pattern_.data();
    double* const work = work_.data();
    mark_[static_cast<std::size_t>(k)] = k;
    for (int at = upper.start[static_cast<std::size_t>(k)];
         at < upper.start[static_cast<std::size_t>(k) + 1]; ++at) {
        int i = upper.row[static_cast<std::size_t>(at)];
        work[i] += upper.value[static_cast<std::size_t>(at)];
        int length = 0;
        for (; mark_[static_cast<std::size_t>(i)] != k; i = parent_[static_cast<std::size_t>(i)]) {
            pattern[length++] = i;
            mark_[static_cast<std::size_t>(i)] = k;
        }
        while (length > 0) pattern[--top] = pattern[--length];
    }
    double pivot = work[k];
    work[k] = 0.0;
    for (; top < static_cast<int>(pattern_.size()); ++top) {
        const auto i = static_cast<std::size_t>(pattern[top]);
        const double above = work[i];
        work[i] = 0.0;
        const double entry = above / pivot_[i];
        const int end = start_[i] + filled_[i]++;
        for (int p = start_[i]; p < end; ++p)
            work[row_[static_cast<std::size_t>(p)]] -= value_[static_cast<std::size_t>(p)] * above;
        pivot -= entry * above;
        row_[static_cast<std::size_t>(end)] = k;
        value_[static_cast<std::size_t>(end)] = entry;
    }
    return pivot;
}

ANCF_INLINE double SparseLdlt::smallest_pivot() const noexcept {
    double least = std::numeric_limits<double>::infinity();
    for (const double pivot : pivot_) {
        if (!(pivot >= least)) least = pivot;
        if (least != least) break;
    }
    return least;
}

ANCF_INLINE void SparseLdlt::solve(const VectorX& b, VectorX& x) const {
    const auto size = static_cast<int>(pivot_.size());
    VectorX turned(size);
    for (int k = 0; k < size; ++k) turned[place_[static_cast<std::size_t>(k)]] = b[k];
    double* const y = turned.data();
    const int* const row = row_.data();
    const double* const value = value_.data();
    for (int j = 0; j < size; ++j)
        for (int p = start_[static_cast<std::size_t>(j)];
             p < start_[static_cast<std::size_t>(j) + 1]; ++p)
            y[row[p]] -= value[p] * y[j];
    for (int j = 0; j < size; ++j) y[j] = 1.0 / pivot_[static_cast<std::size_t>(j)] * y[j];
    for (int j = size - 1; j >= 0; --j)
        for (int p = start_[static_cast<std::size_t>(j)];
             p < start_[static_cast<std::size_t>(j) + 1]; ++p)
            y[j] -= value[p] * y[row[p]];
    x.resize(size);
    for (int k = 0; k < size; ++k) x[k] = turned[place_[static_cast<std::size_t>(k)]];
}

}  // namespace ancf::detail
