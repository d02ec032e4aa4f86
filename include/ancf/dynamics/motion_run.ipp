// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of motion_run.hpp.

#pragma once

#include <ancf/dynamics/motion_run.hpp>
#include <ancf/error.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ancf::detail {

ANCF_INLINE Start start_run(DynamicProblem& problem, DynamicsReport& report) {
    Start start = problem.start();
    ++report.evaluations;
    report.time = start.time;
    report.status = start.status;
    report.message = start.message;
    return start;
}

ANCF_INLINE void StepControl::check(const std::string& options) const {
    require(std::isfinite(tolerance) && tolerance >= 0.0, options,
            ": tolerance must be positive, or 0 for fixed steps, got ", tolerance);
    require_positive(options + ": step", first);
    require_positive(options + ": min_step", least);
    require(most >= least, options, ": max_step must be at least min_step, ", least, ", got ",
            most);
}

ANCF_INLINE Step StepGrid::next(double now, double end) const {
    const double point = origin + (count + 1.0) * width;
    const bool on_grid = end >= point - 1e-9 * width;
    const double to = on_grid ? point : end, rest = to - now;
    if (part > 0.0 && rest > part * (1.0 + 1e-6))
        return {part, now, now + part, Step::Ends::within};
    const bool whole = on_grid && std::abs(rest - width) <= 1e-6 * width;
    return {whole ? width : rest, now, to, on_grid ? Step::Ends::on_grid : Step::Ends::off_grid};
}

ANCF_INLINE bool StepGrid::halve(const Step& step) {
    constexpr double smallest = 1e-3;
    part = 0.5 * step.width;
    return parts * part > smallest * width;
}

ANCF_INLINE void StepGrid::take(const Step& step) {
    if (step.ends == Step::Ends::within) return;
    const bool on_grid = step.ends == Step::Ends::on_grid;
    *this = {on_grid ? origin : step.end, width, on_grid ? count + 1.0 : 0.0};
}

ANCF_INLINE MotionRun::MotionRun(DynamicProblem& problem, LinearSolver& solver,
                                 const Schedule& schedule, const StepControl& control,
                                 bool follow_energy, bool takes_parts)
    : problem_(problem),
      solver_(solver),
      schedule_(schedule),
      control_(control),
      recorder_(problem, schedule, report_, follow_energy),
      grid_{0.0, control.is_adaptive() ? std::min(control.first, control.most) : control.first} {
    require_same_storage(solver, problem);
    require_motion(problem, takes_parts);
    const double time = problem.model().state().time;
    schedule.check(time);
    require_resolved(control.first, time, schedule.end);
    start_ = start_run(problem, report_);
    grid_.origin = start_.time;
    duration_ = schedule.end - start_.time;
    last_width_ = grid_.width;
}

ANCF_INLINE bool MotionRun::goes_on(const MotionPoint& now) const {
    return detail::goes_on(now, schedule_.end, std::min(grid_.width, duration_));
}

ANCF_INLINE Status MotionRun::evaluate(const MotionPoint& at, Request request) {
    ++report_.evaluations;
    report_.fault = problem_.evaluate(at.time, at.q, at.v, at.lambda, request);
    return report_.fault ? report_.fault->status : Status::converged;
}

ANCF_INLINE Step MotionRun::next_step(double now) const {
    Step step = grid_.next(now, schedule_.end);
    step.turn = driven_turn(problem_.model().constraints(), now, step.end);
    return step;
}

ANCF_INLINE bool MotionRun::divides(const Step& step) {
    if (control_.is_adaptive() || step.turn.fits() || grid_.part > 0.0) return false;
    grid_.parts = parts_for_turns(problem_.model().constraints(), step.begin, step.end);
    grid_.part = step.width / grid_.parts;
    return grid_.parts > 1;
}

