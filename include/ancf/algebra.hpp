// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Sums, products and parts of vectors and sparse matrices as plain loops.
///
/// Each says what one expression of Eigen would, and costs a program far less to compile: for what
/// runs once, or costs little beside the elements and the factorisation.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/list.hpp>
#include <ancf/types.hpp>

#include <cmath>

namespace ancf::detail {

/// Writes the entries of x at these places.
void gather(const VectorX& x, const List<int>& at, VectorX& out);

/// Returns the largest |x_i| / scale_i, 0 of none and NaN where an entry is NaN.
[[nodiscard]] double largest_ratio(const VectorX& x, const VectorX& scale);

/// Returns the largest |x_i|, 0 of none and NaN where an entry is NaN.
[[nodiscard]] double largest_magnitude(const VectorX& x) noexcept;

/// Returns A x.
[[nodiscard]] VectorX multiply(const MatrixX& A, const VectorX& x);

/// L D L^T of a small matrix that is symmetric and positive definite, without square roots.
template <int Size>
class SmallCholesky {
public:
    SmallCholesky() = default;

    explicit SmallCholesky(const Matrix<double, Size>& matrix) : factors_(matrix) {
        for (int k = 0; k < Size; ++k) {
            const double over = 1.0 / factors_(k, k);
            for (int i = k + 1; i < Size; ++i) {
                const double share = factors_(i, k) * over;
                for (int j = k + 1; j <= i; ++j) factors_(i, j) -= share * factors_(j, k);
            }
            for (int i = k + 1; i < Size; ++i) factors_(i, k) *= over;
            factors_(k, k) = over;
        }
    }

    /// Tells whether the matrix is positive definite and finite.
    [[nodiscard]] bool definite() const {
        bool good = true;
        for (int k = 0; k < Size; ++k)
            good = good && factors_(k, k) > 0.0 && std::isfinite(factors_(k, k));
        return good;
    }

    /// Returns the solution of matrix x = b.
    [[nodiscard]] Vector<double, Size> solve(const Vector<double, Size>& b) const {
        Vector<double, Size> x = b;
        for (int i = 1; i < Size; ++i)
            for (int j = 0; j < i; ++j) x[i] -= factors_(i, j) * x[j];
        for (int i = Size - 1; i >= 0; --i) {
            x[i] *= factors_(i, i);
            for (int j = i + 1; j < Size; ++j) x[i] -= factors_(j, i) * x[j];
        }
        return x;
    }

private:
    Matrix<double, Size> factors_;  // L below the diagonal, the inverse of D on it
};

/// Returns how many entries a compressed matrix stores.
[[nodiscard]] inline int entries(const SparseMatrix& A) noexcept {
    return A.outerIndexPtr()[A.outerSize()];
}

/// Adds scale A x, A compressed, x and out apart; of lower storage A holds the lower half alone.
///
/// x may be longer or shorter than A is wide: what it lacks is zero, and `out` gets as many rows as
/// it has.
void add_product(const SparseMatrix& A, Storage storage, double scale, const VectorX& x,
                 VectorX& out);

/// Returns A x, of as many rows as x; see add_product.
[[nodiscard]] VectorX multiply(const SparseMatrix& A, Storage storage, const VectorX& x);

/// Returns both halves of the first rows and columns of a compressed matrix, without the zeros; of
/// lower storage it holds the lower half alone.
[[nodiscard]] SparseMatrix leading_block(const SparseMatrix& A, int size, Storage storage);

/// Replaces a compressed matrix of symmetric pattern by its symmetric part.
void symmetrise(SparseMatrix& A);

/// True unless a stored value of a compressed matrix is a NaN or an infinity.
[[nodiscard]] bool all_finite(const SparseMatrix& matrix) noexcept;

/// Returns 2^exponent, the exponent held within 1000 of 0.
[[nodiscard]] double power_of_two(int exponent) noexcept;

/// Completes the roots of the diagonal of a symmetric matrix [A G^T; G 0], of either storage, where
/// they are 0. There the largest scaled entry, |a_ij|/(r_i r_j), becomes `one`, as the diagonal is.
///
/// Likewise where a diagonal is below a hundredth of the largest entry beside it and one of these,
/// so scaled, is above 1024 times `one`, or where an equation of G ties it to a root 2^20 times as
/// large: it is round-off. A root only grows. If nothing tells: 1.
void complete_roots(const SparseMatrix& matrix, double one, VectorX& roots);

/// Returns scales of the unknowns of a symmetric matrix [A G^T; G 0], of either storage: powers of
/// two that the units of lengths, masses and times multiply, up to one factor for all, by powers of
/// two that are exact.
///
/// That is 2^-floor((e_i - e_0)/2), e the exponent of a_ii, completed by complete_roots().
[[nodiscard]] VectorX unit_scales(const SparseMatrix& matrix);

/// Returns scales of the rows of a square matrix, powers of two that bring the largest entry of
/// each row into [1, 2) where its unknowns are measured by `columns`; 1 for rows of zeros.
///
/// With the unit_scales of a scene's tangent they depend on no unit, and so does which entries of a
/// column count as large.
[[nodiscard]] VectorX row_scales(const SparseMatrix& matrix, const VectorX& columns);

/// Returns a copy of a compressed matrix.
[[nodiscard]] SparseMatrix copied(const SparseMatrix& A);

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/algebra.ipp>  // IWYU pragma: export
#endif
