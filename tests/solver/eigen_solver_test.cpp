// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/eigen_solver.hpp>

#include <solver/linear_solver_cases.hpp>
#include <solver/linear_solver_properties.hpp>
#include <support/catch.hpp>

#include <limits>

namespace eigen_solver_test {

using namespace ancf;
using namespace ancf::test;

TEST_CASE("EigenLu: saddle points are solved", "[solver][eigen]") {
    solves_saddle_points(made<EigenLu>);
}

TEST_CASE("EigenLu: an unsymmetric matrix is not mistaken for its transpose", "[solver][eigen]") {
    solves_unsymmetric_systems(made<EigenLu>);
}

TEST_CASE("EigenLu: constraints given twice are singular", "[solver][eigen]") {
    calls_redundant_constraints_singular(made<EigenLu>);
}

TEST_CASE("EigenLdlt: on a saddle point it is right or says that it failed", "[solver][eigen]") {
    int solved = 0;
    for (const int coordinates : {1, 2, 6})
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            EigenLdlt solver;
            const SaddlePoint saddle = saddle_point(6, 5, seed, coordinates);
            const FactorReport report = solve_and_check(solver, saddle.lower, 1e-12);
            if (report.status == Status::converged) {
                CHECK(report.negative_pivots == saddle.constraints);
                ++solved;
            } else {
                CHECK(report.failed_column >= saddle.unknowns);
            }
        }
    CHECK(solved >= 10);  // of 30; measured 30

    EigenLdlt solver;  // regular, but no order of elimination has a first pivot
    const SparseMatrix swap = sparse(2, {{1, 0, 1.0}});
    CHECK(solve_and_check(solver, swap, 1e-15).status == Status::singular);
}

TEST_CASE("EigenLdlt: a failure names the column of the matrix, not of its order",
          "[solver][eigen]") {
    for (const int column : {0, 7, 24}) {
        SparseMatrix matrix = grid(5);
        for (int j = 0; j < 25; ++j)
            for (SparseMatrix::InnerIterator entry(matrix, j); entry; ++entry)
                if (j == column || entry.row() == column) entry.valueRef() = 0.0;
        EigenLdlt solver;
        solver.analyze(matrix);
        const FactorReport report = solver.factorize(matrix);
        CHECK(report.status == Status::singular);
        CHECK(report.failed_column == column);
    }
}

TEST_CASE("EigenLdlt, EigenLu: a limit that is no reciprocal condition number is refused",
          "[solver][eigen]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double limit : {-1.0, 1.0, nan}) {
        CHECK_THROWS_WITH(EigenLdlt(limit), ContainsSubstring("singular_rcond"));
        CHECK_THROWS_WITH(EigenLu(limit), ContainsSubstring("singular_rcond"));
    }
}

}  // namespace eigen_solver_test