ANCF_INLINE bool MotionRun::shortens(const Step& step, Status status, double factor) {
    const bool converged = status == Status::converged;
    if (step.turn.fits()) converged ? ++report_.rejected : ++report_.convergence_failures;
    if (control_.is_adaptive()) grid_ = {step.begin, step.width * factor};
    if (control_.is_adaptive() ? grid_.width >= control_.least : grid_.halve(step)) return true;
    const std::string turn = step.turn.fits() ? ""
                                              : driven_turn_text(problem_.model().constraints(),
                                                                 step.turn, step.begin, step.end);
    if (control_.is_adaptive())
        return fail(Status::step_too_small,
                    joined({"the step fell below ", control_.least, " s at ", step.begin,
                            " s, last of ", converged ? "the local error" : to_string(status),
                            turn.empty() ? "" : "; ", turn},
                           6));
    if (!turn.empty()) return fail(status, turn);
    return fail(status, joined({"Newton's method failed in the step from ", step.begin,
                                " s: ", to_string(status), ", also in parts of ", step.width,
                                " s; a shorter step or adaptive steps (tolerance > 0) may pass"},
                               6));
}

ANCF_INLINE bool MotionRun::record(const MotionPoint& from, MotionPoint& to,
                                   const Between& between) {
    if (!goes_on(to)) to.time = schedule_.end;
    const double before = std::exchange(last_width_, to.time - from.time);
    // its own carry what Newton's method leaves of g and G v, over powers of the width
    has_short_step_ = problem_.multipliers() > 0 && 2.0 * last_width_ < before &&
                      problem_.model().exchange() == nullptr;
    if (has_short_step_) {
        ++report_.evaluations;
        VectorX acceleration, lambda;
        has_short_step_ =
            problem_.accelerations(to.time, to.q, to.v, acceleration, lambda) == Status::converged;
        if (has_short_step_) to.lambda = std::move(lambda);
    }
    return recorder_.step(from, to, between);
}

ANCF_INLINE bool MotionRun::fail(Status status, std::string message) {
    report_.status = status;
    report_.message = std::move(message);
    const std::string reason = solver_.failure();
    if (!reason.empty()) report_.message += "; " + reason;
    if (report_.fault) report_.message += "; " + problem_.assembly().describe(*report_.fault);
    return false;
}

ANCF_INLINE void MotionRun::remember(const char* integrator, const MotionPoint& end,
                                     std::initializer_list<double> own) {
    report_.memory.integrator = integrator;
    remember("", end);
    VectorX numbers(static_cast<Eigen::Index>(own.size()) + 5);
    const double first[] = {end.time, grid_.origin, grid_.count, grid_.width};
    std::copy(own.begin(), own.end(), std::copy_n(first, 4, numbers.data()));
    numbers[numbers.size() - 1] = problem_.length_scale();
    report_.memory.put("scalars", numbers);
    report_.memory.put("signature", signature(problem_, end));
}

ANCF_INLINE void MotionRun::remember(const std::string& prefix, const MotionPoint& point) {
    report_.memory.put(prefix + "q", point.q);
    report_.memory.put(prefix + "v", point.v);
    report_.memory.put(prefix + "lambda", point.lambda);
}

ANCF_INLINE const VectorX& MotionRun::recall(const char* who, const char* integrator,
                                             const Memory& memory, Eigen::Index own) {
    require(memory.integrator == integrator, who, ": the memory is that of ", memory.integrator);
    const VectorX& numbers = memory.get("scalars", own + 5);
    const double now = start_.time;
    require(std::abs(numbers[0] - now) <= 1e-12 * std::abs(now) + 1e-9 * numbers[3], who,
            ": the memory is of time ", numbers[0], " s, the model of ", now, " s");
    const bool adaptive = control_.is_adaptive();
    grid_.origin = numbers[0];
    last_width_ = 0.0;
    if (adaptive || numbers[3] == control_.first) grid_ = {numbers[1], numbers[3], numbers[2]};
    if (adaptive && grid_.width > control_.most) grid_ = {numbers[0], control_.most};
    return numbers;
}

ANCF_INLINE MotionPoint MotionRun::recall(const Memory& memory, const std::string& prefix,
                                          double time) const {
    const int n = problem_.size();
    return {time, memory.get(prefix + "q", n), memory.get(prefix + "v", n),
            memory.get(prefix + "lambda", problem_.multipliers())};
}

}  // namespace ancf::detail
