// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/motion_run.hpp>
#include <ancf/dynamics/turning_frames.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ancf {
namespace detail {

/// One run.
class GeneralizedAlphaRun : MotionRun {
public:
    GeneralizedAlphaRun(DynamicProblem& problem, LinearSolver& solver, const Schedule& schedule,
                        const GeneralizedAlphaOptions& options)
        : MotionRun(problem, solver, schedule,
                    {options.step, options.tolerance, options.min_step, options.max_step},
                    options.follow_energy, true),
          options_(options),
          am_((2.0 * options.rho - 1.0) / (options.rho + 1.0)),
          af_(options.rho / (options.rho + 1.0)),
          gamma_(0.5 + af_ - am_),
          offset_(am_ - af_),
          frames_(problem.model(), problem.numbering()),
          system_(problem.mass()),
          stiff_(static_cast<std::size_t>(detail::entries(system_))) {
        beta_ = 0.25 * (gamma_ + 0.5) * (gamma_ + 0.5);
        beta_hat_ = beta_ * (1.0 - af_) / (1.0 - am_);
        gamma_hat_ = gamma_ * (1.0 - af_) / (1.0 - am_);
        error_constant_ = beta_ + 0.5 * offset_ - 1.0 / 6.0;
        const int n = problem.size();
        for (int j = 0; j < system_.outerSize(); ++j)
            for (int k = system_.outerIndexPtr()[j]; k < system_.outerIndexPtr()[j + 1]; ++k)
                stiff_[k] = j < n && system_.innerIndexPtr()[k] < n;
        solver_.analyze(system_);
    }

    DynamicsReport run() {
        if (has_started()) {
            begin_anew();
            go();
        }
        return std::move(report_);
    }

    DynamicsReport run(const Memory& memory) {
        if (has_started()) {
            recall_run(memory);
            go();
        }
        return std::move(report_);
    }

private:
    // The end of a step: accelerations v' and algorithmic accelerations a.
    struct Point : MotionPoint {
        VectorX acceleration, algorithmic;
    };

    // What its steps told of the matrix at hand.
    struct Experience {
        double steps = 0.0;        // begun with it
        double contraction = 0.0;  // of its corrections after the second, in the step `told`
        double told = 0.0;         // 0: none
    };

    static constexpr double most_noise = 4.0;   // by which corrections that are round-off grow
    static constexpr double few_steps = 4.0;    // of a matrix that fails too early
    static constexpr double farthest = 1.0;     // of corrections that grow: a slope's length
    static constexpr double round_off = 4e-16;  // of corrections, of a scene at the origin

    /// Moves to the end of the schedule.
    void go() {
        next_ = now_;
        if (!control_.is_adaptive())
            recorder_.forbid_gain(std::max(0.7 * (1.0 - options_.rho), 0.02),
                                  "shorter steps, a smaller rho or adaptive steps (tolerance > 0)");
        recorder_.start(now_);
        while (goes_on(now_) && advance()) {
            std::swap(now_, next_);
            if (!record(next_, now_)) break;
        }
        recorder_.finish(now_);
        if (!jumps_.ends(now_)) remember_run();
    }

    /// Begins at the model's state, with accelerations that belong to it.
    ///
    /// a_0 belongs to t_0 + offset h; with a_0 = v'_0 the first steps would be of first order. But
    /// v'' of a vibration that steps do not resolve is far too large for them: it solves
    /// A (v'', .) = (M j, G j) with the jerk j and the matrix A of a step.
    /// @param goes_on  whether an earlier run, of steps that did not resolve vibrations, led here.
    void begin_anew(bool goes_on = false) {
        static_cast<MotionPoint&>(now_) = start_point();
        now_.acceleration = now_.algorithmic = start_.acceleration;
        width_ = duration_ > 0.0 ? std::min(grid_.width, duration_) : grid_.width;
        linearised_width_ = 0.0;
        jerk_.setZero(problem_.size());
        peak_ = 0.0;
        if (offset_ == 0.0 && !goes_on) return;
        static_cast<MotionPoint&>(next_) = now_;
        if (evaluate(next_, Request::tangent_and_damping) != Status::converged ||
            factorise(width_) != Status::converged)
            return;
        Start at = start_;
        if (goes_on && problem_.model().exchange() == nullptr) smooth_acceleration(at);
        now_.acceleration = now_.algorithmic = at.acceleration;
        if (offset_ == 0.0) return;
        report_.evaluations += 4;
        VectorX jerk;
        if (problem_.jerk(at, 1e-3 * width_, jerk) != Status::converged) return;
        VectorX whole = VectorX::Zero(problem_.numbering().coordinates());
        problem_.numbering().set_free(jerk, whole);
        problem_.numbering().dependence().complete(whole);
        solve_mass_step(jerk, problem_.constraints().product(whole));
        for (int i = 0; i < problem_.size(); ++i)
            now_.algorithmic[i] += offset_ * width_ * solution_[i];
    }

