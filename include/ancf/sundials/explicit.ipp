// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of explicit.hpp: one run of ERKStep.

#pragma once

#include <ancf/dynamics/recorder.hpp>
#include <ancf/error.hpp>
#include <ancf/sundials/arkode.hpp>
#include <ancf/sundials/context.hpp>
#include <ancf/sundials/explicit.hpp>
#include <ancf/sundials/explicit_system.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <new>
#include <string>

namespace ancf::sundials {
namespace detail {

/// A table as ARKODE knows it.
struct TableData {
    ARKODE_ERKTableID id;
    Reach reach;  // computed from the coefficients; tests/sundials/explicit_test.cpp checks them
};

[[nodiscard]] ANCF_INLINE TableData table_data(Table table) noexcept {
    switch (table) {
        case Table::bogacki_shampine: return {ARKODE_BOGACKI_SHAMPINE_4_2_3, {1.732, 1.732}};
        case Table::zonneveld: return {ARKODE_ZONNEVELD_5_3_4, {2.828, 2.615}};
        case Table::ark437: return {ARKODE_ARK437L2SA_ERK_7_3_4, {4.695, 4.503}};
        case Table::dormand_prince: return {ARKODE_DORMAND_PRINCE_7_4_5, {0.997, 0.997}};
        case Table::verner: return {ARKODE_VERNER_8_5_6, {1.306, 1.306}};
        case Table::fehlberg: return {ARKODE_FEHLBERG_13_7_8, {2.365, 2.365}};
        case Table::ark436: break;
    }
    return {ARKODE_ARK436L2SA_ERK_6_3_4, {3.999, 3.688}};
}

/// Returns the status that a return code of ARKODE amounts to.
[[nodiscard]] ANCF_INLINE Status arkode_status(int code) noexcept {
    if (code >= 0) return Status::converged;
    switch (code) {
        case ARK_TOO_MUCH_WORK: return Status::max_iterations;
        case ARK_TOO_MUCH_ACC:
        case ARK_ERR_FAILURE: return Status::step_too_small;
        case ARK_RHSFUNC_FAIL:
        case ARK_FIRST_RHSFUNC_ERR:
        case ARK_REPTD_RHSFUNC_ERR:
        case ARK_UNREC_RHSFUNC_ERR: return Status::not_finite;
        default: return Status::diverged;
    }
}

/// One run: ARKODE's objects, the system, and what is reported.
class ExplicitRun {
public:
    ExplicitRun(DynamicProblem& problem, const Schedule& schedule, const ExplicitOptions& options,
                const Start& start, ExplicitReport& report);

    void run();

private:
    void call(int code) const;
    [[nodiscard]] bool is_fixed() const noexcept { return options_.step > 0.0; }
    void set_up();
    void set_tolerances();
    void set_steps();
    [[nodiscard]] bool is_feasible();
    [[nodiscard]] bool is_stable();
    [[nodiscard]] bool step();
    void observe_until(double time);
    void monitor();
    void end(Status status, std::string message);
    void fail(int code);
    void finish();

    DynamicProblem& problem_;
    const Schedule& schedule_;
    const ExplicitOptions& options_;
    const Start& start_;
    ExplicitReport& report_;

    TableData table_;
    ExplicitSystem system_;
    Context context_;
    VectorOwner y_, tolerances_, dense_;
    ArkodeOwner erk_;

