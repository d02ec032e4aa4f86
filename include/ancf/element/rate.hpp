// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A scalar with its rate: what a kernel makes of it is exact along one direction of motion.
///
/// At e + (dt) v an element's strain is s + (dt) B v. Kernels take the deformation that stresses it
/// by deformation(strain, reference); for a Rate that is the strain rate alone, so that the rate of
/// the elastic force is B^T C B v, the force of Kelvin and Voigt, whatever the element:
/// docs/theory-damping.md.

#pragma once

#include <ancf/types.hpp>

#include <Eigen/Core>

#include <cmath>

namespace ancf::detail {

/// Returns what a strain is beyond that of the stress-free state.
template <class S, class T>
[[nodiscard]] inline S deformation(const S& strain, const T& reference) noexcept {
    return strain - reference;
}

/// A value and its derivative along one direction: a dual number. S may be a Rate itself.
template <class S>
struct Rate {
    S value;
    S rate;

    Rate() = default;
    Rate(double constant) noexcept : value(constant), rate(0.0) {}  // NOLINT: stands for a double
    Rate(const S& value_, const S& rate_) noexcept : value(value_), rate(rate_) {}

    friend Rate operator+(const Rate& a, const Rate& b) noexcept {
        return {a.value + b.value, a.rate + b.rate};
    }
    friend Rate operator-(const Rate& a, const Rate& b) noexcept {
        return {a.value - b.value, a.rate - b.rate};
    }
    friend Rate operator-(const Rate& a) noexcept { return {-a.value, -a.rate}; }
    friend Rate operator*(const Rate& a, const Rate& b) noexcept {
        return {a.value * b.value, a.value * b.rate + a.rate * b.value};
    }
    friend Rate operator/(const Rate& a, const Rate& b) noexcept {
        const S quotient = a.value / b.value;
        return {quotient, (a.rate - quotient * b.rate) / b.value};
    }
    Rate& operator+=(const Rate& b) noexcept { return *this = *this + b; }
    Rate& operator-=(const Rate& b) noexcept { return *this = *this - b; }
    Rate& operator*=(const Rate& b) noexcept { return *this = *this * b; }
    Rate& operator/=(const Rate& b) noexcept { return *this = *this / b; }

    friend Rate sqrt(const Rate& a) noexcept {
        using std::sqrt;
        const S root = sqrt(a.value);
        return {root, S(0.5) * a.rate / root};
    }
    friend Rate sin(const Rate& a) noexcept {
        using std::cos, std::sin;
        return {sin(a.value), a.rate * cos(a.value)};
    }
    friend Rate cos(const Rate& a) noexcept {
        using std::cos, std::sin;
        return {cos(a.value), -(a.rate * sin(a.value))};
    }
    friend Rate atan(const Rate& a) noexcept {
        using std::atan;
        return {atan(a.value), a.rate / (S(1.0) + a.value * a.value)};
    }

    /// Returns the strain rate in place of the strain.
    template <class T>
    friend Rate deformation(const Rate& strain, const T& /*reference*/) noexcept {
        return {S(0.0), strain.rate};
    }
};

/// Tells whether a scalar stands for strain rates.
template <class S>
inline constexpr bool is_rate = false;
template <class S>
inline constexpr bool is_rate<Rate<S>> = true;

}  // namespace ancf::detail

/// @cond
template <class S>
struct Eigen::NumTraits<ancf::detail::Rate<S>> : Eigen::GenericNumTraits<ancf::detail::Rate<S>> {
    using Real = ancf::detail::Rate<S>;
    using NonInteger = ancf::detail::Rate<S>;
    using Nested = ancf::detail::Rate<S>;
    using Literal = double;
    enum {
        IsComplex = 0,
        IsInteger = 0,
        IsSigned = 1,
        RequireInitialization = 1,
        ReadCost = 2,
        AddCost = 2,
        MulCost = 4
    };
};
/// @endcond
