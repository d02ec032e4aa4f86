// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The force and the moment that a generalised force amounts to: of a whole scene, of a node.
///
///     const auto report = ancf::solve_statics(model, solver);
///     const auto foot = ancf::nodal_resultant(model, model.state().q, report.reactions, node);
///
/// Under a rigid motion dr = d + w x r the slopes move by w x r_a, so the work of a generalised
/// force is that of the force sum Q_r at the origin and of the moment sum (r x Q_r + r_a x Q_a).

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/error.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/node.hpp>
#include <ancf/types.hpp>

namespace ancf {

/// Force and moment; in the plane only the third moment is not zero.
struct Resultant {
    Vector<double, 3> force = Vector<double, 3>::Zero();   ///< N
    Vector<double, 3> moment = Vector<double, 3>::Zero();  ///< N m
};

namespace detail {

inline void require_coordinates(const char* name, const Layout& layout, const VectorX& q,
                                const VectorX& force) {
    require(q.size() == layout.size() && force.size() == layout.size(), name, ": expected ",
            layout.size(), " coordinates and forces, got ", q.size(), " and ", force.size());
}

/// Returns a node's part of a generalised force, its moment about the node or the origin.
template <int Dimension>
[[nodiscard]] Resultant resultant_about(const Layout& layout, const VectorX& q,
                                        const VectorX& force, int node, bool origin) {
    Resultant sum;
    const bool positioned = layout.fields(node).contains(Field::r);
    for (int at = layout.first(node); at < layout.first(node + 1); at += Dimension) {
        Vector<double, 3> arm = Vector<double, 3>::Zero(), part = Vector<double, 3>::Zero();
        for (int k = 0; k < Dimension; ++k) {
            arm[k] = q[at + k];
            part[k] = force[at + k];
        }
        const bool position = positioned && at == layout.first(node);
        if (position) sum.force = part;
        if (!position || origin) sum.moment += cross(arm, part);
    }
    return sum;
}

}  // namespace detail

/// Returns the resultant of a generalised force, its moment about the origin of space.
/// @param q      all coordinates of the scene.
/// @param force  generalised force of every coordinate, N and N m.
/// @throws InvalidArgument for vectors of another size.
template <class Scene>
[[nodiscard]] Resultant resultant(const Scene& model, const VectorX& q, const VectorX& force) {
    const Layout& layout = model.layout();
    detail::require_coordinates("resultant", layout, q, force);
    Resultant sum;
    for (int node = 0; node < layout.nodes(); ++node) {
        const Resultant part =
            detail::resultant_about<Scene::dimension>(layout, q, force, node, true);
        sum.force += part.force;
        sum.moment += part.moment;
    }
    return sum;
}

/// Returns what a generalised force amounts to at one node, its moment about that node: of
/// StaticsReport::reactions what its supports exert on it.
/// @throws InvalidArgument for a node that does not exist or vectors of another size.
template <class Scene>
[[nodiscard]] Resultant nodal_resultant(const Scene& model, const VectorX& q, const VectorX& force,
                                        NodeId node) {
    const Layout& layout = model.layout();
    detail::require_coordinates("nodal_resultant", layout, q, force);
    detail::require(node.index >= 0 && node.index < layout.nodes(), "nodal_resultant: there are ",
                    layout.nodes(), " nodes, got node ", node.index);
    return detail::resultant_about<Scene::dimension>(layout, q, force, node.index, false);
}

}  // namespace ancf
