// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/dynamics/motion_run.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/dynamics/radau_system.hpp>
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

/// Returns the vectors of the stages in one.
[[nodiscard]] ANCF_INLINE VectorX joined_stages(const Stages& stages) {
    VectorX all(static_cast<Eigen::Index>(stages.size()) * stages.front().size());
    double* out = all.data();
    for (const VectorX& stage : stages) out = std::copy_n(stage.data(), stage.size(), out);
    return all;
}

/// Takes the vectors of the stages apart.
ANCF_INLINE void part_stages(const VectorX& all, Stages& stages) {
    const double* from = all.data();
    for (VectorX& stage : stages) {
        std::copy_n(from, stage.size(), stage.data());
        from += stage.size();
    }
}

/// One run.
class RadauRun : MotionRun {
public:
    ANCF_LAZY RadauRun(DynamicProblem& problem, LinearSolver& solver, const Schedule& schedule,
                       const RadauOptions& options)
        : MotionRun(problem, solver, schedule,
                    {options.step, options.tolerance, options.min_step, options.max_step},
                    options.follow_energy),
          options_(options),
          tableau_(radau_tableau(options.stages)),
          stages_(static_cast<std::size_t>(options.stages)),
          system_(problem, solver, tableau_),
          frames_(problem.model(), problem.numbering(), options.tolerance > 0.0 ? 4.0 : 1.0),
          newton_tolerance_(options.newton_tolerance > 0.0 ? options.newton_tolerance
                            : options.tolerance > 0.0
                                ? (options.stages > 3 ? 0.0125 : 0.06) * options.tolerance
                                : 1e-13),
          of_accelerations_(options.stages > 3 ? 3e-5 : 3e-4),
          at_start_(lagrange_weights(tableau_.nodes, 0.0)),
          Y_(stages_, VectorX::Zero(problem.size())),
          rate_change_(Y_),
          acceleration_(Y_),
          lambda_(stages_, VectorX::Zero(problem.multipliers())),
          force_(Y_),
          lengths_(lambda_),
          change_(Y_),
          lambda_change_(lambda_),
          stage_(stages_),
          acceleration_before_(Y_),
          lambda_before_(lambda_) {}

    DynamicsReport run(const Memory& memory) {
        if (!has_started()) return std::move(report_);
        static_cast<MotionPoint&>(now_) = start_point();
        now_.acceleration = start_.acceleration;
        if (!memory.empty()) recall_run(memory);
        next_ = now_;
        recorder_.start(now_);
        while (goes_on(now_) && advance())
            if (!record(earlier_, now_, [this](double time) { return between(time); })) break;
        recorder_.finish(now_);
        if (!jumps_.ends(now_)) remember_run();
        return std::move(report_);
    }

private:
    // The end of a step and its accelerations, of the last stage.
    struct Point : MotionPoint {
        VectorX acceleration;
    };

    // What the stages of a step are made of.
    struct Span {
        const MotionPoint& from;
        double width, end;
    };

    static constexpr double largest_growth = 8.0;     // of a step
    static constexpr double farthest_start = 10.0;    // steps that the last one's polynomials reach
    static constexpr double round_off = 1e-10;        // of corrections that no longer shrink
    static constexpr double resolution = 4e-15;       // of corrections, of a scene at the origin
    static constexpr double loosest = 1e-3;           // tolerance in frames that turn
    static constexpr double good_contraction = 0.03;  // by which matrices stay
    static constexpr double fair_contraction = 0.2;   // by a tangent of the step's own

