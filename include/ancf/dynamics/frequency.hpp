// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Estimates of the highest and the lowest natural frequency of K - omega^2 M: enough to choose the
/// order of a method or a first step, not a modal analysis.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/types.hpp>

#include <functional>

namespace ancf::detail {

/// x -> A x, or b -> A^-1 b.
using LinearMap = std::function<VectorX(const VectorX&)>;

/// Returns a fixed start vector that no symmetry of a scene shares, each entry up to its scale.
[[nodiscard]] VectorX scattered(const VectorX& scales, int seed);

/// Returns the largest |omega^2| of M^-1 K by power iteration with the Rayleigh quotient.
/// @param x          where to begin, not zero; becomes the mode.
/// @param stiffness  x -> K x.  @param mass  x -> M x.  @param solve_mass  b -> M^-1 b.
[[nodiscard]] double largest_eigenvalue(VectorX& x, const LinearMap& stiffness,
                                        const LinearMap& mass, const LinearMap& solve_mass,
                                        int iterations = 60);

/// Turns the symmetric matrix into the diagonal one of its eigenvalues by cyclic Jacobi rotations.
///
/// For the few rows of a projected problem: Eigen's solver costs far more to compile.
/// @return the rotations, whose columns are the eigenvectors.
[[nodiscard]] MatrixX diagonalize(MatrixX& matrix);

/// Returns the lowest eigenvalue above `threshold` of K x = omega^2 M x, 0 where there is none
/// among those that the subspace finds.
/// @param scales         typical sizes of the coordinates.
/// @param freedom        number of independent motions that the constraints leave.
/// @param shifted_solve  b -> (K + shift M)^-1 b on the constraints, shift > 0.
[[nodiscard]] double lowest_eigenvalue(const VectorX& scales, Eigen::Index freedom,
                                       const LinearMap& stiffness, const LinearMap& mass,
                                       const LinearMap& shifted_solve, double threshold,
                                       int iterations = 12);

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/frequency.ipp>  // IWYU pragma: export
#endif
