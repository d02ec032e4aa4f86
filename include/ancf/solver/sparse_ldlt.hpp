// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// L D L^T of a sparse symmetric matrix in plain loops, for signs of pivots and systems beside the
/// tangent: it costs a program little to compile.
///
/// Row by row along the elimination tree [Davis, ACM Trans. Math. Softw. 31 (2005), Algorithm 849],
/// after minimum degree on blocks of rows; without pivoting.

#pragma once

#include <ancf/assembly/numbering.hpp>
#include <ancf/compiler.hpp>
#include <ancf/list.hpp>
#include <ancf/types.hpp>

#include <cstddef>

namespace ancf::detail {

/// One value of a matrix.
struct MatrixEntry {
    int row;
    int column;
    double value;
};

/// Returns the compressed matrix of entries, those of one place added in their order.
[[nodiscard]] SparseMatrix compressed(int size, const List<MatrixEntry>& entries);

/// Returns the block of each of the first equations: a node, a constraint.
[[nodiscard]] List<int> blocks_of(const Numbering& numbering, int equations);

/// Factorises a symmetric matrix, definite or not. Of the same pattern again it keeps the order,
/// and the rows of L before the first one that has another value.
class SparseLdlt {
public:
    /// @param lower   compressed, with the lower half or more: what is above the diagonal is left
    ///                aside.
    /// @param blocks  of each row its block, from 0: a node. Rows of one block stay together.
    /// @param last    how many of the last rows wait, with their blocks.
    /// @param to_end  whether they wait for all other rows, or each for those that it has entries
    ///                with.
    /// @return        false where a pivot is zero or not finite; no solution may then be asked for.
    [[nodiscard]] bool factorize(const SparseMatrix& lower, const List<int>& blocks, int last = 0,
                                 bool to_end = true);

    /// Returns the number of rows.
    [[nodiscard]] int size() const noexcept { return static_cast<int>(order_.size()); }

    /// Returns the number of entries below the diagonal of L.
    [[nodiscard]] int fill() const noexcept { return static_cast<int>(row_.size()); }

    /// Returns the pivot of a row of the matrix.
    [[nodiscard]] double pivot(int row) const { return pivots_[place_[row]]; }

    /// Solves A x = b in place.
    void solve(VectorX& x) const;

private:
    void order(const SparseMatrix& lower);
    void permute(const int* outer);
    void analyze();
    [[nodiscard]] int take_values(const double* values);
    [[nodiscard]] bool eliminate(int from);

    List<int> blocks_, outer_, inner_;  // the pattern whose order is known
    int last_ = 0;                      // rows that wait,
    bool to_end_ = true;                // for all others
    bool complete_ = false;             // whether L belongs to the values
    List<int> order_, place_;           // row at a place, place of a row
    // of the permuted matrix the upper half, by columns
    List<std::size_t> upper_first_;
    List<int> upper_row_, from_;  // from_: place among the matrix's values
    List<double> upper_value_;
    List<int> parent_;  // in the elimination tree, -1 for a root
    // L below its diagonal, by columns
    List<std::size_t> first_;
    List<int> row_, matrix_row_;  // places, and the rows of the matrix that stand there
    List<double> value_;
    List<double> pivots_;
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/solver/sparse_ldlt.ipp>
#endif
