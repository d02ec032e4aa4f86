// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/assembly/block_pattern.hpp>
#include <ancf/error.hpp>

#include <support/catch.hpp>

#include <vector>

namespace block_pattern_test {

using ancf::BlockPattern;
using ancf::Storage;

const std::vector<int> sizes = {3, 0, 2, 4, 1};  // one block without rows
const ancf::List<ancf::BlockPair> pairs = {{0, 2}, {2, 3}, {3, 2}, {4, 0}, {1, 3}};

bool coupled(int a, int b) {
    if (a == b) return true;
    for (const auto& [c, d] : pairs)
        if ((a == c && b == d) || (a == d && b == c)) return true;
    return false;
}

TEST_CASE("BlockPattern: stores exactly the coupled blocks", "[assembly]") {
    const auto storage = GENERATE(Storage::full, Storage::lower);
    const BlockPattern pattern(sizes, pairs, storage);
    const ancf::SparseMatrix matrix = pattern.matrix();
    REQUIRE(matrix.rows() == 10);
    ancf::MatrixX stored = ancf::MatrixX::Zero(10, 10);
    for (int j = 0; j < matrix.outerSize(); ++j) {
        int last = -1;
        for (ancf::SparseMatrix::InnerIterator it(matrix, j); it; ++it) {
            CHECK(it.row() > last);
            last = static_cast<int>(it.row());
            stored(it.row(), it.col()) += 1.0;
        }
    }
    const int blocks = static_cast<int>(sizes.size());
    for (int a = 0; a < blocks; ++a)
        for (int b = 0; b < blocks; ++b)
            for (int i = 0; i < sizes[static_cast<std::size_t>(a)]; ++i)
                for (int j = 0; j < sizes[static_cast<std::size_t>(b)]; ++j) {
                    const int row = pattern.first(a) + i;
                    const int column = pattern.first(b) + j;
                    const bool half = storage == Storage::full || row >= column;
                    CHECK(stored(row, column) == (coupled(a, b) && half ? 1.0 : 0.0));
                }
}

TEST_CASE("BlockPattern: base and column offset find every value", "[assembly]") {
    const auto storage = GENERATE(Storage::full, Storage::lower);
    const BlockPattern pattern(sizes, pairs, storage);
    ancf::SparseMatrix matrix = pattern.matrix();
    int found = 0;
    const int blocks = static_cast<int>(sizes.size());
    for (int a = 0; a < blocks; ++a)
        for (int b = 0; b < blocks; ++b) {
            if (!coupled(a, b) || !pattern.stored(a, b)) continue;
            const int base = pattern.base(a, b);
            for (int i = 0; i < sizes[static_cast<std::size_t>(a)]; ++i)
                for (int j = 0; j < sizes[static_cast<std::size_t>(b)]; ++j) {
                    const int row = pattern.first(a) + i;
                    const int column = pattern.first(b) + j;
                    if (storage == Storage::lower && row < column) continue;
                    matrix.valuePtr()[base + pattern.column_offset(b, j) + i] = 100 * row + column;
                    ++found;
                    CHECK(matrix.coeff(row, column) == 100 * row + column);
                }
        }
    CHECK(found == matrix.nonZeros());
}

TEST_CASE("BlockPattern: blocks that are not coupled have no base", "[assembly][bad-input]") {
    const BlockPattern pattern(sizes, pairs, Storage::full);
    CHECK_THROWS_AS(pattern.base(0, 3), ancf::InvalidArgument);
}

TEST_CASE("BlockPattern: no blocks make an empty matrix", "[assembly]") {
    const BlockPattern pattern({}, {}, Storage::lower);
    CHECK(pattern.size() == 0);
    CHECK(pattern.matrix().nonZeros() == 0);
}

}  // namespace block_pattern_test
