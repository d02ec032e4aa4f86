// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Results over time as CSV: energies, section forces, stresses, reactions of joints and supports.
///
/// One row for every snapshot that an integrator shows, or every load step of statics.

#pragma once

#include <ancf/dynamics/report.hpp>
#include <ancf/element/evaluation.hpp>
#include <ancf/element/transmitted_forces.hpp>
#include <ancf/error.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/model/state.hpp>
#include <ancf/output/csv.hpp>
#include <ancf/types.hpp>

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ancf {

class DynamicProblem;

/// Writes chosen results of a scene, row by row; the columns are chosen before the first row.
///
///     ancf::TimeSeries series(file, model);
///     series.add_section_forces<Element>("root", 0, 0.0);
///     series.add_reaction("hinge", hinge, beam.first());    // hinge: what Model::add returned
///     series.add_reaction("foot", problem, beam.last());    // of what holds or drives this node
///     schedule.observe = [&](const ancf::Snapshot& seen) { series.write(seen); };
///
/// In statics write the state yourself, as in StaticsOptions::progress, or in PathOptions::progress
/// with a PathPoint for the number; t is then the load factor, energies are zero:
///
///     series.add_reaction("clamp", beam.first());  // of its supports, in statics
///     options.progress = [&](double, const ancf::State& state) {
///         series.write(state);
///         return true;
///     };
///
/// Columns: t, kinetic, strain, potential, load_power, constraint_power, then NAME_QUANTITY.
class TimeSeries {
public:
    /// The stream and the model outlive the series.
    TimeSeries(std::ostream& out, const Scene& model) : out_(out), model_(model) {}

    // its quantities refer to it
    TimeSeries(const TimeSeries&) = delete;
    TimeSeries& operator=(const TimeSeries&) = delete;

    using Values = std::vector<double>;                             ///< the numbers of a row
    using Append = std::function<void(const State&, Values& row)>;  ///< appends numbers to it

    /// Adds columns of your own, NAME_PART for each part:
    ///
    ///     series.add("tip", {"z"}, [&](const ancf::State& state, std::vector<double>& row) {
    ///         row.push_back(model.value(tip, ancf::Field::r, state.q)[2]);
    ///     });
    ///
    /// @param append  puts a number for each part at the end of the row; for another count write()
    ///                throws InvalidArgument.
    /// @throws InvalidArgument after the first row, or without a function.
    void add(const std::string& name, const std::vector<std::string>& parts, Append append);

    /// Adds N, Q_y, Q_z, T, M_y, M_z of a section as transmitted_forces has them; N and N m.
    /// Like the stress below they are elastic: without the viscous part of add_kelvin_voigt.
    /// @param element  index in the group of its type.  @param xi  place along it, 0 to 1
    /// @throws InvalidArgument for an element that does not exist, or xi outside [0, 1].
    template <class Element>
    void add_section_forces(const std::string& name, int element, double xi) {
        static_cast<void>(model_.group<Element>().element(element));
        check_place(xi);
        add(name, {"N", "Q_y", "Q_z", "T", "M_y", "M_z"},
            [this, element, xi](const State& state, Values& row) {
                const auto e = model_.element_coordinates<Element>(element, state.q);
                const SectionForces f =
                    transmitted_forces(model_.group<Element>().element(element), e, xi);
                row.insert(row.end(),
                           {f.axial, f.shear_y, f.shear_z, f.torque, f.moment_y, f.moment_z});
            });
    }

    /// Adds the stress of a point as the element's stress() has it: S_xx, S_yy, S_zz, S_yz, S_xz,
    /// S_xy of beams in space, S_xx, S_yy, S_xy in the plane, S_xx of cables; Pa. y and z in m.
    /// @throws InvalidArgument for an element that does not exist, or xi outside [0, 1].
    template <class Element>
    void add_stress(const std::string& name, int element, double xi, double y = 0.0,
                    double z = 0.0) {
        static_cast<void>(model_.group<Element>().element(element));
        check_place(xi);
        using Stress = decltype(std::declval<const Element&>().stress(
            std::declval<const typename Element::Coordinates&>(), 0.0, 0.0, 0.0));
        constexpr int components = Stress::RowsAtCompileTime;
        std::vector<std::string> parts = {"S_xx"};
        if (components == 3) parts = {"S_xx", "S_yy", "S_xy"};
        if (components == 6) parts = {"S_xx", "S_yy", "S_zz", "S_yz", "S_xz", "S_xy"};
        add(name, parts, [this, element, xi, y, z](const State& state, Values& row) {
            const auto e = model_.element_coordinates<Element>(element, state.q);
            const Stress stress = model_.group<Element>().element(element).stress(e, xi, y, z);
            row.insert(row.end(), stress.data(), stress.data() + components);
        });
    }

    /// Adds the force F and the moment M about the node that a constraint exerts on the node, in
    /// global axes; N and N m.
    /// @param constraint  place in Model::constraints(), as Model::add returned it.
    /// @throws InvalidArgument for a constraint that does not exist or does not hold the node.
    ANCF_LAZY void add_reaction(const std::string& name, int constraint, NodeId node);

    /// Adds the force F and the moment M about the node that supports (pin, clamp, fix, prescribe)
    /// exert on it, in global axes; N and N m, not a number where they cannot be solved for.
    ///
    /// For motions, one factorisation a row however many nodes: DynamicProblem::reactions. Loads
    /// without an amplitude act in full, so for statics leave the problem out.
    /// @param problem  that of the run, which outlives the series.
    /// @throws InvalidArgument for a problem of another model, a node that no support holds, or a
    ///         series that has such columns of statics.
    ANCF_LAZY void add_reaction(const std::string& name, DynamicProblem& problem, NodeId node);

    /// Adds the same F and M in statics, where loads act at the load factor of the row: one
    /// evaluation a row, not a number where that fails.
    /// @throws InvalidArgument for a node that no support holds, or a series that has such columns
    ///         of a motion.
    ANCF_LAZY void add_reaction(const std::string& name, NodeId node);

    /// Writes a row; before the first one, the header.
    /// @throws InvalidArgument for a name that would need quotes.
    void write(const Snapshot& seen);

    /// Writes a row of statics.
    /// @param state  whose time is the load factor, as solve_statics and follow_path leave it.
    void write(const State& state) { write({state, {}, 0.0, 0.0}); }

private:
    struct Quantity {
        std::vector<std::string> columns;
        Append append;
    };

    static void check_place(double xi) {
        detail::require(xi >= 0.0 && xi <= 1.0, "TimeSeries: xi must lie in [0, 1], got ", xi);
    }
    ANCF_LAZY void add_support_force(const std::string& name, NodeId node, bool in_statics);
    ANCF_LAZY [[nodiscard]] VectorX constraint_force(int constraint, const State& state) const;
    void append_force(NodeId node, const State& state, const VectorX& force, Values& row) const;

    std::ostream& out_;
    const Scene& model_;
    std::vector<Quantity> quantities_;
    std::function<void(const State&)> solve_supports_;  // fills the next; empty: nobody asked
    VectorX support_force_;
    bool in_statics_ = false;  // whether solve_supports_ is
    std::optional<CsvWriter> csv_;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/output/time_series.ipp>  // IWYU pragma: export
#endif
