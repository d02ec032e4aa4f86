// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/hermite.hpp>
#include <ancf/element/vec3.hpp>
#include <ancf/list.hpp>
#include <ancf/model/constraints/points.hpp>

#include <cmath>

namespace ancf {

ANCF_INLINE MaterialPoint::MaterialPoint(NodeId node)
    : vectors{{node, Field::r}}, weights{1.0}, name(detail::joined({"node ", node.index})) {}

ANCF_INLINE MaterialPoint::MaterialPoint(Coupling at, List<double> with, std::string called)
    : vectors(std::move(at)), weights(std::move(with)), name(std::move(called)) {}

namespace detail {

ANCF_INLINE MaterialPoint point_of_line(const Connection& at, int element, bool quintic,
                                        double length, double xi) {
    require(xi >= 0.0 && xi <= 1.0, "point_along: xi must lie in [0, 1], got ", xi);
    std::string name = joined({"the point at ", xi, " of element ", element});
    const NodeId i = at.first, j = at.second;
    if (quintic) {
        const auto w = QuinticLine::value(xi, length);
        return {{{i, Field::r},
                 {i, Field::r_x},
                 {i, Field::r_xx},
                 {j, Field::r},
                 {j, Field::r_x},
                 {j, Field::r_xx}},
                {1.0 - w[0], w[1], w[3], w[0], w[2], w[4]},
                std::move(name)};
    }
    const auto shape = hermite(xi, length);
    return {{{i, Field::r}, {i, Field::r_x}, {j, Field::r}, {j, Field::r_x}},
            {shape[0], shape[1], shape[2], shape[3]},
            std::move(name)};
}

template <int Dimension>
PointPair<Dimension>::PointPair(MaterialPoint a, MaterialPoint b)
    : a_(std::move(a)), b_(std::move(b)), weights_(a_.weights) {
    check(a_);
    check(b_);
    require(a_.vectors.size() != 1 || b_.vectors.size() != 1 ||
                a_.vectors[0].node != b_.vectors[0].node,
            "expected two points, got ", a_.name, " twice");
    for (const double weight : b_.weights) weights_.push_back(-weight);
}

template <int Dimension>
PointPair<Dimension>::PointPair(MaterialPoint a, PointMotion<Dimension> path)
    : a_(std::move(a)),
      b_({}, {}, "a point of space"),
      path_(std::move(path)),
      weights_(a_.weights) {
    check(a_);
    path_.check("a point on a path");
}

template <int Dimension>
PointPair<Dimension>::PointPair(MaterialPoint a, const Vector<double, Dimension>& place,
                                const char* user)
    : PointPair(std::move(a), PointMotion<Dimension>::at_rest(place)) {
    require(all_finite(place), user, ": the place must be finite, got ", components(place));
}

template <int Dimension>
Coupling PointPair<Dimension>::coupling() const {
    Coupling all = a_.vectors;
    all.insert(all.end(), b_.vectors.begin(), b_.vectors.end());
    return all;
}

template <int Dimension>
std::string PointPair<Dimension>::names() const {
    return a_.name + " and " + b_.name;
}

template <int Dimension>
template <class Scalar>
Vector<Scalar, Dimension> PointPair<Dimension>::difference(const DynamicVector<Scalar>& q,
                                                           const Scalar& time) const {
    Vector<Scalar, Dimension> d = moved(q);
    if (!path_.value) return d;
    const Vector<Scalar, Dimension> place = continued(path_.value, path_.rate, time);
    for (int i = 0; i < Dimension; ++i) d[i] -= place[i];
    return d;
}

template <int Dimension>
template <class Scalar>
Vector<Scalar, Dimension> PointPair<Dimension>::moved(const DynamicVector<Scalar>& q) const {
    Vector<Scalar, Dimension> d = Vector<Scalar, Dimension>::Zero();
    int at = 0;
    for (const double weight : weights_)
        for (int i = 0; i < Dimension; ++i) d[i] += weight * q[at++];
    return d;
}

template <int Dimension>
VectorX PointPair<Dimension>::generalised_force(const Vector<double, Dimension>& force) const {
    VectorX out(Dimension * static_cast<int>(weights_.size()));
    int at = 0;
    for (const double weight : weights_)
        for (int i = 0; i < Dimension; ++i) out[at++] = weight * force[i];
    return out;
}

template <int Dimension>
void PointPair<Dimension>::add_block(const Matrix<double, Dimension>& block, MatrixX& to) const {
    for (int i = 0; i < to.rows(); ++i)
        for (int j = 0; j < to.cols(); ++j)
            to(i, j) += weights_[i / Dimension] * weights_[j / Dimension] *
                        block(i % Dimension, j % Dimension);
}

template <int Dimension>
void PointPair<Dimension>::check(const MaterialPoint& point) {
    require(!point.vectors.empty() && point.vectors.size() == point.weights.size(),
            "a material point needs one weight per vector, got ", point.vectors.size(),
            " vectors and ", point.weights.size(), " weights");
    for (const double weight : point.weights) require_finite("MaterialPoint: weight", weight);
}

}  // namespace detail

template <int Dimension>
FixedCoordinate<Dimension>::FixedCoordinate(NodeId node, Field field, int component, double value)
    : FixedCoordinate(node, field, component, detail::resting_at(value)) {
    detail::require_finite("FixedCoordinate: value", value);
}

template <int Dimension>
FixedCoordinate<Dimension>::FixedCoordinate(NodeId node, Field field, int component, Motion motion)
    : at_{node, field}, component_(component), motion_(std::move(motion)) {
    detail::require(component >= 0 && component < Dimension, "FixedCoordinate: a vector has ",
                    Dimension, " components, got component ", component);
    motion_.check("FixedCoordinate");
}

template <int Dimension>
std::string FixedCoordinate<Dimension>::name() const {
    return detail::joined(
        {"fixed ", to_string(at_.field), ", component ", component_, ", of node ", at_.node.index});
}

template <int Dimension>
template <class Scalar>
void FixedCoordinate<Dimension>::terms(const DynamicVector<Scalar>& q, const Scalar& time,
                                       ConstraintTerms<Scalar>& out) const {
    out.violation[0] = q[component_] - detail::continued(motion_.value, motion_.rate, time);
    out.jacobian(0, component_) = Scalar(1.0);
    out.rate[0] = -detail::continued(motion_.rate, motion_.acceleration, time);
}

template <int Dimension>
void FixedCoordinate<Dimension>::evaluate(const ConstraintState& at, ConstraintResult& out) const {
    terms(at.q, at.time, out);
    out.convection[0] = -motion_.acceleration(at.time);
}

template <int Dimension>
template <class Scalar>
void Pin<Dimension>::terms(const DynamicVector<Scalar>& q, const Scalar& time,
                           ConstraintTerms<Scalar>& out) const {
    out.violation = points_.difference(q, time);
    int at = 0;
    for (const double weight : points_.weights())
        for (int i = 0; i < Dimension; ++i) out.jacobian(i, at++) = Scalar(weight);
    out.rate = points_.drift(time);
}

template <int Dimension>
void Pin<Dimension>::evaluate(const ConstraintState& at, ConstraintResult& out) const {
    terms(at.q, at.time, out);
    out.convection = points_.drift_rate(at.time);
}

template <int Dimension>
PointOnLine<Dimension>::PointOnLine(MaterialPoint point, const VectorArgument<Dimension>& place,
                                    const VectorArgument<Dimension>& direction)
    : points_(std::move(point), place, "PointOnLine") {
    const Vector<double, Dimension> along = direction;
    const double size = along.norm();
    detail::require(std::isfinite(size) && size > 0.0,
                    "PointOnLine: the direction must have a length, got ",
                    detail::components(along));
    if constexpr (Dimension == 2) {
        normals_[0] = Vector<double, 2>(-along[1], along[0]) / size;
    } else {
        const auto normals = detail::normals_of(detail::vec3<double>(along) / size);
        for (int k = 0; k < 2; ++k) normals_[k] = detail::to_vector(normals[k]);
    }
}

template <int Dimension>
template <class Scalar>
void PointOnLine<Dimension>::terms(const DynamicVector<Scalar>& q, const Scalar& time,
                                   ConstraintTerms<Scalar>& out) const {
    const Vector<Scalar, Dimension> d = points_.difference(q, time);
    for (int k = 0; k < Dimension - 1; ++k) {
        for (int i = 0; i < Dimension; ++i) out.violation[k] += normals_[k][i] * d[i];
        int at = 0;
        for (const double weight : points_.weights())
            for (int i = 0; i < Dimension; ++i) out.jacobian(k, at++) = weight * normals_[k][i];
    }
}

template <int Dimension>
Distance<Dimension>::Distance(Points points, double length)
    : Distance(std::move(points), detail::resting_at(length)) {
    detail::require_positive("Distance: length", length);
}

template <int Dimension>
Distance<Dimension>::Distance(Points points, Motion length)
    : points_(std::move(points)), length_(std::move(length)) {
    length_.check("Distance");
}

template <int Dimension>
template <class Scalar>
void Distance<Dimension>::terms(const DynamicVector<Scalar>& q, const Scalar& time,
                                ConstraintTerms<Scalar>& out) const {
    using std::sqrt;
    const Vector<Scalar, Dimension> d = points_.difference(q, time);
    const Scalar distance = sqrt(detail::product(d, d));
    const Vector<Scalar, Dimension> n = d / distance;
    int at = 0;
    for (const double weight : points_.weights())
        for (int i = 0; i < Dimension; ++i) out.jacobian(0, at++) = weight * n[i];
    out.violation[0] = distance - detail::continued(length_.value, length_.rate, time);
    out.rate[0] = detail::product(n, points_.template drift<Scalar>(time)) -
                  detail::continued(length_.rate, length_.acceleration, time);
}

template <int Dimension>
void Distance<Dimension>::evaluate(const ConstraintState& at, ConstraintResult& out) const {
    terms(at.q, at.time, out);
    const Vector<double, Dimension> d = points_.difference(at.q, at.time);
    const double distance = std::sqrt(detail::product(d, d));
    const Vector<double, Dimension> n = d / distance;
    const Matrix<double, Dimension> curvature =
        at.multipliers[0] / distance * (Matrix<double, Dimension>::Identity() - n * n.transpose());
    points_.add_block(curvature, out.stiffness);
    const Vector<double, Dimension> speed = points_.drift(at.time) + points_.moved(at.v);
    const double along = detail::product(n, speed);
    out.convection[0] = (detail::product(speed, speed) - along * along) / distance +
                        detail::product(n, points_.drift_rate(at.time)) -
                        length_.acceleration(at.time);
}

#if defined(ANCF_SOURCE)
#define ANCF_POINT_CONSTRAINT_INSTANCES(Type) \
    template class Type<2>;                   \
    template class Type<3>;                   \
    ANCF_CONSTRAINT_INSTANCES(Type<2>)        \
    ANCF_CONSTRAINT_INSTANCES(Type<3>)
template class detail::PointPair<2>;
template class detail::PointPair<3>;
ANCF_POINT_CONSTRAINT_INSTANCES(FixedCoordinate)
ANCF_POINT_CONSTRAINT_INSTANCES(Pin)
ANCF_POINT_CONSTRAINT_INSTANCES(PointOnLine)
ANCF_POINT_CONSTRAINT_INSTANCES(Distance)
#endif

}  // namespace ancf
