// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The system of a scene: forces, tangent and mass, scattered into one fixed sparse pattern.
///
/// Unknowns are the free coordinates and the multipliers. In the notation of docs/notation.md:
///
///     residual = (Q_e(q) + G^T lambda - Q(q, v, t), g(q, t)),
///     tangent  = [K - dQ/dq + (G^T lambda)_q, G^T; G, 0].
///
/// The order of summation is fixed, so equal input gives equal bits.

#pragma once

#include <ancf/assembly/block_pattern.hpp>
#include <ancf/assembly/numbering.hpp>
#include <ancf/assembly/schedule.hpp>
#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace ancf {

/// Where a scene is evaluated.
struct Configuration {
    const VectorX& q;            ///< all coordinates
    const VectorX& v;            ///< their rates
    const VectorX& multipliers;  ///< of all constraints
    Instant instant;             ///< time, or load factor
};

/// What an evaluation computes.
enum class Request {
    force,               ///< energies, forces, constraint violations
    tangent,             ///< and the tangent
    tangent_and_damping  ///< and the derivative with respect to the rates
};

/// The last step of Newton's method, all coordinates.
struct Correction {
    VectorX before;  ///< where its tangent was taken
    VectorX change;  ///< what the linear system gave
};

/// Where an element stands in a model.
struct ElementPlace {
    int group;    ///< place of its type in the model's list
    int element;  ///< index in that group
};

/// An element whose energy, force or tangent is not a number.
struct Fault {
    Status status;  ///< degenerate or not_finite
    int group;      ///< place of the element's type in the model's list; -1: not an element,
                    ///< -2: in another part of the scene, which has the fault
    int element;    ///< index in that group
    /// Place of the driven support whose value, rate or acceleration is not finite; -1: none.
    int support = -1;
};

/// The potential of a load that works through an angle.
struct AnglePotential {
    double scale;   ///< of the load, 1
    double value;   ///< at unit scale, of the angle between -pi and pi, J
    double period;  ///< at unit scale, of one turn, J
};

namespace detail {

/// The step of differences in the load factor, a ten-thousandth of it and at least 1e-4:
/// exact but for round-off for loads in proportion to the factor.
[[nodiscard]] inline double factor_step(double factor) noexcept {
    const double size = factor < 0.0 ? -factor : factor;
    return 1e-4 * (size > 1.0 ? size : 1.0);
}

}  // namespace detail

/// Evaluates and assembles a model, which outlives it. It follows changes of prototypes, of masses
/// at nodes and of gravity; after one of nodes, elements, supports, loads or constraints it throws
/// InvalidArgument, and a new one is made.
class Assembly {
public:
    /// @throws InvalidArgument for a load or constraint on a vector that its node does not carry, a
    ///         position attached beside a node whose elements do not have the slope towards it, or
    ///         for lower storage of a tangent that is not symmetric or has multipliers.
    Assembly(const Scene& model, Storage storage);

    /// Returns the scene.
    [[nodiscard]] const Scene& model() const noexcept { return model_; }
    /// Returns the order of unknowns.
    [[nodiscard]] const Numbering& numbering() const noexcept { return numbering_; }
    /// Returns the places of entries.
    [[nodiscard]] const BlockPattern& pattern() const noexcept { return pattern_; }

    /// Evaluates the scene; results stand in the members below until the next evaluation.
    ///
    /// @param increment  where given, a change of all coordinates whose linear effect K increment
    ///                   is added to the internal force (prescribed motion enters this way).
    /// @param last       where given, the correction that led to q: elements that can then take the
    ///                   tangent of mixed integration points.
    /// @return the first element that failed, if one did; the results are then of no use.
    /// @throws InvalidArgument for vectors of another size, and as refresh().
    [[nodiscard]] std::optional<Fault> evaluate(const Configuration& at, Request request,
                                                const VectorX* increment = nullptr,
                                                const Correction* last = nullptr);

