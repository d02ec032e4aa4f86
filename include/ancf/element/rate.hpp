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

#include <ancf/element/dual.hpp>
#include <ancf/element/pack.hpp>
#include <ancf/types.hpp>

#include <Eigen/Core>

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
