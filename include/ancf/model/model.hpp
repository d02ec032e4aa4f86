// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A scene: nodes, elements of the listed types, supports, loads and constraints, and its state.
///
/// A model is built once and then solved or integrated; it knows no solver. Nodes carry the union
/// of the vectors that their elements need. Equal elements share one prototype.

#pragma once

#include <ancf/error.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/load.hpp>
#include <ancf/model/node.hpp>
#include <ancf/model/state.hpp>
#include <ancf/model/support.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ancf {

/// An element of a group: which prototype, between which nodes.
struct Connection {
    int prototype;  ///< index in the group
    NodeId first;   ///< node at x = 0
    NodeId second;  ///< node at x = l
};

/// All elements of one type.
template <class Element>
struct ElementGroup {
    std::vector<Element> prototypes;      ///< constant data, shared by equal elements
    std::vector<Connection> connections;  ///< one for each element

    /// Returns which prototype an element has and its nodes.
    /// @throws InvalidArgument for an index of no element.
    [[nodiscard]] const Connection& connection(int index) const {
        detail::require(index >= 0 && index < static_cast<int>(connections.size()),
                        "Model: there are ", connections.size(),
                        " elements of this type, got index ", index);
        return connections[static_cast<std::size_t>(index)];
    }

    /// Returns the prototype of an element.
    /// @throws InvalidArgument for an index of no element.
    [[nodiscard]] const Element& element(int index) const {
        return prototypes[static_cast<std::size_t>(connection(index).prototype)];
    }
};

/// A load with its course over time; without one it follows the ramp of an Instant.
struct ScaledLoad {
    AnyLoad load;         ///< what acts
    Amplitude amplitude;  ///< factor over time; empty: the ramp

    /// Returns its factor at an instant.
    [[nodiscard]] double scale(const Instant& instant) const {
        return amplitude ? amplitude(instant.time) : instant.ramp;
    }
};

/// How often a model has changed: whoever keeps data of it knows by this whether they still hold.
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

namespace detail {

template <class Element, class = void>
struct HasTorsionStiffness : std::false_type {};
template <class Element>
struct HasTorsionStiffness<Element, std::void_t<decltype(Vector<double, 2>(
                                        std::declval<const Element&>().torsion_stiffness()))>>
    : std::true_type {};

}  // namespace detail

/// A scene of elements of the given types, all of one dimension.
template <class... Elements>
class Model {
    static_assert(sizeof...(Elements) > 0, "a model lists the element types that it may hold");

public:
    /// The first of the listed types.
    using DefaultElement = std::tuple_element_t<0, std::tuple<Elements...>>;
    static constexpr int dimension = DefaultElement::dimension;  ///< of space
    static_assert(((Elements::dimension == dimension) && ...),
                  "all elements of a model have the same dimension");

    using Point = Vector<double, dimension>;     ///< a vector of space
    using Argument = VectorArgument<dimension>;  ///< a vector, also in braces
    using Slopes = Matrix<double, dimension>;    ///< columns r_x, r_y (and r_z)

    /// Adds a node; it carries the vectors that the elements connected to it need.
    /// @param position   m.  @param slopes  columns r_x, r_y (and r_z) of the reference.
    /// @param curvature  r_xx of the reference, 1/m; elements of a quintic centre line have it.
    /// @throws InvalidArgument unless every value is finite.
    NodeId add_node(const Argument& position, const Slopes& slopes = Slopes::Identity(),
                    const Point& curvature = Point::Zero());

    /// Adds an element type's constant data for several equal elements to share.
    /// @return its index for `connect`.
    template <class Element>
    int add_prototype(Element element);

    /// Adds an element between two nodes.
    /// @return its index in its group.
    /// @throws InvalidArgument for a node or a prototype that does not exist, or equal nodes.
    template <class Element = DefaultElement>
    int connect(int prototype, NodeId first, NodeId second);

    // Supports. A component has one: the last that was given to it replaces those before.

    /// Holds every component of the given vectors where they stand.
    /// @throws InvalidArgument for a node that does not exist.
    void fix(NodeId node, Fields fields);

