// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The saddle-point systems [M G^T; G 0] of consistent starts and projections, and redundant rows.
///
/// Eigen alone; a factorisation is kept while the matrix has the same values.

#pragma once

#include <ancf/error.hpp>
#include <ancf/types.hpp>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <Eigen/SparseQR>

#include <algorithm>
#include <vector>

namespace ancf {

/// A factorised system of fixed pattern: LU of full storage, LDL^T of a lower half.
class KktSystem {
public:
    /// Takes the pattern; values that are zero now and later are welcome.
    void analyze(const SparseMatrix& pattern, Storage storage) {
        storage_ = storage;
        factorised_.resize(0);
        matrix_ = pattern;
        if (storage == Storage::full)
            lu_.analyzePattern(matrix_);
        else
            ldlt_.analyzePattern(matrix_);
    }

    /// Factorises, unless the values are those already factorised.
    [[nodiscard]] Status factorize(const SparseMatrix& matrix) {
        const Eigen::Map<const VectorX> values(matrix.valuePtr(), matrix.nonZeros());
        if (factorised_.size() == values.size() && (factorised_.array() == values.array()).all())
            return Status::converged;
        factorised_.resize(0);
        if (!values.allFinite()) return Status::not_finite;
        matrix_ = matrix;
        if (storage_ == Storage::full)
            lu_.factorize(matrix_);
        else
            ldlt_.factorize(matrix_);
        if ((storage_ == Storage::full ? lu_.info() : ldlt_.info()) != Eigen::Success)
            return Status::singular;
        factorised_ = values;
        return Status::converged;
    }

    /// Solves with one step of refinement.
    /// @pre the last factorize converged.
    void solve(const VectorX& b, VectorX& x) const {
        VectorX residual;
        if (storage_ == Storage::full) {
            x = lu_.solve(b);
            residual = b - matrix_ * x;
            x += lu_.solve(residual);
        } else {
            x = ldlt_.solve(b);
            residual = b - matrix_.selfadjointView<Eigen::Lower>() * x;
            x += ldlt_.solve(residual);
        }
    }

private:
    Storage storage_ = Storage::full;
    SparseMatrix matrix_;
    VectorX factorised_;
    Eigen::SparseLU<SparseMatrix, Eigen::COLAMDOrdering<int>> lu_;
    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> ldlt_;
};

/// Returns the rows of G that depend on the rows before them, ascending.
///
/// Each row is measured with the columns scaled and against its own length: a row is dependent when
/// what remains of it off the span of the earlier ones is shorter than the tolerance, relative.
[[nodiscard]] inline std::vector<int> dependent_rows(const SparseMatrix& jacobian,
                                                     const VectorX& scales, double tolerance) {
    SparseMatrix columns = (jacobian * scales.asDiagonal()).transpose();
    std::vector<int> dependent;
    for (int j = 0; j < columns.cols(); ++j) {
        const double length = columns.col(j).norm();
        if (length > 0.0) columns.col(j) /= length;
    }
    columns.makeCompressed();
    if (columns.cols() == 0) return dependent;
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
