// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Static equilibrium by Newton's method in load steps.
///
/// At each load factor the residual R(q, lambda) of the assembly is brought to zero. The stopping
/// test is described in docs/theory-statics.md: the residual against loads and reactions, the
/// correction against the scene's size, with the round-off of the residual as a floor.

#pragma once

#include <ancf/assembly/assembly.hpp>
#include <ancf/assembly/resultant.hpp>
#include <ancf/error.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/convergence.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace ancf {

/// How a static problem is solved.
struct StaticsOptions {
    int steps = 1;                       ///< equal load steps
    int max_iterations = 100;            ///< linear solves per step
    double residual_tolerance = 1e-9;    ///< relative to loads and reactions
    double correction_tolerance = 1e-6;  ///< relative to the scene's size; slopes absolutely
    bool line_search = false;            ///< halve corrections that enlarge the residual
    bool adaptive = false;               ///< halve a step that fails, widen one that does well
    double min_step = 1e-4;              ///< smallest load step of an adaptive run
    double first_factor = 0.0;           ///< load factor of the state that the model is in
    double last_factor = 1.0;            ///< load factor to reach

    /// Called after every converged step; returning false stops there.
    std::function<bool(double factor, const State& state)> progress;

    /// @throws InvalidArgument naming the first value that cannot be meant.
    void check() const;
};

/// One load step.
struct LoadStep {
    double factor = 0.0;  ///< load factor at its end
    int iterations = 0;   ///< linear solves
    Status status = Status::converged;
    bool at_round_off = false;        ///< converged by the floor of the residual's round-off
    std::vector<double> residuals;    ///< relative residual before each solve, and the last
    std::vector<double> corrections;  ///< relative size of each correction
};

/// What a static solution reports.
struct StaticsReport {
    Status status = Status::converged;
    double factor = 0.0;          ///< load factor reached
    std::vector<LoadStep> steps;  ///< every step tried, in order
    std::optional<Fault> fault;   ///< the element that failed, for degenerate and not_finite
    FactorReport factorisation;   ///< of the last tangent: conditioning, negative pivots
    VectorX reactions;            ///< generalised forces of the supports, zero elsewhere; N and N m
    Resultant imbalance;          ///< loads plus reactions: zero at equilibrium
    double strain_energy = 0.0;   ///< J

    /// Returns the number of linear solves over all steps.
    [[nodiscard]] int iterations() const {
        int sum = 0;
        for (const LoadStep& step : steps) sum += step.iterations;
        return sum;
    }
};

/// Brings a model to static equilibrium under its loads.
///
/// The model's state is the first guess and receives the solution; where the run fails it keeps
/// the last converged load step. Loads without an amplitude grow with the load factor.
/// @param solver  any linear solver (linear_solver.hpp).
/// @throws InvalidArgument for options that cannot be meant, or a scene that the solver's storage
///         does not suit.
template <class Scene, class LinearSolver>
[[nodiscard]] StaticsReport solve_statics(Scene& model, LinearSolver& solver,
                                          const StaticsOptions& options = {});

namespace detail {

/// Newton's method on one scene; keeps the assembly and the factorisation between steps.
template <class Scene, class LinearSolver>
class StaticsRun {
public:
    StaticsRun(Scene& model, LinearSolver& solver, const StaticsOptions& options)
        : model_(model),
          solver_(solver),
          options_(options),
          assembly_(model, LinearSolver::storage),
          monitor_(model, assembly_.numbering()) {
        solver_.analyze(assembly_.tangent());
    }

    [[nodiscard]] StaticsReport run() {
        const double whole = options_.last_factor - options_.first_factor;
        const double equal = whole / options_.steps;
        double step = equal;
        double done = options_.first_factor;
        report_.factor = done;
        for (int k = 1; std::abs(options_.last_factor - done) > 1e-12 * std::abs(whole); ++k) {
            double next = options_.adaptive ? done + step
                                            : options_.first_factor + whole * k / options_.steps;
            if (std::abs(next - options_.first_factor) > std::abs(whole) * (1.0 - 1e-12))
                next = options_.last_factor;
            const LoadStep& result = advance(next);
            report_.status = result.status;
            if (result.status == Status::converged) {
                done = report_.factor = next;
                if (options_.progress && !options_.progress(done, model_.state())) break;
                if (result.iterations <= 6)
                    step = std::min(2.0 * std::abs(step), std::abs(equal)) *
                           (whole < 0.0 ? -1.0 : 1.0);
            } else {
                step *= 0.5;
                if (!options_.adaptive || std::abs(step) < options_.min_step * std::abs(whole))
                    break;
            }
        }
        finish();
        return std::move(report_);
    }

private:
    /// Solves at a load factor from the model's state; keeps the state where that fails.
    const LoadStep& advance(double factor) {
        const State before = model_.state();
        report_.fault.reset();
        LoadStep& step = report_.steps.emplace_back();
        step.factor = factor;
        instant_ = {factor, factor};
        step.status = iterate(step);
        if (step.status != Status::converged) model_.state() = before;
        return step;
    }

