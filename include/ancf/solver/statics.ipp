// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/list.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/solver/convergence.hpp>
#include <ancf/solver/mechanism.hpp>
#include <ancf/solver/redundancy.hpp>
#include <ancf/solver/statics.hpp>
#include <ancf/solver/turning.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace ancf {

namespace detail {

/// Newton's method at one load factor; keeps the assembly and the factorisation between steps.
class StaticsNewton {
protected:
    /// How an attempt is made.
    enum class Way {
        usual,    ///< by the iteration that the options ask for
        damped,   ///< with damped corrections, where the path seems to end
        falling,  ///< with damped corrections that leave an unstable state
        plain     ///< plainly, as the last resort
    };

    StaticsNewton(Scene& model, LinearSolver& solver, const StaticsOptions& options)
        : model_(model),
          solver_(solver),
          options_(options),
          assembly_(model, solver.storage()),
          monitor_(model, assembly_.numbering()),
          turning_(model, assembly_.numbering()),
          exchange_(model.exchange()),
          constraints_(exchange_ != nullptr ? exchange_->constraints() : model.constraints()),
          without_sections_(
              some([](const ElementGroup&) { return true; }) &&
              !some([](const ElementGroup& of) { return of.fields().contains(Field::r_y); })) {
        solver_.analyze(assembly_.tangent());
    }

    /// Iterates from the model's state; leaves it where the iteration ends.
    [[nodiscard]] Status iterate(LoadStep& step) {
        State& state = model_.state();
        state.time = instant_.time;
        VectorX driven = state.q;
        together(exchange_, [&] { assembly_.apply_supports(instant_, driven); });
        const VectorX increment = driven - state.q;
        const bool moved = any(largest_magnitude(increment) != 0.0);

        last_.before = state.q;
        if (report_.steps.size() == 1) turns_first_ = holds_in_plane();
        if (!evaluate(state, moved ? &increment : nullptr)) return report_.fault->status;
        note_far_joint();
        state.q = driven;
        double correction = std::numeric_limits<double>::infinity();
        while (true) {
            const double residual = monitor_.residual(assembly_);
            step.residuals.push_back(residual);
            if (!std::isfinite(residual)) return Status::not_finite;
            const bool at_rest = correction <= options_.correction_tolerance &&
                                 residual <= options_.residual_tolerance;
            if (at_rest && !begins_to_fall(step)) return accept(state);
            // a scene without loads that is at rest needs no correction to know it
            const bool idle = step.iterations == 0 && !moved &&
                              !any(largest_magnitude(assembly_.external_force()) != 0.0);
            if (idle || ((settled(step) || stagnates(step)) && !begins_to_fall(step))) {
                step.at_round_off = monitor_.at_round_off(assembly_, state.q);
                if (step.at_round_off) return accept(state);
            }
            if (step.iterations >= most_iterations(step) || hopeless(step))
                return Status::max_iterations;

            // not every factorisation sees it through the round-off
            if (step.iterations == 0 && repeats()) return Status::singular;
            assembly_.residual(residual_);
            if (step.newton == NewtonKind::automatic &&
                (step.corrections.empty() ? turns_first_ : correction > small_turn))
                add_curvature(!step.corrections.empty() || follows_);
            const Status solved = step.damped ? correct_damped(step) : correct(step);
            if (solved != Status::converged) return solved;
            constexpr double far = 2.0;
            if (step.iterations == 1 && monitor_.correction(correction_) > far && begins_unheld())
                return Status::singular;
            if (any(!all_finite(correction_)))
                return failure_.empty() ? Status::not_finite : Status::diverged;
            if (!move(state, residual, step.newton)) return report_.fault->status;
            correction = monitor_.correction(correction_);
            step.corrections.push_back(correction);
        }
    }

    /// Says why a step failed, from its last evaluation.
    [[nodiscard]] std::string cause(const LoadStep& step) {
        if (step.status == Status::not_finite && !report_.fault && exchange_ == nullptr)
            report_.fault = assembly_.inspect_values(model_.state().q);
        if (report_.fault) return assembly_.describe(*report_.fault);
        std::string text = joined({"the step to load factor ", step.factor, " failed after ",
                                   step.iterations, " iterations"});
        if (step.status == Status::singular) text += ": its tangent is singular";
        if (!failure_.empty()) text += ": " + failure_;
        if (step.status == Status::singular || !failure_.empty()) return text;
        if (!step.residuals.empty())
            text += joined({", the last relative residual was ", step.residuals.back()});
        if (!step.corrections.empty())
            text += joined({", the last relative correction ", step.corrections.back()});
        return text;
    }

