// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/solver/convergence.hpp>
#include <ancf/solver/mechanism.hpp>
#include <ancf/solver/path.hpp>
#include <ancf/solver/redundancy.hpp>
#include <ancf/solver/stability.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ancf {

ANCF_INLINE void PathOptions::check() const {
    detail::require(control != PathControl::displacement || at.node != NodeId{},
                    "PathOptions: displacement control needs `at`: a node and the vector of it "
                    "that is controlled");
    detail::require_finite("PathOptions: first_factor", first_factor);
    detail::require(std::isfinite(first_step) && first_step != 0.0,
                    "PathOptions: first_step must be finite and not zero, got ", first_step);
    detail::require_positive("PathOptions: largest_step", largest_step);
    detail::require_positive("PathOptions: smallest_step", smallest_step);
    detail::require(wanted_iterations >= 1 && max_iterations >= wanted_iterations,
                    "PathOptions: 1 <= wanted_iterations <= max_iterations is needed, got ",
                    wanted_iterations, " and ", max_iterations);
    detail::require(max_points >= 1, "PathOptions: max_points must be at least 1, got ",
                    max_points);
    detail::require_positive("PathOptions: residual_tolerance", residual_tolerance);
    detail::require_positive("PathOptions: correction_tolerance", correction_tolerance);
    detail::require(std::isfinite(branch_step) && branch_step != 0.0,
                    "PathOptions: branch_step must be finite and not zero, got ", branch_step);
    if (last_factor) detail::require_finite("PathOptions: last_factor", *last_factor);
}

namespace detail {

/// Predictor along the tangent, Newton's method on the bordered system, a check that the point
/// found lies ahead, bisection of steps in which the number of negative pivots changes or the load
/// turns.
class PathFollower {
public:
    PathFollower(Scene& model, LinearSolver& solver, const PathOptions& options)
        : model_(model),
          solver_(solver),
          options_(options),
          assembly_(model, solver.storage()),
          numbering_(assembly_.numbering()),
          monitor_(model, numbering_),
          rest_(VectorX::Zero(numbering_.coordinates())),
          start_{model.state(), options.first_factor} {
        for (const Support& support : model.supports())
            require(!support.value,
                    "follow_path: supports driven by an amplitude have no place on "
                    "a path; control a displacement instead");
        weigh();
        if (options.control == PathControl::displacement) {
            const int coordinate = model.coordinate(options.at.node, options.at.field);
            require(options.component >= 0 && options.component < model.dimension(),
                    "PathOptions: component must be one of ", model.dimension(), ", got ",
                    options.component);
            require(!numbering_.dependence().attached(coordinate),
                    "PathOptions: the controlled coordinate is attached to another node: control "
                    "that node's");
            controlled_ = numbering_.equation(coordinate + options.component);
            require(controlled_ >= 0,
                    "PathOptions: the controlled coordinate is held: control a free one");
        }
        require(options.direction.size() == 0 || options.direction.size() == rest_.size(),
                "PathOptions: direction needs ", rest_.size(), " coordinates, got ",
                options.direction.size());
        require(detail::all_finite(options.direction), "PathOptions: direction must be finite");
        solver_.analyze(assembly_.tangent());
    }