    /// Takes the accelerations of vibrations that steps do not resolve away, and what belongs to
    /// them of the multipliers.
    ///
    /// With r'' of the positions alone, A (d, .) = (-h^2 beta_hat r'', 0) cancels them. What d has
    /// of resolved motions, A^-1 M d, stays as it is.
    void smooth_acceleration(Start& at) {
        VectorX change;
        report_.evaluations += 3;
        if (problem_.force_curvature(at, 0.1 * width_, change)) return;
        rhs_.setZero(problem_.numbering().unknowns());
        for (int i = 0; i < problem_.size(); ++i)
            rhs_[i] = -width_ * width_ * beta_hat_ * change[i];
        solve_with(solver_, rhs_, solution_);
        change = solution_.head(problem_.size());
        at.acceleration += change;
        at.multipliers += solution_.tail(problem_.multipliers());
        solve_mass_step(change, VectorX::Zero(problem_.multipliers()));
        for (int i = 0; i < problem_.size(); ++i) at.acceleration[i] -= solution_[i];
    }

    /// Solves A (x, .) = (M y, g) by the factorised matrix of a step.
    void solve_mass_step(const VectorX& y, const VectorX& g) {
        product_.setZero(problem_.size());
        problem_.add_mass_product(1.0, y, product_);
        rhs_.resize(problem_.numbering().unknowns());
        for (int i = 0; i < problem_.size(); ++i) rhs_[i] = product_[i];
        for (int i = 0; i < problem_.multipliers(); ++i) rhs_[problem_.size() + i] = g[i];
        solve_with(solver_, rhs_, solution_);
    }

    /// Takes the end of the run that goes on into now_, and where its matrix was made into next_.
    /// Returns whether it ended by a step that was cut.
    [[nodiscard]] bool read(const Memory& memory) {
        const VectorX& values = recall("GeneralizedAlpha", "generalized_alpha", memory, 8);
        require(values[7] == options_.rho, "GeneralizedAlpha: the memory is of rho ", values[7],
                ", the options have ", options_.rho);
        problem_.set_length_scale(values[12]);
        static_cast<MotionPoint&>(now_) = recall(memory, "", values[0]);
        now_.acceleration = memory.get("acceleration", problem_.size());
        now_.algorithmic = memory.get("algorithmic", problem_.size());
        jerk_ = memory.get("jerk", problem_.size());
        peak_ = values[11];
        width_ = values[4];
        linearised_width_ = values[6];
        if (linearised_width_ > 0.0)
            static_cast<MotionPoint&>(next_) = recall(memory, "linearised_", values[5]);
        return was_cut(values, width_);
    }

    void recall_run(const Memory& memory) {
        bool begins_anew = false;
        together(problem_.model().exchange(), [&] { begins_anew = read(memory); });
        require_continuation("GeneralizedAlpha", memory, problem_, start_point(), now_);
        if (begins_anew) return begin_anew(true);
        if (linearised_width_ > 0.0 &&
            (evaluate(next_, Request::tangent_and_damping) != Status::converged ||
             factorise(linearised_width_) != Status::converged))
            linearised_width_ = 0.0;  // the first step builds a matrix of its own
        const VectorX& values = memory.get("scalars", 14);
        matrix_ = {values[8], values[9], values[10]};
        frames_.recall(memory);
    }

    void remember_run() {
        remember("generalized_alpha", now_,
                 {width_, linearised_.time, linearised_width_, options_.rho, matrix_.steps,
                  matrix_.contraction, matrix_.told, peak_});
        report_.memory.put("acceleration", now_.acceleration);
        report_.memory.put("algorithmic", now_.algorithmic);
        report_.memory.put("jerk", jerk_);
        report_.memory.put("frames", frames_.memory());
        if (linearised_width_ > 0.0) remember("linearised_", linearised_);
    }

