// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The options of a motion, its integration by any integrator, and its summary.

#pragma once

#include <ancf/dynamics/report.hpp>
#include <ancf/model/scene.hpp>

#include <support/command_line.hpp>

#include <iosfwd>
#include <string>

namespace examples {

/// How a motion is integrated, from the command line.
struct MotionOptions {
    std::string integrator;   ///< ida-index3 or, without SUNDIALS, generalized-alpha
    double tolerance = 1e-8;  ///< of IDA, Radau and the explicit method
    double step = 1e-4;       ///< s, of the others
    double rho = 0.8;         ///< of generalized-alpha
    double duration;          ///< s
    double interval;          ///< s, of output
    bool pass_degenerate = false;
    std::string save;     ///< file of the last state
    std::string restart;  ///< file of the first state

    MotionOptions(double for_seconds, double output_interval);
    void add_to(CommandLine& line);

    /// Refuses what cannot be integrated, before any work is done; says which options belong to
    /// another integrator.
    /// @throws InvalidArgument naming the value.
    void check(const CommandLine& line) const;

    [[nodiscard]] bool by_ida() const { return integrator.rfind("ida", 0) == 0; }
    [[nodiscard]] bool by_radau() const { return integrator.rfind("radau", 0) == 0; }
    /// Returns whether the integrator is one of explicit methods.
    [[nodiscard]] bool is_explicit() const {
        return integrator == "explicit" || integrator == "leapfrog";
    }

    /// Returns whether the integrator is one of SUNDIALS.
    [[nodiscard]] bool by_sundials() const { return by_ida() || integrator == "explicit"; }
    /// Returns whether the integrator takes a tolerance and no step.
    [[nodiscard]] bool by_tolerance() const { return by_sundials() || by_radau(); }

    /// Returns whether a run is at least as accurate as with the defaults.
    [[nodiscard]] bool as_accurate_as_default() const {
        const MotionOptions own(duration, interval);
        return by_tolerance() ? tolerance <= own.tolerance : step <= own.step;
    }
};

/// Refuses an interval of output of which more than ten million fill the duration.
/// @throws InvalidArgument naming the option and the value.
void require_countable(const std::string& option, double interval, double duration);

/// How a motion went.
struct Motion {
    ancf::DynamicsReport report;
    std::string detail;  ///< what only this integrator has to say

    [[nodiscard]] bool good() const { return report.status == ancf::Status::converged; }
};

/// Integrates a model from its state, or from the state file, and shows the progress on a terminal.
/// @throws InvalidArgument for a state file that does not fit.
[[nodiscard]] Motion integrate(ancf::Scene& model, const MotionOptions& options,
                               ancf::Schedule schedule);

/// Says how a motion went: one line of cost, one of accuracy, and what failed.
void summarise(std::ostream& out, const MotionOptions& options, const Motion& motion);

}  // namespace examples
