// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// One Newton iteration of a cantilever of many elements: assembly, factorisation, solution.
///
/// Times are the least of several runs; "pattern" is what is done once per topology (numbering,
/// pattern, analysis). The bytes are what a solution holds per element: assembly, matrix and
/// factorisation, by the growth of the resident memory.
///
///     assembly_solve --csv > assembly_solve.csv
///     assembly_solve --elements 100000 --threads 1,2

#include <ancf/assembly/assembly.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>

#include <CLI/CLI.hpp>

#if ANCF_BENCH_LAPACK
#include <lapack_banded.hpp>
#endif
#include <peak.hpp>
#include <solvers.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#if defined(_OPENMP)
#include <omp.h>
#endif
#if defined(__linux__)
#include <malloc.h>
#include <unistd.h>
#endif

namespace {

using namespace ancf;
using bench::detail::now;
using Scene = Model;

struct Settings {
    bool csv = false;
    std::vector<int> elements{100, 1000, 10'000, 100'000, 1'000'000};
    std::vector<std::string> rules{"paper", "mixed"};
    std::vector<std::string> solvers{"block-tridiagonal"};
    std::vector<int> threads{1};
    double seconds = 1.0;  ///< of repeats for each figure
};

/// Least times, ms.
struct Times {
    double pattern = 0.0;
    double assembly = 0.0;
    double factor = 0.0;
    double solve = 0.0;
    double bytes = 0.0;  ///< per element
};

/// Returns the resident memory in bytes, 0 where the system does not tell.
double resident() {
#if defined(__linux__)
    malloc_trim(0);
    std::ifstream file("/proc/self/statm");
    double whole = 0.0, pages = 0.0;
    file >> whole >> pages;
    return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
#else
    return 0.0;
#endif
}

/// Returns milliseconds of one call: the least of at least three and at most a thousand.
template <class Call>
double least(double seconds, const Call& call) {
    double best = 1e9;
    const double begin = now();
    for (int k = 0; k < 3 || (k < 1000 && now() - begin < seconds); ++k) {
        const double start = now();
        call();
        best = std::min(best, now() - start);
    }
    return best * 1e3;
}

/// A cantilever of elements 0.1 m long, bent a little by an uneven state.
void build(Scene& scene, int elements, const Rule& rule) {
    const auto material = Material::isotropic(2e11, 0.3, 7800.0);
    CrossSectionOptions options;
    options.rule = rule;
    const auto beam =
        straight_beam<CrossSectionBeam<3>>(scene, material, rectangle(0.02, 0.02), {0, 0, 0},
                                           {0.1 * elements, 0, 0}, elements, options);
    scene.clamp(beam.first());
    VectorX& q = scene.state().q;
    for (Eigen::Index k = 0; k < q.size(); ++k)
        q[k] += 1e-4 * static_cast<double>((k * 37) % 11 - 5);
}

Times measure(const Settings& settings, int elements, const Rule& rule, LinearSolver& solver) {
    Scene scene;
    build(scene, elements, rule);
    const VectorX rest = VectorX::Zero(scene.state().q.size());
    const double before = resident();
    Times times;
    const double began = now();
    Assembly assembly(scene, solver.storage());
    solver.analyze(assembly.tangent());
    times.pattern = (now() - began) * 1e3;

    const Configuration at{scene.state().q, rest, scene.state().multipliers, {0.0, 1.0}};
    times.assembly = least(settings.seconds, [&] {
        if (assembly.evaluate(at, Request::tangent))
            throw std::runtime_error("the state is not admissible");
    });
    times.factor = least(settings.seconds, [&] {
        if (solver.factorize(assembly.tangent()).status != Status::converged)
            throw std::runtime_error("the tangent has no factors");
    });
    VectorX residual, correction;
    assembly.residual(residual);
    times.solve = least(settings.seconds, [&] { solver.solve(residual, correction); });
    times.bytes = (resident() - before) / elements;
    return times;
}

/// Returns the solver of one of the names of all_solvers().
std::unique_ptr<LinearSolver> solver_of(const std::string& name) {
    constexpr double singular_rcond = 0.0;  // a long cantilever is ill-conditioned
#if ANCF_BENCH_LAPACK
    if (name == "lapack-banded") return std::make_unique<bench::LapackBanded>();
#endif
    return bench::solver_named(name, singular_rcond);
}

std::vector<std::string> all_solvers() {
    return {
        "block-tridiagonal",
#if ANCF_WITH_SUITESPARSE
            "cholmod",
#endif
#if ANCF_BENCH_LAPACK
            "lapack-banded",
#endif
            "eigen-ldlt"
    };
}

void set_threads(int threads) {
#if defined(_OPENMP)
    omp_set_num_threads(threads);
#else
    static_cast<void>(threads);
#endif
}

void report(const Settings& settings) {
    std::puts(
        settings.csv
            ? "elements,rule,lanes,threads,solver,pattern_ms,assembly_ms,factor_ms,solve_ms,"
              "bytes_per_element"
            : "elements  rule   lanes threads  solver              pattern    assembly     factor"
              "      solve (ms)   iteration us/element   bytes/element");
    constexpr int lanes = detail::pack_lanes<CrossSectionBeam<3>>;
    for (const std::string& name : settings.rules) {
        const Rule rule = name == "mixed" ? Rule::mixed() : Rule::paper();
        for (const std::string& solver : settings.solvers)
            for (const int threads : settings.threads)
                for (const int elements : settings.elements) {
                    set_threads(threads);
                    const Times t = measure(settings, elements, rule, *solver_of(solver));
                    if (settings.csv)
                        std::printf("%d,%s,%d,%d,%s,%.4f,%.4f,%.4f,%.4f,%.0f\n", elements,
                                    name.c_str(), lanes, threads, solver.c_str(), t.pattern,
                                    t.assembly, t.factor, t.solve, t.bytes);
                    else
                        std::printf(
                            "%8d  %-6s %5d %7d  %-17s %9.2f %11.3f %10.3f %10.3f %27.3f %15.0f\n",
                            elements, name.c_str(), lanes, threads, solver.c_str(), t.pattern,
                            t.assembly, t.factor, t.solve,
                            (t.assembly + t.factor + t.solve) * 1e3 / elements, t.bytes);
                    std::fflush(stdout);
                }
    }
}

}  // namespace

