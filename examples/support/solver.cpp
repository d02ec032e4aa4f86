// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/error.hpp>
#include <ancf/solver/solver_named.hpp>
#if ANCF_WITH_SUITESPARSE
#include <ancf/suitesparse/solver_named.hpp>
#endif

#include <support/solver.hpp>

namespace examples {

namespace {

/// Returns the linear solver that --solver names.
std::unique_ptr<ancf::LinearSolver> linear_solver(const std::string& name) {
    if (name == "eigen") return ancf::solver_named("eigen-lu");
#if ANCF_WITH_SUITESPARSE
    // L D L^T: a tangent on the way to equilibrium need not be positive definite
    return ancf::suitesparse::solver_named(name == "cholmod" ? "cholmod-simplicial" : name);
#else
    ancf::detail::reject("--solver ", name,
                         " needs SuiteSparse, and this program was built without it");
#endif
}

}  // namespace

SolverOptions::SolverOptions() : solver(ANCF_WITH_SUITESPARSE ? "cholmod" : "eigen") {}

void SolverOptions::add_to(CommandLine& line) {
    constexpr int most = 1'000'000;
    line.set_group("Solution");
    line.add_choice("--solver", solver, {"cholmod", "umfpack", "eigen"}, "linear solver");
    line.add_choice("--newton", newton, {"automatic", "plain", "mixed"},
                    "Newton's method: by itself, plain, of mixed integration points");
    line.add_count("--steps", statics.steps, 1, most, "equal load steps");
    line.add_count("--max-iterations", statics.max_iterations, 1, most,
                   "linear solves per load step");
    line.add_flag("--adaptive", statics.adaptive, "halve a load step that fails");
    line.add_flag("--line-search", statics.line_search,
                  "shorten corrections that double the residual");
}

ancf::StaticsReport solve(ancf::Scene& model, const SolverOptions& options) {
    ancf::StaticsOptions statics = options.statics;
    statics.newton = options.newton == "plain"   ? ancf::NewtonKind::plain
                     : options.newton == "mixed" ? ancf::NewtonKind::mixed
                                                 : ancf::NewtonKind::automatic;
    const std::unique_ptr<ancf::LinearSolver> solver = linear_solver(options.solver);
    return ancf::solve_statics(model, *solver, statics);
}

std::unique_ptr<ancf::LinearSolver> general_solver() {
    return linear_solver(ANCF_WITH_SUITESPARSE ? "klu" : "eigen");
}

std::unique_ptr<ancf::LinearSolver> motion_solver() {
#if ANCF_WITH_SUITESPARSE
    return ancf::suitesparse::solver_named("bordered-chain");
#else
    return ancf::solver_named("bordered-chain");
#endif
}

}  // namespace examples
