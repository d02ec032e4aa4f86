// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Estimates of the highest and the lowest natural frequency of K - omega^2 M: enough to choose the
/// order of a method or a first step, not a modal analysis.

#pragma once

#include <ancf/error.hpp>
#include <ancf/types.hpp>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <random>

namespace ancf::detail {

/// Returns a fixed start vector that no symmetry of a scene shares.
[[nodiscard]] inline VectorX scattered(Eigen::Index size, int seed) {
    std::minstd_rand random(static_cast<std::minstd_rand::result_type>(seed) + 1U);
    constexpr double half = 0.5 * static_cast<double>(std::minstd_rand::max());
    random.discard(8);  // small seeds start alike
    VectorX x(size);
    for (double& value : x) value = static_cast<double>(random()) / half - 1.0;
    return x;
}

/// Returns the largest |omega^2| of M^-1 K by power iteration with the Rayleigh quotient.
/// @param stiffness  x -> K x.  @param mass  x -> M x.  @param solve_mass  b -> M^-1 b.
template <class Stiffness, class Mass, class SolveMass>
[[nodiscard]] double largest_eigenvalue(Eigen::Index size, const Stiffness& stiffness,
                                        const Mass& mass, const SolveMass& solve_mass,
                                        int iterations = 60) {
    if (size == 0) return 0.0;
    VectorX x = scattered(size, 0);
    double estimate = 0.0;
    for (int k = 0; k < iterations; ++k) {
        x /= std::sqrt(x.dot(mass(x)));
        const VectorX force = stiffness(x);
        const double quotient = std::abs(x.dot(force));
        const bool settled = k > 5 && std::abs(quotient - estimate) <= 1e-3 * quotient;
        estimate = std::max(quotient, estimate);
        if (settled || quotient == 0.0) break;
        x = solve_mass(force);
    }
    return estimate;
}

/// Returns the lowest eigenvalue above `threshold` of K x = omega^2 M x, 0 where there is none
/// among those that the subspace finds.
/// @param freedom        number of independent motions that the constraints leave.
/// @param shifted_solve  b -> (K + shift M)^-1 b on the constraints, shift > 0.
template <class Stiffness, class Mass, class Solve>
[[nodiscard]] double lowest_eigenvalue(Eigen::Index size, Eigen::Index freedom,
                                       const Stiffness& stiffness, const Mass& mass,
                                       const Solve& shifted_solve, double threshold,
                                       int iterations = 12) {
    const Eigen::Index width = std::min<Eigen::Index>(freedom, 14);
    if (width <= 0) return 0.0;
    MatrixX basis(size, width);
    for (Eigen::Index k = 0; k < width; ++k) basis.col(k) = scattered(size, static_cast<int>(k));
    VectorX values;
    for (int iteration = 0; iteration < iterations; ++iteration) {
        MatrixX mass_basis(size, width), stiff_basis(size, width);
        for (Eigen::Index k = 0; k < width; ++k) {
            basis.col(k) = shifted_solve(mass(VectorX(basis.col(k))));
            // Gram-Schmidt in the mass norm, twice
            for (int pass = 0; pass < 2; ++pass)
                for (Eigen::Index j = 0; j < k; ++j)
                    basis.col(k) -= mass_basis.col(j).dot(basis.col(k)) * basis.col(j);
            VectorX product = mass(VectorX(basis.col(k)));
            const double norm = std::sqrt(basis.col(k).dot(product));
            if (!(norm > 0.0)) return 0.0;
            basis.col(k) /= norm;
            mass_basis.col(k) = product / norm;
            stiff_basis.col(k) = stiffness(VectorX(basis.col(k)));
        }
        MatrixX reduced = basis.transpose() * stiff_basis;
        reduced = 0.5 * (reduced + reduced.transpose().eval());
        const Eigen::SelfAdjointEigenSolver<MatrixX> solver(reduced);
        values = solver.eigenvalues();
        basis *= solver.eigenvectors();
    }
    for (Eigen::Index k = 0; k < values.size(); ++k)
        if (values[k] > threshold) return values[k];
    return 0.0;
}

}  // namespace ancf::detail
