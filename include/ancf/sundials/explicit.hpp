// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Explicit time integration of soft scenes without multipliers, by ERKStep of SUNDIALS' ARKODE.
///
/// M is constant and factorised once, so a stage costs one force and one solution with M. The step
/// stays below the stable one, which falls with the highest frequency of the mesh:
/// docs/theory-explicit.md says for which scenes that pays.
///
///     ancf::DynamicProblem problem(model);
///     ancf::sundials::Explicit integrator;
///     const auto report = integrator.integrate(problem, ancf::equal_intervals(0.0, 1.2, 0.05));

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/report.hpp>

#include <string>

namespace ancf::sundials {

/// A pair of explicit Runge-Kutta formulas. Only those whose stability region holds a piece of the
/// imaginary axis are here; the comments have that piece, as frequency times step.
enum class Table {
    bogacki_shampine,  ///< order 3, 3 forces a step, stable to 1.73
    zonneveld,         ///< order 4, 5 forces, 2.82: the classical method with an error estimate
    ark436,            ///< order 4, 6 forces, 4.00: explicit part of ARK4(3)6L[2]SA
    ark437,            ///< order 4, 7 forces, 4.69: explicit part of ARK4(3)7L[2]SA1
    dormand_prince,    ///< order 5, 6 forces, 0.99
    verner,            ///< order 6, 8 forces, 1.30
    fehlberg           ///< order 8, 13 forces, 2.36
};

/// How an explicit method integrates.
struct ExplicitOptions {
    Table table = Table::ark436;  ///< the formulas
    double tolerance = 1e-6;      ///< relative, of q and v alike
    double step = 0.0;            ///< s, of fixed steps, shortened to fill the run evenly; 0: the
                                  ///< tolerance decides

    // Absolute tolerances are `tolerance` times these; 0 takes a scale from the scene.
    double length_scale = 0.0;    ///< m; slopes have the scale 1, r_xx 1/length_scale
    double velocity_scale = 0.0;  ///< m/s; other rates have velocity_scale/length_scale of these

    double first_step = 0.0;     ///< s; 0: a tenth of the stable one
    double max_step = 0.0;       ///< s; 0: no limit but the stable one
    long max_steps = 1'000'000;  ///< 0: no limit
    double stable_share = 0.9;   ///< of the stable step that is used, above 0 and below 1
    int stable_interval = 50;    ///< steps between two estimates of the stable one
    bool follow_energy = true;   ///< report the energy drift: one evaluation of the force a step

    /// @throws InvalidArgument naming the first value that cannot be meant.
    void check() const;
};

/// How an explicit run went.
struct ExplicitReport : DynamicsReport {
    std::string code;  ///< ARKODE's own name of the return code that ended the run; empty if none
    double highest_frequency = 0.0;  ///< rad/s, last estimate
    double stable_step = 0.0;        ///< s, last estimate; infinite where nothing is stiff
    long limited = 0;                ///< how often stability set the step, not the tolerance
};

/// The integrator.
class Explicit : public Integrator<ExplicitOptions> {
public:
    using Integrator::Integrator;

    /// Integrates from the model's state to the schedule's end; the model is then in the state
    /// reached. What the scene's and the schedule's callables throw comes out.
    ///
    /// Between two steps q is the quintic of q, v and v' at both ends, of order 6, and v its
    /// derivative, of order 5. A run carries nothing but its state: another one goes on from there.
    /// @return status converged at the end; max_iterations at once where the stable step needs
    ///         more than max_steps; diverged where a fixed step is above the stable one; or why it
    ///         ended before, with what was observed until then.
    /// @throws InvalidArgument for a scene with multipliers, a schedule that does not fit the
    ///         model's time, a fixed step below the resolution of time, or no unknowns.
    [[nodiscard]] ExplicitReport integrate(DynamicProblem& problem, const Schedule& schedule) const;
};

}  // namespace ancf::sundials

#if !defined(ANCF_COMPILED)
#include <ancf/sundials/explicit.ipp>  // IWYU pragma: export
#endif
