// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What a run of any integrator of this folder has besides its formulas: a consistent start, the
/// grid of its steps, what it reports, and what it carries to the next run.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>

namespace ancf::detail {

/// Throws where nothing can move, for a part of a scene unless `takes_parts`, and for a schedule
/// that does not fit the model's time.
void require_motion(const DynamicProblem& problem, const Schedule& schedule,
                    bool takes_parts = false);

/// Returns the width at which steps begin to vanish in the round-off of time, s.
[[nodiscard]] double time_resolution(double start, double end) noexcept;

/// Throws for steps that vanish in the round-off of time.
void require_resolved(double step, double start, double end);

/// A point of a motion: free coordinates, rates and multipliers at a time.
struct MotionPoint {
    double time = 0.0;
    VectorX q, v, lambda;
};

/// Returns what tells one scene from another at a point: kinetic, strain and potential energy, the
/// power of loads; sizes of loads, of M and of K; what is out of balance and the size of its parts;
/// the accelerations that constraints ask for.
/// @return 10 numbers, of all parts of the scene.
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
///
/// Between two steps q is the cubic of q and v at both ends and v its derivative, the multipliers
/// are linear, unless the integrator has something better. What is observed is projected on the
/// constraints; the integration never sees that.
class Recorder {
public:
    /// @param energies  whether to follow the energy of every step (one evaluation each).
    Recorder(DynamicProblem& problem, const Schedule& schedule, DynamicsReport& report,
             bool energies)
        : problem_(problem),
          schedule_(schedule),
          report_(report),
          energies_(energies),
          begin_(std::chrono::steady_clock::now()) {}

    /// Sets whether to report the multipliers that belong to each reported state, not those of the
    /// integrator.
    void solve_multipliers(bool solves) noexcept { solves_multipliers_ = solves; }

    /// Ends a run, where energies are followed, that has a fifth of its kinetic and strain energy
    /// from nothing, once a step has turned the scene further than this; not one that may pass
    /// elements that are no beam, whose energy tells nothing.
    /// @param turn    rad
    /// @param advice  what may pass, for the message; it stays.
    /// @param doubt   whether the work of loads and drives is known badly, as by steps that do not
    ///                resolve vibrations and jumps: a gain is to exceed all of it.
    void forbid_gain(double turn, const char* advice, bool doubt = false) noexcept {
        most_turn_ = turn;
        advice_ = advice;
        doubts_work_ = doubt;
    }

    /// Returns what may pass where a run with fixed steps fails.
    [[nodiscard]] const char* advice() const noexcept { return advice_; }

    /// Returns the strain energy of the last point, J; by an evaluation where no energies are
    /// followed. It does not depend on that, nor on what was observed.
    [[nodiscard]] double strain_energy(const MotionPoint& point);

    /// Takes the start and observes it where asked.
    void start(const MotionPoint& point) {
        report_.time = point.time;
        note(point);
        observe(point, point, 0.0, {});
    }

    /// Takes an accepted step.
    /// @param between  gives the points inside, where they are not those of the cubic.
    /// @param length   s, where the times of the points do not tell it.
    /// @return false where the run ends; the report says why.
    [[nodiscard]] bool step(const MotionPoint& from, const MotionPoint& to,
                            const Between& between = {}, double length = 0.0) {
        const double width = length > 0.0 ? length : to.time - from.time;
        report_.time = to.time;
        ++report_.steps;
        report_.smallest_step = report_.steps == 1 ? width : std::min(report_.smallest_step, width);
        report_.largest_step = std::max(report_.largest_step, width);
        note(to, width);
        observe(from, to, 1e-9 * (to.time - from.time), between);
        return goes_on(to.time);
    }

