// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/dynamics/constraint_manifold.hpp>
#include <ancf/dynamics/frequency.hpp>
#include <ancf/dynamics/leapfrog.hpp>
#include <ancf/dynamics/motion_run.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace ancf {
namespace detail {

/// One run. Q and V are what the steps move, q and v the motion.
class LeapfrogRun {
public:
    LeapfrogRun(DynamicProblem& problem, const Schedule& schedule, const LeapfrogOptions& options,
                LeapfrogReport& report)
        : problem_(problem),
          schedule_(schedule),
          options_(options),
          report_(report),
          recorder_(problem, schedule, report, options.follow_energy) {}

    void run() {
        if (!begin()) return;
        recorder_.start(now_);
        bool good = has_changed() ? renew() : fill_anew();
        while (good && goes_on() && advance()) {
            if (is_observed()) complete(now_, at_, at_.kick);
            if (!recorder_.step(earlier_, now_, [this](double time) { return between(time); }))
                break;
            if (has_changed()) {
                good = !goes_on() || renew();
                continue;
            }
            if (++since_ < interval_ && goes_on()) continue;
            estimate();
            good = is_stable();
        }
        complete(now_, at_, at_.kick);
        recorder_.finish(now_);
    }

private:
    // A moved place with s = -a(t, Q) and the kick -a(t, q).
    struct Place {
        VectorX Q, V, s, kick;
    };
    // With constraints s is tangential, the kick is M^-1 (r + G^T lambda).
    struct Moved : Place {
        VectorX lambda;
        TangentSpace at_Q, at_q;
    };

    static constexpr int most_attempts = 12;             // between two estimates, each half as long
    static constexpr double reach = 3.4641016151377544;  // sqrt(12), the largest stable h w

    [[nodiscard]] bool begin() {
        Start start = start_run(problem_, report_);
        if (start.status != Status::converged) return false;
        revision_ = problem_.model().revision();
        const double motion = problem_.motion_frequency(start);
        if (motion > 0.0) least_stable_ = reach / motion;
        now_ = {start.time, std::move(start.q), std::move(start.v), std::move(start.multipliers)};
        at_.kick = -start.acceleration;
        none_ = VectorX::Zero(problem_.multipliers());
        if (!read_constraints()) return false;
        estimate();
        if (report_.status != Status::converged) return false;
        require_no_damping();
        // what has no stiffness where it starts gets it as it moves
        const double ahead =
            std::min(options_.stable_share * least_stable_, schedule_.end - now_.time);
        const double later = problem_.highest_frequency(
            now_.time, now_.q + ahead * (now_.v - 0.5 * ahead * at_.kick), now_.lambda, fastest_);
        if (later > 0.0) least_stable_ = std::min(least_stable_, reach / later);
        return true;
    }

    /// Reads mass and constraints for the motion at hand; false where they depend on each other.
    [[nodiscard]] bool read_constraints() {
        at_.lambda = now_.lambda;
        manifold_.emplace(problem_);
        if (manifold_->find(now_.time, now_.q, at_.at_q)) return true;
        return fail(Status::singular,
                    joined({"the constraints depend on each other at ", now_.time, " s"}));
    }

    /// A kick takes forces where the rates are not known yet: refuses those that depend on rates.
    void require_no_damping() {
        const State at = problem_.raw_state(now_.time, now_.q, now_.v);
        const double frequency = report_.highest_frequency > 0.0 ? report_.highest_frequency : 1.0;
        const VectorX others =
            at.v + frequency * scattered(problem_.scales_of(problem_.length_scale()), 0);
        const int load = problem_.assembly().damping_load(at.q, at.v, others, at.time);
        require(load < 0, "Leapfrog: the force of load ", load,
                " depends on rates, as damping does; integrate by sundials::Explicit, RadauIIA or "
                "GeneralizedAlpha");
    }

