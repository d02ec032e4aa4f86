// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/constants.hpp>
#include <ancf/error.hpp>
#include <ancf/sundials/ida.hpp>
#include <ancf/sundials/ida_system.hpp>
#include <ancf/sundials/run.hpp>

#include <sunlinsol/sunlinsol_klu.h>
#include <sunnonlinsol/sunnonlinsol_newton.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace ancf::sundials {
namespace detail {

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
class IdaRun : SteppedRun {
public:
    IdaRun(DynamicProblem& problem, const Schedule& schedule, const IdaOptions& options)
        : SteppedRun("Ida", &IDAGetReturnFlagName, problem, schedule, options.follow_energy,
                     report_),
          options_(options),
          system_(problem, options.form == Form::gear_gupta_leimkuhler),
          y_(make_vector(context_, system_.size())),
          dy_(make_vector(context_, system_.size())),
          tolerances_(make_vector(context_, system_.size())),
          dense_(make_vector(context_, system_.size())),
          matrix_(make_matrix(context_, system_.size(), system_.map().values())),
          klu_(made(SUNLinSol_KLU(y_.get(), matrix_.get(), context_.get()))),
          turned_(make_turned()),
          ida_(made(IDACreate(context_.get()))) {
#if SUNDIALS_VERSION_MAJOR < 7
        IDASetErrHandlerFn(ida_.get(), &Context::take, &context_);
#endif
    }

    IdaReport run() {
        if (!starts()) return std::move(report_);
        set_up();
        now_ = point(now_.time, y_.get());
        recorder_.start(now_);
        while (now_.time < schedule_.end && step()) {
        }
        const Counts all = counts();
        report_.rejected = all[rejected];
        report_.convergence_failures = all[failures];
        report_.iterations = all[corrections];
        report_.evaluations += all[evaluations];
        report_.jacobians = all[jacobians];
        report_.factorisations = all[factorisations];
        report_.code = code_name(code_);
        recorder_.finish(now_);
        return std::move(report_);
    }

private:
    // What IDA counts, and forgets at a jump.
    enum Count { rejected, failures, corrections, evaluations, jacobians, factorisations };
    using Counts = std::array<long, 6>;

    // Of the run.
    [[nodiscard]] Counts counts() const {
        constexpr int (*functions[])(void*, long*) = {
            IDAGetNumErrTestFails,    IDAGetNumNonlinSolvConvFails,
            IDAGetNumNonlinSolvIters, IDAGetNumResEvals,
            IDAGetNumJacEvals,        IDAGetNumLinSolvSetups};
        Counts all = before_;
        for (std::size_t i = 0; i < all.size(); ++i) {
            long more = 0;
            functions[i](ida_.get(), &more);
            all[i] += more;
        }
        return all;
    }

    [[nodiscard]] int order_limit() {
        if (options_.order != Order::automatic) return options_.order == Order::two ? 2 : 5;
        // Order 5 holds the step below 0.7/omega_max; so many steps while the scene turns once are
        // too many.
        constexpr double steps_in_a_period = 20000.0;
        constexpr double stable = 0.7;
        report_.highest_frequency = problem_.highest_frequency(start_.time, start_.q);
        // a stiff joint carries no motion of its own, but its frequency would hold order 5's step
        // down; a rigid body, of one node too, has a position and no stiffness
        for (const auto& group : problem_.model().groups())
            if (group->one_node() && !group->fields().contains(Field::r)) return 2;
        if (slow_frequency_ == 0.0) return 5;
        double period = 2.0 * pi / slow_frequency_;
        // what is at rest may be driven far more slowly than it vibrates
        if (problem_.motion_frequency(start_) == 0.0)
            period = std::max(period, schedule_.end - start_.time);
        return period * report_.highest_frequency / stable > steps_in_a_period ? 2 : 5;
    }

