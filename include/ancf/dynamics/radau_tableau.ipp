// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of radau_tableau.hpp.

#pragma once

#include <ancf/constants.hpp>
#include <ancf/dynamics/radau_tableau.hpp>

#include <cmath>
#include <cstddef>
#include <utility>

namespace ancf::detail {

/// Returns P_s(x) - P_(s-1)(x) and its derivative, Legendre polynomials.
[[nodiscard]] ANCF_INLINE std::pair<double, double> radau_polynomial(int stages, double x) {
    double before = 1.0, value = x;  // P_0, P_1
    double slope_before = 0.0, slope = 1.0;
    for (int k = 1; k < stages; ++k) {
        const double next = ((2 * k + 1) * x * value - k * before) / (k + 1);
        const double slope_next = slope_before + (2 * k + 1) * value;
        before = std::exchange(value, next);
        slope_before = std::exchange(slope, slope_next);
    }
    return {value - before, slope - slope_before};
}

/// Returns the points of the right Radau rule on [0, 1], ascending.
[[nodiscard]] ANCF_INLINE std::vector<double> radau_nodes(int stages) {
    std::vector<double> nodes;
    for (int k = 0; k + 1 < stages; ++k) {
        double x = -std::cos(pi * (2 * k + 1) / (2 * stages - 1));
        for (int iteration = 0; iteration < 50; ++iteration) {
            const auto [value, slope] = radau_polynomial(stages, x);
            double deflated = slope;  // the zeros that are known, and 1, are taken out
            deflated -= value / (x - 1.0);
            for (const double node : nodes) deflated -= value / (x - (2.0 * node - 1.0));
            const double step = value / deflated;
            x -= step;
            if (std::abs(step) < 1e-15) break;
        }
        nodes.push_back(0.5 * (1.0 + x));
    }
    nodes.push_back(1.0);
    return nodes;
}

/// Returns the zeros of (4) with an imaginary part of at least 0, the real one first.
[[nodiscard]] ANCF_INLINE std::vector<std::complex<double>> radau_eigenvalues(int stages) {
    using Complex = std::complex<double>;
    // of (4), each coefficient over that of the highest power
    std::vector<double> coefficients(static_cast<std::size_t>(stages) + 1, 1.0);
    for (int j = stages - 1; j >= 0; --j)  // ratio of the coefficients of j and j + 1
        coefficients[j] = -coefficients[static_cast<std::size_t>(j) + 1] * (j + 1) *
                          (2 * stages - 1 - j) / (stages - j);
    std::vector<Complex> zeros;
    for (int k = 0; k < stages; ++k) zeros.push_back(2.0 * stages * std::pow(Complex(0.4, 0.9), k));
    for (int iteration = 0; iteration < 500; ++iteration) {  // of Durand and Kerner
        double moved = 0.0;
        for (Complex& zero : zeros) {
            Complex value = 0.0, distances = 1.0;
            for (std::size_t j = coefficients.size(); j-- > 0;)
                value = value * zero + coefficients[j];
            for (const Complex& other : zeros)
                if (&other != &zero) distances *= zero - other;
            const Complex step = value / distances;
            zero -= step;
            moved = std::fmax(moved, std::abs(step) / std::abs(zero));
        }
        if (moved < 1e-15) break;
    }
    std::vector<Complex> kept(1);
    for (const Complex& zero : zeros)
        if (std::abs(zero.imag()) < 1e-6 * std::abs(zero))
            kept[0] = zero.real();
        else if (zero.imag() > 0.0)
            kept.push_back(zero);
    return kept;
}

/// Returns the inverse of a small square matrix by elimination with column pivots.
template <class Scalar>
[[nodiscard]] std::vector<std::vector<Scalar>> small_inverse(
    std::vector<std::vector<Scalar>> matrix) {
    const std::size_t size = matrix.size();
    for (std::size_t i = 0; i < size; ++i) {
        matrix[i].resize(2 * size, Scalar(0.0));
        matrix[i][size + i] = 1.0;
    }
    for (std::size_t k = 0; k < size; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < size; ++i)
            if (std::abs(matrix[i][k]) > std::abs(matrix[pivot][k])) pivot = i;
        std::swap(matrix[k], matrix[pivot]);
        const Scalar inverse = 1.0 / matrix[k][k];
        for (Scalar& entry : matrix[k]) entry *= inverse;
        for (std::size_t i = 0; i < size; ++i) {
            if (i == k) continue;
            const Scalar factor = matrix[i][k];
            for (std::size_t j = k; j < 2 * size; ++j) matrix[i][j] -= factor * matrix[k][j];
        }
    }
    for (auto& row : matrix)
        row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(size));
    return matrix;
}