    /// Holds one component of a vector where it stands.
    /// @throws InvalidArgument for a node or component that does not exist.
    void fix(NodeId node, Field field, int component);

    /// Drives one component of a vector; rate and acceleration are needed in dynamics only, where
    /// they are taken as they are: they must be the value's derivatives.
    /// @throws InvalidArgument for a node or component that does not exist.
    void prescribe(NodeId node, Field field, int component, Amplitude value, Amplitude rate = {},
                   Amplitude acceleration = {});

    /// Holds position and slopes of a node, or all of them but r_x; never r_xx.
    /// @throws InvalidArgument for a node that does not exist.
    void clamp(NodeId node, Clamp clamp = Clamp::full);

    /// Holds the position of a node.
    /// @throws InvalidArgument for a node that does not exist.
    void pin(NodeId node) { fix(node, Field::r); }

    /// Frees what was held or driven of a vector.
    /// @throws InvalidArgument for a node that does not exist.
    void release(NodeId node, Field field);

    /// Adds a load; `amplitude` scales it over time (over the load factor in statics).
    /// @throws InvalidArgument for a node that does not exist or a force of another size.
    template <class Load, std::enable_if_t<is_load_v<Load>, int> = 0>
    void add(Load load, Amplitude amplitude = {});

    /// Adds a constraint.
    /// @throws InvalidArgument for a node that does not exist, or a constraint of no equations.
    template <class Constraint, std::enable_if_t<is_constraint_v<Constraint>, int> = 0>
    void add(Constraint constraint);

    /// Stops the compilation: what is added is neither a load nor a constraint.
    template <class Other, std::enable_if_t<!is_load_v<Other> && !is_constraint_v<Other>, int> = 0>
    void add(const Other&, const Amplitude& = {}) {
        static_assert(
            is_load_v<Other>,
            "Model::add takes a load, which offers `Coupling coupling() const` and `void "
            "evaluate(const LoadState&, LoadResult&) const`, or a constraint, which offers "
            "`Coupling coupling() const`, `int equations() const`, `std::string name() const` and "
            "`void evaluate(const ConstraintState&, ConstraintResult&) const`");
    }

    /// Adds a mass at a node, kg; gravity acts on it.
    /// @throws InvalidArgument for a node that does not exist, or a mass that is not positive.
    void add_mass(NodeId node, double mass);

    /// Sets the acceleration of gravity, m/s^2.
    /// @throws InvalidArgument unless every component is finite.
    void set_gravity(const Argument& gravity, Amplitude amplitude = {});

    // What a scene holds ---------------------------------------------------------------------

    /// Returns all elements of one type.
    template <class Element = DefaultElement>
    [[nodiscard]] const ElementGroup<Element>& group() const {
        return std::get<ElementGroup<Element>>(groups_);
    }

    /// Returns a prototype for a change of stiffness, density or rest length at any time.
    ///
    ///     model.prototype(beam.prototypes[0]) = Element(material, section, length);  // the beam
    ///     model.prototype(model.make_own_prototype(3)) = ...;                        // element 3
    ///
    /// The next evaluation takes over the change, mass and gravity included, also of a problem made
    /// before. What was computed from the elements keeps its values: line loads, all damping,
    /// points along an element (loads and constraints are not made anew). Call this for every
    /// change: one through a reference kept from before goes unnoticed.
    /// @throws InvalidArgument for an index of none.
    template <class Element = DefaultElement>
    [[nodiscard]] Element& prototype(int index) {
        auto& prototypes = std::get<ElementGroup<Element>>(groups_).prototypes;
        detail::require(index >= 0 && index < static_cast<int>(prototypes.size()),
                        "Model: there are ", prototypes.size(), " prototypes, got index ", index);
        ++revision_.properties;
        return prototypes[static_cast<std::size_t>(index)];
    }

    /// Gives an element a copy of its prototype where it shares it, for a change of it alone.
    ///
    /// References to prototypes end. Neighbours that differ are evaluated one by one, not several
    /// at once.
    /// @param element  index in the group of its type.
    /// @return the index of the prototype that no other element has.
    /// @throws InvalidArgument for an index of no element.
    template <class Element = DefaultElement>
    int make_own_prototype(int element);