    void recall_run(const Memory& memory) {
        const int n = problem_.size();
        const VectorX& values = recall("RadauIIA", "radau", memory, 11);
        require(values[13] == static_cast<double>(stages_), "RadauIIA: the memory is of ",
                values[13], " stages, the options have ", options_.stages);
        error_before_ = values[14];
        problem_.set_length_scale(values[15]);
        static_cast<MotionPoint&>(now_) = recall(memory, "", values[0]);
        require_continuation("RadauIIA", memory, problem_, start_point(), now_);
        now_.acceleration = memory.get("acceleration", n);
        part_stages(memory.get("stage_accelerations", n * options_.stages), acceleration_before_);
        part_stages(memory.get("stage_multipliers", problem_.multipliers() * options_.stages),
                    lambda_before_);
        width_before_ = values[4];
        contraction_ = values[7];
        fresh_ = values[8];
        eta_ = values[9];
        most_growth_ = values[10];
        rejected_ = values[11] != 0.0;
        failed_ = values[12] != 0.0;
        frames_.recall(memory);
        if (problem_.multipliers() > 0 && was_cut(values, width_before_)) {
            static_cast<MotionPoint&>(now_) = start_point();
            now_.acceleration = start_.acceleration;
            width_before_ = 0.0;
        }
        if (values[6] == 0.0) return;
        linearised_ = recall(memory, "linearised_", values[5]);
        if (evaluate(linearised_, Request::tangent_and_damping) == Status::converged &&
            system_.factorise(values[6], report_.factorisations) == Status::converged)
            renew_ = false;  // where that fails the first step takes a tangent of its own
    }

    void remember_run() {
        const double factorised = renew_ ? 0.0 : system_.width();
        remember("radau", now_,
                 {width_before_, linearised_.time, factorised, contraction_, fresh_, eta_,
                  most_growth_, rejected_ ? 1.0 : 0.0, failed_ ? 1.0 : 0.0,
                  static_cast<double>(stages_), error_before_});
        report_.memory.put("frames", frames_.memory());
        report_.memory.put("acceleration", now_.acceleration);
        report_.memory.put("stage_accelerations", joined_stages(acceleration_before_));
        report_.memory.put("stage_multipliers", joined_stages(lambda_before_));
        if (factorised > 0.0) remember("linearised_", linearised_);
    }

    /// Takes one step into next_, again with smaller ones where the run is adaptive, and in parts
    /// where it is not.
    [[nodiscard]] bool advance() {
        if (width_before_ > 0.0) frames_.end_step(width_before_);
        strain_ = frames_.turn() ? recorder_.strain_energy(now_) : 0.0;
        for (;;) {
            const Step step = next_step(now_, true);
            if (passes_jump(now_)) {
                begin_anew();
                continue;
            }
            if (divides(step)) continue;
            next_.time = step.end;
            const Status status = step.turn.fits() ? newton(step.width) : Status::diverged;
            const bool tests = status == Status::converged && control_.is_adaptive();
            const double error = tests ? weigh(this->error(step.width), step.width) : 0.0;
            if (status == Status::converged && error <= 1.0) {
                accept(step, error);
                end_step(step.width);
                return true;
            }
            if (!shortens(now_, step, status, shortening(step, status, error))) return false;
        }
    }

    /// Begins behind a jump, as a run does.
    void begin_anew() {
        now_.acceleration = start_.acceleration;
        width_before_ = 0.0;
        most_growth_ = largest_growth;
        rejected_ = failed_ = false;
        knots_.clear();
    }

    /// Settles the next step's width.
    void accept(const Step& step, double error) {
        const bool attempted = rejected_ || failed_;
        rejected_ = failed_ = false;
        grid_.take(step);
        rests_ = error < resting;
        error_before_ = error * share() * options_.tolerance;
        if (!control_.is_adaptive() || step.width != grid_.width) return;
        double factor = std::min(growth(error), attempted ? 1.0 : most_growth_);
        // what a fresh tangent hardly solves a longer step would not
        if (fresh_ > fair_contraction)
            factor = std::min(factor, std::max(0.9, std::sqrt(fair_contraction / fresh_)));
        most_growth_ = std::min(largest_growth, most_growth_ * 1.02);
        // a step keeps its width, and the matrices, unless a change is worth it
        if (factor < 0.95 || factor > (most_growth_ < 1.6 ? 1.25 : 1.6))
            grid_ = {step.end, std::min(step.width * factor, control_.most)};
    }