    void set_up() {
        void* ida = ida_.get();
        slow_frequency_ = slow_frequency();
        report_.order = order_limit();
        constexpr double loosest = 1e-4;  // of stiff scenes
        tolerance_ =
            report_.order == 2 ? std::min(options_.tolerance, loosest) : options_.tolerance;
        set_start();
        call(IDAInit(ida, &IdaSystem::residual, start_.time, y_.get(), dy_.get()));
        call(IDASetUserData(ida, &system_));
        system_.set_tolerances(tolerance_, tolerances_.get());
        call(IDAWFtolerances(ida, &IdaSystem::weights));
        choose_error_test();
        SUNLinSol_KLUSetOrdering(klu_.get(), 0);  // AMD: the pattern is nearly symmetric
        call(IDASetLinearSolver(ida, turned_.get(), matrix_.get()));
        call(IDASetJacFn(ida, &IdaSystem::jacobian));
        if (report_.order == 2) {
            recorder_.forbid_gain(0.01, "a smaller tolerance", true);
            system_.frames().turn_at_once();
            measure_rate();
            highest_frequency_ = report_.highest_frequency;
            if (options_.order == Order::two)
                highest_frequency_ = problem_.highest_frequency(start_.time, start_.q);
        }
        call(IDASetMaxOrd(ida, report_.order));
        call(IDASetDeltaCjLSetup(ida, 0.05));
        call(IDASetMaxNonlinIters(ida, report_.order == 2 ? 7 : 6));
        call(IDASetNonlinConvCoef(ida, 0.1));
        if (options_.form == Form::index3 && problem_.multipliers() > 0)
            inertia_round_off_ = problem_.round_off_of(problem_.mass());
        first_step_ = first_step();
        call(IDASetInitStep(ida, first_step_));
        call(IDASetMinStep(ida, least_step()));
        if (options_.max_step > 0.0) call(IDASetMaxStep(ida, options_.max_step));
    }

    // Fills y and dy, in units of the absolute tolerances. Rates are measured by the highest
    // frequency where it is known: c is of that size where accuracy asks for no smaller step.
    void set_start() {
        auto absolute = view(tolerances_.get());
        fill_tolerances(absolute);
        VectorX sizes = absolute;
        if (report_.highest_frequency > 0.0)
            system_.v(sizes) = report_.highest_frequency * system_.q(absolute);
        system_.set_units(sizes);
        absolute = absolute.cwiseQuotient(system_.units());
        write_start();
    }

    // Fills y and dy.
    void write_start() {
        auto y = view(y_.get());
        auto dy = view(dy_.get());
        y.setZero();
        dy.setZero();
        system_.q(y) = start_.q;
        system_.v(y) = start_.v;
        system_.lambda(y) = start_.multipliers;
        system_.q(dy) = start_.v;
        system_.v(dy) = start_.acceleration;
        for (auto& column : {&y, &dy}) *column = column->cwiseQuotient(system_.units());
    }

    // The absolute tolerances, in the units of the scene.
    void fill_tolerances(Eigen::Map<VectorX>& absolute) {
        double length = options_.length_scale;
        if (length == 0.0) length = problem_.length_scale();
        double velocity = options_.velocity_scale;
        if (velocity == 0.0) velocity = velocity_scale(length, slow_frequency_);
        double force = options_.force_scale;
        if (force == 0.0) force = problem_.force_scale(start_);
        if (force == 0.0) {
            const VectorX sizes = problem_.scales() / problem_.length_scale();
            const double mass =
                problem_.compact_mass().diagonal().cwiseProduct(sizes.cwiseAbs2()).maxCoeff();
            force = mass * velocity * velocity / length;
        }
        VectorX sizes;
        problem_.numbering().gather_free(problem_.scales_of(length), sizes);
        system_.q(absolute) = tolerance_ * sizes;
        system_.v(absolute) = tolerance_ * velocity / length * sizes;
        // Newton's method cannot bring multipliers below the round-off of the forces they balance,
        // of which it sees a part. Where that hides the forces themselves, step() ends the run.
        const double round_off = 0.05 * problem_.force_round_off(start_.time, start_.q);
        hides_forces_ = !(round_off < force);
        const double resolved = hides_forces_ ? 0.0 : round_off;
        // a multiplier has the unit of a force where its equation is a length, else another one
        const VectorX arms = problem_.assembly().violation_scale(length) / length;
        const auto measured = [&](double least, auto&& multipliers) {
            for (Eigen::Index i = 0; i < multipliers.size(); ++i)
                multipliers[i] = arms[i] > 0.0 ? least / arms[i] : least;
        };
        least_ = std::max(tolerance_ * force, resolved);
        most_ = 1e-3 * force;
        measured(least_, system_.lambda(absolute));
        measured(tolerance_ * force * length / velocity, system_.mu(absolute));
    }

