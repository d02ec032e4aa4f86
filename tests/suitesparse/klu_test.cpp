// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/suitesparse/klu.hpp>

#include <solver/linear_solver_cases.hpp>
#include <support/catch.hpp>

namespace klu_test {

using namespace ancf;
using namespace ancf::suitesparse;
using namespace ancf::test;

TEST_CASE("Klu: a pattern without a full set of pivots is singular", "[suitesparse]") {
    SparseMatrix matrix = sparse(3, {{0, 0, 1.0}, {1, 0, 1.0}, {2, 0, 1.0}, {1, 1, 2.0}});
    Klu solver;
    solver.analyze(matrix);
    CHECK(solver.factorize(matrix).status == Status::singular);
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