    /// Takes over what changed in the model; evaluate() does it of its own accord.
    /// @throws InvalidArgument where nodes, elements, supports, loads or constraints have changed.
    void refresh();

    // Results of the last evaluation; forces are of all coordinates, N and N m.

    /// Returns the elastic force Q_e.
    [[nodiscard]] const VectorX& internal_force() const noexcept { return internal_; }
    /// Returns the force of gravity at unit scale, as the elements give it.
    [[nodiscard]] const VectorX& gravity_force() const noexcept { return gravity_; }
    /// Returns the loads Q, gravity included.
    [[nodiscard]] const VectorX& external_force() const noexcept { return external_; }
    /// Returns the force of the constraints, G^T lambda.
    [[nodiscard]] const VectorX& constraint_force() const noexcept { return constraint_; }
    /// Returns what is out of balance at a coordinate, Q_e + G^T lambda - Q.
    [[nodiscard]] double unbalanced(int k) const noexcept {
        return internal_[k] + constraint_[k] - external_[k];
    }
    /// Returns g of the constraints, one entry per equation; m where g is a length.
    [[nodiscard]] const VectorX& violation() const noexcept { return violation_; }
    /// Returns what one coordinate can make of each g, to first order: a position that changes by
    /// `length`, a slope by 1, an r_xx by 1/length. A violation compares with that in any unit.
    /// @param length  m, positive.
    /// @return one entry per equation of the last evaluation, in the unit of its g.
    [[nodiscard]] VectorX violation_scale(double length) const;
    /// Returns U, J; after Request::force it is computed when first asked for.
    [[nodiscard]] double strain_energy() const;

    /// Returns the potential of gravity and of the loads that have one, J.
    [[nodiscard]] double load_potential() const noexcept { return load_potential_; }
    /// Returns what of it comes from angles, in the order of the loads.
    [[nodiscard]] const List<AnglePotential>& angle_potentials() const noexcept { return angles_; }
    /// Returns the tangent, in the pattern.
    [[nodiscard]] const SparseMatrix& tangent() const noexcept { return tangent_; }
    /// Returns its values, for terms of a solver's own; the next evaluation writes them anew.
    [[nodiscard]] double* tangent_values() noexcept { return tangent_.valuePtr(); }
    /// Returns -dQ/dv, in the pattern.
    [[nodiscard]] const SparseMatrix& damping() const noexcept { return damping_; }

    /// Returns the first element whose coordinates are not finite or not admissible.
    /// @throws InvalidArgument for a q of another size.
    [[nodiscard]] std::optional<Fault> inspect(const VectorX& q) const;

    /// Returns the first element whose energy, force or tangent is not finite.
    /// @throws InvalidArgument for a q of another size.
    [[nodiscard]] std::optional<Fault> inspect_values(const VectorX& q) const;

    /// Returns the same as inspect() of all parts, collectively: an element of another part is -1.
    [[nodiscard]] std::optional<Fault> inspect_parts(const VectorX& q) const;

    /// Returns what failed in the last evaluation, in words: the element, or the driven support,
    /// load or constraint whose values are no numbers.
    [[nodiscard]] std::string describe(const Fault& fault) const;

    /// Returns the first element so short that its law softens; CrossSectionBeam tells, with any
    /// centre line.
    /// @throws InvalidArgument for a q of another size.
    [[nodiscard]] std::optional<ElementPlace> softened(const VectorX& q) const;

    /// Returns the largest angle between the slopes r_x at the two ends of an element, from 0 to pi
    /// rad, that of a curved stress-free shape included; 0 without elements that have slopes.
    /// @throws InvalidArgument for a q of another size.
    [[nodiscard]] double largest_turn(const VectorX& q) const;

    /// Writes the residual of the unknowns.
    void residual(VectorX& out) const;
    /// Writes the same with the stresses that the tangent has: those predicted, where the last
    /// evaluation was given a correction, and no effect of an increment.
    void predicted_residual(VectorX& out) const;

    /// Returns g_t of dg/dt = G v + g_t, one entry per equation; m/s where g is a length.
    [[nodiscard]] const VectorX& violation_rate() const noexcept { return violation_rate_; }

