// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A plain vector of three scalars for kernels.
///
/// The scalar may be a double, a complex number or a pack of doubles. Unlike an expression library
/// it costs little to compile and nothing at -O2.

#pragma once

#include <ancf/types.hpp>

namespace ancf::detail {

using ancf::cross;  // not hidden by the overload below

template <class S>
struct Vec3 {
    S v[3];

    S& operator[](int k) noexcept { return v[k]; }
    const S& operator[](int k) const noexcept { return v[k]; }
};

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

/// A 3 x 3 block, column by column.
template <class S>
struct Block {
    S v[9];

    S& operator()(int row, int column) noexcept { return v[3 * column + row]; }
    const S& operator()(int row, int column) const noexcept { return v[3 * column + row]; }
};

}  // namespace ancf::detail
