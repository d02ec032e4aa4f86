// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/leapfrog.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/output/csv.hpp>
#include <ancf/output/state_file.hpp>

#if ANCF_WITH_SUNDIALS
#include <ancf/sundials/explicit.hpp>
#include <ancf/sundials/ida.hpp>
#endif

#include <support/motion.hpp>
#include <support/progress.hpp>
#include <support/solver.hpp>

#include <memory>
#include <string>
#include <utility>

namespace examples {

namespace {

/// Integrates by IDA or by an explicit method.
[[nodiscard]] Motion integrate_by_sundials(ancf::DynamicProblem& problem,
                                           const MotionOptions& options,
                                           const ancf::Schedule& schedule) {
#if ANCF_WITH_SUNDIALS
    if (options.integrator == "explicit") {
        ancf::sundials::ExplicitOptions method;
        method.tolerance = options.tolerance;
        auto report = ancf::sundials::Explicit(method).integrate(problem, schedule);
        std::string detail = "stable step " + ancf::number_text(report.stable_step, 6) + " s, " +
                             std::to_string(report.evaluations) + " forces, " + report.code;
        return {std::move(report), std::move(detail)};
    }
    ancf::sundials::IdaOptions ida;
    ida.tolerance = options.tolerance;
    if (options.integrator == "ida-ggl") ida.form = ancf::sundials::Form::gear_gupta_leimkuhler;
    auto report = ancf::sundials::Ida(ida).integrate(problem, schedule);
    std::string detail = "order at most " + std::to_string(report.order) + ", " + report.code;
    return {std::move(report), std::move(detail)};
#else
    static_cast<void>(problem);
    static_cast<void>(schedule);
    ancf::detail::reject("--integrator ", options.integrator,
                         " needs SUNDIALS, and this program was built without it");
#endif
}

/// Integrates by the integrator of the options.
[[nodiscard]] Motion integrate_problem(ancf::DynamicProblem& problem, const MotionOptions& options,
                                       const ancf::Schedule& schedule, const ancf::Memory& memory) {
    if (options.by_sundials()) return integrate_by_sundials(problem, options, schedule);
    if (options.integrator == "leapfrog") {
        ancf::LeapfrogOptions method;
        method.step = options.step;
        auto report = ancf::Leapfrog(method).integrate(problem, schedule);
        std::string detail = "stable step " + ancf::number_text(report.stable_step, 6) + " s";
        return {std::move(report), std::move(detail)};
    }
    // the matrix of the energy-momentum scheme is not symmetric
    const bool symmetric = options.integrator != "energy";
    const std::unique_ptr<ancf::LinearSolver> solver =
        symmetric ? motion_solver() : general_solver();
    if (!symmetric) {
        ancf::EnergyMomentumOptions method;
        method.step = options.step;
        return {ancf::EnergyMomentum(method).integrate(problem, *solver, schedule, memory), ""};
    }
    if (options.by_radau()) {
        ancf::RadauOptions method;
        method.stages = options.integrator == "radau9" ? 5 : 3;
        method.tolerance = options.tolerance;
        return {ancf::RadauIIA(method).integrate(problem, *solver, schedule, memory),
                std::to_string(method.stages) + " stages"};
    }
    ancf::GeneralizedAlphaOptions method;
    method.step = options.step;
    method.rho = options.rho;
    return {ancf::GeneralizedAlpha(method).integrate(problem, *solver, schedule, memory),
            "rho " + ancf::number_text(options.rho, 6)};
}

}  // namespace

Motion integrate(ancf::Scene& model, const MotionOptions& options, ancf::Schedule schedule) {
    ancf::Memory memory;
    if (!options.restart.empty()) {
        ancf::SavedState saved = ancf::load_state(options.restart);
        ancf::State& state = model.state();
        ancf::detail::require(
            saved.state.q.size() == state.q.size() && saved.state.v.size() == state.v.size() &&
                saved.state.multipliers.size() == state.multipliers.size(),
            options.restart, ": the scene has ", state.q.size(), " coordinates and ",
            state.multipliers.size(), " multipliers, the file ", saved.state.q.size(), " and ",
            saved.state.multipliers.size());
        state = std::move(saved.state);
        if (!options.by_ida() && !options.is_explicit()) memory = std::move(saved.memory);
    }
    const double start = model.state().time;
    schedule.end += start;
    for (double& time : schedule.times) time += start;
    schedule.pass_degenerate = options.pass_degenerate;
    ProgressBar bar(start);
    schedule.progress = [&](double time, double end) {
        bar.show(time, end);
        return true;
    };
    ancf::DynamicProblem problem(model);
    Motion motion = integrate_problem(problem, options, schedule, memory);
    bar.clear();
    if (!options.save.empty())
        ancf::save_state(options.save, {model.state(), motion.report.memory});
    return motion;
}

}  // namespace examples
