// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Explicit time integration of soft scenes: a leapfrog of fourth order. With accelerations
/// a(t, q) a step from q, v at t is
///
///     v += h/2 a*,    q += h v,    a* = a(t + h, q + h^2/12 a(t + h, q)),    v += h/2 a*,
///
/// two forces. The motion itself is q + h^2/12 a and v - h^2/12 da/dt. With multipliers q += h v is
/// the motion on the constraints without forces, and a has no part that they take. The step stays
/// below the stable one, sqrt(12) over the highest frequency of the mesh. The energy does not
/// drift.
/// docs/theory-leapfrog.md derives the method and says for which scenes it pays.
/// Sources: Takahashi and Imada, Journal of the Physical Society of Japan 53, 1984; Lopez-Marcos,
/// Sanz-Serna and Skeel, SIAM Journal on Scientific Computing 18, 1997.
///
///     ancf::DynamicProblem problem(model);
///     ancf::Leapfrog integrator;
///     const auto report = integrator.integrate(problem, ancf::equal_intervals(0.0, 1.2, 0.05));

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/report.hpp>

namespace ancf {

/// How the leapfrog runs.
struct LeapfrogOptions {
    double step = 0.0;           ///< s, shortened to fill the run evenly; 0: the longest below
                                 ///< stable_share, chosen anew as the scene stiffens
    double stable_share = 0.5;   ///< largest step, as a part of the stable one; above 0, below 1
    int stable_interval = 50;    ///< steps between two estimates of the stable one, at most
    long max_steps = 1'000'000;  ///< 0: no limit
    bool follow_energy = true;   ///< report the energy drift: one evaluation of the force a step

    /// @throws InvalidArgument naming the first value that cannot be meant.
    void check() const;
};

/// How a run went; `jacobians` counts estimates of the stable step, `convergence_failures` steps
/// that were taken again, shorter.
struct LeapfrogReport : DynamicsReport {
    double highest_frequency = 0.0;  ///< rad/s, last estimate
    double stable_step = 0.0;        ///< s, last estimate; infinite where nothing vibrates
};

/// The integrator.
class Leapfrog : public Integrator<LeapfrogOptions> {
public:
    using Integrator::Integrator;

    /// Integrates from the model's state to the schedule's end; the model is then in the state
    /// reached.
    ///
    /// Between two steps q is the quintic of q, v and v' at both ends, and v its derivative. A run
    /// carries nothing but its state: another one goes on from there.
    /// @return status converged at the end; max_iterations where it needs more than max_steps;
    ///         diverged where an estimate finds the step above the stable one; or why it ended
    ///         before, with what was observed until then.
    ///
    /// Constraints cost little where they are few: a step solves dense systems, of two equations
    /// for each multiplier.
    /// @throws InvalidArgument for a scene with forces that depend on rates, a schedule that does
    ///         not fit the model's time, a step below the resolution of time, or a scene without a
    ///         free coordinate.
    [[nodiscard]] LeapfrogReport integrate(DynamicProblem& problem, const Schedule& schedule) const;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/leapfrog.ipp>  // IWYU pragma: export
#endif
