// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of ida.hpp: one run of IDA.

#pragma once

#include <ancf/constants.hpp>
#include <ancf/dynamics/recorder.hpp>
#include <ancf/error.hpp>
#include <ancf/sundials/context.hpp>
#include <ancf/sundials/ida.hpp>
#include <ancf/sundials/ida_system.hpp>

#include <sunlinsol/sunlinsol_klu.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <new>
#include <string>

namespace ancf::sundials {
namespace detail {

/// Throws what a failed call to set IDA up amounts to.
ANCF_INLINE void require_success(int code, const Context& context) {
    if (code == IDA_SUCCESS) return;
    if (code == IDA_MEM_FAIL) throw std::bad_alloc();
    ancf::detail::reject("Ida: ", code_name(code), ": ", context.message());
}

/// Returns the status that a return code of IDASolve amounts to.
[[nodiscard]] ANCF_INLINE Status status_of(int code) noexcept {
    if (code >= 0) return Status::converged;
    switch (code) {
        case IDA_TOO_MUCH_WORK: return Status::max_iterations;
        case IDA_TOO_MUCH_ACC:
        case IDA_ERR_FAIL: return Status::step_too_small;
        case IDA_LINIT_FAIL:
        case IDA_LSETUP_FAIL:
        case IDA_LSOLVE_FAIL: return Status::singular;
        case IDA_RES_FAIL:
        case IDA_REP_RES_ERR:
        case IDA_FIRST_RES_FAIL: return Status::not_finite;
        default: return Status::diverged;
    }
}

/// One run: IDA's objects, the system, and what is reported.
class IdaRun {
public:
    IdaRun(DynamicProblem& problem, const Schedule& schedule, const IdaOptions& options,
           const Start& start, IdaReport& report);

    void run();

private:
    struct Scales {
        double length, velocity, force;
    };

    void call(int code) const { require_success(code, context_); }
    [[nodiscard]] Scales scales();
    [[nodiscard]] int order_limit();
    void set_up();
    void set_start();
    void fill_tolerances(Eigen::Map<VectorX>& absolute);
    void choose_error_test();
    [[nodiscard]] double first_step() const;
    [[nodiscard]] bool step();
    [[nodiscard]] bool lost_in_round_off() const;
    void observe_until(double time);
    void monitor();
    void finish();
    void fail(int code);
    [[nodiscard]] double rate_of_turn(const VectorX& rates) const {
        return rates.size() == 0 ? 0.0
                                 : (rates.array().abs() / problem_.scales().array()).maxCoeff();
    }

    DynamicProblem& problem_;
    const Schedule& schedule_;
    const IdaOptions& options_;
    const Start& start_;
    IdaReport& report_;

    IdaSystem system_;
    Context context_;
    VectorOwner y_, dy_, tolerances_, dense_;
    MatrixOwner matrix_;
    LinearSolverOwner klu_;
    IdaOwner ida_;

