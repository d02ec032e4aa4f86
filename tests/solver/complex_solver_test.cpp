// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/error.hpp>
#include <ancf/solver/automatic.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/complex_solver_for.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/scaled.hpp>

#include <solver/complex_solver_cases.hpp>
#include <support/catch.hpp>

namespace complex_solver_test {

using namespace ancf;
using namespace ancf::test;

TEST_CASE("complex chains of every width are solved to round-off", "[solver]") {
    int checked = 0;
    for (const int width : {1, 2, 3, 5, 6, 7, 12, 13, 24})
        for (const int blocks : {1, 2, 3, 9}) {
            CAPTURE(width, blocks);
            const ComplexSample sample = complex_chain(blocks, width, Storage::lower, 11);
            const auto solver = complex_solver_for(BlockTridiagonal(), sample.pattern);
            REQUIRE(solver->name() == "complex block-tridiagonal");
            check_solution(*solver, sample);
            ++checked;
        }
    CHECK(checked == 36);
}

TEST_CASE("complex matrices of either storage are solved by Eigen to round-off", "[solver]") {
    const auto check = [](const LinearSolver& real, int width) {
        const ComplexSample sample = complex_chain(5, width, real.storage(), 13);
        const auto solver = complex_solver_for(real, sample.pattern);
        REQUIRE(solver->name() == "complex eigen-lu");
        check_solution(*solver, sample);
    };
    check(EigenLdlt(), BlockTridiagonal::max_block + 1);
    check(EigenLu(), 6);
}

TEST_CASE("a real solver has its complex one, by pattern where it makes none", "[solver]") {
    const ComplexSample lower = complex_chain(4, 6, Storage::lower, 17),
                        full = complex_chain(4, 6, Storage::full, 17);
    const ComplexSample wide = complex_chain(2, 30, Storage::lower, 17);
    CHECK(complex_solver_for(BlockTridiagonal(), lower.pattern)->name() ==
          "complex block-tridiagonal");
    CHECK(complex_solver_for(Automatic(), lower.pattern)->name() == "complex block-tridiagonal");
    CHECK(complex_solver_for(EigenLdlt(), wide.pattern)->name() == "complex eigen-lu");
    CHECK(complex_solver_for(EigenLu(), full.pattern)->name() == "complex eigen-lu");
    CHECK(complex_solver_for(Scaled(EigenLu()), full.pattern)->name() == "complex eigen-lu");
    check_solution(*complex_solver_for(EigenLdlt(), wide.pattern), wide);
    CHECK_THROWS_AS(complex_solver_for(EigenLu(), lower.pattern.block(0, 0, 3, 2)),
                    InvalidArgument);
    const auto chains = complex_solver_for(BlockTridiagonal(), lower.pattern);
    CHECK_THROWS_AS(chains->analyze(wide.pattern), InvalidArgument);
}

}  // namespace complex_solver_test