    /// Observes what lies within the round-off of the end. Stores the last point in the model,
    /// projected on the constraints; where that fails as it is, and the report says so.
    void finish(const MotionPoint& point);

private:
    // Takes what a step left into the report, before any projection: constraints and, where it is
    // followed, energy by an evaluation of its own. So it does where potentials of angles are
    // observed, which count turns from step to step. It inspects at about every 24 evaluations of
    // the forces, or every 12 steps where those are not counted yet.
    // @param width  of the step, s
    void note(const MotionPoint& point, double width = 0.0);
    // Adds what the step gave kinetic and strain energy beyond the work of loads and drives. Loads
    // work by their forces on the coordinates: their power tells nothing of a stiff spring.
    void check_gain(const MotionPoint& point, double width, const Energies& energies);
    // Ends a run in which the rate of a constraint is not finite.
    void check_rates(double time);
    // Ends a run in which an equation that was left out no longer follows from the others.
    void check_left_out(double time);
    // Notes an element that is no beam any more, unless one is noted. It ends a run that may not
    // pass.
    void inspect(const MotionPoint& point);
    [[nodiscard]] bool goes_on(double time) {
        if (report_.status != Status::converged) return false;
        if (!schedule_.progress || schedule_.progress(time, schedule_.end)) return true;
        report_.status = Status::stopped;
        report_.message = "the progress callback asked to stop";
        return false;
    }
    void observe(const MotionPoint& from, const MotionPoint& to, double slack,
                 const Between& between);
    [[nodiscard]] static MotionPoint cubic(const MotionPoint& from, const MotionPoint& to,
                                           double time) {
        const double h = to.time - from.time;
        const double s = (time - from.time) / h;
        const double later = s * s * (3.0 - 2.0 * s);
        const double slope = 6.0 * s * (1.0 - s) / h;
        const double bulge = h * s * (1.0 - s);
        MotionPoint at = from;
        at.time = time;
        for (Eigen::Index k = 0; k < at.q.size(); ++k) {
            at.q[k] = (1.0 - later) * from.q[k] + later * to.q[k] +
                      bulge * ((1.0 - s) * from.v[k] - s * to.v[k]);
            at.v[k] = slope * (to.q[k] - from.q[k]) + (1.0 - s) * (1.0 - 3.0 * s) * from.v[k] +
                      s * (3.0 * s - 2.0) * to.v[k];
        }
        for (Eigen::Index k = 0; k < at.lambda.size(); ++k)
            at.lambda[k] = (1.0 - s) * from.lambda[k] + s * to.lambda[k];
        return at;
    }

    DynamicProblem& problem_;
    const Schedule& schedule_;
    DynamicsReport& report_;
    bool energies_;
    bool solves_multipliers_ = false;
    double most_turn_ = std::numeric_limits<double>::infinity();  // rad, of a step
    double largest_turn_ = 0.0;                                   // rad, likewise
    const char* advice_ = "shorter steps";
    bool doubts_work_ = false;
    double worked_ = 0.0;              // J: of loads and drives, either sign counted as positive
    double strain_ = 0.0;              // energy of the last point, J
    Energies before_;                  // one step ago
    VectorX force_before_, q_before_;  // one step ago, of all coordinates
    double most_held_ = 0.0;           // kinetic and strain energy, J
    double gain_ = 0.0;                // J: beyond the work of loads and drives
    std::chrono::steady_clock::time_point begin_;
    std::size_t next_ = 0;
};

/// Coordinates, rates and accelerations at a time.
struct Knot {
    double time = 0.0;  ///< s
    VectorX q, v, acceleration;
};

/// Interpolates at a time: of k knots the polynomial of degree 3k - 1, and its derivative.
///
/// Newton's form by divided differences, times measured by the distance of the last two knots.
/// @param knots  at least two, of different times.
void interpolate(const List<Knot>& knots, double time, VectorX& q, VectorX& v);

/// Returns the consistent start of a run and reports it; where there is none the report says why.
[[nodiscard]] Start start_run(DynamicProblem& problem, DynamicsReport& report);

/// How a run chooses the widths of its steps.
struct StepControl {
    double first;                    ///< s; or all
    double tolerance = 0.0;          ///< 0: fixed steps
    double least = 0.0, most = 0.0;  ///< s, of adaptive steps

