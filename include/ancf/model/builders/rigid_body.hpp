// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Rigid bodies: nodes with mass, a centre of mass and moments of inertia.
///
///     const auto hub = model.add_node({0, 0, 1});
///     ancf::add_body(model, hub, 3.0, ancf::Vector<double, 3>(0.2, 0.2, 0.3).asDiagonal());
///     model.attach(blade.first(), hub);                            // a beam, without multipliers
///     const auto pivot = ancf::point_of_body(model, hub, {0, 0, 2});
///     model.add(ancf::Revolute(model, pivot, {1, 0, 0}));
///
/// Beams are attached to the node of a body, at their ends or between them. Joints, loads and
/// springs act at this node or at points of the body. Hold the node by Scene::pin or by a joint
/// such as Weld, not by Scene::clamp: a clamp repeats the equations of RigidNode. Hold points by
/// joints. To fix a second body to a body, give a point of the first one to add_body.
/// docs/theory-dynamics.md, "Rigid bodies", derives the mass.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/model.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

namespace ancf {

/// Makes a node a rigid body, or adds to the body that it is.
///
/// Six multipliers, in the plane three, keep its slopes, the axes of the body, orthonormal
/// (RigidNode, which counts among the constraints of the scene).
/// @param node     one without beams: attach these to it.
/// @param mass     kg.
/// @param inertia  moments and products of inertia about the centre of mass along the node's
///                 slopes, kg m^2: the diagonal holds int (y^2 + z^2) dm and so on, the rest
///                 -int x y dm and so on.
/// @param centre   of mass, from the node along its slopes, m.
/// @throws InvalidArgument for a node of other elements or whose slopes in the reference are not
///         orthonormal, a mass that is not positive, an inertia that no body has or that vanishes
///         about an axis, and a centre that is not finite.
ANCF_LAZY void add_body(Model& model, NodeId node, double mass, const Matrix<double, 3>& inertia,
                        const VectorArgument<3>& centre = {0.0, 0.0, 0.0});

/// Makes a node in the plane a rigid body likewise.
/// @param inertia  int (x^2 + y^2) dm about the centre of mass, kg m^2.
/// @throws InvalidArgument likewise.
ANCF_LAZY void add_body(PlanarModel& model, NodeId node, double mass, double inertia,
                        const VectorArgument<2>& centre = {0.0, 0.0});

/// Adds a node at a point of a body, for joints, loads and springs. The node follows the body
/// without multipliers. Its frame is along X, Y and Z in the reference.
/// @param point  where it stands in the reference, m.
/// @throws InvalidArgument for a node that carries no body, and a point that is that node's or not
///         finite.
ANCF_LAZY NodeId point_of_body(Model& model, NodeId body, const VectorArgument<3>& point);
/// Adds a node at a point of a body in the plane likewise.
/// @throws InvalidArgument likewise.
ANCF_LAZY NodeId point_of_body(PlanarModel& model, NodeId body, const VectorArgument<2>& point);

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/builders/rigid_body.ipp>  // IWYU pragma: export
#endif