    /// Estimates the highest frequency; where an element fails the last estimate stays.
    void estimate() {
        since_ = 0;
        ++report_.jacobians;
        const double before = report_.highest_frequency;
        const double now = problem_.highest_frequency(now_.time, now_.q, at_.lambda, fastest_);
        if (now > 0.0) report_.highest_frequency = now;
        std::string failed;
        if (std::isnan(now) || report_.highest_frequency == 0.0)  // it may be that nothing vibrates
            if (const auto fault =
                    problem_.evaluate(now_.time, now_.q, now_.v, at_.lambda, Request::tangent)) {
                report_.fault = fault;
                failed = problem_.assembly().describe(*fault);
                fail(fault->status, failed);
            }
        if (std::isnan(now))
            fail(Status::not_finite,
                 joined({"the highest frequency of stiffness and mass is no number at ", now_.time,
                         failed.empty() ? " s" : " s; ", failed}));
        report_.stable_step = report_.highest_frequency > 0.0
                                  ? reach / report_.highest_frequency
                                  : std::numeric_limits<double>::infinity();
        least_stable_ = std::min(least_stable_, report_.stable_step);
        // between two estimates the frequency is to rise by 2 % at most
        const double rise = now / before - 1.0;  // NaN or infinite at the start
        const double longer = rise > 0.01 ? std::max(0.02 / rise, 0.1) : 2.0;
        interval_ = static_cast<int>(std::clamp(std::floor(interval_ * longer), 1.0,
                                                static_cast<double>(options_.stable_interval)));
        attempts_ = 0;
    }

    [[nodiscard]] bool has_changed() const { return !(problem_.model().revision() == revision_); }

    /// Goes on with a scene that an observer has changed.
    [[nodiscard]] bool renew() {
        revision_ = problem_.model().revision();
        changes_ = true;
        if (!evaluate(now_.time, now_.q, now_.lambda, at_.kick))
            return fail(report_.fault->status, problem_.assembly().describe(*report_.fault));
        if (!read_constraints()) return false;
        least_stable_ = std::numeric_limits<double>::infinity();
        estimate();
        return fill_anew();
    }

    /// Divides what is left of the run into equal steps of at most a width; false where max_steps
    /// are too few, or time does not resolve them.
    [[nodiscard]] bool fill(double step) {
        const double rest = schedule_.end - now_.time;
        origin_ = now_.time;
        count_ = 0.0;
        steps_ = std::max(1.0, std::ceil(rest / step - 1e-9));
        step_ = rest / steps_;
        if (steps_ > 1.0 && step_ <= time_resolution(origin_, schedule_.end))
            return fail(Status::step_too_small,
                        joined({"a stable step of ", step_,
                                " s is below the resolution of time at ", origin_, " s"}));
        if (options_.max_steps == 0 ||
            steps_ <= static_cast<double>(options_.max_steps - report_.steps))
            return true;
        return fail(Status::max_iterations,
                    joined({"at ", now_.time, " s the rest of the run takes ", steps_, " steps of ",
                            step_, " s, as the scene vibrates at up to ", report_.highest_frequency,
                            " rad/s, and max_steps is ", options_.max_steps,
                            "; a stiff scene is one for RadauIIA"}));
    }

    [[nodiscard]] bool fill_anew() {
        return fill(is_fixed() ? options_.step : options_.stable_share * least_stable_) &&
               is_stable();
    }

    /// Tells whether the step is below the stable one; chooses it anew where the margin has
    /// changed.
    [[nodiscard]] bool is_stable() {
        if (report_.status != Status::converged) return false;
        const double stable = report_.stable_step, most = options_.stable_share * least_stable_;
        if (step_ > stable)
            return fail(
                Status::diverged,
                joined({"the step of ", step_, " s is above the stable one of ", stable, " s at ",
                        now_.time, " s",
                        is_fixed() ? "" : "; a smaller stable_share or stable_interval may pass"}));
        const bool suits =
            step_ <= std::min(1.1 * most, 0.5 * (most + stable)) && step_ >= 0.5 * most;
        return is_fixed() || suits || !goes_on() || fill(most);
    }

    [[nodiscard]] bool binds() const { return problem_.multipliers() > 0; }

    /// Evaluates s = M^-1 (r + G^T lambda); false where an element fails.
    [[nodiscard]] bool evaluate(double time, const VectorX& q, const VectorX& lambda, VectorX& s) {
        ++report_.evaluations;
        report_.fault = problem_.evaluate(time, q, now_.v, lambda, Request::force);
        if (report_.fault) return false;
        problem_.solve_mass(problem_.force(), s);
        return true;
    }

    /// Evaluates s = -a(t, q) of a scene at rest; false where an element fails.
    [[nodiscard]] bool rest(double time, const VectorX& q, const TangentSpace& at, VectorX& lambda,
                            VectorX& s) {
        if (!evaluate(time, q, lambda, s)) return false;
        manifold_->project(at, none_, s, &lambda);
        return true;
    }