    /// Returns by what an adaptive step that failed is taken again.
    [[nodiscard]] double shortening(const Step& step, Status status, double error) {
        if (!control_.is_adaptive()) return 0.0;
        if (status == Status::converged) {
            rejected_ = true;
            return growth(error);
        }
        most_growth_ = 1.1;
        return std::exchange(failed_, true) || !step.turn.fits() ? 0.5 : 0.7;
    }

    /// Returns by what the next step is longer, after an error relative to the tolerance.
    [[nodiscard]] double growth(double error) const {
        const double most = options_.max_iterations;
        const double safety = 0.9 * (2.0 * most + 1.0) / (2.0 * most + iterations_);
        const double power = 1.0 / static_cast<double>(stages_ + 1);
        return std::max(safety * std::pow(std::max(error, 1e-10), -power), 0.2);
    }

    /// Returns what counts of the tolerance: frames that turn take steps so long that they would
    /// lose energy at a looser one.
    [[nodiscard]] double share() const {
        return frames_.turn() && options_.tolerance > loosest ? loosest / options_.tolerance : 1.0;
    }

    /// Solves one step by Newton's method, again with a new tangent where the old one fails, and
    /// with frames that turn, or no longer do, where that is to be tried.
    [[nodiscard]] Status newton(double h) {
        if (!renew_ && system_.width() == h && iterate(h, false) == Status::converged && balanced_)
            return Status::converged;
        const Status status = iterate(h, true);
        return status == Status::converged || !frames_.fail() ? status : iterate(h, true);
    }

    /// Predicts the stages of a step, in frames that turn without strains of the turn.
    void begin(const Span& step) {
        const double h = step.width;
        predict(1.0, width_before_ > 0.0 ? h / width_before_ : 0.0);
        pull_ = 0.0;
        if (!frames_.turn()) return;
        place_stages(step);
        for (std::size_t i = 0; i < stages_; ++i) {
            VectorX q = stage_[i].q;
            frames_.begin_step(now_.q, q);
            Y_[i] += (q - stage_[i].q) / (h * h);
        }
    }

    /// What a correction of a step is measured by; all but the last relative to the scene.
    struct Bounds {
        double least;     // what coordinates resolve
        double noise;     // round-off of the residual, and no less than the least
        double wanted;    // of the options
        double of_error;  // a share of the step's own error, as the last step tells it
        double energy;    // J, of strains
    };

    [[nodiscard]] Bounds bounds(double h) const {
        Bounds of{};
        of.least = resolution * remoteness(now_.q);
        of.noise = std::max(round_off, of.least);
        of.wanted = options_.newton_tolerance > 0.0 ? newton_tolerance_
                                                    : std::max(newton_tolerance_, of.least);
        const double shrinks = width_before_ > 0.0 ? std::min(h / width_before_, 1.0) : 0.0;
        of.of_error = 0.06 * error_before_ * std::pow(shrinks, options_.stages + 1);
        of.energy = frames_.turn()
                        ? std::pow(0.03 * share() * newton_tolerance_, 2) *
                              typical_energy(problem_, now_.v, now_.acceleration, strain_, h)
                        : std::numeric_limits<double>::infinity();
        return of;
    }

