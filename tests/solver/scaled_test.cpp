// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/scaled.hpp>
#include <ancf/solver/scaled.ipp>

#include <solver/linear_solver_cases.hpp>
#include <solver/linear_solver_properties.hpp>
#include <support/catch.hpp>

#include <cmath>
#include <memory>
#include <string_view>

namespace scaled_test {

using namespace ancf;
using namespace ancf::test;

/// Keeps the matrix that it is given; solves with an error of one part in 1000.
class Rough final : public LinearSolver {
public:
    Storage storage() const noexcept override { return Storage::lower; }
    void analyze(const SparseMatrix& matrix) override { solver_.analyze(matrix); }
    FactorReport factorize(const SparseMatrix& matrix) override {
        seen = matrix;
        return solver_.factorize(matrix);
    }
    void solve(const VectorX& b, VectorX& x) const override {
        solver_.solve(b, x);
        x *= 1.001;
    }
    std::string_view name() const noexcept override { return "rough"; }

    SparseMatrix seen;

private:
    EigenLdlt solver_;
};

TEST_CASE("Scaled: the inner solver gets a diagonal between 1 and 4, scaled by powers of two",
          "[solver][scaled]") {
    const SparseMatrix tangent = SampleBeam{8, 1e3, 1e-3}.tangent();
    Scaled solver{Rough()};
    solver.analyze(tangent);
    REQUIRE(solver.factorize(tangent).status == Status::converged);
    const SparseMatrix& given = static_cast<const Rough&>(solver.inner()).seen;
    for (int j = 0; j < tangent.cols(); ++j) {
        int exponent = 0;
        CHECK(std::frexp(solver.scale()[j], &exponent) == 0.5);
        for (SparseMatrix::InnerIterator entry(tangent, j), seen(given, j); entry;
             ++entry, ++seen) {
            CHECK(seen.value() == entry.value() * solver.scale()[j] * solver.scale()[entry.row()]);
            if (entry.row() == j) CHECK((seen.value() >= 1.0 && seen.value() < 4.0));
        }
    }
    CHECK(solver.name() == "scaled rough");
}

TEST_CASE("Scaled: every step of refinement takes off what the inner solver leaves",
          "[solver][scaled]") {
    const SparseMatrix matrix = random_chain({12, 12, 12}, 1);
    const VectorX b = random_vector(36, 1);
    for (int steps = 0; steps <= 3; ++steps) {
        Scaled solver(Rough(), {steps, ResidualPrecision::working});
        solver.analyze(matrix);
        REQUIRE(solver.factorize(matrix).status == Status::converged);
        VectorX x;
        solver.solve(b, x);
        const VectorX rest = b - product(matrix, Storage::lower, x);
        CHECK(rest.norm() / b.norm() * std::pow(1e3, steps + 1) == Approx(1.0).epsilon(0.01));
    }
}

TEST_CASE("Scaled: twice the digits in the residual make a long cantilever exact to a double",
          "[solver][scaled]") {
    // condition number 1e12; the exact solution of the rounded matrix by many steps
    const SampleBeam beam{1000, 1.0, 0.01};
    const SparseMatrix tangent = beam.tangent();
    const auto tip = [&](const ScaledOptions& options) {
        Scaled solver(BlockTridiagonal(), options);
        solver.analyze(tangent);
        REQUIRE(solver.factorize(tangent).status == Status::converged);
        VectorX x;
        solver.solve(beam.tip_load(), x);
        return beam.tip(x);
    };
    const double exact = tip({12, ResidualPrecision::twice});
    CHECK(tip({0, ResidualPrecision::working}) == Approx(exact).epsilon(1e-4));  // measured 6e-6
    CHECK(tip({1, ResidualPrecision::twice}) == Approx(exact).epsilon(1e-8));    // 1e-10
    CHECK(tip({3, ResidualPrecision::twice}) == Approx(exact).epsilon(1e-14));   // 0
}

TEST_CASE("residual: of twice the precision it keeps what cancels", "[solver][scaled]") {
    const SparseMatrix lower = sparse_lower((MatrixX(2, 2) << 1e16, 1.0, 1.0, 1e16).finished());
    const VectorX x = VectorX::Ones(2);
    const VectorX b = VectorX::Constant(2, 1e16);
    for (const Storage storage : {Storage::lower, Storage::full}) {
        const VectorX r = detail::residual<detail::TwiceSum>(stored(lower, storage), storage, x, b);
        CHECK(r == VectorX::Constant(2, -1.0));
    }
}

TEST_CASE("Scaled: saddle points of badly matched units are solved", "[solver][scaled]") {
    const auto scaled_lu = [] { return std::make_unique<Scaled>(EigenLu()); };
    solves_saddle_points(scaled_lu);
    solves_unsymmetric_systems(scaled_lu);
    calls_redundant_constraints_singular(scaled_lu);
}

TEST_CASE("Scaled: negative steps are refused", "[solver][scaled]") {
    CHECK_THROWS_WITH(Scaled(EigenLu(), {-1, ResidualPrecision::working}), ContainsSubstring("-1"));
}

TEST_CASE("Scaled: no solver is refused", "[solver][scaled]") {
    CHECK_THROWS_WITH(Scaled(std::unique_ptr<LinearSolver>()), ContainsSubstring("none"));
}

}  // namespace scaled_test
