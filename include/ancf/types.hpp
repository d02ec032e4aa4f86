// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Names for the Eigen types that the whole library shares.
///
/// Everything is column-major, also under EIGEN_DEFAULT_TO_ROW_MAJOR, and of SI units unless a
/// function says otherwise. Eigen wants single rows row-major.

#pragma once

#include <ancf/compiled.hpp>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <limits>
#include <type_traits>

namespace ancf {

/// A column of fixed size.
template <class Scalar, int Rows>
using Vector = Eigen::Matrix<Scalar, Rows, 1>;

/// A matrix of fixed size, square unless told otherwise.
template <class Scalar, int Rows, int Columns = Rows>
using Matrix = Eigen::Matrix<Scalar, Rows, Columns,
                             Rows == 1 && Columns != 1 ? Eigen::RowMajor : Eigen::ColMajor>;

/// A column of any size.
template <class Scalar>
using DynamicVector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

/// A matrix of any size.
template <class Scalar>
using DynamicMatrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor>;

using VectorX = Eigen::VectorXd;        ///< a column of any size
using MatrixX = DynamicMatrix<double>;  ///< a matrix of any size

/// Compressed columns with 32-bit indices: what CHOLMOD and UMFPACK take without a copy.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/// Which part of a sparse matrix is stored: `lower` of a symmetric one, or all of any.
enum class Storage { lower, full };

namespace detail {

/// An object of a type, to name what its members return; it is never made.
template <class T>
[[nodiscard]] const T& some() noexcept;

/// Whether the type `Members<T>` exists: whether T has the members that it is made of.
template <template <class> class Members, class T, class = void>
inline constexpr bool offers = false;
template <template <class> class Members, class T>
inline constexpr bool offers<Members, T, std::void_t<Members<T>>> = true;

/// Returns the length of a vector whose components may be as small or large as numbers are.
template <int Dimension>
[[nodiscard]] double span(const Vector<double, Dimension>& v) {
    if constexpr (Dimension == 2) {
        return std::hypot(v[0], v[1]);
    } else {
        return std::hypot(v[0], v[1], v[2]);
    }
}

/// True unless a component of a vector or matrix is a NaN or an infinity.
template <class Plain>
[[nodiscard]] bool all_finite(const Plain& x) noexcept {
    Eigen::Index others = 0;  // a count as wide as a number: several are looked at in one go
    for (Eigen::Index k = 0; k < x.size(); ++k)
        others += !(std::abs(x.data()[k]) <= std::numeric_limits<double>::max());
    return others == 0;
}

/// Returns a.b of two or three components, without conjugates.
template <class S, int D>
[[nodiscard]] inline S product(const Vector<S, D>& a, const Vector<S, D>& b) noexcept {
    if constexpr (D == 3)
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    else
        return a[0] * b[0] + a[1] * b[1];
}

}  // namespace detail

/// Returns the vector product; unlike Eigen's it needs no header for geometry.
template <class Scalar>
[[nodiscard]] Vector<Scalar, 3> cross(const Vector<Scalar, 3>& a, const Vector<Scalar, 3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace ancf
