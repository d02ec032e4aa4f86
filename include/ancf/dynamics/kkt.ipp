// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/dynamics/kkt.hpp>
#include <ancf/list.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace ancf::detail {

ANCF_INLINE void KktSystem::analyze(const SparseMatrix& pattern, int rows, List<int> blocks) {
    rows_ = rows;
    blocks_ = std::move(blocks);
    if (blocks_.empty())
        for (int row = 0; row < pattern.cols(); ++row) blocks_.push_back(row);
    const auto equations = static_cast<int>(pattern.cols()) - rows;
    last_ = equations <= most_last ? equations : 0;
    share_ = largest_share;
    factorised_.clear();
    // Explicit zeros would fill L. The first entry of each pair of blocks stays: blocks keep
    // their order. With constraints all stay: their sums keep their bits.
    const auto begins = [&](int row) { return row == 0 || blocks_[row] != blocks_[row - 1]; };
    matrix_ = SparseMatrix(pattern.cols(), pattern.cols());
    slots_.clear();
    zeros_.clear();
    for (int j = 0; j < pattern.cols(); ++j) {
        for (int k = pattern.outerIndexPtr()[j]; k < pattern.outerIndexPtr()[j + 1]; ++k) {
            const int i = pattern.innerIndexPtr()[k];
            if (i < j) continue;
            const bool kept =
                equations > 0 || i == j || pattern.valuePtr()[k] != 0.0 || (begins(i) && begins(j));
            (kept ? slots_ : zeros_).push_back(k);
        }
        matrix_.outerIndexPtr()[j + 1] = static_cast<int>(slots_.size());
    }
    matrix_.resizeNonZeros(static_cast<int>(slots_.size()));
    for (std::size_t k = 0; k < slots_.size(); ++k)
        matrix_.innerIndexPtr()[k] = pattern.innerIndexPtr()[slots_[k]];
    for (int row = 0; row < matrix_.cols(); ++row) {
        const SparseMatrix::InnerIterator first(matrix_, row);
        require(first && first.row() == row, "KktSystem: the pattern has no diagonal entry in row ",
                row);
    }
}

ANCF_INLINE Status KktSystem::factorize(const SparseMatrix& matrix) {
    const double* first = matrix.valuePtr();
    const double* last = first + entries(matrix);
    if (std::equal(first, last, factorised_.begin(), factorised_.end())) return Status::converged;
    factorised_.clear();
    if (!all_finite(matrix)) return Status::not_finite;
    if (std::any_of(zeros_.begin(), zeros_.end(), [=](int k) { return first[k] != 0.0; }))
        analyze(matrix, rows_, List<int>(blocks_));
    for (std::size_t k = 0; k < slots_.size(); ++k) matrix_.valuePtr()[k] = first[slots_[k]];
    scales_ = unit_scales(matrix_);
    for (VectorX& sizes : sizes_) sizes.setZero(matrix_.cols());
    for (int j = 0; j < matrix_.cols(); ++j)
        for (SparseMatrix::InnerIterator entry(matrix_, j); entry; ++entry) {
            const auto i = entry.row();
            sizes_[j < rows_ ? 0 : 1][i] += std::abs(entry.value()) * scales_[j];
            if (i != j) sizes_[i < rows_ ? 0 : 1][j] += std::abs(entry.value()) * scales_[i];
        }
    if (!factorize_values()) return Status::singular;
    factorised_.assign(first, last);
    return Status::converged;
}

ANCF_INLINE Status KktSystem::solve(const VectorX& b, VectorX& x) {
    for (;;) {
        const double error = refine(b, x);
        if (error <= 1e-13) return Status::converged;
        if (!all_finite(x) || (last_ == 0 && share_ < smallest_share))
            return error <= 1e-10 ? Status::converged : Status::singular;
        if (last_ == 0) share_ *= 1e-3;
        last_ = 0;
        if (!factorize_values()) return Status::singular;
    }
}