    /// Takes one step into next_, again with smaller ones where the run is adaptive, and in parts
    /// where it is not.
    [[nodiscard]] bool advance() {
        for (;;) {
            const Step step = next_step(now_);
            if (passes_jump(now_)) {
                begin_anew();
                continue;
            }
            change_width(step.width);
            if (divides(step)) continue;
            next_.time = step.end;
            const Status status = step.turn.fits() ? newton(step.width) : Status::diverged;
            double error = 0.0;
            if (status == Status::converged && control_.is_adaptive()) {
                error = weigh(error_constant_ * step.width * step.width * change_of_acceleration() /
                                  options_.tolerance,
                              step.width);
                // in a vibration accelerations change little twice a period
                peak_ = std::max(error, 0.85 * peak_);
            }
            const double factor = 0.85 / std::cbrt(std::max(peak_, 1e-3));
            if (status == Status::converged && error <= 1.0) {
                // vibrations that steps do not resolve fade in it as fast as in the motion
                for (Eigen::Index k = 0; k < jerk_.size(); ++k)
                    jerk_[k] +=
                        (1.0 - options_.rho) *
                        ((next_.algorithmic[k] - now_.algorithmic[k]) / step.width - jerk_[k]);
                grid_.take(step);
                frames_.end_step(step.width);
                rests_ = error < resting;
                // a step keeps its width, and the matrix, unless a change is worth it
                if (control_.is_adaptive() && step.width == grid_.width &&
                    (factor < 0.95 || factor > 1.4))
                    grid_ = {step.end, std::min(step.width * std::min(factor, 2.0), control_.most)};
                return true;
            }
            if (!shortens(now_, step, status,
                          status == Status::converged ? std::max(0.2, factor) : 0.25))
                return false;
        }
    }

    /// Makes the start of a step what belongs to another width.
    ///
    /// a_n stands for v'(t_n + offset h): without the shift a change of h costs an order. After
    /// steps of one width v_n is off the rate of the positions by -error_constant h^2 v''. Left so,
    /// it would be a shock to constraints, and to vibrations that steps do not resolve, that decays
    /// by rho a step. What is off the constraints is known.
    void change_width(double width) {
        if (width == width_) return;
        const double ratio = width / width_;
        for (Eigen::Index k = 0; k < now_.algorithmic.size(); ++k)
            now_.algorithmic[k] =
                now_.acceleration[k] + ratio * (now_.algorithmic[k] - now_.acceleration[k]);
        const auto hold = [&](VectorX& v) {
            return problem_.multipliers() == 0 || problem_.project_rates(now_.time, now_.q, v, 1);
        };
        VectorX held = now_.v;
        bool holds = hold(held);
        VectorX moved = held;
        if (control_.is_adaptive()) {
            moved -= error_constant_ * (width * width - width_ * width_) * jerk_;
            holds = holds && hold(moved);
        }
        for (Eigen::Index k = 0; holds && k < held.size(); ++k)
            now_.v[k] = moved[k] + ratio * ratio * (now_.v[k] - held[k]);
        peak_ *= ratio * ratio * ratio;
        width_ = width;
    }

    /// Solves one step by Newton's method.
    ///
    /// A stiff body that has turned since the matrix at hand was made can be thrown far off by it:
    /// the step then starts again, with a matrix of its own, and then with the strains of the
    /// prediction. Where vibrations are faster than the steps, their accelerations predict badly:
    /// it starts once more without accelerations, unless the scene moves far in it.
    [[nodiscard]] Status newton(double h) {
        predict(h);
        keep_strains(h);
        if (linearised_width_ == h) {
            const long matrices = report_.factorisations;
            const bool served = matrix_.steps > few_steps;
            const Status status = iterate(h, false);
            const bool failed = status != Status::converged || report_.factorisations > matrices;
            if (failed && !served) frames_.fail();
            if (status == Status::converged) {
                frames_.compare(problem_, next_.q);
                return status;
            }
        }
        predict(h);
        keep_strains(h);
        Status status = iterate(h, true);
        if (status != Status::converged && frames_.keeps()) {
            predict(h);
            status = iterate(h, true);
        }
        if (status == Status::converged) frames_.compare(problem_, next_.q);
        if (status == Status::converged || moves_far(now_, h)) return status;
        predict(h);
        add(h, -now_.acceleration);
        return iterate(h, true);
    }

