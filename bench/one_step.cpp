// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// One call to equilibrium: iterations of scenes on which Newton's method in one load step breaks.
///
///     one_step                         every scene, by every way of correcting
///     one_step --newton automatic      by the default alone
///     one_step --case elastica         the scenes whose names begin so
///     one_step --iterates              strains and pivots of the iterates of one load step
///     one_step --random 400            random cantilevers instead, each against sixty small steps
///     one_step --random 400 --element continuum    the same of continuum beams, or `cable`;
///                                  `rope`: a cable between two pins, under a force at a node or
///                                  per length
///
/// Iterations count rejected steps. `error` is the distance of the loaded end from theory, or from
/// a run in many small steps, over the length; nothing where neither is there.

#include <ancf/model/model.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>

#include <CLI/CLI.hpp>

#include <one_step/scene.hpp>

#include <algorithm>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace ancf::bench::one_step;
using ancf::NewtonKind;

std::vector<Row> all_rows() {
    std::vector<Row> rows = cross_section_rows();
    const std::vector<Row> others = other_rows();
    rows.insert(rows.end(), others.begin(), others.end());
    return rows;
}

ancf::StaticsReport solve(ancf::Model& scene, NewtonKind newton, int steps, bool adaptive) {
    ancf::StaticsOptions options;
    options.newton = newton;
    options.steps = steps;
    options.adaptive = adaptive;
    ancf::EigenLu solver;
    return ancf::solve_statics(scene, solver, options);
}

const std::vector<std::pair<std::string, NewtonKind>>& kinds() {
    static const std::vector<std::pair<std::string, NewtonKind>> all = {
        {"plain", NewtonKind::plain},
        {"mixed", NewtonKind::mixed},
        {"automatic", NewtonKind::automatic}};
    return all;
}

void print(const Row& row, const std::string& newton, const ancf::StaticsReport& report,
           const Problem& problem) {
    std::cout << "| " << row.name << " | " << row.steps << " | " << newton << " | "
              << report.iterations() << " | " << report.steps.size() << " | "
              << to_string(report.status);
    if (report.status != ancf::Status::converged) std::cout << " at " << report.factor;
    std::cout << " | ";
    if (row.has_theory && report.status == ancf::Status::converged)
        std::cout << (problem.scene.position(problem.end) - row.theory).norm() / row.length;
    std::cout << " |" << std::endl;
}

/// Prints where each attempt of a run went, how it ended and how large its corrections were.
void print_attempts(const ancf::StaticsReport& report) {
    for (const ancf::LoadStep& step : report.steps) {
        std::cout << "     " << step.factor << ' ' << to_string(step.status) << ':';
        for (const double correction : step.corrections) std::cout << ' ' << correction;
        std::cout << std::endl;
    }
}

int run_random(int count, unsigned seed, const std::string& element, const std::string& only,
               bool check, bool verbose) {
    int wrong = 0, solved = 0;
    std::vector<std::vector<double>> iterations(kinds().size());
    std::vector<int> elsewhere(kinds().size());
    for (int k = 0; k < count; ++k) {
        std::string name;
        const unsigned own = seed + static_cast<unsigned>(k);
        Problem slow = random_problem(own, element, name);
        bool followed = false;
        if (check)
            followed =
                solve(slow.scene, NewtonKind::plain, 60, true).status == ancf::Status::converged;
        if (check && !followed) {
            std::cout << own << ' ' << name << ": sixty steps fail\n";
            continue;
        }
        ++solved;
        for (std::size_t n = 0; n < kinds().size(); ++n) {
            if (!only.empty() && only != kinds()[n].first) continue;
            Problem p = random_problem(own, element, name);
            const auto report = solve(p.scene, kinds()[n].second, 1, false);
            if (report.status == ancf::Status::converged)
                iterations[n].push_back(report.iterations());
            const double off =
                followed ? (p.scene.state().q - slow.scene.state().q).lpNorm<Eigen::Infinity>()
                         : 0.0;
            const bool other = report.status == ancf::Status::converged && off > 1e-5;
            if (other) ++elsewhere[n];
            const bool failed = report.status != ancf::Status::converged;
            if (verbose || other || (!only.empty() && failed)) {
                std::cout << own << ' ' << kinds()[n].first << ' ' << name << ": "
                          << report.iterations() << " iterations, " << report.steps.size()
                          << " steps, " << to_string(report.status);
                if (report.status != ancf::Status::converged) std::cout << " at " << report.factor;
                if (other) std::cout << ", elsewhere by " << off;
                std::cout << std::endl;
                if (verbose) print_attempts(report);
            }
        }
    }
    for (std::size_t n = 0; n < kinds().size(); ++n) {
        if (!only.empty() && only != kinds()[n].first) continue;
        auto& all = iterations[n];
        std::sort(all.begin(), all.end());
        std::cout << kinds()[n].first << ": " << all.size() << " of " << solved << " converged, "
                  << elsewhere[n] << " elsewhere";
        if (!all.empty())
            std::cout << "; iterations " << all[all.size() / 2] << " in the median, "
                      << all[all.size() * 9 / 10] << " at nine tenths, " << all.back()
                      << " at most";
        std::cout << '\n';
        wrong += elsewhere[n];
    }
    return wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Iterations to equilibrium in one call.");
    std::string newton, name, element;
    int random = 0;
    unsigned seed = 1;
    bool iterates = false, no_check = false, verbose = false, quick = false;
    app.add_option("--newton", newton, "plain, mixed or automatic; none: all");
    app.add_option("--case", name, "beginning of a name");
    app.add_flag("--iterates", iterates, "of one load step");
    app.add_option("--random", random, "number of random cantilevers");
    app.add_option("--element", element, "continuum, cable or rope; none: beams with sections")
        ->check(CLI::IsMember({"continuum", "cable", "rope"}));
    app.add_option("--seed", seed, "of the first of them");
    app.add_flag("--no-check", no_check, "do not compare them with sixty small steps");
    app.add_flag("--verbose", verbose, "print each of them, and the corrections of each attempt");
    app.add_flag("--quick", quick, "a few of all");
    CLI11_PARSE(app, argc, argv);
    if (random > 0) return run_random(random, seed, element, newton, !no_check, verbose);
    if (iterates) {
        print_iterates();
        return 0;
    }
    std::cout << "| scene | steps | newton | iterations | tried | status | error |\n"
                 "|---|---|---|---|---|---|---|\n";
    for (const Row& row : all_rows()) {
        if (row.name.compare(0, name.size(), name) != 0) continue;
        for (const auto& [word, kind] : kinds()) {
            if (!newton.empty() && newton != word) continue;
            Problem problem = row.make();
            const auto report = solve(problem.scene, kind, row.steps, false);
            print(row, word, report, problem);
        }
        if (quick) break;
    }
    return 0;
}
