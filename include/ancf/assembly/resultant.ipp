// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/assembly/resultant.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/error.hpp>

namespace ancf {
namespace detail {

ANCF_INLINE void require_coordinates(const char* name, const Layout& layout, const VectorX& q,
                                     const VectorX& force) {
    require(q.size() == layout.size() && force.size() == layout.size(), name, ": expected ",
            layout.size(), " coordinates and forces, got ", q.size(), " and ", force.size());
}

/// Returns a node's part of a generalised force, its moment about the node or the origin.
[[nodiscard]] ANCF_INLINE Resultant resultant_about(int dimension, const Layout& layout,
                                                    const VectorX& q, const VectorX& force,
                                                    int node, bool origin) {
    Resultant sum;
    const bool positioned = layout.fields(node).contains(Field::r);
    for (int at = layout.first(node); at < layout.first(node + 1); at += dimension) {
        Vector<double, 3> arm = Vector<double, 3>::Zero(), part = Vector<double, 3>::Zero();
        for (int k = 0; k < dimension; ++k) {
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

ANCF_INLINE Resultant resultant(const Scene& model, const VectorX& q, const VectorX& force) {
    const Layout& layout = model.layout();
    detail::require_coordinates("resultant", layout, q, force);
    Resultant sum;
    for (int node = 0; node < layout.nodes(); ++node) {
        const Resultant part =
            detail::resultant_about(model.dimension(), layout, q, force, node, true);
        sum.force += part.force;
        sum.moment += part.moment;
    }
    return sum;
}

ANCF_INLINE Resultant nodal_resultant(const Scene& model, const VectorX& q, const VectorX& force,
                                      NodeId node) {
    const Layout& layout = model.layout();
    detail::require_coordinates("nodal_resultant", layout, q, force);
    detail::require(node.index >= 0 && node.index < layout.nodes(), "nodal_resultant: there are ",
                    layout.nodes(), " nodes, got node ", node.index);
    return detail::resultant_about(model.dimension(), layout, q, force, node.index, false);
}

ANCF_INLINE VectorX rigid_motion(const Scene& model, const VectorX& q, int k) {
    const Layout& layout = model.layout();
    detail::require_coordinates("rigid_motion", layout, q, q);
    const int dimension = layout.dimension(), axis = dimension == 3 ? k % 3 : 2;
    detail::require(k >= 0 && k < (dimension == 3 ? 6 : 3), "rigid_motion: there is no motion ", k);
    const int from = (axis + 1) % 3, to = (axis + 2) % 3;  // a turn
    VectorX motion = VectorX::Zero(q.size());
    for (int node = 0; node < layout.nodes(); ++node)
        for (int at = layout.first(node); at < layout.first(node + 1); at += dimension)
            if (k >= dimension) {
                motion[at + from] = -q[at + to];
                motion[at + to] = q[at + from];
            } else if (at == layout.first(node) && layout.fields(node).contains(Field::r)) {
                motion[at + k] = 1.0;
            }
    return motion;
}

}  // namespace ancf
