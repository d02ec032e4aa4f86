// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of radau.hpp: one run of the method.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/dynamics/hermite.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/dynamics/radau_system.hpp>
#include <ancf/dynamics/radau_tableau.hpp>
#include <ancf/dynamics/recorder.hpp>
#include <ancf/error.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace ancf {
namespace detail {

/// One run.
class RadauRun {
public:
    ANCF_LAZY RadauRun(DynamicProblem& problem, LinearSolver& solver, const Schedule& schedule,
                       const RadauOptions& options, DynamicsReport& report);

    void run(const Memory& memory);

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

    enum class Ends { within, on_grid, off_grid };  // within a step that is taken in parts
    struct Step {
        double width, end;
        Ends ends;
    };

    static constexpr double smallest_part = 1e-3;     // of a fixed step that fails
    static constexpr double largest_growth = 8.0;     // of a step
    static constexpr double farthest_start = 10.0;    // steps that the last one's polynomials reach
    static constexpr double good_contraction = 0.03;  // by which matrices stay
    static constexpr double fair_contraction = 0.2;   // by a tangent of the step's own

    [[nodiscard]] bool adaptive() const { return options_.tolerance > 0.0; }
    [[nodiscard]] bool begin(const Memory& memory);
    void recall(const Memory& memory);
    void remember();
    [[nodiscard]] Step propose() const;
    [[nodiscard]] bool advance();
    void accept(const Step& step, double error);
    void change_step(double step);
    [[nodiscard]] double growth(double error) const;
    [[nodiscard]] Status newton(double h);
    [[nodiscard]] Status iterate(double h, bool renew);
    [[nodiscard]] double correct(double h);
    [[nodiscard]] Status evaluate(const MotionPoint& at, Request request);
    [[nodiscard]] Status evaluate_stages(const Span& step, bool renew);
    void predict(double offset, double ratio);
    void place_stages(const Span& step);
    [[nodiscard]] double error(double h);
    void end_step(double width);
    [[nodiscard]] MotionPoint between(double time);
    void make_knots();
    void add_knot(const MotionPoint& at, const VectorX& acceleration);
    [[nodiscard]] bool solve_half(const Span& half);
    [[nodiscard]] double scaled(const VectorX& q) const {
        return largest_ratio(q, problem_.scales());
    }
    void fail(Status status, std::string message) {
        report_.status = status;
        report_.message = std::move(message);
        if (report_.fault) report_.message += "; " + problem_.assembly().describe(*report_.fault);
    }

    DynamicProblem& problem_;
    const Schedule& schedule_;
    const RadauOptions& options_;
    DynamicsReport& report_;
    Recorder recorder_;
    const RadauTableau tableau_;
    const std::size_t stages_;
    RadauSystem system_;
    const double newton_tolerance_;
    const double round_off_;              // corrections that no longer shrink may be as large
    const std::vector<double> at_start_;  // l_i(0)

    Point now_, next_;
    Point earlier_;                                   // where the last step began
    double origin_ = 0.0, count_ = 0.0, step_ = 0.0;  // grid of steps: origin + count step
    double whole_ = 0.0;                              // s, from the start to the schedule's end
    double part_ = 0.0;                               // of a step that failed; 0: whole steps
    int parts_ = 1;  // into which the turn of a joint divides the step

    // of the stages: (2), accelerations, residuals, multipliers, corrections
    Stages Y_, acceleration_, lambda_, force_, lengths_, change_, lambda_change_;
    std::vector<MotionPoint> stage_;
    // of the step before
    Stages acceleration_before_, lambda_before_;
    double width_before_ = 0.0;

    // what Newton's method and the choice of steps keep
    MotionPoint linearised_;    // where the tangent of the matrices at hand was evaluated
    bool renew_ = true;         // whether the next step takes a new tangent
    double contraction_ = 0.0;  // by which corrections shrank in the last step that told it
    double fresh_ = 0.0;        // the same of the last step by a tangent of its own
    double eta_ = 1.0;          // what is left after a correction, over the correction
    int iterations_ = 0;        // of the last step
    double most_growth_ = largest_growth;
    bool rejected_ = false,
         failed_ = false;  // the last attempt, by its error or in Newton's method