    [[nodiscard]] PathReport run() {
        Point here = start_;
        if (const Outcome start = begin(here); start.failed()) {
            note_failure(start);
            report_.message = cause(start.status, "the path cannot start", here);
            return finish(start.status, here);
        }
        while (static_cast<int>(report_.points.size()) < options_.max_points) {
            Point next = here;
            const Control ahead = branching_ ? along_branch() : along_path(here, step_);
            Outcome tried = advance(here, ahead, next);
            const double whole =
                tried.failed() ? std::abs(ahead.length) : std::abs(length(here, next));
            if (tried.failed()) next = predicted(here, ahead);
            const bool landing = options_.last_factor && passes(here.factor, next.factor);
            if (landing) {
                // the first step along a mode could land on the branch that it leaves
                const Outcome landed = branching_ ? Outcome::of(Status::diverged)
                                                  : land(here, whole, tried.iterations, next);
                if (!tried.failed() || !landed.failed()) tried = landed;
            }
            if (!tried.failed() && options_.critical_points && !branching_ &&
                !find_critical(here, next))
                tried = Outcome::of(Status::diverged);
            if (tried.failed()) {
                note_failure(tried);
                step_ *= 0.5;
                if (step_ != 0.0 && std::abs(step_) >= options_.smallest_step * first_) continue;
                report_.message = cause(tried.status, "the smallest step failed", here);
                if (controlled_ >= 0 && !report_.fault)
                    report_.message +=
                        "; does the path turn back in the controlled coordinate? "
                        "PathControl::cylindrical passes such points";
                return finish(Status::diverged, here);
            }
            record(here, next, tried.iterations);
            adapt(here, next, tried.iterations);
            here = std::move(next);
            const bool ended =
                options_.progress && !options_.progress(report_.points.back(), here.state);
            if (landing) return finish(Status::converged, here);
            if (ended) {
                report_.message = "the progress callback asked to stop";
                return finish(Status::stopped, here);
            }
        }
        report_.message = joined(
            {"the limit of ", options_.max_points, " points came at load factor ", here.factor,
             "; longer steps need a larger first_step or largest_step", flaw_of_start()});
        return finish(Status::max_iterations, here);
    }

private:
    // A point of the path and the direction of the path there.
    struct Point {
        State state;
        double factor;
        VectorX tangent_u = {};  // per unit of the control's measure, unknowns
        double tangent_f = 0.0;
        int negative_pivots = -1;
    };

    // A point of a step and how far from its beginning it is, as the control measures.
    struct Sample {
        double along;
        Point point;
    };

    // Residual or violation where the path starts, relative: less is in balance, and fulfilled.
    static constexpr double unbalanced_start = 1e-6;

    // Between the way to a point and the direction of the path.
    static constexpr double least_cosine = 0.5;

    // How an attempt ended.
    struct Outcome {
        Status status = Status::converged;
        std::optional<Fault> fault = {};
        int iterations = 0;

        [[nodiscard]] bool failed() const { return status != Status::converged; }
        [[nodiscard]] static Outcome of(const Fault& fault) { return {fault.status, fault, 0}; }
        [[nodiscard]] static Outcome of(Status status) { return {status, {}, 0}; }
    };

    // N(du, df) = du.W du + psi^2 df^2 - length^2, or row.du + slope df - length.
    struct Control {
        bool linear;
        VectorX row;
        double slope;
        double length;
        VectorX first_u;  // predictor
        double first_f;
    };

    void weigh() {
        const Layout& layout = model_.layout();
        weights_.setZero(numbering_.unknowns());
        const double size = std::max(monitor_.size(), std::numeric_limits<double>::min());
        int nodes = 0;  // that do not follow others
        for (int node = 0; node < layout.nodes(); ++node) {
            const int first = layout.index({{node}, Field::r});
            if (first < 0 || !numbering_.dependence().attached(first)) ++nodes;
        }
        for (int k = 0; k < numbering_.coordinates(); ++k)
            if (const int equation = numbering_.equation(k); equation >= 0)
                weights_[equation] = std::pow(size, -2 * length_power(layout.field_of(k))) / nodes;
    }

    [[nodiscard]] double product(const VectorX& a, const VectorX& b) const {
        return a.dot(weights_.cwiseProduct(b));
    }

