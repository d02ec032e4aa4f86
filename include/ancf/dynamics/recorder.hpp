// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the integrators of this folder share: output at the schedule's times, and statistics.
///
/// Between two steps q is the cubic of q and v at both ends and v its derivative, the multipliers
/// are linear, unless the integrator has something better. What is observed is projected on the
/// constraints; the integration never sees that.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <chrono>
#include <cstddef>
#include <functional>

namespace ancf::detail {

/// Throws where nothing can move, and for a part of a scene unless `takes_parts`.
void require_motion(const DynamicProblem& problem, bool takes_parts = false);

/// Returns the width at which steps begin to vanish in the round-off of time, s.
[[nodiscard]] double time_resolution(double start, double end) noexcept;

/// Throws for steps that vanish in the round-off of time.
void require_resolved(double step, double start, double end);

/// Throws unless the problem was set up for the storage of the solver.
void require_same_storage(const LinearSolver& solver, const DynamicProblem& problem);

/// A point of a motion: free coordinates, rates and multipliers at a time.
struct MotionPoint {
    double time = 0.0;
    VectorX q, v, lambda;
};

/// Tells whether a run's end, s, is further than the round-off of a step; a last point ahead of it
/// or beyond it by less belongs to the end.
/// @param step  s; that of the integrator, or the whole run where that is shorter
[[nodiscard]] inline bool goes_on(const MotionPoint& now, double end, double step) noexcept {
    return end - now.time > 1e-9 * step;
}

/// Energies and power of a point, sizes of M and K there: what tells one scene from another.
[[nodiscard]] VectorX signature(DynamicProblem& problem, const MotionPoint& point);

/// Throws unless a run that a memory continues goes on from where it ended: the model's state, as
/// `problem.start()` read it, and the scene.
/// @param who    the integrator, for the message.
/// @param point  where the memory's run ended.
void require_continuation(const char* who, const Memory& memory, DynamicProblem& problem,
                          const MotionPoint& start, const MotionPoint& point);

/// Returns the point of a motion at a time between two steps.
using Between = std::function<MotionPoint(double time)>;

/// Reports one run, and ends it where the user or an element does.
class Recorder {
public:
    /// @param energies  whether to follow the energy of every step (one evaluation each).
    Recorder(DynamicProblem& problem, const Schedule& schedule, DynamicsReport& report,
             bool energies);

    /// Takes the start and observes it where asked.
    void start(const MotionPoint& point);

    /// Takes an accepted step.
    /// @param between  gives the points inside, where they are not those of the cubic.
    /// @return false where the run ends; the report says why.
    [[nodiscard]] bool step(const MotionPoint& from, const MotionPoint& to,
                            const Between& between = {});

    /// Observes what lies within the round-off of the end. Stores the last point in the model,
    /// projected on the constraints; where that fails as it is, and the report says so.
    void finish(const MotionPoint& point);

private:
    // Takes what a step left into the report, before any projection: constraints and, where it is
    // followed, energy by an evaluation of its own. It inspects at about every 24 evaluations of
    // the forces, or every 12 steps where those are not counted yet.
    void note(const MotionPoint& point);
    // Notes an element that is no beam any more, unless one is noted. It ends a run that may not
    // pass.
    void inspect(const MotionPoint& point);
    [[nodiscard]] bool goes_on(double time);
    void store(const MotionPoint& end);
    void observe(const MotionPoint& from, const MotionPoint& to, double slack,
                 const Between& between);
    [[nodiscard]] static MotionPoint cubic(const MotionPoint& from, const MotionPoint& to,
                                           double time);

    DynamicProblem& problem_;
    const Schedule& schedule_;
    DynamicsReport& report_;
    bool energies_;
    std::chrono::steady_clock::time_point begin_;
    std::size_t next_ = 0;
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/recorder.ipp>  // IWYU pragma: export
#endif
