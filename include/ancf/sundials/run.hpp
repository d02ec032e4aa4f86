// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the integrators of SUNDIALS share: a scene behind C callbacks, and a run step by step.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/motion_run.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/sundials/context.hpp>
#include <ancf/types.hpp>

#include <exception>
#include <initializer_list>
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
    /// @param names  of its return codes.
    SteppedRun(const char* who, std::string (*names)(int), DynamicProblem& problem,
               const Schedule& schedule, bool follow_energy, DynamicsReport& report);

    /// Throws what a failed call to set SUNDIALS up amounts to.
    void call(int code) const;

    /// Makes a consistent start; false where there is none.
    [[nodiscard]] bool starts();

    /// Returns the frequency of the motion to be followed, rad/s; 0 where nothing moves.
    [[nodiscard]] double slow_frequency();
    /// Returns the velocity that belongs to it, m/s.
    [[nodiscard]] double velocity_scale(double length, double frequency) const;

    /// Returns a least step, s: without one SUNDIALS goes on for ever where time does not advance.
    [[nodiscard]] double least_step() const;

    /// Reports a step of a length, s, to now_; false where it ends the run.
    [[nodiscard]] bool record(double length, const ancf::detail::Between& between);

    /// Ends the run. @return false.
    bool end(Status status, std::string message);
    /// Ends it by a return code, or by the element that the report blames.
    bool fail(int code, Status status, long max_steps);

    DynamicProblem& problem_;
    const Schedule& schedule_;
    Context context_;
    ancf::detail::Recorder recorder_;
    Start start_;
    MotionPoint now_;
    int code_ = 0;  // the last one

private:
    const char* who_;
    std::string (*names_)(int);
    DynamicsReport& outcome_;
};

/// Throws for options that no integrator of SUNDIALS takes.
/// @param scales  name and value of those that are positive, or 0 for automatic.
void check_options(const char* options, double tolerance, long max_steps,
                   std::initializer_list<std::pair<const char*, double>> scales);

}  // namespace ancf::sundials::detail

#if !defined(ANCF_COMPILED)
#include <ancf/sundials/run.ipp>  // IWYU pragma: export
#endif