    /// Whether nothing but its small bending stiffness holds a line at first, so that a correction
    /// is a hundred times the scene's size: parts of the load do no better, and plain iteration
    /// takes a third off each correction.
    [[nodiscard]] bool loose(const LoadStep& step) const {
        return without_sections_ && step.newton == NewtonKind::automatic &&
               !step.corrections.empty() && step.corrections.front() > 100.0;
    }

    /// Whether five corrections in a row have not halved the smallest before them.
    [[nodiscard]] static bool wanders(const LoadStep& step) {
        int since = 0;
        double smallest = std::numeric_limits<double>::infinity();
        for (const double correction : step.corrections) {
            ++since;
            if (!(correction < 0.5 * smallest)) continue;
            smallest = correction;
            since = 0;
        }
        return since >= 5;
    }

    /// Whether nothing holds the scene where the run begins but what turning adds to the first
    /// tangent of an automatic step. A beam so slender that its bending is round-off beside its
    /// stretch counts as held unless the load is far beyond it too. Keeps the correction.
    [[nodiscard]] bool begins_unheld() {
        constexpr double rcond_of_round_off = 1e-14, far_beyond = 1e3;
        if (report_.steps.size() > 1 || report_.steps.front().newton != NewtonKind::automatic ||
            exchange_ != nullptr || solver_.iterative())
            return false;
        const auto fault = report_.fault;  // of the attempt that failed
        const bool evaluated = evaluate(model_.state(), nullptr);
        report_.fault = fault;
        if (!evaluated) return false;
        const FactorReport plain = solver_.factorize(assembly_.tangent());
        if (plain.status == Status::singular) return true;
        VectorX moved;
        assembly_.residual(residual_);
        solve_with(solver_, residual_, moved);
        return (!(plain.rcond > rcond_of_round_off) ||
                !(monitor_.correction(moved) <= far_beyond)) &&
               moves_freely(assembly_, solver_);
    }

    bool evaluate(const State& state, const VectorX* increment, const Correction* last = nullptr) {
        const VectorX rest = VectorX::Zero(state.q.size());
        report_.fault = assembly_.evaluate({state.q, rest, state.multipliers, instant_},
                                           Request::tangent, increment, last);
        return !report_.fault.has_value();
    }

    /// Returns the sum over positions, and that over slopes, of the loads' forces times a change.
    /// @param change  null: of the forces' magnitudes
    [[nodiscard]] std::array<double, 2> sums_of_loads(const VectorX* change) const {
        const Layout& layout = model_.layout();
        std::array<double, 2> sums = {};
        for (int node = 0; node < layout.nodes(); ++node) {
            const int slopes = layout.fields(node).contains(Field::r) ? model_.dimension() : 0;
            for (int k = layout.first(node); k < layout.first(node + 1); ++k) {
                const double force = assembly_.external_force()[k];
                const bool of_slope = k >= layout.first(node) + slopes;
                sums[of_slope ? 1 : 0] +=
                    change != nullptr ? force * (*change)[k] : std::abs(force);
            }
        }
        return sums;
    }

    /// Whether something holds for some type of the scene's elements.
    [[nodiscard]] bool some(bool (*holds)(const ElementGroup&)) const {
        const auto& groups = model_.groups();
        return any(std::any_of(groups.begin(), groups.end(), [&](const auto& group) {
            return group->size() > 0 && holds(*group);
        }));
    }

    /// Whether something holds here, or in any part of the scene.
    [[nodiscard]] bool any(bool own) const {
        return exchange_ == nullptr ? own : exchange_->largest(own ? 1.0 : 0.0) > 0.0;
    }

    Scene& model_;
    LinearSolver& solver_;
    const StaticsOptions& options_;
    Assembly assembly_;
    ConvergenceMonitor monitor_;
    Turning turning_;
    const detail::Exchange* exchange_;        // of a part of a scene
    const List<AnyConstraint>& constraints_;  // of the whole one
    bool without_sections_;                   // elements, and none has r_y
    StaticsReport report_;
    // of the attempt that runs:
    Instant instant_;
    bool follows_ = false;  // it goes on from a step that converged: see add_curvature()
    Way way_ = Way::usual;
    bool turns_first_ = true;  // its first tangent has what turning makes of it
    VectorX residual_, correction_;
    Correction last_;
    std::string failure_;    // of the solver, in words
    std::string far_joint_;  // what note_far_joint() says

private:
    static constexpr double small_turn = 0.05;  // rad: below, the linear sum is better

