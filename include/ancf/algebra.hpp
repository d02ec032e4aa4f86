// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Sums, products and parts of vectors and sparse matrices as plain loops.
///
/// Each says what one expression of Eigen would, and costs a program far less to compile: for what
/// runs once, or costs little beside the elements and the factorisation.

#pragma once

#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace ancf::detail {

/// A term of combination(), for use within one expression.
struct Term {
    double factor;
    const VectorX& vector;
};

/// Returns the sum of the terms, one or more vectors of one size.
[[nodiscard]] inline VectorX combination(std::initializer_list<Term> terms) {
    const Eigen::Index size = terms.begin()->vector.size();
    VectorX sum(size);
    double* out = sum.data();
    for (Eigen::Index i = 0; i < size; ++i)
        out[i] = terms.begin()->factor * terms.begin()->vector[i];
    for (auto term = terms.begin() + 1; term != terms.end(); ++term) {
        eigen_assert(term->vector.size() == size);
        const double* x = term->vector.data();
        for (Eigen::Index i = 0; i < size; ++i) out[i] += term->factor * x[i];
    }
    return sum;
}

/// Returns a - b.
[[nodiscard]] inline VectorX difference(const VectorX& a, const VectorX& b) {
    return combination({{1.0, a}, {-1.0, b}});
}

/// Writes the entries of x at these places.
inline void gather(const VectorX& x, const std::vector<int>& at, VectorX& out) {
    out.resize(static_cast<Eigen::Index>(at.size()));
    double* to = out.data();
    for (const int k : at) *to++ = x[k];
}

/// Returns the largest |x(i)| / scale_i of so many, 0 of none and NaN where an entry is NaN.
template <class Entry>
[[nodiscard]] double largest_ratio_of(const Entry& x, Eigen::Index count, const VectorX& scale) {
    double largest = 0.0;
    for (Eigen::Index i = 0; i < count; ++i) {
        const double ratio = std::abs(x(i)) / scale[i];
        if (!(ratio <= largest)) largest = ratio;
        if (ratio != ratio) break;
    }
    return largest;
}

/// Returns the largest |x_i| / scale_i, likewise.
[[nodiscard]] inline double largest_ratio(const VectorX& x, const VectorX& scale) {
    return largest_ratio_of([&](Eigen::Index i) { return x[i]; }, x.size(), scale);
}

/// Returns the largest |x_i - y_i| / scale_i, likewise.
[[nodiscard]] inline double largest_distance(const VectorX& x, const VectorX& y,
                                             const VectorX& scale) {
    return largest_ratio_of([&](Eigen::Index i) { return x[i] - y[i]; }, x.size(), scale);
}

/// Returns A x.
[[nodiscard]] inline VectorX multiply(const MatrixX& A, const VectorX& x) {
    VectorX out = VectorX::Zero(A.rows());
    for (Eigen::Index j = 0; j < A.cols(); ++j)
        for (Eigen::Index i = 0; i < A.rows(); ++i) out[i] += A(i, j) * x[j];
    return out;
}

/// L L^T of a small matrix that is symmetric and positive definite.
template <int Size>
class SmallCholesky {
public:
    SmallCholesky() = default;

    explicit SmallCholesky(const Matrix<double, Size>& matrix) : lower_(matrix) {
        for (int k = 0; k < Size; ++k)
            for (int i = k; i < Size; ++i) {
                for (int j = 0; j < k; ++j) lower_(i, k) -= lower_(i, j) * lower_(k, j);
                lower_(i, k) = i == k ? std::sqrt(lower_(k, k)) : lower_(i, k) / lower_(k, k);
            }
    }

    /// Returns the solution of matrix x = b.
    [[nodiscard]] Vector<double, Size> solve(const Vector<double, Size>& b) const {
        Vector<double, Size> x = b;
        for (int i = 0; i < Size; ++i) {
            for (int j = 0; j < i; ++j) x[i] -= lower_(i, j) * x[j];
            x[i] /= lower_(i, i);
        }
        for (int i = Size - 1; i >= 0; --i) {
            for (int j = i + 1; j < Size; ++j) x[i] -= lower_(j, i) * x[j];
            x[i] /= lower_(i, i);
        }
        return x;
    }

private:
    Matrix<double, Size> lower_;
};

/// Adds scale A x, A compressed, x and out apart; of lower storage A holds the lower half alone.
///
/// x may be longer or shorter than A is wide: what it lacks is zero, and `out` gets as many rows as
/// it has.
inline void add_product(const SparseMatrix& A, Storage storage, double scale, const VectorX& x,
                        VectorX& out) {
    const int* row = A.innerIndexPtr();
    const double* value = A.valuePtr();
    const auto columns = static_cast<int>(std::min<Eigen::Index>(A.cols(), x.size()));
    const auto rows = static_cast<int>(out.size());
    for (int j = 0; j < columns; ++j)
        for (int k = A.outerIndexPtr()[j]; k < A.outerIndexPtr()[j + 1]; ++k) {
            const int i = row[k];
            if (i < rows) out[i] += scale * value[k] * x[j];
            if (storage == Storage::lower && i != j && i < x.size() && j < rows)
                out[j] += scale * value[k] * x[i];
        }
}