    /// Returns how often the model has changed, its state aside.
    [[nodiscard]] const Revision& revision() const noexcept { return revision_; }

    /// Calls `visit(group)` for the group of each element type.
    template <class Visitor>
    void for_each_group(Visitor&& visit) const {
        std::apply([&](const auto&... groups) { (visit(groups), ...); }, groups_);
    }

    /// Returns the number of nodes.
    [[nodiscard]] int nodes() const noexcept { return static_cast<int>(initial_.size()); }
    /// Returns what is held or driven.
    [[nodiscard]] const std::vector<Support>& supports() const noexcept { return supports_; }
    /// Returns the loads.
    [[nodiscard]] const std::vector<ScaledLoad>& loads() const noexcept { return loads_; }
    /// Returns the constraints.
    [[nodiscard]] const std::vector<AnyConstraint>& constraints() const noexcept {
        return constraints_;
    }
    /// Returns the masses at nodes.
    [[nodiscard]] const std::vector<PointMass>& masses() const noexcept { return masses_; }
    /// Returns the acceleration of gravity, m/s^2.
    [[nodiscard]] const Point& gravity() const noexcept { return gravity_; }
    /// Returns the factor of gravity at an instant.
    [[nodiscard]] double gravity_scale(const Instant& instant) const {
        return gravity_amplitude_ ? gravity_amplitude_(instant.time) : instant.ramp;
    }

    /// Returns the order of coordinates.
    [[nodiscard]] const Layout& layout() const {
        refresh();
        return layout_;
    }

    // Where a scene is -----------------------------------------------------------------------

    /// Returns coordinates, rates, multipliers and time.
    [[nodiscard]] const State& state() const {
        refresh();
        return state_;
    }
    /// Returns coordinates, rates, multipliers and time.
    [[nodiscard]] State& state() {
        refresh();
        return state_;
    }

    /// Returns one vector of a node as it stands now.
    /// @throws InvalidArgument where the node does not carry it.
    [[nodiscard]] Point value(NodeId node, Field field) const {
        return state().q.template segment<dimension>(coordinate(node, field));
    }

    /// Sets one vector of a node.
    /// @throws InvalidArgument unless it is finite, and where the node does not carry it.
    void set_value(NodeId node, Field field, const Argument& value) {
        check_finite("set_value", node, field, value);
        state().q.template segment<dimension>(coordinate(node, field)) = value;
    }

    /// Sets the rate of one vector of a node.
    /// @throws InvalidArgument unless it is finite, and where the node does not carry it.
    void set_rate(NodeId node, Field field, const Argument& rate) {
        check_finite("set_rate", node, field, rate);
        state().v.template segment<dimension>(coordinate(node, field)) = rate;
    }

    /// Returns the position of a node, m.
    /// @throws InvalidArgument for a node that does not exist or has no position.
    [[nodiscard]] Point position(NodeId node) const { return value(node, Field::r); }

    /// Returns the velocity of a node, m/s.
    /// @throws InvalidArgument for a node that does not exist or has no position.
    [[nodiscard]] Point velocity(NodeId node) const {
        return state().v.template segment<dimension>(coordinate(node, Field::r));
    }

    /// Returns the nodal coordinates of an element, taken from `q` of this model's layout.
    /// @throws InvalidArgument for an element that does not exist or a q of another size.
    template <class Element = DefaultElement>
    [[nodiscard]] typename Element::Coordinates element_coordinates(int index,
                                                                    const VectorX& q) const;

    /// Returns the nodal coordinates of an element as they stand now.
    template <class Element = DefaultElement>
    [[nodiscard]] typename Element::Coordinates element_coordinates(int index) const {
        return element_coordinates<Element>(index, state().q);
    }

    /// Returns the index in `State::q` of the first component of a node's vector.
    /// @throws InvalidArgument where the node does not carry it.
    [[nodiscard]] int coordinate(NodeId node, Field field) const;

private:
    struct InitialNode {
        Fields fields;
        Matrix<double, dimension, field_count> vectors;
    };

