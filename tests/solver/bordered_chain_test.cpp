// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/bordered_chain.hpp>
#include <ancf/solver/complex_solver_for.hpp>
#include <ancf/solver/eigen_solver.hpp>

#include <solver/complex_solver_cases.hpp>
#include <solver/linear_solver_cases.hpp>
#include <solver/linear_solver_properties.hpp>
#include <support/catch.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace bordered_chain_test {

using namespace ancf;
using namespace ancf::test;

/// Returns the lower half of a chain with `border` rows below, each with entries in every
/// `stride`-th column, and zeros in the corner.
SparseMatrix bordered(const std::vector<int>& sizes, int border, int stride,
                      double diagonal = 40.0) {
    const SparseMatrix chain = random_chain(sizes, 3, diagonal);
    const auto size = static_cast<int>(chain.cols());
    Triplets triplets;
    for (int j = 0; j < size; ++j)
        for (SparseMatrix::InnerIterator entry(chain, j); entry; ++entry)
            triplets.emplace_back(static_cast<int>(entry.row()), j, entry.value());
    for (int k = 0; k < border; ++k) {
        const VectorX row = random_vector(size, 100U + static_cast<unsigned>(k));
        for (int j = k % stride; j < size; j += stride) triplets.emplace_back(size + k, j, row[j]);
        triplets.emplace_back(size + k, size + k, 0.0);
    }
    return sparse(size + border, triplets);
}

TEST_CASE("BorderedChain: chains of every width with borders of every width", "[solver]") {
    for (const int width : {1, 4, 6, 9, 12, 24})
        for (const int border : {0, 1, 5, 12, 24}) {
            CAPTURE(width, border);
            BorderedChain solver;
            const SparseMatrix lower = bordered(std::vector<int>(30, width), border, 3);
            CHECK(solve_and_check(solver, lower, 1e-13).status == Status::converged);
            CHECK(solver.by_chain());
            CHECK(solver.name() == "bordered-chain");
        }
}

TEST_CASE("BorderedChain: one solver for patterns of every kind, and multipliers of last nodes",
          "[solver]") {
    BorderedChain solver;
    CHECK_FALSE(solver.by_chain());
    for (const int width : {12, 3, 24})
        for (const int border : {2, 30, 7}) {
            CAPTURE(width, border);
            const SparseMatrix lower = bordered(std::vector<int>(12, width), border, 1);
            CHECK(solve_and_check(solver, lower, 1e-13).status == Status::converged);
            CHECK(solver.by_chain() == (border < 30));
        }
    // the pattern has the multipliers of the last node as one more block of the chain
    for (const int held : {1, 3, 6}) {
        CAPTURE(held);
        const SparseMatrix chain = random_chain(std::vector<int>(9, 6), 3);
        Triplets triplets;
        for (int j = 0; j < 54; ++j)
            for (SparseMatrix::InnerIterator entry(chain, j); entry; ++entry)
                triplets.emplace_back(static_cast<int>(entry.row()), j, entry.value());
        for (int k = 0; k < held; ++k) {
            for (int j = 48; j < 54; ++j)
                triplets.emplace_back(54 + k, j,
                                      random_vector(6, 9U + static_cast<unsigned>(k))[j - 48]);
            triplets.emplace_back(54 + k, 54 + k, 0.0);
        }
        CHECK(solve_and_check(solver, sparse(54 + held, triplets), 1e-13).status ==
              Status::converged);
        CHECK(solver.by_chain());
    }
}

TEST_CASE("BorderedChain: what is no such chain goes to the general solver", "[solver]") {
    BorderedChain solver;
    const SparseMatrix wide = bordered(std::vector<int>(9, 12), BorderedChain::max_border + 1, 1);
    CHECK(solve_and_check(solver, wide, 1e-13).status == Status::converged);
    CHECK_FALSE(solver.is_chain());
    CHECK(solver.name() == "eigen-lu");
    CHECK(solve_and_check(solver, grid(60), 1e-13).status == Status::converged);
    CHECK_FALSE(solver.is_chain());
    CHECK(solve_and_check(solver, bordered({12, 12, 12}, 3, 1), 1e-13).status == Status::converged);
    CHECK(solver.is_chain());
    CHECK_THROWS_WITH(BorderedChain(EigenLdlt()), ContainsSubstring("eigen-ldlt"));
    CHECK_THROWS_WITH(BorderedChain(std::unique_ptr<LinearSolver>()), ContainsSubstring("none"));
    const BorderedChain moved(std::move(solver));
    CHECK_THROWS_WITH(solve_and_check(solver, wide, 1e-13), ContainsSubstring("moved"));  // NOLINT
    CHECK(solve_and_check(solver, bordered({12, 12, 12}, 3, 1), 1e-13).status == Status::converged);
    MatrixX idle = MatrixX::Zero(6, 6);
    idle(5, 0) = 1.0;
    CHECK(solve_and_check(solver, sparse_lower(idle), 1e-13).status == Status::singular);
}

