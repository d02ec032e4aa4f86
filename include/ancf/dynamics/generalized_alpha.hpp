// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The generalized-alpha method for the index-3 system, with fixed or adaptive steps.
///
///     M v'_1 + r(t_1, q_1, v_1, lambda_1) = 0,   g(q_1, t_1) = 0,
///     (1 - am) a_1 + am a_0 = (1 - af) v'_1 + af v'_0,
///     q_1 = q_0 + h v_0 + h^2 ((1/2 - beta) a_0 + beta a_1),
///     v_1 = v_0 + h ((1 - gamma) a_0 + gamma a_1)
///
/// Source: Arnold and Bruels, Multibody System Dynamics 18 (2007) 185-202. Second order; rho is the
/// spectral radius at infinite frequency: 1 keeps all oscillations, 0 damps the fastest in one
/// step.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/solver/linear_solver.hpp>

#include <limits>

namespace ancf {

/// How the generalized-alpha method runs.
struct GeneralizedAlphaOptions {
    double rho = 0.8;    ///< spectral radius at infinity, 0 to 1; 1 damps no multipliers
    double step = 1e-3;  ///< s: the step, or the first one of an adaptive run
    /// 0: fixed steps; else the local error of a step in q: of positions relative to the scene's
    /// size, of slopes absolutely, of r_xx relative to the size's inverse.
    double tolerance = 0.0;
    double min_step = 1e-12;  ///< s, of an adaptive run; at least what time resolves
    /// s, of an adaptive run. Set it below the duration of a pulse that is shorter than `step`, or
    /// the run may pass over the pulse: docs/limits.md, "Motion".
    double max_step = std::numeric_limits<double>::infinity();
    double newton_tolerance = 1e-13;  ///< of the coordinates of a step, relative like tolerance
    int max_iterations = 12;          ///< of Newton's method in a step
    /// Report the energy drift, and end as diverged where steps gain energy: one evaluation of the
    /// force a step.
    bool follow_energy = true;

    /// @throws InvalidArgument naming the first value that cannot be meant.
    void check() const;
};

/// The integrator.
class GeneralizedAlpha : public Integrator<GeneralizedAlphaOptions> {
public:
    using Integrator::Integrator;

    /// Integrates from the model's state to the schedule's end; the model is then in the state
    /// reached, on the constraints.
    ///
    /// Fixed steps stay on the grid start + k step; only a last, shorter step leaves it. Where
    /// Newton's method fails, or a driven joint turns by more than pi/3, a step is taken in halves,
    /// quarters and so on.
    /// @param solver  any linear solver (linear_solver.hpp), of full storage with constraints.
    /// @param memory  of the run to continue, as its report gave it; empty: a consistent start.
    /// @return status converged at the end; inconsistent or redundant, with the constraint named,
    ///         where it did not start; or why it ended before, with what was observed until then.
    /// @throws InvalidArgument for a schedule that does not fit the model's time, a step below the
    ///         resolution of time, a memory of another integrator, state or scene, a solver whose
    ///         storage is not the problem's, or a scene without a free coordinate.
    [[nodiscard]] DynamicsReport integrate(DynamicProblem& problem, LinearSolver& solver,
                                           const Schedule& schedule, const Memory& memory) const;
    /// Integrates likewise from a consistent start. A program that calls this one alone does not
    /// compile what reads a memory.
    [[nodiscard]] DynamicsReport integrate(DynamicProblem&, LinearSolver&, const Schedule&) const;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/generalized_alpha.ipp>  // IWYU pragma: export
#endif
