// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The factors of a chain with a border. The border is a few unknowns at the end, which may couple
/// with all others.
///
///     [ A  B^T ] [ x ]   [ b ]        S = C - B A^-1 B^T,     y = S^-1 (c - B A^-1 b),
///     [ B  C   ] [ y ] = [ c ]        x = A^-1 b - A^-1 B^T y
///
/// A is a chain, factorised by block_tridiagonal_kernel.hpp; S is dense and factorised with pivots.
/// This is accurate where A is well conditioned. In motion it is: A holds the masses. Each
/// factorisation is tested: the matrix times a known vector is solved for. The vector does not come
/// back where A is nearly singular or the matrix is not symmetric.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/list.hpp>
#include <ancf/solver/block_tridiagonal_layout.hpp>
#include <ancf/solver/dense_lu.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <complex>
#include <cstddef>

namespace ancf::detail {

/// Factorises matrices of doubles or of complex numbers, symmetric, in the pattern of all entries.
template <class Scalar>
class BorderedFactors {
public:
    /// Unknowns in the widest border.
    static constexpr int max_border = 24;

    /// Looks for the narrowest border that leaves a chain of the narrowest blocks.
    /// @param matrix  compressed, square, all entries; values do not matter.
    /// @return        false where no border does; the factors are of no use then.
    [[nodiscard]] bool analyze(const SparseMatrix& matrix) {
        pattern_ = matrix;
        return divide(0);
    }

    /// @param values  those of the pattern analysed.
    /// Widens the border where the chain has zeros on its diagonal: multipliers of its last nodes.
    /// @return        whether the factors solve the equations of these values.
    [[nodiscard]] bool factorize(const Scalar* values);

    /// Replaces a right-hand side by the solution.
    void solve(Scalar* x) const;

    /// Returns whether a matrix of the columns analysed has the rows analysed, too.
    [[nodiscard]] bool has_pattern(const SparseMatrix& matrix) const {
        const int* inner = pattern_.innerIndexPtr();
        return std::equal(inner, inner + detail::entries(pattern_), matrix.innerIndexPtr());
    }

    /// Number of values in the pattern.
    [[nodiscard]] std::size_t entries() const noexcept {
        return static_cast<std::size_t>(detail::entries(pattern_));
    }

private:
    struct Entry {
        int row, column, slot;  // slot: place among the values
    };

    [[nodiscard]] bool divide(int least_border);
    [[nodiscard]] int border_of(const Scalar* values) const;
    [[nodiscard]] bool factorize_chain(const Scalar* values);
    [[nodiscard]] bool factorize_border(const Scalar* values);
    [[nodiscard]] bool scale(const Scalar* values);
    [[nodiscard]] bool proves_right(const Scalar* values);

    int chain_ = 0, border_ = 0;  // numbers of unknowns
    SparseMatrix pattern_;        // of all entries
    BlockLayout layout_;
    List<int> chain_outer_, chain_inner_, chain_slots_;  // lower half of A
    List<Entry> across_, corner_;                        // B, and C; their rows counted from 0
    List<int> diagonal_;                                 // slots, -1: no entry
    List<Scalar> chain_values_, panels_;
    List<Scalar> columns_;   // A^-1 B^T
    DenseLu<Scalar> small_;  // of S
    List<double> scales_;    // of the unknowns, by which the diagonal of A becomes one
    List<Scalar> probe_;
    VectorX roots_, load_;  // what the kernel of doubles leaves beside its factors
};

#if defined(ANCF_COMPILED)
extern template class BorderedFactors<double>;
extern template class BorderedFactors<std::complex<double>>;
#endif

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/solver/bordered_factors.ipp>
#endif