/// Returns W: differentiation on the points 0 and c_i, by their barycentric weights.
[[nodiscard]] ANCF_INLINE std::vector<std::vector<double>> differentiation(
    const std::vector<double>& nodes) {
    const std::size_t stages = nodes.size();
    std::vector<double> points = {0.0};
    points.insert(points.end(), nodes.begin(), nodes.end());
    std::vector<double> weights(stages + 1, 1.0);
    for (std::size_t i = 0; i <= stages; ++i)
        for (std::size_t j = 0; j <= stages; ++j)
            if (i != j) weights[i] /= points[i] - points[j];
    std::vector<std::vector<double>> W(stages, std::vector<double>(stages, 0.0));
    for (std::size_t i = 0; i < stages; ++i)
        for (std::size_t j = 0; j <= stages; ++j) {
            if (j == i + 1) continue;
            const double entry = weights[j] / weights[i + 1] / (points[i + 1] - points[j]);
            if (j > 0) W[i][j - 1] = entry;
            W[i][i] -= entry;
        }
    return W;
}

/// Returns the columns of T for the eigenvalues, their conjugates included.
[[nodiscard]] ANCF_INLINE std::vector<std::complex<double>> radau_column(
    const std::vector<double>& nodes, const std::complex<double>& eigenvalue) {
    const std::size_t stages = nodes.size();
    std::vector<std::complex<double>> column;
    for (const double x : nodes) {
        // Taylor coefficients of N at x, the product of all (x - c) + d in powers of d
        std::vector<double> taylor = {1.0};
        for (const double node : nodes) {
            taylor.push_back(0.0);
            for (std::size_t k = taylor.size() - 1; k > 0; --k)
                taylor[k] = taylor[k] * (x - node) + taylor[k - 1];
            taylor[0] *= x - node;
        }
        std::complex<double> sum = 0.0, power = 1.0;
        for (std::size_t k = 1; k <= stages; ++k) {
            power *= static_cast<double>(k) / eigenvalue;
            sum += taylor[k] * power;
        }
        column.push_back(sum);
    }
    return column;
}

ANCF_INLINE RadauTableau radau_tableau(int stages) {
    using Complex = std::complex<double>;
    RadauTableau tableau;
    tableau.nodes = radau_nodes(stages);
    const auto size = static_cast<std::size_t>(stages);
    const auto W = differentiation(tableau.nodes);
    const auto A = small_inverse(W);
    const auto squared = [&](const std::vector<std::vector<double>>& a) {
        MatrixX result = MatrixX::Zero(stages, stages);
        for (int i = 0; i < stages; ++i)
            for (int j = 0; j < stages; ++j)
                for (int k = 0; k < stages; ++k) result(i, j) += a[i][k] * a[k][j];
        return result;
    };
    tableau.square = squared(W);
    tableau.double_integral = squared(A);
    tableau.inverse.resize(stages, stages);
    for (int i = 0; i < stages; ++i)
        for (int j = 0; j < stages; ++j) tableau.inverse(i, j) = W[i][j];

    std::vector<std::vector<Complex>> T(size);  // the kept columns, then their conjugates
    for (const Complex& eigenvalue : radau_eigenvalues(stages)) {
        RadauMode mode;
        mode.eigenvalue = eigenvalue;
        mode.column = radau_column(tableau.nodes, eigenvalue);
        const bool real = eigenvalue.imag() == 0.0;
        for (std::size_t i = 0; i < size; ++i) {
            T[i].push_back(mode.column[i]);
            if (!real) T[i].push_back(std::conj(mode.column[i]));
        }
        tableau.modes.push_back(std::move(mode));
    }
    const auto inverse = small_inverse(T);
    std::size_t at = 0;
    for (RadauMode& mode : tableau.modes) {
        mode.row = inverse[at];
        at += mode.eigenvalue.imag() == 0.0 ? 1 : 2;
    }
    return tableau;
}

ANCF_INLINE std::vector<double> lagrange_weights(const std::vector<double>& nodes, double x) {
    std::vector<double> weights(nodes.size(), 1.0);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t j = 0; j < nodes.size(); ++j)
            if (i != j) weights[i] *= (x - nodes[j]) / (nodes[i] - nodes[j]);
    return weights;
}

}  // namespace ancf::detail