    std::vector<Knot> knots_;  // of output in the last step; none: to be made
};

ANCF_LAZY RadauRun::RadauRun(DynamicProblem& problem, LinearSolver& solver,
                             const Schedule& schedule, const RadauOptions& options,
                             DynamicsReport& report)
    : problem_(problem),
      schedule_(schedule),
      options_(options),
      report_(report),
      recorder_(problem, schedule, report, options.follow_energy),
      tableau_(radau_tableau(options.stages)),
      stages_(static_cast<std::size_t>(options.stages)),
      system_(problem, solver, tableau_),
      newton_tolerance_(options.newton_tolerance > 0.0 ? options.newton_tolerance
                        : options.tolerance > 0.0
                            ? (options.stages > 3 ? 0.01 : 0.03) * options.tolerance
                            : 1e-13),
      round_off_(std::max(1e-10, newton_tolerance_)),
      at_start_(lagrange_weights(tableau_.nodes, 0.0)),
      Y_(stages_, VectorX::Zero(problem.size())),
      acceleration_(Y_),
      lambda_(stages_, VectorX::Zero(problem.multipliers())),
      force_(Y_),
      lengths_(lambda_),
      change_(Y_),
      lambda_change_(lambda_),
      stage_(stages_),
      acceleration_before_(Y_),
      lambda_before_(lambda_) {}

ANCF_INLINE void RadauRun::run(const Memory& memory) {
    if (!begin(memory)) return;
    recorder_.start(now_);
    while (goes_on(now_, schedule_.end, std::min(step_, whole_)) && advance()) {
        if (!goes_on(now_, schedule_.end, std::min(step_, whole_))) now_.time = schedule_.end;
        if (recorder_.step(earlier_, now_, [this](double time) { return between(time); })) continue;
        fail(Status::stopped, "the progress callback asked to stop");
        break;
    }
    recorder_.finish(now_);
    remember();
}

ANCF_INLINE bool RadauRun::begin(const Memory& memory) {
    const Start start = problem_.start();
    report_.time = start.time;
    ++report_.evaluations;
    if (start.status != Status::converged) {
        fail(start.status, start.message);
        return false;
    }
    static_cast<MotionPoint&>(now_) = {start.time, start.q, start.v, start.multipliers};
    now_.acceleration = start.acceleration;
    origin_ = start.time;
    whole_ = schedule_.end - start.time;
    step_ = adaptive() ? std::min(options_.step, options_.max_step) : options_.step;
    if (!memory.empty()) recall(memory);
    next_ = now_;
    return true;
}

/// Returns the step to the next point of the grid, or to the schedule's end if that comes first;
/// where steps are divided, the next part of it.
ANCF_INLINE RadauRun::Step RadauRun::propose() const {
    const double grid = origin_ + (count_ + 1.0) * step_;
    const bool on_grid = schedule_.end >= grid - 1e-9 * step_;
    const double end = on_grid ? grid : schedule_.end, rest = end - now_.time;
    if (part_ > 0.0 && rest > part_ * (1.0 + 1e-6)) return {part_, now_.time + part_, Ends::within};
    const bool full = on_grid && std::abs(rest - step_) <= 1e-6 * step_;
    return {full ? step_ : rest, end, on_grid ? Ends::on_grid : Ends::off_grid};
}

ANCF_INLINE void RadauRun::change_step(double step) {
    step_ = step;
    origin_ = now_.time;
    count_ = 0.0;
}

/// Takes one step into next_, again with smaller ones where the run is adaptive, and in parts where
/// it is not.
ANCF_INLINE bool RadauRun::advance() {
    for (;;) {
        const Step step = propose();
        next_.time = step.end;
        const auto& constraints = problem_.model().constraints();
        const DrivenTurn turn = driven_turn(constraints, now_.time, next_.time);
        if (!turn.fits() && !adaptive() && part_ == 0.0) {
            parts_ = parts_for_turns(constraints, now_.time, next_.time);
            part_ = step.width / parts_;
            if (part_ < step.width) continue;
        }
        const Status status = turn.fits() ? newton(step.width) : Status::diverged;
        double error = 0.0;
        if (status == Status::converged && adaptive()) error = this->error(step.width);
        if (status == Status::converged && error <= 1.0) {
            accept(step, error);
            end_step(step.width);
            return true;
        }
        if (turn.fits())
            status == Status::converged ? ++report_.rejected : ++report_.convergence_failures;
        const auto why = [&] {
            return turn.fits() ? std::string()
                               : "; " + driven_turn_text(constraints, turn, now_.time, next_.time);
        };
        if (!adaptive()) {
            part_ = 0.5 * step.width;
            if (parts_ * part_ > smallest_part * step_) continue;
            fail(status, joined({"Newton's method failed in the step from ", now_.time,
                                 " s: ", to_string(status), ", also in parts of ", step.width,
                                 " s; a shorter step or adaptive steps (tolerance > 0) may pass"},
                                6) +
                             why());
            return false;
        }
        if (status == Status::converged) {
            change_step(step.width * growth(error));
            rejected_ = true;
        } else {
            change_step(step.width * (failed_ || !turn.fits() ? 0.5 : 0.7));
            most_growth_ = 1.1;
            failed_ = true;
        }
        if (step_ >= options_.min_step) continue;
        fail(Status::step_too_small,
             joined({"the step fell below ", options_.min_step, " s at ", now_.time, " s, last of ",
                     status == Status::converged ? "the local error" : to_string(status)},
                    6) +
                 why());
        return false;
    }
}

/// Returns by what the next step is longer, after an error relative to the tolerance.
ANCF_INLINE double RadauRun::growth(double error) const {
    const double most = options_.max_iterations;
    const double safety = 0.9 * (2.0 * most + 1.0) / (2.0 * most + iterations_);
    const double power = 1.0 / static_cast<double>(stages_ + 1);
    return std::max(safety * std::pow(std::max(error, 1e-10), -power), 0.2);
}

/// Settles the next step's width.
ANCF_INLINE void RadauRun::accept(const Step& step, double error) {
    const bool attempted = rejected_ || failed_;
    rejected_ = failed_ = false;
    if (step.ends == Ends::within) return;
    part_ = 0.0;
    parts_ = 1;
    count_ += 1.0;
    bool change = false;
    if (adaptive() && step.width == step_) {
        double factor = std::min(growth(error), attempted ? 1.0 : most_growth_);
        // what a fresh tangent hardly solves a longer step would not
        if (fresh_ > fair_contraction)
            factor = std::min(factor, std::max(0.9, std::sqrt(fair_contraction / fresh_)));
        most_growth_ = std::min(largest_growth, most_growth_ * 1.02);
        // a step keeps its width, and the matrices, unless a change is worth it
        change = factor < 0.95 || factor > (most_growth_ < 1.6 ? 1.25 : 1.6);
        if (change) step_ = std::min(step_ * factor, options_.max_step);
    }
    if (change || step.ends == Ends::off_grid) {
        origin_ = next_.time;
        count_ = 0.0;
    }
}

/// Makes the step that was taken the last one.
ANCF_INLINE void RadauRun::end_step(double width) {
    std::swap(earlier_, now_);
    std::swap(now_, next_);
    std::swap(acceleration_before_, acceleration_);
    std::swap(lambda_before_, lambda_);
    width_before_ = width;
    knots_.clear();
}

/// Solves one step by Newton's method, again with a new tangent where the old one fails.
ANCF_INLINE Status RadauRun::newton(double h) {
    if (!renew_ && system_.width() == h && iterate(h, false) == Status::converged)
        return Status::converged;
    return iterate(h, true);
}

ANCF_INLINE Status RadauRun::evaluate(const MotionPoint& at, Request request) {
    ++report_.evaluations;
    report_.fault = problem_.evaluate(at.time, at.q, at.v, at.lambda, request);
    return report_.fault ? report_.fault->status : Status::converged;
}

/// Evaluates the residuals of all stages, of the middle one with the tangent where it is renewed.
ANCF_INLINE Status RadauRun::evaluate_stages(const Span& step, bool renew) {
    place_stages(step);
    const std::size_t middle = stages_ / 2;
    for (std::size_t k = 0; k < stages_; ++k) {
        const std::size_t i = (middle + k) % stages_;
        const bool tangent = renew && i == middle;
        if (const Status status =
                evaluate(stage_[i], tangent ? Request::tangent_and_damping : Request::force);
            status != Status::converged)
            return status;
        force_[i] = problem_.force();
        add_product(problem_.compact_mass(), Storage::full, 1.0, acceleration_[i], force_[i]);
        lengths_[i] = problem_.constraint_residual();
        if (!tangent) continue;
        ++report_.jacobians;
        linearised_ = stage_[i];
        if (const Status status = system_.factorise(step.width, report_.factorisations);
            status != Status::converged)
            return status;
    }
    return Status::converged;
}

/// Writes positions, rates and accelerations of the stages from Y.
ANCF_INLINE void RadauRun::place_stages(const Span& step) {
    const double h = step.width;
    const VectorX &q = step.from.q, &v = step.from.v;
    for (std::size_t i = 0; i < stages_; ++i) {
        MotionPoint& at = stage_[i];
        const auto row = static_cast<Eigen::Index>(i);
        const double c = tableau_.nodes[i];
        at.time = i + 1 == stages_ ? step.end : step.from.time + c * h;
        at.q = q + (h * c * v + h * h * Y_[i]);
        at.v = v;
        acceleration_[i].setZero();
        at.lambda = lambda_[i];
        for (std::size_t j = 0; j < stages_; ++j) {
            const auto column = static_cast<Eigen::Index>(j);
            at.v += h * tableau_.inverse(row, column) * Y_[j];
            acceleration_[i] += tableau_.square(row, column) * Y_[j];
        }
    }
}

/// Takes the first Y and multipliers from the polynomials of the step before, of its places
/// offset + ratio c_i. Far beyond a short step they would tell of its round-off, as its multipliers
/// do, of g/h^2: from there the step starts as a run does.
ANCF_INLINE void RadauRun::predict(double offset, double ratio) {
    const bool far = ratio > farthest_start;
    VectorX acceleration = now_.acceleration, lambda = now_.lambda;
    if (far) {
        ++report_.evaluations;
        if (problem_.accelerations(now_.time, now_.q, now_.v, acceleration, lambda) !=
            Status::converged)
            std::tie(acceleration, lambda) = std::tie(now_.acceleration, now_.lambda);
    }
    for (std::size_t i = 0; i < stages_; ++i) {
        if (width_before_ == 0.0 || far) {
            acceleration_[i] = acceleration;
            lambda_[i] = lambda;
            continue;
        }
        const std::vector<double> weights =
            lagrange_weights(tableau_.nodes, offset + ratio * tableau_.nodes[i]);
        acceleration_[i].setZero();
        lambda_[i].setZero();
        for (std::size_t j = 0; j < stages_; ++j) {
            acceleration_[i] += weights[j] * acceleration_before_[j];
            lambda_[i] += weights[j] * lambda_before_[j];
        }
    }
    for (std::size_t i = 0; i < stages_; ++i) {
        Y_[i].setZero();
        for (std::size_t j = 0; j < stages_; ++j)
            Y_[i] += tableau_.double_integral(static_cast<Eigen::Index>(i),
                                              static_cast<Eigen::Index>(j)) *
                     acceleration_[j];
    }
}

/// Iterates from the prediction, with a new tangent of the middle stage or the matrices at hand.
ANCF_INLINE Status RadauRun::iterate(double h, bool renew) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    constexpr double nothing = epsilon * epsilon;  // of a correction, relative to the scene
    const bool constrained = problem_.multipliers() > 0;
    const Span step{now_, h, next_.time};
    predict(1.0, width_before_ > 0.0 ? h / width_before_ : 0.0);
    int tangents = 0;  // of this step
    int since = 0;     // corrections by the matrices at hand
    double before = 0.0, ratio_before = 0.0;
    const double expected = std::min(contraction_, 0.5);
    eta_ = std::pow(std::max(eta_, 1e-16), 0.8);
    for (iterations_ = 1;; ++iterations_) {
        if (iterations_ > options_.max_iterations) return Status::max_iterations;
        if (const Status status = evaluate_stages(step, renew); status != Status::converged)
            return status;
        if (renew) {
            ++tangents;
            since = 0;
            renew = false;
        }
        const double change = correct(h);
        if (!std::isfinite(change)) return Status::not_finite;
        const double ratio = iterations_ > 1 ? change / before : 0.0;
        // at the round-off of the residual the corrections no longer shrink; in a scene at rest
        // they are round-off of nothing, and tell nothing of the matrices
        if (change <= nothing || (ratio >= 1.0 && change <= round_off_)) break;
        if (++since > 1) {
            // a first ratio may flatter: it stands beside that of the step before
            contraction_ =
                since == 2 ? std::max(ratio, 0.5 * expected) : std::sqrt(ratio * ratio_before);
            if (contraction_ >= 0.99) return Status::diverged;
            eta_ = contraction_ / (1.0 - contraction_);
            const double left = eta_ * change;
            const int rest = options_.max_iterations - iterations_;
            renew =
                left > newton_tolerance_ && left * std::pow(contraction_, rest) > newton_tolerance_;
            if (renew && tangents == 2 && adaptive()) return Status::max_iterations;
        }
        // one correction tells nothing of new matrices, and leaves g off its zero by kept ones
        if ((iterations_ > 1 || (tangents == 0 && !constrained)) &&
            eta_ * change <= newton_tolerance_)
            break;
        before = change;
        ratio_before = ratio;
    }
    renew_ = contraction_ > good_contraction;
    if (tangents > 0) fresh_ = contraction_;
    place_stages(step);
    next_.q = stage_.back().q;
    next_.v = stage_.back().v;
    next_.lambda = lambda_.back();
    next_.acceleration = acceleration_.back();
    return Status::converged;
}

