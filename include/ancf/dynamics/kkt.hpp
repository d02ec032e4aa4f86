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
/// Refinement takes the share away again, a factor of about 1e-8 over the condition of G per step.
class KktSystem {
public:
    /// Takes the pattern, of either storage; values that are zero now and later are welcome.
    /// @param rows  number of rows of A; those of G follow.
    void analyze(const SparseMatrix& pattern, int rows) {
        rows_ = rows;
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
        SparseMatrix shifted = matrix_;
        subtract_shifts(shifted);
        ldlt_.factorize(shifted);
        if (ldlt_.info() != Eigen::Success) return Status::singular;
        factorised_ = values;
        return Status::converged;
    }

    /// Solves with refinement until it gains no more.
    /// @pre the last factorize converged.
    void solve(const VectorX& b, VectorX& x) const {
        x = ldlt_.solve(b);
        VectorX residual = b, correction = x;
        double before = std::numeric_limits<double>::infinity();
        for (int step = 0; step < 30; ++step) {
            residual = b;
            detail::add_product(matrix_, Storage::lower, -1.0, x, residual);
            correction = ldlt_.solve(residual);
            const double size = relative_size(correction, x);
            if (!(size < before)) break;
            x += correction;
            if (size < 4.0 * std::numeric_limits<double>::epsilon()) break;
            before = 0.5 * size;
        }
    }

private:
    // The larger ratio of the two parts, whose units differ.
    [[nodiscard]] double relative_size(const VectorX& correction, const VectorX& x) const {
        double change[2] = {0.0, 0.0}, size[2] = {0.0, 0.0};
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            const int part = i < rows_ ? 0 : 1;
            change[part] = std::max(change[part], std::abs(correction[i]));
            size[part] = std::max(size[part], std::abs(x[i]));
        }
        double ratio = 0.0;
        for (int part = 0; part < 2; ++part)
            if (size[part] > 0.0) ratio = std::max(ratio, change[part] / size[part]);
        return ratio;
    }

    void subtract_shifts(SparseMatrix& matrix) const {
        constexpr double share = 1e-8;
        VectorX diagonal = matrix.diagonal();
        VectorX shift = VectorX::Zero(matrix.cols());
        for (int column = 0; column < rows_; ++column)
            for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
                if (entry.row() >= rows_)
                    shift[entry.row()] += share * entry.value() * entry.value() / diagonal[column];
        for (int row = rows_; row < matrix.cols(); ++row)
            if (diagonal[row] == 0.0) matrix.coeffRef(row, row) -= shift[row];
    }

    int rows_ = 0;
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
