// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A scene of either dimension: nodes, elements of any types, supports, loads and constraints, and
/// its state.
///
/// Assembly, solvers, integrators and output take a Scene, so a function of yours that takes one is
/// no template. What has the dimension in its arguments, such as adding a node, is in model.hpp.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/attachment.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/model/element_group.hpp>
#include <ancf/model/exchange.hpp>
#include <ancf/model/group_of.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/load.hpp>
#include <ancf/model/state.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace ancf {

/// Returns lines between points, constant before the first and behind the last.
/// @param points  time, s (in statics the load factor), and factor, by rising time.
/// @throws InvalidArgument unless there are points, finite and of rising times.
[[nodiscard]] Amplitude tabular_amplitude(List<std::pair<double, double>> points);

/// A load with its course over time; without one it follows the ramp of an Instant.
struct ScaledLoad {
    AnyLoad load;         ///< what acts
    Amplitude amplitude;  ///< factor over time; empty: the ramp

    /// Returns its factor at an instant.
    [[nodiscard]] double scale(const Instant& instant) const {
        return amplitude ? amplitude(instant.time) : instant.ramp;
    }
};

/// How often a model has changed. Data computed from a model are valid while this is the same.
struct Revision {
    long scene = 0;       ///< nodes, elements, supports, loads, constraints
    long properties = 0;  ///< prototypes, masses at nodes, gravity

    /// Tells whether both counts are the same.
    [[nodiscard]] bool operator==(const Revision& other) const noexcept {
        return scene == other.scene && properties == other.properties;
    }
};

/// A mass at a point, kg.
struct PointMass {
    NodeId node;  ///< where
    double mass;  ///< kg
};

/// What of a scene a part holds: indices in the lists of the scene.
struct ScenePart {
    List<List<int>> elements;  ///< of each group: indices of its elements
    List<int> loads;           ///< indices in loads()
    List<int> constraints;     ///< indices in constraints()
    List<int> masses;          ///< indices in masses()
    List<char> nodes;          ///< of every node: whether the part has it
};

namespace detail {

/// Groups of elements; a copy of the list has copies of them.
struct ElementGroups : List<std::unique_ptr<ElementGroup>> {
    ElementGroups() = default;
    ElementGroups(const ElementGroups& other) : ElementGroups() {
        for (const auto& group : other) push_back(group->clone());
    }
    ElementGroups(ElementGroups&&) = default;
    ElementGroups& operator=(ElementGroups&&) = default;
};

/// What a scene holds.
class SceneContents {
protected:
    struct InitialNode {
        Fields fields;
        std::array<double, 3 * field_count> vectors;
        int last_support = -1, last_attachment = -1;  // places in supports_ and attachments_
        bool held = false;  // clamped or attached, each vector that it had
    };

    List<InitialNode> initial_;
    ElementGroups groups_;
    List<Support> supports_;
    List<int> support_before_;  // of the same node: place in supports_, -1: none
    List<ScaledLoad> loads_;
    List<AnyConstraint> constraints_;
    List<AttachedVector> attachments_;
    List<int> attachment_before_;  // likewise
    List<PointMass> masses_;
    std::array<double, 3> gravity_ = {};
    Amplitude gravity_amplitude_;
    std::shared_ptr<const Exchange> exchange_;

    Revision revision_;

    // Derived from the above when first asked for after a change.
    mutable bool layout_stale_ = true;  // layout_
    mutable bool rebuild_ = true;       // what is in layout_ has changed too
    mutable bool state_stale_ = true;   // state_ and dependence_
    mutable int state_nodes_ = 0;       // nodes in state_: the first ones of layout_
    mutable Layout layout_;
    mutable List<std::array<double, 2>> torsion_;  // stiffness at each node of layout_
    mutable List<int> counted_;                    // of each group: elements in torsion_
    mutable Dependence dependence_;
    mutable State state_;
};

}  // namespace detail

