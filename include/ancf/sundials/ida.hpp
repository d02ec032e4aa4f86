// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Time integration of scenes with constraints by IDA of SUNDIALS: variable order, variable step.
///
/// The maintainers of IDA state systems of index 1 as its scope. docs/theory-ida.md says how the
/// forms of index 3 and index 2 are made to work here, and what was verified.
///
///     ancf::DynamicProblem problem(model);
///     ancf::sundials::Ida ida;
///     const auto report = ida.integrate(problem, ancf::equal_intervals(0.0, 1.2, 0.05));

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/report.hpp>

#include <string>

namespace ancf::sundials {

/// How the equations of motion are handed to IDA.
enum class Form {
    index3,                ///< q' = v and g = 0 as they stand
    gear_gupta_leimkuhler  ///< index 2: M (q' - v) + G^T mu = 0 and G v + g_t = 0 added
};

/// The highest order that IDA may use. Orders 3 and 4 are never a good limit: 3 to 5 amplify
/// undamped vibrations, and 5 is at least the most accurate of them.
enum class Order {
    automatic,  ///< two for stiff scenes, for frames of stiff joints, and from rest for runs that
                ///< are long beside the vibrations; else five
    two,
    five
};

/// How IDA integrates.
struct IdaOptions {
    Form form = Form::index3;  ///< how the constraints enter

    /// Relative tolerance. Index 3 leaves rates out of the error test, so it is about a hundred
    /// times looser than the same figure in gear_gupta_leimkuhler. Above 1e-4 it counts as 1e-4
    /// where the order is two: a looser one would strain stiff bodies.
    double tolerance = 1e-8;

    // Absolute tolerances are `tolerance` times these; 0 takes a scale from the scene.
    double length_scale = 0.0;    ///< m; slopes have the scale 1, r_xx 1/length_scale
    double velocity_scale = 0.0;  ///< m/s; other rates have velocity_scale/length_scale of these
    double force_scale = 0.0;     ///< N: multipliers; of equations in other units than m over what
                                  ///< a displacement by one makes of them

    Order order = Order::automatic;  ///< largest order of the method
    double first_step = 0.0;         ///< s; 0: from the initial accelerations
    double max_step = 0.0;           ///< s; 0: no limit
    long max_steps = 0;              ///< 0: no limit
    bool follow_energy = true;  ///< report the energy drift: one evaluation of the force a step

    /// @throws InvalidArgument naming the first value that cannot be meant.
    void check() const;
};

/// How a run of IDA went.
struct IdaReport : DynamicsReport {
    std::string
        code;  ///< IDA's own name of the return code that ended the run; empty if IDA never ran
    int order = 0;                   ///< the limit that was used, 2 or 5
    double highest_frequency = 0.0;  ///< rad/s, where order was automatic
};

/// The integrator.
class Ida : public Integrator<IdaOptions> {
public:
    using Integrator::Integrator;

    /// Integrates from the model's state to the schedule's end; the model is then in the state
    /// reached, on the constraints. What the scene's and the schedule's callables throw comes out.
    ///
    /// Reported states are projected on the constraints; the integration never sees that.
    /// @return status converged at the end; inconsistent or redundant, with the constraint named,
    ///         where it did not start; or why it ended before, with what was observed until then.
    /// @throws InvalidArgument for a schedule that does not fit the model's time, or no unknowns.
    [[nodiscard]] IdaReport integrate(DynamicProblem& problem, const Schedule& schedule) const;
};

}  // namespace ancf::sundials

#if !defined(ANCF_COMPILED)
#include <ancf/sundials/ida.ipp>  // IWYU pragma: export
#endif
