// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/dynamics/motion_run.hpp>
#include <ancf/list.hpp>

namespace ancf::detail {

ANCF_INLINE void require_motion(const DynamicProblem& problem, const Schedule& schedule,
                                bool takes_parts) {
    require(takes_parts || problem.model().exchange() == nullptr,
            "a part of a scene is moved by GeneralizedAlpha alone, in all processes at once");
    require(problem.can_move(),
            "the scene has no free coordinate: there is no motion to integrate");
    schedule.check(problem.model().state().time);
}

ANCF_INLINE double time_resolution(double start, double end) noexcept {
    return 16.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(start), std::abs(end));
}

ANCF_INLINE void require_resolved(double step, double start, double end) {
    const double least = time_resolution(start, end);
    require(step > least, "a step of ", step, " s is below the resolution of time at ", end, " s, ",
            least, " s");
}

/// Returns the larger number; not a number where one of them is not.
[[nodiscard]] ANCF_INLINE double larger(double a, double b) noexcept { return b <= a ? a : b; }

/// Returns the sum of |a_ii| over the first `count` rows.
[[nodiscard]] ANCF_INLINE double trace_of_magnitudes(const SparseMatrix& matrix, int count) {
    double sum = 0.0;
    for (int j = 0; j < count; ++j)
        for (SparseMatrix::InnerIterator entry(matrix, j); entry; ++entry)
            if (entry.row() == j) sum += std::abs(entry.value());
    return sum;
}

/// Returns the sum of |x_i|, with weights from 1 to 2: it tells places from each other.
[[nodiscard]] ANCF_INLINE double weighted_sum(const VectorX& x) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < x.size(); ++i)
        sum += (1.0 + static_cast<double>(i) / static_cast<double>(x.size())) * std::abs(x[i]);
    return sum;
}

ANCF_INLINE VectorX signature(DynamicProblem& problem, const MotionPoint& point) {
    (void)problem.evaluate(point.time, point.q, point.v, point.lambda, Request::tangent);
    const Energies at = problem.energies();
    VectorX loads, inner;
    problem.numbering().gather_free(problem.assembly().external_force(), loads);
    problem.numbering().gather_free(problem.assembly().internal_force(), inner);
    VectorX values(10);
    values[0] = at.kinetic;
    values[1] = at.strain;
    values[2] = at.potential;
    values[3] = at.load_power;
    const auto sized_sum = [&](const VectorX& x) {
        VectorX sized = x;
        for (Eigen::Index k = 0; k < x.size(); ++k)
            sized[k] *= problem.scales()[k] / problem.length_scale();
        return weighted_sum(sized);
    };
    double sum_of_loads = 0.0;
    for (Eigen::Index k = 0; k < loads.size(); ++k) sum_of_loads += std::abs(loads[k]);
    values[4] = problem.sum_of_parts(sum_of_loads);
    values[5] = problem.sum_of_parts(trace_of_magnitudes(problem.mass(), problem.size()));
    values[6] = problem.sum_of_parts(trace_of_magnitudes(problem.tangent(), problem.size()));
    values[7] = problem.sum_of_parts(sized_sum(problem.force()));
    values[8] = problem.sum_of_parts(sized_sum(loads) + sized_sum(inner));
    values[9] = 0.0;
    if (problem.multipliers() == 0) return values;
    problem.evaluate_constraints(point.time, point.q, point.v);
    values[9] = weighted_sum(problem.constraints().convection());
    return values;
}

