// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/algebra.hpp>
#include <ancf/dynamics/frequency.hpp>
#include <ancf/dynamics/kkt.hpp>
#include <ancf/solver/redundancy.hpp>

#include <support/catch.hpp>
#include <support/dense.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace kkt_test {

using namespace ancf;
using namespace ancf::detail;

/// Returns [I G^T; G 0] of G = [1 0; 1 delta].
SparseMatrix nearly_dependent(double delta) {
    MatrixX dense(4, 4);
    dense << 1, 0, 1, 1, 0, 1, 0, delta, 1, 0, 0, 0, 1, delta, 0, 0;
    SparseMatrix matrix = dense.sparseView();
    for (int k = 2; k < 4; ++k) matrix.coeffRef(k, k) = 0.0;
    matrix.makeCompressed();
    return matrix;
}

/// Returns a symmetric sparse matrix, with some zeros stored, and its lower half.
SparseMatrix symmetric(int size, test::Random& random) {
    MatrixX dense = MatrixX::Zero(size, size);
    for (int i = 0; i < size; ++i)
        for (int j = 0; j <= i; ++j)
            if ((i + j) % 3 != 1) dense(i, j) = dense(j, i) = random.vector<1>()[0];
    SparseMatrix matrix = dense.sparseView();
    matrix.makeCompressed();
    return matrix;
}