    [[nodiscard]] bool is_adaptive() const noexcept { return tolerance > 0.0; }
    /// @throws InvalidArgument naming the first option that cannot be meant.
    void check(const std::string& options) const {
        require(std::isfinite(tolerance) && tolerance >= 0.0, options,
                ": tolerance must be positive, or 0 for fixed steps, got ", tolerance);
        require_positive(options + ": step", first);
        require_positive(options + ": min_step", least);
        require(most >= least, options, ": max_step must be at least min_step, ", least, ", got ",
                most);
    }
};

/// A step to try, whole or a part of one.
struct Step {
    enum class Ends { within, on_grid, off_grid };  // within: a part, and not the last

    double width, begin, end;  // s
    Ends ends;
    DrivenTurn turn = {};  // of the joint that is driven furthest
};

/// Steps of one width, from one point origin + k width to the next. Another width makes a new grid.
struct StepGrid {
    double origin, width;  // s
    double count = 0.0;    // of steps taken
    double part = 0.0;     // s, of a step that is taken in parts; 0: whole steps
    int parts = 1;         // into which the turn of a joint divides a step

    /// Returns the step to the next point, or to the run's end if that comes first.
    [[nodiscard]] Step next(double now, double end) const;
    /// Halves a step that failed; false below a thousandth of the parts it was divided into.
    [[nodiscard]] bool halve(const Step& step) {
        constexpr double smallest = 1e-3;
        part = 0.5 * step.width;
        return parts * part > smallest * width;
    }
    void take(const Step& step) {
        if (step.ends == Step::Ends::within) return;
        const bool on_grid = step.ends == Step::Ends::on_grid;
        *this = {on_grid ? origin : step.end, width, on_grid ? count + 1.0 : 0.0};
    }
};

/// The error of a step at rest, relative to the tolerance, is below this.
constexpr double resting = 0.03;

/// Returns where in a step from rest a load or a drive that was still begins to act, or where one
/// acts most that is much the same at both ends; else the step's end, s.
/// @param apart  s, between two looks, at least; they are a thousandth of the step apart or more.
[[nodiscard]] double hidden_action(DynamicProblem& problem, const MotionPoint& now, double end,
                                   double apart);

/// Finds where loads and drives jump, for steps to end there and a run to begin anew behind it, and
/// where they have corners, for steps to end there.
///
/// After 100,000 jumps, or a hundred close to others, it takes them for noise and looks no more.
class Jumps {
public:
    Jumps(DynamicProblem& problem, const Schedule& schedule)
        : problem_(problem),
          end_(schedule.end),
          resolution_(8.0 * time_resolution(problem.model().state().time, schedule.end)) {}

    /// Looks from now to the end of a step: at amplitudes, gravity and accelerations of supports,
    /// where asked for, and the scene is whole, also at those of constraints.
    void look(const MotionPoint& now, double end, bool constraints = false);

    /// Returns a time just before the first jump that was found, s; infinity: there is none.
    [[nodiscard]] double next() const noexcept { return before_; }

    /// Tells whether a step from a point may end there.
    [[nodiscard]] bool is_ahead(const MotionPoint& now) const noexcept {
        return before_ - now.time > resolution_;
    }

    /// Tells whether a point has reached it, and with it the end of the run.
    [[nodiscard]] bool ends(const MotionPoint& now) const noexcept {
        return !is_ahead(now) && end_ - before_ <= 2.0 * resolution_;
    }

    /// Takes a point that has reached it, and the run's start, behind it, with accelerations that
    /// belong to the time there. False where the point has not, and at the run's end.
    /// @param first  step of the run, s: a jump within a hundredth of it is close to the last one.
    [[nodiscard]] bool passes(MotionPoint& now, Start& start, double first, DynamicsReport& report);

    /// Returns where a step meets a corner, s; its end where it meets none. Of each amplitude, of
    /// gravity and of each support's acceleration the sharpest counts, of these the first.
    /// @param tolerance  of the step. A second difference over quarters of the step below 30 times
    ///                   it, relative to the function's largest value, is none of a corner.
    [[nodiscard]] double corner(double now, double end, double tolerance);

private:
    static constexpr double never = std::numeric_limits<double>::infinity();
    static constexpr int most_weariness = 100'000;