    /// Iterates from the prediction, with a new tangent or the matrices at hand.
    [[nodiscard]] Status iterate(double h, bool renew) {
        constexpr double epsilon = std::numeric_limits<double>::epsilon();
        constexpr double nothing = epsilon * epsilon;  // of a correction, relative to the scene
        const bool constrained = problem_.multipliers() > 0;
        const Span step{now_, h, next_.time};
        begin(step);
        const Bounds bound = bounds(h);
        const double least = bound.least, noise = bound.noise;
        int tangents = 0;  // of this step
        int since = 0;     // corrections by the matrices at hand
        double change = 0.0, before = 0.0, ratio_before = 0.0;
        const double expected = std::min(contraction_, 0.5);
        eta_ = std::pow(std::max(eta_, 1e-16), 0.8);
        for (iterations_ = 1;; ++iterations_) {
            if (iterations_ > options_.max_iterations) return Status::max_iterations;
            if (const Status status = evaluate_stages(step, renew); status != Status::converged)
                return status;
            if (renew) {
                ++tangents;
                frames_.add_tangent();
                since = 0;
                renew = false;
            }
            change = correct(h);
            balanced_ = !frames_.turn() ||
                        frames_.balances(problem_, lambda_change_.back(), lambda_.back(), pull_);
            frames_.add_correction();
            if (!std::isfinite(change)) return Status::not_finite;
            // in a step far shorter than its error allows, what is left is to be small beside that
            // error or the accelerations: x is an error x/h^2 of these, and the next step has its
            // stresses
            const double of_motion = of_accelerations_ * h * h * problem_.largest_ratio(Y_.back());
            const double wanted =
                std::min(bound.wanted, std::max({bound.of_error, of_motion, 1e-13, least}));
            const double strained =
                change > noise ? std::sqrt(correction_energy_ / bound.energy) : 0.0;
            const double excess = std::max(change / wanted, strained);
            const double ratio = iterations_ > 1 ? change / before : 0.0;
            const double enough = std::max(wanted, noise);
            // at the round-off of the residual the corrections no longer shrink; in a scene at rest
            // they are round-off of nothing, and tell nothing of the matrices
            if (change <= nothing) contraction_ = 0.0;
            if (change <= nothing || (ratio >= 1.0 && change <= enough)) break;
            if (++since > 1) {
                // a first ratio may flatter: it stands beside that of the step before
                const double contraction =
                    since == 2 ? std::max(ratio, 0.5 * expected) : std::sqrt(ratio * ratio_before);
                if (contraction >= 0.99 && change <= enough) break;
                contraction_ = contraction;
                if (contraction_ >= 0.99) return Status::diverged;
                eta_ = contraction_ / (1.0 - contraction_);
                // strains no longer count below the noise
                const double left =
                    eta_ * std::max(change / wanted, std::min(strained, change / noise));
                const int rest = options_.max_iterations - iterations_;
                renew = left > 1.0 && left * std::pow(contraction_, rest) > 1.0;
                if (renew && tangents == 2 && control_.is_adaptive()) return Status::max_iterations;
            }
            // one correction tells nothing of new matrices, and leaves g off its zero by kept ones;
            // new ones stand at the start of a step that may turn far, kept ones give way to them
            if ((iterations_ > 1 || (tangents == 0 && !constrained)) && is_told(since, change) &&
                eta_ * excess <= 1.0 && (balanced_ || tangents == 0))
                break;
            before = change;
            ratio_before = ratio;
        }
        // a single correction does not tell how good the matrices are; where the last one is
        // round-off of coordinates, the contraction is only an upper bound
        judge_matrices(since > 1 && change > least, tangents > 0);
        place_stages(step);
        next_.q = stage_.back().q;
        frames_.compare(problem_, next_.q);
        next_.v = stage_.back().v;
        next_.lambda = lambda_.back();
        next_.acceleration = acceleration_.back();
        return Status::converged;
    }

    /// Decides whether the next step has new matrices.
    /// @param told   whether the contraction tells how good those at hand are
    /// @param fresh  whether they are of this step
    void judge_matrices(bool told, bool fresh) {
        if (fresh) fresh_ = told ? contraction_ : std::min(fresh_, contraction_);
        // in frames that turn even new matrices leave about half the angle between the stages;
        // adaptive steps would pay for kept ones by shorter steps
        const bool keeps = frames_.turn() && !control_.is_adaptive();
        const double of_angle = keeps ? 1.5 * fresh_ : 0.0;
        renew_ = told && contraction_ > std::max(good_contraction, of_angle);
    }

    /// Tells whether so many corrections by the matrices at hand tell what is left: where fixed
    /// steps ask for round-off the first ratio flatters by powers of ten.
    [[nodiscard]] bool is_told(int since, double change) const {
        return control_.is_adaptive() || since > 2 || change <= round_off ||
               iterations_ == options_.max_iterations;
    }

