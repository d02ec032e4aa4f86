// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Moments and forces on the frame of a node: definitions.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/model/loads/frames.hpp>
#include <ancf/model/triad.hpp>
#include <ancf/types.hpp>

#include <complex>

namespace ancf {

ANCF_INLINE Moment::Moment(NodeId node, const VectorArgument<3>& moment, Attachment attachment)
    : node_(node), moment_(moment), attachment_(attachment) {
    detail::require(moment.allFinite(), "Moment: components must be finite, got ",
                    detail::components(moment));
}

ANCF_INLINE Coupling Moment::coupling() const {
    if (on_section_) return {{node_, Field::r_y}, {node_, Field::r_z}};
    return {{node_, Field::r_x}, {node_, Field::r_y}};
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
    Vector<Scalar, 3> moment;

    At(const Moment& load, const Vector<Scalar, 6>& slopes) {
        const Vector<Scalar, 3> first = slopes.template head<3>(),
                                second = slopes.template tail<3>();
        frame = load.on_section_ ? detail::Triad<Scalar>::of_section(first, second, load.share_)
                                 : detail::Triad<Scalar>::of_slopes(first, second);
        moment = load.attachment_ == Attachment::frame
                     ? frame.in_space(load.moment_)
                     : Vector<Scalar, 3>(load.moment_.template cast<Scalar>());
    }
};

template <class Scalar>
Vector<Scalar, 6> Moment::force(const Vector<Scalar, 6>& slopes) const {
    const At<Scalar> at(*this, slopes);
    return at.frame.on_slopes(at.moment);
}

ANCF_INLINE void Moment::evaluate(const LoadState& state, LoadResult& out) const {
    const At<double> at(*this, state.q);
    out.force = at.frame.on_slopes(at.moment);
    out.stiffness = detail::spin_derivative(at.frame, at.moment);
    if (attachment_ == Attachment::space) return;
    for (int j = 0; j < 6; ++j) {  // the moment turns too: dm = w x m
        const Vector<double, 3> spin = at.frame.spin.col(j), turned = cross(spin, at.moment);
        const Vector<double, 6> column = at.frame.on_slopes(turned);
        for (int i = 0; i < 6; ++i) out.stiffness(i, j) += column[i];
    }
}

ANCF_INLINE FollowerForce::FollowerForce(NodeId node, const VectorArgument<3>& force)
    : node_(node), force_(force) {
    detail::require(force.allFinite(), "FollowerForce: components must be finite, got ",
                    detail::components(force));
}

template <class Scalar>
Vector<Scalar, 3> FollowerForce::force(const Vector<Scalar, 6>& slopes) const {
    return detail::Triad<Scalar>::of_slopes(slopes).in_space(force_);
}

ANCF_INLINE void FollowerForce::evaluate(const LoadState& state, LoadResult& out) const {
    const Vector<double, 6> slopes = state.q.tail<6>();
    const auto frame = detail::Triad<double>::of_slopes(slopes);
    const Vector<double, 3> f = frame.in_space(force_);
    for (int k = 0; k < 3; ++k) out.force[k] = f[k];
    for (int j = 0; j < 6; ++j) {  // df = w x f
        const Vector<double, 3> turned = cross(Vector<double, 3>(frame.spin.col(j)), f);
        for (int i = 0; i < 3; ++i) out.stiffness(i, 3 + j) = turned[i];
    }
}

#if defined(ANCF_SOURCE)
template Vector<double, 6> Moment::force(const Vector<double, 6>&) const;
template Vector<std::complex<double>, 6> Moment::force(
    const Vector<std::complex<double>, 6>&) const;
template Vector<double, 3> FollowerForce::force(const Vector<double, 6>&) const;
template Vector<std::complex<double>, 3> FollowerForce::force(
    const Vector<std::complex<double>, 6>&) const;
#endif

}  // namespace ancf
