// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Derivatives by the complex step: f'(x) = Im f(x + i h)/h, exact to round-off for analytic f.

#pragma once

#include <ancf/types.hpp>

#include <complex>

namespace ancf::test {

/// Small enough that h^2 vanishes beside 1, large enough that h times any value stays normal.
inline constexpr double complex_step = 1e-40;

/// Returns df/dx of a scalar function.
/// @param f  takes Vector<complex, N>, returns complex
template <class Function, int N>
[[nodiscard]] Vector<double, N> complex_step_gradient(const Function& f,
                                                      const Vector<double, N>& x) {
    Vector<std::complex<double>, N> z = x.template cast<std::complex<double>>();
    Vector<double, N> gradient(x.size());
    for (int j = 0; j < x.size(); ++j) {
        z(j) = {x(j), complex_step};
        gradient(j) = std::complex<double>(f(z)).imag() / complex_step;
        z(j) = x(j);
    }
    return gradient;
}

/// Returns the Jacobian df_i/dx_j of a vector function.
/// @param f  takes Vector<complex, N>, returns Vector<complex, M>
template <class Function, int N>
[[nodiscard]] auto complex_step_jacobian(const Function& f, const Vector<double, N>& x) {
    using Value = decltype(f(Vector<std::complex<double>, N>()));
    constexpr int rows = Value::RowsAtCompileTime;
    Vector<std::complex<double>, N> z = x.template cast<std::complex<double>>();
    Matrix<double, rows, N> jacobian;
    for (int j = 0; j < x.size(); ++j) {
        z(j) = {x(j), complex_step};
        const Value value = f(z);
        if (j == 0) jacobian.resize(value.size(), x.size());
        jacobian.col(j) = value.imag() / complex_step;
        z(j) = x(j);
    }
    return jacobian;
}

/// Returns |value - expected|/|expected| in the Frobenius norm.
template <class Value, class Expected>
[[nodiscard]] double relative_error(const Eigen::MatrixBase<Value>& value,
                                    const Eigen::MatrixBase<Expected>& expected) {
    return (value - expected).norm() / expected.norm();
}

}  // namespace ancf::test