    // Factorises the first point; sets the direction of travel and the first step.
    [[nodiscard]] Outcome begin(Point& here) {
        branching_ = options_.direction.size() > 0;
        Outcome outcome = prepare_start(here);
        if (!outcome.failed() && options_.control == PathControl::spherical) {
            // coordinates and load factor count alike at the start; at a limit point, where
            // coordinates would take all, the first step's change of the factor is its length
            psi_ = std::min(1.0 / here.tangent_f,
                            std::abs(options_.branch_step / options_.first_step));
            outcome = prepare_start(here);
        }
        if (outcome.failed()) return outcome;
        if (!solver_.iterative() &&
            !repeated_constraints(model_, numbering_, assembly_.tangent()).empty())
            return Outcome::of(Status::singular);
        report_.bifurcations_sought = options_.critical_points;
        step_ = branching_ ? options_.branch_step : first_step(here);
        first_ = std::abs(step_);
        return outcome;
    }

    // A branch may leave a state whose tangent is singular: the step along it does not need that.
    [[nodiscard]] Outcome prepare_start(Point& here) {
        const Outcome outcome = prepare(here, std::copysign(1.0, options_.first_step));
        return branching_ && outcome.status == Status::singular ? Outcome{} : outcome;
    }

    // Turns the direction of travel into that of the first change of the load; returns the step.
    [[nodiscard]] double first_step(Point& here) const {
        if (controlled_ < 0 && options_.first_step < 0.0) reverse(here);
        const double aimed = options_.first_step / here.tangent_f;  // negative: of a displacement
        return std::copysign(std::min(std::abs(aimed), bounded_step(here)), aimed);
    }

    // Returns the step along a direction that changes the coordinates by |branch_step|.
    [[nodiscard]] double bounded_step(const Point& at) const {
        return std::abs(options_.branch_step) / std::sqrt(product(at.tangent_u, at.tangent_u));
    }

    // Sets the next step by the iterations of the last one.
    void adapt(const Point& here, const Point& next, int iterations) {
        if (branching_) {
            // the response to the load was that of the old branch
            branching_ = false;
            step_ = length(here, next);
            if (controlled_ >= 0 && step_ == 0.0) step_ = bounded_step(next);
            first_ = std::abs(step_);
            return;
        }
        const double growth = std::clamp(
            std::sqrt(static_cast<double>(options_.wanted_iterations) / std::max(iterations, 1)),
            0.5, 2.0);
        step_ = std::copysign(std::min(std::abs(step_) * growth, options_.largest_step * first_),
                              step_);
    }

    [[nodiscard]] std::optional<Fault> evaluate(const Point& at, double ahead = 0.0,
                                                Request request = Request::tangent) {
        const Instant instant{at.factor + ahead, at.factor + ahead};
        return assembly_.evaluate({at.state.q, rest_, at.state.multipliers, instant}, request);
    }

    // Solves K x = -dR/df, after evaluate() and factorisation at that point.
    // @param side  as of Assembly::load_rate()
    void solve_load(const Point& at, VectorX& x, double side = 0.0) {
        VectorX rate = VectorX::Zero(numbering_.unknowns());
        VectorX load = assembly_.load_rate(at.state.q, at.factor, side);
        const VectorX motion = assembly_.violation_rate();  // g_f: the factor is the time
        if (largest_magnitude(motion) != 0.0) load -= constraint_force_rate(at);
        VectorX free;
        numbering_.gather_free(load, free);
        rate.head(numbering_.free_coordinates()) = free;
        rate.tail(numbering_.multipliers()) = -motion;
        solve_with(solver_, rate, x);
    }

    // Returns (G^T lambda)_f of constraints that move.
    [[nodiscard]] VectorX constraint_force_rate(const Point& at) {
        const double step = factor_step(at.factor);
        if (evaluate(at, -step, Request::force)) return VectorX::Zero(numbering_.coordinates());
        const VectorX before = assembly_.constraint_force();
        if (evaluate(at, step, Request::force)) return VectorX::Zero(numbering_.coordinates());
        return (assembly_.constraint_force() - before) / (2.0 * step);
    }

