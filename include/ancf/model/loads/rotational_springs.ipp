// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/model/constraints/frames.hpp>
#include <ancf/model/loads/rotational_springs.hpp>
#include <ancf/model/triad.hpp>

#include <array>
#include <cmath>

namespace ancf {
namespace detail {

ANCF_INLINE HingeAngle::HingeAngle(const char* user, const BasicModel<3>& model, const FrameAt& a,
                                   const FrameAt* b, const Vector<double, 3>& axis)
    : a_(JointSide::frame(model, a)),
      b_(b == nullptr ? JointSide::space(model, a.node) : JointSide::frame(model, *b)) {
    require(b == nullptr || a.node != b->node, user, ": two nodes are joined, got node ",
            a.node.index, " twice");
    const auto [p, n] = normals_of(unit_axis(user, axis));
    const Vec3<double> p_in_b = turned_back(b_.axes, p);
    sine_ = outer(turned_back(a_.axes, n), p_in_b);
    cosine_ = outer(turned_back(a_.axes, p), p_in_b);
}

ANCF_INLINE Coupling HingeAngle::coupling() const {
    Coupling all = {{a_.at.node, a_.at.first}, {a_.at.node, a_.at.second}};
    if (b_.kind != SideKind::space) {
        all.push_back({b_.at.node, b_.at.first});
        all.push_back({b_.at.node, b_.at.second});
    }
    return all;
}

ANCF_INLINE double HingeAngle::value(const VectorX& q, VectorX& gradient) const {
    const Triad<double> a = triad_of(a_, q, 0), b = triad_of(b_, q, 6);
    const FrameForm<double> sine(sine_, a, b), cosine(cosine_, a, b);
    const double s = sine.value, c = cosine.value, square = s * s + c * c;
    const std::array<double, 12> by_s = sine.gradient(a, b), by_c = cosine.gradient(a, b);
    gradient.resize(q.size());
    for (int k = 0; k < q.size(); ++k) gradient[k] = (c * by_s[k] - s * by_c[k]) / square;
    return std::atan2(s, c);
}

ANCF_INLINE MatrixX HingeAngle::hessian(const VectorX& q) const {
    const Triad<double> a = triad_of(a_, q, 0), b = triad_of(b_, q, 6);
    const double s = FrameForm<double>(sine_, a, b).value,
                 c = FrameForm<double>(cosine_, a, b).value;
    const FormCourse of_s(sine_, a, b, {}), of_c(cosine_, a, b, {});
    const auto &s_q = of_s.gradient, &c_q = of_c.gradient;
    const double square = s * s + c * c;
    MatrixX h(q.size(), q.size());
    for (int j = 0; j < q.size(); ++j)
        for (int i = 0; i < q.size(); ++i) {
            const double turn = (c * s_q[i] - s * c_q[i]) / square;
            h(i, j) = (c * of_s.hessian(i, j) - s * of_c.hessian(i, j) + s_q[i] * c_q[j] -
                       c_q[i] * s_q[j] - 2.0 * turn * (s * s_q[j] + c * c_q[j])) /
                      square;
        }
    return h;
}

ANCF_INLINE PlanarHingeAngle::PlanarHingeAngle(const char* user, const BasicModel<2>& model,
                                               NodeId a, const NodeId* b) {
    require(b == nullptr || a != *b, user, ": two nodes are joined, got node ", a.index, " twice");
    slopes_.push_back({a, planar_slope(user, model, a, {})});
    if (b != nullptr) slopes_.push_back({*b, planar_slope(user, model, *b, {})});
    double sign = -1.0;
    for (const NodeField& at : slopes_) {
        start_ += sign * planar_heading(user, model, at.node, at.field);
        sign = 1.0;
    }
}

ANCF_INLINE double PlanarHingeAngle::value(const VectorX& q, VectorX& gradient) const {
    // of B, which is the x-axis where it is space
    const bool space = q.size() == 2;
    const double x = space ? 1.0 : q[2], y = space ? 0.0 : q[3];
    const double s = q[0] * y - q[1] * x, c = q[0] * x + q[1] * y;
    gradient = planar_turn_gradient(q, 0);
    const double sine = std::sin(start_), cosine = std::cos(start_);
    return std::atan2(s * cosine - c * sine, c * cosine + s * sine);
}

ANCF_INLINE MatrixX PlanarHingeAngle::hessian(const VectorX& q) const {
    return planar_turn_hessian(q, 0);
}

template <class Angle>
void HingeSpring<Angle>::evaluate(const LoadState& state, LoadResult& out) const {
    VectorX gradient;
    const double angle = angle_.value(state.q, gradient);
    out.force = -stiffness_ * angle * gradient;
    out.potential = 0.5 * stiffness_ * angle * angle;
    if (state.derivatives)
        out.stiffness =
            -stiffness_ * (gradient * gradient.transpose() + angle * angle_.hessian(state.q));
}

template <class Angle>
void HingeDamper<Angle>::evaluate(const LoadState& state, LoadResult& out) const {
    VectorX gradient;
    (void)angle_.value(state.q, gradient);
    const double rate = gradient.dot(state.v);
    out.force = -damping_ * rate * gradient;
    if (!state.derivatives) return;
    const MatrixX hessian = angle_.hessian(state.q);
    const VectorX of_rate = hessian * state.v;
    out.stiffness = -damping_ * (rate * hessian + gradient * of_rate.transpose());
    out.damping = -damping_ * gradient * gradient.transpose();
}

#if defined(ANCF_SOURCE)
template class HingeSpring<HingeAngle>;
template class HingeSpring<PlanarHingeAngle>;
template class HingeDamper<HingeAngle>;
template class HingeDamper<PlanarHingeAngle>;
#endif

}  // namespace detail
}  // namespace ancf
