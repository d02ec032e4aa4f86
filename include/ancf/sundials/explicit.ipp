// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/error.hpp>
#include <ancf/sundials/arkode.hpp>
#include <ancf/sundials/explicit.hpp>
#include <ancf/sundials/run.hpp>

#include <arkode/arkode.h>
#include <arkode/arkode_erkstep.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

// SUNDIALS 7.1 renamed ERKStepX to ARKodeX and deprecates the old names.
#if SUNDIALS_VERSION_MAJOR > 7 || (SUNDIALS_VERSION_MAJOR == 7 && SUNDIALS_VERSION_MINOR >= 1)
#define ANCF_ARKODE(name) ARKode##name
#else
#define ANCF_ARKODE(name) ERKStep##name
#endif

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

/// A dynamic problem without multipliers as y' = f(t, y), and how long steps may be:
///
///     y = (q, v),    f = (v, -M^-1 r(t, q, v)).
class ExplicitSystem : public SceneCalls {
public:
    /// @pre problem.start() has converged; no multipliers.
    /// @param every  steps between two estimates of the stable one.
    ExplicitSystem(DynamicProblem& problem, const ErkTable& table, int every)
        : SceneCalls(problem),
          table_(table),
          every_(every),
          stable_step_(std::numeric_limits<double>::infinity()) {}

    [[nodiscard]] Eigen::Index size() const noexcept { return 2 * static_cast<Eigen::Index>(n_); }

    static int rate(sunrealtype t, N_Vector y, N_Vector dy, void* self) noexcept {
        auto& system = *static_cast<ExplicitSystem*>(self);
        return system.guarded([&] {
            const auto at = view(y);
            auto out = view(dy);
            system.q_ = system.q(at);
            system.v_ = system.v(at);
            ++system.evaluations_;
            if (!system.evaluate(t, system.none_, Request::force)) return recoverable;
            system.problem_.solve_mass(system.problem_.force(), system.acceleration_);
            system.q(out) = system.v_;
            system.v(out) = -system.acceleration_;
            return good;
        });
    }

    static int stability(N_Vector y, sunrealtype t, sunrealtype* step, void* self) noexcept {
        auto& system = *static_cast<ExplicitSystem*>(self);
        return system.guarded([&] {
            if (++system.since_ >= system.every_) {
                const auto at = view(y);
                system.q_ = system.q(at);
                system.v_ = system.v(at);
                system.estimate(t, system.q_, system.v_);
            }
            *step = std::isfinite(system.stable_step_) ? system.stable_step_ : 0.0;  // 0: no limit
            return good;
        });
    }

    /// Estimates the longest stable step from the largest eigenvalues of M^-1 K and M^-1 D.
    ///
    /// Every eigenvalue mu of the linearised system has |mu| <= d/2 + sqrt(d^2/4 + w^2), with w^2
    /// and d those of M^-1 K and M^-1 D. Where an element fails the last estimate stays.
    void estimate(double t, const VectorX& q, const VectorX& v) {
        since_ = 0;
        ++estimates_;
        if (problem_.evaluate(t, q, v, none_, request_)) return;
        frequency_ = std::sqrt(problem_.largest_eigenvalue(problem_.tangent(), stiffest_));
        const double damping =
            request_ == Request::tangent
                ? 0.0
                : 0.5 * problem_.largest_eigenvalue(problem_.damping(), most_damped_);
        const bool damped = damping > 1e-3 * frequency_;
        const double fastest = damping + std::sqrt(damping * damping + frequency_ * frequency_);
        stable_step_ = (damped ? table_.disc : table_.axis) / fastest;
    }

    [[nodiscard]] double stable_step() const noexcept { return stable_step_; }  ///< s
    [[nodiscard]] double frequency() const noexcept { return frequency_; }      ///< rad/s
    [[nodiscard]] long evaluations() const noexcept { return evaluations_; }    ///< of the force
    [[nodiscard]] long estimates() const noexcept { return estimates_; }        ///< of the step

private:
    const ErkTable& table_;
    int every_;
    VectorX none_, acceleration_;
    VectorX stiffest_, most_damped_;  // modes of the last estimate
    double stable_step_, frequency_ = 0.0;
    int since_ = 0;  // steps since the last estimate
    long evaluations_ = 0, estimates_ = 0;
};

/// One run: ARKODE's objects, the system, and what is reported.
class ExplicitRun : SteppedRun {
public:
    ExplicitRun(DynamicProblem& problem, const Schedule& schedule, const ExplicitOptions& options)
        : SteppedRun("Explicit", &ANCF_ARKODE(GetReturnFlagName), problem, schedule,
                     options.follow_energy, report_),
          options_(options),
          table_(erk_tables[static_cast<int>(options.table)]),
          system_(problem, table_, options.stable_interval),
          y_(make_vector(context_, system_.size())),
          tolerances_(make_vector(context_, system_.size())),
          dense_(make_vector(context_, system_.size())) {}

