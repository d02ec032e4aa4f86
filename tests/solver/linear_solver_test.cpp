// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/automatic.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/solver/scaled.hpp>

#include <solver/linear_solver_cases.hpp>
#include <solver/linear_solver_properties.hpp>
#include <support/catch.hpp>

#include <Eigen/LU>

#include <string_view>

namespace linear_solver_test {

using namespace ancf;
using namespace ancf::test;

/// The example of linear_solver.hpp.
class Dense {
public:
    static constexpr Storage storage = Storage::full;
    void analyze(const SparseMatrix&) {}
    FactorReport factorize(const SparseMatrix& matrix) {
        lu_.compute(MatrixX(matrix));
        const bool good = lu_.rcond() > 1e-15;
        return {good ? Status::converged : Status::singular};
    }
    void solve(const VectorX& b, VectorX& x) const { x = lu_.solve(b); }
    static std::string_view name() { return "dense"; }

private:
    Eigen::PartialPivLU<MatrixX> lu_;
};

struct NoStorage : Dense {
    Storage storage = Storage::full;  // neither static nor constant
};
struct SilentFactorize : Dense {
    void factorize(const SparseMatrix&) {}
};
struct ChangingSolve {
    static constexpr Storage storage = Storage::full;
    void analyze(const SparseMatrix&) {}
    FactorReport factorize(const SparseMatrix&) { return {}; }
    void solve(const VectorX&, VectorX&) {}  // not const
    static std::string_view name() { return "changing"; }
};
struct NumberedName : Dense {
    static int name() { return 3; }
};

TEST_CASE("linear solver: the requirement accepts the smallest example and nothing less",
          "[solver]") {
    STATIC_REQUIRE(is_linear_solver_v<Dense>);
    require_linear_solver<Dense>();
    STATIC_REQUIRE_FALSE(is_linear_solver_v<int>);
    STATIC_REQUIRE_FALSE(is_linear_solver_v<NoStorage>);
    STATIC_REQUIRE_FALSE(is_linear_solver_v<SilentFactorize>);
    STATIC_REQUIRE_FALSE(is_linear_solver_v<ChangingSolve>);
    STATIC_REQUIRE_FALSE(is_linear_solver_v<NumberedName>);
    Dense solver;
    CHECK(solve_and_check(solver, random_chain({12, 12}, 1), 1e-14).status == Status::converged);
}

TEMPLATE_TEST_CASE("linear solver: each one of the core meets the list", "[solver]",
                   BlockTridiagonal, EigenLdlt, EigenLu, Automatic<>, Scaled<BlockTridiagonal>,
                   Scaled<EigenLdlt>, Scaled<EigenLu>) {
    check_linear_solver<TestType>();
}

TEMPLATE_TEST_CASE(
    "linear solver: L D L^T has as many negative pivots as the matrix has eigenvalues", "[solver]",
    BlockTridiagonal, EigenLdlt, Automatic<>, Scaled<BlockTridiagonal>, Scaled<EigenLdlt>) {
    counts_negative_eigenvalues<TestType>();
}

TEST_CASE(
    "linear solver: the tip of a cantilever of 1000 elements is right to what round-off leaves",
    "[solver]") {
    // 64 n^4 eps = 0.01 bounds what a change of the matrix by one rounding can do
    bends_a_long_cantilever<BlockTridiagonal>(1e-4);  // measured 2e-6
    bends_a_long_cantilever<EigenLdlt>(1e-4);
    bends_a_long_cantilever<EigenLu>(1e-4);
    bends_a_long_cantilever<Scaled<BlockTridiagonal>>(1e-5);  // measured 5e-7
}

}  // namespace linear_solver_test