    /// Solves for one correction and adds it; returns its size.
    [[nodiscard]] double correct(double h) {
        if (frames_.turn())
            for (std::size_t i = 0; i < stages_; ++i)
                frames_.carry(stage_[i].q, linearised_.q, force_[i].data());
        system_.solve(h, force_, lengths_, change_, lambda_change_);
        ++report_.iterations;
        double largest = 0.0;
        correction_energy_ = 0.0;
        for (std::size_t i = 0; i < stages_; ++i) {
            if (frames_.turn()) {
                const double energy = h * h * std::abs(change_[i].dot(force_[i]));
                correction_energy_ = std::max(correction_energy_, energy);
                frames_.carry(linearised_.q, stage_[i].q, change_[i].data());
            }
            Y_[i] += change_[i];
            lambda_[i] += lambda_change_[i];
            const double size = h * h * problem_.largest_ratio(change_[i]);
            if (!(size <= largest)) largest = size;
        }
        return largest;
    }

    /// Evaluates the residuals of all stages, and where it is renewed the tangent: of the middle
    /// stage, or in frames that turn of the start, which no prediction strains.
    [[nodiscard]] Status evaluate_stages(const Span& step, bool renew) {
        place_stages(step);
        const auto linearise = [&](const MotionPoint& at) {
            Status status = evaluate(at, Request::tangent_and_damping);
            if (status != Status::converged) return status;
            ++report_.jacobians;
            linearised_ = at;
            return system_.factorise(step.width, report_.factorisations);
        };
        if (renew && frames_.turn())
            if (const Status status = linearise(step.from); status != Status::converged)
                return status;
        const std::size_t middle = stages_ / 2;
        for (std::size_t k = 0; k < stages_; ++k) {
            const std::size_t i = (middle + k) % stages_;
            const bool tangent = renew && !frames_.turn() && i == middle;
            const Status status =
                tangent ? linearise(stage_[i]) : evaluate(stage_[i], Request::force);
            if (status != Status::converged) return status;
            force_[i] = problem_.force();
            lengths_[i] = problem_.constraint_residual();
        }
        stages_ == 3 ? add_inertia<3>() : add_inertia<5>();
        return Status::converged;
    }

    /// Adds M times the accelerations to the residuals, of all stages in one walk over M.
    template <int Count>
    void add_inertia() {
        const SparseMatrix& mass = problem_.compact_mass();
        const double* in[Count];
        double* out[Count];
        for (std::size_t i = 0; i < Count; ++i) {
            in[i] = acceleration_[i].data();
            out[i] = force_[i].data();
        }
        for (int row = 0; row < mass.cols(); ++row) {
            double sums[Count] = {};
            for (int k = mass.outerIndexPtr()[row]; k < mass.outerIndexPtr()[row + 1]; ++k) {
                const double value = mass.valuePtr()[k];
                const int column = mass.innerIndexPtr()[k];
                for (int i = 0; i < Count; ++i) sums[i] += value * in[i][column];
            }
            for (int i = 0; i < Count; ++i) out[i][row] += sums[i];
        }
    }

    /// Takes the first Y and multipliers from the polynomials of the step before, of its places
    /// offset + ratio c_i. Far beyond a short step they would tell of its round-off, as its
    /// multipliers do, of g/h^2: from there the step starts as a run does.
    void predict(double offset, double ratio) {
        const bool far = ratio > farthest_start;
        if (far || width_before_ == 0.0) {
            VectorX acceleration = now_.acceleration, lambda = now_.lambda;
            if (far) {
                ++report_.evaluations;
                // where that fails both stay
                (void)problem_.accelerations(now_.time, now_.q, now_.v, acceleration, lambda);
            }
            std::fill(acceleration_.begin(), acceleration_.end(), acceleration);
            std::fill(lambda_.begin(), lambda_.end(), lambda);
        } else {
            MatrixX weights(options_.stages, options_.stages);
            for (int i = 0; i < options_.stages; ++i) {
                const auto row =
                    lagrange_weights(tableau_.nodes, offset + ratio * tableau_.nodes[i]);
                for (int j = 0; j < options_.stages; ++j) weights(i, j) = row[j];
            }
            sum_stages(weights, 1.0, acceleration_before_, acceleration_);
            sum_stages(weights, 1.0, lambda_before_, lambda_);
        }
        sum_stages(tableau_.double_integral, 1.0, acceleration_, Y_);
    }