    // Tells whether constraints carry all of the load but round-off; after prepare()'s evaluate().
    [[nodiscard]] bool carried(const VectorX& response) const {
        if (numbering_.multipliers() == 0) return false;
        constexpr double round_off = 1e-12;  // of forces
        const int free = numbering_.free_coordinates();
        const auto square = [&](const VectorX& x) {
            VectorX force = VectorX::Zero(free);
            add_product(assembly_.tangent(), assembly_.pattern().storage(), 1.0, x, force);
            return force.cwiseAbs2().cwiseQuotient(weights_.head(free)).sum();
        };
        return square(response.head(free)) <= round_off * round_off * square(response);
    }

    // Factorises at a point; sets its pivots and the direction of the path, of unit measure.
    // @param side  as of Assembly::load_rate()
    [[nodiscard]] Outcome prepare(Point& at, double side = 0.0) {
        idle_ = false;
        if (const std::optional<Fault> fault = evaluate(at)) return Outcome::of(*fault);
        const FactorReport factor = solver_.factorize(assembly_.tangent());
        if (factor.status != Status::converged) return Outcome::of(factor.status);
        const bool counts = options_.critical_points || factor.negative_pivots >= 0;
        if (counts && model_.has_symmetric_loads())
            at.negative_pivots =
                negative_directions(assembly_, assembly_.tangent(), factor, solver_).count;
        solve_load(at, at.tangent_u, side);
        at.tangent_f = 1.0;
        constexpr double round_off = 1e-12;  // of the response, to that of all coordinates
        const double response = product(at.tangent_u, at.tangent_u);
        const double length =
            controlled_ >= 0 ? at.tangent_u[controlled_] : std::sqrt(response + psi_ * psi_);
        idle_ = controlled_ >= 0 ? std::abs(length) * std::sqrt(weights_[controlled_]) <=
                                       round_off * std::sqrt(response)
                                 : length == 0.0 || carried(at.tangent_u);
        if (idle_ || !std::isfinite(length)) return Outcome::of(Status::singular);
        at.tangent_u /= length;
        at.tangent_f /= length;
        return {};
    }

    // Solves for the point that a control asks for, and prepares and orients it.
    [[nodiscard]] Outcome advance(const Point& from, const Control& control, Point& point) {
        const Outcome corrected = correct(control, point);
        if (corrected.failed()) return corrected;
        const bool landing = control.slope != 0.0;  // a load may end at the last factor
        Outcome outcome =
            prepare(point, landing ? std::copysign(1.0, from.factor - point.factor) : 0.0);
        outcome.iterations = corrected.iterations;
        if (outcome.failed() || orient(from, point)) return outcome;
        return Outcome::of(Status::diverged);
    }

    // Returns the predictor of a step, cut at the last load factor; the beginning where it does not
    // reach that, as along a mode. Where a load ends at that factor no state may be as far as a
    // step wants.
    [[nodiscard]] Point predicted(const Point& from, const Control& ahead) const {
        Point point = from;
        const double way = options_.last_factor ? *options_.last_factor - from.factor : 0.0;
        const double part = way == 0.0 ? 0.0 : way / ahead.first_f;
        if (!(part > 0.0 && part <= 1.0)) return point;
        const int free = numbering_.free_coordinates();
        numbering_.add_free(ahead.first_u.head(free), part, point.state.q);
        point.state.multipliers += part * ahead.first_u.tail(numbering_.multipliers());
        point.factor = *options_.last_factor;
        return point;
    }

    // Moves a point behind the last load factor onto it; fails where that leaves the step.
    // @param whole  length of the step
    [[nodiscard]] Outcome land(const Point& from, double whole, int iterations, Point& point) {
        const double change = *options_.last_factor - point.factor;
        const VectorX none = VectorX::Zero(numbering_.unknowns());
        Outcome outcome = advance(from, {true, none, 1.0, change, none, change}, point);
        if (outcome.failed()) return outcome;
        if (std::abs(length(from, point)) > (1.0 + options_.correction_tolerance) * whole)
            return Outcome::of(Status::diverged);
        outcome.iterations += iterations;
        point.factor = point.state.time = *options_.last_factor;
        return outcome;
    }

