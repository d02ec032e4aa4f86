// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/constants.hpp>
#include <ancf/model/loads/moments.hpp>
#include <ancf/model/triad.hpp>

#include <cmath>

namespace ancf {

namespace detail {

/// Writes the force m x a/|a|^2 on a slope and its derivative by a.
ANCF_INLINE void turn_slope(const Vec3<double>& m, const Vec3<double>& a, LoadResult& out) {
    const double square = dot(a, a);
    const auto turned = cross(m, a);
    const auto turn = cross_block(m);
    for (int i = 0; i < 3; ++i) {
        out.force[i] = turned[i] / square;
        for (int j = 0; j < 3; ++j)
            out.stiffness(i, j) = (turn(i, j) - 2.0 / square * turned[i] * a[j]) / square;
    }
}

}  // namespace detail

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

ANCF_INLINE void SlopeMoment::evaluate(const LoadState& state, LoadResult& out) const {
    const auto n = detail::vec3<double>(axis_), slope = detail::vec3<double>(state.q);
    const auto ap = slope - dot(n, slope) * n;
    detail::turn_slope(moment_ * n, ap, out);  // n x da = n x dap and ap.da = ap.dap
    // from the global axis e that leans least along n: u along n x e, w along n x (n x e)
    const auto [u, w] = detail::normals_of(n);
    out.potential = -moment_ * std::atan2(dot(ap, u), -dot(ap, w));
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

ANCF_INLINE void TangentMoment::evaluate(const LoadState& state, LoadResult& out) const {
    detail::turn_slope(detail::vec3<double>(moment_), detail::vec3<double>(state.q), out);
}

ANCF_INLINE void Moment::settle(const Layout& layout) {
    detail::require(layout.index({node_, Field::r_y}) >= 0, "Moment: node ", node_.index,
                    " carries no r_y; connect its elements before the moment is added, or take "
                    "TangentMoment for a node of cables");
    on_section_ = layout.index({node_, Field::r_z}) >= 0;
    share_ = layout.torsion_share(node_);
}

ANCF_INLINE void Moment::evaluate(const LoadState& state, LoadResult& out) const {
    const auto first = detail::vec3<double>(state.q), second = detail::vec3<double>(state.q, 3);
    const auto frame = on_section_ ? detail::Triad<double>::of_section(first, second, share_)
                                   : detail::Triad<double>::of_slopes(first, second);
    const auto given = detail::vec3<double>(moment_);
    const auto moment = attachment_ == Attachment::frame ? frame.in_space(given) : given;
    const auto& spin = frame.spin;
    const detail::Block<double, 6> by_slopes = detail::spin_derivative(frame, moment);
    for (int j = 0; j < 6; ++j) {
        out.force[j] = dot(spin[j], moment);
        detail::Vec3<double> turned = {};  // the moment turns too: dm = w x m
        if (attachment_ == Attachment::frame) turned = cross(spin[j], moment);
        for (int i = 0; i < 6; ++i) out.stiffness(i, j) = by_slopes(i, j) + dot(spin[i], turned);
    }
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

ANCF_INLINE void PlanarFollowerForce::evaluate(const LoadState& state, LoadResult& out) const {
    const double x = state.q[2];
    const double y = state.q[3];
    const double square = x * x + y * y, length = std::sqrt(square);
    out.force[0] = (force_[0] * x - force_[1] * y) / length;
    out.force[1] = (force_[0] * y + force_[1] * x) / length;
    for (int j = 0; j < 2; ++j) {  // df = (-f_y, f_x) (r_x x dr_x)/|r_x|^2
        const double turn = (j == 0 ? -y : x) / square;
        out.stiffness(0, 2 + j) = -turn * out.force[1];
        out.stiffness(1, 2 + j) = turn * out.force[0];
    }
}

}  // namespace ancf