/// Solves for one correction and adds it; returns its size.
ANCF_INLINE double RadauRun::correct(double h) {
    system_.solve(h, force_, lengths_, change_, lambda_change_);
    ++report_.iterations;
    double largest = 0.0;
    for (std::size_t i = 0; i < stages_; ++i) {
        Y_[i] += change_[i];
        lambda_[i] += lambda_change_[i];
        const double size = h * h * scaled(change_[i]);
        if (!(size <= largest)) largest = size;
    }
    return largest;
}

/// Returns the local error of the step relative to the tolerance.
ANCF_INLINE double RadauRun::error(double h) {
    const double tau = h / tableau_.modes.front().eigenvalue.real();
    VectorX rates = now_.v, accelerations = now_.acceleration;
    for (std::size_t i = 0; i < stages_; ++i) {
        rates -= at_start_[i] * stage_[i].v;
        accelerations -= at_start_[i] * acceleration_[i];
    }
    rates *= tau;
    accelerations *= tau * tau;
    const double size = scaled(system_.filter(rates, accelerations)) / options_.tolerance;
    return std::isfinite(size) ? size : 1e10;
}

/// Adds a knot of output, its rates and accelerations on the constraints; output itself brings q
/// there.
ANCF_INLINE void RadauRun::add_knot(const MotionPoint& at, const VectorX& acceleration) {
    Knot knot{at.time, at.q, at.v, acceleration};
    if (problem_.multipliers() > 0 && problem_.project_rates(knot.time, knot.q, knot.v))
        (void)problem_.project_accelerations(knot.time, knot.q, knot.v, knot.acceleration);
    knots_.push_back(std::move(knot));
}