    /// Finds ds/dt at a place by two forces ahead of it, or behind where the part is negative.
    [[nodiscard]] bool find_rate(double part, double time, const VectorX& q, const VectorX& v,
                                 const VectorX& s, const TangentSpace& at) {
        VectorX first, second;
        const auto along = [&](double later, VectorX& there) {
            VectorX rate = v - 0.5 * later * s, lambda = none_;
            VectorX place = q;
            TangentSpace to;
            return manifold_->drift(time, later, at, place, rate, to) &&
                   rest(time + later, place, to, lambda, there);
        };
        if (!along(part, first) || !along(2.0 * part, second)) return false;
        s_rate_ = (4.0 * first - 3.0 * s - second) / (2.0 * part);
        return true;
    }

    /// Finds Q and V of the motion at hand for the step that begins.
    [[nodiscard]] bool enter() {
        manifold_->project(at_.at_q, none_, at_.kick, &at_.lambda);
        at_.s = at_.kick;
        // forward: a load may begin here
        if (!find_rate(step_ / 16.0, now_.time, now_.q, now_.v, at_.s, at_.at_q)) return false;
        const double share = step_ * step_ / 12.0;
        at_.V = now_.v - share * s_rate_;
        VectorX lambda = at_.lambda;  // that of the kick stays
        for (int k = 0; k < 2; ++k) {
            at_.Q = now_.q + share * at_.s;
            if (!manifold_->bring(now_.time, at_.at_q, at_.Q, at_.at_Q) ||
                !rest(now_.time, at_.Q, at_.at_Q, lambda, at_.s))
                return false;
        }
        manifold_->project(at_.at_Q, at_.at_Q.rate, at_.V);
        return true;
    }

    /// Tells whether joints are driven so little in a step that it can only end in the right turn.
    [[nodiscard]] bool turns_little() {
        report_.fault.reset();
        const List<AnyConstraint>& all = problem_.model().constraints();
        const DrivenTurn turn = driven_turn(all, now_.time, next_.time);
        reason_ = turn.fits() ? "Newton's method does not reach the constraints"
                              : driven_turn_text(all, turn, now_.time, next_.time);
        return turn.fits();
    }

    /// Takes a step into next_; false where an element fails or the constraints are not reached.
    [[nodiscard]] bool take_step() {
        const double h = step_, share = h * h / 12.0;
        next_.time = count_ + 1.0 < steps_ ? origin_ + (count_ + 1.0) * h : schedule_.end;
        if (binds() && !turns_little()) return false;
        if (count_ == 0.0 && !enter()) return false;
        moved_.V = at_.V - 0.5 * h * at_.kick;
        moved_.Q = at_.Q;
        moved_.lambda = at_.lambda;
        if (!manifold_->drift(now_.time, h, at_.at_Q, moved_.Q, moved_.V, moved_.at_Q) ||
            !rest(next_.time, moved_.Q, moved_.at_Q, moved_.lambda, moved_.s))
            return false;
        next_.q = moved_.Q - share * moved_.s;
        if (!manifold_->bring(next_.time, moved_.at_Q, next_.q, moved_.at_q) ||
            !evaluate(next_.time, next_.q, moved_.lambda, moved_.kick))
            return false;
        moved_.V -= 0.5 * h * moved_.kick;
        manifold_->project(moved_.at_Q, moved_.at_Q.rate, moved_.V);
        // of second order, which is fourth in v; closer where steps may begin anew, or its error
        // would excite the fastest vibrations at every beginning
        const bool ends =
            changes_ || count_ + 1.0 == steps_ || (!is_fixed() && since_ + 1 == interval_);
        if (ends) {
            if (!find_rate(-h / 16.0, next_.time, moved_.Q, moved_.V, moved_.s, moved_.at_Q))
                return false;
        } else if (count_ == 0.0) {
            s_rate_ = 2.0 / h * (moved_.s - at_.s) - s_rate_;
        } else {
            s_rate_ = (3.0 * moved_.s - 4.0 * at_.s + s_before_) / (2.0 * h);
        }
        next_.v = moved_.V + share * s_rate_;
        manifold_->project(moved_.at_q, moved_.at_q.rate, next_.v);
        next_.lambda = moved_.lambda;
        return true;
    }