    /// Solves for the correction.
    Status correct(LoadStep& step) {
        report_.factorisation = solver_.factorize(assembly_.tangent());
        failure_ = solver_.failure();
        if (report_.factorisation.status != Status::converged) return report_.factorisation.status;
        solve_with(solver_, residual_, correction_);
        failure_ = solver_.failure();
        for (double& entry : correction_) entry = -entry;
        ++step.iterations;
        if (report_.factorisation.negative_pivots > assembly_.numbering().multipliers())
            ++step.indefinite;
        return Status::converged;
    }

    /// The correction of a motion D dx/dt = -R(x) over a time: one step of Euler's backward method.
    /// D has the magnitudes of the tangent's diagonal, the largest one where that has a zero, and
    /// at least what the largest load makes of a turn: masses on links have no other. The time
    /// is such that the correction is neither large nor against the force; in a fall, that K + D/t
    /// is positive definite: the motion leaves an unstable state to the side where it is pushed.
    Status correct_damped(LoadStep& step) {
        constexpr double wanted = 0.5, growth = 4.0, first_time = 1e6, shortest = 1e-3;
        constexpr double nothing = 1e-12;  // a correction of the multipliers alone
        const bool falls = way_ == Way::falling;
        const int free = assembly_.numbering().free_coordinates();
        double* const values = assembly_.tangent_values();
        const List<int> at = diagonal_places(assembly_.tangent());
        VectorX diagonal = VectorX::Zero(free);
        for (int k = 0; k < free; ++k) diagonal[k] = values[at[k]];
        // what has no stiffness of its own is as viscous as the stiffest of its unit
        VectorX viscosity = diagonal;
        for (double& one : viscosity) one = std::abs(one);
        const VectorX stiffest = stiffest_of_unit(assembly_, diagonal);
        const VectorX lever =
            length_powers(monitor_.size(), model_.layout(), assembly_.numbering());
        double load = 0.0;  // work of the largest one on a turn by 1 rad, J
        VectorX force;
        assembly_.numbering().gather_free(assembly_.external_force(), force);
        for (int k = 0; k < free; ++k) load = std::max(load, std::abs(force[k]) * lever[k]);
        for (int k = 0; k < free; ++k) {
            if (viscosity[k] <= 1e-15 * stiffest[k]) viscosity[k] = stiffest[k];
            viscosity[k] = std::max(viscosity[k], load / (lever[k] * lever[k]));
        }
        if (step.corrections.empty()) {
            time_ = falls ? 1.0 : first_time;
            growth_ = growth;
        } else {
            time_ *= std::min(growth_, wanted / step.corrections.back());
        }
        growth_ = std::min(2.0 * growth_, growth);
        while (time_ > shortest && step.iterations < most_iterations(step)) {
            for (int k = 0; k < free; ++k) values[at[k]] = diagonal[k] + viscosity[k] / time_;
            const bool solved = correct(step) == Status::converged;
            if (!solved || (falls && negative_directions(assembly_, assembly_.tangent(),
                                                         report_.factorisation, solver_)
                                             .count > 0)) {
                time_ /= falls ? 2.0 : growth;
                if (falls) growth_ = 1.0;
                continue;
            }
            double work = 0.0;  // of forces on the correction, without what closes constraints
            for (int k = 0; k < assembly_.numbering().unknowns(); ++k)
                work += (k < free ? -1.0 : 1.0) * residual_[k] * correction_[k];
            const double size = monitor_.correction(correction_);
            if (size <= nothing || (work > 0.0 && size <= 2.0 * wanted)) return Status::converged;
            time_ *= std::min(1.0 / growth, std::max(wanted / size, 1e-2));
        }
        return Status::max_iterations;
    }

    /// Adds to the tangent what turning makes of it.
    void add_curvature(bool chords) {
        VectorX& residual = correction_;  // is free until the next solution
        assembly_.predicted_residual(residual);
        turning_.add_curvature(last_.before, residual, assembly_.tangent(),
                               assembly_.tangent_values(), chords);
    }

    /// Applies the correction, shortened on request, and evaluates there.
    bool move(State& state, double before, NewtonKind newton) {
        const State start = state;
        const auto& numbering = assembly_.numbering();
        const bool mixed = newton != NewtonKind::plain;
        double length = 1.0;
        for (int halving = 0;; ++halving) {
            state = start;
            numbering.add_free(correction_, length, state.q);
            for (int k = 0; k < numbering.multipliers(); ++k)
                state.multipliers[k] += length * correction_[numbering.free_coordinates() + k];
            if (mixed) bend(newton, state.q);
            const bool evaluated = evaluate(state, nullptr, mixed ? &last_ : nullptr);
            if (!options_.line_search || halving == 8 ||
                (evaluated && monitor_.residual(assembly_) < 2.0 * before)) {
                last_.before = state.q;
                return evaluated;
            }
            length *= 0.5;
        }
    }