    static void reverse(Point& at) {
        at.tangent_u = -at.tangent_u;
        at.tangent_f = -at.tangent_f;
    }

    // Keeps the direction of travel through limit and bifurcation points. Returns whether the
    // increment is within 60 degrees of the path's direction at both ends: a sphere also meets the
    // path behind its centre, and beyond a right angle the direction at the end has no sense.
    [[nodiscard]] bool orient(const Point& from, Point& to) const {
        if (controlled_ >= 0)
            return branching_ || length(from, to) * step_ > 0.0;  // a landing may lie behind
        const VectorX moved = difference(from, to);
        const double change = to.factor - from.factor;
        const double cosine = alignment(moved, change, to);
        if (cosine < 0.0) reverse(to);
        // a branch has its direction from the step along its mode
        return branching_ ||
               (alignment(moved, change, from) >= least_cosine && std::abs(cosine) >= least_cosine);
    }

    // Returns the cosine between an increment and the direction of the path, which has unit length.
    [[nodiscard]] double alignment(const VectorX& moved, double change, const Point& at) const {
        const double along = product(moved, at.tangent_u) + psi_ * psi_ * change * at.tangent_f;
        return along / std::hypot(std::sqrt(product(moved, moved)), psi_ * change);
    }

    // Returns the length of an increment as the control measures it; signed for a displacement.
    [[nodiscard]] double length(const Point& from, const Point& to) const {
        const VectorX moved = difference(from, to);
        return controlled_ >= 0
                   ? moved[controlled_]
                   : std::hypot(std::sqrt(product(moved, moved)), psi_ * (to.factor - from.factor));
    }

    // Of all unknowns; multipliers have no weight in a length.
    [[nodiscard]] VectorX difference(const Point& from, const Point& to) const {
        VectorX moved(numbering_.unknowns());
        VectorX free;
        numbering_.gather_free(to.state.q - from.state.q, free);
        moved.head(numbering_.free_coordinates()) = free;
        moved.tail(numbering_.multipliers()) = to.state.multipliers - from.state.multipliers;
        return moved;
    }

    [[nodiscard]] Control along_path(const Point& from, double step) const {
        Control control{controlled_ >= 0,     {}, 0.0, step, step * from.tangent_u,
                        step * from.tangent_f};
        if (control.linear) {
            control.row.setZero(numbering_.unknowns());
            control.row[controlled_] = 1.0;
        }
        return control;
    }

    [[nodiscard]] Control along_branch() const {
        VectorX free;
        numbering_.gather_free(options_.direction, free);
        VectorX mode = VectorX::Zero(numbering_.unknowns());
        mode.head(free.size()) = free;
        require(largest_magnitude(free) != 0.0,
                "PathOptions: direction moves no coordinate that is free");
        mode /= std::sqrt(product(mode, mode));
        return {true, weights_.cwiseProduct(mode), 0.0, step_, step_ * mode, 0.0};
    }

