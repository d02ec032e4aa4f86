// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of recorder.hpp.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/dynamics/recorder.hpp>
#include <ancf/error.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

namespace ancf::detail {

ANCF_INLINE void require_motion(const DynamicProblem& problem, bool takes_parts) {
    require(takes_parts || problem.model().exchange() == nullptr,
            "a part of a scene is moved by GeneralizedAlpha alone, in all processes at once");
    require(problem.can_move(),
            "the scene has no free coordinate: there is no motion to integrate");
}

ANCF_INLINE double time_resolution(double start, double end) noexcept {
    return 16.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(start), std::abs(end));
}

ANCF_INLINE void require_resolved(double step, double start, double end) {
    const double least = time_resolution(start, end);
    require(step > least, "a step of ", step, " s is below the resolution of time at ", end, " s, ",
            least, " s");
}

ANCF_INLINE void require_same_storage(const LinearSolver& solver, const DynamicProblem& problem) {
    require(problem.assembly().pattern().storage() == solver.storage(), solver.name(), " works on ",
            solver.storage() == Storage::lower ? "the lower half" : "full storage",
            "; set ProblemOptions::storage to match it");
}

/// Returns the larger number; not a number where one of them is not.
[[nodiscard]] ANCF_INLINE double larger(double a, double b) noexcept { return b <= a ? a : b; }

/// Returns the sum of |a_ii| over the first `count` rows.
[[nodiscard]] ANCF_INLINE double trace_of_magnitudes(const SparseMatrix& matrix, int count) {
    double sum = 0.0;
    for (int j = 0; j < count; ++j)
        for (SparseMatrix::InnerIterator entry(matrix, j); entry; ++entry)
            if (entry.row() == j) sum += std::abs(entry.value());
    return sum;
}

ANCF_INLINE VectorX signature(DynamicProblem& problem, const MotionPoint& point) {
    (void)problem.evaluate(point.time, point.q, point.v, point.lambda, Request::tangent);
    const Energies at = problem.energies();
    VectorX values(6);
    values[0] = at.kinetic;
    values[1] = at.strain;
    values[2] = at.potential;
    values[3] = at.load_power;
    values[4] = problem.sum_of_parts(trace_of_magnitudes(problem.mass(), problem.size()));
    values[5] = problem.sum_of_parts(trace_of_magnitudes(problem.tangent(), problem.size()));
    return values;
}

ANCF_INLINE void require_continuation(const char* who, const Memory& memory,
                                      DynamicProblem& problem, const MotionPoint& start,
                                      const MotionPoint& point) {
    constexpr double same = 1e-9;
    VectorX q = point.q;
    VectorX v = point.v;
    (void)problem.project(point.time, q, v);
    const double fastest = problem.largest_ratio(v);
    const double moved = problem.largest_distance(q, start.q);
    const double sped = problem.largest_distance(v, start.v);
    require(moved <= same && sped <= same * fastest, who,
            ": the model's state is not the one that the memory belongs to");
    const VectorX then = memory.get("signature", 6);
    const VectorX here = signature(problem, point);
    const auto differ = [&](int k) {
        return !(std::abs(here[k] - then[k]) <= same * (std::abs(then[k]) + std::abs(here[k])));
    };
    const double energy = std::abs(then[0]) + std::abs(then[1]) + std::abs(then[2]);
    bool same_scene = !differ(3);
    for (int k = 0; k < 3; ++k)
        same_scene = same_scene && std::abs(here[k] - then[k]) <= same * energy;
    require(same_scene, who,
            ": the memory is of another scene: kinetic, strain and potential energy and the "
            "loads' power are ",
            Components{here.data(), 4}, " here, ", Components{then.data(), 4}, " there");
    require(!differ(4) && !differ(5), who,
            ": the memory is of another scene: mass or stiffness has changed since; a run after "
            "such a change starts without a memory");
}

ANCF_INLINE Recorder::Recorder(DynamicProblem& problem, const Schedule& schedule,
                               DynamicsReport& report, bool energies)
    : problem_(problem),
      schedule_(schedule),
      report_(report),
      energies_(energies),
      begin_(std::chrono::steady_clock::now()) {}

ANCF_INLINE void Recorder::start(const MotionPoint& point) {
    report_.time = point.time;
    note(point);
    observe(point, point, 0.0, {});
}

