// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Path following: equilibrium states along a path on which the load factor may rise and fall.
///
/// A point of the path solves R(u, f) = 0 together with a control N(du, df) = 0 on the increment
/// from the last point. Limit and bifurcation points are found by the number of negative pivots of
/// the tangent. Source: Crisfield's arc length (spherical, cylindrical) with a consistent
/// linearisation; docs/theory-paths.md.

#pragma once

#include <ancf/assembly/assembly.hpp>
#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace ancf {

/// What the steps of a path are measured by.
enum class PathControl {
    cylindrical,  ///< the length of the change of the coordinates
    spherical,    ///< that length and the change of the load factor
    displacement  ///< the change of one coordinate
};

/// One converged point.
struct PathPoint {
    double factor = 0.0;  ///< load factor
    double arc = 0.0;     ///< sum of the lengths of the steps up to here, as the control measures
    int iterations = 0;   ///< linear solves of the corrector
    int negative_pivots = -1;  ///< of the tangent on what constraints allow; 0 = stable under dead
                               ///< loads, -1 = unknown
};

/// Where the tangent becomes singular.
enum class CriticalKind {
    limit,       ///< the load factor turns round
    bifurcation  ///< another branch passes through
};

/// A critical point between two points of the path.
struct CriticalPoint {
    CriticalKind kind;  ///< limit point or bifurcation
    double factor;      ///< load factor there
    std::size_t after;  ///< index of the path point before it
    State state;        ///< of the model there, within half_width
    /// Null vector of the tangent, all coordinates, of unit length in the path's measure.
    VectorX mode;
    /// By how much the number of negative pivots changes: above 1, several points fall together and
    /// `mode` is one of their null vectors. 1 where pivots are unknown.
    int multiplicity = 1;
    /// Half the length of the step's part that contains the point, as the control measures: 1e-9 of
    /// the step, or more where the path could not be computed so close to a singular tangent.
    double half_width = 0.0;
};

/// How a path is followed.
struct PathOptions {
    PathControl control = PathControl::cylindrical;  ///< what a step is measured by
    NodeField at{};                                  ///< displacement control: the vector
    int component = 0;                               ///< displacement control: component, from 0

    double first_factor = 0.0;           ///< load factor of the state that the model is in
    double first_step = 0.1;             ///< change of the load factor that the first step aims at,
                                         ///< by any control; negative: the load falls; no longer
                                         ///< than `branch_step`
    double largest_step = 10.0;          ///< longest step, as a multiple of the first one; 1000
                                         ///< where a stiff scene buckles in the end
    double smallest_step = 1e-6;         ///< shortest step, likewise
    int wanted_iterations = 5;           ///< steps grow and shrink towards this number
    int max_iterations = 15;             ///< of a step, before it is halved
    int max_points = 1000;               ///< limit of a path
    double residual_tolerance = 1e-9;    ///< as in StaticsOptions
    double correction_tolerance = 1e-6;  ///< as in StaticsOptions
    bool critical_points = true;         ///< find them, and with them steps that leap to another
                                         ///< branch, which are halved

    std::optional<double> last_factor;  ///< stop when the load factor passes it, and land on it
    /// Called at every point, the last included; returning false ends the path there,
    /// with status stopped.
    std::function<bool(const PathPoint& point, const State& state)> progress;

    /// First direction, all coordinates; empty: along the load. A mode of a CriticalPoint switches
    /// to the branch through it, or says which way to leave a limit point, where the load falls
    /// either way.
    VectorX direction;
    /// Length of the first step along `direction`, its sign the side; halved where it fails. Its
    /// square is the mean over nodes of the squared displacement, relative to the scene's size,
    /// squared changes of slopes, and of r_xx relative to the size's inverse. A first step along
    /// the load is no longer either: at a limit point the response to a change of the load has no
    /// bound.
    double branch_step = 0.05;

    /// @throws InvalidArgument naming the first value that cannot be meant.
    void check() const;
};

/// What a followed path reports.
struct PathReport {
    /// converged: landed on last_factor; stopped: by the callback; diverged: the smallest step
    /// failed; max_iterations: max_points; else the path cannot start in this state.
    Status status = Status::converged;
    List<PathPoint> points;        ///< in order
    List<CriticalPoint> critical;  ///< in order
    /// Whether negative pivots were known at every point, so that bifurcations were looked for.
    /// Where not, as under loads without a potential, the path passes them without a word.
    bool bifurcations_sought = false;
    /// Why a step failed, the last that did; converged where none has.
    Status failure = Status::converged;
    std::optional<Fault> fault;  ///< the element that failed then, for degenerate and not_finite
    std::string message;         ///< why the path ended where; empty where it converged
};

/// Follows the path of equilibria from the model's state; the model ends in the last point.
///
///     const int y = model.coordinate(crown, ancf::Field::r) + 1;
///     options.progress = [&](const ancf::PathPoint& point, const ancf::State& state) {
///         std::cout << point.factor << ' ' << state.q[y] << '\n';
///         return state.q[y] > -1.0;  // ends the path here; so do last_factor and max_points
///     };
///     const auto report = ancf::follow_path(model, solver, options);
///     for (const auto& point : report.critical) std::cout << point.factor << '\n';
///
/// Under loads without a potential, and with a solver that iterates, negative pivots are unknown:
/// limit points are still found. A solver that counts them, such as EigenLdlt, saves a
/// factorisation at each point. Of several points within one step those are found that a bisection
/// tells apart; two that undo each other's change between the ends of a step are not seen.
/// Constraints may move with the load factor, which is their time.
/// @throws InvalidArgument for options that cannot be meant, driven supports, or a scene that the
///         solver's storage does not suit.
[[nodiscard]] PathReport follow_path(Scene& model, LinearSolver& solver,
                                     const PathOptions& options = {});

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/path.ipp>
#endif
