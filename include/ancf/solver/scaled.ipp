// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/solver/direct_solver.hpp>
#include <ancf/solver/scaled.hpp>

#include <cmath>
#include <cstddef>

namespace ancf {

namespace detail {

/// A sum that keeps its round-off: value and what it lacks.
struct TwiceSum {
    double high = 0.0;
    double low = 0.0;

    /// Adds a b without round-off in the product. With -fassociative-math the sum has round-off.
    void add_product(double a, double b) noexcept {
        const double product = a * b;
        low += std::fma(a, b, -product);
        const double sum = high + product;
        const double part = sum - high;
        low += (high - (sum - part)) + (product - part);
        high = sum;
    }
};

/// The sum in working precision, with the same interface.
struct PlainSum {
    double high = 0.0;
    static constexpr double low = 0.0;
    void add_product(double a, double b) noexcept { high += a * b; }
};

/// Returns b - A x; `storage` says what of A is stored.
template <class Sum>
[[nodiscard]] VectorX residual(const SparseMatrix& matrix, Storage storage, const VectorX& x,
                               const VectorX& b) {
    List<Sum> sums(static_cast<std::size_t>(b.size()));
    for (int column = 0; column < matrix.outerSize(); ++column) {
        Sum mirrored;
        for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
            sums[entry.row()].add_product(-entry.value(), x[column]);
            if (storage == Storage::lower && entry.row() != column)
                mirrored.add_product(-entry.value(), x[entry.row()]);
        }
        Sum& own = sums[column];
        own.add_product(mirrored.high, 1.0);
        own.add_product(mirrored.low, 1.0);
    }
    VectorX result(b.size());
    for (Eigen::Index row = 0; row < b.size(); ++row) {
        Sum& sum = sums[row];
        sum.add_product(b[row], 1.0);
        result[row] = sum.high + sum.low;
    }
    return result;
}

}  // namespace detail

ANCF_INLINE Scaled::Scaled(std::unique_ptr<LinearSolver> solver, const ScaledOptions& options)
    : solver_(std::move(solver)), options_(options) {
    detail::require(solver_ != nullptr, "Scaled needs a solver, got none");
    detail::require(options.refinement_steps >= 0, "refinement_steps must not be negative, got ",
                    options.refinement_steps);
    storage_ = solver_->storage();
    name_ = "scaled " + std::string(solver_->name());
}

ANCF_INLINE void Scaled::analyze(const SparseMatrix& matrix) {
    detail::require(solver_ != nullptr, "Scaled: the solver was moved from");
    detail::require_storage(name(), matrix, storage());
    stage_.reset();
    scaled_ = matrix;
    solver_->analyze(scaled_);
    stage_.analysed(matrix);
}

ANCF_INLINE FactorReport Scaled::factorize(const SparseMatrix& matrix) {
    stage_.begin_factorisation(name(), matrix);
    // powers of two near 1/sqrt|a_ii|, so that scaled diagonal entries lie in [1, 4); a row without
    // a diagonal, a constraint's, is scaled to a largest entry of about 1
    detail::symmetric_roots(matrix, scale_);
    for (double& root : scale_) {
        int exponent = 1;
        if (std::isfinite(root)) std::frexp(root, &exponent);
        root = detail::power_of_two(1 - exponent);
    }
    for (int column = 0; column < matrix.outerSize(); ++column)
        for (int slot = matrix.outerIndexPtr()[column]; slot < matrix.outerIndexPtr()[column + 1];
             ++slot)
            scaled_.valuePtr()[slot] =
                matrix.valuePtr()[slot] * scale_[matrix.innerIndexPtr()[slot]] * scale_[column];
    return stage_.finished(solver_->factorize(scaled_));
}

ANCF_INLINE void Scaled::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    const VectorX right = scale_.cwiseProduct(b);
    const auto residual = options_.residual == ResidualPrecision::twice
                              ? detail::residual<detail::TwiceSum>
                              : detail::residual<detail::PlainSum>;
    VectorX correction;
    VectorX solution;
    detail::solve_with(*solver_, right, solution);
    for (int step = 0; step < options_.refinement_steps; ++step) {
        detail::solve_with(*solver_, residual(scaled_, storage(), solution, right), correction);
        solution += correction;
    }
    x = scale_.cwiseProduct(solution);
}

}  // namespace ancf
