// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The force and the moment that a generalised force amounts to: of a whole scene, of a node; the
/// rigid motions in which they do their work.
///
///     const auto report = ancf::solve_statics(model, solver);
///     const auto foot = ancf::nodal_resultant(model, model.state().q, report.reactions, node);
///
/// Under a rigid motion dr = d + w x r the slopes move by w x r_a, so the work of a generalised
/// force is that of the force sum Q_r at the origin and of the moment sum (r x Q_r + r_a x Q_a).

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/types.hpp>

namespace ancf {

/// Force and moment; in the plane only the third moment is not zero.
struct Resultant {
    Vector<double, 3> force = Vector<double, 3>::Zero();   ///< N
    Vector<double, 3> moment = Vector<double, 3>::Zero();  ///< N m
};

/// Returns the resultant of a generalised force, its moment about the origin of space.
/// @param q      all coordinates of the scene.
/// @param force  generalised force of every coordinate, N and N m.
/// @throws InvalidArgument for vectors of another size.
[[nodiscard]] Resultant resultant(const Scene& model, const VectorX& q, const VectorX& force);

/// Returns what a generalised force amounts to at one node, its moment about that node: of
/// StaticsReport::reactions what its supports exert on it.
/// @throws InvalidArgument for a node that does not exist or vectors of another size.
[[nodiscard]] Resultant nodal_resultant(const Scene& model, const VectorX& q, const VectorX& force,
                                        NodeId node);

/// Returns the rates of all coordinates, m/s and 1/s, in a rigid motion: translations of 1 m/s,
/// then turns about the origin of 1 rad/s. Their inner product with a generalised force is a
/// component of its resultant.
/// @param k  from 0: x, y, z, about x, about y, about z; in the plane x, y, about z.
/// @throws InvalidArgument for another k, or coordinates of another size.
[[nodiscard]] VectorX rigid_motion(const Scene& model, const VectorX& q, int k);

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/assembly/resultant.ipp>
#endif
