// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The table of hard cases: its rows, and the lists of cases that its sources give.

#pragma once

#include <ancf/constants.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/solver/path.hpp>
#include <ancf/solver/statics.hpp>

#include <chrono>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace hard_cases {

using ancf::pi;

/// One line of the table.
struct Row {
    std::string name;
    std::string element;
    std::string rule;
    int elements = 0;
    double error = 0.0;  ///< relative to length, load, angle or frequency of the reference
    int iterations = 0;
    int steps = 0;
    std::string status;
    double seconds = 0.0;
    double limit = 0.0;  ///< largest error of an answer that may call itself converged
};

/// Returns a row that waits for its results.
[[nodiscard]] inline Row make_row(std::string element, std::string rule, std::string name,
                                  int elements, double limit) {
    Row row;
    row.name = std::move(name);
    row.element = std::move(element);
    row.rule = std::move(rule);
    row.elements = elements;
    row.limit = limit;
    return row;
}

using Rows = std::vector<Row>;

/// A case of one element: runs its meshes.
struct Case {
    std::string name;
    std::function<void(Rows&, bool quick)> run;
    std::string element = {};  ///< of its rows
};

/// Returns cases with the name of their element.
[[nodiscard]] inline std::vector<Case> of_element(const std::string& element,
                                                  std::vector<Case> cases) {
    for (Case& one : cases) one.element = element;
    return cases;
}

/// The cases of each element type; one source each, as instantiations are what compiles slowly.
[[nodiscard]] std::vector<Case> projected_cases();
[[nodiscard]] std::vector<Case> transported_cases();
[[nodiscard]] std::vector<Case> geodesic_cases();
[[nodiscard]] std::vector<Case> quintic_cases();
[[nodiscard]] std::vector<Case> engineering_cases();
[[nodiscard]] std::vector<Case> continuum_cases();
[[nodiscard]] std::vector<Case> cable_cases();
[[nodiscard]] std::vector<Case> planar_cases();
[[nodiscard]] std::vector<Case> planar_motion_cases();
[[nodiscard]] std::vector<Case> motion_cases();
[[nodiscard]] std::vector<Case> frame_cases();

/// Keeps the larger error; a NaN stays.
inline void worsen(double& error, double other) {
    if (!std::isnan(error) && !(other <= error)) error = other;
}

/// Returns seconds since the first call.
[[nodiscard]] inline double now() {
    using Clock = std::chrono::steady_clock;
    static const Clock::time_point start = Clock::now();
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Fills in what a static report tells.
inline void set(Row& row, const ancf::StaticsReport& report) {
    row.iterations = report.iterations();
    row.steps = static_cast<int>(report.steps.size());
    row.status = std::string(to_string(report.status));
}

/// Fills in what the report of a path tells.
inline void set(Row& row, const ancf::PathReport& report) {
    row.iterations = 0;
    for (const ancf::PathPoint& point : report.points) row.iterations += point.iterations;
    row.steps = static_cast<int>(report.points.size());
    // a path that its own callback ends, where it has seen enough, ends at an equilibrium
    const bool ended = report.status == ancf::Status::stopped;
    row.status = std::string(to_string(ended ? ancf::Status::converged : report.status));
}

/// Fills in what the report of a motion tells.
inline void set(Row& row, const ancf::DynamicsReport& report) {
    row.iterations = static_cast<int>(report.iterations);
    row.steps = static_cast<int>(report.steps);
    if (row.status.empty() || report.status != ancf::Status::converged)
        row.status = std::string(to_string(report.status));
}

}  // namespace hard_cases