    ExplicitReport run() {
        if (!starts()) return std::move(report_);
        set_up();
        a_ = start_.acceleration;
        recorder_.start(now_);
        if (is_feasible())
            while (now_.time < schedule_.end && step()) {
            }
        if (is_fixed() && report_.fault) {  // it may be what steps above the stable one lead to
            system_.estimate(now_.time, now_.q, now_.v);
            const std::string reason = instability();
            if (!reason.empty()) report_.message += (report_.message.empty() ? "" : "; ") + reason;
        }
        ANCF_ARKODE(GetNumErrTestFails)(erk_.get(), &report_.rejected);
        ANCF_ARKODE(GetNumExpSteps)(erk_.get(), &report_.limited);
        report_.rejected += earlier_rejected_;
        report_.limited += earlier_limited_;
        report_.evaluations += system_.evaluations();
        report_.jacobians = system_.estimates();
        report_.highest_frequency = system_.frequency();
        report_.stable_step = system_.stable_step();
        if (ran_) report_.code = code_name(code_);
        recorder_.finish(now_);
        return std::move(report_);
    }

private:
    [[nodiscard]] bool is_fixed() const noexcept { return options_.step > 0.0; }

    void set_up() {
        auto y = view(y_.get());
        system_.q(y) = start_.q;
        system_.v(y) = start_.v;
        erk_.reset(
            made(ERKStepCreate(&ExplicitSystem::rate, start_.time, y_.get(), context_.get())));
#if SUNDIALS_VERSION_MAJOR < 7
        ERKStepSetErrHandlerFn(erk_.get(), &Context::take, &context_);
#endif
        revision_ = problem_.model().revision();
        system_.estimate(start_.time, start_.q, start_.v);
        void* erk = erk_.get();
        call(ANCF_ARKODE(SetUserData)(erk, &system_));
        call(ERKStepSetTableNum(erk, table_.id));
        // of what gives the accelerations; more asks for more forces
        call(ANCF_ARKODE(SetInterpolantDegree)(erk, 3));
#if SUNDIALS_VERSION_MAJOR < 7 || (SUNDIALS_VERSION_MAJOR == 7 && SUNDIALS_VERSION_MINOR < 1)
        // Before 7.1 every table whose last stage is at the step's end has it taken for the first
        // one of the next step, which lowers the order to three; after a step that was processed it
        // is not.
        if (!table_.reuses_last)
            call(ANCF_ARKODE(SetPostprocessStepFn)(erk,
                                                   [](sunrealtype, N_Vector, void*) { return 0; }));
#endif
        set_tolerances();
        set_steps();
    }

    void set_tolerances() {
        double length = options_.length_scale;
        if (length == 0.0) length = problem_.length_scale();
        double velocity = options_.velocity_scale;
        if (velocity == 0.0) velocity = velocity_scale(length, slow_frequency());
        VectorX sizes;
        problem_.numbering().gather_free(problem_.scales_of(length), sizes);
        auto absolute = view(tolerances_.get());
        system_.q(absolute) = options_.tolerance * sizes;
        system_.v(absolute) = options_.tolerance * velocity / length * sizes;
        call(ANCF_ARKODE(SVtolerances)(erk_.get(), options_.tolerance, tolerances_.get()));
    }

    void set_steps() {
        void* erk = erk_.get();
        const double duration = schedule_.end - start_.time;
        call(ANCF_ARKODE(SetStopTime)(erk, schedule_.end));
        if (is_fixed()) {
            fixed_step_ = duration / std::max(1.0, std::ceil(duration / options_.step - 1e-9));
            if (duration > 0.0) call(ANCF_ARKODE(SetFixedStep)(erk, fixed_step_));
            return;
        }
        call(ANCF_ARKODE(SetStabilityFn)(erk, &ExplicitSystem::stability, &system_));
        call(ANCF_ARKODE(SetCFLFraction)(erk, options_.stable_share));
        // a step just below the stable one grows to it
        call(ANCF_ARKODE(SetFixedStepBounds)(erk, 1.0, 1.0));
        first_step_ = options_.first_step;
        if (first_step_ == 0.0)
            first_step_ = std::min(0.1 * system_.stable_step(), 1e-3 * duration);
        first_step_ = std::min(first_step_, options_.stable_share * system_.stable_step());
        if (options_.max_step > 0.0) first_step_ = std::min(first_step_, options_.max_step);
        if (first_step_ > 0.0) call(ANCF_ARKODE(SetInitStep)(erk, first_step_));
        call(ANCF_ARKODE(SetMinStep)(erk, least_step()));
        if (options_.max_step > 0.0) call(ANCF_ARKODE(SetMaxStep)(erk, options_.max_step));
    }

