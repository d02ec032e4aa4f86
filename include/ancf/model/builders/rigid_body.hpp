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
/// docs/theory-dynamics.md, "Rigid bodies", derives their mass.

#pragma once

#include <ancf/model/layout.hpp>
#include <ancf/model/model.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

namespace ancf {

/// Adds a body to a node.
///
/// A node without elements becomes a rigid body of its own: six multipliers (RigidNode) keep its
/// slopes, the axes of the body, orthonormal. Attach beams to it, or join them by constraints:
/// what is connected to the node itself shares these slopes.
/// A node of elements with r_x, r_y and r_z carries the body, as a beam does a rotor, and bends on:
/// there are no multipliers. Connect its elements first.
/// @param mass     kg.
/// @param inertia  moments and products of inertia about the centre of mass along the node's
///                 slopes, kg m^2: the diagonal holds int (y^2 + z^2) dm and so on, the rest
///                 -int x y dm and so on.
/// @param centre   of mass, from the node along its slopes, m.
/// @throws InvalidArgument for a mass that is not positive, an inertia that no body has, a centre
///         that is not finite, a node of other elements, and of a node without elements an inertia
///         that vanishes about an axis.
void add_body(Model& model, NodeId node, double mass, const Matrix<double, 3>& inertia,
              const VectorArgument<3>& centre = {0.0, 0.0, 0.0});

/// Adds a body to a node in the plane, likewise; three multipliers keep the slopes of a body of its
/// own.
/// @param inertia  int (x^2 + y^2) dm about the centre of mass, kg m^2.
/// @throws InvalidArgument likewise.
void add_body(PlanarModel& model, NodeId node, double mass, double inertia,
              const VectorArgument<2>& centre = {0.0, 0.0});

/// Adds a node at a point of a body, for joints, loads and springs there. It has a frame along the
/// global axes of the reference and follows the body without multipliers.
/// @param point  where it stands in the reference, m.
/// @throws InvalidArgument for a node that carries no body, and a point that is that node's.
NodeId point_of_body(Model& model, NodeId body, const VectorArgument<3>& point);
NodeId point_of_body(PlanarModel& model, NodeId body, const VectorArgument<2>& point);

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/builders/rigid_body.ipp>  // IWYU pragma: export
#endif
