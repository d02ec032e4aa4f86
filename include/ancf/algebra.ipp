// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/list.hpp>

#include <algorithm>
#include <cstddef>

namespace ancf::detail {

ANCF_INLINE void gather(const VectorX& x, const List<int>& at, VectorX& out) {
    out.resize(static_cast<Eigen::Index>(at.size()));
    double* to = out.data();
    for (const int k : at) *to++ = x[k];
}

ANCF_INLINE double largest_ratio(const VectorX& x, const VectorX& scale) {
    double largest = 0.0;
    for (Eigen::Index k = 0; k < x.size(); ++k) {
        const double ratio = std::abs(x[k]) / scale[k];
        if (std::isnan(ratio)) return ratio;
        largest = std::max(largest, ratio);
    }
    return largest;
}

ANCF_INLINE double largest_magnitude(const VectorX& x) noexcept {
    double largest = 0.0;
    for (Eigen::Index i = 0; i < x.size() && largest == largest; ++i)
        if (!(std::abs(x[i]) <= largest)) largest = std::abs(x[i]);
    return largest;
}

ANCF_INLINE VectorX multiply(const MatrixX& A, const VectorX& x) {
    VectorX out = VectorX::Zero(A.rows());
    for (Eigen::Index j = 0; j < A.cols(); ++j)
        for (Eigen::Index i = 0; i < A.rows(); ++i) out[i] += A(i, j) * x[j];
    return out;
}

ANCF_INLINE void add_product(const SparseMatrix& A, Storage storage, double scale, const VectorX& x,
                             VectorX& out) {
    const int* row = A.innerIndexPtr();
    const double* value = A.valuePtr();
    const auto columns = static_cast<int>(std::min<Eigen::Index>(A.cols(), x.size()));
    const auto rows = static_cast<int>(out.size());
    if (storage == Storage::full && rows >= A.rows()) {  // as most are, without a test per entry
        double* sums = out.data();
        for (int j = 0; j < columns; ++j) {
            const double factor = x[j];
            for (int k = A.outerIndexPtr()[j]; k < A.outerIndexPtr()[j + 1]; ++k)
                sums[row[k]] += scale * value[k] * factor;
        }
        return;
    }
    for (int j = 0; j < columns; ++j)
        for (int k = A.outerIndexPtr()[j]; k < A.outerIndexPtr()[j + 1]; ++k) {
            const int i = row[k];
            if (i < rows) out[i] += scale * value[k] * x[j];
            if (storage == Storage::lower && i != j && i < x.size() && j < rows)
                out[j] += scale * value[k] * x[i];
        }
}

ANCF_INLINE VectorX multiply(const SparseMatrix& A, Storage storage, const VectorX& x) {
    VectorX out = VectorX::Zero(x.size());
    add_product(A, storage, 1.0, x, out);
    return out;
}

ANCF_INLINE SparseMatrix leading_block(const SparseMatrix& A, int size, Storage storage) {
    // Two passes over the entries kept: count each column, then fill it. Rows ascend, since the
    // mirror images of a column come from columns before it.
    List<int> next(static_cast<std::size_t>(size) + 1, 0);
    const auto visit = [&](const auto& keep) {
        for (int j = 0; j < size; ++j)
            for (int k = A.outerIndexPtr()[j]; k < A.outerIndexPtr()[j + 1]; ++k) {
                const int i = A.innerIndexPtr()[k];
                const double value = A.valuePtr()[k];
                if (i >= size || value == 0.0) continue;
                keep(i, j, value);
                if (storage == Storage::lower && i != j) keep(j, i, value);
            }
    };
    visit([&](int, int j, double) { ++next[static_cast<std::size_t>(j) + 1]; });
    for (std::size_t j = 0; j < static_cast<std::size_t>(size); ++j) next[j + 1] += next[j];
    SparseMatrix block(size, size);
    block.resizeNonZeros(next.back());
    std::copy(next.begin(), next.end(), block.outerIndexPtr());
    visit([&](int i, int j, double value) {
        const int slot = next[j]++;
        block.innerIndexPtr()[slot] = i;
        block.valuePtr()[slot] = value;
    });
    return block;
}

ANCF_INLINE void symmetrise(SparseMatrix& A) {
    const List<double> values(A.valuePtr(), A.valuePtr() + entries(A));
    // rows ascend, so the mirror images of a column's entries are met in their order
    List<int> next(A.outerIndexPtr(), A.outerIndexPtr() + A.cols());
    for (int j = 0; j < static_cast<int>(A.cols()); ++j)
        for (int k = A.outerIndexPtr()[j]; k < A.outerIndexPtr()[j + 1]; ++k) {
            int& mirrored = next.data()[A.innerIndexPtr()[k]];
            A.valuePtr()[k] = 0.5 * (values.data()[k] + values.data()[mirrored++]);
        }
}

ANCF_INLINE bool all_finite(const SparseMatrix& matrix) noexcept {
    for (Eigen::Index k = 0; k < entries(matrix); ++k)
        if (!std::isfinite(matrix.valuePtr()[k])) return false;
    return true;
}

ANCF_INLINE double power_of_two(int exponent) noexcept {
    return std::ldexp(1.0, std::max(-1000, std::min(1000, exponent)));
}

ANCF_INLINE void complete_roots(const SparseMatrix& matrix, double one, VectorX& roots) {
    const auto size = static_cast<int>(matrix.cols());
    const auto for_each = [&](const auto& visit) {
        for (int j = 0; j < size; ++j)
            for (int k = matrix.outerIndexPtr()[j]; k < matrix.outerIndexPtr()[j + 1]; ++k) {
                const double entry = std::abs(matrix.valuePtr()[k]);
                if (std::isfinite(entry)) visit(matrix.innerIndexPtr()[k], j, entry);
            }
    };
    VectorX known = roots, largest = VectorX::Zero(size);  // entries beside the diagonal
    for_each([&](int i, int j, double entry) {
        if (i == j) return;
        largest[i] = std::max(largest[i], entry);
        largest[j] = std::max(largest[j], entry);
        if (entry > 1024.0 * one * roots[i] * roots[j] && roots[i] > 0.0 && roots[j] > 0.0)
            known[i] = known[j] = 0.0;
    });
    // rows without a diagonal: what the firmest of their unknowns makes of their root
    VectorX firm = VectorX::Zero(size);
    const auto for_each_tie = [&](const auto& visit) {
        for_each([&](int i, int j, double entry) {
            if ((roots[i] == 0.0) == (roots[j] == 0.0)) return;
            const int tie = roots[i] == 0.0 ? i : j, tied = roots[i] == 0.0 ? j : i;
            if (entry > 1e-2 * largest[tie]) visit(tie, tied, roots[tied] / entry);
        });
    };
    for_each_tie([&](int tie, int, double root) { firm[tie] = std::max(firm[tie], root); });
    for_each_tie([&](int tie, int tied, double root) {
        if (root < 0x1p-20 * firm[tie]) known[tied] = 0.0;
    });
    bool incomplete = false;
    for (int i = 0; i < size; ++i) {
        if (one * roots[i] * roots[i] > 1e-2 * largest[i]) known[i] = roots[i];
        incomplete = incomplete || known[i] == 0.0;
    }
    // From one to the next, first by entries that count in their rows. The limit spares long chains
    // of rows without a diagonal.
    for (int pass = 0; pass < 20 && incomplete; ++pass) {
        VectorX next = roots, beside = VectorX::Zero(size);
        for_each([&](int i, int j, double entry) {
            if ((known[i] == 0.0) == (known[j] == 0.0)) return;
            const int lacking = known[i] == 0.0 ? i : j, other = known[i] == 0.0 ? j : i;
            next[lacking] = std::max(next[lacking], entry / (one * known[other]));
            beside[lacking] = std::max(beside[lacking], entry);
        });
        incomplete = false;
        for (int i = 0; i < size; ++i) {
            if (known[i] == 0.0 && beside[i] > (pass < 10 ? 1e-2 : 0.0) * largest[i])
                known[i] = next[i];
            incomplete = incomplete || known[i] == 0.0;
        }
    }
    for (int i = 0; i < size; ++i) {
        if (known[i] > 0.0) roots[i] = known[i];
        if (roots[i] == 0.0) roots[i] = 1.0;
    }
}

ANCF_INLINE VectorX unit_scales(const SparseMatrix& matrix) {
    const auto size = static_cast<int>(matrix.cols());
    const int *outer = matrix.outerIndexPtr(), *row = matrix.innerIndexPtr();
    const double* value = matrix.valuePtr();
    VectorX roots = VectorX::Zero(size);  // of the diagonal over 2^first
    int first = 0, found = 0;
    for (int j = 0; j < size; ++j)
        for (int k = outer[j]; k < outer[j + 1] && row[k] <= j; ++k) {
            if (row[k] != j || value[k] == 0.0 || !std::isfinite(value[k])) continue;
            const int exponent = std::ilogb(value[k]);
            if (found++ == 0) first = exponent;
            const int apart = exponent - first;
            roots[j] = power_of_two(apart >= 0 ? apart / 2 : -((1 - apart) / 2));
        }
    if (found < size) complete_roots(matrix, std::ldexp(1.0, first), roots);
    for (double& root : roots) root = power_of_two(-std::ilogb(root));
    return roots;
}

ANCF_INLINE VectorX row_scales(const SparseMatrix& matrix, const VectorX& columns) {
    VectorX scales = VectorX::Zero(matrix.rows());
    for (int j = 0; j < static_cast<int>(matrix.cols()); ++j)
        for (int k = matrix.outerIndexPtr()[j]; k < matrix.outerIndexPtr()[j + 1]; ++k) {
            double& largest = scales[matrix.innerIndexPtr()[k]];
            largest = std::max(largest, std::abs(matrix.valuePtr()[k]) * columns[j]);
        }
    for (double& scale : scales) scale = scale > 0.0 ? power_of_two(-std::ilogb(scale)) : 1.0;
    return scales;
}

ANCF_INLINE SparseMatrix copied(const SparseMatrix& A) {
    SparseMatrix result(A.rows(), A.cols());
    result.resizeNonZeros(entries(A));
    std::copy_n(A.outerIndexPtr(), A.cols() + 1, result.outerIndexPtr());
    std::copy_n(A.innerIndexPtr(), entries(A), result.innerIndexPtr());
    std::copy_n(A.valuePtr(), entries(A), result.valuePtr());
    return result;
}

}  // namespace ancf::detail
