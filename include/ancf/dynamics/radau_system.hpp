// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The linear systems of a step of Radau IIA: one real matrix, and one complex matrix for each pair
/// of stages. Equations (4) to (8) of docs/theory-radau.md.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/solver/complex_solver.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <complex>
#include <cstddef>
#include <memory>
#include <vector>

namespace ancf::detail {

/// The coefficients of a method of s stages, made at set-up.
struct RadauTableau {
    std::vector<double> nodes;  ///< c, ascending, the last one 1
    MatrixX inverse;            ///< W = A^-1, s x s
    MatrixX square;             ///< W^2
    MatrixX double_integral;    ///< A^2
    /// mu: the real eigenvalue of W, then one of each conjugate pair.
    std::vector<std::complex<double>> eigenvalues;
    /// The real part of T^-1, s x s: a row of the real eigenvalue, then of each pair the real and
    /// the imaginary part of one row.
    MatrixX to_modes;
    MatrixX from_modes;  ///< the inverse of to_modes

    [[nodiscard]] int stages() const noexcept { return static_cast<int>(nodes.size()); }
};

/// Returns the method of an odd number of stages from 1 to 9.
[[nodiscard]] RadauTableau radau_tableau(int stages);

/// Returns the values at x of the Lagrange polynomials on the nodes, one of each; the nodes differ.
[[nodiscard]] std::vector<double> lagrange_weights(const std::vector<double>& nodes, double x);

/// A vector of each stage.
using Stages = std::vector<VectorX>;

/// Sums over the stages, three or five: out_i = scale sum_j weights(i, j) in_j, all of one size.
void sum_stages(const MatrixX& weights, double scale, const Stages& in, Stages& out);

/// The matrices [M + (h/mu) D + (h/mu)^2 K, G^T; G, 0] for all mu, and their factors; of n free
/// coordinates and m multipliers.
class RadauSystem {
public:
    /// Analyses the pattern for all solvers.
    ANCF_LAZY RadauSystem(const DynamicProblem& problem, LinearSolver& solver,
                          const RadauTableau& tableau);

    /// Factorises all matrices for a step, with K, G and D of the problem's last evaluation, of
    /// tangent and damping; adds to a count how many.
    [[nodiscard]] Status factorise(double h, long& count);

    /// The step that is factorised, s; 0 where there is none.
    [[nodiscard]] double width() const noexcept { return width_; }

    /// Solves for the corrections of Y and of the multipliers.
    /// @param h       the step of the equations, s; those of another step than width() are solved
    ///                by its matrices.
    /// @param force   of each stage the residual of the equation of motion, n entries, of the units
    ///                of generalised forces.
    /// @param lengths of each stage g, m entries, of the units of the constraints.
    /// @param Y       of each stage (2), n entries, of the units of accelerations.
    /// @param lambda  of each stage the multipliers, m entries.
    void solve(double h, const Stages& force, const Stages& lengths, Stages& Y, Stages& lambda);

    /// Solves [M + tau D + tau^2 K, G^T; G, 0] (e, nu) = ((M + tau D) a + M b, 0), tau = h/mu_0, h
    /// that of width().
    /// @param a, b  n entries each, of the units of coordinates.
    /// @return e, until the next call.
    [[nodiscard]] const VectorX& filter(const VectorX& a, const VectorX& b);

private:
    void solve_pair(std::size_t mode, double h, VectorX& real, VectorX& imaginary,
                    VectorX& real_lengths, VectorX& imaginary_lengths);

    const DynamicProblem& problem_;
    LinearSolver& solver_;
    const RadauTableau& tableau_;
    std::vector<std::unique_ptr<ComplexSolver>> complex_solvers_;  // of modes 1, 2, ...
    SparseMatrix damping_, system_;
    bool damped_ = false;
    std::vector<char> stiff_;  // per value: 1 in the block of coordinates, 0 elsewhere
    std::vector<std::complex<double>> values_;
    double width_ = 0.0;
    VectorX rhs_, solution_, error_;
    Stages modal_, modal_lengths_;  // right-hand sides and solutions by modes, real
    ComplexVectorX complex_;
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/radau_system.ipp>  // IWYU pragma: export
#endif
