// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/energy_momentum_system.hpp>
#include <ancf/dynamics/motion_run.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/error.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ancf {
namespace detail {

/// One run.
class EnergyMomentumRun : MotionRun {
public:
    EnergyMomentumRun(DynamicProblem& problem, LinearSolver& solver, const Schedule& schedule,
                      const EnergyMomentumOptions& options)
        : MotionRun(problem, solver, schedule, {options.step}, options.follow_energy),
          options_(options),
          system_(problem) {}

    DynamicsReport run(const Memory& memory) {
        if (!has_started()) return std::move(report_);
        solver_.analyze(problem_.mass());
        now_ = start_point();
        acceleration_ = start_.acceleration;
        if (!memory.empty()) recall_run(memory);
        next_ = now_;
        recorder_.start(now_);
        while (goes_on(now_) && advance()) {
            std::swap(now_, next_);
            if (!record(next_, now_)) break;
        }
        recorder_.finish(now_);
        remember_run();
        return std::move(report_);
    }

private:
    void recall_run(const Memory& memory) {
        const int n = problem_.size();
        const int m = problem_.multipliers();
        const VectorX& values = recall("EnergyMomentum", "energy_momentum", memory, 4, 7);
        problem_.set_length_scale(values[8]);
        const MotionPoint end = recall(memory, "", values[0]);
        require_continuation("EnergyMomentum", memory, problem_, now_, end);
        const double width = values[6];
        if (width > 0.0) {
            // evaluate the matrix again in the step that it comes from
            now_ = {values[4],
                    memory.get("linearised_from_q", n),
                    memory.get("linearised_from_v", n),
                    {}};
            next_ = {values[5],
                     memory.get("linearised_to_q", n),
                     {},
                     memory.get("linearised_to_lambda", m)};
            full_now_ = problem_.raw_state(now_.time, now_.q, now_.v);
            system_.begin(now_.time, width, full_now_.q, full_now_.v);
            increment_ = next_.q - now_.q;
            if (evaluate(width, true) != Status::converged) linearised_width_ = 0.0;
        }
        now_ = end;  // with its own rates: projected ones would have less energy
        acceleration_ = m > 0 && was_cut(values, values[7]) ? start_.acceleration
                                                            : memory.get("acceleration", n);
    }

    void remember_run() {
        remember("energy_momentum", now_,
                 {linearised_from_.time, linearised_to_.time, linearised_width_, last_width_});
        Memory& memory = report_.memory;
        memory.put("acceleration", acceleration_);
        if (linearised_width_ == 0.0) return;
        memory.put("linearised_from_q", linearised_from_.q);
        memory.put("linearised_from_v", linearised_from_.v);
        memory.put("linearised_to_q", linearised_to_.q);
        memory.put("linearised_to_lambda", linearised_to_.lambda);
    }

    /// Takes one step into next_, in parts where a joint is driven far or Newton's method fails.
    ///
    /// Beyond pi/12 in a step there are other solutions, with energies of their own, that Newton's
    /// method may find.
    [[nodiscard]] bool advance() {
        for (;;) {
            Step step = next_step(now_);
            if (divides(step, true)) step = next_step(now_);
            next_.time = step.end;
            const Status status = step.turn.fits() ? solve(step.width) : Status::diverged;
            if (status == Status::converged) {
                acceleration_ = (next_.v - now_.v) / step.width;
                grid_.take(step);
                return true;
            }
            if (!shortens(now_, step, status, 0.5)) return false;
        }
    }

    /// Takes one step by Newton's method.
    ///
    /// A stiff body that has turned since the matrix at hand was made can be thrown far off by it:
    /// the step then starts again, with a matrix of its own. Where vibrations are faster than the
    /// steps, the mean acceleration of the last step predicts badly: it starts once more without,
    /// unless the scene moves far in it.
    [[nodiscard]] Status solve(double h) {
        full_now_ = problem_.raw_state(now_.time, now_.q, now_.v);
        system_.begin(now_.time, h, full_now_.q, full_now_.v);
        const double bend = 0.5 * h * h;
        if (linearised_width_ == h && iterate(h, bend, false) == Status::converged)
            return Status::converged;
        const Status status = iterate(h, bend, true);
        if (status == Status::converged || moves_far(now_, h)) return status;
        return iterate(h, 0.0, true);
    }

