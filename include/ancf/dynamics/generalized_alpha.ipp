// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of generalized_alpha.hpp: one run of the method.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/recorder.hpp>
#include <ancf/error.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace ancf {
namespace detail {

/// One run.
class GeneralizedAlphaRun {
public:
    GeneralizedAlphaRun(DynamicProblem& problem, LinearSolver& solver, const Schedule& schedule,
                        const GeneralizedAlphaOptions& options, DynamicsReport& report);

    void run(const Memory& memory);

private:
    // The end of a step: accelerations v' and algorithmic accelerations a.
    struct Point : MotionPoint {
        VectorX acceleration, algorithmic;
    };

    enum class Ends { within, on_grid, off_grid };  // within a step that is taken in parts
    struct Step {
        double width, end;
        Ends ends;
    };

    static constexpr double smallest_part = 1e-3;  // of a fixed step that fails
    static constexpr double farthest = 1.0;        // of corrections that grow: a slope's length

    [[nodiscard]] bool begin(const Memory& memory);
    void read(const Memory& memory);
    void recall(const Memory& memory);
    void remember();
    [[nodiscard]] Step propose() const;
    [[nodiscard]] bool advance();
    void shift_algorithmic(double width);
    [[nodiscard]] Status newton(double h);
    [[nodiscard]] Status iterate(double h, bool renew);
    [[nodiscard]] Status evaluate(const MotionPoint& at, Request request);
    [[nodiscard]] Status factorise(double h);
    void predict(double h);
    void correct(double h);
    [[nodiscard]] std::string turn_text(const DrivenTurn& turn) const {
        return driven_turn_text(problem_.model().constraints(), turn, now_.time, next_.time);
    }
    [[nodiscard]] double scaled(const VectorX& q) const { return problem_.largest_ratio(q); }
    [[nodiscard]] double change_of_acceleration() const {
        return problem_.largest_distance(next_.acceleration, now_.acceleration);
    }
    void fail(Status status, std::string message) {
        report_.status = status;
        report_.message = std::move(message);
        if (!failure_.empty()) report_.message += "; " + failure_;
        if (report_.fault) report_.message += "; " + problem_.assembly().describe(*report_.fault);
    }

    DynamicProblem& problem_;
    LinearSolver& solver_;
    const Schedule& schedule_;
    const GeneralizedAlphaOptions& options_;
    DynamicsReport& report_;
    Recorder recorder_;

    // the method's parameters
    double am_, af_, beta_, gamma_, offset_;  // a_n belongs to t_n + offset h
    double beta_hat_, gamma_hat_;             // dq = h^2 beta_hat dv', dv = h gamma_hat dv'
    double error_constant_;                   // local error = it h^2 (v'_1 - v'_0)

    Point now_, next_;
    double origin_ = 0.0, count_ = 0.0, step_ = 0.0;  // grid of steps: origin + count step
    double whole_ = 0.0;                              // s, from the start to the schedule's end
    double part_ = 0.0;                               // of a step that failed; 0: whole steps
    int parts_ = 1;                  // into which the turn of a joint divides the step
    double width_ = 0.0;             // step that now_.algorithmic belongs to
    MotionPoint linearised_;         // where the factorised matrix was evaluated
    double linearised_width_ = 0.0;  // its step; 0: there is no matrix

