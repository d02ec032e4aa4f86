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
    detail::require(detail::all_finite(moment), "Moment: components must be finite, got ",
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

ANCF_INLINE FollowerForce::FollowerForce(NodeId node, const VectorArgument<3>& force)
    : node_(node), force_(force) {
    detail::require(detail::all_finite(force), "FollowerForce: components must be finite, got ",
                    detail::components(force));
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
template Vector<double, 6> Moment::force(const Vector<double, 6>&) const;
template Vector<std::complex<double>, 6> Moment::force(
    const Vector<std::complex<double>, 6>&) const;
template Vector<double, 3> FollowerForce::force(const Vector<double, 6>&) const;
template Vector<std::complex<double>, 3> FollowerForce::force(
    const Vector<std::complex<double>, 6>&) const;
#endif

}  // namespace ancf