    // By how much Newton's method must fall below a tolerance: 0.33 of IDA times the coefficient
    // that set_up() gives it.
    static constexpr double asked = 32.0;

    // Lets the tolerance of multipliers be no less than what round-off of the inertia forces leaves
    // in them: in short steps Newton's method could not bring them below. It takes all of the
    // round-off in a step that is cut short, and `asked` times as much where a run begins, whose
    // first corrections are no larger; else a twentieth, as of elastic forces. No more than a
    // thousandth of the forces, but in a step that is cut, where multipliers are those of the
    // state.
    // @param rest  s, to the time where the step has to end
    void resolve_multipliers(double rest) {
        if (inertia_round_off_ == 0.0) return;
        double length = first_step_, last = 0.0;
        if (!begins_) IDAGetCurrentStep(ida_.get(), &length);
        if (!begins_) IDAGetLastStep(ida_.get(), &last);
        const bool is_cut = 2.0 * rest < last;
        const bool begins = now_.time - start_.time < 10.0 * first_step_;
        length = std::min(length, rest);
        double left = inertia_round_off_ / (length * length);
        if (!is_cut) left *= begins ? asked : 0.05;
        if (!is_cut) left = std::min(left, most_);
        double loosened = 1.0;
        if (left > least_) loosened = std::exp2(std::ceil(std::log2(left / least_)));
        if (loosened == loosened_) return;
        auto tolerances = view(tolerances_.get());
        system_.lambda(tolerances) *= loosened / loosened_;
        loosened_ = loosened;
    }

    // The error test sees positions, and rates where the form holds them on the constraints.
    void choose_error_test() {
        auto differential = view(dense_.get());
        differential.setZero();
        system_.q(differential).setOnes();
        if (options_.form == Form::gear_gupta_leimkuhler) system_.v(differential).setOnes();
        call(IDASetId(ida_.get(), dense_.get()));
        call(IDASetSuppressAlg(ida_.get(), SUNTRUE));
    }

    // KLU, in frames that turn with the nodes.
    [[nodiscard]] LinearSolverOwner make_turned() {
        LinearSolverOwner solver(made(SUNLinSolNewEmpty(context_.get())));
        solver->content = this;
        solver->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; };
        solver->ops->setup = [](SUNLinearSolver self, SUNMatrix matrix) {
            return SUNLinSolSetup(static_cast<IdaRun*>(self->content)->klu_.get(), matrix);
        };
        solver->ops->solve = [](SUNLinearSolver self, SUNMatrix matrix, N_Vector x, N_Vector b,
                                sunrealtype) {
            auto& run = *static_cast<IdaRun*>(self->content);
            if (run.begins_astray()) {
                double c = 0.0;
                IDAGetCurrentCj(run.ida_.get(), &c);
                return run.system_.keep_strains(c, 0.5 * (1.0 + c / run.system_.c()), x);
            }
            return run.system_.solve(run.klu_.get(), matrix, x, b);
        };
        solver->ops->free = [](SUNLinearSolver self) {
            SUNLinSolFreeEmpty(self);
            return 0;
        };
        return solver;
    }

    // The corrections of a step, in one measure.
    struct Corrections {
        double first = 0.0, rate = 0.0;

        // Returns what the correction after so many others leaves, as their rate tells.
        [[nodiscard]] double left(double size, int corrections) {
            if (corrections == 0) first = size;
            rate = corrections == 0 ? 0.0 : std::pow(size / first, 1.0 / corrections);
            if (size == 0.0) return 0.0;
            if (corrections == 0) return 1e4 * size;
            return rate < 1.0 ? rate / (1.0 - rate) * size
                              : std::numeric_limits<double>::infinity();
        }
    };

