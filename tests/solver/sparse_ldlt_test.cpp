// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/sparse_ldlt.hpp>

#include <Eigen/Dense>

#include <support/catch.hpp>
#include <support/dense.hpp>

#include <limits>
#include <random>
#include <vector>

namespace sparse_ldlt_test {

using ancf::detail::MatrixEntry;
using ancf::detail::SparseLdlt;

/// A grid of side x side blocks, each coupled with its neighbours, and its lower half by entries.
struct Grid {
    ancf::List<MatrixEntry> entries;
    std::vector<int> blocks;
    ancf::MatrixX dense;

    Grid(int side, int width, double shift) {
        std::mt19937 random(17);
        std::uniform_real_distribution<double> value(-1.0, 1.0);
        const int size = side * side * width;
        dense = ancf::MatrixX::Zero(size, size);
        for (int row = 0; row < size; ++row) blocks.push_back(row / width);
        const auto couple = [&](int a, int b) {
            for (int i = a * width; i < (a + 1) * width; ++i)
                for (int j = b * width; j < (b + 1) * width; ++j)
                    if (i >= j) add(i, j, value(random));
        };
        for (int block = 0; block < side * side; ++block) {
            couple(block, block);
            if (block % side > 0) couple(block, block - 1);
            if (block >= side) couple(block, block - side);
        }
        // said twice, an entry is a sum
        for (int row = 0; row < size; ++row) add(row, row, shift);
    }

