// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Results over time as CSV: energies, section forces, stresses, reactions of joints and supports.
///
/// One row for every snapshot that an integrator shows.

#pragma once

#include <ancf/assembly/resultant.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/element/section_forces.hpp>
#include <ancf/element/transmitted_forces.hpp>
#include <ancf/error.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/model/model.hpp>
#include <ancf/model/node.hpp>
#include <ancf/model/state.hpp>
#include <ancf/model/support.hpp>
#include <ancf/output/csv.hpp>
#include <ancf/types.hpp>

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace ancf {

/// Writes chosen results of a scene, row by row; the columns are chosen before the first row.
///
///     ancf::TimeSeries series(file, model);
///     series.add_section_forces("root", 0, 0.0);
///     series.add_reaction("hinge", 0, beam.first());        // of the first constraint
///     series.add_reaction("foot", problem, beam.last());    // of what holds or drives this node
///     schedule.observe = [&](const ancf::Snapshot& seen) { series.write(seen); };
///
/// Columns: t, kinetic, strain, potential, load_power, constraint_power, then NAME_QUANTITY.
template <class Scene>
class TimeSeries {
public:
    /// The stream and the model outlive the series.
    TimeSeries(std::ostream& out, const Scene& model) : out_(out), model_(model) {}

    // its quantities refer to it
    TimeSeries(const TimeSeries&) = delete;
    TimeSeries& operator=(const TimeSeries&) = delete;

    /// Adds N, Q_y, Q_z, T, M_y, M_z of a section as transmitted_forces has them; N and N m.
    /// @param element  index in the group of its type.  @param xi  place along it, 0 to 1
    template <class Element = typename Scene::DefaultElement>
    void add_section_forces(const std::string& name, int element, double xi);

    /// Adds the stress of a point as the element's stress() has it: S_xx, S_yy, S_zz, S_yz, S_xz,
    /// S_xy of beams in space, S_xx, S_yy, S_xy in the plane, S_xx of cables; Pa.
    template <class Element = typename Scene::DefaultElement>
    void add_stress(const std::string& name, int element, double xi, double y = 0.0,
                    double z = 0.0);

    /// Adds the force F and the moment M about the node that a constraint exerts on the node, in
    /// global axes; N and N m.
    /// @param constraint  place in Model::constraints().
    /// @throws InvalidArgument for a constraint that does not exist or does not hold the node.
    void add_reaction(const std::string& name, int constraint, NodeId node);

    /// Adds the force F and the moment M about the node that supports (pin, clamp, fix, prescribe)
    /// exert on it, in global axes; N and N m, not a number where they cannot be solved for.
    ///
    /// One factorisation a row, however many nodes: DynamicProblem::reactions.
    /// @param problem  that of the run, which outlives the series.
    /// @throws InvalidArgument for a problem of another model or a node that no support holds.
    void add_reaction(const std::string& name, DynamicProblem& problem, NodeId node);

    /// Writes a row; before the first one, the header.
    /// @throws InvalidArgument for a name that would need quotes.
    void write(const Snapshot& seen);

private:
    using Values = std::vector<double>;
    using Point = typename Scene::Point;
    struct Quantity {
        std::vector<std::string> columns;
        std::function<void(const State&, Values&)> append;
    };

    void add(const std::string& name, const std::vector<std::string>& parts,
             std::function<void(const State&, Values&)> append);
    template <class Element>
    void require_element(int element, double xi) const;
    void add_force(const std::string& name, std::function<void(const State&, Values&)> append);
    [[nodiscard]] VectorX constraint_force(int constraint, const State& state) const;
    void append_force(NodeId node, const State& state, const VectorX& force, Values& row) const;

    std::ostream& out_;
    const Scene& model_;
    std::vector<Quantity> quantities_;
    std::function<void(const State&)> solve_supports_;  // fills the next; empty: nobody asked
    VectorX support_force_;
    std::optional<CsvWriter> csv_;
};

template <class Scene>
void TimeSeries<Scene>::add(const std::string& name, const std::vector<std::string>& parts,
                            std::function<void(const State&, Values&)> append) {
    detail::require(!csv_, "TimeSeries: ", name, " must be added before the first row");
    Quantity quantity{{}, std::move(append)};
    for (const std::string& part : parts) quantity.columns.push_back(name + '_' + part);
    quantities_.push_back(std::move(quantity));
}

template <class Scene>
template <class Element>
void TimeSeries<Scene>::require_element(int element, double xi) const {
    const std::size_t count = model_.template group<Element>().connections.size();
    detail::require(element >= 0 && static_cast<std::size_t>(element) < count,
                    "TimeSeries: there are ", count, " elements of this type, got index ", element);
    detail::require(xi >= 0.0 && xi <= 1.0, "TimeSeries: xi must lie in [0, 1], got ", xi);
}

template <class Scene>
template <class Element>
void TimeSeries<Scene>::add_section_forces(const std::string& name, int element, double xi) {
    require_element<Element>(element, xi);
    add(name, {"N", "Q_y", "Q_z", "T", "M_y", "M_z"},
        [this, element, xi](const State& state, Values& row) {
            const auto e = model_.template element_coordinates<Element>(element, state.q);
            const SectionForces f =
                transmitted_forces(model_.template group<Element>().element(element), e, xi);
            row.insert(row.end(),
                       {f.axial, f.shear_y, f.shear_z, f.torque, f.moment_y, f.moment_z});
        });
}

template <class Scene>
template <class Element>
void TimeSeries<Scene>::add_stress(const std::string& name, int element, double xi, double y,
                                   double z) {
    require_element<Element>(element, xi);
    using Stress = decltype(std::declval<const Element&>().stress(
        std::declval<const typename Element::Coordinates&>(), 0.0, 0.0, 0.0));
    constexpr int components = Stress::RowsAtCompileTime;
    std::vector<std::string> parts = {"S_xx"};
    if (components == 3) parts = {"S_xx", "S_yy", "S_xy"};
    if (components == 6) parts = {"S_xx", "S_yy", "S_zz", "S_yz", "S_xz", "S_xy"};
    add(name, parts, [this, element, xi, y, z](const State& state, Values& row) {
        const auto e = model_.template element_coordinates<Element>(element, state.q);
        const Stress stress = model_.template group<Element>().element(element).stress(e, xi, y, z);
        row.insert(row.end(), stress.data(), stress.data() + components);
    });
}

template <class Scene>
void TimeSeries<Scene>::add_reaction(const std::string& name, int constraint, NodeId node) {
    const auto& constraints = model_.constraints();
    detail::require(constraint >= 0 && constraint < static_cast<int>(constraints.size()),
                    "TimeSeries: there are ", constraints.size(), " constraints, got index ",
                    constraint, "; for a support give the DynamicProblem instead");
    const AnyConstraint& held = constraints[static_cast<std::size_t>(constraint)];
    bool found = false;
    for (const NodeField& at : held.coupling()) found = found || at.node == node;
    detail::require(found, "TimeSeries: ", held.name(), " does not hold node ", node.index);
    add_force(name, [this, node, constraint](const State& state, Values& row) {
        append_force(node, state, constraint_force(constraint, state), row);
    });
}

template <class Scene>
void TimeSeries<Scene>::add_reaction(const std::string& name, DynamicProblem& problem,
                                     NodeId node) {
    detail::require(&problem.model() == &model_, "TimeSeries: the problem of ", name,
                    " is that of another model");
    bool found = false;
    for (const Support& support : model_.supports()) found = found || support.node == node;
    detail::require(found, "TimeSeries: no support holds node ", node.index);
    solve_supports_ = [this, &problem](const State& state) {
        if (problem.reactions(state, support_force_) != Status::converged)
            support_force_.setConstant(std::numeric_limits<double>::quiet_NaN());
    };
    add_force(name, [this, node](const State& state, Values& row) {
        append_force(node, state, support_force_, row);
    });
}

template <class Scene>
void TimeSeries<Scene>::add_force(const std::string& name,
                                  std::function<void(const State&, Values&)> append) {
    add(name, {"F_x", "F_y", "F_z", "M_x", "M_y", "M_z"}, std::move(append));
}

/// Returns -G^T lambda of one constraint, of all coordinates.
template <class Scene>
VectorX TimeSeries<Scene>::constraint_force(int constraint, const State& state) const {
    constexpr int dimension = Scene::dimension;
    const auto& constraints = model_.constraints();
    int first = 0;
    for (int k = 0; k < constraint; ++k)
        first += constraints[static_cast<std::size_t>(k)].equations();
    const AnyConstraint& held = constraints[static_cast<std::size_t>(constraint)];
    const Coupling coupling = held.coupling();
    const auto size = static_cast<Eigen::Index>(coupling.size()) * dimension;
    ConstraintState at;
    at.q.resize(size);
    at.v.setZero(size);
    at.time = state.time;
    at.multipliers = state.multipliers.segment(first, held.equations());
    const auto own = [](VectorX& vector, std::size_t k) {
        return vector.template segment<dimension>(static_cast<Eigen::Index>(k) * dimension);
    };
    for (std::size_t k = 0; k < coupling.size(); ++k)
        own(at.q, k) = state.q.template segment<dimension>(
            model_.coordinate(coupling[k].node, coupling[k].field));
    ConstraintResult out;
    out.reset(held.equations(), size);
    held.evaluate(at, out);
    VectorX exerted = -(out.jacobian.transpose() * at.multipliers);
    VectorX force = VectorX::Zero(state.q.size());
    for (std::size_t k = 0; k < coupling.size(); ++k)
        force.template segment<dimension>(model_.coordinate(coupling[k].node, coupling[k].field)) +=
            own(exerted, k);
    return force;
}

template <class Scene>
void TimeSeries<Scene>::append_force(NodeId node, const State& state, const VectorX& force,
                                     Values& row) const {
    const Resultant at = nodal_resultant(model_, state.q, force, node);
    row.insert(row.end(), at.force.data(), at.force.data() + 3);
    row.insert(row.end(), at.moment.data(), at.moment.data() + 3);
}

template <class Scene>
void TimeSeries<Scene>::write(const Snapshot& seen) {
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
