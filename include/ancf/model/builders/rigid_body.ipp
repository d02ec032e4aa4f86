// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/compiler.hpp>
#include <ancf/element/joint/body_mass.hpp>
#include <ancf/error.hpp>
#include <ancf/model/builders/rigid_body.hpp>
#include <ancf/model/constraints/joints.hpp>

#include <cmath>

namespace ancf {

namespace detail {

/// Returns int (x, y, z)^T (x, y, z) dm about the centre of mass: P = tr(J)/2 I - J.
[[nodiscard]] ANCF_INLINE Matrix<double, 3> second_moments(const Matrix<double, 3>& inertia) {
    return 0.5 * inertia.trace() * Matrix<double, 3>::Identity() - inertia;
}

/// Returns P of a body in the plane. Only its trace, the inertia, has an effect.
[[nodiscard]] ANCF_INLINE Matrix<double, 2> second_moments(double inertia) {
    return 0.5 * inertia * Matrix<double, 2>::Identity();
}

/// Returns P, lifted so that it is positive definite, of flat bodies too.
template <int Dimension>
[[nodiscard]] Matrix<double, Dimension> lifted(const Matrix<double, Dimension>& second) {
    const double trace = second.trace();
    for (const double lift : {1e-9, 1e-5}) {  // 1e-5 for figures of few digits
        const Matrix<double, Dimension> p =
            second + lift * trace * Matrix<double, Dimension>::Identity();
        if (SmallCholesky<Dimension>(p).definite()) return p;
    }
    reject(
        "add_body: no body has this inertia: no principal moment may exceed the sum of the others");
}

/// Returns whether a node carries a body.
/// @throws InvalidArgument for a node that does not exist or is one of another element.
template <int Dimension>
[[nodiscard]] bool has_body(const char* call, const Scene& model, NodeId node) {
    require(node.index >= 0 && node.index < model.nodes(), call, ": there are ", model.nodes(),
            " nodes, got node ", node.index);
    bool found = false;
    for (const auto& group : model.groups())
        for (const Connection& of : group->connections) {
            if (of.first != node && of.second != node) continue;
            require(group->template holds<BodyMass<Dimension>>(), call, ": node ", node.index,
                    " is one of an element: give the body a node of its own there and attach the "
                    "other one to it");
            found = true;
        }
    return found;
}

/// Adds a body, of the second moments P about its centre of mass.
template <int Dimension>
void put_body(BasicModel<Dimension>& model, NodeId node, double mass,
              const Matrix<double, Dimension>& second, const Vector<double, Dimension>& centre) {
    using Body = BodyMass<Dimension>;
    require_positive("add_body: mass", mass);
    require_finite("add_body: the centre", components(centre));
    require(all_finite(second) && (second - second.transpose()).norm() <= 1e-9 * second.trace(),
            "add_body: the inertia must be finite and symmetric");
    const Matrix<double, Dimension> about = lifted<Dimension>(second);
    const bool again = has_body<Dimension>("add_body", model, node);
    Matrix<double, Dimension> axes;
    for (int k = 0; k < Dimension; ++k)
        axes.col(k) = model.reference(node, static_cast<Field>(1 + k));
    require((axes.transpose() * axes - Matrix<double, Dimension>::Identity()).norm() <= 1e-6,
            "add_body: the slopes of node ", node.index,
            " are the axes of the body: they must be orthonormal, got (by columns) ",
            components(axes));
    // P of a rod has one eigenvalue that is not zero, the trace; 1e-4 is above the lift
    require(SmallCholesky<Dimension>(
                (1.0 - 1e-4) * about.trace() * Matrix<double, Dimension>::Identity() - about)
                .definite(),
            "add_body: a body needs inertia about every axis; for a mass at a point there is "
            "Model::add_mass");
    typename Body::Moments moments;
    moments(0, 0) = mass;
    for (int i = 0; i < Dimension; ++i) {
        moments(0, 1 + i) = moments(1 + i, 0) = mass * centre[i];
        for (int j = 0; j < Dimension; ++j)
            moments(1 + i, 1 + j) = about(i, j) + mass * centre[i] * centre[j];
    }
    // radius of gyration about the node, m
    const double size = std::sqrt((moments.trace() - mass) / mass);
    model.template connect<Body>(model.add_prototype(Body(moments, size)), node, node);
    if (!again) model.add(RigidNode<Dimension>(node));
}

/// Adds a node without mass that is attached to a body.
template <int Dimension>
[[nodiscard]] NodeId put_point(BasicModel<Dimension>& model, NodeId body,
                               const Vector<double, Dimension>& point) {
    using Body = BodyMass<Dimension>;
    require(has_body<Dimension>("point_of_body", model, body), "point_of_body: node ", body.index,
            " carries no body");
    require_finite("point_of_body: the point", components(point));
    const double distance =
        span(Vector<double, Dimension>(point - model.reference(body, Field::r)));
    require(distance != 0.0, "point_of_body: the point is that of node ", body.index,
            ": take that node");
    const NodeId node = model.add_node(point);
    const Body massless(Body::Moments::Zero(), distance);
    model.template connect<Body>(model.add_prototype(massless), node, node);
    model.attach(node, body, Body::fields);
    return node;
}

}  // namespace detail

ANCF_LAZY void add_body(Model& model, NodeId node, double mass, const Matrix<double, 3>& inertia,
                        const VectorArgument<3>& centre) {
    detail::put_body<3>(model, node, mass, detail::second_moments(inertia), centre);
}

ANCF_LAZY void add_body(PlanarModel& model, NodeId node, double mass, double inertia,
                        const VectorArgument<2>& centre) {
    detail::require_positive("add_body: inertia", inertia);
    detail::put_body<2>(model, node, mass, detail::second_moments(inertia), centre);
}

ANCF_LAZY NodeId point_of_body(Model& model, NodeId body, const VectorArgument<3>& point) {
    return detail::put_point<3>(model, body, point);
}

ANCF_LAZY NodeId point_of_body(PlanarModel& model, NodeId body, const VectorArgument<2>& point) {
    return detail::put_point<2>(model, body, point);
}

}  // namespace ancf