    /// Lets what the correction turns keep its length.
    void bend(NewtonKind newton, VectorX& q) {
        last_.change = q - last_.before;
        if (newton == NewtonKind::mixed ||
            !(turning_.largest_angle(last_.before, last_.change) > small_turn)) {
            turning_.twist(last_.before, last_.change, q);
            return;
        }
        const auto [of_positions, of_slopes] = sums_of_loads(&last_.change);
        const bool moments_lead = std::abs(of_slopes) > std::abs(of_positions);
        turning_.turn(last_.before, last_.change, q,
                      moments_lead ? TurnBy::angle : TurnBy::tangent);
    }

    /// A root of the equations counts only where every element is in order.
    Status accept(const State& state) {
        report_.fault = assembly_.inspect_parts(state.q);
        return report_.fault ? report_.fault->status : Status::converged;
    }

    [[nodiscard]] int most_iterations(const LoadStep& step) const {
        const int most = options_.max_iterations;
        if (step.newton == NewtonKind::plain || way_ == Way::falling) return most;
        const int shared = std::min(options_.mixed_iterations, most);
        return step.damped ? shared + std::min(shared, most - shared) : shared;
    }

    /// Whether the last correction is far below its tolerance and beside what the step has moved.
    [[nodiscard]] bool settled(const LoadStep& step) const {
        if (step.corrections.empty()) return false;
        const double last = step.corrections.back();
        return last <= 1e-2 * options_.correction_tolerance &&
               last <= 1e-3 * *std::max_element(step.corrections.begin(), step.corrections.end());
    }

    static bool stagnates(const LoadStep& step) {
        const std::size_t count = step.residuals.size();
        return count >= 3 && step.corrections.back() < 1e-3 &&
               step.residuals[count - 1] > 0.25 * step.residuals[count - 2];
    }

    /// Whether corrections are too large for an iteration that would converge, or wander.
    [[nodiscard]] bool hopeless(const LoadStep& step) const {
        const std::size_t count = step.corrections.size();
        if (step.newton != NewtonKind::automatic || step.damped) return false;
        return loose(step) || (count >= 2 && (step.corrections.back() > (count == 2 ? 2.0 : 1.2) ||
                                              wanders(step)));
    }

    /// Whether a fall is still at its beginning, where corrections are small too.
    [[nodiscard]] bool begins_to_fall(const LoadStep& step) {
        constexpr double begun = 0.01, still = 1e-6;
        if (way_ != Way::falling || step.corrections.empty() ||
            step.corrections.back() <= still * options_.correction_tolerance ||
            *std::max_element(step.corrections.begin(), step.corrections.end()) > begun)
            return false;
        const FactorReport factor = solver_.factorize(assembly_.tangent());
        return negative_directions(assembly_, assembly_.tangent(), factor, solver_).count > 0;
    }

    /// Whether a scene in the plane is held where the run begins: in the first tangent what turning
    /// makes of it would hide from the factorisation that only loads hold the scene.
    [[nodiscard]] bool holds_in_plane() {
        return model_.dimension() == 3 || report_.steps.front().newton != NewtonKind::automatic ||
               supports_hold(assembly_) || !begins_unheld();
    }

    /// Whether constraints repeat each other or a support, by the first tangent of the run. Of a
    /// scene in parts, those of one part are compared.
    [[nodiscard]] bool repeats() {
        if (!repeats_)
            repeats_ = !solver_.iterative() &&
                       any(!repeated_constraints(model_, assembly_.numbering(), assembly_.tangent())
                                .empty());
        return *repeats_;
    }

    /// Notes a driven joint that stands more than pi/3 off where the step begins: its angle did not
    /// change to what it is, so that no step was cut, and Newton's method may throw sections over.
    void note_far_joint() {
        if (exchange_ != nullptr || constraints_.empty()) return;
        // angles are what does not grow with a length
        const VectorX one = assembly_.violation_scale(monitor_.size());
        const VectorX two = assembly_.violation_scale(2.0 * monitor_.size());
        Eigen::Index row = 0;
        for (std::size_t k = 0; k < constraints_.size(); ++k) {
            double square = 0.0;  // of the sine, which passes pi/3 once (constraints/frames.hpp)
            for (const Eigen::Index end = row + constraints_[k].equations(); row < end; ++row)
                if (one[row] == two[row]) square += std::pow(assembly_.violation()[row], 2);
            const double angle = constraints_[k].driven_angle(instant_.time);
            if (square > 0.75 && angle != 0.0)
                far_joint_ = joined({"; constraint ", k, " (", constraints_[k].name(),
                                     ") began more than ", largest_driven_turn,
                                     " rad off the angle that it is driven to, ", angle, " rad"});
        }
    }

