// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What every time integrator takes and gives: where to report, whom to tell, how it went.

#pragma once

#include <ancf/assembly/assembly.hpp>
#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/state.hpp>
#include <ancf/types.hpp>

#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace ancf {

/// Energies of a scene and the powers that change them.
///
/// d(kinetic + strain)/dt = load_power + constraint_power, where nothing dissipates in the
/// elements.
struct Energies {
    double kinetic = 0.0;           ///< v^T M v/2, J
    double strain = 0.0;            ///< of all elements, J
    double potential = 0.0;         ///< of gravity and of the loads that have one, J
    double load_power = 0.0;        ///< Q^T v of all loads, gravity included, W
    double constraint_power = 0.0;  ///< of driven supports and of constraints that move in time, W;
                                    ///< with EnergyMomentum by the forces of the step's middle

    /// Returns their sum, J.
    [[nodiscard]] double total() const noexcept { return kinetic + strain + potential; }
};

/// What an observer sees at a time that it asked for.
struct Snapshot {
    const State& state;     ///< all coordinates; on the constraints to round-off
    Energies energies;      ///< of that state
    double violation;       ///< largest |g| of that state
    double violation_rate;  ///< largest |G v + g_t| of that state
};

/// Where a run ends and what is reported on the way.
struct Schedule {
    double end = 0.0;    ///< s, not before the state's time
    List<double> times;  ///< s, ascending, between the state's time and the end

    /// Called at each of the times, in order.
    std::function<void(const Snapshot&)> observe;

    /// Called after every step with its time and the end; returning false stops there.
    std::function<bool(double time, double end)> progress;

    /// Whether a run goes on where an element is no beam any more (docs/limits.md, "Directors"),
    /// such as a slack rope that folds for a moment. If not, it ends with Status::degenerate.
    /// DynamicsReport::left_range tells of it in both cases.
    bool pass_degenerate = false;

    /// @throws InvalidArgument for an end before the start or times that are not ascending between.
    void check(double start) const;
};

/// Returns the schedule of a run with equally spaced outputs, both ends included.
/// @throws InvalidArgument unless duration is at least 0 and the interval is positive, or for more
///         than ten million outputs.
[[nodiscard]] Schedule equal_intervals(double start, double duration, double interval);

/// What an integrator carries beyond the state: enough to continue a run bit for bit.
struct Memory {
    std::string integrator;                        ///< who wrote it; empty: nothing is carried
    List<std::pair<std::string, VectorX>> values;  ///< by name

    /// Tells whether there is nothing to continue.
    [[nodiscard]] bool empty() const noexcept { return integrator.empty(); }

    /// Adds values.
    void put(std::string name, VectorX value) {
        values.emplace_back(std::move(name), std::move(value));
    }

    /// @throws InvalidArgument where it holds no value of that name and size.
    [[nodiscard]] const VectorX& get(const std::string& name, Eigen::Index size) const {
        for (const auto& [key, value] : values)
            if (key == name && value.size() == size) return value;
        detail::reject("Memory of ", integrator, ": expected ", size, " values of ", name);
    }
};

/// What every integrator is: options. An object can be used for many runs.
template <class Options>
class Integrator {
public:
    /// @throws InvalidArgument naming the first option that cannot be meant.
    explicit Integrator(const Options& options = {}) : options_(options) { options_.check(); }

    /// Returns the options it was made with.
    [[nodiscard]] const Options& options() const noexcept { return options_; }

private:
    Options options_;
};

/// How a run went; a run that fails keeps what it reached.
struct DynamicsReport {
    Status status = Status::converged;  ///< how it ended
    std::string message;                ///< what failed where; left_range; that the end is off its
                                        ///< constraints
    std::optional<Fault> fault;         ///< the element that failed, for degenerate and not_finite
    std::string left_range;             ///< the first element that was seen to be no beam, and when
    double time = 0.0;                  ///< s, reached

    long steps = 0;                 ///< accepted
    long rejected = 0;              ///< by the error test
    long convergence_failures = 0;  ///< steps whose Newton iteration failed
    long iterations = 0;            ///< Newton iterations, one linear solve each
    long evaluations = 0;           ///< of the residual force
    long jacobians = 0;             ///< of the tangent
    long factorisations = 0;        ///< numerical ones, of the whole run
    double smallest_step = 0.0;     ///< s
    double largest_step = 0.0;      ///< s

    double violation = 0.0;        ///< largest |g| after any step, before projection
    double violation_rate = 0.0;   ///< largest |G v + g_t| after any step, before projection
    double energy_start = 0.0;     ///< total energy at the start, J
    double energy_drift = 0.0;     ///< largest |total - total at the start| after any step, J
    double kinetic_largest = 0.0;  ///< J: the measure for energy_drift
    double seconds = 0.0;          ///< wall time

    Memory memory;  ///< what the next run needs to continue this one; empty where none can
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/report.ipp>  // IWYU pragma: export
#endif
