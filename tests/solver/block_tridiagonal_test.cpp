// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/block_tridiagonal.hpp>

#include <solver/linear_solver_cases.hpp>
#include <solver/linear_solver_properties.hpp>
#include <support/catch.hpp>

#include <limits>
#include <vector>

namespace block_tridiagonal_test {

using namespace ancf;
using namespace ancf::test;

TEST_CASE("BlockTridiagonal: blocks are the nodes of a chain", "[solver][chain]") {
    const auto starts = [](const std::vector<int>& nodes) {
        return detail::chain_starts(random_chain(nodes, 1));
    };
    CHECK(starts({12, 12, 12, 12}) == std::vector<int>{0, 12, 24, 36, 48});
    CHECK(starts({6, 12, 12, 9, 6}) == std::vector<int>{0, 6, 18, 30, 39, 45});
    CHECK(starts({24, 12, 24, 12}) == std::vector<int>{0, 24, 36, 60, 72});
    CHECK(starts({7}) == std::vector<int>{0, 4, 7});  // one dense block: two halves
    CHECK(starts({}) == std::vector<int>{0});
    CHECK(detail::chain_starts(grid(5)).back() == 25);

    SparseMatrix diagonal(5, 5);
    diagonal.setIdentity();
    CHECK(detail::chain_starts(diagonal) == std::vector<int>{0, 1, 2, 3, 4, 5});
}

TEST_CASE("BlockTridiagonal: no entry couples blocks that are not neighbours", "[solver][chain]") {
    Random random(3);
    int checked = 0;
    for (int trial = 0; trial < 200; ++trial) {  // a random band with holes
        Triplets triplets;
        const int size = 1 + trial;
        const int band = 1 + trial % 17;
        for (int j = 0; j < size; ++j)
            for (int i = j; i < std::min(size, j + band); ++i)
                if (i == j || random.uniform(0.0, 1.0) < 0.4) triplets.emplace_back(i, j, 1.0);
        const SparseMatrix matrix = sparse(size, triplets);
        const std::vector<int> starts = detail::chain_starts(matrix);
        REQUIRE(starts.front() == 0);
        REQUIRE(starts.back() == size);
        std::vector<int> block(static_cast<std::size_t>(size));
        for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
            REQUIRE(starts[k] < starts[k + 1]);
            for (int i = starts[k]; i < starts[k + 1]; ++i)
                block[static_cast<std::size_t>(i)] = static_cast<int>(k);
        }
        for (int j = 0; j < size; ++j)
            for (SparseMatrix::InnerIterator entry(matrix, j); entry; ++entry) {
                const auto row = static_cast<std::size_t>(entry.row());
                REQUIRE(block[row] - block[static_cast<std::size_t>(j)] <= 1);
                ++checked;
            }
    }
    CHECK(checked > 10000);
}

TEST_CASE("BlockTridiagonal: small nodes share a block, wide ones take the width that fits",
          "[solver][chain]") {
    const auto analysed = [](const std::vector<int>& nodes) {
        BlockTridiagonal solver;
        solver.analyze(random_chain(nodes, 1));
        return solver;
    };
    CHECK(analysed(std::vector<int>(12, 12)).width() == 12);
    CHECK(analysed(std::vector<int>(12, 12)).blocks() == 12);
    CHECK(analysed(std::vector<int>(12, 6)).width() == 6);
    CHECK(analysed(std::vector<int>(12, 6)).blocks() == 12);
    CHECK(analysed(std::vector<int>(12, 1)).blocks() == 2);  // six unknowns each
    CHECK(analysed(std::vector<int>(8, 9)).width() == 12);
    CHECK(analysed({24, 12, 24}).width() == 24);
    CHECK(analysed({}).blocks() == 0);
}