    double time_ = 0.0;            // of a damped correction
    double growth_ = 0.0;          // of this time, at most
    std::optional<bool> repeats_;  // see repeats()
};

/// The load steps of a run, and what is tried where one fails.
class StaticsRun : StaticsNewton {
public:
    StaticsRun(Scene& model, LinearSolver& solver, const StaticsOptions& options)
        : StaticsNewton(model, solver, options),
          newton_(possible(options.newton)),
          most_falls_(model.has_symmetric_loads() ? 8 : 1) {}

    [[nodiscard]] StaticsReport run() {
        whole_ = options_.last_factor - options_.first_factor;
        equal_ = part_size_ = whole_ / options_.steps;
        report_.factor = options_.first_factor;
        bool going = true;
        while (going &&
               std::abs(options_.last_factor - report_.factor) > 1e-12 * std::abs(whole_)) {
            const double from = report_.factor;
            const double wanted = next_wanted();
            const double next = within_turn(from, next_part(wanted));
            const DrivenTurn turn = driven_turn(constraints_, from, next);
            if (!turn.fits()) {
                report_.status = Status::diverged;
                report_.message = driven_turn_text(constraints_, turn, from, next);
                break;
            }
            const LoadStep& result = advance(next);
            report_.status = result.status;
            going = result.status == Status::converged ? go_on(result, next == wanted)
                                                       : try_again(result, next - from, turn.angle);
        }
        finish();
        return std::move(report_);
    }

private:
    static constexpr double smallest_turn = 0.05;  // rad: a shorter part is not tried

    /// Returns the end of the step that the options ask for.
    [[nodiscard]] double next_wanted() const {
        const double first = options_.first_factor;
        const double wanted = options_.adaptive
                                  ? report_.factor + (in_parts() ? part_size_ : equal_)
                                  : first + whole_ * (steps_done_ + 1) / options_.steps;
        return std::abs(wanted - first) > std::abs(whole_) * (1.0 - 1e-12) ? options_.last_factor
                                                                           : wanted;
    }

    /// Returns the load factor wanted, or the end of a part of that step after one that failed.
    [[nodiscard]] double next_part(double wanted) const {
        const bool part = newton_ == NewtonKind::automatic && in_parts() &&
                          std::abs(wanted - report_.factor) > std::abs(part_size_) * (1.0 + 1e-9);
        return part ? report_.factor + part_size_ : wanted;
    }

    /// Whether the next attempt is one part, not all that is left of a step.
    [[nodiscard]] bool in_parts() const {
        return way_ == Way::usual || (way_ != Way::plain && falls_by_parts_);
    }

    /// Returns the load factor wanted, or an earlier one up to which driven joints turn by what a
    /// step, or the part of one that converges, may take.
    [[nodiscard]] double within_turn(double done, double wanted) const {
        const double most = turn_share_ * largest_driven_turn * (1.0 + 1e-10);
        double next = wanted;
        for (int halving = 0; halving < 30; ++halving) {
            const double turn = driven_turn(constraints_, done, next).angle;
            if (!(turn > most)) break;
            // equal parts of an even drive at first
            const double parts = halving == 0 ? std::ceil(turn / most) : 2.0;
            next = done + (next - done) / parts;
        }
        return next;
    }

    /// Solves at a load factor from the model's state, in the way that has its turn; keeps the
    /// state where that fails.
    [[nodiscard]] const LoadStep& advance(double factor) {
        const LoadStep& step = attempt(factor, way_ == Way::plain ? NewtonKind::plain : newton_);
        if (step.status == Status::converged || newton_ == NewtonKind::plain ||
            newton_ == NewtonKind::automatic)
            return step;
        return attempt(factor, NewtonKind::plain);
    }

