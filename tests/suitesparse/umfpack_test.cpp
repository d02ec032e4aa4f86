// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/suitesparse/umfpack.hpp>

#include <solver/linear_solver_cases.hpp>
#include <solver/linear_solver_properties.hpp>
#include <support/catch.hpp>

namespace umfpack_test {

using namespace ancf;
using namespace ancf::suitesparse;
using namespace ancf::test;

TEST_CASE("Umfpack: saddle points are solved", "[suitesparse]") {
    solves_saddle_points(made<Umfpack>);
}

TEST_CASE("Umfpack: an unsymmetric matrix is not mistaken for its transpose", "[suitesparse]") {
    solves_unsymmetric_systems(made<Umfpack>);
}

TEST_CASE("Umfpack: constraints given twice are singular", "[suitesparse]") {
    calls_redundant_constraints_singular(made<Umfpack>);
}

TEST_CASE("Umfpack: a pattern analysed with zeros in it serves any values", "[suitesparse]") {
    serves_any_values_of_a_pattern(made<Umfpack>);
}

TEST_CASE("Umfpack: the matrix may change after the factorisation", "[suitesparse]") {
    outlives_its_matrix(made<Umfpack>);
}

TEST_CASE("Umfpack: options that cannot be meant are refused", "[suitesparse]") {
    UmfpackOptions options;
    options.refinement_steps = -1;
    CHECK_THROWS_WITH(Umfpack(options), ContainsSubstring("refinement_steps"));
    options.refinement_steps = 0;
    options.singular_rcond = 1.0;
    CHECK_THROWS_WITH(Umfpack(options), ContainsSubstring("singular_rcond"));
}

}  // namespace umfpack_test