/// Makes the knots of output in the last step: its ends, of five stages half a step between them.
ANCF_INLINE void RadauRun::make_knots() {
    add_knot(earlier_, earlier_.acceleration);
    const double h = 0.5 * width_before_;
    if (stages_ > 3 && solve_half({earlier_, h, earlier_.time + h}))
        add_knot(stage_.back(), acceleration_.back());
    add_knot(now_, now_.acceleration);
}

/// Solves the first half of the last step by the whole one's matrices, from its polynomials.
ANCF_INLINE bool RadauRun::solve_half(const Span& half) {
    predict(0.0, 0.5);
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
            if (change > round_off_) return false;
            break;
        }
        if (ratio / (1.0 - ratio) * change <= newton_tolerance_) break;
        before = change;
    }
    place_stages(half);
    return true;
}

/// Interpolates in the last step.
ANCF_INLINE MotionPoint RadauRun::between(double time) {
    if (knots_.empty()) make_knots();
    MotionPoint at;
    at.time = time;
    interpolate(knots_, time, at.q, at.v);
    const std::vector<double> weights =
        lagrange_weights(tableau_.nodes, (time - earlier_.time) / (now_.time - earlier_.time));
    at.lambda = VectorX::Zero(problem_.multipliers());
    for (std::size_t i = 0; i < stages_; ++i)
        for (Eigen::Index k = 0; k < at.lambda.size(); ++k)
            at.lambda[k] += weights[i] * lambda_before_[i][k];
    return at;
}

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

