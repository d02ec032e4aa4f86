// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Scaling of unknowns before a factorisation, and refinement of the solution after it.
///
/// Lengths, slopes, forces and moments differ by powers of slenderness. S A S with
/// S = diag(1/sqrt|a_ii|) has a unit diagonal, whatever the units, and is near the best conditioned
/// matrix that a diagonal scaling can reach. S is of powers of two, so it adds no round-off.

#pragma once

#include <ancf/error.hpp>
#include <ancf/solver/conditioning.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ancf {

/// With how many digits a residual b - A x is summed.
enum class ResidualPrecision {
    working,  ///< of a double: takes out most of the factorisation's round-off
    twice     ///< of two doubles: takes out all of it, at some times the cost
};

/// How Scaled refines a solution.
struct ScaledOptions {
    int refinement_steps = 1;                                 ///< in each solve
    ResidualPrecision residual = ResidualPrecision::working;  ///< of each step
};

namespace detail {

/// Returns the diagonal of S: powers of two near 1/sqrt|a_ii|, so that scaled diagonal entries lie
/// in [1, 4). A row without a diagonal, a constraint's, is scaled to a largest entry of about 1.
[[nodiscard]] inline VectorX symmetric_scale(const SparseMatrix& matrix) {
    VectorX scale;
    symmetric_roots(matrix, scale);
    return scale.unaryExpr([](double root) {
        int exponent = 1;
        if (std::isfinite(root)) std::frexp(root, &exponent);
        return std::ldexp(1.0, std::clamp(1 - exponent, -1000, 1000));
    });
}

/// A sum that keeps its round-off: value and what it lacks.
struct TwiceSum {
    double high = 0.0;
    double low = 0.0;

    /// Adds a b without round-off in the product; must not be compiled with -ffast-math.
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
                               const VectorX& b);

}  // namespace detail

/// Scales a matrix symmetrically for another solver, and refines its solutions.
///
/// Reports what the inner solver reports of S A S; `rcond` is that of the scaled matrix.
template <class Solver>
class Scaled {
    static_assert(is_linear_solver_v<Solver>, "Scaled<Solver> needs a linear solver");

public:
    static constexpr Storage storage = Solver::storage;  ///< that of the inner solver

    /// @throws InvalidArgument for negative refinement steps.
    explicit Scaled(Solver solver = Solver(), const ScaledOptions& options = {})
        : solver_(std::move(solver)),
          options_(options),
          name_("scaled " + std::string(solver_.name())) {
        detail::require(options.refinement_steps >= 0,
                        "refinement_steps must not be negative, got ", options.refinement_steps);
    }

    /// @throws InvalidArgument unless square, compressed, and of the storage and pattern that the
    ///         inner solver takes.
    void analyze(const SparseMatrix& matrix) {
        detail::require_storage(name(), matrix, storage);
        stage_.reset();
        scaled_ = matrix;
        solver_.analyze(scaled_);
        stage_.analysed(matrix);
    }

    /// Factorises in the pattern analysed.
    /// @throws InvalidArgument if its size or the number of entries in a column differs.
    [[nodiscard]] FactorReport factorize(const SparseMatrix& matrix);

    /// Solves A x = b. @throws InvalidArgument unless factorised and b has its size.
    void solve(const VectorX& b, VectorX& x) const;

    /// "scaled" and the name of the inner solver.
    [[nodiscard]] std::string_view name() const noexcept { return name_; }

    /// The diagonal of S of the last factorisation.
    [[nodiscard]] const VectorX& scale() const noexcept { return scale_; }

    /// The solver that gets the scaled matrix.
    [[nodiscard]] const Solver& inner() const noexcept { return solver_; }

private:
    [[nodiscard]] VectorX scaled_residual(const VectorX& x, const VectorX& b) const {
        return options_.residual == ResidualPrecision::twice
                   ? detail::residual<detail::TwiceSum>(scaled_, storage, x, b)
                   : detail::residual<detail::PlainSum>(scaled_, storage, x, b);
    }

    Solver solver_;
    ScaledOptions options_;
    std::string name_;
    SparseMatrix scaled_;
    VectorX scale_;
    detail::SolverStage stage_;
};

namespace detail {

template <class Sum>
VectorX residual(const SparseMatrix& matrix, Storage storage, const VectorX& x, const VectorX& b) {
    std::vector<Sum> sums(static_cast<std::size_t>(b.size()));
    for (int column = 0; column < matrix.outerSize(); ++column) {
        Sum mirrored;
        for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
            sums[static_cast<std::size_t>(entry.row())].add_product(-entry.value(), x[column]);
            if (storage == Storage::lower && entry.row() != column)
                mirrored.add_product(-entry.value(), x[entry.row()]);
        }
        Sum& own = sums[static_cast<std::size_t>(column)];
        own.add_product(mirrored.high, 1.0);
        own.add_product(mirrored.low, 1.0);
    }
    VectorX result(b.size());
    for (Eigen::Index row = 0; row < b.size(); ++row) {
        Sum& sum = sums[static_cast<std::size_t>(row)];
        sum.add_product(b[row], 1.0);
        result[row] = sum.high + sum.low;
    }
    return result;
}

}  // namespace detail

template <class Solver>
FactorReport Scaled<Solver>::factorize(const SparseMatrix& matrix) {
    stage_.begin_factorisation(name(), matrix);
    scale_ = detail::symmetric_scale(matrix);
    for (int column = 0; column < matrix.outerSize(); ++column)
        for (int slot = matrix.outerIndexPtr()[column]; slot < matrix.outerIndexPtr()[column + 1];
             ++slot)
            scaled_.valuePtr()[slot] =
                matrix.valuePtr()[slot] * scale_[matrix.innerIndexPtr()[slot]] * scale_[column];
    return stage_.finished(solver_.factorize(scaled_));
}

template <class Solver>
void Scaled<Solver>::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    const VectorX right = scale_.cwiseProduct(b);
    VectorX correction;
    VectorX solution;
    solver_.solve(right, solution);
    for (int step = 0; step < options_.refinement_steps; ++step) {
        solver_.solve(scaled_residual(solution, right), correction);
        solution += correction;
    }
    x = scale_.cwiseProduct(solution);
}

}  // namespace ancf