    // Newton's method on the bordered system from `point`, the last one.
    [[nodiscard]] Outcome correct(const Control& control, Point& point) {
        const Point start = point;
        const int free = numbering_.free_coordinates();
        VectorX du = control.first_u;
        double df = control.first_f;
        double correction = std::numeric_limits<double>::infinity();
        double before = std::numeric_limits<double>::infinity();
        VectorX residual, by_residual, by_load;
        for (int iteration = 0;; ++iteration) {
            point.state.q = start.state.q;
            numbering_.add_free(du.head(free), 1.0, point.state.q);
            point.state.multipliers = start.state.multipliers + du.tail(numbering_.multipliers());
            point.factor = point.state.time = start.factor + df;
            if (const auto fault = evaluate(point)) return Outcome::of(*fault);
            const double unbalanced = monitor_.residual(assembly_);
            const bool balanced =
                unbalanced <= options_.residual_tolerance ||
                (unbalanced > 0.25 * before && monitor_.at_round_off(assembly_, point.state.q));
            if (balanced && correction <= options_.correction_tolerance) {
                // a driven joint that turns further could have missed a whole turn
                if (!driven_turn(model_.constraints(), start.factor, point.factor).fits())
                    return Outcome::of(Status::diverged);
                const auto fault = assembly_.inspect(point.state.q);
                return fault ? Outcome::of(*fault) : Outcome{Status::converged, {}, iteration};
            }
            before = unbalanced;
            if (iteration == options_.max_iterations) return Outcome::of(Status::max_iterations);
            if (const FactorReport factor = solver_.factorize(assembly_.tangent());
                factor.status != Status::converged)
                return Outcome::of(factor.status);
            assembly_.residual(residual);
            solve_with(solver_, residual, by_residual);
            solve_load(point, by_load);
            const VectorX row =
                control.linear ? control.row : VectorX(2.0 * weights_.cwiseProduct(du));
            const double slope = control.linear ? control.slope : 2.0 * psi_ * psi_ * df;
            const double violated =
                control.linear
                    ? control.row.dot(du) + control.slope * df - control.length
                    : product(du, du) + psi_ * psi_ * df * df - control.length * control.length;
            const double change = (row.dot(by_residual) - violated) / (row.dot(by_load) + slope);
            const VectorX step = change * by_load - by_residual;
            if (!detail::all_finite(step) || !std::isfinite(change))
                return Outcome::of(Status::not_finite);
            du += step;
            df += change;
            correction = std::max(monitor_.correction(step), psi_ * std::abs(change));
        }
    }

    // Tells whether a step reaches the last load factor: one that ends just before it lands too, as
    // what is left would be a step of round-off.
    [[nodiscard]] bool passes(double from, double to) const {
        constexpr double round_off = 1e-12;
        const double way = *options_.last_factor - from;
        const double left = *options_.last_factor - to;
        return way != 0.0 && left / way <= round_off;  // a path may start at it
    }

    [[nodiscard]] static bool turns(const Point& a, const Point& b) {
        return a.tangent_f * b.tangent_f < 0.0;
    }

    // Change of the number of negative pivots; 0 where unknown.
    [[nodiscard]] static int changed_pivots(const Point& a, const Point& b) {
        if (a.negative_pivots < 0 || b.negative_pivots < 0) return 0;
        return std::abs(a.negative_pivots - b.negative_pivots);
    }

    // Finds the critical points of a step. Returns false where it leaps to another branch, or over
    // the last load factor and back.
    [[nodiscard]] bool find_critical(const Point& from, const Point& to) {
        const auto known = static_cast<std::ptrdiff_t>(report_.critical.size());
        int budget = 200;  // of halvings: where the count flickers, both halves always have changes
        const bool follows =
            search(from, {0.0, from}, {length(from, to), to}, turns(from, to), 30, budget);
        const auto found = report_.critical.begin() + known;
        const auto beyond = [&](const CriticalPoint& point) {
            return options_.last_factor && passes(from.factor, point.factor);
        };
        if (follows && std::none_of(found, report_.critical.end(), beyond)) return true;
        report_.critical.erase(found, report_.critical.end());
        return false;
    }