    /// Writes positions, rates and accelerations of the stages from Y.
    void place_stages(const Span& step) {
        const double h = step.width;
        const VectorX &q = step.from.q, &v = step.from.v;
        for (std::size_t i = 0; i < stages_; ++i) {
            MotionPoint& at = stage_[i];
            const double c = tableau_.nodes[i];
            at.time = i + 1 == stages_ ? step.end : step.from.time + c * h;
            at.q = q + (h * c * v + h * h * Y_[i]);
            at.lambda = lambda_[i];
        }
        sum_stages(tableau_.inverse, h, Y_, rate_change_);
        sum_stages(tableau_.square, 1.0, Y_, acceleration_);
        for (std::size_t i = 0; i < stages_; ++i) stage_[i].v = v + rate_change_[i];
    }

    /// Returns the local error of the step relative to the tolerance.
    [[nodiscard]] double error(double h) {
        const double tau = h / tableau_.eigenvalues.front().real();
        VectorX rates = now_.v, accelerations = now_.acceleration;
        for (std::size_t i = 0; i < stages_; ++i) {
            rates -= at_start_[i] * stage_[i].v;
            accelerations -= at_start_[i] * acceleration_[i];
        }
        rates *= tau;
        accelerations *= tau * tau;
        const VectorX& q = stage_[stages_ / 2].q;
        if (frames_.turn())
            for (VectorX* x : {&rates, &accelerations}) frames_.carry(q, linearised_.q, x->data());
        VectorX error = system_.filter(rates, accelerations);
        if (frames_.turn()) frames_.carry(linearised_.q, q, error.data());
        const double size = problem_.largest_ratio(error) / (share() * options_.tolerance);
        return std::isfinite(size) ? size : 1e10;
    }

    /// Makes the step that was taken the last one.
    void end_step(double width) {
        std::swap(earlier_, now_);
        std::swap(now_, next_);
        std::swap(acceleration_before_, acceleration_);
        std::swap(lambda_before_, lambda_);
        width_before_ = width;
        // the last one begins the next step
        knots_.erase(knots_.begin(), knots_.end() - (knots_.size() > 1 ? 1 : 0));
    }

    /// Interpolates in the last step.
    [[nodiscard]] MotionPoint between(double time) {
        if (knots_.size() < 2) make_knots();
        MotionPoint at{time, {}, {}, {}};
        interpolate(knots_, time, at.q, at.v);
        const double share = (time - earlier_.time) / (now_.time - earlier_.time);
        at.lambda = (1.0 - share) * earlier_.lambda + share * now_.lambda;
        if (has_short_step_) return at;
        const List<double> weights = lagrange_weights(tableau_.nodes, share);
        at.lambda.setZero();
        for (std::size_t i = 0; i < stages_; ++i)
            for (Eigen::Index k = 0; k < at.lambda.size(); ++k)
                at.lambda[k] += weights[i] * lambda_before_[i][k];
        return at;
    }

    /// Makes the knots of output in the last step: its ends, of five stages half a step between
    /// them.
    void make_knots() {
        if (knots_.empty()) add_knot(earlier_, earlier_.acceleration);
        const double h = 0.5 * width_before_;
        if (stages_ > 3 && solve_half({earlier_, h, earlier_.time + h}))
            add_knot(stage_.back(), acceleration_.back());
        add_knot(now_, now_.acceleration);
    }