    DynamicProblem& problem_;
    const double end_, resolution_;          // s
    double before_ = never, after_ = never;  // s: closer to each other than the resolution
    double passed_ = -never;                 // s: behind the last one
    int weariness_ = 0;
    List<double> largest_;  // of each function
};

/// A run, from which those of the integrators derive.
class MotionRun {
protected:
    /// Starts. @throws InvalidArgument as the integrators do.
    /// @param takes_parts  whether the scene can be a part of one.
    MotionRun(DynamicProblem& problem, LinearSolver& solver, const Schedule& schedule,
              const StepControl& control, bool follow_energy, bool takes_parts = false);

    [[nodiscard]] bool has_started() const { return report_.status == Status::converged; }
    [[nodiscard]] MotionPoint start_point() const {
        return {start_.time, start_.q, start_.v, start_.multipliers};
    }
    /// Tells whether the end is further than the round-off of a step; a last point ahead of it or
    /// beyond it by less belongs to the end.
    [[nodiscard]] bool goes_on(const MotionPoint& now) const {
        return schedule_.end - now.time > 1e-9 * std::min(grid_.width, duration_) &&
               !jumps_.ends(now);
    }

    /// Evaluates at a point; the report has the element that failed.
    [[nodiscard]] Status evaluate(const MotionPoint& at, Request request) {
        ++report_.evaluations;
        report_.fault = problem_.evaluate(at.time, at.q, at.v, at.lambda, request);
        return report_.fault ? report_.fault->status : Status::converged;
    }

    /// Returns the next step to try. In an adaptive run it ends no later than at a jump, and at
    /// rest no later than at a hidden_action().
    /// @param corners  whether it also ends at corners; the step behind one has the whole width.
    [[nodiscard]] Step next_step(const MotionPoint& now, bool corners = false);

    /// Moves a point and the run's start behind a jump, if the point stands at one that next_step()
    /// found.
    [[nodiscard]] bool passes_jump(MotionPoint& now);

    /// Divides a fixed step that drives a joint too far; false where it is to be tried as it is.
    /// @param always  whether any turn beyond pi/12 is too far, also one that a step may try.
    [[nodiscard]] bool divides(const Step& step, bool always = false) {
        if (control_.is_adaptive() || grid_.part > 0.0 || (step.turn.fits() && !always))
            return false;
        grid_.parts = parts_for_turns(problem_.model().constraints(), step.begin, step.end);
        grid_.part = step.width / grid_.parts;
        return grid_.parts > 1;
    }

    /// Returns what a local error, relative to the tolerance, counts in a step of a width. Errors
    /// of rates move the scene on, in short steps as in long ones: those that follow a step of five
    /// tolerances are held to less, in proportion to their widths; where shorter steps do not help,
    /// as at a shock, to the tolerance.
    [[nodiscard]] double weigh(double error, double width);

    /// Counts a step that failed, or converged with too large an error, and makes the next one
    /// shorter: by a factor, or in halves where steps are fixed; where a constraint's drive jumps
    /// in it, to end there. False where the run ends.
    [[nodiscard]] bool shortens(const MotionPoint& now, const Step& step, Status status,
                                double factor);

    /// Reports a step that was taken; the last one ends where the schedule does. One that is
    /// shorter than half of the one before, or of the options' step, ends with the multipliers of
    /// its state. False where it ends the run.
    [[nodiscard]] bool record(const MotionPoint& from, MotionPoint& to,
                              const Between& between = {});

    /// Ends the run. @return false.
    bool fail(Status status, std::string message) {
        report_.status = status;
        report_.message = std::move(message);
        const std::string reason = solver_.failure();
        if (!reason.empty()) report_.message += "; " + reason;
        if (report_.fault) report_.message += "; " + problem_.assembly().describe(*report_.fault);
        return false;
    }