/// What a model is, whatever its dimension. Model and PlanarModel are what a program makes.
///
/// It is built once and then solved or integrated; it holds no solver. Nodes carry the union of the
/// vectors that their elements need. Equal elements share one prototype. Element types mix freely:
/// each has a group, in the order in which their first prototypes were added.
class Scene : detail::SceneContents {
public:
    /// Copies nodes, elements, supports, loads, constraints and state.
    Scene(const Scene& other);
    /// Takes all of that over and leaves an empty scene.
    Scene(Scene&& other) noexcept;
    /// Replaces all of that; data computed from this scene are then no longer valid.
    /// @throws InvalidArgument for a scene of another dimension.
    Scene& operator=(const Scene& other);
    /// Replaces all of that likewise.
    /// @throws InvalidArgument for a scene of another dimension.
    Scene& operator=(Scene&& other);
    ANCF_INLINE_VIRTUAL virtual ~Scene();

    /// Returns the dimension of space, 2 or 3.
    [[nodiscard]] int dimension() const noexcept { return dimension_; }

    /// Adds an element type's constant data for several equal elements to share.
    /// @return its index for `connect`.
    /// @throws InvalidArgument for an element of another dimension or without a length.
    template <class Element>
    int add_prototype(Element element) {
        check_dimension("an element", Element::dimension);
        detail::require_positive("Scene::add_prototype: the length of an element",
                                 element.length());
        if (find_group<Element>() == nullptr) groups_.push_back(detail::make_group<Element>());
        return detail::append_prototype<Element>(found_group<Element>(), std::move(element));
    }

    /// Adds an element between two nodes. Elements on a common node share its slopes: at an angle
    /// give each a node of its own, and attach or join these.
    /// @return its index in its group.
    /// @throws InvalidArgument for a node or a prototype that does not exist, equal nodes, or a
    ///         node that was clamped or attached with fewer vectors than the element needs.
    template <class Element>
    int connect(int prototype, NodeId first, NodeId second) {
        return connect_in(find_group<Element>(), prototype, first, second);
    }

    /// Returns all elements of one type.
    /// @throws InvalidArgument where the model has none of that type.
    template <class Element>
    [[nodiscard]] const GroupOf<Element>& group() const {
        return static_cast<const GroupOf<Element>&>(found_group<Element>());
    }

    /// Returns the groups of all types, in their order.
    [[nodiscard]] const List<std::unique_ptr<ElementGroup>>& groups() const noexcept {
        return groups_;
    }

    /// Returns a prototype for a change of stiffness, density or rest length at any time.
    ///
    ///     using Beam = ancf::CrossSectionBeam<3>;
    ///     model.prototype<Beam>(beam.prototypes[0]) = Beam(material, section, length);  // all
    ///     model.prototype<Beam>(model.make_own_prototype<Beam>(3)) = ...;  // element 3 alone
    ///
    /// The next evaluation takes over the change, mass and gravity included, also of a problem made
    /// before. What was computed from the elements keeps its values: line loads, all damping,
    /// points along an element (loads and constraints are not made anew). Call this for every
    /// change: one through a reference kept from before goes unnoticed.
    /// @throws InvalidArgument for an index of none.
    template <class Element>
    [[nodiscard]] Element& prototype(int index) {
        auto& group = static_cast<GroupOf<Element>&>(found_group<Element>());
        check_prototype(group, index);
        ++revision_.properties;
        rebuild_ = true;
        return group.prototypes[index];
    }

    /// Gives an element a copy of its prototype where it shares it, for a change of it alone.
    ///
    /// References to prototypes end. Neighbours that differ are evaluated one by one, not several
    /// at once.
    /// @param element  index in the group of its type.
    /// @return the index of the prototype that no other element has.
    /// @throws InvalidArgument for an index of no element.
    template <class Element>
    int make_own_prototype(int element) {
        auto& group = static_cast<GroupOf<Element>&>(found_group<Element>());
        const int shared = group.connection(element).prototype;
        if (has_own_prototype(group, element)) return shared;
        const int own = add_prototype(Element(group.element(element)));
        group.connections[element].prototype = own;
        return own;
    }

    // Supports. A component has one: the last that was given to it replaces those before.

