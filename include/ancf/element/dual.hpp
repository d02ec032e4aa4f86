// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A value with its derivative along one direction: what kernels linearise strains with.
///
/// f(a + eps b) = f(a) + eps f'(a) b with eps^2 = 0. Exact, and cheaper than a Jacobian where one
/// direction is all that is wanted: docs/theory-statics.md, "Stresses as unknowns".

#pragma once

#include <cmath>
#include <type_traits>

namespace ancf {

/// A number a + eps b.
/// @tparam Base   any scalar, a Dual too
/// @tparam Rates  whether kernels take strain rates of it in place of strains: element/rate.hpp
template <class Base, bool Rates = false>
struct Dual {
    Base value;  ///< a
    Base rate;   ///< b, the derivative along the direction

    Dual() = default;
    /// Makes a + eps b.
    Dual(const Base& a, const Base& b) noexcept : value(a), rate(b) {}

    /// Makes a constant.
    template <class T, class = std::enable_if_t<std::is_convertible_v<T, Base>>>
    Dual(const T& constant) noexcept : value(constant), rate(0.0) {}  // NOLINT: meant

    /// Makes the same number of every lane of a wider base.
    template <class T, class = std::enable_if_t<!std::is_same_v<T, Base>>>
    explicit Dual(const Dual<T, Rates>& other) noexcept : value(other.value), rate(other.rate) {}

    /// By the product rule and its like.
    friend Dual operator+(const Dual& a, const Dual& b) noexcept {
        return {a.value + b.value, a.rate + b.rate};
    }
    /// By the product rule and its like.
    friend Dual operator-(const Dual& a, const Dual& b) noexcept {
        return {a.value - b.value, a.rate - b.rate};
    }
    /// By the product rule and its like.
    friend Dual operator*(const Dual& a, const Dual& b) noexcept {
        return {a.value * b.value, a.value * b.rate + a.rate * b.value};
    }
    /// By the product rule and its like.
    friend Dual operator/(const Dual& a, const Dual& b) noexcept {
        const Base quotient = a.value / b.value;
        return {quotient, (a.rate - quotient * b.rate) / b.value};
    }
    /// By the product rule and its like.
    friend Dual operator-(const Dual& a) noexcept { return {-a.value, -a.rate}; }
    /// By the product rule and its like.
    Dual& operator+=(const Dual& b) noexcept { return *this = *this + b; }
    /// By the product rule and its like.
    Dual& operator-=(const Dual& b) noexcept { return *this = *this - b; }
    /// By the product rule and its like.
    Dual& operator*=(const Dual& b) noexcept { return *this = *this * b; }
    /// By the product rule and its like.
    Dual& operator/=(const Dual& b) noexcept { return *this = *this / b; }

    /// Returns the square root and its rate.
    friend Dual sqrt(const Dual& a) noexcept {
        using std::sqrt;
        const Base root = sqrt(a.value);
        return {root, Base(0.5) * a.rate / root};
    }
    /// Returns the cosine and its rate.
    friend Dual cos(const Dual& a) noexcept {
        using std::cos;
        using std::sin;
        return {cos(a.value), -a.rate * sin(a.value)};
    }
    /// Returns the sine and its rate.
    friend Dual sin(const Dual& a) noexcept {
        using std::cos;
        using std::sin;
        return {sin(a.value), a.rate * cos(a.value)};
    }
    /// Returns the angle and its rate.
    friend Dual atan(const Dual& a) noexcept {
        using std::atan;
        return {atan(a.value), a.rate / (Base(1.0) + a.value * a.value)};
    }
};

namespace detail {

/// Returns what a linearised quantity reaches at the end of its change.
template <class S>
[[nodiscard]] inline S arrived(const Dual<S>& course) noexcept {
    return course.value + course.rate;
}

}  // namespace detail
}  // namespace ancf
