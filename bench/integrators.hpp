// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The integrators that the benchmarks compare, each with its one setting.
///
/// A chain without constraints is solved by the solver for chains, everything else by a general
/// one. Newton's method goes to 1e-10 of the scene's size, far below any error that is measured.

#pragma once

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#if ANCF_WITH_SUITESPARSE
#include <ancf/suitesparse/klu.hpp>
#else
#include <ancf/solver/eigen_lu.hpp>
#endif
#if ANCF_WITH_SUNDIALS
#include <ancf/sundials/ida.hpp>
#endif

#include <functional>
#include <string>
#include <utility>

namespace ancf::bench {

#if ANCF_WITH_SUITESPARSE
using GeneralSolver = suitesparse::Klu;
#else
using GeneralSolver = EigenLu;
#endif

/// One way to integrate a scene from its present state.
template <class Scene>
struct Integrator {
    using Integrate = std::function<DynamicsReport(Scene&, const Schedule&, double)>;

    std::string name;
    std::string setting;  ///< "tolerance", or "step" in s
    Integrate integrate;  ///< with a value of the setting
};

#if ANCF_WITH_SUNDIALS
/// IDA in one of its forms.
template <class Scene>
Integrator<Scene> ida(std::string name, sundials::Form form) {
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
#endif

/// Runs generalized-alpha with the solver that suits the scene.
template <class Scene>
DynamicsReport run_generalized_alpha(Scene& model, const Schedule& schedule,
                                     GeneralizedAlphaOptions options) {
    options.follow_energy = false;
    options.newton_tolerance = 1e-10;
    const GeneralizedAlpha integrator(options);
    ProblemOptions with_lower_storage;
    with_lower_storage.storage = Storage::lower;
    if (model.constraints().empty()) {
        DynamicProblem problem(model, with_lower_storage);
        BlockTridiagonal solver;
        return integrator.integrate(problem, solver, schedule);
    }
    DynamicProblem problem(model);
    GeneralSolver solver;
    return integrator.integrate(problem, solver, schedule);
}

/// Generalized-alpha of fixed steps.
template <class Scene>
Integrator<Scene> generalized_alpha(std::string name, double rho) {
    return {std::move(name), "step", [rho](Scene& model, const Schedule& schedule, double step) {
                GeneralizedAlphaOptions options;
                options.rho = rho;
                options.step = step;
                return run_generalized_alpha(model, schedule, options);
            }};
}

/// Generalized-alpha that chooses its steps.
template <class Scene>
Integrator<Scene> adaptive_generalized_alpha(std::string name) {
    return {std::move(name), "tolerance",
            [](Scene& model, const Schedule& schedule, double tolerance) {
                GeneralizedAlphaOptions options;
                options.tolerance = tolerance;
                options.step = 1e-4;
                return run_generalized_alpha(model, schedule, options);
            }};
}

/// Radau IIA that chooses its steps.
template <class Scene>
Integrator<Scene> radau(std::string name, int stages) {
    return {std::move(name), "tolerance",
            [stages](Scene& model, const Schedule& schedule, double tolerance) {
                RadauOptions options;
                options.stages = stages;
                options.tolerance = tolerance;
                options.follow_energy = false;
                const RadauIIA integrator(options);
                ProblemOptions with_lower_storage;
                with_lower_storage.storage = Storage::lower;
                if (model.constraints().empty()) {
                    DynamicProblem problem(model, with_lower_storage);
                    BlockTridiagonal solver;
                    return integrator.integrate(problem, solver, schedule);
                }
                DynamicProblem problem(model);
                GeneralSolver solver;
                return integrator.integrate(problem, solver, schedule);
            }};
}

/// The energy-momentum scheme of fixed steps.
template <class Scene>
Integrator<Scene> energy_momentum(std::string name) {
    return {std::move(name), "step", [](Scene& model, const Schedule& schedule, double step) {
                DynamicProblem problem(model);
                EnergyMomentumOptions options;
                options.step = step;
                options.follow_energy = false;
                GeneralSolver solver;
                return EnergyMomentum(options).integrate(problem, solver, schedule);
            }};
}

}  // namespace ancf::bench
