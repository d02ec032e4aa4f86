// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/algebra.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/direct_solver.hpp>
#include <ancf/solver/eigen_solver.hpp>

#include <solver/linear_solver_cases.hpp>
#include <support/catch.hpp>
#include <support/dense.hpp>

#include <Eigen/LU>

#include <limits>

namespace conditioning_test {

using namespace ancf;
using namespace ancf::test;

/// Smallest eigenvalue in magnitude of the matrix scaled to a unit diagonal.
double exact_rcond(const SparseMatrix& lower) {
    const MatrixX dense = stored(lower, Storage::full);
    const VectorX scale = dense.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
    const MatrixX scaled = scale.asDiagonal() * dense * scale.asDiagonal();
    return eigenvalues(scaled).cwiseAbs().minCoeff();
}

template <class Solver>
double reported_rcond(const SparseMatrix& lower) {
    Solver solver;
    const SparseMatrix matrix = stored(lower, solver.storage());
    solver.analyze(matrix);
    const FactorReport report = solver.factorize(matrix);
    REQUIRE(report.status == Status::converged);
    return report.rcond;
}

TEMPLATE_TEST_CASE("rcond: on beams it is within a factor of three of the smallest eigenvalue",
                   "[solver][condition]", BlockTridiagonal, EigenLdlt, EigenLu) {
    int checked = 0;
    for (const int elements : {1, 2, 4, 8, 16})
        for (const double height : {0.3, 0.1, 0.01, 0.001}) {
            const SparseMatrix tangent = SampleBeam{elements, 1.0, height}.tangent();
            const double ratio = reported_rcond<TestType>(tangent) / exact_rcond(tangent);
            INFO("elements " << elements << ", height " << height << ", ratio " << ratio);
            CHECK(ratio > 1.0 / 3.0);  // measured 0.59 to 1.45
            CHECK(ratio < 3.0);
            ++checked;
        }
    CHECK(checked == 20);
}

TEMPLATE_TEST_CASE("rcond: it falls with the fourth power of the number of elements",
                   "[solver][condition]", BlockTridiagonal, EigenLdlt, EigenLu) {
    const double coarse = reported_rcond<TestType>(SampleBeam{64, 1.0, 0.1}.tangent());
    const double fine = reported_rcond<TestType>(SampleBeam{512, 1.0, 0.1}.tangent());
    CHECK(std::log(coarse / fine) / std::log(8.0) == Approx(4.0).margin(0.1));
}

TEMPLATE_TEST_CASE("rcond: units do not change it", "[solver][condition]", BlockTridiagonal,
                   EigenLdlt, EigenLu) {
    const SparseMatrix tangent = SampleBeam{16, 1.0, 0.05}.tangent();
    const double expected = reported_rcond<TestType>(tangent);
    VectorX unit(tangent.cols());
    for (Eigen::Index i = 0; i < unit.size(); ++i) unit[i] = std::ldexp(1.0, int(i % 61) - 30);
    const SparseMatrix other = unit.asDiagonal() * tangent * unit.asDiagonal();
    CHECK(reported_rcond<TestType>(other) == Approx(expected).epsilon(1e-6));
}

TEMPLATE_TEST_CASE("rcond: a mechanism is named by an unknown that takes part in it",
                   "[solver][condition]", BlockTridiagonal, EigenLdlt, EigenLu) {
    // two beams that are not connected: the second one is free
    const SparseMatrix held = SampleBeam{4, 1.0, 0.05, 12}.tangent();
    const SparseMatrix free = SampleBeam{4, 1.0, 0.05, 0}.tangent();
    Triplets triplets;
    for (const auto& [matrix, first] : {std::pair(&held, 0), std::pair(&free, 48)})
        for (int j = 0; j < matrix->cols(); ++j)
            for (SparseMatrix::InnerIterator entry(*matrix, j); entry; ++entry)
                triplets.emplace_back(static_cast<int>(entry.row()) + first, j + first,
                                      entry.value());
    TestType solver;
    const SparseMatrix matrix = stored(sparse(48 + 60, triplets), solver.storage());
    solver.analyze(matrix);
    const FactorReport report = solver.factorize(matrix);
    CHECK(report.status == Status::singular);
    CHECK(report.failed_column >= 48);
}

TEST_CASE("symmetric_roots: the root of the diagonal, or what scales a constraint to one",
          "[solver][condition]") {
    Triplets triplets = {{0, 0, 4.0},  {1, 1, -9.0}, {3, 3, 1e-6}, {2, 0, 6.0},
                         {2, 1, 12.0}, {4, 2, 5.0},  {2, 2, 0.0}};
    VectorX expected(6);
    expected << 2.0, 3.0, 4.0, 1e-3, 1.25, 1.0;  // row 2: 12/3, row 4: 5/4; nothing tells of row 5
    VectorX roots;
    const SparseMatrix lower = sparse(6, triplets);
    detail::symmetric_roots(lower, roots);
    CHECK((roots - expected).norm() <= 1e-15);
    detail::symmetric_roots(stored(lower, Storage::full), roots);
    CHECK((roots - expected).norm() <= 1e-15);
}

TEST_CASE("condition: a diagonal of round-off does not make a constrained system singular",
          "[solver][condition]") {
    // two unknowns with stiffness, one that a constraint holds to the second, the constraint
    MatrixX full(4, 4);
    full << 5e7, 0, 160, 0, 0, 1e6, 0, -0.9, 160, 0, 0, 1, 0, -0.9, 1, 0;
    double without = 0.0;
    for (const double diagonal : {0.0, 2.4e-39, -2.4e-39, 2.3e-20}) {
        CAPTURE(diagonal);
        full(2, 2) = diagonal;
        const SparseMatrix matrix = full.sparseView();
        EigenLu solver;
        solver.analyze(matrix);
        const FactorReport report = solver.factorize(matrix);
        CHECK(report.status == Status::converged);
        if (diagonal == 0.0) without = report.rcond;
        CHECK(report.rcond > 0.1 * without);
        VectorX x;
        solver.solve(VectorX(full * VectorX::Ones(4)), x);
        CHECK((x - VectorX::Ones(4)).norm() < 1e-9);
    }
}

TEST_CASE("symmetric_roots: a constraint tells of a diagonal that is round-off",
          "[solver][condition]") {
    // a node, a body that a slider presses with next to nothing, and what ties the two
    for (const double diagonal : {4.8e-31, -1.4e-27, 0.0}) {
        CAPTURE(diagonal);
        const SparseMatrix matrix =
            sparse(3, {{0, 0, 4e6}, {1, 1, diagonal}, {2, 0, 1.0}, {2, 1, -1.0}, {2, 2, 0.0}});
        VectorX roots, expected(3);
        expected << 2e3, 2e3, 5e-4;
        detail::symmetric_roots(matrix, roots);
        CHECK((roots - expected).cwiseQuotient(expected).norm() <= 1e-15);
        const VectorX scales = detail::unit_scales(matrix);
        CHECK(std::abs(std::log2(scales[1] / scales[0])) <= 1.0);
    }
    // a soft spring counts
    const SparseMatrix soft =
        sparse(3, {{0, 0, 4e6}, {1, 1, 0.25}, {2, 0, 1.0}, {2, 1, -1.0}, {2, 2, 0.0}});
    VectorX roots;
    detail::symmetric_roots(soft, roots);
    CHECK(roots[1] == 0.5);
}

TEST_CASE("condition: a diagonal that tells no scale does not make a system singular",
          "[solver][condition]") {
    // an unknown with next to no stiffness, one with some, and what holds them together
    MatrixX full(3, 3);
    full << 1e-20, 0, 1, 0, 1, -1, 1, -1, 0;
    const auto judged = [](const MatrixX& dense, Storage storage) {
        const Eigen::PartialPivLU<MatrixX> lu(dense);
        FactorReport report{Status::converged};
        detail::report_condition(
            stored(dense.sparseView(), storage), storage, default_singular_rcond,
            [&](const VectorX& b, VectorX& x) { x = lu.solve(b); }, report);
        return report;
    };
    for (const Storage storage : {Storage::full, Storage::lower}) {
        const FactorReport regular = judged(full, storage);
        CHECK(regular.status == Status::converged);
        CHECK(regular.rcond > 0.1);  // rho(|A^-1| |A|) is 1
    }
    // what moves without stiffness but for round-off remains singular
    MatrixX loose(2, 2);
    loose << 1, -1, -1, 1 + 4e-16;
    for (const double scale : {1.0, 1e-9}) {
        const MatrixX units = Eigen::DiagonalMatrix<double, 2>(1.0, scale);
        CHECK(judged(units * loose * units, Storage::full).status == Status::singular);
        CHECK(judged(units * loose * units, Storage::lower).status == Status::singular);
    }
}

}  // namespace conditioning_test
