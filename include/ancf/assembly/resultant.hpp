// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The force and the moment that a generalised force amounts to.
///
/// Under a rigid motion dr = d + w x r the slopes move by w x r_a, so the work of a generalised
/// force is that of the force sum Q_r at the origin and of the moment sum (r x Q_r + r_a x Q_a).

#pragma once

#include <ancf/error.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/types.hpp>

namespace ancf {

/// Force and moment about the origin of space; in the plane only the third moment is not zero.
struct Resultant {
    Vector<double, 3> force = Vector<double, 3>::Zero();   ///< N
    Vector<double, 3> moment = Vector<double, 3>::Zero();  ///< N m
};

/// Returns the resultant of a generalised force.
/// @param q      all coordinates of the scene.
/// @param force  generalised force of every coordinate, N and N m.
template <class Scene>
[[nodiscard]] Resultant resultant(const Scene& model, const VectorX& q, const VectorX& force) {
    constexpr int dimension = Scene::dimension;
    const Layout& layout = model.layout();
    detail::require(q.size() == layout.size() && force.size() == layout.size(),
                    "resultant: expected ", layout.size(), " coordinates and forces, got ",
                    q.size(), " and ", force.size());
    Resultant sum;
    for (int node = 0; node < layout.nodes(); ++node) {
        const bool positioned = layout.fields(node).contains(Field::r);
        for (int at = layout.first(node); at < layout.first(node + 1); at += dimension) {
            Vector<double, 3> place = Vector<double, 3>::Zero();
            Vector<double, 3> part = Vector<double, 3>::Zero();
            place.head<dimension>() = q.template segment<dimension>(at);
            part.head<dimension>() = force.template segment<dimension>(at);
            if (positioned && at == layout.first(node)) sum.force += part;
            sum.moment += cross(place, part);
        }
    }
    return sum;
}

}  // namespace ancf