    /// Takes a step, where an element fails a shorter one.
    [[nodiscard]] bool advance() {
        while (!take_step()) {
            ++report_.convergence_failures;
            if (is_fixed() || ++attempts_ == most_attempts)
                return fail(
                    report_.fault ? report_.fault->status : Status::max_iterations,
                    joined({"a step of ", step_, " s from ", now_.time, " s failed; "}) +
                        (report_.fault ? problem_.assembly().describe(*report_.fault) : reason_));
            if (!fill(0.5 * step_)) return false;
        }
        count_ += 1.0;
        std::swap(earlier_, now_);
        std::swap(now_, next_);
        binds() ? std::swap(at_, moved_) : std::swap<Place>(at_, moved_);
        s_before_.swap(moved_.s);
        kick_before_.swap(moved_.kick);
        return true;
    }

    /// Returns -v' of a point, from its kick, and finds its multipliers.
    VectorX complete(MotionPoint& point, const Moved& of, VectorX kick) {
        if (!binds()) return kick;
        problem_.evaluate_constraints(point.time, point.q, point.v);
        point.lambda = of.lambda;
        manifold_->project(of.at_q, -problem_.constraint_convection(), kick, &point.lambda);
        return kick;
    }

    [[nodiscard]] bool is_observed() const {
        const double slack = 1e-9 * step_;
        const auto next =
            std::upper_bound(schedule_.times.begin(), schedule_.times.end(), earlier_.time + slack);
        return schedule_.observe && next != schedule_.times.end() && *next <= now_.time + slack;
    }

    [[nodiscard]] MotionPoint between(double time) {
        MotionPoint at{time, {}, {}, now_.lambda};
        interpolate(
            {{earlier_.time, earlier_.q, earlier_.v, -complete(earlier_, moved_, kick_before_)},
             {now_.time, now_.q, now_.v, -complete(now_, at_, at_.kick)}},
            time, at.q, at.v);
        Moved here;
        if (!binds() || !manifold_->bring(time, at_.at_q, at.q, here.at_q)) return at;
        manifold_->project(here.at_q, here.at_q.rate, at.v);
        here.lambda = none_;
        if (evaluate(time, at.q, none_, here.kick)) (void)complete(at, here, here.kick);
        report_.fault.reset();  // a step can do without
        return at;
    }

    [[nodiscard]] bool is_fixed() const noexcept { return options_.step > 0.0; }
    [[nodiscard]] bool goes_on() const noexcept { return now_.time < schedule_.end; }
    bool fail(Status status, std::string message) {
        report_.status = status;
        report_.message = std::move(message);
        return false;
    }

    DynamicProblem& problem_;
    const Schedule& schedule_;
    const LeapfrogOptions& options_;
    LeapfrogReport& report_;
    Recorder recorder_;
    std::optional<ConstraintManifold> manifold_;
    VectorX none_;        // m zeros
    std::string reason_;  // why a step failed that no element did

    Revision revision_;     // of the scene that the kick is of
    bool changes_ = false;  // whether an observer has changed the scene
    MotionPoint now_, earlier_, next_;
    Moved at_, moved_;                  // of now_, of next_
    VectorX s_before_, kick_before_;    // of earlier_
    VectorX s_rate_;                    // ds/dt at now_
    VectorX fastest_;                   // mode of the highest frequency
    double origin_ = 0.0, step_ = 0.0;  // s, of the grid: origin + count step
    double count_ = 0.0, steps_ = 0.0;  // taken and to be taken of it
    double least_stable_ = std::numeric_limits<double>::infinity();  // s, seen so far
    int since_ = 0, interval_ = 1;  // steps since the last estimate, and to the next one
    int attempts_ = 0;              // that failed since
};

}  // namespace detail

ANCF_INLINE void LeapfrogOptions::check() const {
    detail::require(std::isfinite(step) && step >= 0.0,
                    "LeapfrogOptions: step must be positive, or 0 for automatic, got ", step);
    detail::require(stable_share > 0.0 && stable_share < 1.0,
                    "LeapfrogOptions: stable_share must be between 0 and 1, got ", stable_share);
    detail::require(stable_interval > 0, "LeapfrogOptions: stable_interval must be positive, got ",
                    stable_interval);
    detail::require(max_steps >= 0,
                    "LeapfrogOptions: max_steps must be positive, or 0 for no limit, got ",
                    max_steps);
}

ANCF_INLINE LeapfrogReport Leapfrog::integrate(DynamicProblem& problem,
                                               const Schedule& schedule) const {
    detail::require_motion(problem, schedule);
    const double from = problem.model().state().time;
    if (options().step > 0.0 && schedule.end > from)
        detail::require_resolved(options().step, from, schedule.end);
    LeapfrogReport report;
    detail::LeapfrogRun(problem, schedule, options(), report).run();
    return report;
}

}  // namespace ancf
