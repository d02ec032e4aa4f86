// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Complex matrices, and what every solver of them passes.

#pragma once

#include <ancf/error.hpp>
#include <ancf/solver/complex_solver.hpp>
#include <ancf/types.hpp>

#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <complex>
#include <cstdint>
#include <limits>
#include <vector>

namespace ancf::test {

using Complex = std::complex<double>;

/// A sparse matrix, its complex values and the same as a dense one.
struct ComplexSample {
    SparseMatrix pattern;
    std::vector<Complex> values;
    Eigen::MatrixXcd dense;
};

/// Returns a symmetric chain of blocks of the given width, diagonally dominant in its real part.
inline ComplexSample complex_chain(int blocks, int width, Storage storage, std::uint64_t seed) {
    Random random(seed);
    const int size = blocks * width;
    ComplexSample sample;
    sample.dense = Eigen::MatrixXcd::Zero(size, size);
    std::vector<Eigen::Triplet<double>> entries;
    for (int j = 0; j < size; ++j)
        for (int i = j; i < std::min(size, (j / width + 2) * width); ++i) {
            // drawn one after the other: arguments have no order, and so no compiler its own sample
            const double imaginary = random.uniform(-1.0, 1.0), real = random.uniform(-1.0, 1.0);
            Complex value(real, imaginary);
            if (i == j) value += 3.0 * width;
            sample.dense(i, j) = sample.dense(j, i) = value;
            entries.emplace_back(i, j, 1.0);
            if (storage == Storage::full && i != j) entries.emplace_back(j, i, 1.0);
        }
    sample.pattern.resize(size, size);
    sample.pattern.setFromTriplets(entries.begin(), entries.end());
    for (int j = 0; j < size; ++j)
        for (SparseMatrix::InnerIterator entry(sample.pattern, j); entry; ++entry)
            sample.values.push_back(sample.dense(entry.row(), j));
    return sample;
}

/// Checks a solver against a dense factorisation.
inline void check_solution(ComplexSolver& solver, const ComplexSample& sample) {
    Random random(7);
    REQUIRE(solver.factorize(sample.values) == Status::converged);
    ComplexVectorX x(sample.dense.rows());
    for (Complex& entry : x) entry = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
    const ComplexVectorX b = x;
    solver.solve(x);
    // well conditioned: a few roundings, 3e-16 measured
    CHECK((sample.dense * x - b).norm() <= 1e-14 * b.norm());
    std::vector<Complex> wrong = sample.values;
    wrong.back() = std::numeric_limits<double>::quiet_NaN();
    CHECK(solver.factorize(wrong) == Status::not_finite);
    wrong.assign(wrong.size(), 0.0);
    CHECK(solver.factorize(wrong) == Status::singular);
    wrong.pop_back();
    CHECK_THROWS_AS(solver.factorize(wrong), InvalidArgument);
    CHECK(solver.factorize(sample.values) == Status::converged);
}

}  // namespace ancf::test