    /// Tries a load factor; keeps the state where that fails.
    [[nodiscard]] const LoadStep& attempt(double factor, NewtonKind newton) {
        // whatever ends the iteration, an exception of a user's function too
        struct Keep {
            State& state;
            State before;
            bool reached = false;
            ~Keep() {
                if (!reached) state = std::move(before);
            }
        } keep{model_.state(), model_.state()};
        report_.fault.reset();
        report_.message.clear();
        failure_.clear();
        far_joint_.clear();
        reached_.reset();
        passed_ = 0;
        LoadStep& step = report_.steps.emplace_back();
        step.factor = factor;
        step.newton = newton;
        step.damped = way_ == Way::damped || way_ == Way::falling;
        follows_ = follows();
        instant_ = {factor, factor};
        step.status = iterate(step);
        if (step.status == Status::converged && !followed(step)) step.status = Status::diverged;
        keep.reached = step.status == Status::converged;
        if (!keep.reached) report_.message = cause(step) + far_joint_;
        return step;
    }

    /// Moves on after a step, or a part of one, that converged; returns whether the run goes on.
    /// @param whole  whether the step that the options ask for is done
    [[nodiscard]] bool go_on(const LoadStep& step, bool whole) {
        report_.factor = step.factor;
        turns_first_ = true;
        way_ = Way::usual;
        if (grows(step))
            part_size_ =
                std::copysign(std::min(2.0 * std::abs(part_size_), std::abs(equal_)), whole_);
        if (!whole) return true;
        turn_share_ = 1.0;
        jumped_ = false;
        failed_falls_ = 0;
        falls_by_parts_ = false;
        spent_ = report_.iterations();
        ++steps_done_;
        if (!options_.progress || options_.progress(report_.factor, model_.state())) return true;
        report_.status = Status::stopped;
        report_.message = "the progress callback asked to stop";
        return false;
    }

    /// Chooses what follows a step that failed; returns whether the run goes on.
    /// @param size  of the step, in load factors
    /// @param turn  of the driven joints in it, rad
    [[nodiscard]] bool try_again(const LoadStep& failed, double size, double turn) {
        if (way_ == Way::damped && failed_falls_ < most_falls_) {
            way_ = Way::falling;
            return true;
        }
        if (way_ == Way::falling) {
            failed_falls_ = may_take(0.5 * size) ? failed_falls_ + 1 : most_falls_;
            if (failed_falls_ < most_falls_) {
                falls_by_parts_ = true;
                part_size_ = 0.5 * size;
            }
        }
        if (way_ != Way::usual) {
            const bool going = way_ != Way::plain;
            way_ = Way::usual;  // and the part that the attempt before has left
            return going;
        }
        if (turn > smallest_turn) {
            turn_share_ = 0.5 * turn / largest_driven_turn;
            return true;
        }
        if (loose(failed)) {
            newton_ = NewtonKind::plain;  // from here on, as a run without cuts of its own
            return true;
        }
        part_size_ = share_after(failed) * size;
        if (passed_ > 1 && may_take(part_size_))
            return falls_by_parts_ = true;  // from beyond a single one it falls to the right side
        unheld_ = passed_ == 0 && is_stuck(failed);
        if (passed_ > 0) {
            part_size_ = size;
            way_ = Way::falling;
            return true;
        }
        if (!jumped_ && newton_ == NewtonKind::automatic &&
            (unheld_ || (report_.factor != options_.first_factor && wanders(failed)))) {
            jumped_ = true;
            way_ = Way::damped;
            return true;
        }
        if (cuts(failed) && may_take(part_size_)) return true;
        if (!may_retry(failed)) return false;
        way_ = Way::plain;  // what a run without cuts would have tried
        part_size_ = equal_;
        return true;
    }

    /// Whether a part is not shorter than the options allow.
    [[nodiscard]] bool may_take(double part) const {
        return std::abs(part) >= options_.min_step * std::abs(whole_);
    }

    /// Whether nothing holds the scene where a step that failed begins.
    [[nodiscard]] bool is_stuck(const LoadStep& failed) {
        return failed.corrections.empty() ? failed.status == Status::singular : begins_unheld();
    }

    /// Whether the next step may be longer. After a failed one, two have to succeed.
    [[nodiscard]] bool grows(const LoadStep& step) {
        if (newton_ != NewtonKind::automatic) return step.iterations <= 6;
        return step.iterations <= 8 && ++successes_ > 1;
    }

    /// Whether a step that failed is worth a shorter one, as long as that is not endless.
    [[nodiscard]] bool cuts(const LoadStep& failed) const {
        return options_.adaptive || (may_retry(failed) && (report_.iterations() - spent_) / 10 <
                                                              options_.max_iterations);
    }

    /// Whether an automatic step that failed may do better in another way: not where it could not
    /// move at all, or the user's own bound ended it.
    [[nodiscard]] bool may_retry(const LoadStep& failed) const {
        return newton_ == NewtonKind::automatic && failed.iterations > 0 &&
               failed.iterations < options_.max_iterations;
    }