    SparseMatrix system_;
    std::vector<char> stiff_;  // per value: 1 in the block of coordinates, 0 elsewhere
    VectorX product_, rhs_, solution_;
    std::string failure_;  // of the solver, in words
};

ANCF_INLINE GeneralizedAlphaRun::GeneralizedAlphaRun(DynamicProblem& problem, LinearSolver& solver,
                                                     const Schedule& schedule,
                                                     const GeneralizedAlphaOptions& options,
                                                     DynamicsReport& report)
    : problem_(problem),
      solver_(solver),
      schedule_(schedule),
      options_(options),
      report_(report),
      recorder_(problem, schedule, report, options.follow_energy),
      am_((2.0 * options.rho - 1.0) / (options.rho + 1.0)),
      af_(options.rho / (options.rho + 1.0)),
      gamma_(0.5 + af_ - am_),
      offset_(am_ - af_),
      system_(problem.mass()),
      stiff_(static_cast<std::size_t>(detail::entries(system_))) {
    beta_ = 0.25 * (gamma_ + 0.5) * (gamma_ + 0.5);
    beta_hat_ = beta_ * (1.0 - af_) / (1.0 - am_);
    gamma_hat_ = gamma_ * (1.0 - af_) / (1.0 - am_);
    error_constant_ = std::abs(beta_ + 0.5 * offset_ - 1.0 / 6.0);
    const int n = problem.size();
    for (int j = 0; j < system_.outerSize(); ++j)
        for (int k = system_.outerIndexPtr()[j]; k < system_.outerIndexPtr()[j + 1]; ++k)
            stiff_[static_cast<std::size_t>(k)] = j < n && system_.innerIndexPtr()[k] < n;
    solver_.analyze(system_);
}

ANCF_INLINE void GeneralizedAlphaRun::run(const Memory& memory) {
    if (!begin(memory)) return;
    recorder_.start(now_);
    while (goes_on(now_, schedule_.end, std::min(step_, whole_)) && advance()) {
        std::swap(now_, next_);
        if (!goes_on(now_, schedule_.end, std::min(step_, whole_))) now_.time = schedule_.end;
        if (recorder_.step(next_, now_)) continue;
        fail(Status::stopped, "the progress callback asked to stop");
        break;
    }
    recorder_.finish(now_);
    remember();
}

ANCF_INLINE bool GeneralizedAlphaRun::begin(const Memory& memory) {
    const Start start = problem_.start();
    report_.time = start.time;
    ++report_.evaluations;
    if (start.status != Status::converged) {
        fail(start.status, start.message);
        return false;
    }
    static_cast<MotionPoint&>(now_) = {start.time, start.q, start.v, start.multipliers};
    now_.acceleration = now_.algorithmic = start.acceleration;
    origin_ = start.time;
    whole_ = schedule_.end - start.time;
    step_ = options_.tolerance > 0.0 ? std::min(options_.step, options_.max_step) : options_.step;
    width_ = whole_ > 0.0 ? std::min(step_, whole_) : step_;
    if (!memory.empty()) {
        recall(memory);
    } else if (offset_ != 0.0) {
        // a_0 belongs to t_0 + offset h; with a_0 = v'_0 the first steps would be of first order
        VectorX jerk;
        if (problem_.jerk(start, 1e-3 * width_, jerk) == Status::converged)
            now_.algorithmic += offset_ * width_ * jerk;
        report_.evaluations += 4;
    }
    next_ = now_;
    return true;
}

/// Returns the step to the next point of the grid, or to the schedule's end if that comes first;
/// where steps are divided, the next part of it.
ANCF_INLINE GeneralizedAlphaRun::Step GeneralizedAlphaRun::propose() const {
    const double grid = origin_ + (count_ + 1.0) * step_;
    const bool on_grid = schedule_.end >= grid - 1e-9 * step_;
    const double end = on_grid ? grid : schedule_.end, rest = end - now_.time;
    if (part_ > 0.0 && rest > part_ * (1.0 + 1e-6)) return {part_, now_.time + part_, Ends::within};
    const bool full = on_grid && std::abs(rest - step_) <= 1e-6 * step_;
    return {full ? step_ : rest, end, on_grid ? Ends::on_grid : Ends::off_grid};
}

/// Takes one step into next_, again with smaller ones where the run is adaptive, and in parts where
/// it is not.
ANCF_INLINE bool GeneralizedAlphaRun::advance() {
    const bool adaptive = options_.tolerance > 0.0;
    for (;;) {
        const Step step = propose();
        shift_algorithmic(step.width);
        next_.time = step.end;
        const auto& constraints = problem_.model().constraints();
        const DrivenTurn turn = driven_turn(constraints, now_.time, next_.time);
        if (!turn.fits() && !adaptive && part_ == 0.0) {
            parts_ = parts_for_turns(constraints, now_.time, next_.time);
            part_ = step.width / parts_;
            if (part_ < step.width) continue;
        }
        const Status status = turn.fits() ? newton(step.width) : Status::diverged;
        double error = 0.0;
        if (status == Status::converged && adaptive)
            error = error_constant_ * step.width * step.width * change_of_acceleration() /
                    options_.tolerance;
        const double factor = 0.85 / std::cbrt(std::max(error, 1e-3));
        if (status == Status::converged && error <= 1.0) {
            width_ = step.width;
            if (step.ends == Ends::within) return true;
            part_ = 0.0;
            parts_ = 1;
            count_ += 1.0;
            // a step keeps its width, and the matrix, unless a change is worth it
            const bool change = adaptive && step.width == step_ && (factor < 0.95 || factor > 1.4);
            if (change) step_ = std::min(step_ * std::min(factor, 2.0), options_.max_step);
            if (change || step.ends == Ends::off_grid) {
                origin_ = next_.time;
                count_ = 0.0;
            }
            return true;
        }
        if (turn.fits())
            status == Status::converged ? ++report_.rejected : ++report_.convergence_failures;
        if (!adaptive) {
            part_ = 0.5 * step.width;
            if (parts_ * part_ > smallest_part * step_) continue;
            fail(status,
                 turn.fits()
                     ? joined({"Newton's method failed in the step from ", now_.time,
                               " s: ", to_string(status), ", also in parts of ", step.width,
                               " s; a shorter step or adaptive steps (tolerance > 0) may pass"},
                              6)
                     : turn_text(turn));
            return false;
        }
        step_ = step.width * (status == Status::converged ? std::max(0.2, factor) : 0.25);
        origin_ = now_.time;
        count_ = 0.0;
        if (step_ >= options_.min_step) continue;
        fail(Status::step_too_small,
             joined({"the step fell below ", options_.min_step, " s at ", now_.time, " s, last of ",
                     status == Status::converged ? "the local error" : to_string(status)},
                    6) +
                 (turn.fits() ? "" : "; " + turn_text(turn)));
        return false;
    }
}

/// Moves the algorithmic acceleration to the time that belongs to another step.
///
/// a_n stands for v'(t_n + offset h): without the shift a change of h costs an order.
ANCF_INLINE void GeneralizedAlphaRun::shift_algorithmic(double width) {
    if (width == width_) return;
    now_.algorithmic = now_.acceleration + width / width_ * (now_.algorithmic - now_.acceleration);
    width_ = width;
}

/// Solves one step by Newton's method.
///
/// A stiff body that has turned since the matrix at hand was made can be thrown far off by it: the
/// step then starts again, with a matrix of its own.
ANCF_INLINE Status GeneralizedAlphaRun::newton(double h) {
    if (linearised_width_ == h && iterate(h, false) == Status::converged) return Status::converged;
    return iterate(h, true);
}

/// Iterates from the prediction, with a new matrix or the one at hand.
///
/// A matrix, of an earlier step or iterate, stays while it converges fast enough.
ANCF_INLINE Status GeneralizedAlphaRun::iterate(double h, bool renew) {
    const int n = problem_.size();
    const int m = problem_.multipliers();
    predict(h);
    rhs_.resize(n + m);
    bool fresh = false;  // whether the matrix is of this step
    double before = 0.0;
    for (int k = 1; k <= options_.max_iterations; ++k) {
        if (const Status status =
                evaluate(next_, renew ? Request::tangent_and_damping : Request::force);
            status != Status::converged)
            return status;
        if (renew) {
            if (const Status status = factorise(h); status != Status::converged) return status;
            fresh = true;
        }
        product_ = -problem_.force();
        problem_.add_mass_product(-1.0, next_.acceleration, product_);
        rhs_.head(n) = product_;
        rhs_.tail(m) = problem_.constraint_residual() / (-h * h * beta_hat_);
        solver_.solve(rhs_, solution_);
        failure_ = solver_.failure();
        ++report_.iterations;
        correct(h);
        const double change = h * h * beta_hat_ * scaled(solution_.head(n));
        if (!std::isfinite(change)) return Status::not_finite;
        // far below the local error of the step, however short it is
        const double local = h * h * beta_hat_ * change_of_acceleration();
        const double wanted = std::min(options_.newton_tolerance, std::max(1e-3 * local, 1e-16));
        // what is left is known from two corrections by one matrix; one alone tells nothing
        const double ratio = k > 1 ? change / before : 1.0;
        const bool measured = k > 1 && !renew && ratio < 0.5;
        const double left = measured ? std::max(ratio, 1e-4) / (1.0 - ratio) * change : change;
        // at the round-off of the residual the corrections no longer shrink
        const bool small = change <= 1e3 * options_.newton_tolerance;
        if (left <= wanted || (k > 1 && ratio >= 1.0 && small)) return Status::converged;
        if (ratio > 1.0 && (!fresh || change > farthest)) return Status::diverged;
        // so slow that a new matrix is cheaper
        const bool slow = std::log(wanted / change) / std::log(ratio) > 4.0;
        renew = k > 1 && (ratio > 0.9 || (slow && !(small && fresh)));
        before = change;
    }
    return Status::max_iterations;
}

ANCF_INLINE Status GeneralizedAlphaRun::evaluate(const MotionPoint& at, Request request) {
    ++report_.evaluations;
    report_.fault = problem_.evaluate(at.time, at.q, at.v, at.lambda, request);
    return report_.fault ? report_.fault->status : Status::converged;
}

/// Builds [M + h gamma_hat D + h^2 beta_hat K, G^T; G, 0] from the last evaluation and factorises
/// it.
ANCF_INLINE Status GeneralizedAlphaRun::factorise(double h) {
    const double* mass = problem_.mass().valuePtr();
    const double* tangent = problem_.tangent().valuePtr();
    const double* damping = problem_.damping().valuePtr();
    double* system = system_.valuePtr();
    const double share = h * h * beta_hat_;  // of the stiffness, to every digit at any step
    const char* stiff = stiff_.data();
    for (Eigen::Index k = 0; k < detail::entries(system_); ++k)
        system[k] =
            mass[k] + (stiff[k] != 0 ? share : 1.0) * tangent[k] + h * gamma_hat_ * damping[k];
    ++report_.jacobians;
    ++report_.factorisations;
    const Status status = solver_.factorize(system_).status;
    failure_ = solver_.failure();
    linearised_ = next_;
    linearised_width_ = status == Status::converged ? h : 0.0;
    return status;
}

/// Starts from the accelerations of the step's start.
ANCF_INLINE void GeneralizedAlphaRun::predict(double h) {
    next_.lambda = now_.lambda;
    next_.acceleration = now_.acceleration;
    next_.algorithmic = (now_.acceleration - am_ * now_.algorithmic) / (1.0 - am_);
    next_.q = now_.q + h * now_.v + h * h * (0.5 - beta_) * now_.algorithmic +
              h * h * beta_ * next_.algorithmic;
    next_.v = now_.v + h * (1.0 - gamma_) * now_.algorithmic + h * gamma_ * next_.algorithmic;
}

/// Adds the solution (dv', dlambda).
ANCF_INLINE void GeneralizedAlphaRun::correct(double h) {
    const VectorX change = solution_.head(problem_.size());
    next_.acceleration += change;
    next_.algorithmic += (1.0 - af_) / (1.0 - am_) * change;
    next_.q += h * h * beta_hat_ * change;
    next_.v += h * gamma_hat_ * change;
    next_.lambda += solution_.tail(problem_.multipliers());
}

ANCF_INLINE void GeneralizedAlphaRun::remember() {
    Memory& memory = report_.memory;
    memory.integrator = "generalized_alpha";
    memory.put("q", now_.q);
    memory.put("v", now_.v);
    memory.put("lambda", now_.lambda);
    memory.put("acceleration", now_.acceleration);
    memory.put("algorithmic", now_.algorithmic);
    VectorX scalars(9);
    scalars << now_.time, origin_, count_, step_, width_, linearised_.time, linearised_width_,
        options_.rho, problem_.length_scale();
    memory.put("scalars", scalars);
    memory.put("signature", signature(problem_, now_));
    if (linearised_width_ == 0.0) return;
    memory.put("linearised_q", linearised_.q);
    memory.put("linearised_v", linearised_.v);
    memory.put("linearised_lambda", linearised_.lambda);
}

/// Takes the end of the run that goes on into now_, and where its matrix was made into next_.
ANCF_INLINE void GeneralizedAlphaRun::read(const Memory& memory) {
    const int n = problem_.size();
    const int m = problem_.multipliers();
    require(memory.integrator == "generalized_alpha", "GeneralizedAlpha: the memory is that of ",
            memory.integrator);
    const VectorX& scalars = memory.get("scalars", 9);
    require(std::abs(scalars[0] - now_.time) <= 1e-12 * std::abs(now_.time) + 1e-9 * scalars[3],
            "GeneralizedAlpha: the memory is of time ", scalars[0], " s, the model of ", now_.time,
            " s");
    require(scalars[7] == options_.rho, "GeneralizedAlpha: the memory is of rho ", scalars[7],
            ", the options have ", options_.rho);
    problem_.set_length_scale(scalars[8]);
    static_cast<MotionPoint&>(now_) = {scalars[0], memory.get("q", n), memory.get("v", n),
                                       memory.get("lambda", m)};
    now_.acceleration = memory.get("acceleration", n);
    now_.algorithmic = memory.get("algorithmic", n);
    if (scalars[6] == 0.0) return;
    static_cast<MotionPoint&>(next_) = {scalars[5], memory.get("linearised_q", n),
                                        memory.get("linearised_v", n),
                                        memory.get("linearised_lambda", m)};
}

ANCF_INLINE void GeneralizedAlphaRun::recall(const Memory& memory) {
    const MotionPoint start = now_;
    together(problem_.model().exchange(), [&] { read(memory); });
    require_continuation("GeneralizedAlpha", memory, problem_, start, now_);
    const VectorX& scalars = memory.get("scalars", 9);
    width_ = scalars[4];
    origin_ = now_.time;
    if (options_.tolerance > 0.0 || scalars[3] == options_.step) {
        origin_ = scalars[1];
        count_ = scalars[2];
        step_ = scalars[3];
    }
    if (options_.tolerance > 0.0 && step_ > options_.max_step) {
        step_ = options_.max_step;
        origin_ = now_.time;
        count_ = 0.0;
    }
    if (scalars[6] == 0.0) return;
    if (evaluate(next_, Request::tangent_and_damping) == Status::converged)
        (void)factorise(scalars[6]);  // where it fails the first step builds one of its own
}

}  // namespace detail

