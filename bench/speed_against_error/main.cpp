// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Processor time against error: every element, rule, linear solver and integrator on Model II, the
/// semicircle, the 45-degree bend, the twist and two pendulums.
///
/// Without --csv it prints, per case, the runs that no other beats in both time and error (the
/// Pareto front), and the cheapest run below each of some errors; a run counts with the largest
/// error of those of its kind that are at least as fine. Errors of the static cases are
/// relative to the length, those of the twist in rad, those of the pendulums in m.
///
///     speed_against_error --csv > speed_against_error.csv
///     speed_against_error --quick       a few seconds; exits with 1 where a case has no good run

#include <CLI/CLI.hpp>

#include <rows.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace {

using speed::Row;

const std::vector<std::string> all_cases = {"model2", "semicircle", "bend45",
                                            "twist",  "pendulum",   "link"};

void print_csv(const Row& row) {
    std::printf("%s,%s,%s,%s,%d,%g,%.4e,%.5g,%d\n", row.scene.c_str(), row.element.c_str(),
                row.rule.c_str(), row.solver.c_str(), row.elements, row.setting, row.error,
                row.cpu_ms, row.iterations);
    std::fflush(stdout);
}

void print_line(const Row& row) {
    std::printf("  %-24s %-9s %-26s %4d elements  %8.1e  error %8.2e  %9.3f ms  %6d solves\n",
                row.element.c_str(), row.rule.c_str(), row.solver.c_str(), row.elements,
                row.setting, row.error, row.cpu_ms, row.iterations);
}

/// Gives each run the largest error of its kind among the runs at least as fine as it in mesh and
/// setting: an error that is small by chance does not count.
std::vector<Row> without_luck(const std::vector<Row>& rows) {
    std::vector<Row> result = rows;
    for (Row& row : result)
        for (const Row& other : rows)
            if (other.element == row.element && other.rule == row.rule &&
                other.solver == row.solver && other.elements >= row.elements &&
                other.setting <= row.setting)
                row.error = std::max(row.error, other.error);
    return result;
}

/// Returns the rows that no other of the same case beats in both time and error, by time.
std::vector<Row> front(std::vector<Row> rows) {
    std::sort(rows.begin(), rows.end(),
              [](const Row& a, const Row& b) { return a.cpu_ms < b.cpu_ms; });
    std::vector<Row> kept;
    for (const Row& row : rows)
        if (kept.empty() || row.error < kept.back().error) kept.push_back(row);
    return kept;
}

void print_summary(const std::map<std::string, std::vector<Row>>& rows) {
    for (const auto& [scene, of_case] : rows) {
        const std::vector<Row> best = front(without_luck(of_case));
        std::printf("\n%s: no other run is faster and more accurate\n", scene.c_str());
        for (const Row& row : best) print_line(row);
        std::puts(" cheapest below an error of");
        for (const double most : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
            for (const Row& row : best)
                if (row.error <= most) {
                    std::printf("  %.0e:", most);
                    print_line(row);
                    break;
                }
    }
}

/// Whether every case was run and has a run that is accurate enough for its few elements.
bool all_good(const speed::Plan& plan, const std::map<std::string, std::vector<Row>>& rows) {
    constexpr double enough = 1e-2;  // the worst case reaches 4e-3
    bool good = true;
    for (const std::string& scene : all_cases) {
        if (!plan.wants(scene) || (plan.quick && scene == "link")) continue;
        const auto found = rows.find(scene);
        if (found == rows.end() || !(front(found->second).back().error < enough)) {
            std::cerr << scene << ": no run has an error below " << enough << '\n';
            good = false;
        }
    }
    return good;
}

}  // namespace

int main(int argc, char** argv) {
    speed::Plan plan;
    bool csv = false;
    CLI::App app("Processor time against error, for every element, rule, solver and integrator.");
    app.add_flag("--csv", csv, "every run as comma-separated values");
    app.add_flag("--quick", plan.quick, "few meshes, one linear solver");
    app.add_option("--cases", plan.cases, "model2, semicircle, bend45, twist, pendulum, link")
        ->delimiter(',')
        ->check(CLI::IsMember(all_cases));
    CLI11_PARSE(app, argc, argv);

    std::map<std::string, std::vector<Row>> rows;
    if (csv)
        std::puts("case,element,rule,solver,elements,step_or_tolerance,error,cpu_ms,iterations");
    const speed::Report report = [&](const Row& row) {
        if (csv) print_csv(row);
        if (row.error == row.error) rows[row.scene].push_back(row);
    };
    try {
        for (const auto run :
             {speed::cross_section, speed::geodesic, speed::quintic, speed::pointwise,
              speed::continuum, speed::torsion, speed::planar, speed::cable,
              speed::pendulums_in_space, speed::pendulums_in_the_plane, speed::pendulums_of_cable})
            run(plan, report);
    } catch (const std::exception& failure) {
        std::cerr << failure.what() << '\n';
        return 1;
    }
    if (!csv) print_summary(rows);
    return all_good(plan, rows) ? 0 : 1;
}
