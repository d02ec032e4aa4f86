// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Moments on one slope: definitions.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/constants.hpp>
#include <ancf/error.hpp>
#include <ancf/model/loads/moments.hpp>
#include <ancf/model/triad.hpp>

#include <cmath>
#include <complex>

namespace ancf {

ANCF_INLINE SlopeMoment::SlopeMoment(NodeId node, Field slope, const VectorArgument<3>& axis,
                                     double moment)
    : node_(node), slope_(slope), axis_(axis), moment_(moment) {
    detail::require_slope("SlopeMoment", slope, 3);
    const double length = detail::span(axis);
    detail::require(std::isfinite(length) && length > 0.0,
                    "SlopeMoment: the axis must have a length, got ", detail::components(axis));
    axis_ /= length;
    detail::require_finite("SlopeMoment: moment", moment);
}

template <class Scalar>
Vector<Scalar, 3> SlopeMoment::force(const Vector<Scalar, 3>& slope) const {
    const Vector<Scalar, 3> n = axis_.cast<Scalar>();
    const Vector<Scalar, 3> ap = slope - Scalar(n.transpose() * slope) * n;
    return moment_ / Scalar(ap.transpose() * ap) * cross(n, ap);
}

ANCF_INLINE void SlopeMoment::evaluate(const LoadState& state, LoadResult& out) const {
    const Vector<double, 3> slope = state.q, ap = slope - axis_.dot(slope) * axis_;
    const double square = ap.squaredNorm(), scale = moment_ / square;
    const Vector<double, 3> turned = cross(axis_, ap);
    // ap and turned are normal to the axis: n x dap - 2 turned (ap.dap)/|ap|^2
    const Matrix<double, 3> turn = cross_matrix(axis_);
    for (int i = 0; i < 3; ++i) {
        out.force[i] = scale * turned[i];
        for (int j = 0; j < 3; ++j)
            out.stiffness(i, j) = scale * (turn(i, j) - 2.0 / square * turned[i] * ap[j]);
    }
    // the angle from the global axis e that leans least along n: ap.e and ap.(n x e)
    int across = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(axis_[i]) < std::abs(axis_[across])) across = i;
    const Vector<double, 3> ahead = turn.col(across);
    out.potential = -moment_ * std::atan2(ap.dot(ahead), ap[across]);
    out.period = 2.0 * pi * std::abs(moment_);
}

ANCF_INLINE PlanarSlopeMoment::PlanarSlopeMoment(NodeId node, Field slope, double moment)
    : node_(node), slope_(slope), moment_(moment) {
    detail::require_slope("PlanarSlopeMoment", slope, 2);
    detail::require_finite("PlanarSlopeMoment: moment", moment);
}

template <class Scalar>
Vector<Scalar, 2> PlanarSlopeMoment::force(const Vector<Scalar, 2>& slope) const {
    return moment_ / Scalar(slope.transpose() * slope) * Vector<Scalar, 2>(-slope[1], slope[0]);
}

ANCF_INLINE void PlanarSlopeMoment::evaluate(const LoadState& state, LoadResult& out) const {
    const Vector<double, 2> slope = state.q;
    const double x = slope[0];
    const double y = slope[1];
    const double scale = moment_ / (slope.squaredNorm() * slope.squaredNorm());
    out.force = force(slope);
    out.stiffness << 2.0 * scale * x * y, scale * (y * y - x * x), scale * (y * y - x * x),
        -2.0 * scale * x * y;
    out.potential = -moment_ * std::atan2(y, x);
    out.period = 2.0 * pi * std::abs(moment_);
}

ANCF_INLINE TangentMoment::TangentMoment(NodeId node, const VectorArgument<3>& moment)
    : node_(node), moment_(moment) {
    detail::require(moment.allFinite(), "TangentMoment: components must be finite, got ",
                    detail::components(moment));
}

template <class Scalar>
Vector<Scalar, 3> TangentMoment::force(const Vector<Scalar, 3>& slope) const {
    return cross(Vector<Scalar, 3>(moment_.cast<Scalar>()), slope) /
           Scalar(slope.transpose() * slope);
}

ANCF_INLINE void TangentMoment::evaluate(const LoadState& state, LoadResult& out) const {
    const Vector<double, 3> slope = state.q;
    const double square = slope.squaredNorm();
    const Vector<double, 3> turned = cross(moment_, slope);
    const Matrix<double, 3> turn = cross_matrix(moment_);
    for (int i = 0; i < 3; ++i) {
        out.force[i] = turned[i] / square;
        for (int j = 0; j < 3; ++j)
            out.stiffness(i, j) = (turn(i, j) - 2.0 / square * turned[i] * slope[j]) / square;
    }
}

#if defined(ANCF_SOURCE)
template Vector<double, 3> SlopeMoment::force(const Vector<double, 3>&) const;
template Vector<std::complex<double>, 3> SlopeMoment::force(
    const Vector<std::complex<double>, 3>&) const;
template Vector<double, 2> PlanarSlopeMoment::force(const Vector<double, 2>&) const;
template Vector<std::complex<double>, 2> PlanarSlopeMoment::force(
    const Vector<std::complex<double>, 2>&) const;
template Vector<double, 3> TangentMoment::force(const Vector<double, 3>&) const;
template Vector<std::complex<double>, 3> TangentMoment::force(
    const Vector<std::complex<double>, 3>&) const;
#endif

}  // namespace ancf