    /// Adds a knot of output, its rates and accelerations on the constraints; output itself brings
    /// q there.
    void add_knot(const MotionPoint& at, const VectorX& acceleration) {
        Knot knot{at.time, at.q, at.v, acceleration};
        if (problem_.multipliers() > 0 && problem_.project_rates(knot.time, knot.q, knot.v, 1))
            (void)problem_.project_accelerations(knot.time, knot.q, knot.v, knot.acceleration);
        knots_.push_back(std::move(knot));
    }

    /// Solves the first half of the last step by the whole one's matrices, from its polynomials.
    [[nodiscard]] bool solve_half(const Span& half) {
        predict(0.0, 0.5);
        const double least = resolution * remoteness(now_.q);
        double before = 0.0;
        for (int iteration = 1; iteration <= options_.max_iterations; ++iteration) {
            if (evaluate_stages(half, false) != Status::converged) {
                report_.fault.reset();
                return false;
            }
            const double change = correct(half.width);
            if (!std::isfinite(change)) return false;
            const double ratio = iteration > 1 ? change / before : 0.5;
            if (iteration > 1 && ratio >= 1.0) {
                if (change > std::max({newton_tolerance_, round_off, least})) return false;
                break;
            }
            if (ratio / (1.0 - ratio) * change <= newton_tolerance_) break;
            before = change;
        }
        place_stages(half);
        return true;
    }

    const RadauOptions& options_;
    const RadauTableau tableau_;
    const std::size_t stages_;
    RadauSystem system_;
    TurningFrames frames_;
    double pull_ = 0.0;     // N m, of the last correction of multipliers
    bool balanced_ = true;  // whether kept matrices left little of them in the last step
    const double newton_tolerance_;
    const double of_accelerations_;  // the same, of what they move in a step
    const List<double> at_start_;    // l_i(0)

    Point now_, next_;
    Point earlier_;  // where the last step began

    // of the stages: (2), changes of rates, accelerations, multipliers, residuals, corrections
    Stages Y_, rate_change_, acceleration_, lambda_, force_, lengths_, change_, lambda_change_;
    List<MotionPoint> stage_;
    // of the step before
    Stages acceleration_before_, lambda_before_;
    double width_before_ = 0.0;
    double error_before_ = 0.0;  // relative to the scene

    // what Newton's method and the choice of steps keep
    MotionPoint linearised_;          // where the tangent of the matrices at hand was evaluated
    bool renew_ = true;               // whether the next step takes a new tangent
    double strain_ = 0.0;             // energy at the step's start, J
    double correction_energy_ = 0.0;  // of the last correction, J; 0 where frames do not turn
    double contraction_ = 0.0;        // by which corrections shrank in the last step that told it
    double fresh_ = 0.0;              // the same of the last step by a tangent of its own
    double eta_ = 1.0;                // what is left after a correction, over the correction
    int iterations_ = 0;              // of the last step
    double most_growth_ = largest_growth;
    bool rejected_ = false,
         failed_ = false;  // the last attempt, by its error or in Newton's method

    List<Knot> knots_;  // of output in the last step; less than two: to be made
};

}  // namespace detail

ANCF_INLINE void RadauOptions::check() const {
    detail::require(stages == 3 || stages == 5, "RadauOptions: stages must be 3 or 5, got ",
                    stages);
    detail::StepControl{step, tolerance, min_step, max_step}.check("RadauOptions");
    detail::require(std::isfinite(newton_tolerance) && newton_tolerance >= 0.0,
                    "RadauOptions: newton_tolerance must be positive, or 0 for a share of the "
                    "tolerance, got ",
                    newton_tolerance);
    detail::require(max_iterations >= 2, "RadauOptions: max_iterations must be at least 2, got ",
                    max_iterations);
}

ANCF_LAZY DynamicsReport RadauIIA::integrate(DynamicProblem& problem, LinearSolver& solver,
                                             const Schedule& schedule, const Memory& memory) const {
    return detail::RadauRun(problem, solver, schedule, options()).run(memory);
}

}  // namespace ancf