    /// Iterates from the prediction h v + bend a until the corrections are round-off, with a new
    /// matrix or the one at hand.
    ///
    /// A matrix, of an earlier step or iterate, stays while it converges fast enough.
    [[nodiscard]] Status iterate(double h, double bend, bool renew) {
        const int n = problem_.size();
        const int m = problem_.multipliers();
        increment_ = h * now_.v + bend * acceleration_;
        next_.q = now_.q + increment_;
        next_.lambda = now_.lambda;
        bool fresh = false;  // whether the matrix is of this step
        bool last = false;   // whether the correction after this one would be round-off
        const double noise = 2e-14 * remoteness(now_.q);  // of corrections
        double before = 0.0;
        double least = std::numeric_limits<double>::infinity();
        int stalled = 0;  // corrections since the least one
        for (int k = 1; k <= options_.max_iterations; ++k) {
            if (const Status status = evaluate(h, renew); status != Status::converged)
                return status;
            fresh = fresh || renew;
            solve_with(solver_, rhs_, solution_);
            ++report_.iterations;
            const VectorX correction = solution_.head(n);
            increment_ += correction;
            next_.q = now_.q + increment_;
            next_.lambda += 2.0 / (h * h) * solution_.tail(m);
            const double change = largest_ratio(correction, problem_.scales());
            if (!std::isfinite(change)) return Status::not_finite;
            // what Newton's method found from there had energies of its own
            if (change > farthest && reaches_far(correction)) return Status::diverged;
            const double ratio = k > 1 ? change / before : 0.0;
            stalled = change < least ? 0 : stalled + 1;
            least = std::min(least, change);
            // corrections that no longer shrink are the round-off of the residual
            if ((last && change <= before) || change <= floor ||
                (ratio > 0.3 && change <= std::max(1e-11, noise)) ||
                (stalled >= 2 && change <= std::max(1e-9, noise))) {
                set_rates(h);
                const bool distrusted = h > trusted_part * options_.step && turns_inside_out();
                return distrusted ? Status::diverged : Status::converged;
            }
            if (!fresh && ratio > 1.0) return Status::diverged;
            // so slow that a new matrix is cheaper
            renew = k > 1 && (ratio > 0.9 || std::log(floor / change) / std::log(ratio) > 6.0);
            before = change;
            // foreseen where corrections are above the noise; a small one may hide slower parts
            const double contraction = std::max(ratio, fastest);
            last = k > 1 && change * contraction * contraction <= floor;
        }
        return Status::max_iterations;
    }

    /// Evaluates at next_ and, where asked, builds and factorises the matrix there.
    [[nodiscard]] Status evaluate(double h, bool matrix) {
        set_rates(h);
        const State full = problem_.raw_state(next_.time, next_.q, next_.v);
        ++report_.evaluations;
        report_.fault.reset();
        if (!system_.evaluate(full.q, full.v, next_.lambda, matrix, rhs_)) {
            report_.fault = problem_.assembly().inspect(full.q);
            if (!report_.fault)  // a load or a constraint
                report_.fault =
                    problem_.evaluate(next_.time, next_.q, next_.v, next_.lambda, Request::force);
            return report_.fault ? report_.fault->status : Status::not_finite;
        }
        if (!matrix) return Status::converged;
        ++report_.jacobians;
        ++report_.factorisations;
        linearised_from_ = now_;
        linearised_to_ = next_;
        const Status status = solver_.factorize(system_.matrix()).status;
        linearised_width_ = status == Status::converged ? h : 0.0;
        return status;
    }

    void set_rates(double h) { next_.v = 2.0 / h * increment_ - now_.v; }

    /// Tells whether a correction changes a slope by more than its length, or a position by more
    /// than the scene's size. A change of r_xx counts by what it makes of the slopes of an element.
    [[nodiscard]] bool reaches_far(const VectorX& correction) const {
        VectorX sizes;
        problem_.numbering().gather_free(problem_.scales_of(problem_.length_scale())
                                             .cwiseMax(problem_.scales_of(system_.length())),
                                         sizes);
        return largest_ratio(correction, sizes) > farthest;
    }

    /// Tells whether r_x and r_y of a node in the plane change sides between now_ and next_.
    ///
    /// The equations of a long step may have a solution there, beyond the energy of a crushed
    /// section, that those of shorter steps from the same state were not seen to have.
    [[nodiscard]] bool turns_inside_out() const {
        const Scene& model = problem_.model();
        if (model.dimension() != 2) return false;
        const VectorX end = problem_.raw_state(next_.time, next_.q, next_.v).q;
        for (int node = 0; node < model.layout().nodes(); ++node) {
            const Fields fields = model.layout().fields(node);
            if (!fields.contains(Field::r_x) || !fields.contains(Field::r_y)) continue;
            const int x = model.layout().first(node) + 2 * fields.rank(Field::r_x);
            const int y = model.layout().first(node) + 2 * fields.rank(Field::r_y);
            const auto side = [x, y](const VectorX& q) {
                return q[x] * q[y + 1] - q[x + 1] * q[y];
            };
            if (side(full_now_.q) * side(end) < 0.0) return true;
        }
        return false;
    }

    static constexpr double floor = 1e-16;        // of corrections, relative
    static constexpr double fastest = 1e-2;       // the fastest contraction that is believed
    static constexpr double farthest = 1.0;       // of them: a slope's length, the scene's size;
                                                  // of r_xx the inverse length of an element
    static constexpr double trusted_part = 1e-2;  // of one that turns a section inside out

    const EnergyMomentumOptions& options_;
    EnergyMomentumSystem system_;

    MotionPoint now_, next_;
    VectorX acceleration_;  // mean of the last step: the prediction of the next
    MotionPoint linearised_from_, linearised_to_;  // the step that the matrix was evaluated in
    double linearised_width_ = 0.0;                // 0: there is no matrix
    State full_now_;
    VectorX increment_;  // q_1 - q_0, free of the round-off of q
    VectorX rhs_, solution_;
};

}  // namespace detail

ANCF_INLINE void EnergyMomentumOptions::check() const {
    detail::require_positive("EnergyMomentumOptions: step", step);
    detail::require(max_iterations >= 1,
                    "EnergyMomentumOptions: max_iterations must be at least 1, got ",
                    max_iterations);
}

ANCF_INLINE DynamicsReport EnergyMomentum::integrate(DynamicProblem& problem, LinearSolver& solver,
                                                     const Schedule& schedule,
                                                     const Memory& memory) const {
    return detail::EnergyMomentumRun(problem, solver, schedule, options()).run(memory);
}

}  // namespace ancf
