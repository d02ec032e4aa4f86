// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The algorithm behind follow_path: predictor along the tangent, Newton's method on the bordered
/// system, bisection of steps in which the number of negative pivots changes.

#pragma once

#include <ancf/solver/path.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ancf {

inline void PathOptions::check() const {
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

template <class Scene, class LinearSolver>
class PathFollower {
public:
    PathFollower(Scene& model, LinearSolver& solver, const PathOptions& options)
        : model_(model),
          solver_(solver),
          options_(options),
          assembly_(model, LinearSolver::storage),
          numbering_(assembly_.numbering()),
          monitor_(model, numbering_),
          rest_(VectorX::Zero(numbering_.coordinates())) {
        for (const Support& support : model.supports())
            require(!support.value,
                    "follow_path: supports driven by an amplitude have no place on "
                    "a path; control a displacement instead");
        weigh();
        if (options.control == PathControl::displacement) {
            const int coordinate = model.coordinate(options.at.node, options.at.field);
            require(options.component >= 0 && options.component < Scene::dimension,
                    "PathOptions: component must be one of ", Scene::dimension, ", got ",
                    options.component);
            controlled_ = numbering_.equation(coordinate + options.component);
            require(controlled_ >= 0,
                    "PathOptions: the controlled coordinate is held by a support");
        }
        require(options.direction.size() == 0 || options.direction.size() == rest_.size(),
                "PathOptions: direction needs ", rest_.size(), " coordinates, got ",
                options.direction.size());
        require(options.direction.allFinite(), "PathOptions: direction must be finite");
        solver_.analyze(assembly_.tangent());
    }

    [[nodiscard]] PathReport run() {
        Point here{model_.state(), options_.first_factor};
        Status status = prepare(here);
        if (status == Status::converged && options_.control == PathControl::spherical) {
            // coordinates and load factor count alike at the start
            psi_ = 1.0 / here.tangent_f;
            status = prepare(here);
        }
        if (status != Status::converged) return finish(status, here);
        double step = first_length(here);
        const double first = std::abs(step);
        bool branching = options_.direction.size() > 0;
        while (static_cast<int>(report_.points.size()) < options_.max_points) {
            Control control = branching ? along_branch() : along_path(here, step);
            Point next = here;
            const int iterations = correct(control, next);
            if (iterations < 0 || prepare(next) != Status::converged) {
                step *= 0.5;
                if (branching || std::abs(step) < options_.smallest_step * first)
                    return finish(Status::diverged, here);
                continue;
            }
            orient(here, next);
            const bool landing = options_.last_factor && passes(here.factor, next.factor);
            if (landing) {
                control = to_factor(*options_.last_factor - next.factor);
                if (correct(control, next) < 0 || prepare(next) != Status::converged)
                    return finish(Status::diverged, here);
                orient(here, next);
                next.factor = next.state.time = *options_.last_factor;
            }
            if (options_.critical_points && !branching && crosses(here, next))
                locate(here, next, step);
            if (landing) {
                record(next, iterations, step);
                return finish(Status::converged, next);
            }
            record(next, iterations, step);
            here = std::move(next);
            if (options_.progress && !options_.progress(report_.points.back(), here.state))
                return finish(Status::converged, here);
            const double growth =
                std::clamp(std::sqrt(static_cast<double>(options_.wanted_iterations) /
                                     std::max(iterations, 1)),
                           0.5, 2.0);
            step = std::copysign(std::min(std::abs(step) * growth, options_.largest_step * first),
                                 step);
            branching = false;
        }
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
        const double nodes = std::max(1, layout.nodes());
        for (int node = 0; node < layout.nodes(); ++node)
            for (int k = layout.first(node); k < layout.first(node + 1); ++k) {
                const bool position = layout.fields(node).contains(Field::r) &&
                                      k < layout.first(node) + Scene::dimension;
                if (const int equation = numbering_.equation(k); equation >= 0)
                    weights_[equation] = (position ? 1.0 / (size * size) : 1.0) / nodes;
            }
    }

    [[nodiscard]] double product(const VectorX& a, const VectorX& b) const {
        return a.dot(weights_.cwiseProduct(b));
    }

    [[nodiscard]] std::optional<Fault> evaluate(const Point& at) {
        const Instant instant{at.factor, at.factor};
        return assembly_.evaluate({at.state.q, rest_, at.state.multipliers, instant},
                                  Request::tangent);
    }

    // Solves K x = dQ/df.
    void solve_load(const Point& at, VectorX& x) {
        VectorX rate = VectorX::Zero(numbering_.unknowns());
        VectorX free;
        numbering_.gather_free(assembly_.load_rate(at.state.q, at.factor), free);
        rate.head(numbering_.free_coordinates()) = free;
        solver_.solve(rate, x);
    }

    // Factorises at a point; sets its pivots and the direction of the path, of unit measure.
    [[nodiscard]] Status prepare(Point& at) {
        if (const std::optional<Fault> fault = evaluate(at)) return fault->status;
        const FactorReport factor = solver_.factorize(assembly_.tangent());
        if (factor.status != Status::converged) return factor.status;
        at.negative_pivots = factor.negative_pivots;
        solve_load(at, at.tangent_u);
        at.tangent_f = 1.0;
        const double length = controlled_ >= 0
                                  ? at.tangent_u[controlled_]
                                  : std::sqrt(product(at.tangent_u, at.tangent_u) + psi_ * psi_);
        if (!(std::abs(length) > 0.0) || !std::isfinite(length)) return Status::singular;
        at.tangent_u /= length;
        at.tangent_f /= length;
        return Status::converged;
    }

    // Keeps the direction of travel through limit and bifurcation points.
    void orient(const Point& from, Point& to) const {
        if (controlled_ >= 0) return;
        const VectorX moved = free_difference(from, to);
        const double along =
            product(moved, to.tangent_u) + psi_ * psi_ * (to.factor - from.factor) * to.tangent_f;
        if (along >= 0.0) return;
        to.tangent_u = -to.tangent_u;
        to.tangent_f = -to.tangent_f;
    }

    [[nodiscard]] VectorX free_difference(const Point& from, const Point& to) const {
        VectorX moved = VectorX::Zero(numbering_.unknowns());
        VectorX free;
        numbering_.gather_free(to.state.q - from.state.q, free);
        moved.head(numbering_.free_coordinates()) = free;
        return moved;
    }

    [[nodiscard]] double first_length(Point& at) const {
        // tangent_f > 0 here unless a displacement is controlled, whose step may be of either sign
        return options_.first_step / at.tangent_f;
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
        require((free.array() != 0.0).any(),
                "PathOptions: direction moves no coordinate that is free");
        mode /= std::sqrt(product(mode, mode));
        return {true,
                weights_.cwiseProduct(mode),
                0.0,
                options_.branch_step,
                options_.branch_step * mode,
                0.0};
    }

    [[nodiscard]] Control to_factor(double change) const {
        return {true,   VectorX::Zero(numbering_.unknowns()), 1.0,
                change, VectorX::Zero(numbering_.unknowns()), change};
    }

    // Newton's method on the bordered system from `point`, the last one; -1 where it fails.
    [[nodiscard]] int correct(const Control& control, Point& point) {
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
            if (evaluate(point)) return -1;
            const double unbalanced = monitor_.residual(assembly_);
            const bool balanced =
                unbalanced <= options_.residual_tolerance ||
                (unbalanced > 0.25 * before && monitor_.at_round_off(assembly_, point.state.q));
            if (balanced && correction <= options_.correction_tolerance)
                return assembly_.inspect(point.state.q) ? -1 : iteration;
            before = unbalanced;
            if (iteration == options_.max_iterations) return -1;
            if (solver_.factorize(assembly_.tangent()).status != Status::converged) return -1;
            assembly_.residual(residual);
            solver_.solve(residual, by_residual);
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
            if (!step.allFinite() || !std::isfinite(change)) return -1;
            du += step;
            df += change;
            correction = monitor_.correction(step);
        }
    }

    [[nodiscard]] bool passes(double from, double to) const {
        return (*options_.last_factor - from) * (*options_.last_factor - to) <= 0.0 && from != to;
    }

    [[nodiscard]] static bool turns(const Point& a, const Point& b) {
        return a.tangent_f * b.tangent_f < 0.0;
    }

    [[nodiscard]] bool crosses(const Point& a, const Point& b) const {
        return a.negative_pivots >= 0 && b.negative_pivots >= 0
                   ? a.negative_pivots != b.negative_pivots
                   : turns(a, b);
    }

    // Bisects the step between two points until the critical one is found.
    void locate(const Point& from, const Point& to, double step) {
        double low = 0.0;
        double high = step;
        Point before = from;
        Point after = to;
        for (int halving = 0; halving < 30; ++halving) {
            // aside of the middle where that happens to be too close to singular
            double middle = low;
            Point point = from;
            bool found = false;
            for (const double part : {0.5, 0.4, 0.65}) {
                middle = low + part * (high - low);
                point = from;
                found = correct(along_path(from, middle), point) >= 0 &&
                        prepare(point) == Status::converged;
                if (found) break;
            }
            if (!found) break;
            orient(from, point);
            if (crosses(from, point)) {
                high = middle;
                after = std::move(point);
            } else {
                low = middle;
                before = std::move(point);
            }
        }
        const CriticalKind kind =
            turns(before, after) ? CriticalKind::limit : CriticalKind::bifurcation;
        report_.critical.push_back({kind, 0.5 * (before.factor + after.factor),
                                    report_.points.empty() ? 0 : report_.points.size() - 1,
                                    after.state, null_vector(after)});
    }

    // Inverse iteration with the nearly singular tangent at a critical point.
    [[nodiscard]] VectorX null_vector(const Point& at) {
        VectorX mode = VectorX::LinSpaced(numbering_.unknowns(), 1.0, 2.0);
        for (int k = 0; k < mode.size(); k += 2) mode[k] = -mode[k];
        Point point = at;
        if (prepare(point) == Status::converged) {
            VectorX next;
            for (int sweep = 0; sweep < 4; ++sweep) {
                solver_.solve(mode, next);
                mode = next / next.norm();
            }
        }
        mode /= std::sqrt(product(mode, mode));
        VectorX all = VectorX::Zero(numbering_.coordinates());
        numbering_.add_free(mode.head(numbering_.free_coordinates()), 1.0, all);
        return all;
    }

    void record(const Point& point, int iterations, double step) {
        const double before = report_.points.empty() ? 0.0 : report_.points.back().arc;
        report_.points.push_back(
            {point.factor, before + std::abs(step), iterations, point.negative_pivots});
    }

    [[nodiscard]] PathReport finish(Status status, const Point& last) {
        model_.state() = last.state;
        report_.status = status;
        return std::move(report_);
    }

    Scene& model_;
    LinearSolver& solver_;
    const PathOptions& options_;
    Assembly<Scene> assembly_;
    const Numbering& numbering_;
    ConvergenceMonitor monitor_;
    VectorX rest_;
    VectorX weights_;      // of the free coordinates in the path's measure
    double psi_ = 0.0;     // weight of the load factor in it
    int controlled_ = -1;  // equation of the controlled coordinate
    PathReport report_;
};

}  // namespace detail

template <class Scene, class LinearSolver>
PathReport follow_path(Scene& model, LinearSolver& solver, const PathOptions& options) {
    require_linear_solver<LinearSolver>();
    options.check();
    return detail::PathFollower<Scene, LinearSolver>(model, solver, options).run();
}

}  // namespace ancf
