// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of explicit.hpp: one run of ERKStep.

#pragma once

#include <ancf/algebra.hpp>
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
#include <utility>

namespace ancf::sundials {
namespace detail {

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
    [[nodiscard]] int evolve(double& reached);
    void restart(double step);
    void observe_until(double time);
    [[nodiscard]] ancf::detail::MotionPoint between(double time) const;
    void monitor();
    void end(Status status, std::string message);
    void fail(int code);
    void finish();

    DynamicProblem& problem_;
    const Schedule& schedule_;
    const ExplicitOptions& options_;
    const Start& start_;
    ExplicitReport& report_;

    ExplicitSystem system_;
    Context context_;
    VectorOwner y_, tolerances_, dense_;
    ArkodeOwner erk_;

    double fixed_step_ = 0.0;  // s: options_.step, shortened
    double time_;
    int code_ = ARK_SUCCESS;  // of the last call that evolves
    bool ran_ = false;
    std::size_t next_ = 0;                             // of the schedule's times
    VectorX q_, v_, a_;                                // at time_
    VectorX from_q_, from_v_, from_a_;                 // where the step that led there began
    double from_ = 0.0;                                // s
    long earlier_rejected_ = 0, earlier_limited_ = 0;  // before the last restart
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
      system_(problem, reach_of(options.table), options.stable_interval),
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
    call(ERKStepSetTableNum(erk, table_id(options_.table)));
    call(Arkode::set_degree(erk, 3));  // of what gives the accelerations; more asks for more forces
#if SUNDIALS_VERSION_MAJOR < 7 || (SUNDIALS_VERSION_MAJOR == 7 && SUNDIALS_VERSION_MINOR < 1)
    // Before 7.1 every table whose last stage is at the step's end has it taken for the first one
    // of the next step, which lowers the order to three; after a step that was processed it is not.
    if (!is_first_same_as_last(options_.table))
        call(Arkode::set_after_step(erk, [](sunrealtype, N_Vector, void*) { return 0; }));
#endif
    set_tolerances();
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
    call(Arkode::set_stop_time(erk, schedule_.end));
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
    a_ = start_.acceleration;
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
    const int code = evolve(reached);
    if (code < 0) {
        fail(code);
        return false;
    }
    code_ = code;
    ++report_.steps;
    from_ = std::exchange(time_, reached);
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

// Takes a step; where an element fails, smaller ones, which ARKODE does not try by itself.
ANCF_INLINE int ExplicitRun::evolve(double& reached) {
    constexpr int most = 12;
    for (int attempt = 0;; ++attempt) {
        const int code =
            Arkode::evolve(erk_.get(), schedule_.end, y_.get(), &reached, ARK_ONE_STEP);
        system_.rethrow();
        if (arkode_status(code) != Status::not_finite || is_fixed() || attempt == most) return code;
        double tried = 0.0;
        Arkode::current_step(erk_.get(), &tried);
        ++report_.convergence_failures;
        restart(0.25 * tried);
    }
}

// Begins anew at the last state with a step of its own.
ANCF_INLINE void ExplicitRun::restart(double step) {
    void* erk = erk_.get();
    long count = 0;
    Arkode::error_failures(erk, &count);
    earlier_rejected_ += count;
    Arkode::limited_steps(erk, &count);
    earlier_limited_ += count;
    auto y = view(y_.get());
    system_.q(y) = q_;
    system_.v(y) = v_;
    call(ERKStepReInit(erk, &ExplicitSystem::rate, time_, y_.get()));
    call(Arkode::set_stop_time(erk, schedule_.end));
    call(Arkode::set_first_step(erk, step));
}

ANCF_INLINE void ExplicitRun::monitor() {
    if (schedule_.observe) {
        from_q_.swap(q_);
        from_v_.swap(v_);
        if (report_.steps > 0) {
            from_a_.swap(a_);
            call(Arkode::derivative(erk_.get(), time_, 1, dense_.get()));
            a_ = system_.v(view(dense_.get()));
        }
    }
    const auto y = view(y_.get());
    q_ = system_.q(y);
    v_ = system_.v(y);
    ancf::detail::note(problem_, {time_, q_, v_, {}}, options_.follow_energy, report_);
}

ANCF_INLINE void ExplicitRun::observe_until(double time) {
    for (; next_ < schedule_.times.size() && schedule_.times[next_] <= time; ++next_) {
        if (!schedule_.observe) continue;
        const double at = schedule_.times[next_];
        const auto point = at < time_ ? between(at) : ancf::detail::MotionPoint{time_, q_, v_, {}};
        schedule_.observe(problem_.snapshot(at, point.q, point.v, {}, observed_));
    }
}

// Quintic of q, v and a at both ends, and its derivative.
ANCF_INLINE ancf::detail::MotionPoint ExplicitRun::between(double time) const {
    const double h = time_ - from_;
    const double s = (time - from_) / h;
    const double r = 1.0 - s;
    const double later = s * s * s * (10.0 + s * (6.0 * s - 15.0));
    const double slope = 30.0 * s * s * r * r / h;
    return {time,
            (1.0 - later) * from_q_ + later * q_ +
                h * s * r * (r * r * (1.0 + 3.0 * s) * from_v_ - s * s * (1.0 + 3.0 * r) * v_) +
                0.5 * h * h * s * s * r * r * (r * from_a_ + s * a_),
            slope * (q_ - from_q_) + r * r * (1.0 + s * (2.0 - 15.0 * s)) * from_v_ +
                s * s * (1.0 + r * (2.0 - 15.0 * r)) * v_ +
                0.5 * h * s * r * (r * (2.0 - 5.0 * s) * from_a_ - s * (2.0 - 5.0 * r) * a_),
            {}};
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
    report_.rejected += earlier_rejected_;
    report_.limited += earlier_limited_;
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
        " multipliers, which no explicit method takes; integrate by RadauIIA or Ida, or "
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