    void refresh() const;
    [[nodiscard]] std::vector<double> torsion_shares() const;
    template <class Element>
    static void add_torsion(const ElementGroup<Element>& group,
                            std::vector<Vector<double, 2>>& stiffness);
    void check(NodeId node) const;
    void check_component(int component) const;
    static void check_finite(const char* call, NodeId node, Field field, const Point& value) {
        detail::require(value.allFinite(), "Model::", call, ": ", to_string(field), " of node ",
                        node.index, " must be finite, got ", detail::components(value));
    }

    /// Returns a number of its own for every component of every vector that a node may carry.
    [[nodiscard]] static long component_of(NodeId node, Field field, int component) {
        return (static_cast<long>(node.index) * field_count + static_cast<int>(field)) * dimension +
               component;
    }

    std::vector<InitialNode> initial_;
    std::tuple<ElementGroup<Elements>...> groups_;
    std::vector<Support> supports_;
    std::unordered_map<long, std::size_t> support_at_;  // place in supports_, by component_of()
    std::vector<ScaledLoad> loads_;
    std::vector<AnyConstraint> constraints_;
    std::vector<PointMass> masses_;
    Point gravity_ = Point::Zero();
    Amplitude gravity_amplitude_;

    Revision revision_;

    // Derived from the above when first asked for after a change.
    mutable bool stale_ = true;
    mutable Layout layout_;
    mutable State state_;
};

template <class... Elements>
NodeId Model<Elements...>::add_node(const Argument& position, const Slopes& slopes,
                                    const Point& curvature) {
    detail::require(position.allFinite(), "Model::add_node: the position must be finite, got ",
                    detail::components(position));
    detail::require(slopes.allFinite(), "Model::add_node: slopes must be finite, got (by columns) ",
                    detail::components(slopes));
    detail::require(curvature.allFinite(), "Model::add_node: the curvature must be finite, got ",
                    detail::components(curvature));
    InitialNode node;
    node.vectors.setZero();
    for (int i = 0; i < dimension; ++i) {
        node.vectors(i, 0) = position[i];
        for (int k = 0; k < dimension; ++k) node.vectors(i, 1 + k) = slopes(i, k);
        node.vectors(i, static_cast<int>(Field::r_xx)) = curvature[i];
    }
    initial_.push_back(node);
    stale_ = true;
    ++revision_.scene;
    return {nodes() - 1};
}

template <class... Elements>
template <class Element>
int Model<Elements...>::add_prototype(Element element) {
    static_assert((std::is_same_v<Element, Elements> || ...),
                  "the model's template arguments list the element types that it may hold");
    auto& prototypes = std::get<ElementGroup<Element>>(groups_).prototypes;
    prototypes.push_back(std::move(element));
    return static_cast<int>(prototypes.size()) - 1;
}

template <class... Elements>
template <class Element>
int Model<Elements...>::connect(int prototype, NodeId first, NodeId second) {
    auto& group = std::get<ElementGroup<Element>>(groups_);
    check(first);
    check(second);
    detail::require(first != second, "Model::connect: an element joins two nodes, got node ",
                    first.index, " twice");
    detail::require(prototype >= 0 && prototype < static_cast<int>(group.prototypes.size()),
                    "Model::connect: there are ", group.prototypes.size(),
                    " prototypes, got index ", prototype);
    group.connections.push_back({prototype, first, second});
    for (const NodeId node : {first, second}) {
        Fields& fields = initial_[static_cast<std::size_t>(node.index)].fields;
        fields = fields | Element::fields;
    }
    stale_ = true;
    ++revision_.scene;
    return static_cast<int>(group.connections.size()) - 1;
}

template <class... Elements>
template <class Element>
int Model<Elements...>::make_own_prototype(int element) {
    auto& group = std::get<ElementGroup<Element>>(groups_);
    const int shared = group.connection(element).prototype;
    const auto has_it = [=](const Connection& other) { return other.prototype == shared; };
    if (std::count_if(group.connections.begin(), group.connections.end(), has_it) == 1)
        return shared;
    const int own = add_prototype(Element(group.element(element)));
    group.connections[static_cast<std::size_t>(element)].prototype = own;
    return own;
}