    /// Holds every component of the given vectors where they stand.
    /// @throws InvalidArgument for a node that does not exist.
    void fix(NodeId node, Fields fields);

    /// Holds one component of a vector where it stands.
    /// @throws InvalidArgument for a node or component that does not exist.
    void fix(NodeId node, Field field, int component);

    /// Drives one component of a vector; rate and acceleration are needed in dynamics only, where
    /// they are taken as they are: they must be the value's derivatives.
    /// @param value  the component itself, not its change; of time, in statics of the load factor.
    /// @throws InvalidArgument for a node or component that does not exist, or a rate or an
    ///         acceleration without a value.
    void prescribe(NodeId node, Field field, int component, Amplitude value, Amplitude rate = {},
                   Amplitude acceleration = {});

    /// Holds position and slopes of a node, or all of them but r_x; never r_xx, r_xy.
    /// @throws InvalidArgument for a node that does not exist.
    void clamp(NodeId node, Clamp clamp = Clamp::full);

    /// Holds the position of a node.
    /// @throws InvalidArgument for a node that does not exist.
    void pin(NodeId node) { fix(node, Field::r); }

    /// Frees what was held or driven of a vector, in all components.
    /// @throws InvalidArgument for a node that does not exist or a vector that is attached.
    void release(NodeId node, Field field);

    /// Attaches a node rigidly to another one, at the place and in the directions that they have in
    /// the reference: its position, and the slopes that hold its section.
    ///
    /// Of a node with r_z in space, or r_y in the plane, these are r and all slopes across: r_x
    /// stays its own, so that each beam at a joint has its own stretch. Of a node with r_y alone in
    /// space, r, r_x and r_y. Of a node of cables r alone, which is a pin.
    ///
    /// A node on the axis beyond a beam's end follows r_x, which stretches: more on finer meshes.
    /// Attach it to a rigid body or to a joint of frame(): docs/limits.md, "Frames".
    /// @param end    connect its elements, or add its mass, first.
    /// @param joint  gets the vectors that are followed; docs/theory-frames.md says which joint
    ///               needs a stiffness of its own.
    /// @throws InvalidArgument as the other overload.
    void attach(NodeId end, NodeId joint);

    /// Attaches the given vectors of a node to another one: a constant linear combination of that
    /// node's vectors each, as in the reference. They are no unknowns any more.
    ///
    ///     attach(end, joint, Field::r);                 // a pin
    ///     attach(end, joint, Field::r | Field::r_z);    // a hinge about r_z
    ///
    /// An offset below 1e-12 of the coordinates that it is the difference of counts as none.
    /// @throws InvalidArgument for no vectors, a node that does not exist or carries no such
    ///         vector, a vector that is attached already, held, r_xx or r_xy, a node that follows
    ///         another one already, nodes that would follow each other in a circle, and a joint
    ///         whose slopes are not independent.
    void attach(NodeId end, NodeId joint, Fields vectors);

    /// Adds a load; `amplitude` scales it over time (over the load factor in statics). Without one
    /// it grows with the load factor in statics, unless it declares `in_full` as Spring does, and
    /// acts in full from the start of a motion.
    /// @throws InvalidArgument for a node that does not exist, a load of another dimension or a
    ///         force of another size.
    template <class Load, std::enable_if_t<is_load_v<Load>, int> = 0>
    void add(Load load, Amplitude amplitude = {}) {
        check_dimension("a load", detail::dimension_of<Load>::value);
        if constexpr (detail::offers<detail::ActsInFull, Load>)
            if (!amplitude) amplitude = [](double) { return 1.0; };
        add_load(AnyLoad(std::move(load)), std::move(amplitude));
    }

    /// Adds a constraint; returns its place in constraints().
    /// @throws InvalidArgument for a node that does not exist, a constraint of another dimension or
    ///         of no equations.
    template <class Constraint, std::enable_if_t<is_constraint_v<Constraint>, int> = 0>
    int add(Constraint constraint) {
        check_dimension("a constraint", detail::dimension_of<Constraint>::value);
        add_constraint(AnyConstraint(std::move(constraint)));
        return static_cast<int>(constraints_.size()) - 1;
    }