TEST_CASE("BorderedChain: a matrix that the chain does not solve goes to the general solver",
          "[solver]") {
    const SparseMatrix good = stored(bordered(std::vector<int>(9, 6), 6, 1), Storage::full);
    const VectorX b = random_vector(static_cast<int>(good.cols()), 5);
    VectorX x;
    const auto error_of = [&](BorderedChain& solver, const SparseMatrix& matrix,
                              bool by_chain = false) {
        solver.analyze(good);
        REQUIRE(solver.factorize(good).status == Status::converged);
        CHECK(solver.by_chain());
        REQUIRE(solver.factorize(matrix).status == Status::converged);
        CHECK(solver.by_chain() == by_chain);
        solver.solve(b, x);
        return backward_error(matrix, Storage::full, x, b);
    };
    BorderedChain solver;
    SparseMatrix unsymmetric = good;
    unsymmetric.coeffRef(0, 1) += 0.5;
    CHECK(error_of(solver, unsymmetric) <= 1e-13);
    SparseMatrix skew = good;
    skew.coeffRef(57, 0) *= -1.0;  // the factors read the other half
    CHECK(error_of(solver, skew) <= 1e-13);
    // the border alone holds the last block of the chain, which joins the border where it has no
    // stiffness at all, or holds motions that hardly strain it
    using Pair = std::pair<double, double>;
    for (const auto& [stiffness, share] :
         {Pair(0.0, 0.0), Pair(40.0, 0.0), Pair(40.0, 1e-12), Pair(40.0, 1e-9)}) {
        CAPTURE(stiffness, share);
        SparseMatrix held = good;
        for (int j = 48; j < 54; ++j)
            for (SparseMatrix::InnerIterator entry(held, j); entry; ++entry) {
                const auto i = static_cast<int>(entry.row());
                if (i < 54) held.coeffRef(i, j) = held.coeffRef(j, i) = 0.0;
            }
        for (int i = 48; i < 54; ++i)
            for (int j = 48; j < 54; ++j)
                held.coeffRef(i, j) = stiffness * (i == j ? 1.0 + share : 1.0);
        CHECK(error_of(solver, held, stiffness == 0.0) <= 1e-13);
    }
    // another one takes the chain again
    CHECK(solver.factorize(good).status == Status::converged);
    CHECK(solver.by_chain());
}

TEST_CASE("BorderedChain: complex matrices", "[solver]") {
    const ComplexSample sample = complex_chain(7, 6, Storage::full, 21);
    const auto solver = complex_solver_for(BorderedChain(), sample.pattern);
    CHECK(solver->name() == "complex bordered-chain");
    check_solution(*solver, sample);
    // the last eight unknowns reach the first ones, without a diagonal of their own
    ComplexSample joint = sample;
    for (int j = 34; j < 42; ++j) {
        for (int i = 34; i < 42; ++i) joint.dense(i, j) = 0.0;
        joint.dense(j, j - 34) = joint.dense(j - 34, j) = Complex(1.0, 0.5);
    }
    joint.values.clear();
    joint.pattern = SparseMatrix(42, 42);
    Triplets triplets;
    for (int j = 0; j < 42; ++j)
        for (int i = 0; i < 42; ++i)
            if (i == j || joint.dense(i, j) != 0.0) triplets.emplace_back(i, j, 1.0);
    joint.pattern.setFromTriplets(triplets.begin(), triplets.end());
    for (int j = 0; j < 42; ++j)
        for (SparseMatrix::InnerIterator entry(joint.pattern, j); entry; ++entry)
            joint.values.push_back(joint.dense(entry.row(), j));
    const auto other = complex_solver_for(BorderedChain(), joint.pattern);
    CHECK(other->name() == "complex bordered-chain");
    check_solution(*other, joint);
    // regular, but nothing for the chain
    joint.dense(0, 0) = joint.values.front() = 0.0;
    check_solution(*other, joint);
    CHECK(complex_solver_for(BorderedChain(), complex_chain(3, 30, Storage::full, 1).pattern)
              ->name() == "complex eigen-lu");
}

}  // namespace bordered_chain_test