ANCF_INLINE double KktSystem::refine(const VectorX& b, VectorX& x) const {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    x = b;
    ldlt_.solve(x);
    VectorX residual, next = x;
    double error = std::numeric_limits<double>::infinity();
    for (int step = 0; step < 30; ++step) {
        const double now = relative_residual(b, next, residual);
        if (!(now < error)) break;
        const bool slow = now > 0.5 * error;
        x = next;
        error = now;
        if (slow || error < 4.0 * epsilon) break;
        ldlt_.solve(residual);
        for (Eigen::Index i = 0; i < x.size(); ++i) next[i] = x[i] + residual[i];
    }
    return error;
}

ANCF_INLINE double KktSystem::relative_residual(const VectorX& b, const VectorX& x,
                                                VectorX& residual) const {
    // below this round-off is absolute: the rates of motions that die out are not judged
    constexpr double nothing =
        std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
    residual = b;
    double largest[2] = {0.0, 0.0}, rest[2] = {0.0, 0.0}, size[2] = {0.0, 0.0};
    const auto part = [this](Eigen::Index i) { return i < rows_ ? 0 : 1; };  // of other units
    for (Eigen::Index i = 0; i < x.size(); ++i)
        largest[part(i)] = std::max(largest[part(i)], std::abs(x[i]) / scales_[i]);
    // what b alone would make of the first part: where constraints take all of it, x is round-off
    for (int i = 0; i < rows_; ++i) {
        const double diagonal = std::abs(matrix_.valuePtr()[matrix_.outerIndexPtr()[i]]);
        if (diagonal > 0.0)
            largest[0] = std::max(largest[0], std::abs(b[i]) / (diagonal * scales_[i]));
    }
    for (int j = 0; j < matrix_.cols(); ++j) {
        double row = residual[j];
        for (SparseMatrix::InnerIterator entry(matrix_, j); entry; ++entry) {
            const auto i = entry.row();
            row -= entry.value() * x[i];
            if (i != j) residual[i] -= entry.value() * x[j];
        }
        residual[j] = row;
    }
    for (Eigen::Index i = 0; i < b.size(); ++i) {
        rest[part(i)] = std::max(rest[part(i)], scales_[i] * std::abs(residual[i]));
        const double terms = std::abs(b[i]) + sizes_[0][i] * largest[0] + sizes_[1][i] * largest[1];
        size[part(i)] = std::max(size[part(i)], scales_[i] * terms);
    }
    if (!all_finite(residual)) return std::numeric_limits<double>::infinity();
    double ratio = 0.0;
    for (int k = 0; k < 2; ++k)
        if (size[k] > nothing) ratio = std::max(ratio, rest[k] / size[k]);
    return ratio;
}

ANCF_INLINE bool KktSystem::factorize_values() {
    // the first entry of a column of the lower half is its diagonal
    VectorX sizes = VectorX::Zero(matrix_.cols());  // of G diag(A)^-1 G^T
    for (int column = 0; column < rows_; ++column) {
        const SparseMatrix::InnerIterator diagonal(matrix_, column);
        if (diagonal.value() == 0.0) continue;
        for (SparseMatrix::InnerIterator entry(matrix_, column); entry; ++entry)
            if (entry.row() >= rows_)
                sizes[entry.row()] += entry.value() * entry.value() / std::abs(diagonal.value());
    }
    if (last_ > 0) {
        bool independent = ldlt_.factorize(matrix_, blocks_, last_);
        for (int row = rows_; independent && row < matrix_.cols(); ++row)
            independent = std::abs(ldlt_.pivot(row)) >= least_pivot * sizes[row];
        if (independent) return true;
        last_ = 0;
    }
    SparseMatrix shifted = matrix_;
    for (int row = rows_; row < matrix_.cols(); ++row) {
        SparseMatrix::InnerIterator diagonal(shifted, row);
        if (diagonal.value() == 0.0) diagonal.valueRef() = -share_ * sizes[row];
    }
    return ldlt_.factorize(shifted, blocks_);
}

}  // namespace ancf::detail