    // Whether the steps that stability allows reach the end.
    [[nodiscard]] bool is_feasible() {
        if (is_fixed()) return is_stable();
        const double most = options_.stable_share * system_.stable_step();
        const double needed = (schedule_.end - now_.time) / most;
        if (options_.max_steps == 0 || needed <= static_cast<double>(options_.max_steps))
            return true;
        return end(
            Status::max_iterations,
            ancf::detail::joined(
                {"a stable step is ", most, " s long, as the scene vibrates at up to ",
                 system_.frequency(), " rad/s: that makes ", needed, " steps, and max_steps is ",
                 options_.max_steps, "; a stiff scene is one for GeneralizedAlpha"}));
    }

    // Whether a fixed step is below the stable one; ends the run where it is not.
    [[nodiscard]] bool is_stable() {
        std::string reason = instability();
        return reason.empty() || end(Status::diverged, std::move(reason));
    }

    // Begins anew, and estimates the stable step anew, where the run goes on in a scene that an
    // observer has changed. Of fixed steps it also estimates it from time to time and at the end;
    // it ends the run where a fixed step is above it.
    [[nodiscard]] bool remains_stable() {
        const bool ends = now_.time >= schedule_.end;
        const bool changed = !(problem_.model().revision() == revision_);
        const bool due = is_fixed() && (ends || report_.steps % options_.stable_interval == 0);
        const bool wanted = changed ? !ends : due;
        if (!wanted) return true;
        revision_ = problem_.model().revision();
        system_.estimate(now_.time, now_.q, now_.v);
        if (changed) {
            double next = 0.0;
            ANCF_ARKODE(GetCurrentStep)(erk_.get(), &next);
            VectorX none;
            ++report_.evaluations;
            // where that fails the next step does
            (void)problem_.accelerations(now_.time, now_.q, now_.v, a_, none);
            restart(next);
        }
        return !is_fixed() || is_stable();
    }

    // Returns that a fixed step is above the stable one; empty where it is not.
    [[nodiscard]] std::string instability() const {
        if (fixed_step_ <= system_.stable_step()) return {};
        return ancf::detail::joined({"the fixed step of ", fixed_step_,
                                     " s is above the stable one of ", system_.stable_step(),
                                     " s at ", now_.time, " s"});
    }

    // Takes one step and reports it; false where the run ends.
    [[nodiscard]] bool step() {
        if (options_.max_steps > 0 && report_.steps == options_.max_steps)
            return fail(ARK_TOO_MUCH_WORK);
        is_fixed() ? stay_on_grid() : limit_step();
        double reached = now_.time;
        system_.forget_fault();
        context_.forget_message();
        ran_ = true;
        code_ = evolve(reached);
        if (code_ < 0) return fail(code_);
        take_state(reached);
        if (jumps_.ends(now_)) now_.time = schedule_.end;
        double length = 0.0;
        ANCF_ARKODE(GetLastStep)(erk_.get(), &length);
        return record(length, [this](double time) { return between(time); }) && remains_stable();
    }

    // Lets the next step end on the grid of fixed steps, which their sum would leave.
    void stay_on_grid() {
        const double point = start_.time + (report_.steps + 1.0) * fixed_step_;
        const double end = point < schedule_.end - 1e-9 * fixed_step_ ? point : schedule_.end;
        if (end > now_.time) call(ANCF_ARKODE(SetFixedStep)(erk_.get(), end - now_.time));
    }

    // Lets the next step end at a jump or a corner of a load or a drive; at a jump it begins anew
    // behind it.
    void limit_step() {
        double next = first_step_;
        if (ran_) ANCF_ARKODE(GetCurrentStep)(erk_.get(), &next);
        const auto end = [&] { return std::min(now_.time + next, schedule_.end); };
        const auto look = [&] { jumps_.look(now_, end()); };
        for (look(); jumps_.passes(now_, start_, first_step_, report_); look()) {
            a_ = start_.acceleration;
            restart(next = first_step_);
        }
        const double corner = jumps_.corner(now_.time, end(), options_.tolerance);
        const double stop = stop_time();
        call(ANCF_ARKODE(SetStopTime)(erk_.get(), corner < end() ? std::min(corner, stop) : stop));
    }

    [[nodiscard]] double stop_time() const {
        return jumps_.is_ahead(now_) ? std::min(jumps_.next(), schedule_.end) : schedule_.end;
    }

