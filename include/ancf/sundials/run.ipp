// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of run.hpp.

#pragma once

#include <ancf/error.hpp>
#include <ancf/sundials/run.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

namespace ancf::sundials::detail {

ANCF_INLINE SteppedRun::SteppedRun(const char* who, std::string (*names)(int),
                                   DynamicProblem& problem, const Schedule& schedule,
                                   bool follow_energy, DynamicsReport& report)
    : problem_(problem),
      schedule_(schedule),
      recorder_(problem, schedule, report, follow_energy),
      who_(who),
      names_(names),
      outcome_(report) {}

ANCF_INLINE void SteppedRun::call(int code) const {
    if (code == IDA_SUCCESS) return;
    if (code == IDA_MEM_FAIL) throw std::bad_alloc();
    ancf::detail::reject(who_, ": ", names_(code), ": ", context_.message());
}

ANCF_INLINE bool SteppedRun::starts() {
    start_ = ancf::detail::start_run(problem_, outcome_);
    now_ = {start_.time, start_.q, start_.v, start_.multipliers};
    return outcome_.status == Status::converged;
}

ANCF_INLINE double SteppedRun::slow_frequency() {
    const double motion = problem_.motion_frequency(start_);
    return motion > 0.0 ? motion : problem_.lowest_frequency(start_.time, start_.q);
}

ANCF_INLINE double SteppedRun::velocity_scale(double length, double frequency) const {
    double velocity = length * frequency;
    // nothing moves: one length in the run
    if (velocity == 0.0) velocity = length / (schedule_.end - start_.time);
    return std::isfinite(velocity) ? velocity : length;  // else there is no run
}

ANCF_INLINE double SteppedRun::least_step() const {
    const double farthest = std::max(std::abs(start_.time), std::abs(schedule_.end));
    return 100.0 * std::numeric_limits<double>::epsilon() * farthest;
}

ANCF_INLINE bool SteppedRun::record(double length, const ancf::detail::Between& between) {
    const bool first = outcome_.steps == 0;
    const double smallest = first ? length : std::min(outcome_.smallest_step, length);
    const double largest = std::max(outcome_.largest_step, length);
    // as one of no length: outputs close to its end are interpolated too
    const bool goes_on = recorder_.step(now_, now_, between);
    outcome_.smallest_step = smallest;
    outcome_.largest_step = largest;
    return goes_on;
}

ANCF_INLINE bool SteppedRun::end(Status status, std::string message) {
    outcome_.status = status;
    outcome_.message = std::move(message);
    return false;
}

ANCF_INLINE bool SteppedRun::fail(int code, Status status, long max_steps) {
    code_ = code;
    std::string message = ancf::detail::joined({names_(code), " at ", now_.time, " s"}, 6);
    if (code == IDA_TOO_MUCH_WORK)
        message += ancf::detail::joined({": ", max_steps, " steps were taken"});
    if (!context_.message().empty()) message += ": " + context_.message();
    if (outcome_.fault) message += "; " + problem_.assembly().describe(*outcome_.fault);
    return end(outcome_.fault ? outcome_.fault->status : status, std::move(message));
}

ANCF_INLINE void check_options(const char* options, double tolerance, long max_steps,
                               std::initializer_list<std::pair<const char*, double>> scales) {
    ancf::detail::require(tolerance >= 1e-14 && tolerance < 1.0, options,
                          ": tolerance must be from 1e-14 to 1, got ", tolerance);
    for (const auto& [name, value] : scales)
        ancf::detail::require(std::isfinite(value) && value >= 0.0, options, ": ", name,
                              " must be positive, or 0 for automatic, got ", value);
    ancf::detail::require(max_steps >= 0, options,
                          ": max_steps must be positive, or 0 for no limit, got ", max_steps);
}

}  // namespace ancf::sundials::detail