    // Bisects a part of the step from `origin` until each of its critical points stands alone, or
    // the tangent is too close to singular: then those that are left count as one. Returns false
    // where the step leaps.
    [[nodiscard]] bool search(const Point& origin, const Sample& low, const Sample& high,
                              bool turned, int halvings, int& budget) {
        const int change = changed_pivots(low.point, high.point);
        if (change == 0 && !turned) return true;
        const bool halves = halvings > 0 && budget-- > 0;
        const auto middle = halves ? between(origin, low, high) : std::nullopt;
        if (!middle) {
            if (leaps(low.point, high.point)) return false;
            record_critical(low, high, turned);
            return true;
        }
        // Close to a singular tangent the direction is round-off, its sign too: there the part with
        // the pivots' change has the turn of the whole, known from further off.
        const bool apart = changed_pivots(low.point, middle->point) != 0 &&
                           changed_pivots(middle->point, high.point) != 0;
        const bool close = halvings < 20 && change != 0 && !(apart && turned);
        const auto part = [&](const Sample& a, const Sample& b) {
            const bool turn =
                close ? turned && changed_pivots(a.point, b.point) != 0 : turns(a.point, b.point);
            return search(origin, a, b, turn, halvings - 1, budget);
        };
        return part(low, *middle) && part(*middle, high);
    }

    // Tells whether two neighbouring points lie on different branches: then the way from one to the
    // other is more than 11 degrees off the directions there. Closer points differ by round-off.
    [[nodiscard]] bool leaps(const Point& low, const Point& high) const {
        if (controlled_ >= 0 || length(low, high) <= 10.0 * options_.correction_tolerance)
            return false;
        const VectorX moved = difference(low, high);
        const double change = high.factor - low.factor;
        return std::min(alignment(moved, change, low), alignment(moved, change, high)) < 0.98;
    }

    // A point of the path about half way, aside of it where that is too close to singular.
    [[nodiscard]] std::optional<Sample> between(const Point& origin, const Sample& low,
                                                const Sample& high) {
        for (const double part : {0.5, 0.4, 0.65}) {
            Sample middle{low.along + part * (high.along - low.along), origin};
            Control control = along_path(origin, middle.along);
            interpolate(origin, low.point, high.point, part, control);
            if (!advance(origin, control, middle.point).failed()) return middle;
        }
        return std::nullopt;
    }

    // Starts a control at the part of the way from one point to another, by the cubic through both
    // points and their directions: a tangent from `origin` is further off the path.
    void interpolate(const Point& origin, const Point& low, const Point& high, double part,
                     Control& control) const {
        const double rest = 1.0 - part, way = length(low, high);
        const double to_high = part * part * (3.0 - 2.0 * part);
        const double at_low = way * part * rest * rest, at_high = -way * part * part * rest;
        control.first_u = difference(origin, low) + to_high * difference(low, high) +
                          at_low * low.tangent_u + at_high * high.tangent_u;
        control.first_f = low.factor - origin.factor + to_high * (high.factor - low.factor) +
                          at_low * low.tangent_f + at_high * high.tangent_f;
    }

    void record_critical(const Sample& low, const Sample& high, bool turned) {
        const int change = changed_pivots(low.point, high.point);
        // a direction that turns over while the tangent stays regular: a sharp bend of the path
        if (change == 0 && high.point.negative_pivots >= 0) return;
        report_.critical.push_back({turned ? CriticalKind::limit : CriticalKind::bifurcation,
                                    0.5 * (low.point.factor + high.point.factor),
                                    report_.points.empty() ? 0 : report_.points.size() - 1,
                                    high.point.state, null_vector(high.point), std::max(change, 1),
                                    0.5 * std::abs(high.along - low.along)});
    }

    // Inverse iteration with the nearly singular tangent at a critical point.
    [[nodiscard]] VectorX null_vector(const Point& at) {
        VectorX mode = VectorX::LinSpaced(numbering_.unknowns(), 1.0, 2.0);
        for (int k = 0; k < mode.size(); k += 2) mode[k] = -mode[k];
        Point point = at;
        if (!prepare(point).failed()) {
            VectorX next;
            for (int sweep = 0; sweep < 4; ++sweep) {
                solve_with(solver_, mode, next);
                mode = next / next.norm();
            }
        }
        mode /= std::sqrt(product(mode, mode));
        VectorX all = VectorX::Zero(numbering_.coordinates());
        numbering_.add_free(mode.head(numbering_.free_coordinates()), 1.0, all);
        return all;
    }

