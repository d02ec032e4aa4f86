// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Condensed systems against the whole ones.

#include <ancf/solver/condensation.hpp>

#include <support/catch.hpp>
#include <support/dense.hpp>
#include <support/random_state.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace condensation_test {

using namespace ancf;
using test::Random;

/// Twelve unknowns; 2, 5 and 9 see the unknowns beside them alone, 10 and 11 each other too.
MatrixX sample(Random& random, bool symmetric) {
    MatrixX K = 6.0 * MatrixX::Identity(12, 12);
    const std::vector<std::pair<int, int>> entries = {{0, 1}, {1, 2},  {2, 3},  {3, 4},  {4, 5},
                                                      {5, 6}, {6, 7},  {7, 8},  {8, 9},  {0, 9},
                                                      {0, 4}, {8, 10}, {7, 11}, {10, 11}};
    for (const auto& [i, j] : entries) {
        K(i, j) = random.uniform(-1.0, 1.0);
        K(j, i) = symmetric ? K(i, j) : random.uniform(-1.0, 1.0);
    }
    return K;
}

const List<List<int>> sets = {{2}, {5}, {9}, {10, 11}};

/// Solves by elimination, the reduced system dense.
VectorX solve_condensed(detail::Condensation& condensation, const SparseMatrix& K,
                        const VectorX& b) {
    std::vector<int> place(12, -1);
    int kept = 0, stored = 0;
    for (int j = 0; j < 12; ++j)
        if (condensation.keeps(j)) {
            place[static_cast<std::size_t>(j)] = kept++;
            stored += K.outerIndexPtr()[j + 1] - K.outerIndexPtr()[j];
        }
    std::vector<double> values(static_cast<std::size_t>(stored) + condensation.filled().size());
    REQUIRE(condensation.reduce(K, values.data()));
    MatrixX S = MatrixX::Zero(kept, kept);
    std::size_t next = 0;
    for (int j = 0; j < 12; ++j) {
        if (!condensation.keeps(j)) continue;
        for (int k = K.outerIndexPtr()[j]; k < K.outerIndexPtr()[j + 1]; ++k, ++next) {
            const int i = place[static_cast<std::size_t>(K.innerIndexPtr()[k])];
            if (i >= 0) S(i, place[static_cast<std::size_t>(j)]) += values[next];
        }
    }
    for (const auto& [i, j] : condensation.filled())
        S(place[static_cast<std::size_t>(i)], place[static_cast<std::size_t>(j)]) += values[next++];
    const VectorX right = b + condensation.shift(b);
    VectorX reduced(kept), x = VectorX::Zero(12);
    for (int j = 0; j < 12; ++j)
        if (place[static_cast<std::size_t>(j)] >= 0)
            reduced[place[static_cast<std::size_t>(j)]] = right[j];
    const VectorX solved = test::solved(S, reduced);
    for (int j = 0; j < 12; ++j)
        if (place[static_cast<std::size_t>(j)] >= 0)
            x[j] = solved[place[static_cast<std::size_t>(j)]];
    condensation.complete(b, x);
    return x;
}

TEST_CASE("Condensation: what is left has the solution of the whole", "[solver]") {
    const bool symmetric = GENERATE(true, false);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        Random random(seed);
        const MatrixX dense = sample(random, symmetric);
        SparseMatrix K = dense.sparseView();
        K.makeCompressed();
        detail::Condensation condensation(K, sets, symmetric);
        CHECK_FALSE(condensation.keeps(5));
        CHECK(condensation.keeps(4));
        const VectorX b = random.vector(12);
        const VectorX x = solve_condensed(condensation, K, b);
        CHECK((dense * x - b).norm() <= 1e-13 * b.norm());
    }
}

TEST_CASE("Condensation: unknowns without stiffness are refused", "[solver]") {
    Random random(1);
    SparseMatrix K = sample(random, true).sparseView();
    K.makeCompressed();
    detail::Condensation condensation(K, sets, true);
    K.coeffRef(5, 5) = 0.0;
    std::vector<double> values(static_cast<std::size_t>(K.nonZeros()) +
                               condensation.filled().size());
    CHECK_FALSE(condensation.reduce(K, values.data()));
}

}  // namespace condensation_test