    /// Returns the derivative of the external force with respect to the load factor, where the
    /// instant is that factor: N and N m.
    /// @param side  0: central; 1, -1: by the loads above or below the factor alone, as a load may
    ///              begin or end there.
    [[nodiscard]] VectorX load_rate(const VectorX& q, double factor, double side = 0.0) const;

    /// Adds the derivative of the loads' part of the tangent by the load factor, just above the
    /// factor 0, to a matrix of this pattern: exact however small it is beside the tangent.
    void add_load_tangent_rate(const VectorX& q, SparseMatrix& matrix) const;

    /// Adds scale (K(q + change) - K(q - change)) of the loads at the factor 0, less its round-off,
    /// to a matrix of this pattern; K is their part of the tangent.
    void add_load_tangent_change(const VectorX& q, const VectorX& change, double scale,
                                 SparseMatrix& matrix) const;

    /// Returns the first load, amplitudes aside, whose force is another at other rates; -1 where
    /// there is none. Vectors have an entry per coordinate.
    [[nodiscard]] int damping_load(const VectorX& q, const VectorX& v, const VectorX& others,
                                   double time) const;

    // Inertia, as the prototypes are now, constant in q.

    /// Returns the mass matrix in the pattern of the tangent; zero for the multipliers.
    [[nodiscard]] SparseMatrix mass() const;

    /// Returns M a for a vector of all coordinates.
    [[nodiscard]] VectorX mass_product(const VectorX& a) const;

    /// Sets the driven coordinates of q to their values at an instant.
    void apply_supports(const Instant& instant, VectorX& q) const;

    /// Writes the indices of the nodal coordinates of an element, as many as its type has.
    void element_coordinates(const ElementPlace& place, int* out) const;
    /// Writes the nodal coordinates of an element, taken from all coordinates.
    void gather_element(const ElementPlace& place, const VectorX& q, double* e) const;

    /// Adds a square block of an element, by columns, to a matrix of this pattern.
    void add_block(const ElementPlace& place, const double* block, SparseMatrix& matrix) const {
        const auto group = static_cast<std::size_t>(place.group);
        model_.groups()[group]->add_block(place.element, target(group, matrix.valuePtr()), block);
    }

    /// Returns the coordinates of a load.
    [[nodiscard]] const detail::LocalCoordinates& load_coordinates(std::size_t load) const {
        return load_coordinates_[load];
    }
    /// Returns the coordinates of a constraint.
    [[nodiscard]] const detail::LocalCoordinates& constraint_coordinates(
        std::size_t constraint) const {
        return constraint_coordinates_[constraint];
    }

    /// Adds scale times a matrix on some coordinates to a matrix of this pattern.
    void add_matrix(const List<int>& coordinates, double scale, const MatrixX& local,
                    SparseMatrix& matrix) const;
    /// Calls visit(i, j, place, mirrored) for the entries G_ij of one constraint, j of those of its
    /// coordinates that are unknowns: the places of G_ij and of its mirror image in G^T among the
    /// values of a matrix of this pattern.
    template <class Visitor>
    void visit_border(int constraint, const List<int>& coordinates, const Visitor& visit) const {
        const int own = numbering_.constraint_block(constraint);
        const int equations = pattern_.first(own + 1) - pattern_.first(own);
        for (int j = 0; j < static_cast<int>(coordinates.size()); ++j) {
            const int equation = numbering_.equation(coordinates[j]);
            if (equation < 0) continue;
            const int node = numbering_.block(coordinates[j]);
            const int column = equation - pattern_.first(node);
            const int place = pattern_.base(own, node) + pattern_.column_offset(node, column);
            const int mirrored = pattern_.base(node, own) + column;
            for (int i = 0; i < equations; ++i)
                visit(i, j, place + i, mirrored + pattern_.column_offset(own, i));
        }
    }

private:
    // Returns the place of the first driven support whose entry is not finite, -1: none.
    [[nodiscard]] int faulty_support(const VectorX& entries) const;
    // values of the matrix from first to before last
    struct ValueRange {
        int first;
        int last;
    };
    using ValueRanges = List<ValueRange>;