    /// Begins the report's memory: the end of the run, numbers of it, what tells its scene.
    /// @param own  numbers after time, origin, count and width, before the scene's size and the
    ///             width that failed.
    void remember(const char* integrator, const MotionPoint& end,
                  std::initializer_list<double> own) {
        report_.memory.integrator = integrator;
        remember("", end);
        VectorX numbers(static_cast<Eigen::Index>(own.size()) + 6);
        const double first[] = {end.time, grid_.origin, grid_.count, grid_.width};
        std::copy(own.begin(), own.end(), std::copy_n(first, 4, numbers.data()));
        numbers.tail<2>() << problem_.length_scale(), failed_width_;
        report_.memory.put("scalars", numbers);
        if (const VectorX& angles = problem_.angle_potentials(); angles.size() > 0)
            report_.memory.put("angles", angles);
        if (grid_.part > 0.0)
            report_.memory.put("parts", Vector<double, 2>(grid_.part, grid_.parts));
        report_.memory.put("signature", signature(problem_, end));
    }
    void remember(const std::string& prefix, const MotionPoint& point) {
        report_.memory.put(prefix + "q", point.q);
        report_.memory.put(prefix + "v", point.v);
        report_.memory.put(prefix + "lambda", point.lambda);
    }

    /// Returns the numbers of a memory and goes on with its grid.
    /// @param who    the integrator, for messages.
    /// @param width  place of the last step's width.
    const VectorX& recall(const char* who, const char* integrator, const Memory& memory,
                          Eigen::Index own, Eigen::Index width = 4);
    [[nodiscard]] MotionPoint recall(const Memory& memory, const std::string& prefix,
                                     double time) const {
        const int n = problem_.size();
        return {time, memory.get(prefix + "q", n), memory.get(prefix + "v", n),
                memory.get(prefix + "lambda", problem_.multipliers())};
    }
    /// Returns the largest coordinate relative to its scale, at least 1: round-off grows with it.
    /// Of positions that is the distance from the origin. Several processes call it together.
    [[nodiscard]] double remoteness(const VectorX& q) const {
        return std::max(1.0, problem_.largest_ratio(q));
    }
    /// Tells whether the rates move a position by a quarter of the scene's size in a step, or a
    /// slope by a quarter of its length: Newton's method may find another solution from there.
    [[nodiscard]] bool moves_far(const MotionPoint& at, double width) const {
        return width * problem_.largest_ratio(at.v) > 0.25;
    }
    /// Has multipliers reported that belong to each state, after a step that resolves the scene.
    /// What a longer step leaves of vibrations is small, but not the forces.
    void solve_multipliers(double width) noexcept {
        recorder_.solve_multipliers(width * highest_frequency_ < 1.0);
    }
    /// Tells whether the run that goes on ended beside the grid, by a step far shorter than the
    /// others. With constraints what its rates changed by is what is left of g and G v, over powers
    /// of the width.
    /// @param numbers  of its memory.  @param width  of its last step, s.
    [[nodiscard]] static bool was_cut(const VectorX& numbers, double width) {
        return numbers[1] == numbers[0] && numbers[2] == 0.0 && 2.0 * width < numbers[3];
    }

    DynamicProblem& problem_;
    LinearSolver& solver_;
    const Schedule& schedule_;
    StepControl control_;
    Jumps jumps_;
    DynamicsReport report_;
    Recorder recorder_;
    Start start_;  // of the run, or behind its last jump
    StepGrid grid_;
    double duration_ = 0.0;      // s, from the start to the schedule's end
    double last_width_ = 0.0;    // s, of the last step, at first that of the options
    double failed_width_ = 0.0;  // s, of a step with far too large an error; fades in later ones
    double tried_width_ = 0.0;   // s, of the last attempt at the next step; 0: there was none
    double tried_error_ = 0.0;   // what its error counted
    int in_vain_ = 0;            // attempts at it that did not help
    bool rests_ = true;          // whether the last step had next to no error
    double acts_at_ = -std::numeric_limits<double>::infinity();  // s, of the last hidden_action()
    double corner_at_ = acts_at_;                                // s, of the last corner
    double uncut_width_ = 0.0;                                   // s, of the step that it cut
    bool has_short_step_ = false;  // whether it ended with the multipliers of its state
    double highest_frequency_ =
        std::numeric_limits<double>::infinity();  // rad/s, at the start; known with multipliers
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/motion_run.ipp>  // IWYU pragma: export
#endif
