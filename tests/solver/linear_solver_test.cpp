// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/automatic.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/bordered_chain.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/solver/scaled.hpp>
#include <ancf/solver/solver_named.hpp>

#include <solver/linear_solver_cases.hpp>
#include <solver/linear_solver_properties.hpp>
#include <support/catch.hpp>

#include <Eigen/LU>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace linear_solver_test {

using namespace ancf;
using namespace ancf::test;

/// The example of linear_solver.hpp.
class Dense final : public LinearSolver {
public:
    Storage storage() const noexcept override { return Storage::full; }
    void analyze(const SparseMatrix&) override {}
    FactorReport factorize(const SparseMatrix& matrix) override {
        lu_.compute(MatrixX(matrix));
        const bool good = lu_.rcond() > 1e-15;
        return {good ? Status::converged : Status::singular};
    }
    void solve(const VectorX& b, VectorX& x) const override { x = lu_.solve(b); }
    std::string_view name() const noexcept override { return "dense"; }

private:
    Eigen::PartialPivLU<MatrixX> lu_;
};

TEST_CASE("linear solver: the smallest example solves", "[solver]") {
    Dense solver;
    CHECK(solve_and_check(solver, random_chain({12, 12}, 1), 1e-14).status == Status::converged);
}

template <class Solver>
std::unique_ptr<LinearSolver> scaled() {
    return std::make_unique<Scaled>(Solver());
}

TEST_CASE("linear solver: each one of the core meets the list", "[solver]") {
    const std::vector<MakeSolver> makes = {
        made<BlockTridiagonal>, made<EigenLdlt>,          made<EigenLu>,     made<Automatic>,
        made<BorderedChain>,    scaled<BlockTridiagonal>, scaled<EigenLdlt>, scaled<EigenLu>};
    for (std::size_t k = 0; k < makes.size(); ++k) DYNAMIC_SECTION(k << " " << makes[k]()->name()) {
            check_linear_solver(makes[k]);
        }
}

TEST_CASE("linear solver: one that is moved keeps its factorisation", "[solver]") {
    keeps_its_factorisation_when_moved(BlockTridiagonal(), BlockTridiagonal());
    keeps_its_factorisation_when_moved(EigenLdlt(), EigenLdlt());
    keeps_its_factorisation_when_moved(EigenLu(), EigenLu());
    keeps_its_factorisation_when_moved(Automatic(), Automatic());
    keeps_its_factorisation_when_moved(BorderedChain(), BorderedChain());
    keeps_its_factorisation_when_moved(Scaled(EigenLu()), Scaled(EigenLu()));
}

TEST_CASE("linear solver: L D L^T has as many negative pivots as the matrix has eigenvalues",
          "[solver]") {
    counts_negative_eigenvalues(made<BlockTridiagonal>);
    counts_negative_eigenvalues(made<EigenLdlt>);
    counts_negative_eigenvalues(made<Automatic>);
    counts_negative_eigenvalues(scaled<BlockTridiagonal>);
    counts_negative_eigenvalues(scaled<EigenLdlt>);
}

TEST_CASE(
    "linear solver: the tip of a cantilever of 1000 elements is right to what round-off leaves",
    "[solver]") {
    // 64 n^4 eps = 0.01 bounds what a change of the matrix by one rounding can do
    bends_a_long_cantilever(made<BlockTridiagonal>, 1e-4);  // measured 2e-6
    bends_a_long_cantilever(made<EigenLdlt>, 1e-4);
    bends_a_long_cantilever(made<EigenLu>, 1e-4);
    bends_a_long_cantilever(made<BorderedChain>, 1e-4);
    bends_a_long_cantilever(scaled<BlockTridiagonal>, 1e-5);  // measured 5e-7
}

TEST_CASE("solver_named: every name makes a solver that calls itself so", "[solver]") {
    const SparseMatrix chain = random_chain({12, 12}, 1);
    int made = 0;
    for (const std::string& name : solver_names()) {
        const std::unique_ptr<LinearSolver> solver = solver_named(name);
        if (name != "automatic") CHECK(solver->name() == name);
        CHECK(solve_and_check(*solver, chain, 4e-15).status == Status::converged);
        ++made;
    }
    CHECK(made == 5);
}

TEST_CASE("solver_named: a singular_rcond reaches the solver", "[solver]") {
    const SparseMatrix tangent = SampleBeam{16, 1.0, 0.05}.tangent();  // rcond about 1e-5
    for (const std::string& name : solver_names()) {
        INFO(name);
        CHECK(solve_and_check(*solver_named(name, 0.5), tangent, 0.0).status == Status::singular);
        CHECK_THROWS_WITH(solver_named(name, 1.0), ContainsSubstring("singular_rcond"));
    }
}

TEST_CASE("solver_named: an unknown name is answered by those that there are", "[solver]") {
    CHECK_THROWS_WITH(solver_named("cholmod"),
                      ContainsSubstring("cholmod") && ContainsSubstring("eigen-ldlt, eigen-lu"));
}

}  // namespace linear_solver_test