    // Where and in which order the elements of a group add.
    struct GroupPlan {
        List<ElementSlots> slots;
        ElementSchedule schedule;
        ValueRanges cleared;              // run by run
        List<std::size_t> first_cleared;  // of each run, and the end
        List<detail::AttachedElement> attached;
    };

    // Evaluates this part of a scene alone.
    [[nodiscard]] std::optional<Fault> evaluate_own(const Configuration& at, Request request,
                                                    const VectorX* increment,
                                                    const Correction* last);
    // Throws where nodes, elements, supports, loads or constraints of the model have changed.
    void check_scene() const;
    void check_size(const char* call, const char* what, const VectorX& given) const {
        check_scene();
        detail::require(given.size() == numbering_.coordinates(), "Assembly::", call, ": expected ",
                        numbering_.coordinates(), " ", what, ", got ", given.size());
    }
    void list_coordinates();
    void build_pattern(Storage storage);
    [[gnu::cold]] void list_followed();
    // Throws where an attached position follows a slope that would move without stiffness.
    [[gnu::cold]] void check_arms() const;
    void build_slots(std::size_t group);
    // Returns where a group adds, with its tangents to these values.
    [[nodiscard]] GroupTarget target(std::size_t group, double* values) const;
    void build_clearing();
    void clear_values(const ValueRange* first, const ValueRange* last) {
        for (; first != last; ++first)
            std::fill(tangent_.valuePtr() + first->first, tangent_.valuePtr() + first->last, 0.0);
    }
    void build_gravity();

    // Of the group, the prototype and the coordinates of an element.
    using Judge = std::function<bool(const ElementGroup&, int, const double*)>;
    // Returns the first element that it is true of.
    [[nodiscard]] std::optional<ElementPlace> find_element(const VectorX& q,
                                                           const Judge& judge) const;
    // Calls visit(place of the element, its coordinates) for the elements of a group.
    template <class Visitor>
    void for_each_element(std::size_t group, const Visitor& visit) const;

    // Calls visit(load, coordinates that it acts on, result) for every load.
    template <class Visitor>
    void for_each_load(const VectorX& q, const VectorX& v, double time, bool derivatives,
                       const Visitor& visit) const;
    void add_elements(const Configuration& at, Request request, const VectorX* increment,
                      const Correction* last);
    void add_loads(const Configuration& at, Request request);
    void add_constraints(const Configuration& at, Request request);
    void add_constraint_blocks(int constraint, ConstraintResult& result);

    const Scene& model_;
    Numbering numbering_;
    BlockPattern pattern_;
    List<GroupPlan> plans_;      // per group
    ValueRanges cleared_first_;  // columns that no element adds to
    ElementSchedule::Followed followed_;
    List<detail::LocalCoordinates> load_coordinates_;
    List<detail::LocalCoordinates> constraint_coordinates_;
    List<List<int>> constraint_powers_;  // of a length, per coordinate
    Revision revision_;                  // of the model that this is set up for
    VectorX gravity_;                    // force of gravity at unit scale

    VectorX internal_, predicted_, external_, constraint_, violation_, violation_rate_;
    ConstraintState constraint_state_;  // where, and what, of one constraint
    ConstraintResult constraint_result_;
    List<std::array<double, 3>> steepest_;  // |dg/dq| of r_xx, slopes, r by equation
    VectorX force_q_;                       // coordinates of the last evaluation of forces alone
    mutable bool energy_known_ = true;      // else it is that at force_q_, to be computed
    mutable double strain_energy_ = 0.0;
    double load_potential_ = 0.0;
    List<AnglePotential> angles_;
    int faulty_load_ = -1, faulty_constraint_ = -1;  // of the last evaluation; -1: none
    SparseMatrix tangent_, damping_;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/assembly/assembly.ipp>
#endif