ANCF_INLINE bool Recorder::step(const MotionPoint& from, const MotionPoint& to,
                                const Between& between) {
    const double width = to.time - from.time;
    report_.time = to.time;
    ++report_.steps;
    report_.smallest_step = report_.steps == 1 ? width : std::min(report_.smallest_step, width);
    report_.largest_step = std::max(report_.largest_step, width);
    note(to);
    observe(from, to, 1e-9 * width, between);
    return goes_on(to.time);
}

ANCF_INLINE void Recorder::finish(const MotionPoint& point) {
    if (report_.status == Status::converged)
        observe(point, point, std::max(0.0, schedule_.end - point.time), {});
    store(point);
    report_.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

ANCF_INLINE void Recorder::inspect(const MotionPoint& point) {
    if (!report_.left_range.empty()) return;
    const Assembly& assembly = problem_.assembly();
    const VectorX q = problem_.raw_state(point.time, point.q, point.v).q;
    const auto fault = schedule_.pass_degenerate ? assembly.inspect(q) : assembly.inspect_parts(q);
    if (!fault) return;
    report_.left_range = joined({assembly.describe(*fault), " at ", point.time, " s"}, 6);
    if (schedule_.pass_degenerate || report_.status != Status::converged) return;
    report_.status = fault->status;
    report_.fault = fault;
}

ANCF_INLINE void Recorder::note(const MotionPoint& point) {
    const long in_a_step = std::max(2L, report_.evaluations / std::max(1L, report_.steps));
    if (report_.steps % std::max(1L, 24 / in_a_step) == 0) inspect(point);
    if (problem_.multipliers() > 0) {
        problem_.evaluate_constraints(point.time, point.q, point.v, false);
        report_.violation = larger(report_.violation, problem_.constraint_violation());
        report_.violation_rate = larger(report_.violation_rate, problem_.violation_rate());
    }
    if (!energies_) return;
    const Energies energies = problem_.energies(point.time, point.q, point.v, point.lambda);
    ++report_.evaluations;
    if (report_.steps == 0) report_.energy_start = energies.total();
    report_.energy_drift =
        larger(report_.energy_drift, std::abs(energies.total() - report_.energy_start));
    report_.kinetic_largest = larger(report_.kinetic_largest, energies.kinetic);
}

ANCF_INLINE bool Recorder::goes_on(double time) {
    if (report_.status != Status::converged) return false;
    if (!schedule_.progress || schedule_.progress(time, schedule_.end)) return true;
    report_.status = Status::stopped;
    report_.message = "the progress callback asked to stop";
    return false;
}

ANCF_INLINE void Recorder::store(const MotionPoint& end) {
    inspect(end);
    const auto add = [&](const std::string& text) {
        if (!report_.message.empty() && !text.empty()) report_.message += "; ";
        report_.message += text;
    };
    add(report_.left_range);
    VectorX q = end.q;
    VectorX v = end.v;
    if (!problem_.project(end.time, q, v))
        add("the last state could not be brought onto the constraints");
    problem_.store(end.time, q, v, end.lambda);
}

ANCF_INLINE void Recorder::observe(const MotionPoint& from, const MotionPoint& to, double slack,
                                   const Between& between) {
    for (; next_ < schedule_.times.size() && schedule_.times[next_] <= to.time + slack; ++next_) {
        if (!schedule_.observe) continue;
        const double time = schedule_.times[next_];
        State state;
        if (time >= to.time - slack) {
            schedule_.observe(problem_.snapshot(to.time, to.q, to.v, to.lambda, state));
        } else {
            MotionPoint at = between ? between(time) : cubic(from, to, time);
            schedule_.observe(
                problem_.snapshot(time, std::move(at.q), std::move(at.v), at.lambda, state));
        }
    }
}

ANCF_INLINE MotionPoint Recorder::cubic(const MotionPoint& from, const MotionPoint& to,
                                        double time) {
    const double h = to.time - from.time;
    const double s = (time - from.time) / h;
    const double later = s * s * (3.0 - 2.0 * s);
    const double slope = 6.0 * s * (1.0 - s) / h;
    const double bulge = h * s * (1.0 - s);
    return {
        time, (1.0 - later) * from.q + later * to.q + bulge * ((1.0 - s) * from.v - s * to.v),
        slope * (to.q - from.q) + (1.0 - s) * (1.0 - 3.0 * s) * from.v + s * (3.0 * s - 2.0) * to.v,
        (1.0 - s) * from.lambda + s * to.lambda};
}

}  // namespace ancf::detail
