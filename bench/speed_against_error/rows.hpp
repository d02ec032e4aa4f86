// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the program speed_against_error measures: one row per run.

#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace speed {

/// One run: what was solved and how, what it cost and how far it was off.
struct Row {
    std::string scene;  ///< the column `case`
    std::string element;
    std::string rule;
    std::string solver;  ///< linear solver of a static run, integrator of a motion
    int elements = 0;
    double setting = 0.0;  ///< tolerance, or step in s
    double error = 0.0;    ///< m, or rad; not a number where the run failed
    double cpu_ms = 0.0;   ///< model, assembly and solution, the least of several runs
    int iterations = 0;    ///< linear solves
};

/// How much is run.
struct Plan {
    bool quick = false;              ///< few meshes, one linear solver: a few seconds
    std::vector<std::string> cases;  ///< empty: all

    [[nodiscard]] bool wants(const std::string& scene) const {
        return cases.empty() || std::find(cases.begin(), cases.end(), scene) != cases.end();
    }
};

using Report = std::function<void(const Row&)>;

// Each is one translation unit: all its runs with one or two elements.
void cross_section(const Plan& plan, const Report& report);
void geodesic(const Plan& plan, const Report& report);
void quintic(const Plan& plan, const Report& report);
void pointwise(const Plan& plan, const Report& report);
void continuum(const Plan& plan, const Report& report);
void torsion(const Plan& plan, const Report& report);
void planar(const Plan& plan, const Report& report);
void cable(const Plan& plan, const Report& report);
void pendulums_in_space(const Plan& plan, const Report& report);
void pendulums_in_the_plane(const Plan& plan, const Report& report);
void pendulums_of_cable(const Plan& plan, const Report& report);

/// Returns milliseconds of processor time of one call.
template <class Call>
double cpu_ms(const Call& call) {
    const std::clock_t began = std::clock();
    call();
    return static_cast<double>(std::clock() - began) * (1e3 / CLOCKS_PER_SEC);
}

/// Returns the least milliseconds of a call over runs that fill `enough` ms, at most `most`.
template <class Call>
double least_cpu_ms(const Call& call, double enough, int most) {
    double best = cpu_ms(call);
    double spent = best;
    for (int k = 1; k < most && spent < enough; ++k) {
        const double again = cpu_ms(call);
        spent += again;
        best = std::min(best, again);
    }
    return best;
}

}  // namespace speed
