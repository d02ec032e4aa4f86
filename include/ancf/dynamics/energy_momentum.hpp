// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The energy-momentum scheme: energy and momenta kept to round-off, with constraints too.
///
///     (q_1 - q_0)/h = (v_0 + v_1)/2,   M (v_1 - v_0)/h + f + G_d^T lambda = Q,   g(q_1, t_1) = 0
///
/// f and G_d are discrete gradients of the strain energies and of g (discrete_gradient.hpp). Second
/// order, fixed steps, Newton's method to the floor of round-off. For conservative scenes and long
/// times.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/solver/linear_solver.hpp>

namespace ancf {

/// How the energy-momentum method runs.
struct EnergyMomentumOptions {
    double step = 1e-3;         ///< s; taken in shorter parts where Newton's method fails or a
                                ///< joint is driven by more than pi/12 in it
    int max_iterations = 30;    ///< of Newton's method in a step
    bool follow_energy = true;  ///< report the energy drift: one evaluation of the force a step

    /// @throws InvalidArgument naming the first value that cannot be meant.
    void check() const;
};

/// The integrator.
///
/// The multipliers of a state are those of the step that led to it: they belong to its middle.
/// Loads that have no potential, and elements that dissipate, enter at the middle of a step.
class EnergyMomentum : public Integrator<EnergyMomentumOptions> {
public:
    using Integrator::Integrator;

    /// Integrates from the model's state to the schedule's end; the model is then in the state
    /// reached, on the constraints.
    ///
    /// Steps stay on the grid start + k step; only a last, shorter step leaves it.
    ///
    /// What is observed is projected on the constraints, and its energy is that of the projected
    /// state. Where constraints are not linear that differs from the energy that the scheme
    /// conserves by the square of the step; the report's energy_drift is the scheme's own.
    /// @param solver  any linear solver (linear_solver.hpp). One of full storage has the exact
    ///                tangent; one of the lower half converges more slowly, to the same solution.
    /// @param memory  of the run to continue, as its report gave it; empty: a consistent start.
    /// @return as GeneralizedAlpha::integrate.
    /// @throws InvalidArgument as GeneralizedAlpha::integrate.
    [[nodiscard]] DynamicsReport integrate(DynamicProblem& problem, LinearSolver& solver,
                                           const Schedule& schedule,
                                           const Memory& memory = {}) const;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/energy_momentum.ipp>  // IWYU pragma: export
#endif