ANCF_INLINE void require_continuation(const char* who, const Memory& memory,
                                      DynamicProblem& problem, const MotionPoint& start,
                                      const MotionPoint& point) {
    constexpr double same = 1e-9;
    VectorX q = point.q;
    VectorX v = point.v;
    (void)problem.project(point.time, q, v);
    const double fastest = problem.largest_ratio(v);
    const double moved = problem.largest_ratio(q - start.q);
    const double sped = problem.largest_ratio(v - start.v);
    require(moved <= same && sped <= same * fastest, who,
            ": the model's state is not the one that the memory belongs to");
    const VectorX then = memory.get("signature", 10);
    const VectorX here = signature(problem, point);
    const auto differ = [&](int k) {
        return !(std::abs(here[k] - then[k]) <= same * (std::abs(then[k]) + std::abs(here[k])));
    };
    const double energy = std::abs(then[0]) + std::abs(then[1]) + std::abs(then[2]);
    bool same_scene = !differ(3) && !differ(4);
    for (int k = 0; k < 3; ++k)
        same_scene = same_scene && std::abs(here[k] - then[k]) <= same * energy;
    require(same_scene, who,
            ": the memory is of another scene: kinetic, strain and potential energy, the loads' "
            "power and the sum of their forces are ",
            Components{here.data(), 5}, " here, ", Components{then.data(), 5}, " there");
    require(!differ(5) && !differ(6), who,
            ": the memory is of another scene: mass or stiffness has changed since; a run after "
            "such a change starts without a memory");
    // round-off of forces in balance, and of the accelerations of a turn
    const double turn = problem.multipliers() == 0
                            ? 0.0
                            : fastest * fastest *
                                  weighted_sum(problem.constraints().magnitude(
                                      problem.scales_of(problem.length_scale())));
    require(std::abs(here[7] - then[7]) <= same * (then[8] + here[8]) &&
                std::abs(here[9] - then[9]) <= same * (then[9] + here[9] + turn),
            who,
            ": the memory is of another scene: a constraint, a drive or the place of a load has "
            "changed since; a run after such a change starts without a memory");
}