TEST_CASE("KktSystem: rows that nearly depend on each other are solved for or refused",
          "[dynamics][kkt]") {
    for (const double delta : {1.0, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
        const SparseMatrix matrix = nearly_dependent(delta);
        KktSystem system;
        system.analyze(matrix, 2);
        REQUIRE(system.factorize(matrix) == Status::converged);
        const VectorX exact = (VectorX(4) << 1.0, 1.0, 0.5, 0.25).finished();
        VectorX x;
        INFO("delta " << delta);
        REQUIRE(system.solve(matrix * exact, x) == Status::converged);
        CHECK((x - exact).norm() <= 1e-11 / (delta * delta));  // its condition
        CHECK(std::abs(x[0] + delta * x[1] - 1.0 - delta) <= 1e-10);
    }
    const SparseMatrix matrix = nearly_dependent(1e-8);
    KktSystem system;
    system.analyze(matrix, 2);
    REQUIRE(system.factorize(matrix) == Status::converged);
    VectorX x;
    const VectorX b = (VectorX(4) << 0.0, 0.0, 1.0, 2.0).finished();  // x_1 = 1e8
    CHECK(system.solve(b, x) == Status::singular);
}

TEST_CASE("KktSystem: few equations and many are solved for while they change", "[dynamics][kkt]") {
    test::Random random(29);
    constexpr int size = 40;
    for (const int equations : {1, 5, 12, 13, 30}) {
        CAPTURE(equations);
        const int all = size + equations;
        MatrixX dense = MatrixX::Zero(all, all);
        for (int i = 0; i < size; ++i)
            for (int j = std::max(0, i - 4); j <= i; ++j)
                dense(i, j) = dense(j, i) = random.vector<1>()[0] + (i == j ? 10.0 : 0.0);
        KktSystem system;
        for (int change = 0; change < 8; ++change) {
            CAPTURE(change);
            // equation 3 is left out; in the end equation 1 is nearly equation 0
            for (int e = 0; e < equations; ++e)
                for (int k = 0; k < 5; ++k)
                    dense(size + e, (7 * e + 11 * k) % size) = e == 3 ? 0.0 : random.vector<1>()[0];
            if (equations > 3) dense(size + 3, size + 3) = 1.0;
            if (equations > 1 && change == 6) {
                dense.row(size + 1) = dense.row(size);
                dense(size + 1, 0) += 1e-5;
            }
            dense.topRightCorner(size, equations) =
                dense.bottomLeftCorner(equations, size).transpose();
            SparseMatrix matrix(all, all);
            for (int j = 0; j < all; ++j)
                for (int i = 0; i < all; ++i)
                    if (i == j || i < size || j < size) matrix.insert(i, j) = dense(i, j);
            matrix.makeCompressed();
            if (change == 0) system.analyze(matrix, size);
            REQUIRE(system.factorize(matrix) == Status::converged);
            VectorX exact(all), x;
            for (double& entry : exact) entry = random.vector<1>()[0];
            const VectorX b = dense * exact;
            REQUIRE(system.solve(b, x) == Status::converged);
            CHECK((dense * x - b).norm() <= 1e-13 * b.norm());  // measured 2e-15
            if (change != 6) CHECK((x - exact).norm() <= 1e-10 * exact.norm());
        }
    }
}

TEST_CASE("KktSystem: zeros that it leaves out count from when they are zero no more",
          "[dynamics][kkt]") {
    constexpr int nodes = 9, size = 3 * nodes;
    std::vector<int> blocks;
    for (int row = 0; row < size; ++row) blocks.push_back(row / 3);
    MatrixX dense = MatrixX::Zero(size, size);  // a chain, its directions apart at first
    for (int i = 0; i < size; ++i) {
        dense(i, i) = 4.0;
        if (i >= 3) dense(i, i - 3) = dense(i - 3, i) = 1.0 + 0.1 * i;
    }
    KktSystem system;
    for (int change = 0; change < 4; ++change) {
        CAPTURE(change);
        if (change == 2) dense(1, 0) = dense(0, 1) = 0.5;
        if (change == 3) dense(26, 22) = dense(22, 26) = -0.5;
        SparseMatrix matrix(size, size);
        for (int j = 0; j < size; ++j)
            for (int i = 0; i < size; ++i)
                if (std::abs(i / 3 - j / 3) <= 1) matrix.insert(i, j) = dense(i, j);
        matrix.makeCompressed();
        if (change == 0) system.analyze(matrix, size, blocks);
        REQUIRE(system.factorize(matrix) == Status::converged);
        const VectorX exact = VectorX::LinSpaced(size, -1.0, 2.0), b = dense * exact;
        VectorX x;
        REQUIRE(system.solve(b, x) == Status::converged);
        CHECK((dense * x - b).norm() <= 1e-13 * b.norm());  // measured 3e-16
    }
}

TEST_CASE("KktSystem: what is not finite is refused, and a lower half is enough",
          "[dynamics][kkt]") {
    SparseMatrix matrix = nearly_dependent(1.0);
    const SparseMatrix lower = matrix.triangularView<Eigen::Lower>();
    KktSystem of_all, of_half;
    of_all.analyze(matrix, 2);
    of_half.analyze(lower, 2);
    REQUIRE(of_all.factorize(matrix) == Status::converged);
    REQUIRE(of_half.factorize(lower) == Status::converged);
    const VectorX b = (VectorX(4) << 1.0, -2.0, 3.0, 0.5).finished();
    VectorX x, y;
    REQUIRE(of_all.solve(b, x) == Status::converged);
    REQUIRE(of_half.solve(b, y) == Status::converged);
    CHECK((matrix * x - b).norm() <= 1e-14 * b.norm());
    CHECK((x - y).norm() == 0.0);
    matrix.coeffRef(0, 0) = std::numeric_limits<double>::quiet_NaN();
    CHECK(of_all.factorize(matrix) == Status::not_finite);
}

TEST_CASE("KktSystem: what is next to nothing is solved for", "[dynamics][kkt]") {
    const SparseMatrix matrix = nearly_dependent(1e-2);
    KktSystem system;
    system.analyze(matrix, 2);
    REQUIRE(system.factorize(matrix) == Status::converged);
    for (const double tiny : {0.0, 4.9e-324, 1e-322, 1e-310, 1e-300, 1e-250}) {
        INFO("size " << tiny);
        const VectorX b = (VectorX(4) << 0.0, 0.0, -tiny, tiny).finished();
        VectorX x;
        CHECK(system.solve(b, x) == Status::converged);
        CHECK(x.head(2).cwiseAbs().maxCoeff() <= 1e5 * tiny);  // x = (-1, 200) tiny
    }
}

TEST_CASE("KktSystem: a load that the constraints take whole is solved for", "[dynamics][kkt]") {
    // the first part of the solution is zero: what is computed of it is round-off alone
    test::Random random(3);
    for (int trial = 0; trial < 200; ++trial) {
        INFO("trial " << trial);
        const Vector<double, 3> v = random.vector<3>();
        MatrixX dense = MatrixX::Zero(6, 6);
        dense.topLeftCorner(3, 3) = v * v.transpose() + Matrix<double, 3>::Identity();
        dense.bottomLeftCorner(3, 3) = dense.topRightCorner(3, 3) = Matrix<double, 3>::Identity();
        SparseMatrix matrix = dense.sparseView();
        for (int k = 3; k < 6; ++k) matrix.coeffRef(k, k) = 0.0;
        matrix.makeCompressed();
        KktSystem system;
        system.analyze(matrix, 3);
        REQUIRE(system.factorize(matrix) == Status::converged);
        VectorX x, b = VectorX::Zero(6);
        b.head(3) = random.vector<3>();
        CHECK(system.solve(b, x) == Status::converged);
        CHECK(x.head(3).norm() <= 1e-15);  // measured 1e-16 or less
        CHECK((x.tail(3) - b.head(3)).norm() <= 1e-15);
    }
}

TEST_CASE("KktSystem: a pattern without its diagonal is refused", "[dynamics][kkt]") {
    SparseMatrix matrix = nearly_dependent(1.0);
    matrix.prune([](int row, int column, double) { return row != 3 || column != 3; });
    KktSystem system;
    CHECK_THROWS_WITH(system.analyze(matrix, 2), ContainsSubstring("no diagonal entry in row 3"));
}

TEST_CASE("dependent_rows: those that follow from the rows before them, and no others",
          "[dynamics][kkt]") {
    test::Random random(11);
    constexpr int coordinates = 60;
    VectorX scales(coordinates);
    for (double& scale : scales) scale = std::pow(10.0, random.vector<1>()[0]);
    for (const double excess : {0.0, 1e-12, 1e-8}) {
        // row 0 is zero; from row 5 every third one is made of two before it and that much more,
        // in a coordinate of its own
        MatrixX rows = MatrixX::Zero(24, coordinates);
        std::vector<int> expected{0};
        for (int i = 1; i < rows.rows(); ++i) {
            if (i % 3 == 2 && i > 2) {
                rows.row(i) = rows.row(i - 1) - 2.0 * rows.row(i / 2);
                const double length = rows.row(i).cwiseProduct(scales.transpose()).norm();
                const int own = 50 + i / 3;
                rows(i, own) = excess * length / scales[own];
                if (excess < 1e-10) expected.push_back(i);
            } else {
                for (int k = 0; k < 4; ++k) rows(i, (7 * i + 11 * k) % 50) = random.vector<1>()[0];
            }
        }
        INFO("excess " << excess);
        const MatrixX columns = rows.transpose();
        CHECK(dependent_rows(columns.sparseView(), 0, scales, 1e-10) == expected);
        SparseMatrix with_zeros(coordinates, rows.rows());
        for (int j = 0; j < columns.cols(); ++j)
            for (int i = 0; i < coordinates; ++i) with_zeros.insert(i, j) = columns(i, j);
        with_zeros.makeCompressed();
        CHECK(dependent_rows(with_zeros, 0, scales, 1e-10) == expected);
    }
    CHECK(dependent_rows(SparseMatrix(3, 0), 0, VectorX::Ones(3), 1e-10).empty());
}

TEST_CASE("dependent_rows: the scales of the coordinates count", "[dynamics][kkt]") {
    MatrixX columns(2, 2);  // rows (1, 0) and (1, 1)
    columns << 1, 1, 0, 1;
    const VectorX alike = VectorX::Ones(2), apart = Vector<double, 2>(1.0, 1e-12);
    CHECK(dependent_rows(columns.sparseView(), 0, alike, 1e-10).empty());
    CHECK(dependent_rows(columns.sparseView(), 0, apart, 1e-10) == std::vector<int>{1});
    // more rows than coordinates: the last follows from both, in any scales
    MatrixX wide(2, 3);
    wide << 1, 1, 3, 0, 1, -2;
    CHECK(dependent_rows(wide.sparseView(), 0, alike, 1e-10) == std::vector<int>{2});
}

TEST_CASE("dependent_rows: a long closed chain has one dependent row, at no great cost",
          "[dynamics][kkt]") {
    // x_k - x_{k+1} = 0 around a ring of points, in shuffled order of the coordinates
    constexpr int links = 20000;
    const auto place = [](int k) { return static_cast<int>(7919LL * (k % links) % links); };
    SparseMatrix columns(links, links);
    for (int k = 0; k < links; ++k) {
        columns.insert(place(k), k) = 1.0;
        columns.insert(place(k + 1), k) = -1.0;
    }
    columns.makeCompressed();
    CHECK(dependent_rows(columns, 0, VectorX::Ones(links), 1e-10) == std::vector<int>{links - 1});
}

TEST_CASE("algebra: products and blocks of symmetric matrices from either storage", "[algebra]") {
    test::Random random(5);
    constexpr int size = 9;
    const SparseMatrix full = symmetric(size, random);
    const SparseMatrix lower = full.triangularView<Eigen::Lower>();
    CHECK(lower.nonZeros() < full.nonZeros());
    const VectorX x = random.vector<size>();
    const VectorX expected = full * x;
    CHECK((detail::multiply(full, Storage::full, x) - expected).norm() <= 1e-14);
    CHECK((detail::multiply(lower, Storage::lower, x) - expected).norm() <= 1e-14);
    CHECK(detail::leading_block(lower, 0, Storage::lower).cols() == 0);
    for (const int part : {1, 4, size}) {
        const MatrixX block = MatrixX(full).topLeftCorner(part, part);
        CHECK((MatrixX(detail::leading_block(full, part, Storage::full)) - block).norm() == 0.0);
        CHECK((MatrixX(detail::leading_block(lower, part, Storage::lower)) - block).norm() == 0.0);
        const VectorX head = x.head(part);
        const VectorX product = block * head;
        CHECK((detail::multiply(lower, Storage::lower, head) - product).norm() <= 1e-14);
    }
}

TEST_CASE("algebra: the largest ratio tells of a NaN and is zero of nothing", "[algebra]") {
    const VectorX scale = Vector<double, 3>(1.0, 2.0, 4.0);
    CHECK(detail::largest_ratio(VectorX(), VectorX()) == 0.0);
    CHECK(detail::largest_ratio((VectorX(3) << 1.0, -6.0, 4.0).finished(), scale) == 3.0);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(std::isnan(detail::largest_ratio((VectorX(3) << nan, 1.0, 1.0).finished(), scale)));
}

TEST_CASE("algebra: SmallCholesky and diagonalize agree with Eigen", "[algebra]") {
    test::Random random(6);
    for (int trial = 0; trial < 20; ++trial) {
        const MatrixX root = MatrixX(random.vector<3>() * random.vector<3>().transpose());
        const Matrix<double, 3> spd = root * root.transpose() + Matrix<double, 3>::Identity();
        const Vector<double, 3> b = random.vector<3>();
        const detail::SmallCholesky<3> factors(spd);
        CHECK((spd * factors.solve(b) - b).norm() <= 1e-13 * b.norm());
    }
    MatrixX matrix = MatrixX::Zero(8, 8);  // of rank 3, as with rigid motions
    for (int k = 0; k < 3; ++k) {
        const Vector<double, 8> v = random.vector<8>();
        matrix += std::pow(100.0, k) * v * v.transpose();
    }
    const MatrixX before = matrix;
    const MatrixX vectors = detail::diagonalize(matrix);
    CHECK((vectors.transpose() * vectors - MatrixX::Identity(8, 8)).norm() <= 1e-13);
    CHECK((before * vectors - vectors * MatrixX(matrix.diagonal().asDiagonal())).norm() <=
          1e-12 * before.norm());
    VectorX values = matrix.diagonal();
    std::sort(values.begin(), values.end());
    const VectorX expected = test::eigenvalues(before);
    CHECK((values - expected).norm() <= 1e-12 * before.norm());
}

}  // namespace kkt_test
