// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Static equilibrium by Newton's method in load steps.
///
/// At each load factor the residual R(q, lambda) of the assembly is brought to zero. The stopping
/// test is described in docs/theory-statics.md: the residual against loads and reactions, the
/// correction against the scene's size, with the round-off of the residual as a floor.

#pragma once

#include <ancf/assembly/assembly.hpp>
#include <ancf/assembly/resultant.hpp>
#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/solver/stability.hpp>
#include <ancf/types.hpp>

#include <functional>
#include <optional>
#include <string>

namespace ancf {

/// How Newton's method corrects a state: docs/theory-statics.md, "Stresses as unknowns".
enum class NewtonKind {
    plain,  ///< the derivative of the residual
    mixed,  ///< that of mixed integration points: fewer iterations and larger steps
    /// mixed where an element is; large corrections turn slopes and chords, by the angle where
    /// moments do most work and by its tangent where forces do; a step that will not converge, or
    /// ends on another branch, is cut; a line that hangs loose is iterated plainly instead:
    /// docs/theory-statics.md, "The automatic iteration"
    automatic
};

/// How a static problem is solved.
struct StaticsOptions {
    NewtonKind newton = NewtonKind::automatic;  ///< a step that fails otherwise is repeated as
                                                ///< plain; automatic takes it in parts before
    int steps = 1;                              ///< equal load steps; one in which a driven joint
                                                ///< turns by more than pi/3 is taken in parts
    int max_iterations = 100;                   ///< linear solves per step
    int mixed_iterations = 25;                  ///< likewise, before a step is repeated as plain
    double residual_tolerance = 1e-9;           ///< relative to loads and reactions
    double correction_tolerance = 1e-6;  ///< relative to the scene's size; slopes absolutely,
                                         ///< r_xx times the elements' mean length; 1e-3
                                         ///< where the residual is at its round-off
    bool line_search = false;            ///< halve corrections that double the residual
    bool adaptive = false;               ///< halve a step that fails, widen one that does well
    double min_step = 1e-4;              ///< smallest step of an adaptive run, as a part of
                                         ///< the way from first_factor to last_factor
    double first_factor = 0.0;           ///< load factor of the state that the model is in; to
                                         ///< settle at one factor, such as 0, any other
    double last_factor = 1.0;            ///< load factor to reach

    /// Called after every converged step, not after its parts; returning false stops there, with
    /// Status::stopped.
    std::function<bool(double factor, const State& state)> progress;

    /// @throws InvalidArgument naming the first value that cannot be meant.
    void check() const;
};

/// One load step.
struct LoadStep {
    double factor = 0.0;                    ///< load factor at its end
    NewtonKind newton = NewtonKind::plain;  ///< which iteration it took
    bool damped = false;                    ///< with damped corrections: no path seemed to go on
    int iterations = 0;                     ///< linear solves
    int indefinite = 0;                     ///< of them, those with negative pivots that no
                                            ///< multiplier accounts for, where a solver counts
    Status status = Status::converged;      ///< how it ended
    bool at_round_off = false;              ///< converged by the floor of the residual's round-off
    List<double> residuals;                 ///< relative residual before each solve, and the last
    List<double> corrections;               ///< relative size of each correction
};

/// What a static solution reports.
struct StaticsReport {
    Status status = Status::converged;  ///< how it ended
    double factor = 0.0;                ///< load factor reached
    List<LoadStep> steps;               ///< every step or part of one tried, in order
    std::optional<Fault> fault;         ///< the element that failed, for degenerate and not_finite
    std::string message;                ///< what failed where; of a singular tangent, what moves
                                        ///< without stiffness; of a driven joint that turns too
                                        ///< far, which one. Empty where it converged
    /// In the state that the model is left in, an element so short that its law softens: an
    /// equilibrium with it need not be the one that smaller load steps lead to. CrossSectionBeam
    /// tells, with any centre line.
    std::optional<ElementPlace> softened;
    /// In that state, the largest angle between the slopes r_x at the two ends of an element, rad:
    /// how coarse the mesh is. Beyond about one a mesh may have stable equilibria of its own. Like
    /// `softened` it is left as it is here where that state cannot be evaluated.
    double largest_turn = 0.0;
    /// Of the state that the model is left in, an equilibrium where a step converged. Costs one
    /// factorisation L D L^T after the last step where the solver counts no pivots, or the tangent
    /// of the last correction is not near that of the state.
    Stability stability = Stability::unknown;
    /// Whether loads alone hold the scene: without them it moves without stiffness, as a pendulum
    /// does. Where that is not meant a support or a joint is missing.
    bool held_by_loads = false;
    FactorReport factorisation;  ///< of the last tangent solved with
    VectorX reactions;           ///< generalised forces of the supports, zero elsewhere; N and N m
    Resultant imbalance;         ///< loads plus reactions: zero at equilibrium
    double strain_energy = 0.0;  ///< J

    /// Returns the number of linear solves over all steps.
    [[nodiscard]] int iterations() const {
        int sum = 0;
        for (const LoadStep& step : steps) sum += step.iterations;
        return sum;
    }
};

/// Brings a model to static equilibrium under its loads.
///
/// The model's state is the first guess and receives the solution; where the run fails, or a
/// function of the user's throws, it keeps the last converged load step. Loads without an amplitude
/// grow with the load factor. State::time becomes that factor, and rates stay as they are: set both
/// before a motion that begins at rest at another time.
/// @param solver  any linear solver (linear_solver.hpp).
/// @throws InvalidArgument for options that cannot be meant, or a scene that the solver's storage
///         does not suit.
[[nodiscard]] StaticsReport solve_statics(Scene& model, LinearSolver& solver,
                                          const StaticsOptions& options = {});

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/statics.ipp>
#endif
