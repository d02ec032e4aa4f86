// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/suitesparse/klu.hpp>

#include <solver/linear_solver_cases.hpp>
#include <solver/linear_solver_properties.hpp>
#include <support/catch.hpp>

#include <utility>

namespace klu_test {

using namespace ancf;
using namespace ancf::suitesparse;
using namespace ancf::test;

TEST_CASE("Klu: saddle points are solved", "[suitesparse]") { solves_saddle_points(made<Klu>); }

TEST_CASE("Klu: an unsymmetric matrix is not mistaken for its transpose", "[suitesparse]") {
    solves_unsymmetric_systems(made<Klu>);
}

TEST_CASE("Klu: constraints given twice are singular", "[suitesparse]") {
    calls_redundant_constraints_singular(made<Klu>);
}

TEST_CASE("Klu: a pattern analysed with zeros in it serves any values", "[suitesparse]") {
    serves_any_values_of_a_pattern(made<Klu>);
}

TEST_CASE("Klu: the matrix may change after the factorisation", "[suitesparse]") {
    outlives_its_matrix(made<Klu>);
}

TEST_CASE("Klu: a pattern without a full set of pivots is singular", "[suitesparse]") {
    SparseMatrix matrix = sparse(3, {{0, 0, 1.0}, {1, 0, 1.0}, {2, 0, 1.0}, {1, 1, 2.0}});
    Klu solver;
    solver.analyze(matrix);
    CHECK(solver.factorize(matrix).status == Status::singular);
}

TEST_CASE("Klu: a solver moves, its factorisation with it", "[suitesparse]") {
    const SparseMatrix matrix = stored(random_chain({12, 12}, 1), Storage::full);
    const VectorX b = random_vector(24, 1);
    VectorX expected;
    VectorX x;
    Klu first;
    first.analyze(matrix);
    REQUIRE(first.factorize(matrix).status == Status::converged);
    first.solve(b, expected);
    Klu second;
    second.analyze(matrix);
    REQUIRE(second.factorize(matrix).status == Status::converged);
    second = std::move(first);
    second.solve(b, x);
    CHECK(x == expected);
}

TEST_CASE("Klu: options that cannot be meant are refused", "[suitesparse]") {
    KluOptions options;
    options.pivot_tolerance = 0.0;
    CHECK_THROWS_WITH(Klu(options), ContainsSubstring("pivot_tolerance"));
    options.pivot_tolerance = 1.0;
    options.singular_rcond = 1.0;
    CHECK_THROWS_WITH(Klu(options), ContainsSubstring("singular_rcond"));
}

}  // namespace klu_test