/// Returns A x, of as many rows as x; see add_product.
[[nodiscard]] inline VectorX multiply(const SparseMatrix& A, Storage storage, const VectorX& x) {
    VectorX out = VectorX::Zero(x.size());
    add_product(A, storage, 1.0, x, out);
    return out;
}

/// Returns both halves of the first rows and columns of a compressed matrix, without the zeros; of
/// lower storage it holds the lower half alone.
[[nodiscard]] inline SparseMatrix leading_block(const SparseMatrix& A, int size, Storage storage) {
    // Two passes over the entries kept: count each column, then fill it. Rows ascend, since the
    // mirror images of a column come from columns before it.
    std::vector<int> next(static_cast<std::size_t>(size) + 1, 0);
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
        const int slot = next[static_cast<std::size_t>(j)]++;
        block.innerIndexPtr()[slot] = i;
        block.valuePtr()[slot] = value;
    });
    return block;
}

/// Replaces a compressed matrix of symmetric pattern by its symmetric part.
inline void symmetrise(SparseMatrix& A) {
    const std::vector<double> values(A.valuePtr(), A.valuePtr() + A.nonZeros());
    // rows ascend, so the mirror images of a column's entries are met in their order
    std::vector<int> next(A.outerIndexPtr(), A.outerIndexPtr() + A.cols());
    for (int j = 0; j < static_cast<int>(A.cols()); ++j)
        for (int k = A.outerIndexPtr()[j]; k < A.outerIndexPtr()[j + 1]; ++k) {
            int& mirrored = next.data()[A.innerIndexPtr()[k]];
            A.valuePtr()[k] = 0.5 * (values.data()[k] + values.data()[mirrored++]);
        }
}

/// True unless a stored value of a compressed matrix is a NaN or an infinity.
[[nodiscard]] inline bool all_finite(const SparseMatrix& matrix) noexcept {
    for (Eigen::Index k = 0; k < matrix.nonZeros(); ++k)
        if (!std::isfinite(matrix.valuePtr()[k])) return false;
    return true;
}

/// Returns scales of the unknowns of a symmetric matrix [A G^T; G 0], of either storage: powers of
/// two that the units of lengths, masses and times multiply, up to one factor for all, by powers of
/// two that are exact.
///
/// That is 2^-floor((e_i - e_0)/2), e the exponent of a_ii; of rows without a diagonal, which are
/// constraints, 2^e_0 over their largest scaled entry.
[[nodiscard]] inline VectorX unit_scales(const SparseMatrix& matrix) {
    const auto size = static_cast<int>(matrix.cols());
    const auto for_each_entry = [&](const auto& visit) {
        for (int j = 0; j < size; ++j)
            for (int k = matrix.outerIndexPtr()[j]; k < matrix.outerIndexPtr()[j + 1]; ++k)
                if (matrix.valuePtr()[k] != 0.0 && std::isfinite(matrix.valuePtr()[k]))
                    visit(matrix.innerIndexPtr()[k], j, std::abs(matrix.valuePtr()[k]));
    };
    const auto power = [](int exponent) {
        return std::ldexp(1.0, std::max(-1000, std::min(1000, exponent)));
    };
    VectorX scales = VectorX::Zero(size);
    int first = 0;
    bool found = false;
    for_each_entry([&](int i, int j, double value) {
        if (i != j) return;
        const int exponent = std::ilogb(value);
        if (!found) first = exponent;
        found = true;
        const int apart = exponent - first;
        scales[i] = power(apart >= 0 ? -(apart / 2) : (1 - apart) / 2);
    });
    VectorX largest = VectorX::Zero(size);
    for_each_entry([&](int i, int j, double value) {
        if (scales[i] == 0.0) largest[i] = std::max(largest[i], value * scales[j]);
        if (scales[j] == 0.0) largest[j] = std::max(largest[j], value * scales[i]);
    });
    for (int i = 0; i < size; ++i)
        if (scales[i] == 0.0)
            scales[i] = largest[i] > 0.0 ? power(first - std::ilogb(largest[i])) : 1.0;
    return scales;
}

/// Returns the lower half of a compressed matrix, with its zeros.
[[nodiscard]] inline SparseMatrix lower_half(const SparseMatrix& A) {
    const auto size = static_cast<int>(A.cols());
    SparseMatrix lower(size, size);
    lower.reserve(A.nonZeros());
    for (int j = 0; j < size; ++j) {
        lower.startVec(j);
        for (int k = A.outerIndexPtr()[j]; k < A.outerIndexPtr()[j + 1]; ++k)
            if (const int i = A.innerIndexPtr()[k]; i >= j)
                lower.insertBack(i, j) = A.valuePtr()[k];
    }
    lower.finalize();
    return lower;
}

}  // namespace ancf::detail
