// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/assembly/assembly.hpp>
#include <ancf/assembly/resultant.hpp>
#include <ancf/compiler.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/output/time_series.hpp>

#include <limits>
#include <memory>

namespace ancf {

ANCF_INLINE void TimeSeries::add(const std::string& name, const std::vector<std::string>& parts,
                                 Append append) {
    detail::require(!csv_, "TimeSeries: ", name, " must be added before the first row");
    detail::require(append != nullptr, "TimeSeries: ", name, " has no function");
    Quantity quantity{{}, std::move(append)};
    for (const std::string& part : parts) quantity.columns.push_back(name + '_' + part);
    quantities_.push_back(std::move(quantity));
}

ANCF_LAZY void TimeSeries::add_reaction(const std::string& name, int constraint, NodeId node) {
    const auto& constraints = model_.constraints();
    detail::require(constraint >= 0 && constraint < static_cast<int>(constraints.size()),
                    "TimeSeries: there are ", constraints.size(), " constraints, got index ",
                    constraint,
                    "; for a support leave the index out in statics, and in a motion give the "
                    "DynamicProblem in its place");
    const AnyConstraint& held = constraints[constraint];
    bool found = false;
    for (const NodeField& at : held.coupling()) found = found || at.node == node;
    detail::require(found, "TimeSeries: ", held.name(), " does not hold node ", node.index);
    add(name, {"F_x", "F_y", "F_z", "M_x", "M_y", "M_z"},
        [this, node, constraint](const State& state, Values& row) {
            append_force(node, state, constraint_force(constraint, state), row);
        });
}

ANCF_LAZY void TimeSeries::add_reaction(const std::string& name, DynamicProblem& problem,
                                        NodeId node) {
    detail::require(&problem.model() == &model_, "TimeSeries: the problem of ", name,
                    " is that of another model");
    add_support_force(name, node, false);
    solve_supports_ = [this, &problem](const State& state) {
        if (problem.reactions(state, support_force_) != Status::converged)
            support_force_.setConstant(std::numeric_limits<double>::quiet_NaN());
    };
}

ANCF_LAZY void TimeSeries::add_reaction(const std::string& name, NodeId node) {
    add_support_force(name, node, true);
    solve_supports_ = [this, assembly = std::shared_ptr<Assembly>()](const State& state) mutable {
        if (!assembly) assembly = std::make_shared<Assembly>(model_, Storage::full);
        const Instant instant{state.time, state.time};
        const VectorX rest = VectorX::Zero(state.q.size());
        const bool fails =
            assembly->evaluate({state.q, rest, state.multipliers, instant}, Request::force)
                .has_value();
        support_force_ = rest;
        for (const int k : assembly->numbering().held())
            support_force_[k] =
                fails ? std::numeric_limits<double>::quiet_NaN() : assembly->unbalanced(k);
    };
}

ANCF_LAZY void TimeSeries::add_support_force(const std::string& name, NodeId node,
                                             bool in_statics) {
    detail::require(!solve_supports_ || in_statics == in_statics_, "TimeSeries: ", name,
                    in_statics ? " is of statics, others are of a motion: take two series"
                               : " is of a motion, others are of statics: take two series");
    in_statics_ = in_statics;
    bool found = false;
    for (const Support& support : model_.supports()) found = found || support.node == node;
    detail::require(found, "TimeSeries: no support holds node ", node.index, ": pin or fix it");
    add(name, {"F_x", "F_y", "F_z", "M_x", "M_y", "M_z"},
        [this, node](const State& state, Values& row) {
            append_force(node, state, support_force_, row);
        });
}

/// Returns -G^T lambda of one constraint, of all coordinates.
ANCF_LAZY VectorX TimeSeries::constraint_force(int constraint, const State& state) const {
    const int dimension = model_.dimension();
    const auto& constraints = model_.constraints();
    int first = 0;
    for (int k = 0; k < constraint; ++k) first += constraints[k].equations();
    const AnyConstraint& held = constraints[constraint];
    detail::require(first + held.equations() <= state.multipliers.size(),
                    "TimeSeries: ", held.name(), " has the multipliers ", first, " to ",
                    first + held.equations() - 1, ", the state has ", state.multipliers.size());
    std::vector<int> coordinates;  // of all its vectors
    for (const NodeField& at : held.coupling())
        for (int i = 0; i < dimension; ++i)
            coordinates.push_back(model_.coordinate(at.node, at.field) + i);
    const auto size = static_cast<Eigen::Index>(coordinates.size());
    ConstraintState at;
    detail::gather(state.q, coordinates, at.q);
    at.v.setZero(size);
    at.time = state.time;
    at.multipliers = state.multipliers.segment(first, held.equations());
    ConstraintResult out;
    held.evaluate(at, out);
    const VectorX exerted = -(out.jacobian.transpose() * at.multipliers);
    VectorX force = VectorX::Zero(state.q.size());
    for (Eigen::Index k = 0; k < size; ++k) force[coordinates[k]] += exerted[k];
    return force;
}

ANCF_INLINE void TimeSeries::append_force(NodeId node, const State& state, const VectorX& force,
                                          Values& row) const {
    const Resultant at = nodal_resultant(model_, state.q, force, node);
    row.insert(row.end(), at.force.data(), at.force.data() + 3);
    row.insert(row.end(), at.moment.data(), at.moment.data() + 3);
}

ANCF_INLINE void TimeSeries::write(const Snapshot& seen) {
    if (!csv_) {
        std::vector<std::string> columns = {"t",         "kinetic",    "strain",
                                            "potential", "load_power", "constraint_power"};
        for (const Quantity& quantity : quantities_)
            columns.insert(columns.end(), quantity.columns.begin(), quantity.columns.end());
        csv_.emplace(out_, std::move(columns));
    }
    const Energies& energies = seen.energies;
    Values row = {seen.state.time,    energies.kinetic,    energies.strain,
                  energies.potential, energies.load_power, energies.constraint_power};
    if (solve_supports_) solve_supports_(seen.state);
    for (const Quantity& quantity : quantities_) quantity.append(seen.state, row);
    csv_->row(row);
}

}  // namespace ancf
