// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the integrators of this folder share: output at the schedule's times, and statistics.
///
/// Between two steps q is the cubic of q and v at both ends and v its derivative; the multipliers
/// are linear. What is observed is projected on the constraints; the integration never sees that.

#pragma once

#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>

namespace ancf::detail {

/// Throws unless the problem was set up for the storage of the solver.
template <class LinearSolver, class Scene>
void require_same_storage(const DynamicProblem<Scene>& problem) {
    require(problem.assembly().pattern().storage() == LinearSolver::storage, LinearSolver::name(),
            " works on ",
            LinearSolver::storage == Storage::lower ? "the lower half" : "full storage",
            "; set ProblemOptions::storage to match it");
}

/// A point of a motion: free coordinates, rates and multipliers at a time.
struct MotionPoint {
    double time = 0.0;
    VectorX q, v, lambda;
};

/// Reports one run.
template <class Scene>
class Recorder {
public:
    /// @param energies  whether to follow the energy of every step (one evaluation each).
    Recorder(DynamicProblem<Scene>& problem, const Schedule& schedule, DynamicsReport& report,
             bool energies)
        : problem_(problem),
          schedule_(schedule),
          report_(report),
          energies_(energies),
          begin_(std::chrono::steady_clock::now()) {}

    /// Takes the start and observes it where asked.
    void start(const MotionPoint& point) {
        report_.time = point.time;
        note(point, true);
        observe(point, point, 0.0);
    }

    /// Takes an accepted step.
    /// @return false where the progress callback asks to stop.
    [[nodiscard]] bool step(const MotionPoint& from, const MotionPoint& to) {
        const double width = to.time - from.time;
        report_.time = to.time;
        ++report_.steps;
        report_.smallest_step = report_.steps == 1 ? width : std::min(report_.smallest_step, width);
        report_.largest_step = std::max(report_.largest_step, width);
        note(to, false);
        observe(from, to, 1e-9 * width);
        return !schedule_.progress || schedule_.progress(to.time, schedule_.end);
    }

    /// Stores the last point, projected, in the model.
    void finish(const MotionPoint& point) {
        VectorX q = point.q;
        VectorX v = point.v;
        (void)problem_.project(point.time, q, v);
        problem_.store(point.time, q, v, point.lambda);
        report_.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }

private:
    void note(const MotionPoint& point, bool first) {
        if (problem_.multipliers() > 0) {
            problem_.evaluate_constraints(point.time, point.q, point.v);
            report_.violation = std::max(report_.violation, problem_.constraint_violation());
            report_.violation_rate = std::max(report_.violation_rate, problem_.violation_rate());
        }
        if (!energies_) return;
        const Energies energies = problem_.energies(point.time, point.q, point.v, point.lambda);
        ++report_.evaluations;
        if (first) report_.energy_start = energies.total();
        report_.energy_drift =
            std::max(report_.energy_drift, std::abs(energies.total() - report_.energy_start));
        report_.kinetic_largest = std::max(report_.kinetic_largest, energies.kinetic);
    }

    void observe(const MotionPoint& from, const MotionPoint& to, double slack) {
        for (; next_ < schedule_.times.size() && schedule_.times[next_] <= to.time + slack;
             ++next_) {
            if (!schedule_.observe) continue;
            const double time = schedule_.times[next_];
            State state;
            if (time >= to.time - slack)
                schedule_.observe(problem_.snapshot(to.time, to.q, to.v, to.lambda, state));
            else
                observe_between(from, to, time, state);
        }
    }

    void observe_between(const MotionPoint& from, const MotionPoint& to, double time,
                         State& state) {
        const double h = to.time - from.time;
        const double s = (time - from.time) / h;
        const double later = s * s * (3.0 - 2.0 * s);
        const double slope = 6.0 * s * (1.0 - s) / h;
        VectorX q = (1.0 - later) * from.q + later * to.q +
                    h * s * (1.0 - s) * ((1.0 - s) * from.v - s * to.v);
        VectorX v = slope * (to.q - from.q) + (1.0 - s) * (1.0 - 3.0 * s) * from.v +
                    s * (3.0 * s - 2.0) * to.v;
        const VectorX lambda = (1.0 - s) * from.lambda + s * to.lambda;
        schedule_.observe(problem_.snapshot(time, std::move(q), std::move(v), lambda, state));
    }

    DynamicProblem<Scene>& problem_;
    const Schedule& schedule_;
    DynamicsReport& report_;
    bool energies_;
    std::chrono::steady_clock::time_point begin_;
    std::size_t next_ = 0;
};

}  // namespace ancf::detail
