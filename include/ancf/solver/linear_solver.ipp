// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/solver/linear_solver.hpp>

#include <algorithm>

namespace ancf::detail {

ANCF_INLINE void solve_with(const LinearSolver& solver, const VectorX& b, VectorX& x) {
    const Eigen::Index size = b.size();
    solver.solve(b, x);
    require(x.size() == size, solver.name(), ": solve gave ", x.size(), " entries for ", size);
}

ANCF_INLINE void require_storage(std::string_view solver, const SparseMatrix& matrix,
                                 Storage storage) {
    require(matrix.rows() == matrix.cols(), solver, " needs a square matrix, got ", matrix.rows(),
            " x ", matrix.cols());
    require(matrix.isCompressed(), solver,
            " needs a compressed matrix: call makeCompressed() first");
    const int* outer = matrix.outerIndexPtr();
    const int* inner = matrix.innerIndexPtr();
    for (int column = 0; column < static_cast<int>(matrix.cols()); ++column) {
        for (int slot = outer[column]; slot < outer[column + 1]; ++slot) {
            const int row = inner[slot];
            require(slot == outer[column] || inner[slot - 1] < row, solver,
                    " needs ascending rows, got row ", row, " out of order in column ", column);
            require(storage == Storage::full || row >= column, solver,
                    " needs the lower half of a symmetric matrix, got an entry at row ", row,
                    ", column ", column);
        }
    }
}

ANCF_INLINE void SolverStage::analysed(const SparseMatrix& matrix) {
    const int* outer = matrix.outerIndexPtr();
    columns_.assign(1, 0);  // an empty matrix may have no such array
    if (matrix.cols() > 0) columns_.assign(outer, outer + matrix.cols() + 1);
    factorised_ = false;
}

ANCF_INLINE void SolverStage::begin_factorisation(std::string_view solver,
                                                  const SparseMatrix& matrix) {
    require(!columns_.empty(), solver, ": analyze must be called before factorize");
    require(matrix.rows() == size() && matrix.cols() == size(), solver, " analysed a matrix of ",
            size(), " x ", size(), ", got ", matrix.rows(), " x ", matrix.cols());
    const bool compressed = matrix.isCompressed();
    require(compressed && entries(matrix) == columns_.back(), solver, " analysed a pattern of ",
            columns_.back(), " entries, got ", entries(matrix),
            compressed ? "" : ", not compressed");
    require(size() == 0 || std::equal(columns_.begin(), columns_.end(), matrix.outerIndexPtr()),
            solver, " analysed another pattern of as many entries");
    factorised_ = false;
}

ANCF_INLINE void SolverStage::require_solvable(std::string_view solver, const VectorX& b) const {
    require(factorised_ && !columns_.empty(), solver,
            ": solve needs a factorisation that converged");
    require(b.size() == size(), solver, " factorised a matrix of ", size(), " x ", size(),
            ", got a right-hand side of ", b.size());
}

}  // namespace ancf::detail