    /// Iterates from next_, with a new matrix or the one at hand.
    ///
    /// A matrix, of an earlier step or iterate, stays while it converges fast enough.
    [[nodiscard]] Status iterate(double h, bool renew) {
        bool fresh = false;  // whether the matrix is of this step
        int since = 0;       // corrections by the matrix at hand
        matrix_.steps += 1.0;
        const double least = round_off * remoteness(next_.q);
        double before = 0.0, pull = 0.0;
        for (int k = 1; k <= options_.max_iterations; ++k) {
            if (const Status status =
                    evaluate(next_, renew ? Request::tangent_and_damping : Request::force);
                status != Status::converged)
                return status;
            if (renew) {
                if (const Status status = factorise(h); status != Status::converged) return status;
                fresh = true;
                since = 0;
            }
            const double change = correct(h);
            const auto of_lambda = solution_.tail(problem_.multipliers());
            const bool balanced = !frames_.turn() || fresh ||
                                  frames_.balances(problem_, of_lambda, next_.lambda, pull);
            if (!std::isfinite(change)) return Status::not_finite;
            // far below the local error of the step, however short it is
            const double local = h * h * beta_hat_ * change_of_acceleration();
            const double wanted =
                std::min(options_.newton_tolerance, std::max(1e-3 * local, 1e-16));
            const double ratio = k > 1 ? change / before : 1.0;
            if (++since > 2) {
                matrix_.contraction = std::max(ratio, since > 3 ? matrix_.contraction : 1e-4);
                matrix_.told = matrix_.steps;
            }
            // one correction tells nothing of what is left
            const double shrinks = std::max(ratio, expected_contraction());
            const double left =
                since > 1 ? shrinks / std::max(1.0 - shrinks, 0.1) * change : change;
            // at the round-off of the residual the corrections no longer shrink
            const bool small =
                change <= 1e3 * options_.newton_tolerance && (fresh || ratio <= most_noise);
            // a matrix of this step takes far more than half of an error
            const bool stays = ratio >= (fresh && left <= options_.newton_tolerance ? 0.5 : 1.0);
            const bool noise = change <= least || (stays && small);
            if (left <= wanted || (k > 1 && noise)) {
                // in a body that turns, what two corrections leave adds up over the steps
                if (k == options_.max_iterations || !frames_.turn() || (since > 2 && balanced))
                    return Status::converged;
                renew = since > 2;
                before = change;
                continue;
            }
            if (ratio > 1.0 && (!fresh || change > farthest)) return Status::diverged;
            // so slow that a new matrix is cheaper
            const bool slow = std::log(wanted / change) / std::log(ratio) > 4.0;
            renew = k > 1 && (ratio > 0.9 || (slow && !(small && fresh)));
            before = change;
        }
        return Status::max_iterations;
    }

    /// Solves for one correction and adds it; returns its size.
    [[nodiscard]] double correct(double h) {
        const int n = problem_.size();
        const int m = problem_.multipliers();
        product_ = problem_.force();
        problem_.add_mass_product(1.0, next_.acceleration, product_);
        rhs_.resize(n + m);
        for (int i = 0; i < n; ++i) rhs_[i] = -product_[i];
        for (int i = 0; i < m; ++i)
            rhs_[n + i] = problem_.constraint_residual()[i] / (-h * h * beta_hat_);
        if (frames_.turn()) frames_.carry(next_.q, linearised_.q, rhs_.data());
        solve_with(solver_, rhs_, solution_);
        if (frames_.turn()) frames_.carry(linearised_.q, next_.q, solution_.data());
        ++report_.iterations;
        frames_.add_correction();
        add(h, solution_.head(n));
        next_.lambda += solution_.tail(m);
        return h * h * beta_hat_ * problem_.largest_ratio(solution_.head(n));
    }

    /// Builds [M + h gamma_hat D + h^2 beta_hat K, G^T; G, 0] from the last evaluation and
    /// factorises it.
    [[nodiscard]] Status factorise(double h) {
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
        frames_.add_tangent();
        const Status status = solver_.factorize(system_).status;
        linearised_ = next_;
        linearised_width_ = status == Status::converged ? h : 0.0;
        matrix_ = {1.0};
        return status;
    }