template <class... Elements>
void Model<Elements...>::fix(NodeId node, Fields fields) {
    for (int k = 0; k < field_count; ++k) {
        const auto field = static_cast<Field>(k);
        if (!fields.contains(field)) continue;
        for (int component = 0; component < dimension; ++component) fix(node, field, component);
    }
}

template <class... Elements>
void Model<Elements...>::fix(NodeId node, Field field, int component) {
    prescribe(node, field, component, {});
}

template <class... Elements>
void Model<Elements...>::prescribe(NodeId node, Field field, int component, Amplitude value,
                                   Amplitude rate, Amplitude acceleration) {
    check(node);
    check_component(component);
    const auto [at, added] =
        support_at_.try_emplace(component_of(node, field, component), supports_.size());
    if (added) supports_.emplace_back();
    supports_[at->second] = {
        node, field, component, std::move(value), std::move(rate), std::move(acceleration)};
    ++revision_.scene;
}

template <class... Elements>
void Model<Elements...>::clamp(NodeId node, Clamp clamp) {
    check(node);
    const Fields carried = initial_[static_cast<std::size_t>(node.index)].fields;
    detail::require(!(carried == Fields()), "Model::clamp: node ", node.index,
                    " carries no vectors yet; connect its elements first");
    for (const Field field : {Field::r, Field::r_x, Field::r_y, Field::r_z}) {
        const bool held = clamp == Clamp::full || field != Field::r_x;
        if (held && carried.contains(field)) fix(node, field);
    }
}

template <class... Elements>
void Model<Elements...>::release(NodeId node, Field field) {
    check(node);
    const auto same = [&](const Support& s) { return s.node == node && s.field == field; };
    supports_.erase(std::remove_if(supports_.begin(), supports_.end(), same), supports_.end());
    support_at_.clear();
    for (std::size_t k = 0; k < supports_.size(); ++k)
        support_at_[component_of(supports_[k].node, supports_[k].field, supports_[k].component)] =
            k;
    ++revision_.scene;
}

template <class... Elements>
template <class Load, std::enable_if_t<is_load_v<Load>, int>>
void Model<Elements...>::add(Load load, Amplitude amplitude) {
    constexpr int of = detail::dimension_of<Load>::value;
    static_assert(of == 0 || of == dimension, "the load is of another dimension than the model");
    for (const NodeField& at : load.coupling()) check(at.node);
    if constexpr (detail::settles<Load>::value) load.settle(layout());
    if constexpr (detail::has_constant_force<Load>::value) {  // wrong sizes show wherever it stands
        const VectorX zero = VectorX::Zero(dimension * static_cast<int>(load.coupling().size()));
        LoadResult result{zero, {}, {}, 0.0};
        load.evaluate({zero, zero, 0.0, false}, result);
    }
    loads_.push_back({AnyLoad(std::move(load)), std::move(amplitude)});
    ++revision_.scene;
}

template <class... Elements>
template <class Constraint, std::enable_if_t<is_constraint_v<Constraint>, int>>
void Model<Elements...>::add(Constraint constraint) {
    constexpr int of = detail::dimension_of<Constraint>::value;
    static_assert(of == 0 || of == dimension,
                  "the constraint is of another dimension than the model; in the plane write "
                  "Pin<2>, Distance<2>, FixedCoordinate<2>");
    for (const NodeField& at : constraint.coupling()) check(at.node);
    detail::require(constraint.equations() > 0, "Model::add: constraint ", constraint.name(),
                    " has ", constraint.equations(), " equations, expected at least 1");
    constraints_.emplace_back(std::move(constraint));
    stale_ = true;
    ++revision_.scene;
}

template <class... Elements>
void Model<Elements...>::add_mass(NodeId node, double mass) {
    check(node);
    detail::require_positive("Model::add_mass: mass", mass);
    masses_.push_back({node, mass});
    ++revision_.properties;
}

template <class... Elements>
void Model<Elements...>::set_gravity(const Argument& gravity, Amplitude amplitude) {
    detail::require(gravity.allFinite(), "Model::set_gravity: components must be finite, got ",
                    detail::components(gravity));
    gravity_ = gravity;
    gravity_amplitude_ = std::move(amplitude);
    ++revision_.properties;
}

