// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Radau IIA of three or five stages for the index-3 system, with fixed or adaptive steps:
///
///     M V'_i + r(t_i, Q_i, V_i, L_i) = 0,   g(Q_i, t_i) = 0,   i = 1 to s,
///     Q_i = q_0 + h sum_j a_ij V_j,   V_i = v_0 + h sum_j a_ij V'_j,   q_1 = Q_s, v_1 = V_s
///
/// Order 2s - 1 in q; with constraints |G v + g_t| is of order s, the multipliers of order s - 1.
/// Source: Hairer and Wanner, Solving Ordinary Differential Equations II, 1996, IV.8 and VII.
/// docs/theory-radau.md derives the reduction to systems of the scene's size.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/solver/linear_solver.hpp>

#include <limits>

namespace ancf {

/// How Radau IIA runs.
struct RadauOptions {
    int stages = 3;  ///< 3, of order 5, or 5, of order 9
    /// 0: fixed steps; else the local error of a step in q: of positions relative to the scene's
    /// size, of slopes absolutely, of r_xx relative to the size's inverse.
    double tolerance = 1e-6;
    double step = 1e-3;       ///< s: the first one, or all
    double min_step = 1e-12;  ///< s, of an adaptive run; at least what time resolves
    /// s, of an adaptive run. Set it below the duration of a pulse that is shorter than `step`, or
    /// the run may pass over the pulse: docs/limits.md, "Motion".
    double max_step = std::numeric_limits<double>::infinity();
    /// Of the coordinates of a stage, relative like tolerance; 0: 0.06 of the tolerance, with five
    /// stages 0.0125, of fixed steps 1e-13. At most 0.06 of the last step's error, or 3e-4, with
    /// five stages 3e-5, of what accelerations move in a step, whichever is larger. Where matrices
    /// turn with a stiff body the energy of the error is bounded too: docs/theory-radau.md.
    double newton_tolerance = 0.0;
    int max_iterations = 10;    ///< of Newton's method in a step
    bool follow_energy = true;  ///< report the energy drift: one evaluation of the force a step

    /// @throws InvalidArgument naming the first value that cannot be meant.
    void check() const;
};

/// The integrator.
class RadauIIA : public Integrator<RadauOptions> {
public:
    using Integrator::Integrator;

    /// Integrates from the model's state to the schedule's end; the model is then in the state
    /// reached, on the constraints.
    ///
    /// Between steps q is the polynomial of q, v and v' at both ends of the step, of five stages
    /// also half a step after its start, and v its derivative. Fixed steps stay on the grid start +
    /// k step; only a last, shorter step leaves it. Where Newton's method fails, or a driven joint
    /// turns by more than pi/3, a step is taken in halves, quarters and so on. Counts of
    /// factorisations are of real and complex matrices.
    /// @param solver  any linear solver (linear_solver.hpp), of full storage with constraints;
    ///                complex matrices go to its LinearSolver::complex_solver.
    /// @param memory  of the run to continue, as its report gave it; empty: a consistent start.
    /// @return as GeneralizedAlpha::integrate.
    /// @throws InvalidArgument as GeneralizedAlpha::integrate.
    ANCF_LAZY [[nodiscard]] DynamicsReport integrate(DynamicProblem& problem, LinearSolver& solver,
                                                     const Schedule& schedule,
                                                     const Memory& memory = {}) const;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/radau.ipp>  // IWYU pragma: export
#endif
