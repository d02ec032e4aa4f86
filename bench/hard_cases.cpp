// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The hard cases, one table: how far each element comes, in how many iterations, and what it says.
///
///     hard_cases                     all cases, a minute or two
///     hard_cases --case twist_720    one of them
///     hard_cases --csv               comma-separated values
///
/// `locked` are the continuum beams whose mesh is too coarse for the answer: equations solved, and
/// the beam too stiff. The exit status is 1 if a row calls itself converged and is wrong: its error
/// not a number, or above what mesh and measure of strain account for.

#include <CLI/CLI.hpp>

#include <hard_cases/cases.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

using hard_cases::Row;

bool wrong(const Row& row) {
    if (!std::isfinite(row.error)) return true;
    return row.status == "converged" && row.error > row.limit;
}

void print(const Row& row, bool csv) {
    if (csv) {
        std::cout << row.name << ',' << row.element << ',' << row.rule << ',' << row.elements << ','
                  << std::setprecision(6) << row.error << ',' << row.iterations << ',' << row.steps
                  << ',' << row.status << ',' << std::setprecision(3) << row.seconds << std::endl;
        return;
    }
    std::cout << std::left << std::setw(24) << row.name << std::setw(22) << row.element
              << std::setw(8) << row.rule << std::right << std::setw(5) << row.elements
              << std::setw(12) << std::scientific << std::setprecision(2) << row.error
              << std::setw(7) << row.iterations << std::setw(6) << row.steps << "  " << std::left
              << std::setw(16) << row.status << std::right << std::fixed << std::setprecision(3)
              << std::setw(9) << row.seconds << (wrong(row) ? "  WRONG" : "") << '\n'
              << std::defaultfloat;
}

int run(const std::string& chosen, bool csv, bool quick) {
    std::vector<hard_cases::Case> cases;
    for (auto* list :
         {hard_cases::projected_cases, hard_cases::transported_cases, hard_cases::geodesic_cases,
          hard_cases::engineering_cases, hard_cases::continuum_cases, hard_cases::cable_cases,
          hard_cases::planar_cases, hard_cases::planar_motion_cases, hard_cases::motion_cases})
        for (auto& one : list()) cases.push_back(std::move(one));
    if (!chosen.empty() && std::none_of(cases.begin(), cases.end(),
                                        [&](const auto& one) { return one.name == chosen; })) {
        std::cerr << "no case " << chosen << "; there are:";
        for (const auto& one : cases) std::cerr << ' ' << one.name;
        std::cerr << '\n';
        return 2;
    }
    std::cout << (csv ? "case,element,rule,elements,error,iterations,steps,status,seconds\n"
                      : "case                    element               rule       n       error"
                        "  iter. steps  status            seconds\n");
    int bad = 0;
    for (const auto& one : cases) {
        if (!chosen.empty() && one.name != chosen) continue;
        hard_cases::Rows rows;
        one.run(rows, quick);
        for (const Row& row : rows) {
            print(row, csv);
            if (wrong(row)) ++bad;
        }
    }
    if (bad > 0) std::cerr << bad << " rows are wrong\n";
    return bad > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Hard cases of large rotations, slenderness and instability.");
    std::string chosen;
    bool csv = false, quick = false;
    app.add_option("--case", chosen, "one case by its name");
    app.add_flag("--csv", csv, "print comma-separated values");
    app.add_flag("--quick", quick, "fewer and coarser meshes, a few seconds");
    CLI11_PARSE(app, argc, argv);
    return run(chosen, csv, quick);
}