    // Whether a first correction is to take back the strains of the prediction.
    [[nodiscard]] bool begins_astray() {
        if (astray_ == 0) return false;
        int corrections = 0;
        SUNNonlinSolGetCurIter(newton_.get(), &corrections);
        return corrections == 0;
    }

    // IDA ends a step after one correction where the matrix once converged fast. As a stiff body
    // turns that matrix grows old: forces stay unbalanced, and the body loses its spin. So every
    // step measures its own rate. Otherwise it is IDA's test, but a first correction ends a step
    // below 1e-4 of what is allowed, not below 1e-8, and what is left strains no stiff body by more
    // than the tolerance allows of the energy of the motion, in frames that turn.
    void measure_rate() {
        newton_.reset(made(SUNNonlinSol_Newton(y_.get(), context_.get())));
        call(IDASetNonlinearSolver(ida_.get(), newton_.get()));
        const auto test = [](SUNNonlinearSolver newton, N_Vector, N_Vector correction,
                             sunrealtype allowed, N_Vector weights, void* self) {
            constexpr int converged = 0;
            constexpr double nothing = 1e-10;  // of a correction, relative to the scene
            auto& run = *static_cast<IdaRun*>(self);
            int corrections = 0;  // before this one
            SUNNonlinSolGetCurIter(newton, &corrections);
            if (run.astray_ > 0 && --corrections < 0) return SUN_NLS_CONTINUE;
            const double size = N_VWrmsNorm(correction, weights), tolerance = run.tolerance_;
            const double strain =
                size * tolerance > nothing
                    ? std::sqrt(run.system_.work() / run.energy_) / (0.003 * tolerance) * allowed
                    : 0.0;
            const double left = run.size_.left(size, corrections);
            const double left_strain = run.strain_.left(strain, corrections);
            // a first correction went astray; an old matrix would tell nothing of it
            if (corrections == 1 && run.size_.rate > 0.1 && run.system_.frames().turn() &&
                run.system_.fresh()) {
                run.goes_astray_ = true;
                return SUN_NLS_CONTINUE;
            }
            if (run.size_.rate > 0.9) return SUN_NLS_CONV_RECVR;
            if (std::max(left, left_strain) <= allowed) return converged;
            return corrections == 5 ? SUN_NLS_CONV_RECVR : SUN_NLS_CONTINUE;
        };
        call(SUNNonlinSolSetConvTestFn(newton_.get(), test, this));
    }

    // Prepares the next step. The report still has the counts from before the last one.
    void begin_step() {
        system_.begin_step(now_.time, y_.get());
        if (report_.order > 2) return;
        double length = 0.0;  // of the last one
        IDAGetLastStep(ida_.get(), &length);
        const Counts all = counts();
        ancf::detail::TurningFrames& frames = system_.frames();
        for (; report_.iterations < all[corrections]; ++report_.iterations) frames.add_correction();
        for (; report_.factorisations < all[factorisations]; ++report_.factorisations)
            frames.add_tangent();
        for (; report_.convergence_failures < all[failures]; ++report_.convergence_failures)
            frames.fail();
        frames.end_step(length);
        const VectorX rates = view(dy_.get()).cwiseProduct(system_.units());
        energy_ = frames.turn() ? ancf::detail::typical_energy(problem_, now_.v, system_.v(rates),
                                                               recorder_.strain_energy(now_),
                                                               std::max(length, first_step_))
                                : std::numeric_limits<double>::infinity();
        astray_ = frames.turn() ? std::max(astray_ - 1, 0) : 0;
        if (std::exchange(goes_astray_, false) && frames.turn()) astray_ = 50;
    }

    // From the acceleration: the first step is of order 1, so its error is h^2 a/2.
    [[nodiscard]] double first_step() const {
        if (options_.first_step > 0.0) return options_.first_step;
        const double duration = schedule_.end - start_.time;
        double step = 1e-3 * duration;
        const double turn = problem_.largest_ratio(start_.v);
        if (turn > 0.0) step = std::min(step, 1e-3 / turn);
        const double acceleration = problem_.largest_ratio(start_.acceleration);
        if (acceleration > 0.0) step = std::min(step, std::sqrt(0.5 * tolerance_ / acceleration));
        const double resolved =
            inertia_round_off_ > 0.0 ? std::sqrt(asked * inertia_round_off_ / most_) : 0.0;
        return std::max(step, std::min(resolved, 1e-3 * duration));
    }