    void record(const Point& from, const Point& to, int iterations) {
        const double before = report_.points.empty() ? 0.0 : report_.points.back().arc;
        report_.points.push_back(
            {to.factor, before + std::abs(length(from, to)), iterations, to.negative_pivots});
        if (to.negative_pivots < 0) report_.bifurcations_sought = false;
    }

    void note_failure(const Outcome& outcome) {
        report_.failure = outcome.status;
        report_.fault = outcome.fault;
    }

    // Says why a point has no successor, from the last factorisation or fault.
    [[nodiscard]] std::string cause(Status status, const char* what, const Point& here) {
        std::string text = joined({what, " at load factor ", here.factor, ": "});
        if (status == Status::not_finite && !report_.fault)
            report_.fault = assembly_.inspect_values(here.state.q);
        if (report_.fault) {
            text += assembly_.describe(*report_.fault);
            return text + flaw_of_start();
        }
        std::string found;
        if (status == Status::singular && report_.points.empty())
            found = singular_cause(model_, numbering_, assembly_.tangent(), solver_);
        if (found.empty() && status == Status::singular && idle_)
            found = controlled_ >= 0 ? "the load does not move the coordinate that is controlled"
                                     : "the load moves nothing";
        text += found.empty() ? std::string(to_string(status)) : found;
        return text + flaw_of_start();
    }

    // Says what is wrong with the state where the path starts, where something is.
    [[nodiscard]] std::string flaw_of_start() {
        if (evaluate(start_)) return {};
        std::string text = unfulfilled();
        if (text.empty() && monitor_.residual(assembly_) > unbalanced_start &&
            !monitor_.at_round_off(assembly_, start_.state.q))
            text = "; the path starts out of balance: solve_statics() first";
        return text;
    }

    // Names the constraint that the last evaluation violates most, where one is violated.
    [[nodiscard]] std::string unfulfilled() const {
        const VectorX scale = assembly_.violation_scale(monitor_.size());
        const auto& constraints = model_.constraints();
        double most = unbalanced_start;  // less is fulfilled
        std::size_t worst = constraints.size();
        Eigen::Index row = 0;
        for (std::size_t k = 0; k < constraints.size(); ++k)
            for (const Eigen::Index end = row + constraints[k].equations(); row < end; ++row) {
                const double share = std::abs(assembly_.violation()[row]) / scale[row];
                if (!(share > most)) continue;
                most = share;
                worst = k;
            }
        if (worst == constraints.size()) return {};
        return joined({"; where the path starts, constraint ", worst, " (",
                       constraints[worst].name(), ") is not fulfilled: solve_statics() first"});
    }

    [[nodiscard]] PathReport finish(Status status, const Point& last) {
        model_.state() = last.state;
        report_.status = status;
        return std::move(report_);
    }

    Scene& model_;
    LinearSolver& solver_;
    const PathOptions& options_;
    Assembly assembly_;
    const Numbering& numbering_;
    ConvergenceMonitor monitor_;
    VectorX rest_;
    const Point start_;
    VectorX weights_;      // of the free coordinates in the path's measure
    double psi_ = 0.0;     // weight of the load factor in it
    int controlled_ = -1;  // equation of the controlled coordinate
    double step_ = 0.0;    // the next one, signed for a displacement or along a branch
    double first_ = 0.0;   // size of the one that others are measured by
    bool branching_ = false;
    bool idle_ = false;  // a change of the load moves nothing, of what is measured
    PathReport report_;
};

}  // namespace detail

ANCF_INLINE PathReport follow_path(Scene& model, LinearSolver& solver, const PathOptions& options) {
    options.check();
    return detail::PathFollower(model, solver, options).run();
}

}  // namespace ancf