    double slow_frequency_ = 0.0;  // rad/s: of the motion that is followed
    double time_;
    int code_ = IDA_SUCCESS;  // of the last call of IDASolve
    std::size_t next_ = 0;    // of the schedule's times
    VectorX q_, v_, lambda_;
    State observed_;
};

ANCF_INLINE IdaRun::IdaRun(DynamicProblem& problem, const Schedule& schedule,
                           const IdaOptions& options, const Start& start, IdaReport& report)
    : problem_(problem),
      schedule_(schedule),
      options_(options),
      start_(start),
      report_(report),
      system_(problem, options.form),
      y_(make_vector(context_, system_.size())),
      dy_(make_vector(context_, system_.size())),
      tolerances_(make_vector(context_, system_.size())),
      dense_(make_vector(context_, system_.size())),
      matrix_(make_matrix(context_, system_.size(), system_.map().values())),
      klu_(make_klu(context_, y_.get(), matrix_.get())),
      ida_(make_ida(context_)),
      time_(start.time) {
    set_up();
}

// Fills y and dy, in units of the absolute tolerances. Rates are measured by the highest frequency
// where it is known: c is of that size where accuracy asks for no smaller step.
ANCF_INLINE void IdaRun::set_start() {
    auto y = view(y_.get());
    auto dy = view(dy_.get());
    system_.q(y) = start_.q;
    system_.v(y) = start_.v;
    system_.lambda(y) = start_.multipliers;
    system_.q(dy) = start_.v;
    system_.v(dy) = start_.acceleration;
    auto absolute = view(tolerances_.get());
    fill_tolerances(absolute);
    VectorX sizes = absolute;
    if (report_.highest_frequency > 0.0)
        system_.v(sizes) = report_.highest_frequency * system_.q(absolute);
    system_.set_units(sizes);
    for (auto& column : {&y, &dy, &absolute}) *column = column->cwiseQuotient(system_.units());
}

ANCF_INLINE void IdaRun::set_up() {
    void* ida = ida_.get();
    slow_frequency_ = problem_.motion_frequency(start_);
    if (slow_frequency_ == 0.0) slow_frequency_ = problem_.lowest_frequency(start_.time, start_.q);
    report_.order = order_limit();
    set_start();
    call(IDAInit(ida, &IdaSystem::residual, start_.time, y_.get(), dy_.get()));
    call(IDASetUserData(ida, &system_));
    call(IDASVtolerances(ida, options_.tolerance, tolerances_.get()));
    choose_error_test();
    SUNLinSol_KLUSetOrdering(klu_.get(), 0);  // AMD: the pattern is nearly symmetric
    call(IDASetLinearSolver(ida, klu_.get(), matrix_.get()));
    call(IDASetJacFn(ida, &IdaSystem::jacobian));
    call(IDASetMaxOrd(ida, report_.order));
    call(IDASetDeltaCjLSetup(ida, 0.05));
    call(IDASetMaxNonlinIters(ida, 6));
    call(IDASetNonlinConvCoef(ida, 0.1));
    call(IDASetStopTime(ida, schedule_.end));
    call(IDASetInitStep(ida, first_step()));
    // without a least step IDA goes on for ever where time no longer advances
    const double farthest = std::max(std::abs(start_.time), std::abs(schedule_.end));
    call(IDASetMinStep(ida, 100.0 * std::numeric_limits<double>::epsilon() * farthest));
    if (options_.max_step > 0.0) call(IDASetMaxStep(ida, options_.max_step));
}

ANCF_INLINE IdaRun::Scales IdaRun::scales() {
    Scales s{options_.length_scale, options_.velocity_scale, options_.force_scale};
    if (s.length == 0.0) s.length = problem_.length_scale();
    if (s.velocity == 0.0) s.velocity = s.length * slow_frequency_;
    // nothing moves: one length in the run
    if (s.velocity == 0.0) s.velocity = s.length / (schedule_.end - start_.time);
    if (!std::isfinite(s.velocity)) s.velocity = s.length;  // there is no run
    if (s.force == 0.0) s.force = problem_.force_scale(start_);
    if (s.force == 0.0) {
        const VectorX sizes = problem_.scales() / problem_.length_scale();
        const double mass =
            problem_.compact_mass().diagonal().cwiseProduct(sizes.cwiseAbs2()).maxCoeff();
        s.force = mass * s.velocity * s.velocity / s.length;
    }
    return s;
}

// The absolute tolerances, in the units of the scene.
ANCF_INLINE void IdaRun::fill_tolerances(Eigen::Map<VectorX>& absolute) {
    const Scales s = scales();
    VectorX sizes;
    problem_.numbering().gather_free(problem_.scales_of(s.length), sizes);
    system_.q(absolute) = options_.tolerance * sizes;
    system_.v(absolute) = options_.tolerance * s.velocity / s.length * sizes;
    // Newton's method cannot bring multipliers below the round-off of the forces they balance, of
    // which it sees a part. Where that hides the forces themselves, step() ends the run.
    const double round_off = 0.05 * problem_.force_round_off(start_.time, start_.q);
    const double resolved = round_off < s.force ? round_off : 0.0;
    // a multiplier has the unit of a force where its equation is a length, else another one
    const VectorX arms = problem_.assembly().violation_scale(s.length) / s.length;
    const auto measured = [&](double force, auto&& multipliers) {
        for (Eigen::Index i = 0; i < multipliers.size(); ++i)
            multipliers[i] = arms[i] > 0.0 ? force / arms[i] : force;
    };
    measured(std::max(options_.tolerance * s.force, resolved), system_.lambda(absolute));
    measured(options_.tolerance * s.force * s.length / s.velocity, system_.mu(absolute));
}

// The error test sees positions, and rates where the form holds them on the constraints.
ANCF_INLINE void IdaRun::choose_error_test() {
    auto differential = view(dense_.get());
    differential.setZero();
    system_.q(differential).setOnes();
    if (options_.form == Form::gear_gupta_leimkuhler) system_.v(differential).setOnes();
    call(IDASetId(ida_.get(), dense_.get()));
    call(IDASetSuppressAlg(ida_.get(), SUNTRUE));
}

ANCF_INLINE int IdaRun::order_limit() {
    if (options_.order != Order::automatic) return options_.order == Order::two ? 2 : 5;
    // Order 5 holds the step below 0.7/omega_max; so many steps while the scene turns once are too
    // many.
    constexpr double steps_in_a_period = 20000.0;
    constexpr double stable = 0.7;
    report_.highest_frequency = problem_.highest_frequency(start_.time, start_.q);
    // a stiff joint carries no motion of its own, but its frequency would hold order 5's step down
    for (const auto& group : problem_.model().groups())
        if (group->one_node()) return 2;
    if (slow_frequency_ == 0.0) return 5;
    const double period = 2.0 * pi / slow_frequency_;
    return period * report_.highest_frequency / stable > steps_in_a_period ? 2 : 5;
}

// From the acceleration: the first step is of order 1, so its error is h^2 a/2.
ANCF_INLINE double IdaRun::first_step() const {
    if (options_.first_step > 0.0) return options_.first_step;
    const double duration = schedule_.end - start_.time;
    double step = 1e-3 * duration;
    const double turn = rate_of_turn(start_.v);
    if (turn > 0.0) step = std::min(step, 1e-3 / turn);
    const double acceleration = rate_of_turn(start_.acceleration);
    if (acceleration > 0.0)
        step = std::min(step, std::sqrt(0.5 * options_.tolerance / acceleration));
    return step;
}

ANCF_INLINE void IdaRun::run() {
    report_.smallest_step = std::numeric_limits<double>::infinity();
    monitor();
    observe_until(time_);
    while (time_ < schedule_.end && step()) {
    }
    if (report_.steps == 0) report_.smallest_step = 0.0;
    finish();
}

// Takes one step and reports it; false where the run ends.
ANCF_INLINE bool IdaRun::step() {
    if (options_.max_steps > 0 && report_.steps == options_.max_steps) {
        fail(IDA_TOO_MUCH_WORK);
        return false;
    }
    double reached = time_;
    system_.forget_fault();
    system_.begin_step(time_);
    context_.forget_message();
    const int code =
        IDASolve(ida_.get(), schedule_.end, &reached, y_.get(), dy_.get(), IDA_ONE_STEP);
    system_.rethrow();
    if (code < 0) {
        fail(code);
        return false;
    }
    code_ = code;
    ++report_.steps;
    time_ = reached;
    if (lost_in_round_off()) {
        context_.remember("Newton's method fails in most steps, the forces hide in round-off");
        fail(IDA_CONV_FAIL);
        return false;
    }
    double length = 0.0;
    IDAGetLastStep(ida_.get(), &length);
    report_.smallest_step = std::min(report_.smallest_step, length);
    report_.largest_step = std::max(report_.largest_step, length);
    monitor();
    observe_until(time_);
    if (schedule_.progress && !schedule_.progress(time_, schedule_.end)) {
        report_.status = Status::stopped;
        report_.message = "a callback asked to stop";
        return false;
    }
    return true;
}

// IDA halves its step where Newton's method fails and doubles it after the next, for ever.
ANCF_INLINE bool IdaRun::lost_in_round_off() const {
    long failures = 0;
    IDAGetNumNonlinSolvConvFails(ida_.get(), &failures);
    return failures > 1000 && 3 * failures > report_.steps;
}

// What a step left: energy and constraints, before any projection.
ANCF_INLINE void IdaRun::monitor() {
    const VectorX y = view(y_.get()).cwiseProduct(system_.units());
    q_ = system_.q(y);
    v_ = system_.v(y);
    lambda_ = system_.lambda(y);
    ancf::detail::note(problem_, {time_, q_, v_, lambda_}, options_.follow_energy, report_);
}

ANCF_INLINE void IdaRun::observe_until(double time) {
    for (; next_ < schedule_.times.size() && schedule_.times[next_] <= time; ++next_) {
        if (!schedule_.observe) continue;
        const double at = schedule_.times[next_];
        const bool between = at < time_;
        if (between) call(IDAGetDky(ida_.get(), at, 0, dense_.get()));
        const VectorX y = view(between ? dense_.get() : y_.get()).cwiseProduct(system_.units());
        schedule_.observe(
            problem_.snapshot(at, system_.q(y), system_.v(y), system_.lambda(y), observed_));
    }
}

ANCF_INLINE void IdaRun::fail(int code) {
    code_ = code;
    // an element that failed in an attempt that IDA got over is not to blame
    if (code == IDA_REP_RES_ERR || code == IDA_FIRST_RES_FAIL || code == IDA_RES_FAIL ||
        code == IDA_CONV_FAIL)
        report_.fault = system_.fault();
    const bool turns = code != IDA_TOO_MUCH_WORK && !system_.turn().empty();
    report_.status = report_.fault ? report_.fault->status
                     : turns       ? Status::step_too_small
                                   : status_of(code);
    std::string& message = report_.message;
    message = ancf::detail::joined({code_name(code), " at ", time_, " s"}, 6);
    if (code == IDA_TOO_MUCH_WORK)
        message += ancf::detail::joined({": ", options_.max_steps, " steps were taken"});
    if (!context_.message().empty()) message += ": " + context_.message();
    if (report_.fault) message += "; " + problem_.assembly().describe(*report_.fault);
    if (turns) message += "; " + system_.turn();
    if (report_.status == Status::diverged && options_.form == Form::index3 &&
        problem_.multipliers() > 0)
        message +=
            "; in very short steps the multipliers of index 3 are round-off: if that is so here, a "
            "larger first_step or tolerance, or gear_gupta_leimkuhler, may pass";
}

ANCF_INLINE void IdaRun::finish() {
    void* ida = ida_.get();
    IDAGetNumErrTestFails(ida, &report_.rejected);
    IDAGetNumNonlinSolvConvFails(ida, &report_.convergence_failures);
    IDAGetNumNonlinSolvIters(ida, &report_.iterations);
    long evaluations = 0;
    IDAGetNumResEvals(ida, &evaluations);
    report_.evaluations += evaluations;
    IDAGetNumJacEvals(ida, &report_.jacobians);
    IDAGetNumLinSolvSetups(ida, &report_.factorisations);
    report_.code = code_name(code_);
    report_.time = time_;
    ancf::detail::store_end(problem_, {time_, q_, v_, lambda_}, report_);
}

}  // namespace detail

ANCF_INLINE void IdaOptions::check() const {
    const auto scale = [](const char* name, double value) {
        ancf::detail::require(std::isfinite(value) && value >= 0.0, "IdaOptions: ", name,
                              " must be positive, or 0 for automatic, got ", value);
    };
    ancf::detail::require(tolerance >= 1e-14 && tolerance < 1.0,
                          "IdaOptions: tolerance must be from 1e-14 to 1, got ", tolerance);
    scale("length_scale", length_scale);
    scale("velocity_scale", velocity_scale);
    scale("force_scale", force_scale);
    scale("first_step", first_step);
    scale("max_step", max_step);
    ancf::detail::require(max_steps >= 0,
                          "IdaOptions: max_steps must be positive, or 0 for no limit, ", "got ",
                          max_steps);
}

ANCF_INLINE IdaReport Ida::integrate(DynamicProblem& problem, const Schedule& schedule) const {
    const auto began = std::chrono::steady_clock::now();
    ancf::detail::require(problem.assembly().pattern().storage() == Storage::full,
                          "Ida: the problem must have full storage");
    ancf::detail::require_motion(problem);
    schedule.check(problem.model().state().time);
    IdaReport report;
    const Start start = problem.start();
    ++report.evaluations;
    report.time = start.time;
    report.status = start.status;
    report.message = start.message;
    if (start.status == Status::converged)
        detail::IdaRun(problem, schedule, options_, start, report).run();
    report.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return report;
}

}  // namespace ancf::sundials
