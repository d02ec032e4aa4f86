// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A scalar with its derivative along one direction: what kernels linearise strains with, and what
/// makes strain rates of them.
///
/// At e + (dt) v an element's strain is s + (dt) B v. Kernels take the deformation that stresses it
/// by deformation(strain, reference); for a Rate that is the strain rate alone, so that the rate of
/// the elastic force is B^T C B v, the force of Kelvin and Voigt, whatever the element:
/// docs/theory-damping.md.

#pragma once

#include <ancf/element/pack.hpp>
#include <ancf/element/vec3.hpp>
#include <ancf/types.hpp>

#include <Eigen/Core>

#include <cmath>
#include <type_traits>

namespace ancf {

/// A number a + eps b: f(a + eps b) = f(a) + eps f'(a) b with eps^2 = 0.
///
/// Exact, and cheaper than a Jacobian where one direction is all that is wanted:
/// docs/theory-statics.md, "Stresses as unknowns".
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

    /// @{
    /// By the product rule and its like.
    friend Dual operator+(const Dual& a, const Dual& b) noexcept {
        return {a.value + b.value, a.rate + b.rate};
    }
    friend Dual operator-(const Dual& a, const Dual& b) noexcept {
        return {a.value - b.value, a.rate - b.rate};
    }
    friend Dual operator*(const Dual& a, const Dual& b) noexcept {
        return {a.value * b.value, a.value * b.rate + a.rate * b.value};
    }
    friend Dual operator/(const Dual& a, const Dual& b) noexcept {
        const Base quotient = a.value / b.value;
        return {quotient, (a.rate - quotient * b.rate) / b.value};
    }
    friend Dual operator-(const Dual& a) noexcept { return {-a.value, -a.rate}; }
    Dual& operator+=(const Dual& b) noexcept { return *this = *this + b; }
    Dual& operator-=(const Dual& b) noexcept { return *this = *this - b; }
    Dual& operator*=(const Dual& b) noexcept { return *this = *this * b; }
    Dual& operator/=(const Dual& b) noexcept { return *this = *this / b; }
    /// @}

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
        return {detail::arctan(a.value), a.rate / (Base(1.0) + a.value * a.value)};
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

namespace ancf::detail {

/// Returns what a strain is beyond that of the stress-free state.
template <class S, class T>
[[nodiscard]] inline S deformation(const S& strain, const T& reference) noexcept {
    return strain - reference;
}

/// A number whose strains are strain rates. S may be a Rate itself.
template <class S>
using Rate = Dual<S, true>;

/// Returns the strain rate in place of the strain.
template <class S, class T>
[[nodiscard]] inline Rate<S> deformation(const Rate<S>& strain, const T& /*reference*/) noexcept {
    return {S(0.0), strain.rate};
}

/// Returns e + t v as Rate<S>, of S or double.
template <class S, class E, class V>
[[nodiscard]] auto moving(const E& e, const V& v) noexcept {
    Vector<Rate<S>, E::RowsAtCompileTime> result;
    for (int k = 0; k < result.size(); ++k) result[k] = {S(e[k]), S(v[k])};
    return result;
}

/// Returns coordinates with their change: what stresses of an earlier state are linearised along.
template <class S, int Size>
[[nodiscard]] Vector<Dual<S>, Size> course(const Vector<S, Size>& before,
                                           const Vector<S, Size>& change) noexcept {
    Vector<Dual<S>, Size> result;
    for (int k = 0; k < Size; ++k) result[k] = {before[k], change[k]};
    return result;
}

/// Returns the rates of a matrix times a factor.
template <class S, int Rows, int Columns>
[[nodiscard]] auto rates(double factor, const Matrix<Rate<S>, Rows, Columns>& x) noexcept {
    Matrix<S, Rows, Columns> result;
    for (int k = 0; k < x.size(); ++k) result.data()[k] = factor * x.data()[k].rate;
    return result;
}

/// Returns the matrix of a linear function of Vector<Pack<2>, Size>, two columns at a time. A
/// common motion of both nodes, which start with Dimension coordinates of position, gives zero.
template <int Dimension, int Size, class Function>
[[nodiscard]] Matrix<double, Size> columns(const Function& function) {
    Vector<Pack<2>, Size> unit = Vector<Pack<2>, Size>::Zero();
    Matrix<double, Size> result;
    for (int k = Dimension / 2 * 2; k < Size; k += 2) {
        for (const int lane : {0, 1}) unit[k + lane].set(lane, 1.0);
        const Vector<Pack<2>, Size> both = function(unit);
        for (const int lane : {0, 1}) {
            for (int i = 0; i < Size; ++i) result(i, k + lane) = both[i][lane];
            unit[k + lane] = 0.0;
        }
    }
    result.template leftCols<Dimension>() = -result.template middleCols<Dimension>(Size / 2);
    return result;
}

/// Returns the evaluation of e + t v, the transpose of `coupling` = B^T C dB/dt taken off the rate
/// of the tangent: what is left is the derivative of B^T C B v by e.
template <class Element, int Size>
[[nodiscard]] auto damped(const Element& element, const Vector<double, Size>& e,
                          const Vector<double, Size>& v, const Matrix<double, Size>& coupling) {
    auto at = element.evaluate(moving<double>(e, v));
    for (int j = 0; j < Size; ++j)
        for (int i = 0; i < Size; ++i) at.tangent(i, j).rate -= coupling(j, i);
    return at;
}

/// Tells whether a scalar stands for strain rates.
template <class S>
inline constexpr bool is_rate = false;
template <class S>
inline constexpr bool is_rate<Rate<S>> = true;

}  // namespace ancf::detail

/// @cond
template <class S>
struct Eigen::NumTraits<ancf::detail::Rate<S>>
    : ancf::detail::ScalarTraits<ancf::detail::Rate<S>, 2> {};
/// @endcond
