// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The hard cases, one table: how far each element comes, in how many iterations, and what it says.
///
///     hard_cases                       all cases, a minute or two
///     hard_cases --case twist_720      one of them
///     hard_cases --element geodesic    those of one element
///     hard_cases --directors geodesic  those of spatial beams with these directors
///     hard_cases --csv                 comma-separated values
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
#include <set>
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
    std::cout << std::left << std::setw(26) << row.name << std::setw(22) << row.element
              << std::setw(8) << row.rule << std::right << std::setw(5) << row.elements
              << std::setw(12) << std::scientific << std::setprecision(2) << row.error
              << std::setw(7) << row.iterations << std::setw(6) << row.steps << "  " << std::left
              << std::setw(16) << row.status << std::right << std::fixed << std::setprecision(3)
              << std::setw(9) << row.seconds << (wrong(row) ? "  WRONG" : "") << '\n'
              << std::defaultfloat;
}

/// Which cases are wanted; empty: all.
struct Choice {
    std::string name, element, directors;

    [[nodiscard]] bool takes(const hard_cases::Case& one) const {
        return (name.empty() || name == one.name) && (element.empty() || element == one.element) &&
               (directors.empty() || directors == directors_of(one.element));
    }

    /// Returns the directors of a cross-section beam in space, which its name tells.
    [[nodiscard]] static std::string directors_of(const std::string& element) {
        if (element == "cross-section") return "projected";
        if (element == "geodesic-engineering" || element == "quintic") return "geodesic";
        return element;
    }
};

int run(const Choice& choice, bool csv, bool quick) {
    std::vector<hard_cases::Case> cases;
    for (auto* list :
         {hard_cases::projected_cases, hard_cases::transported_cases, hard_cases::geodesic_cases,
          hard_cases::quintic_cases, hard_cases::engineering_cases, hard_cases::continuum_cases,
          hard_cases::cable_cases, hard_cases::planar_cases, hard_cases::planar_motion_cases,
          hard_cases::motion_cases, hard_cases::frame_cases})
        for (auto& one : list()) cases.push_back(std::move(one));
    const auto unwanted = [&](const auto& one) { return !choice.takes(one); };
    if (std::all_of(cases.begin(), cases.end(), unwanted)) {
        std::set<std::string> names, elements;
        for (const auto& one : cases) names.insert(one.name), elements.insert(one.element);
        std::cerr << "no such case; there are:";
        for (const auto& name : names) std::cerr << ' ' << name;
        std::cerr << "\nof the elements:";
        for (const auto& element : elements) std::cerr << ' ' << element;
        std::cerr << '\n';
        return 2;
    }
    std::cout << (csv ? "case,element,rule,elements,error,iterations,steps,status,seconds\n"
                      : "case                      element               rule       n       error"
                        "  iter. steps  status            seconds\n");
    int bad = 0;
    for (const auto& one : cases) {
        if (unwanted(one)) continue;
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
    Choice choice;
    bool csv = false, quick = false;
    app.add_option("--case", choice.name, "one case by its name");
    app.add_option("--element", choice.element, "the cases of one element");
    app.add_option("--directors", choice.directors,
                   "the cases of spatial beams with these directors")
        ->check(CLI::IsMember({"projected", "transported", "geodesic"}));
    app.add_flag("--csv", csv, "print comma-separated values");
    app.add_flag("--quick", quick, "fewer and coarser meshes, a few seconds");
    CLI11_PARSE(app, argc, argv);
    return run(choice, csv, quick);
}