    /// Returns what a correction by the matrix at hand leaves of the last one, from earlier steps.
    ///
    /// The first ratio of a step flatters: the first correction is mostly the prediction's error.
    /// In a stiff body that turns this contraction grows with the square of the angle since the
    /// matrix was made.
    [[nodiscard]] double expected_contraction() const {
        constexpr double unknown = 0.8;
        if (matrix_.told == 0.0) return unknown;
        const double grown = matrix_.steps / matrix_.told;
        return std::min(matrix_.contraction * grown * grown, unknown);
    }

    /// Starts from the accelerations of the step's start.
    void predict(double h) {
        next_.lambda = now_.lambda;
        next_.acceleration = now_.acceleration;
        next_.algorithmic = now_.algorithmic;
        next_.q = now_.q;
        next_.v = now_.v;
        for (Eigen::Index k = 0; k < next_.q.size(); ++k) {
            const double before = now_.algorithmic[k];
            const double after = (now_.acceleration[k] - am_ * before) / (1.0 - am_);
            next_.algorithmic[k] = after;
            next_.q[k] =
                now_.q[k] + h * now_.v[k] + h * h * (0.5 - beta_) * before + h * h * beta_ * after;
            next_.v[k] = now_.v[k] + h * (1.0 - gamma_) * before + h * gamma_ * after;
        }
    }

    /// Takes back the strains of the prediction, in frames that turn and keep them.
    void keep_strains(double h) {
        if (!frames_.turn()) return;
        VectorX kept = next_.q;
        frames_.begin_step(now_.q, kept);
        for (Eigen::Index k = 0; k < kept.size(); ++k)
            kept[k] = (kept[k] - next_.q[k]) / (h * h * beta_hat_);
        add(h, kept);
    }

    /// Changes the accelerations, and what follows of them.
    void add(double h, const VectorX& change) {
        next_.acceleration += change;
        next_.algorithmic += (1.0 - af_) / (1.0 - am_) * change;
        next_.q += h * h * beta_hat_ * change;
        next_.v += h * gamma_hat_ * change;
    }

    [[nodiscard]] double change_of_acceleration() const {
        return problem_.largest_ratio(next_.acceleration - now_.acceleration);
    }

    const GeneralizedAlphaOptions& options_;

    // the method's parameters
    double am_, af_, beta_, gamma_, offset_;  // a_n belongs to t_n + offset h
    double beta_hat_, gamma_hat_;             // dq = h^2 beta_hat dv', dv = h gamma_hat dv'
    double error_constant_;                   // local error = it h^2 (v'_1 - v'_0)

    TurningFrames frames_;
    Point now_, next_;
    double width_ = 0.0;             // step that now_.algorithmic, now_.v and peak_ belong to
    double peak_ = 0.0;              // largest error of late, of the tolerance
    VectorX jerk_;                   // mean rate of a over the steps of late; 0 at the start
    MotionPoint linearised_;         // where the factorised matrix was evaluated
    double linearised_width_ = 0.0;  // its step; 0: there is no matrix
    Experience matrix_;

    SparseMatrix system_;
    List<char> stiff_;  // per value: 1 in the block of coordinates, 0 elsewhere
    VectorX product_, rhs_, solution_;
};

}  // namespace detail

ANCF_INLINE void GeneralizedAlphaOptions::check() const {
    detail::require(rho >= 0.0 && rho <= 1.0,
                    "GeneralizedAlphaOptions: rho must be from 0 to 1, got ", rho);
    detail::StepControl{step, tolerance, min_step, max_step}.check("GeneralizedAlphaOptions");
    detail::require_positive("GeneralizedAlphaOptions: newton_tolerance", newton_tolerance);
    detail::require(max_iterations >= 1,
                    "GeneralizedAlphaOptions: max_iterations must be at least 1, got ",
                    max_iterations);
}

ANCF_INLINE DynamicsReport GeneralizedAlpha::integrate(DynamicProblem& problem,
                                                       LinearSolver& solver,
                                                       const Schedule& schedule,
                                                       const Memory& memory) const {
    if (memory.empty()) return integrate(problem, solver, schedule);
    return detail::GeneralizedAlphaRun(problem, solver, schedule, options()).run(memory);
}

ANCF_INLINE DynamicsReport GeneralizedAlpha::integrate(DynamicProblem& problem,
                                                       LinearSolver& solver,
                                                       const Schedule& schedule) const {
    return detail::GeneralizedAlphaRun(problem, solver, schedule, options()).run();
}

}  // namespace ancf
