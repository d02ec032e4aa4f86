// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/constants.hpp>
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

ANCF_INLINE void Moment::settle(const Layout& layout) {
    detail::require(layout.index({node_, Field::r_y}) >= 0, "Moment: node ", node_.index,
                    " carries no r_y; connect its elements before the moment is added, or take "
                    "TangentMoment for a node of cables");
    on_section_ = layout.index({node_, Field::r_z}) >= 0;
    share_ = layout.torsion_share(node_);
}

template <class Scalar>
struct Moment::At {
    detail::Triad<Scalar> frame;
    detail::Vec3<Scalar> moment;

    template <class Slopes>
    At(const Moment& load, const Slopes& slopes) {
        const auto first = detail::vec3<Scalar>(slopes), second = detail::vec3<Scalar>(slopes, 3);
        frame = load.on_section_ ? detail::Triad<Scalar>::of_section(first, second, load.share_)
                                 : detail::Triad<Scalar>::of_slopes(first, second);
        const auto given = detail::vec3<double>(load.moment_);
        moment = load.attachment_ == Attachment::frame ? frame.in_space(given)
                                                       : detail::vec3<Scalar>(given);
    }
};

template <class Scalar>
Vector<Scalar, 6> Moment::force(const Vector<Scalar, 6>& slopes) const {
    const At<Scalar> at(*this, slopes);
    Vector<Scalar, 6> out;
    for (int k = 0; k < 6; ++k) out[k] = dot(at.frame.spin[k], at.moment);
    return out;
}

ANCF_INLINE void Moment::evaluate(const LoadState& state, LoadResult& out) const {
    const At<double> at(*this, state.q);
    const auto& spin = at.frame.spin;
    const detail::Block<double, 6> by_slopes = detail::spin_derivative(at.frame, at.moment);
    for (int j = 0; j < 6; ++j) {
        out.force[j] = dot(spin[j], at.moment);
        detail::Vec3<double> turned = {};  // the moment turns too: dm = w x m
        if (attachment_ == Attachment::frame) turned = cross(spin[j], at.moment);
        for (int i = 0; i < 6; ++i) out.stiffness(i, j) = by_slopes(i, j) + dot(spin[i], turned);
    }
}

template <class Scalar>
Vector<Scalar, 3> FollowerForce::force(const Vector<Scalar, 6>& slopes) const {
    const auto frame = detail::Triad<Scalar>::of_slopes(detail::vec3<Scalar>(slopes),
                                                        detail::vec3<Scalar>(slopes, 3));
    const auto f = frame.in_space(detail::vec3<double>(force_));
    return {f[0], f[1], f[2]};
}

ANCF_INLINE void FollowerForce::evaluate(const LoadState& state, LoadResult& out) const {
    const auto frame = detail::Triad<double>::of_slopes(detail::vec3<double>(state.q, 3),
                                                        detail::vec3<double>(state.q, 6));
    const auto f = frame.in_space(detail::vec3<double>(force_));
    for (int k = 0; k < 3; ++k) out.force[k] = f[k];
    for (int j = 0; j < 6; ++j) {  // df = w x f
        const detail::Vec3<double> turned = cross(frame.spin[j], f);
        for (int i = 0; i < 3; ++i) out.stiffness(i, 3 + j) = turned[i];
    }
}

#if defined(ANCF_SOURCE)
#define ANCF_MOMENT_FORCES(Load, out, in)                                      \
    template Vector<double, out> Load::force(const Vector<double, in>&) const; \
    template Vector<std::complex<double>, out> Load::force(                    \
        const Vector<std::complex<double>, in>&) const;
ANCF_MOMENT_FORCES(SlopeMoment, 3, 3)
ANCF_MOMENT_FORCES(PlanarSlopeMoment, 2, 2)
ANCF_MOMENT_FORCES(TangentMoment, 3, 3)
ANCF_MOMENT_FORCES(Moment, 6, 6)
ANCF_MOMENT_FORCES(FollowerForce, 3, 6)
#endif

}  // namespace ancf