    /// Returns how much of a step that failed to try next: less at first where its first correction
    /// says that a half will not do.
    [[nodiscard]] double share_after(const LoadStep& failed) {
        const bool far = newton_ == NewtonKind::automatic && successes_ == none_failed &&
                         !failed.corrections.empty() && failed.corrections.front() > 2.0;
        successes_ = 0;
        return far ? 0.25 : 0.5;
    }

    /// Returns the iteration asked for, or what the scene has of it. Without mixed elements `mixed`
    /// becomes plain, and `automatic` too unless there are sections to turn, or masses alone that
    /// loads may have to hold. In a part of a scene `automatic` becomes mixed.
    [[nodiscard]] NewtonKind possible(NewtonKind wanted) const {
        if (wanted == NewtonKind::plain) return wanted;
        if (some([](const ElementGroup& of) { return of.evaluates_mixed(); }))
            // slopes are turned by a system of the whole scene
            return exchange_ != nullptr ? NewtonKind::mixed : wanted;
        const bool turns =
            wanted == NewtonKind::automatic && exchange_ == nullptr && !without_sections_;
        return turns ? wanted : NewtonKind::plain;
    }

    /// Whether a step goes on from one that converged, none of late having failed: its first
    /// tangent may have what the new load makes of chords. From elsewhere a load beyond a buckling
    /// load would turn the first correction round.
    [[nodiscard]] bool follows() const {
        return report_.factor != options_.first_factor && successes_ >= none_failed;
    }

    /// Whether a step ended where the load leads from the state before: in a stable state, or by
    /// corrections so small that no other branch was near. A beam that moments alone roll up turns
    /// unstable on its way. Where nothing but loads can hold the scene, the end must be held.
    [[nodiscard]] bool followed(const LoadStep& step) {
        constexpr double small_correction = 0.1;
        if (step.damped && unheld_) {
            report_.factorisation = solver_.factorize(assembly_.tangent());
            if (report_.factorisation.status != Status::converged ||
                stability(assembly_, report_.factorisation) != Stability::stable)
                return false;
            doubted_ = false;
            return stable_ = report_.held_by_loads = true;
        }
        if (step.newton != NewtonKind::automatic || step.corrections.empty() || !stable_ ||
            moments_alone())
            return true;
        const bool small = !(*std::max_element(step.corrections.begin(), step.corrections.end()) >
                             small_correction);
        if (small && !doubted_ && !step.damped && !may_be_unstable()) return true;
        if (step.damped) report_.factorisation = solver_.factorize(assembly_.tangent());
        if (report_.factorisation.status != Status::converged) return false;
        const Stability reached = stability(assembly_, report_.factorisation, counted_before(step));
        // by stresses that are off by the square of the last correction
        constexpr double correction_of_round_off = 1e-8;
        if (step.corrections.back() <= correction_of_round_off) reached_ = reached;
        // of loads with a potential `unknown` is a matter of round-off
        const bool lost = reached == Stability::unstable ||
                          (reached == Stability::unknown && !model_.has_symmetric_loads() &&
                           !softest_decay(assembly_, solver_));
        // an imperfect column may end straight beyond its buckling load: let it fall
        if (small && lost && !step.damped && failed_falls_ < most_falls_) {
            const NegativeDirections negative =
                negative_directions(assembly_, assembly_.tangent(), report_.factorisation, solver_);
            passed_ = std::max(negative.count, 1);
            return false;
        }
        // a perfect one does not fall, or within a plane alone: the path itself gets there
        const bool leads = small || way_ == Way::falling;
        if (leads) stable_ = !lost;
        doubted_ = lost && !leads;
        return !doubted_;
    }

    /// Returns the solver where its factors are of a tangent that may have other signs than that of
    /// the state: a correction changes a tangent by about its own share, and the least eigenvalue
    /// is rcond of the largest.
    [[nodiscard]] const LinearSolver* counted_before(const LoadStep& step) const {
        constexpr double same = 1e-3;  // of rcond
        const bool negligible = !step.corrections.empty() &&
                                step.corrections.back() <= same * report_.factorisation.rcond;
        return negligible ? nullptr : &solver_;
    }

    /// Whether loads act on slopes, and none on a position.
    [[nodiscard]] bool moments_alone() const {
        const auto [of_positions, of_slopes] = sums_of_loads(nullptr);
        return of_positions == 0.0 && of_slopes > 0.0;
    }