template <class... Elements>
template <class Element>
typename Element::Coordinates Model<Elements...>::element_coordinates(int index,
                                                                      const VectorX& q) const {
    const Connection& connection = group<Element>().connection(index);
    detail::require(q.size() == layout().size(), "Model::element_coordinates: expected ",
                    layout().size(), " coordinates, got ", q.size());
    typename Element::Coordinates e;
    int at = 0;
    for (const NodeId node : {connection.first, connection.second})
        for (int k = 0; k < field_count; ++k) {
            const auto field = static_cast<Field>(k);
            if (!Element::fields.contains(field)) continue;
            const int first = layout().index({node, field});
            for (int i = 0; i < dimension; ++i) e[at++] = q[first + i];
        }
    return e;
}

template <class... Elements>
int Model<Elements...>::coordinate(NodeId node, Field field) const {
    check(node);
    const int first = layout().index({node, field});
    detail::require(first >= 0, "Model: node ", node.index, " carries no ", to_string(field),
                    ", as no element there needs it");
    return first;
}

template <class... Elements>
void Model<Elements...>::refresh() const {
    if (!stale_) return;
    std::vector<Fields> fields;
    fields.reserve(initial_.size());
    for (const InitialNode& node : initial_) fields.push_back(node.fields);
    const Layout before =
        std::exchange(layout_, Layout(dimension, std::move(fields), torsion_shares()));
    const State old = std::exchange(state_, State{});
    state_.time = old.time;
    state_.q.setZero(layout_.size());
    state_.v.setZero(layout_.size());
    for (int node = 0; node < nodes(); ++node)
        for (int k = 0; k < field_count; ++k) {
            const NodeField at{{node}, static_cast<Field>(k)};
            const int to = layout_.index(at);
            if (to < 0) continue;
            const int from = node < before.nodes() ? before.index(at) : -1;
            const auto& vectors = initial_[static_cast<std::size_t>(node)].vectors;
            for (int i = 0; i < dimension; ++i) {
                state_.q[to + i] = from >= 0 ? old.q[from + i] : vectors(i, k);
                if (from >= 0) state_.v[to + i] = old.v[from + i];
            }
        }
    int equations = 0;
    for (const AnyConstraint& constraint : constraints_) equations += constraint.equations();
    state_.multipliers.setZero(equations);
    const auto kept = std::min<Eigen::Index>(equations, old.multipliers.size());
    state_.multipliers.head(kept) = old.multipliers.head(kept);
    stale_ = false;
}

template <class... Elements>
std::vector<double> Model<Elements...>::torsion_shares() const {
    if constexpr (!(detail::HasTorsionStiffness<Elements>::value || ...)) return {};
    std::vector<Vector<double, 2>> stiffness(initial_.size(), Vector<double, 2>(0.0, 0.0));
    (add_torsion(std::get<ElementGroup<Elements>>(groups_), stiffness), ...);
    std::vector<double> shares;
    shares.reserve(stiffness.size());
    for (const Vector<double, 2>& of : stiffness) {
        const double sum = of[0] + of[1];
        shares.push_back(sum > 0.0 ? of[0] / sum : 0.5);
    }
    return shares;
}

template <class... Elements>
template <class Element>
void Model<Elements...>::add_torsion(const ElementGroup<Element>& group,
                                     std::vector<Vector<double, 2>>& stiffness) {
    if constexpr (detail::HasTorsionStiffness<Element>::value) {
        for (const Connection& connection : group.connections) {
            const Vector<double, 2> own =
                group.prototypes[static_cast<std::size_t>(connection.prototype)]
                    .torsion_stiffness();
            for (const NodeId node : {connection.first, connection.second})
                for (int k = 0; k < 2; ++k)
                    stiffness[static_cast<std::size_t>(node.index)][k] += own[k];
        }
    }
}

template <class... Elements>
void Model<Elements...>::check(NodeId node) const {
    detail::require(node.index >= 0 && node.index < nodes(), "Model: there are ", nodes(),
                    " nodes, got node ", node.index);
}

template <class... Elements>
void Model<Elements...>::check_component(int component) const {
    detail::require(component >= 0 && component < dimension, "Model: a vector has ", dimension,
                    " components, got component ", component);
}

}  // namespace ancf