int main(int argc, char** argv) {
    Settings settings;
    CLI::App app("One Newton iteration of a cantilever of many elements.");
    app.add_flag("--csv", settings.csv, "comma-separated values");
    app.add_option("--elements", settings.elements, "numbers of elements")
        ->delimiter(',')
        ->check(CLI::Range(1, 5'000'000));
    app.add_option("--rules", settings.rules, "paper, mixed")
        ->delimiter(',')
        ->check(CLI::IsMember({"paper", "mixed"}));
    app.add_option("--solvers", settings.solvers, "names of solvers, or all")
        ->delimiter(',')
        ->check(CLI::IsMember(all_solvers()) | CLI::IsMember({"all"}));
    app.add_option("--threads", settings.threads, "numbers of threads of the assembly")
        ->delimiter(',')
        ->check(CLI::Range(1, 256));
    app.add_option("--seconds", settings.seconds, "of repeats for each figure")
        ->check(CLI::PositiveNumber);
    CLI11_PARSE(app, argc, argv);
    if (settings.solvers == std::vector<std::string>{"all"}) settings.solvers = all_solvers();
#if !defined(_OPENMP)
    if (settings.threads != std::vector<int>{1}) {
        std::cerr << "assembly_solve was built without OpenMP: one thread only\n";
        return 2;
    }
#endif
    try {
        report(settings);
    } catch (const std::exception& failure) {
        std::cerr << failure.what() << '\n';
        return 1;
    }
    return 0;
}