    Status iterate(LoadStep& step) {
        State& state = model_.state();
        state.time = instant_.time;
        VectorX increment = -state.q;
        VectorX driven = state.q;
        assembly_.apply_supports(instant_, driven);
        increment += driven;
        const bool moved = (increment.array() != 0.0).any();

        if (!evaluate(state, moved ? &increment : nullptr)) return report_.fault->status;
        state.q = driven;
        double correction = std::numeric_limits<double>::infinity();
        while (true) {
            const double residual = monitor_.residual(assembly_);
            step.residuals.push_back(residual);
            if (!std::isfinite(residual)) return Status::not_finite;
            if (residual <= options_.residual_tolerance &&
                correction <= options_.correction_tolerance)
                return accept(state);
            // a scene already at rest needs no correction to know it
            if ((step.iterations == 0 && !moved) || stagnates(step)) {
                step.at_round_off = monitor_.at_round_off(assembly_, state.q);
                if (step.at_round_off) return accept(state);
            }
            if (step.iterations >= options_.max_iterations) return Status::max_iterations;

            report_.factorisation = solver_.factorize(assembly_.tangent());
            if (report_.factorisation.status != Status::converged)
                return report_.factorisation.status;
            assembly_.residual(residual_);
            solver_.solve(residual_, correction_);
            correction_ = -correction_;
            ++step.iterations;
            if (!correction_.allFinite()) return Status::not_finite;
            if (!move(state, residual)) return report_.fault->status;
            correction = monitor_.correction(correction_);
            step.corrections.push_back(correction);
        }
    }

    /// Applies the correction, shortened on request, and evaluates there.
    bool move(State& state, double before) {
        const State start = state;
        double length = 1.0;
        for (int halving = 0;; ++halving) {
            state = start;
            assembly_.numbering().add_free(correction_, length, state.q);
            state.multipliers += length * correction_.tail(assembly_.numbering().multipliers());
            const bool evaluated = evaluate(state, nullptr);
            if (!options_.line_search || halving == 8) return evaluated;
            if (evaluated && monitor_.residual(assembly_) < 2.0 * before) return true;
            length *= 0.5;
        }
    }

    bool evaluate(const State& state, const VectorX* increment) {
        const VectorX rest = VectorX::Zero(state.q.size());
        report_.fault = assembly_.evaluate({state.q, rest, state.multipliers, instant_},
                                           Request::tangent, increment);
        return !report_.fault.has_value();
    }

    /// A root of the equations counts only where every element is in order.
    Status accept(const State& state) {
        report_.fault = assembly_.inspect(state.q);
        return report_.fault ? report_.fault->status : Status::converged;
    }

    static bool stagnates(const LoadStep& step) {
        const std::size_t count = step.residuals.size();
        return count >= 3 && step.corrections.back() < 1e-3 &&
               step.residuals[count - 1] > 0.25 * step.residuals[count - 2];
    }

    void finish() {
        const State& state = model_.state();
        const auto& numbering = assembly_.numbering();
        instant_ = {report_.factor, report_.factor};
        report_.reactions.setZero(numbering.coordinates());
        const auto fault = report_.fault;
        if (!evaluate(state, nullptr)) return;
        report_.fault = fault;
        report_.strain_energy = assembly_.strain_energy();
        for (const int k : numbering.held())
            report_.reactions[k] = assembly_.internal_force()[k] + assembly_.constraint_force()[k] -
                                   assembly_.external_force()[k];
        report_.imbalance = resultant(
            model_, state.q,
            assembly_.external_force() - assembly_.constraint_force() + report_.reactions);
    }

    Scene& model_;
    LinearSolver& solver_;
    const StaticsOptions& options_;
    Assembly<Scene> assembly_;
    ConvergenceMonitor monitor_;
    Instant instant_;
    StaticsReport report_;
    VectorX residual_, correction_;
};

}  // namespace detail

inline void StaticsOptions::check() const {
    detail::require(steps >= 1, "StaticsOptions: steps must be at least 1, got ", steps);
    detail::require(max_iterations >= 1, "StaticsOptions: max_iterations must be at least 1, got ",
                    max_iterations);
    detail::require_positive("StaticsOptions: residual_tolerance", residual_tolerance);
    detail::require_positive("StaticsOptions: correction_tolerance", correction_tolerance);
    detail::require_positive("StaticsOptions: min_step", min_step);
    detail::require_finite("StaticsOptions: first_factor", first_factor);
    detail::require_finite("StaticsOptions: last_factor", last_factor);
    detail::require(first_factor != last_factor,
                    "StaticsOptions: first_factor and last_factor must differ, both are ",
                    last_factor);
}

template <class Scene, class LinearSolver>
StaticsReport solve_statics(Scene& model, LinearSolver& solver, const StaticsOptions& options) {
    require_linear_solver<LinearSolver>();
    options.check();
    return detail::StaticsRun<Scene, LinearSolver>(model, solver, options).run();
}

}  // namespace ancf
