// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/automatic.hpp>
#include <ancf/solver/scaled.hpp>
#include <ancf/suitesparse/cholmod.hpp>
#include <ancf/suitesparse/klu.hpp>
#include <ancf/suitesparse/umfpack.hpp>

#include <solver/linear_solver_cases.hpp>
#include <solver/linear_solver_properties.hpp>
#include <support/catch.hpp>

namespace linear_solver_test {

using namespace ancf;
using namespace ancf::suitesparse;
using namespace ancf::test;

template <CholmodMode Mode, CholmodOrdering Ordering>
struct CholmodAs : Cholmod {
    CholmodAs() : Cholmod({Mode, Ordering}) {}
};
using Simplicial = CholmodAs<CholmodMode::simplicial, CholmodOrdering::amd>;
using SimplicialNatural = CholmodAs<CholmodMode::simplicial, CholmodOrdering::natural>;
using Supernodal = CholmodAs<CholmodMode::supernodal, CholmodOrdering::amd>;
using SupernodalNatural = CholmodAs<CholmodMode::supernodal, CholmodOrdering::natural>;
using Tried = CholmodAs<CholmodMode::automatic, CholmodOrdering::automatic>;

TEMPLATE_TEST_CASE("linear solver: each one of SuiteSparse meets the list", "[suitesparse]",
                   Cholmod, Simplicial, SimplicialNatural, Supernodal, SupernodalNatural, Tried,
                   Klu, Umfpack, Automatic<Cholmod>, Scaled<Cholmod>, Scaled<Supernodal>,
                   Scaled<Klu>, Scaled<Umfpack>) {
    check_linear_solver<TestType>();
}

TEMPLATE_TEST_CASE(
    "Cholmod: simplicial, it has as many negative pivots as the matrix has eigenvalues",
    "[suitesparse]", Simplicial, SimplicialNatural, Scaled<Simplicial>) {
    counts_negative_eigenvalues<TestType>();
}

TEST_CASE("linear solver: SuiteSparse bends a cantilever of 1000 elements as beam theory does",
          "[suitesparse]") {
    bends_a_long_cantilever<Simplicial>(1e-4);
    bends_a_long_cantilever<Supernodal>(1e-4);
    bends_a_long_cantilever<Klu>(1e-4);
    bends_a_long_cantilever<Umfpack>(1e-4);
    bends_a_long_cantilever<Scaled<Cholmod>>(1e-5);
}

}  // namespace linear_solver_test