ANCF_INLINE void GeneralizedAlphaOptions::check() const {
    detail::require(rho >= 0.0 && rho <= 1.0,
                    "GeneralizedAlphaOptions: rho must be from 0 to 1, got ", rho);
    detail::require_positive("GeneralizedAlphaOptions: step", step);
    detail::require(
        std::isfinite(tolerance) && tolerance >= 0.0,
        "GeneralizedAlphaOptions: tolerance must be positive, or 0 for fixed steps, got ",
        tolerance);
    detail::require_positive("GeneralizedAlphaOptions: min_step", min_step);
    detail::require(max_step >= min_step,
                    "GeneralizedAlphaOptions: max_step must be at least min_step, ", min_step,
                    ", got ", max_step);
    detail::require_positive("GeneralizedAlphaOptions: newton_tolerance", newton_tolerance);
    detail::require(max_iterations >= 1,
                    "GeneralizedAlphaOptions: max_iterations must be at least 1, got ",
                    max_iterations);
}

ANCF_INLINE DynamicsReport GeneralizedAlpha::integrate(DynamicProblem& problem,
                                                       LinearSolver& solver,
                                                       const Schedule& schedule,
                                                       const Memory& memory) const {
    detail::require_same_storage(solver, problem);
    detail::require_motion(problem, true);
    schedule.check(problem.model().state().time);
    detail::require_resolved(options_.step, problem.model().state().time, schedule.end);
    DynamicsReport report;
    detail::GeneralizedAlphaRun(problem, solver, schedule, options_, report).run(memory);
    return report;
}

}  // namespace ancf