    /// Whether the last factorisation leaves it open that a state is unstable.
    [[nodiscard]] bool may_be_unstable() const {
        const int negative = report_.factorisation.negative_pivots;
        return negative < 0 ? !solver_.iterative() : negative > assembly_.numbering().multipliers();
    }

    void finish() {
        const State& state = model_.state();
        const auto& numbering = assembly_.numbering();
        instant_ = {report_.factor, report_.factor};
        report_.reactions.setZero(numbering.coordinates());
        const auto fault = report_.fault;
        const bool evaluated = evaluate(state, nullptr);
        report_.fault = fault;
        if (!evaluated) return;
        report_.softened = assembly_.softened(state.q);
        report_.largest_turn = assembly_.largest_turn(state.q);
        report_.strain_energy = assembly_.strain_energy();
        // the last tangent of a run that failed is not of the state that it keeps
        const bool counted = report_.status == Status::converged && !report_.steps.empty() &&
                             report_.steps.back().iterations > 0;
        const bool alone = exchange_ == nullptr && !solver_.iterative();
        if (alone && counted && reached_)
            report_.stability = *reached_;
        else if (alone && counted)
            report_.stability =
                stability(assembly_, report_.factorisation, counted_before(report_.steps.back()));
        else if (alone)
            report_.stability = stability(assembly_);
        for (const int k : numbering.held()) report_.reactions[k] = assembly_.unbalanced(k);
        if (report_.status == Status::singular && alone) {
            std::string found = singular_cause(model_, numbering, assembly_.tangent(), solver_);
            if (!found.empty()) report_.message = std::move(found);
        }
        VectorX outer = assembly_.external_force();
        for (Eigen::Index k = 0; k < outer.size(); ++k) {
            outer[k] = outer[k] - assembly_.constraint_force()[k] + report_.reactions[k];
            if (exchange_ != nullptr && !exchange_->owns(static_cast<int>(k))) outer[k] = 0.0;
        }
        report_.imbalance = resultant(model_, state.q, outer);
        if (exchange_ == nullptr) return;
        exchange_->sum(report_.imbalance.force.data(), 3);
        exchange_->sum(report_.imbalance.moment.data(), 3);
    }

    NewtonKind newton_;
    double whole_ = 0.0;       // of the load factors
    double equal_ = 0.0;       // a step of equal ones
    double part_size_ = 0.0;   // of a step, or of the part of one that is tried next
    double turn_share_ = 1.0;  // of the turn that one step may take, where a longer one failed
    int steps_done_ = 0;       // of those that the options ask for
    int spent_ = 0;            // iterations before the step that the options ask for
    static constexpr int none_failed = 2;
    int successes_ = none_failed;       // steps that converged since one failed
    bool jumped_ = false;               // this step had a damped attempt that was no fall
    bool unheld_ = false;               // nothing holds the scene where the failed step begins
    int passed_ = 0;                    // bifurcations that the last step ended beyond
    int failed_falls_ = 0;              // in this step
    int most_falls_;                    // bound: loads without a potential may go round for ever
    bool falls_by_parts_ = false;       // a fall takes a part of this step, not all that is left
    bool stable_ = true;                // as far as is known, the last state that was accepted
    bool doubted_ = false;              // the last step ended elsewhere
    std::optional<Stability> reached_;  // at the end of the last attempt, where it was judged
};

}  // namespace detail

ANCF_INLINE void StaticsOptions::check() const {
    detail::require(steps >= 1, "StaticsOptions: steps must be at least 1, got ", steps);
    detail::require(max_iterations >= 1, "StaticsOptions: max_iterations must be at least 1, got ",
                    max_iterations);
    detail::require(mixed_iterations >= 1,
                    "StaticsOptions: mixed_iterations must be at least 1, got ", mixed_iterations);
    detail::require_positive("StaticsOptions: residual_tolerance", residual_tolerance);
    detail::require_positive("StaticsOptions: correction_tolerance", correction_tolerance);
    detail::require_positive("StaticsOptions: min_step", min_step);
    detail::require_finite("StaticsOptions: first_factor", first_factor);
    detail::require_finite("StaticsOptions: last_factor", last_factor);
    detail::require(first_factor != last_factor,
                    "StaticsOptions: first_factor and last_factor must differ, both are ",
                    last_factor, "; for the equilibrium there set first_factor one lower");
}

ANCF_INLINE StaticsReport solve_statics(Scene& model, LinearSolver& solver,
                                        const StaticsOptions& options) {
    options.check();
    return detail::StaticsRun(model, solver, options).run();
}

}  // namespace ancf
