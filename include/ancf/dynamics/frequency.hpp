// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Estimates of the highest and the lowest natural frequency of K - omega^2 M: enough to choose the
/// order of a method or a first step, not a modal analysis.

#pragma once

#include <ancf/list.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>

namespace ancf::detail {

/// x -> A x, or b -> A^-1 b.
using LinearMap = std::function<VectorX(const VectorX&)>;

/// Returns a fixed start vector that no symmetry of a scene shares, each entry up to its scale.
[[nodiscard]] inline VectorX scattered(const VectorX& scales, int seed) {
    // the congruence of Park, Miller and Stockmeyer (Communications of the ACM 36, 1993)
    constexpr std::uint64_t modulus = 2147483647;
    std::uint64_t random = static_cast<std::uint64_t>(seed) + 1;
    const auto next = [&random] { return random = 48271 * random % modulus; };
    for (int k = 0; k < 8; ++k) next();  // small seeds start alike
    VectorX x = scales;
    for (double& value : x) value *= 2.0 * static_cast<double>(next()) / (modulus - 1) - 1.0;
    return x;
}

/// Turns the symmetric matrix into the diagonal one of its eigenvalues by cyclic Jacobi rotations.
///
/// For the few rows of a projected problem: Eigen's solver costs far more to compile.
/// @return the rotations, whose columns are the eigenvectors.
[[nodiscard]] inline MatrixX diagonalize(MatrixX& matrix) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const Eigen::Index size = matrix.rows();
    MatrixX vectors = MatrixX::Zero(size, size);
    for (Eigen::Index k = 0; k < size; ++k) vectors(k, k) = 1.0;
    const auto rotate = [](double& a, double& b, double c, double s) {
        const double kept = a;
        a = c * kept - s * b;
        b = s * kept + c * b;
    };
    for (int sweep = 0; sweep < 30; ++sweep) {
        bool diagonal = true;
        for (Eigen::Index p = 0; p < size; ++p)
            for (Eigen::Index q = p + 1; q < size; ++q) {
                const double off = matrix(p, q);
                if (std::abs(off) <= epsilon * std::sqrt(std::abs(matrix(p, p) * matrix(q, q))))
                    continue;
                diagonal = false;
                const double half = (matrix(q, q) - matrix(p, p)) / (2.0 * off);
                const double root = std::sqrt(1.0 + half * half);
                const double tangent = half < 0.0 ? 1.0 / (half - root) : 1.0 / (half + root);
                const double c = 1.0 / std::sqrt(1.0 + tangent * tangent);
                const double s = tangent * c;
                for (Eigen::Index k = 0; k < size; ++k) {
                    rotate(matrix(k, p), matrix(k, q), c, s);
                    rotate(vectors(k, p), vectors(k, q), c, s);
                }
                for (Eigen::Index k = 0; k < size; ++k) rotate(matrix(p, k), matrix(q, k), c, s);
                matrix(p, q) = matrix(q, p) = 0.0;
            }
        if (diagonal) break;
    }
    return vectors;
}

/// Returns the lowest eigenvalue above `threshold` of K x = omega^2 M x, 0 where there is none
/// among those that the subspace finds.
/// @param scales         typical sizes of the coordinates.
/// @param freedom        number of independent motions that the constraints leave.
/// @param shifted_solve  b -> (K + shift M)^-1 b on the constraints, shift > 0.
[[nodiscard]] inline double lowest_eigenvalue(const VectorX& scales, Eigen::Index freedom,
                                              const LinearMap& stiffness, const LinearMap& mass,
                                              const LinearMap& shifted_solve, double threshold) {
    const auto width = static_cast<std::size_t>(std::min<Eigen::Index>(freedom, 14));
    if (freedom <= 0) return 0.0;
    List<VectorX> basis(width), mass_basis(width), stiff_basis(width), turned(width);
    for (std::size_t k = 0; k < width; ++k) basis[k] = scattered(scales, static_cast<int>(k));
    MatrixX reduced(static_cast<Eigen::Index>(width), static_cast<Eigen::Index>(width));
    for (int iteration = 0; iteration < 12; ++iteration) {
        for (std::size_t k = 0; k < width; ++k) {
            basis[k] = shifted_solve(mass(basis[k]));
            // Gram-Schmidt in the mass norm, twice
            for (int pass = 0; pass < 2; ++pass)
                for (std::size_t j = 0; j < k; ++j)
                    basis[k] -= mass_basis[j].dot(basis[k]) * basis[j];
            mass_basis[k] = mass(basis[k]);
            const double norm = std::sqrt(basis[k].dot(mass_basis[k]));
            if (!(norm > 0.0)) return 0.0;
            basis[k] /= norm;
            mass_basis[k] /= norm;
            stiff_basis[k] = stiffness(basis[k]);
        }
        for (std::size_t i = 0; i < width; ++i)
            for (std::size_t j = 0; j <= i; ++j)
                reduced.data()[i * width + j] = reduced.data()[j * width + i] =
                    0.5 * (basis[i].dot(stiff_basis[j]) + basis[j].dot(stiff_basis[i]));
        const MatrixX vectors = diagonalize(reduced);
        for (std::size_t k = 0; k < width; ++k) {
            turned[k].setZero(scales.size());
            for (std::size_t j = 0; j < width; ++j)
                turned[k] += vectors.data()[k * width + j] * basis[j];
        }
        basis.swap(turned);
    }
    double lowest = std::numeric_limits<double>::infinity();
    for (Eigen::Index k = 0; k < reduced.rows(); ++k)
        if (reduced(k, k) > threshold) lowest = std::min(lowest, reduced(k, k));
    return std::isfinite(lowest) ? lowest : 0.0;
}

}  // namespace ancf::detail