    /// Stops the compilation: what is added is neither a load nor a constraint.
    template <class Other, std::enable_if_t<!is_load_v<Other> && !is_constraint_v<Other>, int> = 0>
    int add(const Other&, const Amplitude& = {}) {
        static_assert(
            is_load_v<Other>,
            "Model::add takes a load, which offers `Coupling coupling() const` and `void "
            "evaluate(const LoadState&, LoadResult&) const`, or a constraint, which offers "
            "`Coupling coupling() const`, `int equations() const`, `std::string name() const` and "
            "`void evaluate(const ConstraintState&, ConstraintResult&) const`");
        return -1;
    }

    /// Adds a mass at a node, kg; gravity acts on it. A node without elements then has a position:
    /// it is free, on springs or joints, or attached as an eccentric mass.
    /// @throws InvalidArgument for a node that does not exist, or a mass that is not positive.
    void add_mass(NodeId node, double mass);

    /// Returns a part of the scene, in its present state, with the numbers of all nodes: those that
    /// the part has not carry no vectors. Supports and attachments come with their nodes.
    /// @param exchange  tells the parts of each other's forces.
    /// @throws InvalidArgument for another number of groups or nodes than the scene has, or a part
    ///         that has a node and not the nodes that it follows.
    [[nodiscard]] std::unique_ptr<Scene> part(
        const ScenePart& held, std::shared_ptr<const detail::Exchange> exchange) const;

    /// Returns what joins a part to the others; none of a whole scene.
    [[nodiscard]] const detail::Exchange* exchange() const noexcept { return exchange_.get(); }

    /// Returns how often the model has changed, its state aside.
    [[nodiscard]] const Revision& revision() const noexcept { return revision_; }
    /// Returns the number of nodes.
    [[nodiscard]] int nodes() const noexcept { return static_cast<int>(initial_.size()); }
    /// Returns what is held or driven.
    [[nodiscard]] const List<Support>& supports() const noexcept { return supports_; }
    /// Returns the loads.
    [[nodiscard]] const List<ScaledLoad>& loads() const noexcept { return loads_; }
    /// Tells whether the stiffness of every load is symmetric.
    [[nodiscard]] bool has_symmetric_loads() const noexcept {
        return std::all_of(loads_.begin(), loads_.end(),
                           [](const ScaledLoad& load) { return load.load.symmetric(); });
    }
    /// Returns the constraints.
    [[nodiscard]] const List<AnyConstraint>& constraints() const noexcept { return constraints_; }
    /// Returns the attached vectors.
    [[nodiscard]] const List<AttachedVector>& attachments() const noexcept { return attachments_; }
    /// Returns what the attached vectors follow.
    [[nodiscard]] const Dependence& dependence() const {
        update_state();
        return dependence_;
    }
    /// Returns the masses at nodes.
    [[nodiscard]] const List<PointMass>& masses() const noexcept { return masses_; }
    /// Returns a component of the acceleration of gravity, m/s^2.
    [[nodiscard]] double gravity_component(int k) const { return gravity_[k]; }
    /// Returns the factor of gravity at an instant.
    [[nodiscard]] double gravity_scale(const Instant& instant) const {
        return gravity_amplitude_ ? gravity_amplitude_(instant.time) : instant.ramp;
    }

    /// Returns the order of coordinates.
    [[nodiscard]] const Layout& layout() const {
        refresh();
        return layout_;
    }

    /// Returns the index in `State::q` of the first component of a node's vector.
    /// @throws InvalidArgument where the node does not carry it.
    [[nodiscard]] int coordinate(NodeId node, Field field) const;

    /// Returns coordinates, rates, multipliers and time.
    [[nodiscard]] const State& state() const {
        update_state();
        return state_;
    }
    /// Returns coordinates, rates, multipliers and time.
    [[nodiscard]] State& state() {
        update_state();
        return state_;
    }