    double fixed_step_ = 0.0;  // s: options_.step, shortened
    double time_;
    int code_ = ARK_SUCCESS;  // of the last call that evolves
    bool ran_ = false;
    std::size_t next_ = 0;  // of the schedule's times
    VectorX q_, v_;
    State observed_;
};

ANCF_INLINE ExplicitRun::ExplicitRun(DynamicProblem& problem, const Schedule& schedule,
                                     const ExplicitOptions& options, const Start& start,
                                     ExplicitReport& report)
    : problem_(problem),
      schedule_(schedule),
      options_(options),
      start_(start),
      report_(report),
      table_(table_data(options.table)),
      system_(problem, table_.reach, options.stable_interval),
      y_(make_vector(context_, system_.size())),
      tolerances_(make_vector(context_, system_.size())),
      dense_(make_vector(context_, system_.size())),
      time_(start.time) {
    auto y = view(y_.get());
    system_.q(y) = start.q;
    system_.v(y) = start.v;
    erk_ = make_erk(context_, &ExplicitSystem::rate, start.time, y_.get());
    system_.estimate(start.time, start.q, start.v);
    set_up();
}

// Throws what a failed call to set ARKODE up amounts to.
ANCF_INLINE void ExplicitRun::call(int code) const {
    if (code == ARK_SUCCESS) return;
    if (code == ARK_MEM_FAIL) throw std::bad_alloc();
    ancf::detail::reject("Explicit: ", arkode_code_name(code), ": ", context_.message());
}

ANCF_INLINE void ExplicitRun::set_up() {
    void* erk = erk_.get();
    call(Arkode::set_user_data(erk, &system_));
    call(ERKStepSetTableNum(erk, table_.id));
    set_tolerances();
    call(Arkode::set_stop_time(erk, schedule_.end));
    set_steps();
}

ANCF_INLINE void ExplicitRun::set_tolerances() {
    double length = options_.length_scale;
    if (length == 0.0) length = problem_.length_scale();
    double velocity = options_.velocity_scale;
    if (velocity == 0.0) velocity = length * problem_.motion_frequency(start_);
    if (velocity == 0.0) velocity = length * problem_.lowest_frequency(start_.time, start_.q);
    // nothing moves: one length in the run
    if (velocity == 0.0) velocity = length / (schedule_.end - start_.time);
    if (!std::isfinite(velocity)) velocity = length;  // there is no run
    VectorX sizes;
    problem_.numbering().gather_free(problem_.scales_of(length), sizes);
    auto absolute = view(tolerances_.get());
    system_.q(absolute) = options_.tolerance * sizes;
    system_.v(absolute) = options_.tolerance * velocity / length * sizes;
    call(Arkode::set_tolerances(erk_.get(), options_.tolerance, tolerances_.get()));
}

ANCF_INLINE void ExplicitRun::set_steps() {
    void* erk = erk_.get();
    const double duration = schedule_.end - start_.time;
    if (is_fixed()) {
        fixed_step_ = duration / std::max(1.0, std::ceil(duration / options_.step - 1e-9));
        if (duration > 0.0) call(Arkode::set_fixed_step(erk, fixed_step_));
        return;
    }
    call(Arkode::set_stability(erk, &ExplicitSystem::stability, &system_));
    call(Arkode::set_stable_share(erk, options_.stable_share));
    call(Arkode::set_kept_steps(erk, 1.0, 1.0));  // a step just below the stable one grows to it
    double first = options_.first_step;
    if (first == 0.0) first = std::min(0.1 * system_.stable_step(), 1e-3 * duration);
    first = std::min(first, options_.stable_share * system_.stable_step());
    if (options_.max_step > 0.0) first = std::min(first, options_.max_step);
    if (first > 0.0) call(Arkode::set_first_step(erk, first));
    // without a least step ARKODE goes on for ever where time no longer advances
    const double farthest = std::max(std::abs(start_.time), std::abs(schedule_.end));
    call(Arkode::set_min_step(erk, 100.0 * std::numeric_limits<double>::epsilon() * farthest));
    if (options_.max_step > 0.0) call(Arkode::set_max_step(erk, options_.max_step));
}

ANCF_INLINE void ExplicitRun::run() {
    report_.smallest_step = std::numeric_limits<double>::infinity();
    monitor();
    observe_until(time_);
    if (is_feasible())
        while (time_ < schedule_.end && step()) {
        }
    if (report_.steps == 0) report_.smallest_step = 0.0;
    finish();
}

// Whether the steps that stability allows reach the end.
ANCF_INLINE bool ExplicitRun::is_feasible() {
    if (is_fixed()) return is_stable();
    const double most = options_.stable_share * system_.stable_step();
    const double needed = (schedule_.end - time_) / most;
    if (options_.max_steps == 0 || needed <= static_cast<double>(options_.max_steps)) return true;
    end(Status::max_iterations,
        ancf::detail::joined(
            {"a stable step is ", most, " s long, as the scene vibrates at up to ",
             system_.frequency(), " rad/s: that makes ", needed, " steps, and max_steps is ",
             options_.max_steps, "; a stiff scene is one for GeneralizedAlpha"},
            6));
    return false;
}

// Whether a fixed step is below the stable one; ends the run where it is not.
ANCF_INLINE bool ExplicitRun::is_stable() {
    if (fixed_step_ <= system_.stable_step()) return true;
    end(Status::diverged,
        ancf::detail::joined({"the fixed step of ", fixed_step_, " s is above the stable one of ",
                              system_.stable_step(), " s at ", time_, " s"},
                             6));
    return false;
}

// Takes one step and reports it; false where the run ends.
ANCF_INLINE bool ExplicitRun::step() {
    if (options_.max_steps > 0 && report_.steps == options_.max_steps) {
        fail(ARK_TOO_MUCH_WORK);
        return false;
    }
    double reached = time_;
    system_.forget_fault();
    context_.forget_message();
    ran_ = true;
    const int code = Arkode::evolve(erk_.get(), schedule_.end, y_.get(), &reached, ARK_ONE_STEP);
    system_.rethrow();
    if (code < 0) {
        fail(code);
        return false;
    }
    code_ = code;
    ++report_.steps;
    time_ = reached;
    double length = 0.0;
    Arkode::last_step(erk_.get(), &length);
    report_.smallest_step = std::min(report_.smallest_step, length);
    report_.largest_step = std::max(report_.largest_step, length);
    monitor();
    observe_until(time_);
    if (schedule_.progress && !schedule_.progress(time_, schedule_.end)) {
        end(Status::stopped, "a callback asked to stop");
        return false;
    }
    if (!is_fixed() || report_.steps % options_.stable_interval != 0) return true;
    system_.estimate(time_, q_, v_);
    return is_stable();
}

ANCF_INLINE void ExplicitRun::monitor() {
    const auto y = view(y_.get());
    q_ = system_.q(y);
    v_ = system_.v(y);
    ancf::detail::note(problem_, {time_, q_, v_, {}}, options_.follow_energy, report_);
}

ANCF_INLINE void ExplicitRun::observe_until(double time) {
    for (; next_ < schedule_.times.size() && schedule_.times[next_] <= time; ++next_) {
        if (!schedule_.observe) continue;
        const double at = schedule_.times[next_];
        const bool between = at < time_;
        if (between) {
            call(Arkode::derivative(erk_.get(), at, 0, dense_.get()));
            system_.rethrow();
        }
        const auto y = view(between ? dense_.get() : y_.get());
        schedule_.observe(problem_.snapshot(at, system_.q(y), system_.v(y), {}, observed_));
    }
}

ANCF_INLINE void ExplicitRun::end(Status status, std::string message) {
    report_.status = status;
    report_.message = std::move(message);
}

ANCF_INLINE void ExplicitRun::fail(int code) {
    code_ = code;
    // a fault in an attempt that ARKODE got over is not to blame
    if (arkode_status(code) == Status::not_finite || code == ARK_CONV_FAILURE)
        report_.fault = system_.fault();
    std::string message = ancf::detail::joined({arkode_code_name(code), " at ", time_, " s"}, 6);
    if (code == ARK_TOO_MUCH_WORK)
        message += ancf::detail::joined({": ", options_.max_steps, " steps were taken"});
    if (!context_.message().empty()) message += ": " + context_.message();
    if (report_.fault) message += "; " + problem_.assembly().describe(*report_.fault);
    end(report_.fault ? report_.fault->status : arkode_status(code), std::move(message));
}

ANCF_INLINE void ExplicitRun::finish() {
    Arkode::error_failures(erk_.get(), &report_.rejected);
    Arkode::limited_steps(erk_.get(), &report_.limited);
    report_.evaluations += system_.evaluations();
    report_.jacobians = system_.estimates();
    report_.highest_frequency = system_.frequency();
    report_.stable_step = system_.stable_step();
    if (ran_) report_.code = arkode_code_name(code_);
    report_.time = time_;
    ancf::detail::store_end(problem_, {time_, q_, v_, {}}, report_);
}

}  // namespace detail

ANCF_INLINE void ExplicitOptions::check() const {
    const auto scale = [](const char* name, double value) {
        ancf::detail::require(std::isfinite(value) && value >= 0.0, "ExplicitOptions: ", name,
                              " must be positive, or 0 for automatic, got ", value);
    };
    ancf::detail::require(tolerance >= 1e-14 && tolerance < 1.0,
                          "ExplicitOptions: tolerance must be from 1e-14 to 1, got ", tolerance);
    scale("step", step);
    scale("length_scale", length_scale);
    scale("velocity_scale", velocity_scale);
    scale("first_step", first_step);
    scale("max_step", max_step);
    ancf::detail::require(max_steps >= 0,
                          "ExplicitOptions: max_steps must be positive, or 0 for no limit, got ",
                          max_steps);
    ancf::detail::require(stable_share > 0.0 && stable_share < 1.0,
                          "ExplicitOptions: stable_share must be between 0 and 1, got ",
                          stable_share);
    ancf::detail::require(stable_interval > 0,
                          "ExplicitOptions: stable_interval must be positive, got ",
                          stable_interval);
}

ANCF_INLINE ExplicitReport Explicit::integrate(DynamicProblem& problem,
                                               const Schedule& schedule) const {
    const auto began = std::chrono::steady_clock::now();
    ancf::detail::require(
        problem.multipliers() == 0, "Explicit: the scene has constraints with ",
        problem.multipliers(),
        " multipliers, which no explicit method takes; integrate by GeneralizedAlpha or Ida, or "
        "join by supports, by polyline and by Scene::attach, which have no multipliers");
    ancf::detail::require_motion(problem);
    const double from = problem.model().state().time;
    schedule.check(from);
    if (options_.step > 0.0 && schedule.end > from)
        ancf::detail::require_resolved(options_.step, from, schedule.end);
    ExplicitReport report;
    const Start start = problem.start();
    ++report.evaluations;
    report.time = start.time;
    report.status = start.status;
    report.message = start.message;
    if (start.status == Status::converged)
        detail::ExplicitRun(problem, schedule, options_, start, report).run();
    report.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return report;
}

}  // namespace ancf::sundials
