// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the integrators of SUNDIALS share: a scene behind C callbacks, and a run step by step.

#pragma once

#include <ancf/dynamics/motion_run.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/error.hpp>
#include <ancf/sundials/context.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <initializer_list>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>

namespace ancf::sundials::detail {

/// A scene that callbacks evaluate, y = (q, v, ...).
///
/// No exception leaves a callback: it is kept and thrown again once SUNDIALS has returned.
class SceneCalls {
public:
    /// The parts of y or of a vector of its size.
    template <class Column>
    [[nodiscard]] auto q(Column&& y) const {
        return y.head(n_);
    }
    template <class Column>
    [[nodiscard]] auto v(Column&& y) const {
        return y.segment(n_, n_);
    }

    /// Throws what a callback of the scene threw.
    void rethrow() {
        if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    }

    /// Returns the element that failed in the last evaluation, if one did.
    [[nodiscard]] const std::optional<Fault>& fault() const noexcept { return fault_; }
    void forget_fault() noexcept { fault_.reset(); }

protected:
    static constexpr int good = 0;
    static constexpr int recoverable = 1;  // a smaller step is tried
    static constexpr int fatal = -1;

    explicit SceneCalls(DynamicProblem& problem)
        : problem_(problem),
          n_(problem.size()),
          request_(problem.model().loads().empty() ? Request::tangent
                                                   : Request::tangent_and_damping) {}

    /// Evaluates at (q_, v_); false where an element failed, which is kept: the attempts that
    /// follow may stay before it.
    [[nodiscard]] bool evaluate(double t, const VectorX& lambda, Request request) {
        const auto fault = problem_.evaluate(t, q_, v_, lambda, request);
        if (fault) fault_ = fault;
        return !fault;
    }

    /// Returns what work returns, or that it threw.
    template <class Work>
    [[nodiscard]] int guarded(const Work& work) noexcept {
        try {
            return work();
        } catch (...) {
            failure_ = std::current_exception();
            return fatal;
        }
    }

    DynamicProblem& problem_;
    const int n_;
    const Request request_;  // of tangents
    VectorX q_, v_;

private:
    std::exception_ptr failure_;
    std::optional<Fault> fault_;
};

/// A run, one step of SUNDIALS after the other.
class SteppedRun {
protected:
    using MotionPoint = ancf::detail::MotionPoint;

    /// @param who    the integrator, for messages.
    /// @param names  of its return codes, to be freed.
    SteppedRun(const char* who, char* (*names)(long), DynamicProblem& problem,
               const Schedule& schedule, bool follow_energy, DynamicsReport& report)
        : problem_(problem),
          schedule_(schedule),
          jumps_(problem, schedule),
          recorder_(problem, schedule, report, follow_energy),
          who_(who),
          names_(names),
          outcome_(report) {}

    /// Throws what a failed call to set SUNDIALS up amounts to.
    void call(int code) const {
        if (code == IDA_SUCCESS) return;
        if (code == IDA_MEM_FAIL) throw std::bad_alloc();
        ancf::detail::reject(who_, ": ", code_name(code), ": ", context_.message());
    }

    /// Returns SUNDIALS's own name of a return code, such as IDA_ERR_FAIL.
    [[nodiscard]] std::string code_name(int code) const {
        const std::unique_ptr<char, decltype(&std::free)> name(names_(code), &std::free);
        return name == nullptr ? std::string() : std::string(name.get());
    }

    /// Makes a consistent start; false where there is none.
    [[nodiscard]] bool starts() {
        start_ = ancf::detail::start_run(problem_, outcome_);
        now_ = {start_.time, start_.q, start_.v, start_.multipliers};
        return outcome_.status == Status::converged;
    }

    /// Returns the frequency of the motion to be followed, rad/s; 0 where nothing moves.
    [[nodiscard]] double slow_frequency() {
        const double motion = problem_.motion_frequency(start_);
        return motion > 0.0 ? motion : problem_.lowest_frequency(start_.time, start_.q);
    }

    /// Returns the velocity that belongs to it, m/s.
    [[nodiscard]] double velocity_scale(double length, double frequency) const {
        double velocity = length * frequency;
        // nothing moves: one length in the run
        if (velocity == 0.0) velocity = length / (schedule_.end - start_.time);
        return std::isfinite(velocity) ? velocity : length;  // else there is no run
    }

    /// Returns a least step, s: without one SUNDIALS goes on for ever where time does not advance.
    [[nodiscard]] double least_step() const {
        const double farthest = std::max(std::abs(start_.time), std::abs(schedule_.end));
        return 100.0 * std::numeric_limits<double>::epsilon() * farthest;
    }

    /// Reports a step of a length, s, to now_; false where it ends the run.
    [[nodiscard]] bool record(double length, const ancf::detail::Between& between) {
        // from its end: outputs close to the end are interpolated too
        return recorder_.step(now_, now_, between, length);
    }

    /// Ends the run. @return false.
    bool end(Status status, std::string message) {
        outcome_.status = status;
        outcome_.message = std::move(message);
        return false;
    }

    /// Ends it by a return code, or by the element that the report blames.
    bool fail(int code, Status status, long max_steps) {
        code_ = code;
        std::string message = ancf::detail::joined({code_name(code), " at ", now_.time, " s"});
        if (code == IDA_TOO_MUCH_WORK)
            message += ancf::detail::joined({": ", max_steps, " steps were taken"});
        if (!context_.message().empty()) message += ": " + context_.message();
        if (outcome_.fault) message += "; " + problem_.assembly().describe(*outcome_.fault);
        return end(outcome_.fault ? outcome_.fault->status : status, std::move(message));
    }

    DynamicProblem& problem_;
    const Schedule& schedule_;
    ancf::detail::Jumps jumps_;
    Context context_;
    ancf::detail::Recorder recorder_;
    Start start_;  // of the run, or behind its last jump
    MotionPoint now_;
    int code_ = 0;  // the last one

private:
    const char* who_;
    char* (*names_)(long);
    DynamicsReport& outcome_;
};

/// Throws for options that no integrator of SUNDIALS takes.
/// @param scales  name and value of those that are positive, or 0 for automatic.
inline void check_options(const char* options, double tolerance, long max_steps,
                          std::initializer_list<std::pair<const char*, double>> scales) {
    ancf::detail::require(tolerance >= 1e-14 && tolerance < 1.0, options,
                          ": tolerance must be from 1e-14 to 1, got ", tolerance);
    for (const auto& [name, value] : scales)
        ancf::detail::require(std::isfinite(value) && value >= 0.0, options, ": ", name,
                              " must be positive, or 0 for automatic, got ", value);
    ancf::detail::require(max_steps >= 0, options,
                          ": max_steps must be positive, or 0 for no limit, got ", max_steps);
}

}  // namespace ancf::sundials::detail