    /// Returns the nodal coordinates of an element, taken from `q` of this model's layout.
    /// @throws InvalidArgument for an element that does not exist or a q of another size.
    template <class Element>
    [[nodiscard]] typename Element::Coordinates element_coordinates(int index,
                                                                    const VectorX& q) const {
        typename Element::Coordinates e;
        gather_element(found_group<Element>(), index, q, e.data());
        return e;
    }

    /// Returns the nodal coordinates of an element as they stand now.
    template <class Element>
    [[nodiscard]] typename Element::Coordinates element_coordinates(int index) const {
        return element_coordinates<Element>(index, state().q);
    }

protected:
    /// @throws InvalidArgument unless coordinates, or rates, are as many as a layout has.
    static void check_state(const VectorX& of, const Layout& layout);

    /// @throws InvalidArgument for a node that does not exist.
    void check(NodeId node) const;

    /// Returns the components of a vector as it stands now.
    [[nodiscard]] const double* vector_now(NodeId node, Field field) const;

    /// Returns the components of a vector in the reference.
    [[nodiscard]] const double* vector_added(NodeId node, Field field) const {
        check(node);
        return initial_[node.index].vectors.data() + 3 * static_cast<int>(field);
    }

    /// @throws InvalidArgument for an attached vector.
    void check_unattached(const char* call, NodeId node, Field field) const;

    /// @param dimension  of space, 2 or 3
    explicit Scene(int dimension) noexcept;

    /// Adds a node.
    /// @param vectors  r, r_x, r_y, r_z, r_xy and r_xx, each of as many components as space has
    NodeId add_initial_node(const std::array<double, 3 * field_count>& vectors);
    /// Sets the acceleration of gravity, m/s^2; what is beyond the dimension is zero.
    void set_gravity_components(const std::array<double, 3>& gravity, Amplitude amplitude);

private:
    // Not inlined: a program needs it once, and looks elements up at many places.
    template <class Element>
    [[nodiscard]] ANCF_NOINLINE ElementGroup* find_group() const noexcept {
        for (const auto& group : groups_)
            if (group->holds<Element>()) return group.get();
        return nullptr;
    }
    template <class Element>
    [[nodiscard]] ElementGroup& found_group() const {
        ElementGroup* const group = find_group<Element>();
        if (group == nullptr) reject_group(detail::type_name<Element>());
        return *group;
    }
    void swap(Scene& other) noexcept;
    void check_attachment(NodeId end, NodeId joint, Field field) const;
    // Returns f of v = f_1 r_x + f_2 r_y + f_3 r_z of a node's reference.
    [[nodiscard]] std::array<double, 3> by_slopes(NodeId node, const double* v) const;
    [[nodiscard]] const AttachedVector* attachment_of(NodeId node, Field field) const noexcept;
    [[noreturn]] void reject_group(std::string_view name) const;
    int connect_in(ElementGroup* group, int prototype, NodeId first, NodeId second);
    // Returns whether an element has its prototype for itself.
    [[nodiscard]] static bool has_own_prototype(const ElementGroup& group, int element);
    static void check_prototype(const ElementGroup& group, int index);
    void gather_element(const ElementGroup& group, int index, const VectorX& q, double* e) const;

    void check_dimension(const char* what, int dimension) const;
    void add_load(AnyLoad load, Amplitude amplitude);
    void add_constraint(AnyConstraint constraint);
    // New nodes are appended to the layout; the state follows when it is asked for. The layout is
    // made anew where nodes that it has get more vectors, elements of a second type, or prototypes.
    void refresh() const;
    void update_state() const;
    void add_torsion() const;
    [[nodiscard]] bool state_fits(const Layout& layout) const noexcept {
        const int size = layout.first(state_nodes_);
        return state_.q.size() == size && state_.v.size() == size;
    }
    void fit_state(const Layout& before) const;
    void check_widening(const char* call, NodeId node, Fields fields) const;
    void widen(NodeId node, Fields fields);

    // Returns the place of a support in supports_, -1 where there is none.
    [[nodiscard]] int support_of(NodeId node, Field field, int component) const noexcept;
    void append(Support support);
    void append(const AttachedVector& attachment);

    int dimension_;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/scene.ipp>
#endif