    // Takes one step and reports it; false where the run ends.
    [[nodiscard]] bool step() {
        if (options_.max_steps > 0 && report_.steps == options_.max_steps)
            return fail(IDA_TOO_MUCH_WORK);
        const double stop = even_stop(stop_time());
        call(IDASetStopTime(ida_.get(), stop));
        begin_step();
        resolve_multipliers(stop - now_.time);
        double reached = now_.time;
        system_.forget_fault();
        context_.forget_message();
        code_ = IDASolve(ida_.get(), schedule_.end, &reached, y_.get(), dy_.get(), IDA_ONE_STEP);
        system_.rethrow();
        if (code_ < 0) return fail(code_);
        begins_ = false;
        now_.time = reached;
        if (lost_in_round_off()) {
            ++report_.steps;
            report_.time = reached;
            context_.remember("Newton's method fails in most steps, the forces hide in round-off");
            return fail(IDA_CONV_FAIL);
        }
        double length = 0.0;
        IDAGetLastStep(ida_.get(), &length);
        now_ = point(reached, y_.get());
        // its own are round-off in short steps. What a longer one leaves of vibrations that it does
        // not resolve is small, but not the forces of it.
        recorder_.solve_multipliers(problem_.multipliers() > 0 &&
                                    length * highest_frequency_ < 1.0);
        // what the sum of many steps leaves is no step: the multipliers of index 3 would be round-
        // off
        if (schedule_.end - reached <= 1e-9 * length || jumps_.ends(now_))
            now_.time = schedule_.end;
        return record(length, [this, reached, length](double time) {
            // an output may stand between both sides of a jump
            const double within = std::clamp(time, reached - length, reached);
            call(IDAGetDky(ida_.get(), within, 0, dense_.get()));
            return point(time, dense_.get());
        });
    }

    // Whether the last step had next to no error.
    [[nodiscard]] bool rests() {
        call(IDAGetEstLocalErrors(ida_.get(), dense_.get()));
        const VectorX allowed =
            tolerance_ * system_.q(view(y_.get())).cwiseAbs() + system_.q(view(tolerances_.get()));
        const auto errors = system_.q(view(dense_.get())).cwiseQuotient(allowed);
        return errors.squaredNorm() <
               ancf::detail::resting * ancf::detail::resting * static_cast<double>(errors.size());
    }

    // Returns where the next step has to end: at a jump, after a rest where a load or a drive acts
    // that it would pass over, or with the schedule. At a jump it first begins anew behind it.
    [[nodiscard]] double stop_time() {
        double end = next_end(), stop = schedule_.end;
        if (!begins_ && (now_.time < acts_at_ || rests())) {
            const double at = ancf::detail::hidden_action(problem_, now_, end, first_step_);
            if (at < end) stop = end = acts_at_ = at;
        }
        jumps_.look(now_, end);
        while (jumps_.passes(now_, start_, first_step_, report_)) {
            begin_anew();
            jumps_.look(now_, next_end());
            stop = schedule_.end;
        }
        return jumps_.is_ahead(now_) ? std::min(stop, jumps_.next()) : stop;
    }

    // Returns where the next step is to end so that the last four before a stop are equal. Where
    // steps do not resolve vibrations, multipliers are those of IDA. In index 3 order 2 takes them
    // from the positions of five times: of a body that turns they are wrong unless these times are
    // equally far apart.
    [[nodiscard]] double even_stop(double stop) const {
        if (begins_ || highest_frequency_ == 0.0 || problem_.multipliers() == 0 ||
            options_.form != Form::index3)
            return stop;
        double length = 0.0;
        IDAGetCurrentStep(ida_.get(), &length);
        const double rest = stop - now_.time, parts = std::ceil((1.0 - 1e-6) * rest / length);
        return parts > 1.0 && parts <= 4.0 ? now_.time + rest / parts : stop;
    }

