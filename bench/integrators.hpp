// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The integrators that the benchmarks compare, each with its one setting.
///
/// One beam without constraints is solved by the solver for chains, every other scene by the one
/// for chains with constraints, in the energy-momentum scheme by a general one. Newton's method
/// goes to 1e-10 of the scene's size, far below any error that is measured.

#pragma once

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/leapfrog.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/model/scene.hpp>
#if ANCF_WITH_SUNDIALS
#include <ancf/sundials/explicit.hpp>
#include <ancf/sundials/ida.hpp>
#endif

#include <solvers.hpp>

#include <functional>
#include <string>
#include <utility>

namespace ancf::bench {

/// One way to integrate a scene from its present state.
struct Integrator {
    using Integrate = std::function<DynamicsReport(Scene&, const Schedule&, double)>;

    std::string name;
    std::string setting;  ///< "tolerance", or "step" in s
    Integrate integrate;  ///< with a value of the setting
};

#if ANCF_WITH_SUNDIALS
/// IDA in one of its forms.
inline Integrator ida(std::string name, sundials::Form form) {
    return {std::move(name), "tolerance",
            [form](Scene& model, const Schedule& schedule, double tolerance) {
                DynamicProblem problem(model);
                sundials::IdaOptions options;
                options.form = form;
                options.tolerance = tolerance;
                options.follow_energy = false;
                return sundials::Ida(options).integrate(problem, schedule);
            }};
}

/// An explicit method by one of its tables; for scenes without multipliers.
/// @param fixed  fixed steps, which fail above the stable one
inline Integrator explicit_method(std::string name, sundials::Table table, bool fixed = false) {
    return {std::move(name), fixed ? "step" : "tolerance",
            [table, fixed](Scene& model, const Schedule& schedule, double setting) {
                DynamicProblem problem(model);
                sundials::ExplicitOptions options;
                options.table = table;
                (fixed ? options.step : options.tolerance) = setting;
                options.follow_energy = false;
                return sundials::Explicit(options).integrate(problem, schedule);
            }};
}
#endif

/// The leapfrog, with fixed steps.
inline Integrator leapfrog(std::string name) {
    return {std::move(name), "step", [](Scene& model, const Schedule& schedule, double step) {
                DynamicProblem problem(model);
                LeapfrogOptions options;
                options.step = step;
                options.follow_energy = false;
                return Leapfrog(options).integrate(problem, schedule);
            }};
}

/// Runs an integrator with the solver that suits the scene.
/// @param general  name of the solver of scenes that are no chain.
template <class Method>
DynamicsReport run_with_solver(Scene& model, const Schedule& schedule, const Method& integrator,
                               const char* general = "bordered-chain") {
    const bool chain = model.constraints().empty() && model.attachments().empty();
    const auto solver = solver_named(chain ? "block-tridiagonal" : general);
    ProblemOptions for_solver;
    for_solver.storage = solver->storage();
    DynamicProblem problem(model, for_solver);
    return integrator.integrate(problem, *solver, schedule);
}

/// Runs generalized-alpha, Newton's method as fine as the comparison needs it.
inline DynamicsReport run_generalized_alpha(Scene& model, const Schedule& schedule,
                                            GeneralizedAlphaOptions options) {
    options.follow_energy = false;
    options.newton_tolerance = 1e-10;
    return run_with_solver(model, schedule, GeneralizedAlpha(options));
}

/// Generalized-alpha of fixed steps.
inline Integrator generalized_alpha(std::string name, double rho) {
    return {std::move(name), "step", [rho](Scene& model, const Schedule& schedule, double step) {
                GeneralizedAlphaOptions options;
                options.rho = rho;
                options.step = step;
                return run_generalized_alpha(model, schedule, options);
            }};
}

/// Generalized-alpha that chooses its steps.
inline Integrator adaptive_generalized_alpha(std::string name) {
    return {std::move(name), "tolerance",
            [](Scene& model, const Schedule& schedule, double tolerance) {
                GeneralizedAlphaOptions options;
                options.tolerance = tolerance;
                options.step = 1e-4;
                return run_generalized_alpha(model, schedule, options);
            }};
}

/// Radau IIA that chooses its steps.
inline Integrator radau(std::string name, int stages) {
    return {std::move(name), "tolerance",
            [stages](Scene& model, const Schedule& schedule, double tolerance) {
                RadauOptions options;
                options.stages = stages;
                options.tolerance = tolerance;
                options.follow_energy = false;
                return run_with_solver(model, schedule, RadauIIA(options));
            }};
}

/// The energy-momentum scheme of fixed steps.
inline Integrator energy_momentum(std::string name) {
    return {std::move(name), "step", [](Scene& model, const Schedule& schedule, double step) {
                EnergyMomentumOptions options;
                options.step = step;
                options.follow_energy = false;
                // its matrix is symmetric for a solver of symmetric ones alone
                return run_with_solver(model, schedule, EnergyMomentum(options), general_solver);
            }};
}

}  // namespace ancf::bench