ANCF_INLINE void RadauRun::remember() {
    Memory& memory = report_.memory;
    memory.integrator = "radau";
    memory.put("q", now_.q);
    memory.put("v", now_.v);
    memory.put("lambda", now_.lambda);
    memory.put("acceleration", now_.acceleration);
    memory.put("stage_accelerations", joined_stages(acceleration_before_));
    memory.put("stage_multipliers", joined_stages(lambda_before_));
    const double factorised = renew_ ? 0.0 : system_.width();
    VectorX scalars(15);
    scalars << now_.time, origin_, count_, step_, width_before_, linearised_.time, factorised,
        contraction_, fresh_, eta_, most_growth_, rejected_ ? 1.0 : 0.0, failed_ ? 1.0 : 0.0,
        static_cast<double>(stages_), problem_.length_scale();
    memory.put("scalars", scalars);
    memory.put("signature", signature(problem_, now_));
    if (factorised == 0.0) return;
    memory.put("linearised_q", linearised_.q);
    memory.put("linearised_v", linearised_.v);
    memory.put("linearised_lambda", linearised_.lambda);
}

ANCF_INLINE void RadauRun::recall(const Memory& memory) {
    const int n = problem_.size();
    const int m = problem_.multipliers();
    const auto stages = static_cast<Eigen::Index>(stages_);
    require(memory.integrator == "radau", "RadauIIA: the memory is that of ", memory.integrator);
    const VectorX& scalars = memory.get("scalars", 15);
    require(std::abs(scalars[0] - now_.time) <= 1e-12 * std::abs(now_.time) + 1e-9 * scalars[3],
            "RadauIIA: the memory is of time ", scalars[0], " s, the model of ", now_.time, " s");
    require(scalars[13] == static_cast<double>(stages_), "RadauIIA: the memory is of ", scalars[13],
            " stages, the options have ", options_.stages);
    problem_.set_length_scale(scalars[14]);
    const MotionPoint start = now_;
    static_cast<MotionPoint&>(now_) = {scalars[0], memory.get("q", n), memory.get("v", n),
                                       memory.get("lambda", m)};
    require_continuation("RadauIIA", memory, problem_, start, now_);
    now_.acceleration = memory.get("acceleration", n);
    part_stages(memory.get("stage_accelerations", n * stages), acceleration_before_);
    part_stages(memory.get("stage_multipliers", m * stages), lambda_before_);
    width_before_ = scalars[4];
    origin_ = now_.time;
    if (adaptive() || scalars[3] == options_.step) {
        origin_ = scalars[1];
        count_ = scalars[2];
        step_ = scalars[3];
    }
    if (adaptive() && step_ > options_.max_step) change_step(options_.max_step);
    contraction_ = scalars[7];
    fresh_ = scalars[8];
    eta_ = scalars[9];
    most_growth_ = scalars[10];
    rejected_ = scalars[11] != 0.0;
    failed_ = scalars[12] != 0.0;
    if (scalars[6] == 0.0) return;
    linearised_ = {scalars[5], memory.get("linearised_q", n), memory.get("linearised_v", n),
                   memory.get("linearised_lambda", m)};
    if (evaluate(linearised_, Request::tangent_and_damping) == Status::converged &&
        system_.factorise(scalars[6], report_.factorisations) == Status::converged)
        renew_ = false;  // where that fails the first step takes a tangent of its own
}

}  // namespace detail

