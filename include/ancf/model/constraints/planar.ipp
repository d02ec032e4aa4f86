// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/model/constraints/frames.hpp>
#include <ancf/model/constraints/planar.hpp>
#include <ancf/model/triad.hpp>

#include <cmath>
#include <complex>

namespace ancf {

namespace detail {

/// Returns the slope whose direction counts.
ANCF_INLINE Field planar_slope(const char* user, const BasicModel<2>& model, NodeId node,
                               std::optional<Field> slope) {
    if (slope) require_slope(user, *slope, 2);
    const bool section = model.layout().index({node, Field::r_y}) >= 0;
    return slope.value_or(section ? Field::r_y : Field::r_x);
}

/// Returns the angle of a slope, rad.
ANCF_INLINE double planar_heading(const char* user, const BasicModel<2>& model, NodeId node,
                                  Field slope) {
    const Vector<double, 2> p = model.value(node, slope);
    require(span(p) > 0.0, user, ": ", to_string(slope), " of node ", node.index, " has no length");
    return std::atan2(p[1], p[0]);
}

/// Returns the derivative of th_b - th_a by q, whose last coordinates, from `first` on, are the
/// slopes p of a and, unless it is space, of b.
template <class Scalar>
[[nodiscard]] DynamicVector<Scalar> planar_turn_gradient(const DynamicVector<Scalar>& q,
                                                         int first) {
    DynamicVector<Scalar> d = DynamicVector<Scalar>::Zero(q.size());
    for (int k = first; k < q.size(); k += 2) {
        const Scalar square = (k == first ? -1.0 : 1.0) * (q[k] * q[k] + q[k + 1] * q[k + 1]);
        d[k] = -q[k + 1] / square;
        d[k + 1] = q[k] / square;
    }
    return d;
}

/// Returns the second derivative likewise.
[[nodiscard]] ANCF_INLINE MatrixX planar_turn_hessian(const VectorX& q, int first) {
    MatrixX h = MatrixX::Zero(q.size(), q.size());
    for (int k = first; k < q.size(); k += 2) {
        const double x = q[k], y = q[k + 1], square = x * x + y * y;
        const double scale = (k == first ? -1.0 : 1.0) / (square * square);
        h(k, k) = 2.0 * scale * x * y;
        h(k + 1, k + 1) = -h(k, k);
        h(k, k + 1) = h(k + 1, k) = scale * (y * y - x * x);
    }
    return h;
}

}  // namespace detail

ANCF_INLINE double section_angle(const BasicModel<2>& model, NodeId node, const VectorX& q) {
    const Field slope = detail::planar_slope("section_angle", model, node, {});
    const Vector<double, 2> p = model.value(node, slope, q);
    return slope == Field::r_y ? std::atan2(-p[0], p[1]) : std::atan2(p[1], p[0]);
}

ANCF_INLINE PlanarWeld::PlanarWeld(const BasicModel<2>& model, NodeId a, const NodeId* b,
                                   Motion angle, std::optional<Field> slope)
    : a_(a),
      b_(b == nullptr ? a : *b),
      to_space_(b == nullptr),
      slope_a_(detail::planar_slope("PlanarWeld", model, a_, slope)),
      slope_b_(detail::planar_slope("PlanarWeld", model, b_, slope)),
      angle_(std::move(angle)) {
    detail::require(to_space_ || a_ != b_, "PlanarWeld: two nodes are joined, got node ", a.index,
                    " twice");
    angle_.check("PlanarWeld");
    if (to_space_) place_ = model.position(a);
    if (!to_space_) start_ = detail::planar_heading("PlanarWeld", model, b_, slope_b_);
    start_ -= detail::planar_heading("PlanarWeld", model, a_, slope_a_);
}

template <class Scalar>
PlanarWeld::Held<Scalar> PlanarWeld::held(const DynamicVector<Scalar>& q,
                                          const Scalar& time) const {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const int at = first_slope();
    const Scalar a[2] = {q[at], q[at + 1]};
    Scalar b[2] = {Scalar(1.0), Scalar(0.0)};
    if (!to_space_)
        for (int k = 0; k < 2; ++k) b[k] = q[6 + k];
    const Scalar lengths = sqrt((a[0] * a[0] + a[1] * a[1]) * (b[0] * b[0] + b[1] * b[1]));
    const Scalar sine = (a[0] * b[1] - a[1] * b[0]) / lengths;
    const Scalar cosine = (a[0] * b[0] + a[1] * b[1]) / lengths;
    const Scalar target = start_ + detail::continued(angle_.value, angle_.rate, time);
    const Scalar s = sine * cos(target) - cosine * sin(target),
                 c = cosine * cos(target) + sine * sin(target);
    const auto f = detail::turn_factor(std::real(s), c);
    return {f.value * s, f.value * c - f.first * s * s,
            -(f.value * s) - s * (3.0 * f.first * c - f.second * s * s)};
}

template <class Scalar>
void PlanarWeld::terms(const DynamicVector<Scalar>& q, const Scalar& time,
                       ConstraintTerms<Scalar>& out) const {
    for (int k = 0; k < 2; ++k) {
        out.violation[k] = q[k] - (to_space_ ? Scalar(place_[k]) : q[2 + k]);
        out.jacobian(k, k) = Scalar(1.0);
        if (!to_space_) out.jacobian(k, 2 + k) = Scalar(-1.0);
    }
    const Held<Scalar> now = held(q, time);
    const DynamicVector<Scalar> gradient = detail::planar_turn_gradient(q, first_slope());
    out.violation[2] = now.value;
    for (Eigen::Index k = 0; k < q.size(); ++k) out.jacobian(2, k) = now.first * gradient[k];
    out.rate[2] = -now.first * detail::continued(angle_.rate, angle_.acceleration, time);
}

ANCF_INLINE void PlanarWeld::evaluate(const ConstraintState& at, ConstraintResult& out) const {
    terms(at.q, at.time, out);
    const Held<double> now = held(at.q, at.time);
    const VectorX gradient = detail::planar_turn_gradient(at.q, first_slope());
    const MatrixX curvature = detail::planar_turn_hessian(at.q, first_slope());
    double speed = -angle_.rate(at.time), bend = -angle_.acceleration(at.time);
    for (Eigen::Index j = 0; j < at.q.size(); ++j) {
        speed += gradient[j] * at.v[j];
        for (Eigen::Index i = 0; i < at.q.size(); ++i) {
            bend += at.v[i] * curvature(i, j) * at.v[j];
            out.stiffness(i, j) = at.multipliers[2] * (now.first * curvature(i, j) +
                                                       now.second * gradient[i] * gradient[j]);
        }
    }
    out.convection[2] = now.first * bend + now.second * speed * speed;
}

#if defined(ANCF_SOURCE)
ANCF_CONSTRAINT_INSTANCES(PlanarWeld)
#endif

}  // namespace ancf
