// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/list.hpp>
#include <ancf/model/element_group.hpp>
#include <ancf/model/loads/damping.hpp>

namespace ancf {

ANCF_LAZY void LinearDamping::evaluate(const LoadState& state, LoadResult& out) const {
    detail::require(matrix_.rows() == state.v.size(), "LinearDamping: ", state.v.size(),
                    " coordinates are coupled, the matrix has ", matrix_.rows(), " rows");
    out.force = -matrix_ * state.v;
    out.damping = -matrix_;
}

namespace detail {

ANCF_LAZY void add_rayleigh_damping(Scene& model, const ElementGroup& group,
                                    const List<int>& elements, double a, double b,
                                    const Amplitude& amplitude) {
    require_not_negative("add_rayleigh_damping: a", a);
    require_not_negative("add_rayleigh_damping: b", b);
    const VectorX& q = model.state().q;
    require(q.size() == model.layout().size(), "add_rayleigh_damping: the state has ", q.size(),
            " coordinates, the model has ", model.layout().size());
    const int dofs = group.dofs();
    VectorX e(dofs), force(dofs);
    MatrixX mass(dofs, dofs), tangent(dofs, dofs);
    for (const int index : elements) {
        const Connection& connection = group.connection(index);
        const Coupling coupling = coupling_of(connection, group.fields());
        double* to = e.data();
        for (const NodeField& at : coupling)
            for (int i = 0; i < model.dimension(); ++i)
                *to++ = q[model.coordinate(at.node, at.field) + i];
        group.mass(connection.prototype, mass.data());
        static_cast<void>(
            group.evaluate(connection.prototype, e.data(), force.data(), tangent.data()));
        model.add(LinearDamping(coupling, a * mass + b * tangent), amplitude);
    }
}

/// Returns the mass matrix of an element's centre line alone: that of (r, r_x, r_xx), rho A times
/// int s^T s ds.
ANCF_INLINE MatrixX line_mass(const ElementGroup& group, int prototype, int dimension) {
    const int fields = group.fields().count();
    const auto in_line = [&](int vector) {
        const Field field = group.fields().at(vector % fields);
        return field != Field::r_y && field != Field::r_z && field != Field::r_xy;
    };
    MatrixX mass(group.dofs(), group.dofs());
    group.mass(prototype, mass.data());
    for (int row = 0; row < group.dofs(); ++row)
        for (int column = 0; column < group.dofs(); ++column)
            if (!in_line(row / dimension) || !in_line(column / dimension)) mass(row, column) = 0.0;
    return mass;
}

ANCF_LAZY void add_drag(Scene& model, const ElementGroup& group, const List<int>& elements,
                        double c, const Amplitude& amplitude) {
    require_not_negative("add_drag: the drag", c);
    const int node = group.dofs() / 2;
    for (const int index : elements) {
        const Connection& connection = group.connection(index);
        const MatrixX line = line_mass(group, connection.prototype, model.dimension());
        const double total = line(0, 0) + 2.0 * line(0, node) + line(node, node);  // rho A l
        const double scale = c * group.length(connection.prototype) / total;
        model.add(LinearDamping(coupling_of(connection, group.fields()), scale * line), amplitude);
    }
}

}  // namespace detail
}  // namespace ancf