ANCF_INLINE void RadauOptions::check() const {
    detail::require(stages == 3 || stages == 5, "RadauOptions: stages must be 3 or 5, got ",
                    stages);
    detail::require(std::isfinite(tolerance) && tolerance >= 0.0,
                    "RadauOptions: tolerance must be positive, or 0 for fixed steps, got ",
                    tolerance);
    detail::require_positive("RadauOptions: step", step);
    detail::require_positive("RadauOptions: min_step", min_step);
    detail::require(max_step >= min_step, "RadauOptions: max_step must be at least min_step, ",
                    min_step, ", got ", max_step);
    detail::require(std::isfinite(newton_tolerance) && newton_tolerance >= 0.0,
                    "RadauOptions: newton_tolerance must be positive, or 0 for a share of the "
                    "tolerance, got ",
                    newton_tolerance);
    detail::require(max_iterations >= 2, "RadauOptions: max_iterations must be at least 2, got ",
                    max_iterations);
}

ANCF_LAZY DynamicsReport RadauIIA::integrate(DynamicProblem& problem, LinearSolver& solver,
                                             const Schedule& schedule, const Memory& memory) const {
    detail::require_same_storage(solver, problem);
    detail::require_motion(problem);
    schedule.check(problem.model().state().time);
    detail::require_resolved(options_.step, problem.model().state().time, schedule.end);
    DynamicsReport report;
    detail::RadauRun(problem, solver, schedule, options_, report).run(memory);
    return report;
}

}  // namespace ancf