ANCF_INLINE void Recorder::finish(const MotionPoint& point) {
    if (report_.status == Status::converged)
        observe(point, point, std::max(0.0, schedule_.end - point.time), {});
    inspect(point);
    const auto add = [&](const std::string& text) {
        if (!report_.message.empty() && !text.empty()) report_.message += "; ";
        report_.message += text;
    };
    add(report_.left_range);
    VectorX q = point.q;
    VectorX v = point.v;
    if (!problem_.project(point.time, q, v))
        add("the last state could not be brought onto the constraints");
    VectorX acceleration, lambda = point.lambda;
    if (solves_multipliers_) (void)problem_.accelerations(point.time, q, v, acceleration, lambda);
    if (report_.status == Status::converged && !all_finite(lambda)) {
        report_.status = Status::not_finite;
        add("the multipliers at the end are not finite");
    }
    problem_.store(point.time, q, v, lambda);
    report_.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

ANCF_INLINE void Recorder::inspect(const MotionPoint& point) {
    if (!report_.left_range.empty()) return;
    const Assembly& assembly = problem_.assembly();
    const VectorX q = problem_.raw_state(point.time, point.q, point.v).q;
    const auto fault = schedule_.pass_degenerate ? assembly.inspect(q) : assembly.inspect_parts(q);
    if (!fault) return;
    report_.left_range = joined({assembly.describe(*fault), " at ", point.time, " s"});
    if (schedule_.pass_degenerate || report_.status != Status::converged) return;
    report_.status = fault->status;
    report_.fault = fault;
}

ANCF_INLINE void Recorder::check_rates(double time) {
    const ConstraintSet& constraints = problem_.constraints();
    if (std::isfinite(constraints.largest_rate()) || report_.status != Status::converged) return;
    int worst = 0;
    while (worst + 1 < constraints.size() && std::isfinite(constraints.rate()[worst])) ++worst;
    report_.status = Status::not_finite;
    report_.message = joined(
        {constraints.describe(worst), " moves at a rate that is not finite at ", time, " s"});
}

ANCF_INLINE void Recorder::check_left_out(double time) {
    if (problem_.left_out().empty() || report_.status != Status::converged) return;
    const ConstraintSet& constraints = problem_.constraints();
    const VectorX sizes = constraints.magnitude(problem_.scales_of(problem_.length_scale()));
    double kept = 0.0, largest = 0.0;  // |g|, relative to what the scene's size makes of it
    int worst = -1;
    for (int i = 0; i < constraints.size(); ++i) {
        const double size = std::abs(constraints.violation()[i]) / sizes[i];
        const bool is_out = constraints.left_out(i);
        if (!is_out) kept = std::max(kept, size);
        if (!is_out || !(size > largest)) continue;
        largest = size;
        worst = i;
    }
    if (largest <= 1e-3 || largest <= 10.0 * kept) return;
    report_.status = Status::inconsistent;
    report_.message = joined({constraints.describe(worst),
                              " was left out as redundant and is so no longer: |g| = ",
                              std::abs(constraints.violation()[worst]), " at ", time, " s"});
}

ANCF_INLINE void Recorder::note(const MotionPoint& point, double width) {
    const long in_a_step = std::max(2L, report_.evaluations / std::max(1L, report_.steps));
    if (report_.steps % std::max(1L, 24 / in_a_step) == 0) inspect(point);
    if (problem_.multipliers() > 0) {
        problem_.evaluate_constraints(point.time, point.q, point.v, false);
        const ConstraintSet& constraints = problem_.constraints();
        report_.violation = larger(report_.violation, constraints.largest_violation());
        report_.violation_rate = larger(report_.violation_rate, constraints.largest_rate());
        check_rates(point.time);
        check_left_out(point.time);
    }
    const std::size_t angles =
        schedule_.observe ? problem_.assembly().angle_potentials().size() : 0;
    // of all parts, as they evaluate together
    if (!energies_ && problem_.sum_of_parts(static_cast<double>(angles)) == 0.0) return;
    const Energies energies = problem_.energies(point.time, point.q, point.v, point.lambda);
    ++report_.evaluations;
    if (!energies_) return;
    strain_ = energies.strain;
    if (report_.steps == 0) report_.energy_start = energies.total();
    report_.energy_drift =
        larger(report_.energy_drift, std::abs(energies.total() - report_.energy_start));
    report_.kinetic_largest = larger(report_.kinetic_largest, energies.kinetic);
    check_gain(point, width, energies);
}

ANCF_INLINE double Recorder::strain_energy(const MotionPoint& point) {
    if (energies_) return strain_;
    ++report_.evaluations;
    (void)problem_.evaluate(point.time, point.q, point.v, point.lambda, Request::force);
    return problem_.assembly().strain_energy();
}

ANCF_INLINE void Recorder::check_gain(const MotionPoint& point, double width,
                                      const Energies& energies) {
    if (!std::isfinite(most_turn_) || schedule_.pass_degenerate) return;
    const VectorX force = problem_.assembly().external_force();
    const VectorX q = problem_.raw_state(point.time, point.q, point.v).q;
    const double held = energies.kinetic + energies.strain;
    most_held_ = std::max(most_held_, held);
    if (report_.steps > 0) {
        const double driven = 0.5 * width * (before_.constraint_power + energies.constraint_power);
        VectorX sum = force, moved = q;
        sum += force_before_;
        moved -= q_before_;
        const double work = 0.5 * problem_.sum_of_parts(problem_.own_dot(sum, moved));
        worked_ += std::abs(driven);
        if (!problem_.model().loads().empty()) worked_ += std::abs(work);  // gravity does not jump
        gain_ += held - before_.kinetic - before_.strain - driven - work;
        largest_turn_ = std::max(largest_turn_, width * problem_.largest_ratio(point.v));
    }
    before_ = energies;
    force_before_ = force;
    q_before_ = q;
    if (largest_turn_ <= most_turn_ ||
        !(gain_ > 0.2 * most_held_ + (doubts_work_ ? worked_ : 0.0)) ||
        report_.status != Status::converged)
        return;
    report_.status = Status::diverged;
    report_.message =
        joined({"the scene has gained ", gain_,
                " J that neither loads nor drives gave it, by steps of up to ", largest_turn_,
                " rad, at ", point.time, " s; ", advice_, " may pass"});
}

ANCF_INLINE void Recorder::observe(const MotionPoint& from, const MotionPoint& to, double slack,
                                   const Between& between) {
    for (; next_ < schedule_.times.size() && schedule_.times[next_] <= to.time + slack; ++next_) {
        if (!schedule_.observe) continue;
        const double time = schedule_.times[next_];
        State state;
        if (time >= to.time - slack) {
            schedule_.observe(
                problem_.snapshot(to.time, to.q, to.v, to.lambda, state, solves_multipliers_));
        } else {
            MotionPoint at = between ? between(time) : cubic(from, to, time);
            schedule_.observe(problem_.snapshot(time, std::move(at.q), std::move(at.v),
                                                std::move(at.lambda), state, solves_multipliers_));
        }
    }
}

ANCF_INLINE void interpolate(const List<Knot>& knots, double time, VectorX& q, VectorX& v) {
    constexpr std::size_t derivatives = 3, most = 9;
    const double last = knots.back().time;
    const double width = last - knots[knots.size() - 2].time;
    const std::size_t count = std::min(most, derivatives * knots.size());
    double places[most];
    for (std::size_t k = 0; k < count; ++k)
        places[k] = (knots[k / derivatives].time - last) / width;
    const double x = (time - last) / width;
    q.resize(knots.back().q.size());
    v.resize(q.size());
    for (Eigen::Index i = 0; i < q.size(); ++i) {
        double differences[most];
        for (std::size_t k = 0; k < count; ++k) differences[k] = knots[k / derivatives].q[i];
        for (std::size_t order = 1; order < count; ++order)
            for (std::size_t k = count - 1; k >= order; --k) {
                const Knot& knot = knots[k / derivatives];
                if (k / derivatives != (k - order) / derivatives)
                    differences[k] =
                        (differences[k] - differences[k - 1]) / (places[k] - places[k - order]);
                else if (order == 1)
                    differences[k] = width * knot.v[i];
                else
                    differences[k] = 0.5 * width * width * knot.acceleration[i];
            }
        double value = differences[count - 1], slope = 0.0;
        for (std::size_t k = count - 1; k-- > 0;) {
            slope = slope * (x - places[k]) + value;
            value = value * (x - places[k]) + differences[k];
        }
        q[i] = value;
        v[i] = slope / width;
    }
}

ANCF_INLINE Start start_run(DynamicProblem& problem, DynamicsReport& report) {
    Start start = problem.start();
    ++report.evaluations;
    report.time = start.time;
    report.status = start.status;
    report.message = start.message;
    return start;
}

ANCF_INLINE Step StepGrid::next(double now, double end) const {
    const double point = origin + (count + 1.0) * width;
    const bool on_grid = end >= point - 1e-9 * width;
    const double to = on_grid ? point : end, rest = to - now;
    const double round_off = 0.25 * time_resolution(now, to);
    const auto slack = [&](double h) { return 1e-6 * h + round_off; };
    if (part > 0.0 && rest > part + slack(part)) return {part, now, now + part, Step::Ends::within};
    const double full = part > 0.0 ? part : width;
    const bool is_full = (on_grid || part > 0.0) && std::abs(rest - full) <= slack(full);
    return {is_full ? full : rest, now, to, on_grid ? Step::Ends::on_grid : Step::Ends::off_grid};
}

/// Calls `look` with each function of time alone: amplitudes, gravity, and of supports a member.
ANCF_INLINE void look_at_drives(const Scene& model, Amplitude Support::*member,
                                const std::function<void(const Amplitude&)>& look) {
    for (const ScaledLoad& load : model.loads())
        if (load.amplitude) look(load.amplitude);
    for (const Support& support : model.supports())
        if (support.*member) look(support.*member);
    look([&](double time) { return model.gravity_scale({time, 1.0}); });
}

ANCF_INLINE double hidden_action(DynamicProblem& problem, const MotionPoint& now, double end,
                                 double apart) {
    const double between = std::max(apart, 1e-3 * (end - now.time));
    double found = end;
    const auto look = [&](const Amplitude& function) {
        const double first = function(now.time), last = function(end);
        const double round_off = 1e-12 * std::abs(first);
        const double least = 1e-9 * std::abs(last - first) + round_off;
        double most = 10.0 * std::abs(last - first) + round_off, at = end;
        double still = end;  // up to here it does not change
        for (double time = now.time + between; time < end; time += between) {
            const double change = std::abs(function(time) - first);
            if (still == end && change > least) still = time - between;
            if (!(change > most)) continue;
            most = change;
            at = time;
        }
        if (still - now.time > 0.01 * (end - now.time)) at = std::min(at, still);
        found = std::min(found, at);
    };
    const Exchange* parts = problem.model().exchange();
    together(parts, [&] { look_at_drives(problem.model(), &Support::value, look); });
    if (parts != nullptr) return -parts->largest(-found);
    if (problem.multipliers() > 0)
        look([&](double time) {
            problem.evaluate_constraints(time, now.q, now.v, false);
            return problem.constraints().violation().sum();
        });
    return found;
}

ANCF_INLINE void Jumps::look(const MotionPoint& now, double end, bool constraints) {
    if (weariness_ > most_weariness) return;
    const Scene& model = problem_.model();
    // Halves an interval towards the larger change, which shrinks to about half unless it jumps.
    const auto find = [&](const Amplitude& function, double least, double from, double low,
                          double to, double high) {
        constexpr double share = 0.1;  // of a change, that a jump keeps
        least = std::max(least, share * std::abs(high - low));
        while (std::abs(high - low) > least) {
            if (to - from <= resolution_) {
                before_ = from;
                after_ = to;
                return true;
            }
            const double middle = 0.5 * (from + to), value = function(middle);
            const double change = std::max(std::abs(value - low), std::abs(high - value));
            const bool early = std::abs(value - low) == change;
            least = std::max(least, share * change);
            (early ? to : from) = middle;
            (early ? high : low) = value;
        }
        return false;
    };
    std::size_t k = 0;
    const auto look = [&](const Amplitude& function) {
        constexpr int parts = 4;
        constexpr double matters = 1e-4;  // of the largest value
        if (k == largest_.size()) largest_.push_back(0.0);
        double& largest = largest_[k++];
        const double whole = std::min(end, before_) - now.time;
        if (!(whole > resolution_)) return;
        double from = now.time, low = function(from);
        largest = std::max(largest, std::abs(low));
        for (int part = 1; part <= parts; ++part) {
            const double to = part == parts ? now.time + whole : now.time + part * whole / parts;
            const double high = function(to);
            largest = std::max(largest, std::abs(high));
            if (find(function, matters * largest, from, low, to, high)) {
                while (before_ - from > resolution_ &&
                       find(function, matters * largest, from, low, before_, function(before_))) {
                }
                return;
            }
            from = to;
            low = high;
        }
    };
    const Exchange* parts = model.exchange();
    together(parts, [&] { look_at_drives(model, &Support::acceleration, look); });
    if (parts != nullptr) {
        before_ = -parts->largest(-before_);
        after_ = before_ + resolution_;
        return;
    }
    if (constraints && problem_.multipliers() > 0)
        look([&](double time) {
            problem_.evaluate_constraints(time, now.q, now.v);
            return problem_.constraints().convection().sum();
        });
}

ANCF_INLINE bool Jumps::passes(MotionPoint& now, Start& start, double first,
                               DynamicsReport& report) {
    if (is_ahead(now) || ends(now)) return false;
    Start behind;
    behind.time = std::max(now.time, std::exchange(after_, never));
    before_ = never;
    const bool close = behind.time - std::exchange(passed_, behind.time) < 0.01 * first;
    weariness_ += close ? 1000 : 1;
    behind.q = now.q;
    behind.v = now.v;
    ++report.evaluations;
    const bool whole = problem_.model().exchange() == nullptr;
    if ((whole && !problem_.project(behind.time, behind.q, behind.v)) ||
        problem_.accelerations(behind.time, behind.q, behind.v, behind.acceleration,
                               behind.multipliers) != Status::converged)
        return false;
    start = std::move(behind);
    now = {start.time, start.q, start.v, start.multipliers};
    return true;
}

ANCF_INLINE double Jumps::corner(double now, double end, double tolerance) {
    const double matters = 30.0 * tolerance;
    constexpr int levels = 20, late = 12;
    constexpr double least_growth = 0.1;  // of sharpness after the late level; less where smooth
    constexpr double most_growth = 4.0;   // likewise; more where it is noise
    constexpr double round_off = 100.0 * std::numeric_limits<double>::epsilon();
    double found = end;
    if (weariness_ > most_weariness) return found;
    std::size_t k = 0;
    // Halves an interval towards the largest second difference of three overlapping halves. Over a
    // corner it shrinks with the interval, where the function is smooth with its square.
    const auto look = [&](const Amplitude& function) {
        if (k == largest_.size()) largest_.push_back(0.0);
        double& largest = largest_[k++];
        double from = now, width = found - now, values[5];
        for (int i = 0; i < 5; ++i) {
            values[i] = function(from + 0.25 * i * width);
            largest = std::max(largest, std::abs(values[i]));
        }
        double sharpness = 0.0, before = 0.0;
        for (int level = 0; level < levels; ++level) {
            double most = -1.0;
            int at = 0;
            for (int i = 0; i < 3; ++i) {
                const double difference = values[i] - 2.0 * values[i + 1] + values[i + 2];
                if (!(std::abs(difference) > most)) continue;
                most = std::abs(difference);
                at = i;
            }
            const double of_time = std::abs(end * (values[4] - values[0]) / width);
            const bool tells = most > round_off * (of_time + largest);
            if (!tells && level > late) break;
            sharpness = std::ldexp(most, level);
            if (!(tells && sharpness > matters * largest)) return;
            if (level == late) before = sharpness;
            from += 0.25 * at * width;
            width *= 0.5;
            const double low = values[at], middle = values[at + 1], high = values[at + 2];
            values[0] = low;
            values[1] = function(from + 0.25 * width);
            values[2] = middle;
            values[3] = function(from + 0.75 * width);
            values[4] = high;
        }
        const double time = from + 0.5 * width, whole = end - now;
        const bool inside = 50.0 * (time - now) > whole && 1e3 * (end - time) > whole;
        if (inside && sharpness >= least_growth * before && sharpness <= most_growth * before)
            found = time;
    };
    look_at_drives(problem_.model(), &Support::acceleration, look);
    return found;
}

ANCF_INLINE MotionRun::MotionRun(DynamicProblem& problem, LinearSolver& solver,
                                 const Schedule& schedule, const StepControl& control,
                                 bool follow_energy, bool takes_parts)
    : problem_(problem),
      solver_(solver),
      schedule_(schedule),
      control_(control),
      jumps_(problem, schedule),
      recorder_(problem, schedule, report_, follow_energy),
      grid_{0.0, control.is_adaptive() ? std::min(control.first, control.most) : control.first} {
    require(
        problem.assembly().pattern().storage() == solver.storage(), solver.name(),
        solver.storage() == Storage::lower
            ? " works on the lower half: set ProblemOptions::storage to Storage::lower, or take "
              "a solver of full storage such as EigenLu"
            : " works on full storage: set ProblemOptions::storage to Storage::full");
    require_motion(problem, schedule, takes_parts);
    const double time = problem.model().state().time;
    require_resolved(control.first, time, schedule.end);
    control_.least = std::max(control.least, time_resolution(time, schedule.end));
    start_ = start_run(problem, report_);
    grid_.origin = start_.time;
    duration_ = schedule.end - start_.time;
    last_width_ = grid_.width;
    if (has_started() && problem.multipliers() > 0)
        highest_frequency_ = problem.highest_frequency(start_.time, start_.q);
}

ANCF_INLINE Step MotionRun::next_step(const MotionPoint& now, bool corners) {
    if (now.time == corner_at_ && uncut_width_ > grid_.width) grid_ = {now.time, uncut_width_};
    corner_at_ = -std::numeric_limits<double>::infinity();
    Step step = grid_.next(now.time, schedule_.end);
    const bool looks = std::exchange(rests_, false) || now.time < acts_at_;
    if (control_.is_adaptive()) jumps_.look(now, step.end);
    if (looks && control_.is_adaptive()) {
        const double end = jumps_.is_ahead(now) ? std::min(step.end, jumps_.next()) : step.end;
        const double at = hidden_action(problem_, now, end, control_.first);
        if (at < end) {
            acts_at_ = at;
            failed_width_ = std::max(failed_width_, step.width);
            grid_ = {step.begin, at - step.begin};
            step = grid_.next(now.time, schedule_.end);
            jumps_.look(now, step.end);
        }
    }
    if (jumps_.is_ahead(now) && jumps_.next() < step.end) {
        double width = jumps_.next() - step.begin;
        while (step.begin + width > jumps_.next()) width = std::nextafter(width, 0.0);
        grid_ = {step.begin, width};
        step = grid_.next(now.time, schedule_.end);
    }
    if (corners && control_.is_adaptive()) {
        const double at = jumps_.corner(now.time, step.end, control_.tolerance);
        if (at < step.end) {
            uncut_width_ = step.width;
            grid_ = {step.begin, at - step.begin};
            step = grid_.next(now.time, schedule_.end);
            corner_at_ = step.end;
        }
    }
    step.turn = driven_turn(problem_.model().constraints(), now.time, step.end);
    return step;
}

ANCF_INLINE bool MotionRun::passes_jump(MotionPoint& now) {
    if (!jumps_.passes(now, start_, control_.first, report_)) return false;
    grid_ = {now.time, std::min(control_.first, control_.most)};
    last_width_ = grid_.width;
    failed_width_ = tried_width_ = 0.0;
    in_vain_ = 0;
    rests_ = true;
    return true;
}

ANCF_INLINE double MotionRun::weigh(double error, double width) {
    constexpr double shortest = 0.2;  // of the next attempt, of this one
    constexpr int most_in_vain = 3;
    const double weighed = error * std::max(1.0, failed_width_ / width);
    if (weighed > 5.0) failed_width_ = std::max(failed_width_, width);
    const bool helps =
        tried_width_ == 0.0 || weighed < tried_error_ * std::sqrt(width / tried_width_);
    tried_width_ = width;
    tried_error_ = weighed;
    if (error > 1.0 || weighed <= 1.0) return weighed;
    if (!helps) ++in_vain_;
    if (in_vain_ < most_in_vain && shortest * width > control_.least) return weighed;
    failed_width_ = 0.0;
    return error;
}

ANCF_INLINE bool MotionRun::shortens(const MotionPoint& now, const Step& step, Status status,
                                     double factor) {
    const bool converged = status == Status::converged;
    if (step.turn.fits()) converged ? ++report_.rejected : ++report_.convergence_failures;
    if (control_.is_adaptive()) {
        jumps_.look(now, step.end, true);
        if (jumps_.is_ahead(now) && jumps_.next() < step.end) return true;
        grid_ = {step.begin, step.width * factor};
    }
    if (control_.is_adaptive() ? grid_.width >= control_.least : grid_.halve(step)) return true;
    if (status == Status::not_finite && !report_.fault && problem_.model().exchange() == nullptr)
        report_.fault =
            problem_.assembly().inspect_values(problem_.raw_state(now.time, now.q, now.v).q);
    const std::string turn = step.turn.fits() ? ""
                                              : driven_turn_text(problem_.model().constraints(),
                                                                 step.turn, step.begin, step.end);
    if (control_.is_adaptive())
        return fail(Status::step_too_small,
                    joined({"the step fell below ", control_.least, " s at ", step.begin,
                            " s, last of ", converged ? "the local error" : to_string(status),
                            turn.empty() ? "" : "; ", turn}));
    if (!turn.empty()) return fail(status, turn);
    return fail(status, joined({"Newton's method failed in the step from ", step.begin,
                                " s: ", to_string(status), ", also in parts of ", step.width,
                                " s; ", recorder_.advice(), " may pass"}));
}

ANCF_INLINE bool MotionRun::record(const MotionPoint& from, MotionPoint& to,
                                   const Between& between) {
    if (!goes_on(to)) to.time = schedule_.end;
    failed_width_ *= 0.9;
    tried_width_ = 0.0;
    in_vain_ = 0;
    const double before = std::exchange(last_width_, to.time - from.time);
    // its own, and its rates, carry what Newton's method leaves of g and G v, over powers of the
    // width
    has_short_step_ = problem_.multipliers() > 0 && 2.0 * last_width_ < before &&
                      problem_.model().exchange() == nullptr;
    if (has_short_step_) {
        ++report_.evaluations;
        VectorX q = to.q, v = to.v, acceleration, lambda;
        has_short_step_ =
            problem_.project(to.time, q, v) &&
            problem_.accelerations(to.time, q, v, acceleration, lambda) == Status::converged;
        if (has_short_step_) to.lambda = std::move(lambda);
    }
    solve_multipliers(last_width_);
    return recorder_.step(from, to, between);
}

ANCF_INLINE const VectorX& MotionRun::recall(const char* who, const char* integrator,
                                             const Memory& memory, Eigen::Index own,
                                             Eigen::Index width) {
    require(memory.integrator == integrator, who, ": the memory is that of ", memory.integrator);
    const VectorX& numbers = memory.get("scalars", own + 6);
    const double now = start_.time;
    require(std::abs(numbers[0] - now) <= 1e-12 * std::abs(now) + 1e-9 * numbers[3], who,
            ": the memory is of time ", numbers[0], " s, the model of ", now, " s");
    const bool adaptive = control_.is_adaptive();
    grid_.origin = numbers[0];
    const bool keeps = adaptive || numbers[3] == control_.first;
    if (keeps) grid_ = {numbers[1], numbers[3], numbers[2]};
    if (adaptive && grid_.width > control_.most) grid_ = {numbers[0], control_.most};
    const bool in_parts = keeps && !adaptive && grid_.count > 0.0 && numbers[width] > 0.0;
    last_width_ = in_parts ? numbers[width] : grid_.width;
    failed_width_ = numbers[own + 5];
    solve_multipliers(numbers[width]);
    for (const auto& [name, values] : memory.values) {
        if (name == "angles") problem_.set_angle_potentials(values);
        if (name != "parts" || values.size() != 2 || !keeps || adaptive) continue;
        grid_.part = last_width_ = values[0];
        grid_.parts = static_cast<int>(values[1]);
    }
    return numbers;
}

}  // namespace ancf::detail
