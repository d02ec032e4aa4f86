// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The saddle-point systems [M G^T; G 0] of consistent starts and projections, and redundant rows.
///
/// Eigen alone, and of it what compiles fast; a factorisation is kept while the matrix has the same
/// values.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/error.hpp>
#include <ancf/types.hpp>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseQR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ancf {

/// A factorised saddle point [A G^T; G D] of fixed pattern, A symmetric and positive definite, D
/// zero or, in the rows of equations left out, one.
///
/// Each zero of D is factorised as -e_i, e_i a small share of (G diag(A)^-1 G^T)_ii: the matrix is
/// then quasi-definite, so that L D L^T exists in every order (Vanderbei, SIAM J. Optim. 5, 1995).
/// Refinement takes the share away again: a step leaves share/s of the error, s the smallest
/// eigenvalue of S = G A^-1 G^T scaled by its diagonal. Where that is too slow the share is made
/// smaller; s below about 1e-14, a row independent of the others by less than 1e-7 of its length,
/// is singular. Where A is not positive definite the factorisation may break down or be inaccurate.
class KktSystem {
public:
    /// Takes the pattern, of either storage; values that are zero now and later are welcome.
    /// @param rows  number of rows of A; those of G follow.
    void analyze(const SparseMatrix& pattern, int rows) {
        rows_ = rows;
        share_ = largest_share;
        factorised_.resize(0);
        matrix_ = detail::lower_half(pattern);
        ldlt_.analyzePattern(matrix_);
    }

    /// Factorises, unless the values are those already factorised. Reads the lower half.
    [[nodiscard]] Status factorize(const SparseMatrix& matrix) {
        const Eigen::Map<const VectorX> values(matrix.valuePtr(), matrix.nonZeros());
        if (factorised_.size() == values.size() &&
            std::equal(values.data(), values.data() + values.size(), factorised_.data()))
            return Status::converged;
        factorised_.resize(0);
        if (!values.allFinite()) return Status::not_finite;
        matrix_ = detail::lower_half(matrix);
        if (!factorize_shifted()) return Status::singular;
        factorised_ = values;
        return Status::converged;
    }

    /// Solves with refinement until it gains no more, with smaller shares where it ends too early.
    /// @pre the last factorize converged.
    /// @return singular where the equations do not hold to 1e-10.
    [[nodiscard]] Status solve(const VectorX& b, VectorX& x) {
        for (;;) {
            const double error = refine(b, x);
            if (error <= 1e-13) return Status::converged;
            if (!x.allFinite() || share_ < smallest_share)
                return error <= 1e-10 ? Status::converged : Status::singular;
            share_ *= 1e-3;
            if (!factorize_shifted()) return Status::singular;
        }
    }

private:
    static constexpr double largest_share = 1e-8, smallest_share = 1e-13;

    // Solves, and returns the larger residual of the two parts, relative to |matrix| |x| + |b|.
    [[nodiscard]] double refine(const VectorX& b, VectorX& x) const {
        constexpr double epsilon = std::numeric_limits<double>::epsilon();
        x = ldlt_.solve(b);
        VectorX residual, next = x;
        double error = std::numeric_limits<double>::infinity();
        for (int step = 0; step < 30; ++step) {
            const double now = relative_residual(b, next, residual);
            if (!(now < error)) break;
            const bool slow = now > 0.5 * error;
            x = next;
            error = now;
            if (slow || error < 4.0 * epsilon) break;
            next = x + ldlt_.solve(residual);
        }
        return error;
    }

    [[nodiscard]] double relative_residual(const VectorX& b, const VectorX& x,
                                           VectorX& residual) const {
        residual = b;
        double largest[2] = {0.0, 0.0}, rest[2] = {0.0, 0.0}, size[2] = {0.0, 0.0};
        const auto part = [this](Eigen::Index i) { return i < rows_ ? 0 : 1; };  // of other units
        for (Eigen::Index i = 0; i < x.size(); ++i)
            largest[part(i)] = std::max(largest[part(i)], std::abs(x[i]));
        VectorX terms = b.cwiseAbs();  // and |matrix| times the largest entries of x
        for (int j = 0; j < matrix_.cols(); ++j)
            for (SparseMatrix::InnerIterator entry(matrix_, j); entry; ++entry) {
                const auto i = entry.row();
                residual[i] -= entry.value() * x[j];
                terms[i] += std::abs(entry.value()) * largest[part(j)];
                if (i == j) continue;
                residual[j] -= entry.value() * x[i];
                terms[j] += std::abs(entry.value()) * largest[part(i)];
            }
        for (Eigen::Index i = 0; i < b.size(); ++i) {
            rest[part(i)] = std::max(rest[part(i)], std::abs(residual[i]));
            size[part(i)] = std::max(size[part(i)], terms[i]);
        }
        if (!residual.allFinite()) return std::numeric_limits<double>::infinity();
        double ratio = 0.0;
        for (int k = 0; k < 2; ++k)
            if (size[k] > 0.0) ratio = std::max(ratio, rest[k] / size[k]);
        return ratio;
    }

    [[nodiscard]] bool factorize_shifted() {
        const VectorX diagonal = matrix_.diagonal();
        VectorX shift = VectorX::Zero(matrix_.cols());
        for (int column = 0; column < rows_; ++column) {
            if (diagonal[column] == 0.0) continue;
            for (SparseMatrix::InnerIterator entry(matrix_, column); entry; ++entry)
                if (entry.row() >= rows_)
                    shift[entry.row()] +=
                        entry.value() * entry.value() / std::abs(diagonal[column]);
        }
        SparseMatrix shifted = matrix_;
        for (int row = rows_; row < matrix_.cols(); ++row)
            if (diagonal[row] == 0.0) shifted.coeffRef(row, row) -= share_ * shift[row];
        ldlt_.factorize(shifted);
        return ldlt_.info() == Eigen::Success;
    }

    int rows_ = 0;
    double share_ = largest_share;
    SparseMatrix matrix_;  // lower half
    VectorX factorised_;
    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> ldlt_;
};

/// Returns the rows of G that depend on the rows before them, ascending.
///
/// Each row is measured with the coordinates scaled and against its own length: a row is dependent
/// when what remains of it off the span of the earlier ones is shorter than the tolerance,
/// relative.
/// @param columns  G^T, compressed.
[[nodiscard]] inline std::vector<int> dependent_rows(SparseMatrix columns, const VectorX& scales,
                                                     double tolerance) {
    std::vector<int> dependent;
    if (columns.cols() == 0) return dependent;
    for (int j = 0; j < columns.cols(); ++j) {
        double square = 0.0;
        for (SparseMatrix::InnerIterator entry(columns, j); entry; ++entry) {
            entry.valueRef() *= scales[entry.row()];
            square += entry.value() * entry.value();
        }
        if (square == 0.0) continue;
        for (SparseMatrix::InnerIterator entry(columns, j); entry; ++entry)
            entry.valueRef() /= std::sqrt(square);
    }
    // In the natural order the factorisation moves a column to the end when it depends on those
    // before it.
    Eigen::SparseQR<SparseMatrix, Eigen::NaturalOrdering<int>> qr;
    qr.setPivotThreshold(tolerance);
    qr.compute(columns);
    const auto& order = qr.colsPermutation().indices();
    for (Eigen::Index k = qr.rank(); k < columns.cols(); ++k)
        dependent.push_back(static_cast<int>(order[k]));
    std::sort(dependent.begin(), dependent.end());
    return dependent;
}

}  // namespace ancf
