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
    for (int k = 0; k < 3; ++k) axis_[k] /= length;
    detail::require_finite("SlopeMoment: moment", moment);
}

template <class Scalar>
Vector<Scalar, 3> SlopeMoment::force(const Vector<Scalar, 3>& slope) const {
    const auto n = detail::vec3<Scalar>(axis_), a = detail::vec3<Scalar>(slope);
    const auto ap = a - dot(n, a) * n, f = moment_ / dot(ap, ap) * cross(n, ap);
    return {f[0], f[1], f[2]};
}

ANCF_INLINE void SlopeMoment::evaluate(const LoadState& state, LoadResult& out) const {
    const auto n = detail::vec3<double>(axis_), slope = detail::vec3<double>(state.q);
    const auto ap = slope - dot(n, slope) * n, turned = cross(n, ap);
    const double square = dot(ap, ap), scale = moment_ / square;
    // ap and turned are normal to the axis: n x dap - 2 turned (ap.dap)/|ap|^2
    const auto turn = detail::cross_block(n);
    for (int i = 0; i < 3; ++i) {
        out.force[i] = scale * turned[i];
        for (int j = 0; j < 3; ++j)
            out.stiffness(i, j) = scale * (turn(i, j) - 2.0 / square * turned[i] * ap[j]);
    }
    // the angle from the global axis e that leans least along n: ap.e and ap.(n x e)
    int across = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(n[i]) < std::abs(n[across])) across = i;
    detail::Vec3<double> zero_angle = {};
    zero_angle[across] = 1.0;
    out.potential = -moment_ * std::atan2(dot(ap, cross(n, zero_angle)), ap[across]);
    out.period = 2.0 * pi * std::abs(moment_);
}

ANCF_INLINE PlanarSlopeMoment::PlanarSlopeMoment(NodeId node, Field slope, double moment)
    : node_(node), slope_(slope), moment_(moment) {
    detail::require_slope("PlanarSlopeMoment", slope, 2);
    detail::require_finite("PlanarSlopeMoment: moment", moment);
}

template <class Scalar>
Vector<Scalar, 2> PlanarSlopeMoment::force(const Vector<Scalar, 2>& slope) const {
    const Scalar scale = moment_ / (slope[0] * slope[0] + slope[1] * slope[1]);
    return {-scale * slope[1], scale * slope[0]};
}

ANCF_INLINE void PlanarSlopeMoment::evaluate(const LoadState& state, LoadResult& out) const {
    const double x = state.q[0];
    const double y = state.q[1];
    const double square = x * x + y * y, scale = moment_ / (square * square);
    out.force[0] = -moment_ / square * y;
    out.force[1] = moment_ / square * x;
    out.stiffness(0, 0) = 2.0 * scale * x * y;
    out.stiffness(1, 1) = -out.stiffness(0, 0);
    out.stiffness(0, 1) = out.stiffness(1, 0) = scale * (y * y - x * x);
    out.potential = -moment_ * std::atan2(y, x);
    out.period = 2.0 * pi * std::abs(moment_);
}

ANCF_INLINE TangentMoment::TangentMoment(NodeId node, const VectorArgument<3>& moment)
    : node_(node), moment_(moment) {
    detail::require(detail::all_finite(moment), "TangentMoment: components must be finite, got ",
                    detail::components(moment));
}

template <class Scalar>
Vector<Scalar, 3> TangentMoment::force(const Vector<Scalar, 3>& slope) const {
    const auto a = detail::vec3<Scalar>(slope),
               f = cross(detail::vec3<Scalar>(moment_), a) / dot(a, a);
    return {f[0], f[1], f[2]};
}

ANCF_INLINE void TangentMoment::evaluate(const LoadState& state, LoadResult& out) const {
    const auto slope = detail::vec3<double>(state.q), m = detail::vec3<double>(moment_);
    const double square = dot(slope, slope);
    const auto turned = cross(m, slope);
    const auto turn = detail::cross_block(m);
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
