// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/automatic.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/solver_named.hpp>

#include <solver/linear_solver_cases.hpp>
#include <solver/linear_solver_properties.hpp>
#include <support/catch.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace automatic_test {

using namespace ancf;
using namespace ancf::test;

TEST_CASE("Automatic: a chain goes to the solver for chains, and it says so", "[solver]") {
    Automatic solver;
    CHECK(solver.explanation().empty());
    const SparseMatrix chain = random_chain(std::vector<int>(64, 12), 1);
    CHECK(solve_and_check(solver, chain, 4e-15).status == Status::converged);
    CHECK(solver.is_chain());
    CHECK(solver.name() == "block-tridiagonal");
    CHECK(solver.explanation() == "block-tridiagonal: a chain of 64 blocks of up to 12 unknowns");
}

TEST_CASE("Automatic: a grid goes to the general solver, and it says why", "[solver]") {
    Automatic solver;
    CHECK(solve_and_check(solver, grid(40), 4e-15).status == Status::converged);
    CHECK_FALSE(solver.is_chain());
    CHECK(solver.name() == "eigen-ldlt");
    CHECK_THAT(solver.explanation(), ContainsSubstring("no chain") && ContainsSubstring("40"));

    // and back again
    const SparseMatrix chain = random_chain({12, 12}, 1);
    CHECK(solve_and_check(solver, chain, 4e-15).status == Status::converged);
    CHECK(solver.is_chain());
}

TEST_CASE("Automatic: the general solver may be any one of symmetric matrices", "[solver]") {
    Automatic solver(solver_named("eigen-ldlt"));
    CHECK(solve_and_check(solver, grid(40), 4e-15).status == Status::converged);
    CHECK_THROWS_WITH(Automatic(EigenLu()), ContainsSubstring("eigen-lu"));
    CHECK_THROWS_WITH(Automatic(std::unique_ptr<LinearSolver>()), ContainsSubstring("none"));

    // moved from, it serves chains alone
    Automatic moved(std::move(solver));
    CHECK(solve_and_check(moved, grid(40), 4e-15).status == Status::converged);
    CHECK_THROWS_AS(solver.analyze(grid(40)), InvalidArgument);  // NOLINT
    CHECK(solve_and_check(solver, random_chain({12, 12}, 1), 4e-15).status == Status::converged);
}

}  // namespace automatic_test
