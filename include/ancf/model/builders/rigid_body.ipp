// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/joint/body_mass.hpp>
#include <ancf/error.hpp>
#include <ancf/model/builders/rigid_body.hpp>
#include <ancf/model/constraints/joints.hpp>

#include <cmath>

namespace ancf {

namespace detail {

/// Returns int (x, y, z)^T (x, y, z) dm about the centre of mass: P = tr(J)/2 - J.
[[nodiscard]] ANCF_INLINE Matrix<double, 3> second_moments(const Matrix<double, 3>& inertia) {
    return 0.5 * inertia.trace() * Matrix<double, 3>::Identity() - inertia;
}

/// In the plane the energy of a rigid motion has the trace of P alone.
[[nodiscard]] ANCF_INLINE Matrix<double, 2> second_moments(double inertia) {
    return 0.5 * inertia * Matrix<double, 2>::Identity();
}

/// Tells whether a symmetric matrix is positive definite.
template <int Dimension>
[[nodiscard]] bool is_positive(Matrix<double, Dimension> p) {
    for (int k = 0; k < Dimension; ++k) {
        if (!(p(k, k) > 0.0)) return false;
        for (int j = k + 1; j < Dimension; ++j)
            for (int i = k + 1; i < Dimension; ++i) p(i, j) -= p(i, k) * p(k, j) / p(k, k);
    }
    return true;
}

/// @param second  P about the centre of mass
template <int Dimension>
void put_body(BasicModel<Dimension>& model, NodeId node, double mass,
              const Matrix<double, Dimension>& second, const Vector<double, Dimension>& centre) {
    using Body = BodyMass<Dimension>;
    using Square = Matrix<double, Dimension>;
    constexpr double round_off = 1e-9;
    require_positive("add_body: mass", mass);
    require_finite("add_body: the centre", components(centre));
    require(node.index >= 0 && node.index < model.nodes(), "add_body: there are ", model.nodes(),
            " nodes, got node ", node.index);
    const double trace = second.trace();
    const Square slack = round_off * trace * Square::Identity();
    require(all_finite(second) && (second - second.transpose()).norm() <= round_off * trace &&
                (trace == 0.0 || is_positive<Dimension>(second + slack)),
            "add_body: no body has this inertia: it is symmetric, and none of its principal "
            "moments exceeds the sum of the others");
    const Fields carried = model.layout().fields(node.index);
    const bool own = carried == Fields() || carried == Fields(Field::r);
    require(own || carried.contains(Body::fields), "add_body: the elements at node ", node.index,
            " do not have all slopes: give the body a node of its own and join it to that one");
    require(!own || is_positive<Dimension>(trace * Square::Identity() - second - slack),
            "add_body: a body of its own needs inertia about every axis; for a mass at a point "
            "there is Model::add_mass");
    const bool flat = own && !is_positive<Dimension>(second - slack);
    typename Body::Moments moments;
    moments(0, 0) = mass;
    for (int i = 0; i < Dimension; ++i) {
        moments(0, 1 + i) = moments(1 + i, 0) = mass * centre[i];
        for (int j = 0; j < Dimension; ++j)
            moments(1 + i, 1 + j) =
                second(i, j) + (flat ? slack(i, j) : 0.0) + mass * centre[i] * centre[j];
    }
    const double size = std::sqrt((moments.trace() - mass) / mass);
    require(size > 0.0, "add_body: for a mass at a point there is Model::add_mass");
    model.template connect<Body>(model.add_prototype(Body(moments, size)), node, node);
    if (own) model.add(RigidNode<Dimension>(node));
}

template <int Dimension>
[[nodiscard]] NodeId put_point(BasicModel<Dimension>& model, NodeId body,
                               const Vector<double, Dimension>& point) {
    using Body = BodyMass<Dimension>;
    require(body.index >= 0 && body.index < model.nodes() &&
                model.layout().fields(body.index).contains(Body::fields),
            "point_of_body: node ", body.index, " carries no body");
    const double distance = span(Vector<double, Dimension>(point - model.position(body)));
    require(distance > 0.0, "point_of_body: the point is that of node ", body.index,
            ": take that node");
    const NodeId node = model.add_node(point);
    const Body massless(Body::Moments::Zero(), distance);
    model.template connect<Body>(model.add_prototype(massless), node, node);
    model.attach(node, body, Body::fields);
    return node;
}

}  // namespace detail

ANCF_INLINE void add_body(Model& model, NodeId node, double mass, const Matrix<double, 3>& inertia,
                          const VectorArgument<3>& centre) {
    detail::put_body<3>(model, node, mass, detail::second_moments(inertia), centre);
}

ANCF_INLINE void add_body(PlanarModel& model, NodeId node, double mass, double inertia,
                          const VectorArgument<2>& centre) {
    detail::put_body<2>(model, node, mass, detail::second_moments(inertia), centre);
}

ANCF_INLINE NodeId point_of_body(Model& model, NodeId body, const VectorArgument<3>& point) {
    return detail::put_point<3>(model, body, point);
}

ANCF_INLINE NodeId point_of_body(PlanarModel& model, NodeId body, const VectorArgument<2>& point) {
    return detail::put_point<2>(model, body, point);
}

}  // namespace ancf
