// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/complex_solver_for.hpp>
#include <ancf/suitesparse/cholmod.hpp>
#include <ancf/suitesparse/klu.hpp>
#include <ancf/suitesparse/umfpack.hpp>

#include <solver/complex_solver_cases.hpp>
#include <support/catch.hpp>

namespace suitesparse_complex_solver_test {

using namespace ancf;
using namespace ancf::suitesparse;
using namespace ancf::test;

TEST_CASE("KLU and UMFPACK solve complex matrices to round-off", "[suitesparse]") {
    const ComplexSample sample = complex_chain(5, 6, Storage::full, 13);
    const auto klu = complex_solver_for(Klu(), sample.pattern);
    CHECK(klu->name() == "complex klu");
    check_solution(*klu, sample);
    const auto umfpack = complex_solver_for(Umfpack(), sample.pattern);
    CHECK(umfpack->name() == "complex umfpack");
    check_solution(*umfpack, sample);
}

TEST_CASE("complex matrices beside CHOLMOD are solved by the core", "[suitesparse]") {
    const ComplexSample narrow = complex_chain(4, 6, Storage::lower, 17);
    check_solution(*complex_solver_for(Cholmod(), narrow.pattern), narrow);
    const ComplexSample wide = complex_chain(2, 30, Storage::lower, 17);
    check_solution(*complex_solver_for(Cholmod(), wide.pattern), wide);
}

}  // namespace suitesparse_complex_solver_test
