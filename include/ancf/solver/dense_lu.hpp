// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// L U of small dense matrices, and products of complex numbers without a look for infinities.

#pragma once

#include <ancf/list.hpp>

#include <Eigen/Core>

#include <cmath>
#include <complex>
#include <utility>

namespace ancf::detail {

/// Returns how large a number is; of a complex one |re| + |im|, which takes no root.
inline double magnitude(double x) noexcept { return std::abs(x); }
inline double magnitude(const std::complex<double>& x) noexcept {
    return std::abs(x.real()) + std::abs(x.imag());
}

/// Returns a b; of complex numbers by their parts, which does not look for infinities.
inline double product(double a, double b) noexcept { return a * b; }
inline std::complex<double> product(const std::complex<double>& a,
                                    const std::complex<double>& b) noexcept {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// L U of a small matrix of doubles or complex numbers, with rows exchanged.
template <class Scalar>
struct DenseLu {
    using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

    Matrix factors;   ///< the matrix, then L and U
    List<int> order;  ///< the row that each row was exchanged with

    /// Factorises in place. @return false where a pivot is zero or no number.
    [[nodiscard]] bool factorize() {
        const auto rows = static_cast<int>(factors.rows());
        order.clear();
        for (int j = 0; j < rows; ++j) {
            int pivot = j;
            for (int i = j + 1; i < rows; ++i)
                if (magnitude(factors(i, j)) > magnitude(factors(pivot, j))) pivot = i;
            order.push_back(pivot);
            for (int k = 0; pivot != j && k < rows; ++k)
                std::swap(factors(j, k), factors(pivot, k));
            const double size = magnitude(factors(j, j));
            if (size == 0.0 || !std::isfinite(size)) return false;
            for (int i = j + 1; i < rows; ++i) factors(i, j) /= factors(j, j);
            for (int k = j + 1; k < rows; ++k) {
                const Scalar above = factors(j, k);
                for (int i = j + 1; i < rows; ++i) factors(i, k) -= product(factors(i, j), above);
            }
        }
        return true;
    }

    /// Solves in place.
    void solve(Scalar* x) const {
        const auto rows = static_cast<int>(factors.rows());
        for (int j = 0; j < rows; ++j) std::swap(x[j], x[order[j]]);
        for (int j = 0; j < rows; ++j)
            for (int i = j + 1; i < rows; ++i) x[i] -= product(factors(i, j), x[j]);
        for (int j = rows - 1; j >= 0; --j) {
            x[j] /= factors(j, j);
            for (int i = 0; i < j; ++i) x[i] -= product(factors(i, j), x[j]);
        }
    }

    /// Returns the inverse of the matrix that was factorised.
    [[nodiscard]] Matrix inverse() const {
        const Eigen::Index rows = factors.rows();
        Matrix result(rows, rows);
        for (Eigen::Index j = 0; j < rows; ++j) {
            for (Eigen::Index i = 0; i < rows; ++i) result(i, j) = i == j ? 1.0 : 0.0;
            solve(&result(0, j));
        }
        return result;
    }
};

}  // namespace ancf::detail
