// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/automatic.hpp>
#include <ancf/solver/bordered_chain.hpp>
#include <ancf/solver/scaled.hpp>
#include <ancf/suitesparse/cholmod.hpp>
#include <ancf/suitesparse/klu.hpp>
#include <ancf/suitesparse/solver_named.hpp>
#include <ancf/suitesparse/umfpack.hpp>

#include <solver/linear_solver_cases.hpp>
#include <solver/linear_solver_properties.hpp>
#include <support/catch.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace linear_solver_test {

using namespace ancf;
using namespace ancf::suitesparse;
using namespace ancf::test;

/// Makes Cholmod of one mode and order.
template <CholmodMode Mode, CholmodOrdering Ordering = CholmodOrdering::amd>
std::unique_ptr<LinearSolver> cholmod() {
    return std::make_unique<Cholmod>(CholmodOptions{Mode, Ordering});
}
constexpr auto simplicial = cholmod<CholmodMode::simplicial>;
constexpr auto simplicial_natural = cholmod<CholmodMode::simplicial, CholmodOrdering::natural>;
constexpr auto supernodal = cholmod<CholmodMode::supernodal>;
constexpr auto supernodal_natural = cholmod<CholmodMode::supernodal, CholmodOrdering::natural>;
constexpr auto tried = cholmod<CholmodMode::automatic, CholmodOrdering::automatic>;

MakeSolver scaled(const MakeSolver& make) {
    return [make] { return std::make_unique<Scaled>(make()); };
}

std::unique_ptr<LinearSolver> automatic() { return std::make_unique<Automatic>(Cholmod()); }
std::unique_ptr<LinearSolver> bordered() { return std::make_unique<BorderedChain>(Klu()); }

TEST_CASE("linear solver: each one of SuiteSparse meets the list", "[suitesparse]") {
    const std::vector<MakeSolver> makes = {
        made<Cholmod>,     simplicial,           simplicial_natural,
        supernodal,        supernodal_natural,   tried,
        made<Klu>,         made<Umfpack>,        automatic,
        bordered,          scaled(supernodal),   scaled(made<Cholmod>),
        scaled(made<Klu>), scaled(made<Umfpack>)};
    for (std::size_t k = 0; k < makes.size(); ++k) DYNAMIC_SECTION(k << " " << makes[k]()->name()) {
            check_linear_solver(makes[k]);
        }
}

TEST_CASE("linear solver: one of SuiteSparse that is moved keeps its factorisation",
          "[suitesparse]") {
    keeps_its_factorisation_when_moved(Cholmod(), Cholmod());
    keeps_its_factorisation_when_moved(Klu(), Klu());
    keeps_its_factorisation_when_moved(Umfpack(), Umfpack());
    keeps_its_factorisation_when_moved(Scaled(Cholmod()), Scaled(Cholmod()));
}

TEMPLATE_TEST_CASE("linear solver: SuiteSparse's LU takes any matrix and any order of calls",
                   "[suitesparse]", Klu, Umfpack) {
    SECTION("saddle points are solved") { solves_saddle_points(made<TestType>); }
    SECTION("an unsymmetric matrix is not mistaken for its transpose") {
        solves_unsymmetric_systems(made<TestType>);
    }
    SECTION("constraints given twice are singular") {
        calls_redundant_constraints_singular(made<TestType>);
    }
    SECTION("a pattern analysed with zeros in it serves any values") {
        serves_any_values_of_a_pattern(made<TestType>);
    }
    SECTION("the matrix may change after the factorisation") {
        outlives_its_matrix(made<TestType>);
    }
}

TEST_CASE("Cholmod: simplicial, it has as many negative pivots as the matrix has eigenvalues",
          "[suitesparse]") {
    counts_negative_eigenvalues(simplicial);
    counts_negative_eigenvalues(simplicial_natural);
    counts_negative_eigenvalues(scaled(simplicial));
}

TEST_CASE("linear solver: SuiteSparse bends a cantilever of 1000 elements as beam theory does",
          "[suitesparse]") {
    bends_a_long_cantilever(simplicial, 1e-4);
    bends_a_long_cantilever(supernodal, 1e-4);
    bends_a_long_cantilever(made<Klu>, 1e-4);
    bends_a_long_cantilever(made<Umfpack>, 1e-4);
    bends_a_long_cantilever(scaled(made<Cholmod>), 1e-5);
}

TEST_CASE("solver_named: it knows SuiteSparse's solvers and the core's", "[suitesparse]") {
    const SparseMatrix chain = random_chain({12, 12}, 1);
    int made = 0;
    for (const std::string& name : suitesparse::solver_names()) {
        const std::unique_ptr<LinearSolver> solver = suitesparse::solver_named(name);
        INFO(name);
        if (name == "cholmod-simplicial") CHECK(solver->name() == "cholmod");
        CHECK(solve_and_check(*solver, chain, 4e-15).status == Status::converged);
        CHECK_THROWS_WITH(suitesparse::solver_named(name, 1.0),
                          ContainsSubstring("singular_rcond"));
        ++made;
    }
    CHECK(made == 9);
    CHECK(suitesparse::solver_named("klu")->name() == "klu");
    CHECK(suitesparse::solver_named("umfpack")->name() == "umfpack");
    CHECK_THROWS_WITH(suitesparse::solver_named("pardiso"), ContainsSubstring("pardiso") &&
                                                                ContainsSubstring("eigen-lu") &&
                                                                ContainsSubstring("umfpack"));
}

}  // namespace linear_solver_test