    void add(int i, int j, double value) {
        entries.push_back({i, j, value});
        dense(i, j) += value;
        if (i != j) dense(j, i) += value;
    }
};

TEST_CASE("sparse LDL^T: new values of a pattern and other patterns in one object",
          "[sparse-ldlt]") {
    SparseLdlt factor;
    const auto check = [&](const ancf::SparseMatrix& lower, const std::vector<int>& blocks) {
        const ancf::MatrixX dense = ancf::MatrixX(lower).selfadjointView<Eigen::Lower>();
        REQUIRE(factor.factorize(lower, blocks));
        const ancf::VectorX b = ancf::VectorX::LinSpaced(lower.cols(), 1.0, 2.0);
        ancf::VectorX x = b;
        factor.solve(x);
        CHECK((dense * x - b).norm() <= 1e-12);  // measured 1e-14
    };
    const Grid definite(7, 3, 30.0), negative(7, 3, -30.0);
    for (const Grid* grid : {&definite, &negative})
        check(ancf::detail::compressed(147, grid->entries), grid->blocks);
    // as many entries elsewhere, other blocks, a failure between
    const std::vector<int> each = {0, 1, 2}, pair = {0, 0, 1};
    const auto first =
        ancf::detail::compressed(3, {{0, 0, 2.0}, {1, 0, 1.0}, {1, 1, 2.0}, {2, 2, 2.0}});
    const auto second =
        ancf::detail::compressed(3, {{0, 0, 2.0}, {1, 1, 2.0}, {2, 1, 1.0}, {2, 2, 2.0}});
    check(first, each);
    check(second, each);
    check(second, pair);
    CHECK_FALSE(factor.factorize(0.0 * second, pair));
    check(second, pair);
}

TEST_CASE("sparse LDL^T: rows kept from the values before give the bits of a fresh factor",
          "[sparse-ldlt]") {
    const Grid grid(7, 3, 30.0);
    ancf::SparseMatrix lower = ancf::detail::compressed(147, grid.entries);
    const ancf::VectorX b = ancf::VectorX::LinSpaced(147, 1.0, 2.0);
    std::mt19937 random(5);
    for (const int last : {0, 4}) {
        SparseLdlt kept;
        for (int change = 0; change < 60; ++change) {
            CAPTURE(last, change);
            double& value = lower.valuePtr()[random() % static_cast<unsigned>(lower.nonZeros())];
            const double before = value;
            value = change % 10 == 9 ? std::numeric_limits<double>::quiet_NaN() : 1.01 * value;
            SparseLdlt fresh;
            const bool done = fresh.factorize(lower, grid.blocks, last);
            CHECK(done == (change % 10 != 9));
            CHECK(kept.factorize(lower, grid.blocks, last) == done);
            if (!done) value = before;
            if (!done) continue;
            ancf::VectorX x = b, y = b;
            fresh.solve(x);
            kept.solve(y);
            CHECK(x == y);
        }
        CHECK(kept.factorize(lower, grid.blocks, last));
        CHECK(kept.factorize(lower, grid.blocks, last));  // nothing is new
        ancf::VectorX x = b;
        kept.solve(x);
        const ancf::MatrixX dense = ancf::MatrixX(lower).selfadjointView<Eigen::Lower>();
        CHECK((dense * x - b).norm() <= 1e-12);  // measured 1e-14
    }
}

TEST_CASE("sparse LDL^T: the last rows are eliminated last", "[sparse-ldlt]") {
    // a chain A and a row without a diagonal entry: its pivot is -(A^-1)_00
    const auto chain = ancf::detail::compressed(
        4, {{0, 0, 2.0}, {1, 1, 2.0}, {2, 2, 2.0}, {1, 0, 1.0}, {2, 1, 1.0}, {3, 0, 1.0}});
    SparseLdlt factor;
    REQUIRE(factor.factorize(chain, {0, 1, 2, 3}, 1));
    CHECK(factor.pivot(3) == Approx(-0.75));
}

TEST_CASE("sparse LDL^T: solves and counts signs as dense matrices do", "[sparse-ldlt]") {
    for (const double shift : {30.0, 3.0, -30.0}) {  // definite, indefinite, negative definite
        INFO("shift " << shift);
        const Grid grid(7, 3, shift);
        const auto size = static_cast<int>(grid.dense.rows());
        const ancf::SparseMatrix lower = ancf::detail::compressed(size, grid.entries);
        CHECK((ancf::MatrixX(lower) - ancf::MatrixX(grid.dense.triangularView<Eigen::Lower>()))
                  .norm() <= 1e-14 * grid.dense.norm());
        SparseLdlt factor;
        REQUIRE(factor.factorize(lower, grid.blocks));
        REQUIRE(factor.size() == size);
        ancf::VectorX wanted = ancf::VectorX::LinSpaced(size, -1.0, 2.0);
        ancf::VectorX x = grid.dense * wanted;
        factor.solve(x);
        // no pivoting: the indefinite one loses digits; measured 3e-16, 4e-15, 3e-16
        CHECK((x - wanted).norm() <= 1e-11 * wanted.norm());
        int negative = 0;
        for (int row = 0; row < size; ++row) negative += factor.pivot(row) < 0.0 ? 1 : 0;
        CHECK(negative == (ancf::test::eigenvalues(grid.dense).array() < 0.0).count());
    }
}

TEST_CASE("sparse LDL^T: a pivot of zero or none at all is told", "[sparse-ldlt][bad-input]") {
    SparseLdlt factor;
    CHECK(factor.factorize(ancf::detail::compressed(0, {}), {}));
    CHECK_FALSE(factor.factorize(ancf::detail::compressed(2, {{0, 0, 1.0}}), {0, 1}));
    const ancf::List<MatrixEntry> rank_one = {{0, 0, 1.0}, {1, 0, 1.0}, {1, 1, 1.0}};
    CHECK_FALSE(factor.factorize(ancf::detail::compressed(2, rank_one), {0, 0}));
}

TEST_CASE("sparse LDL^T: a star and a ring of blocks get hardly any fill", "[sparse-ldlt]") {
    const int leaves = 2000;
    ancf::List<MatrixEntry> star;
    std::vector<int> blocks;
    for (int k = 0; k <= leaves; ++k) {
        blocks.push_back(k);
        star.push_back({k, k, k == 0 ? leaves : 2.0});
        if (k > 0) star.push_back({k, 0, 1.0});
    }
    SparseLdlt factor;
    REQUIRE(factor.factorize(ancf::detail::compressed(leaves + 1, star), blocks));
    CHECK(factor.fill() == leaves);
    ancf::List<MatrixEntry> ring;
    for (int k = 0; k <= leaves; ++k) {
        ring.push_back({k, k, 3.0});
        if (k > 0) ring.push_back({k, k - 1, -1.0});
    }
    ring.push_back({leaves, 0, -1.0});
    REQUIRE(factor.factorize(ancf::detail::compressed(leaves + 1, ring), blocks));
    CHECK(factor.fill() <= 2 * leaves);
}

}  // namespace sparse_ldlt_test