TEST_CASE("BlockTridiagonal: a pattern that is no chain is refused with the width it would take",
          "[solver][chain]") {
    BlockTridiagonal solver;
    CHECK(BlockTridiagonal::accepts(random_chain({24, 24, 24}, 1)));
    CHECK_FALSE(BlockTridiagonal::accepts(random_chain({25, 25, 25}, 1)));
    CHECK_THROWS_WITH(solver.analyze(random_chain({25, 25, 25}, 1)), ContainsSubstring("25"));

    SparseMatrix ring = random_chain(std::vector<int>(20, 12), 1);
    ring.coeffRef(239, 0) = 1.0;
    ring.makeCompressed();
    CHECK_FALSE(BlockTridiagonal::accepts(ring));
    CHECK_THROWS_AS(solver.analyze(ring), InvalidArgument);
}

TEST_CASE("BlockTridiagonal: an entry that left its block is refused, not written elsewhere",
          "[solver][chain]") {
    const SparseMatrix matrix = random_chain({9, 9, 9, 9}, 1);
    SparseMatrix other = matrix;
    const int last = other.outerIndexPtr()[3] - 1;  // of column 2, to the last row
    other.innerIndexPtr()[last] = 35;
    BlockTridiagonal solver;
    solver.analyze(matrix);
    CHECK_THROWS_WITH(solver.factorize(other), ContainsSubstring("another pattern"));
    CHECK(solver.factorize(matrix).status == Status::converged);
}

TEST_CASE("BlockTridiagonal: separate chains in one matrix are solved", "[solver][chain]") {
    const SparseMatrix one = random_chain(std::vector<int>(5, 12), 1);
    Triplets triplets;
    for (int copy = 0; copy < 3; ++copy)
        for (int j = 0; j < one.cols(); ++j)
            for (SparseMatrix::InnerIterator entry(one, j); entry; ++entry)
                triplets.emplace_back(static_cast<int>(entry.row()) + 60 * copy, j + 60 * copy,
                                      entry.value() * (1.0 + copy));
    BlockTridiagonal solver;
    CHECK(solve_and_check(solver, sparse(180, triplets), 4e-15).status == Status::converged);
}

TEST_CASE("BlockTridiagonal: a failure names the column of the zero pivot", "[solver][chain]") {
    for (const int column : {0, 5, 11, 12, 30, 47}) {
        SparseMatrix matrix = random_chain({12, 12, 12, 12}, 2);
        for (int j = 0; j < 48; ++j)  // the row and the column vanish
            for (SparseMatrix::InnerIterator entry(matrix, j); entry; ++entry)
                if (j == column || entry.row() == column) entry.valueRef() = 0.0;
        BlockTridiagonal solver;
        solver.analyze(matrix);
        const FactorReport report = solver.factorize(matrix);
        CHECK(report.status == Status::singular);
        CHECK(report.failed_column == column);
    }
}

TEST_CASE("BlockTridiagonal: a cantilever of 5000 elements is solved, of 30 000 honestly refused",
          "[solver][chain]") {
    // eps / rcond is the error to expect: 0.3 at 5000, far above 1 at 30 000
    BlockTridiagonal solver;
    for (const int elements : {5000, 30000}) {
        const SparseMatrix tangent = SampleBeam{elements, 1.0, 0.01}.tangent();
        solver.analyze(tangent);
        const FactorReport report = solver.factorize(tangent);
        CHECK(report.status == (elements < 10000 ? Status::converged : Status::singular));
        CHECK(report.rcond < 1e-14);
    }
    BlockTridiagonal lenient(0.0);
    const SparseMatrix tangent = SampleBeam{30000, 1.0, 0.01}.tangent();
    lenient.analyze(tangent);
    CHECK(lenient.factorize(tangent).status == Status::converged);
}

TEST_CASE("BlockTridiagonal: a limit that is no reciprocal condition number is refused",
          "[solver][chain]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double limit : {-1e-16, 1.0, 2.0, nan})
        CHECK_THROWS_WITH(BlockTridiagonal(limit), ContainsSubstring("singular_rcond"));
    CHECK_NOTHROW(BlockTridiagonal(0.0));
}

}  // namespace block_tridiagonal_test
