// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/model/loads/springs.hpp>

#include <cmath>

namespace ancf {

template <int Dimension>
void Spring<Dimension>::evaluate(const LoadState& state, LoadResult& out) const {
    const Vector<double, Dimension> d = points_.difference(state.q, 0.0);
    const double distance = std::sqrt(detail::product(d, d));
    double tension_per_length = stiffness_;
    if (length_ > 0.0) tension_per_length *= 1.0 - length_ / distance;
    out.force = points_.generalised_force(-tension_per_length * d);
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
void Damper<Dimension>::evaluate(const LoadState& state, LoadResult& out) const {
    const Vector<double, Dimension> d = points_.difference(state.q, 0.0),
                                    w = points_.moved(state.v);
    const double square = detail::product(d, d), rate = detail::product(d, w) / square;
    out.force = points_.generalised_force(-damping_ * rate * d);
    if (!state.derivatives) return;
    const Vector<double, Dimension> turn = (w - 2.0 * rate * d) / square;
    const Matrix<double, Dimension> identity = Matrix<double, Dimension>::Identity();
    points_.add_block(-damping_ * (rate * identity + d * turn.transpose()), out.stiffness);
    points_.add_block(-damping_ / square * d * d.transpose(), out.damping);
}

#if defined(ANCF_SOURCE)
template class Spring<2>;
template class Spring<3>;
template class Damper<2>;
template class Damper<3>;
#endif

}  // namespace ancf