    // Returns where the next step would end, s.
    [[nodiscard]] double next_end() const {
        double length = first_step_;
        if (!begins_) IDAGetCurrentStep(ida_.get(), &length);
        return std::min(now_.time + length, schedule_.end);
    }

    // Begins behind a jump.
    void begin_anew() {
        before_ = counts();
        write_start();
        first_step_ = first_step();
        call(IDAReInit(ida_.get(), start_.time, y_.get(), dy_.get()));
        call(IDASetInitStep(ida_.get(), first_step_));
        begins_ = true;
    }

    // IDA halves its step where Newton's method fails and doubles it after the next, for ever. In a
    // long run it may fail as often, but not in so many of the steps.
    [[nodiscard]] bool lost_in_round_off() const {
        if (!hides_forces_) return false;
        const long failed = counts()[failures];
        return failed > 1000 && 3 * failed > report_.steps + 1;  // this one
    }

    // The motion in the scene's units.
    [[nodiscard]] MotionPoint point(double time, N_Vector units) const {
        const VectorX y = view(units).cwiseProduct(system_.units());
        return {time, system_.q(y), system_.v(y), system_.lambda(y)};
    }

    bool fail(int code) {
        // an element that failed in an attempt that IDA got over is not to blame
        if (code == IDA_REP_RES_ERR || code == IDA_FIRST_RES_FAIL || code == IDA_RES_FAIL ||
            code == IDA_CONV_FAIL)
            report_.fault = system_.fault();
        const bool turns = code != IDA_TOO_MUCH_WORK && !system_.driven_turn().empty();
        SteppedRun::fail(code, turns ? Status::step_too_small : status_of(code),
                         options_.max_steps);
        std::string& message = report_.message;
        if (turns) message += "; " + system_.driven_turn();
        if (report_.status == Status::diverged && options_.form == Form::index3 &&
            problem_.multipliers() > 0)
            message +=
                "; in very short steps the multipliers of index 3 are round-off: if that is so "
                "here, a larger first_step or tolerance, or gear_gupta_leimkuhler, may pass";
        return false;
    }

    const IdaOptions& options_;
    IdaReport report_;

    IdaSystem system_;
    VectorOwner y_, dy_, tolerances_, dense_;
    MatrixOwner matrix_;
    LinearSolverOwner klu_, turned_;
    NewtonOwner newton_;  // of stiff scenes
    IdaOwner ida_;

    Corrections size_, strain_;        // of a step, in IDA's norm
    double energy_ = 0.0;              // J, typical of a step
    bool goes_astray_ = false;         // whether a first correction of the step went astray
    int astray_ = 0;                   // steps left that take back the strains of the prediction
    double tolerance_ = 0.0;           // that counts
    double slow_frequency_ = 0.0;      // rad/s: of the motion that is followed
    double highest_frequency_ = 0.0;   // rad/s: of a scene whose vibrations steps may not resolve
    double first_step_ = 0.0;          // s
    double least_ = 0.0, most_ = 0.0;  // N: tolerance of forces in multipliers
    double loosened_ = 1.0;            // by how much that is more than the least in the next step
    double inertia_round_off_ = 0.0;   // N s^2; 0: it does not count
    bool hides_forces_ = false;        // whether the start's forces are below their round-off
    double acts_at_ = -std::numeric_limits<double>::infinity();  // s, of the last hidden action
    Counts before_ = {};                                         // up to the last jump
    bool begins_ = true;  // whether the run or what follows a jump has no step yet
};

}  // namespace detail

ANCF_INLINE void IdaOptions::check() const {
    detail::check_options("IdaOptions", tolerance, max_steps,
                          {{"length_scale", length_scale},
                           {"velocity_scale", velocity_scale},
                           {"force_scale", force_scale},
                           {"first_step", first_step},
                           {"max_step", max_step}});
}

ANCF_INLINE IdaReport Ida::integrate(DynamicProblem& problem, const Schedule& schedule) const {
    ancf::detail::require(problem.assembly().pattern().storage() == Storage::full,
                          "Ida: the problem must have full storage: set ProblemOptions::storage");
    ancf::detail::require_motion(problem, schedule);
    return detail::IdaRun(problem, schedule, options()).run();
}

}  // namespace ancf::sundials
