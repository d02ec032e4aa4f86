// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/model/loads/springs.hpp>

#include <cmath>
#include <complex>

namespace ancf {

template <int Dimension>
template <class Scalar>
DynamicVector<Scalar> Spring<Dimension>::force(const DynamicVector<Scalar>& q) const {
    using std::sqrt;
    const Vector<Scalar, Dimension> d = points_.difference(q, Scalar(0.0));
    Scalar tension_per_length = stiffness_;
    if (length_ > 0.0) tension_per_length *= 1.0 - length_ / sqrt(detail::product(d, d));
    return points_.generalised_force(Vector<Scalar, Dimension>(-tension_per_length * d));
}

template <int Dimension>
void Spring<Dimension>::evaluate(const LoadState& state, LoadResult& out) const {
    out.force = force(state.q);
    const Vector<double, Dimension> d = points_.difference(state.q, 0.0);
    const double distance = std::sqrt(detail::product(d, d));
    const double extension = distance - length_;
    out.potential = 0.5 * stiffness_ * extension * extension;
    if (!state.derivatives) return;
    Matrix<double, Dimension> block = -stiffness_ * Matrix<double, Dimension>::Identity();
    if (length_ > 0.0) {
        const Vector<double, Dimension> n = d / distance;
        block += stiffness_ * length_ / distance *
                 (Matrix<double, Dimension>::Identity() - n * n.transpose());
    }
    points_.add_block(block, out.stiffness);
}

template <int Dimension>
template <class Scalar>
DynamicVector<Scalar> Damper<Dimension>::force(const DynamicVector<Scalar>& q,
                                               const DynamicVector<Scalar>& v) const {
    const Vector<Scalar, Dimension> d = points_.difference(q, Scalar(0.0)), w = points_.moved(v);
    const Scalar rate = detail::product(d, w) / detail::product(d, d);
    return points_.generalised_force(Vector<Scalar, Dimension>(-damping_ * rate * d));
}

template <int Dimension>
void Damper<Dimension>::evaluate(const LoadState& state, LoadResult& out) const {
    out.force = force(state.q, state.v);
    if (!state.derivatives) return;
    const Vector<double, Dimension> d = points_.difference(state.q, 0.0),
                                    w = points_.moved(state.v);
    const double square = detail::product(d, d), rate = detail::product(d, w) / square;
    const Vector<double, Dimension> turn = (w - 2.0 * rate * d) / square;
    const Matrix<double, Dimension> identity = Matrix<double, Dimension>::Identity();
    points_.add_block(-damping_ * (rate * identity + d * turn.transpose()), out.stiffness);
    points_.add_block(-damping_ / square * d * d.transpose(), out.damping);
}

#if defined(ANCF_SOURCE)
#define ANCF_SPRING_FORCES(Dimension, Scalar)                                                    \
    template DynamicVector<Scalar> Spring<Dimension>::force(const DynamicVector<Scalar>&) const; \
    template DynamicVector<Scalar> Damper<Dimension>::force(const DynamicVector<Scalar>&,        \
                                                            const DynamicVector<Scalar>&) const;
#define ANCF_SPRING_INSTANCES(Dimension)  \
    template class Spring<Dimension>;     \
    template class Damper<Dimension>;     \
    ANCF_SPRING_FORCES(Dimension, double) \
    ANCF_SPRING_FORCES(Dimension, std::complex<double>)
ANCF_SPRING_INSTANCES(2)
ANCF_SPRING_INSTANCES(3)
#endif

}  // namespace ancf
