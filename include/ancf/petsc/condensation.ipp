// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of condensation.hpp.

#pragma once

#include <ancf/petsc/condensation.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <utility>

namespace ancf::petsc::detail {

ANCF_INLINE Condensation::Condensation(const SparseMatrix& pattern,
                                       std::vector<std::vector<int>> sets, bool symmetric)
    : symmetric_(symmetric), kept_(static_cast<std::size_t>(pattern.cols()), 1) {
    for (const std::vector<int>& set : sets)
        for (const int k : set) kept_[static_cast<std::size_t>(k)] = 0;
    const int* const outer = pattern.outerIndexPtr();
    const int* const inner = pattern.innerIndexPtr();
    for (int j = 0; j < pattern.cols(); ++j) {
        start_.push_back(entries_);
        if (!keeps(j)) continue;
        for (int k = outer[j]; k < outer[j + 1]; ++k) entries_ += keeps(inner[k]) ? 1 : 0;
    }
    std::size_t size = 0;
    for (std::vector<int>& own : sets) {
        Set& set = sets_.emplace_back();
        for (const int j : own)
            for (int k = outer[j]; k < outer[j + 1]; ++k)
                if (keeps(inner[k])) set.others.push_back(inner[k]);
        std::sort(set.others.begin(), set.others.end());
        set.others.erase(std::unique(set.others.begin(), set.others.end()), set.others.end());
        set.own = std::move(own);
        set.first = size;
        size += set.own.size() * (set.own.size() + (symmetric ? 1 : 2) * set.others.size());
    }
    factors_.resize(size);
}

ANCF_INLINE bool Condensation::reduce(const SparseMatrix& matrix, double* values) {
    const int* const outer = matrix.outerIndexPtr();
    const int* const inner = matrix.innerIndexPtr();
    const double* const from = matrix.valuePtr();
    double* to = values;
    for (int j = 0; j < matrix.cols(); ++j) {
        if (!keeps(j)) continue;
        for (int k = outer[j]; k < outer[j + 1]; ++k)
            if (keeps(inner[k])) *to++ = from[k];
    }
    // calls visit(place among the wanted rows, entry) for the entries of a column
    const auto walk = [&](int column, const std::vector<int>& rows, const auto& visit) {
        std::size_t i = 0;
        for (int k = outer[column]; k < outer[column + 1] && i < rows.size(); ++k) {
            while (i < rows.size() && rows[i] < inner[k]) ++i;
            if (i < rows.size() && rows[i] == inner[k])
                visit(static_cast<Eigen::Index>(i), from[k]);
        }
    };
    MatrixX ee, ne, en, change;
    for (const Set& set : sets_) {
        const auto m = static_cast<Eigen::Index>(set.own.size());
        const auto n = static_cast<Eigen::Index>(set.others.size());
        ee.setZero(m, m);
        ne.setZero(n, m);
        for (Eigen::Index j = 0; j < m; ++j) {
            const int column = set.own[static_cast<std::size_t>(j)];
            walk(column, set.own, [&](Eigen::Index i, double value) { ee(i, j) = value; });
            walk(column, set.others, [&](Eigen::Index i, double value) { ne(i, j) = value; });
        }
        if (symmetric_) {
            en = ne.transpose();
        } else {
            en.setZero(m, n);
            for (Eigen::Index j = 0; j < n; ++j)
                walk(set.others[static_cast<std::size_t>(j)], set.own,
                     [&](Eigen::Index i, double value) { en(i, j) = value; });
        }
        double* const factors = factors_.data() + set.first;
        Eigen::Map<MatrixX> inverse(factors, m, m), right(factors + m * m, m, n);
        inverse = ee.inverse();
        if (!inverse.allFinite()) return false;
        right.noalias() = inverse * en;
        change.noalias() = ne * right;
        if (!symmetric_) Eigen::Map<MatrixX>(factors + m * (m + n), n, m).noalias() = ne * inverse;
        for (Eigen::Index j = 0; j < n; ++j) {
            const int column = set.others[static_cast<std::size_t>(j)];
            std::size_t place = start_[static_cast<std::size_t>(column)], i = 0;
            for (int k = outer[column]; k < outer[column + 1] && i < set.others.size(); ++k) {
                if (!keeps(inner[k])) continue;
                while (i < set.others.size() && set.others[i] < inner[k]) ++i;
                if (i < set.others.size() && set.others[i] == inner[k])
                    values[place] -= change(static_cast<Eigen::Index>(i), j);
                ++place;
            }
        }
    }
    return true;
}

ANCF_INLINE void Condensation::shift(const VectorX& b, VectorX& out) const {
    out.setZero(b.size());
    for (const Set& set : sets_) {
        const std::size_t m = set.own.size(), n = set.others.size();
        const double* const right = factors_.data() + set.first + m * m;
        for (std::size_t i = 0; i < m; ++i) {
            const double own = b[set.own[i]];
            for (std::size_t j = 0; j < n; ++j)
                out[set.others[j]] -=
                    own * (symmetric_ ? right[j * m + i] : right[m * n + i * n + j]);
        }
    }
}

ANCF_INLINE void Condensation::complete(const VectorX& b, VectorX& x) const {
    for (const Set& set : sets_) {
        const std::size_t m = set.own.size(), n = set.others.size();
        const double* const inverse = factors_.data() + set.first;
        const double* const right = inverse + m * m;
        for (std::size_t i = 0; i < m; ++i) {
            double sum = 0.0;
            for (std::size_t j = 0; j < m; ++j) sum += inverse[j * m + i] * b[set.own[j]];
            for (std::size_t j = 0; j < n; ++j) sum -= right[j * m + i] * x[set.others[j]];
            x[set.own[i]] = sum;
        }
    }
}

}  // namespace ancf::petsc::detail