    // Takes a step; where an element fails, smaller ones, which ARKODE does not try by itself.
    [[nodiscard]] int evolve(double& reached) {
        constexpr int most = 12;
        for (int attempt = 0;; ++attempt) {
            const int code =
                ANCF_ARKODE(Evolve)(erk_.get(), schedule_.end, y_.get(), &reached, ARK_ONE_STEP);
            system_.rethrow();
            if (arkode_status(code) != Status::not_finite || is_fixed() || attempt == most)
                return code;
            double tried = 0.0;
            ANCF_ARKODE(GetCurrentStep)(erk_.get(), &tried);
            ++report_.convergence_failures;
            restart(0.25 * tried);
        }
    }

    // Begins anew at the last state with a step of its own.
    void restart(double step) {
        void* erk = erk_.get();
        long count = 0;
        ANCF_ARKODE(GetNumErrTestFails)(erk, &count);
        earlier_rejected_ += count;
        ANCF_ARKODE(GetNumExpSteps)(erk, &count);
        earlier_limited_ += count;
        auto y = view(y_.get());
        system_.q(y) = now_.q;
        system_.v(y) = now_.v;
        call(ERKStepReInit(erk, &ExplicitSystem::rate, now_.time, y_.get()));
        call(ANCF_ARKODE(SetStopTime)(erk, stop_time()));
        if (!is_fixed()) call(ANCF_ARKODE(SetInitStep)(erk, step));
    }

    // Takes the end of a step into now_.
    void take_state(double time) {
        if (schedule_.observe) {
            std::swap(from_, now_);
            from_a_.swap(a_);
            call(ANCF_ARKODE(GetDky)(erk_.get(), time, 1, dense_.get()));
            a_ = system_.v(view(dense_.get()));
        }
        const auto y = view(y_.get());
        now_.time = time;
        now_.q = system_.q(y);
        now_.v = system_.v(y);
    }

    // Quintic of q, v and a at both ends, and its derivative.
    [[nodiscard]] MotionPoint between(double time) const {
        MotionPoint at{time, {}, {}, {}};
        ancf::detail::interpolate(
            {{from_.time, from_.q, from_.v, from_a_}, {now_.time, now_.q, now_.v, a_}}, time, at.q,
            at.v);
        return at;
    }

    bool fail(int code) {
        // a fault in an attempt that ARKODE got over is not to blame
        if (arkode_status(code) == Status::not_finite || code == ARK_CONV_FAILURE)
            report_.fault = system_.fault();
        return SteppedRun::fail(code, arkode_status(code), options_.max_steps);
    }

    const ExplicitOptions& options_;
    const ErkTable& table_;
    ExplicitReport report_;

    ExplicitSystem system_;
    VectorOwner y_, tolerances_, dense_;
    std::unique_ptr<void, Destroy<ANCF_ARKODE(Free)>> erk_;

    double fixed_step_ = 0.0;  // s: options_.step, shortened
    double first_step_ = 0.0;  // s, where steps are not fixed
    Revision revision_;        // of the scene that the stable step is of
    bool ran_ = false;
    VectorX a_;         // at now_
    MotionPoint from_;  // where the step that led there began
    VectorX from_a_;
    long earlier_rejected_ = 0, earlier_limited_ = 0;  // before the last restart
};

}  // namespace detail

ANCF_INLINE void ExplicitOptions::check() const {
    detail::check_options("ExplicitOptions", tolerance, max_steps,
                          {{"step", step},
                           {"length_scale", length_scale},
                           {"velocity_scale", velocity_scale},
                           {"first_step", first_step},
                           {"max_step", max_step}});
    ancf::detail::require(stable_share > 0.0 && stable_share < 1.0,
                          "ExplicitOptions: stable_share must be between 0 and 1, got ",
                          stable_share);
    ancf::detail::require(stable_interval > 0,
                          "ExplicitOptions: stable_interval must be positive, got ",
                          stable_interval);
}

ANCF_INLINE ExplicitReport Explicit::integrate(DynamicProblem& problem,
                                               const Schedule& schedule) const {
    ancf::detail::require(
        problem.multipliers() == 0, "Explicit: the scene has constraints with ",
        problem.multipliers(),
        " multipliers, which ARKODE's methods do not take; integrate by Leapfrog, RadauIIA or Ida, "
        "or join by supports, by polyline and by Scene::attach, which have no multipliers");
    ancf::detail::require_motion(problem, schedule);
    const double from = problem.model().state().time;
    if (options().step > 0.0 && schedule.end > from)
        ancf::detail::require_resolved(options().step, from, schedule.end);
    return detail::ExplicitRun(problem, schedule, options()).run();
}

}  // namespace ancf::sundials

#undef ANCF_ARKODE
