// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A plain vector of three scalars for kernels, and the arctangent of such a scalar.
///
/// The scalar may be a double, a complex number or a pack of doubles. Unlike an expression library
/// it costs little to compile and nothing at -O2.

#pragma once

#include <ancf/types.hpp>

#include <array>
#include <cmath>
#include <complex>

namespace ancf::detail {

using ancf::cross;  // not hidden by the overload below

template <class S>
struct Vec3 {
    S v[3];

    S& operator[](int k) noexcept { return v[k]; }
    const S& operator[](int k) const noexcept { return v[k]; }
};

/// Returns three components of any vector, from one on.
template <class S, class V>
inline Vec3<S> vec3(const V& v, int first = 0) {
    return {{S(v[first]), S(v[first + 1]), S(v[first + 2])}};
}

/// Returns it as a vector of Eigen's.
template <class S>
[[nodiscard]] inline Vector<S, 3> to_vector(const Vec3<S>& a) noexcept {
    return {a[0], a[1], a[2]};
}

template <class S>
inline Vec3<S> operator+(const Vec3<S>& a, const Vec3<S>& b) noexcept {
    return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}

template <class S>
inline Vec3<S> operator-(const Vec3<S>& a, const Vec3<S>& b) noexcept {
    return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}

template <class T, class S>
inline Vec3<S> operator*(const T& factor, const Vec3<S>& a) noexcept {
    return {{factor * a[0], factor * a[1], factor * a[2]}};
}

template <class S, class T>
inline Vec3<S> operator/(const Vec3<S>& a, const T& divisor) noexcept {
    return {{a[0] / divisor, a[1] / divisor, a[2] / divisor}};
}

/// Adds factor * b.
template <class T, class S>
inline void add(Vec3<S>& a, const T& factor, const Vec3<S>& b) noexcept {
    for (int k = 0; k < 3; ++k) a[k] += factor * b[k];
}

template <class S>
inline S dot(const Vec3<S>& a, const Vec3<S>& b) noexcept {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class S>
inline Vec3<S> cross(const Vec3<S>& a, const Vec3<S>& b) noexcept {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

/// Returns the length, of a complex vector continued.
template <class S>
inline S length(const Vec3<S>& a) noexcept {
    using std::sqrt;
    return sqrt(dot(a, a));
}

/// Returns two unit vectors normal to a unit vector and to each other.
[[nodiscard]] inline std::array<Vec3<double>, 2> normals_of(const Vec3<double>& axis) noexcept {
    int smallest = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(axis[k]) < std::abs(axis[smallest])) smallest = k;
    Vec3<double> other = {};
    other[smallest] = 1.0;
    const Vec3<double> normal = cross(axis, other), u = normal / length(normal);
    return {u, cross(axis, u)};
}

/// A small matrix, square unless told otherwise, column by column.
template <class S, int Rows = 3, int Columns = Rows>
struct Block {
    S v[Rows * Columns];

    S& operator()(int row, int column) noexcept { return v[Rows * column + row]; }
    const S& operator()(int row, int column) const noexcept { return v[Rows * column + row]; }
};

/// Returns a b.
template <class A, class B>
inline auto operator*(const Block<A>& a, const Block<B>& b) noexcept {
    Block<decltype(a.v[0] * b.v[0])> out;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
            out(i, j) = a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j);
    return out;
}

/// Returns factor a.
template <class T, class S>
inline auto scaled(const T& factor, const Block<S>& a) noexcept {
    Block<decltype(factor * a.v[0])> out;
    for (int k = 0; k < 9; ++k) out.v[k] = factor * a.v[k];
    return out;
}

/// Returns the matrix [a]x of the vector product.
template <class S>
inline Block<S> cross_block(const Vec3<S>& a) noexcept {
    return {{S(0), a[2], -a[1], -a[2], S(0), a[0], a[1], -a[0], S(0)}};
}

/// Returns the arctangent.
template <class S>
inline S arctan(const S& x) noexcept {
    using std::atan;
    return atan(x);
}

/// Likewise for a complex step, to first order in the imaginary part: what a standard library
/// returns may have lost it.
inline std::complex<double> arctan(const std::complex<double>& z) noexcept {
    return {std::atan(z.real()), z.imag() / (1.0 + z.real() * z.real())};
}

}  // namespace ancf::detail
