// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A model in space or in the plane: a Scene with the calls that have vectors in their arguments.

#pragma once

#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace ancf {

namespace detail {

/// Returns the vectors of a node in the order of Field, three numbers each.
///
/// The rate r_xy, in the plane alone, is that by which r_y turns as r_x does, at a constant angle
/// between them.
/// @param slopes     columns r_x, r_y (and r_z)
/// @param curvature  r_xx, 1/m
template <int Dimension>
[[nodiscard]] std::array<double, 3 * field_count> node_vectors(
    const Vector<double, Dimension>& position, const Matrix<double, Dimension>& slopes,
    const Vector<double, Dimension>& curvature) {
    constexpr int r_xx = 3 * static_cast<int>(Field::r_xx),
                  r_xy = 3 * static_cast<int>(Field::r_xy);
    std::array<double, 3 * field_count> vectors = {};
    for (int i = 0; i < Dimension; ++i) {
        vectors[i] = position[i];
        for (int k = 0; k < Dimension; ++k) vectors[3 * (1 + k) + i] = slopes(i, k);
        vectors[r_xx + i] = curvature[i];
    }
    if constexpr (Dimension == 2) {
        const double square = slopes(0, 0) * slopes(0, 0) + slopes(1, 0) * slopes(1, 0);
        const double turn = slopes(0, 0) * curvature[1] - slopes(1, 0) * curvature[0];
        if (turn == 0.0) return vectors;
        vectors[r_xy] = -turn / square * slopes(1, 1);
        vectors[r_xy + 1] = turn / square * slopes(0, 1);
    }
    return vectors;
}

}  // namespace detail

/// A scene of a given dimension; what it holds and most of its calls are those of Scene.
template <int Dimension>
class BasicModel : public Scene {
public:
    static_assert(Dimension == 2 || Dimension == 3, "a model is in the plane or in space");

    static constexpr int dimension = Dimension;  ///< of space

    using Point = Vector<double, Dimension>;     ///< a vector of space
    using Argument = VectorArgument<Dimension>;  ///< a vector, also in braces
    using Slopes = Matrix<double, Dimension>;    ///< columns r_x, r_y (and r_z)
    /// The rate of a turn, rad/s: a vector, in the plane a number.
    using Spin = std::conditional_t<Dimension == 3, VectorArgument<3>, double>;

    BasicModel() : Scene(Dimension) {}

    /// Adds a node; it carries the vectors that the elements connected to it need.
    /// @param position   m.  @param slopes  columns r_x, r_y (and r_z) of the reference.
    /// @param curvature  r_xx of the reference, 1/m; elements of a quintic centre line have it.
    ///                   In the plane r_xy, where elements have it, turns r_y as r_xx turns r_x.
    /// @throws InvalidArgument unless every value is finite.
    NodeId add_node(const Argument& position, const Slopes& slopes = Slopes::Identity(),
                    const Point& curvature = Point::Zero()) {
        detail::require_finite("Model::add_node: the position", detail::components(position));
        detail::require(detail::all_finite(slopes),
                        "Model::add_node: slopes must be finite, got (by columns) ",
                        detail::components(slopes));
        detail::require_finite("Model::add_node: the curvature", detail::components(curvature));
        return add_initial_node(detail::node_vectors<Dimension>(position, slopes, curvature));
    }

    /// Adds a load of this dimension, as Scene::add does.
    template <class Load, std::enable_if_t<is_load_v<Load>, int> = 0>
    void add(Load load, Amplitude amplitude = {}) {
        static_assert(fits<Load>,
                      "the load is of another dimension than the model: Model takes Force<3>, "
                      "Moment; PlanarModel takes Force<2>, PlanarSlopeMoment");
        if constexpr (fits<Load>) Scene::add(std::move(load), std::move(amplitude));
    }

    /// Stops the compilation: what is added with an amplitude is no load.
    template <class Other, std::enable_if_t<!is_load_v<Other>, int> = 0>
    void add(const Other& other, const Amplitude& amplitude) {
        static_assert(is_load_v<Other>,
                      "Model::add takes an amplitude with a load alone, which offers `Coupling "
                      "coupling() const` and `void evaluate(const LoadState&, LoadResult&) const`");
        Scene::add(other, amplitude);
    }

    /// Adds a constraint of this dimension, as Scene::add does; returns its place in constraints().
    template <class Constraint, std::enable_if_t<!is_load_v<Constraint>, int> = 0>
    int add(Constraint constraint) {
        static_assert(fits<Constraint>,
                      "the constraint is of another dimension than the model: Model takes Pin<3>, "
                      "Weld; PlanarModel takes Pin<2>, PlanarWeld");
        if constexpr (fits<Constraint>) return Scene::add(std::move(constraint));
        return -1;
    }

    /// Sets the acceleration of gravity, m/s^2.
    /// @throws InvalidArgument unless every component is finite.
    void set_gravity(const Argument& gravity, Amplitude amplitude = {}) {
        detail::require_finite("Model::set_gravity: components", detail::components(gravity));
        std::array<double, 3> components = {};
        for (int k = 0; k < Dimension; ++k) components[k] = gravity[k];
        set_gravity_components(components, std::move(amplitude));
    }

    /// Returns the acceleration of gravity, m/s^2.
    [[nodiscard]] Point gravity() const {
        Point result;
        for (int k = 0; k < Dimension; ++k) result[k] = gravity_component(k);
        return result;
    }

    /// Returns one vector of a node in the reference, as the node was added.
    /// @throws InvalidArgument for a node that does not exist.
    [[nodiscard]] Point reference(NodeId node, Field field) const {
        return Eigen::Map<const Point>(vector_added(node, field));
    }

    /// Returns one vector of a node as it stands now.
    /// @throws InvalidArgument where the node does not carry it, and for a state of another model.
    [[nodiscard]] Point value(NodeId node, Field field) const {
        return Eigen::Map<const Point>(vector_now(node, field));
    }

    /// Returns one vector of a node.
    /// @param of  layout().size() numbers in the order of State::q: a state's q or v, the shape of
    ///            a mode, reactions.
    /// @throws InvalidArgument for another size, and where the node does not carry the vector.
    [[nodiscard]] Point value(NodeId node, Field field, const VectorX& of) const {
        const int first = coordinate(node, field);
        check_state(of, layout());
        return Eigen::Map<const Point>(of.data() + first);
    }

    /// Sets one vector of a node.
    /// @throws InvalidArgument unless it is finite, where the node does not carry it, and where it
    ///         is attached to another node.
    void set_value(NodeId node, Field field, const Argument& value) {
        set_vector("set_value", state().q, node, field, value);
    }

    /// Sets the rate of one vector of a node.
    /// @throws InvalidArgument as set_value().
    void set_rate(NodeId node, Field field, const Argument& rate) {
        set_vector("set_rate", state().v, node, field, rate);
    }

    /// Sets the rates of some nodes to those of a rigid body that spins.
    ///
    /// What is attached to them or to others follows those. The body spins as the nodes stand now.
    /// @param velocity  of the body at `about`, m/s.
    /// @param spin      rad/s.
    /// @param about     a point, m.
    /// @throws InvalidArgument unless every value is finite, for a node that does not exist, for
    ///         nodes that are all attached or carry nothing, and for a state of another model.
    void set_rigid_rates(const List<NodeId>& nodes, const Argument& velocity, const Spin& spin,
                         const Argument& about = Point(Point::Zero())) {
        const auto turned = [&](const Point& vector) -> Point {
            if constexpr (Dimension == 3)
                return cross<double>(spin, vector);
            else
                return spin * Point(-vector[1], vector[0]);
        };
        const Point at_origin = velocity - turned(about);
        detail::require(detail::all_finite(at_origin),
                        "Model::set_rigid_rates: velocity, spin and about must be finite");
        VectorX& rates = state().v;
        check_state(rates, layout());
        for (const NodeId node : nodes) check(node);
        bool own = nodes.empty();
        for (const NodeId node : nodes) {
            const Fields fields = layout().fields(node.index);
            for (int k = 0; k < fields.count(); ++k) {
                const int first = layout().first(node.index) + k * Dimension;
                if (dependence().attached(first)) continue;
                const Point now = value(node, fields.at(k));
                own = true;
                Eigen::Map<Point> rate(rates.data() + first);
                rate = turned(now);
                if (fields.at(k) == Field::r) rate += at_origin;
            }
        }
        detail::require(own,
                        "Model::set_rigid_rates: these nodes have no vectors of their own; name "
                        "those that they are attached to");
        dependence().complete(rates);
    }

    /// Sets the rates of all nodes so.
    /// @throws InvalidArgument as the other one.
    void set_rigid_rates(const Argument& velocity, const Spin& spin,
                         const Argument& about = Point(Point::Zero())) {
        List<NodeId> all(static_cast<std::size_t>(nodes()));
        for (int node = 0; node < nodes(); ++node) all[node] = {node};
        set_rigid_rates(all, velocity, spin, about);
    }

    /// Returns the position of a node, m.
    /// @throws InvalidArgument for a node that does not exist or has no position.
    [[nodiscard]] Point position(NodeId node) const { return value(node, Field::r); }

    /// Returns the velocity of a node, m/s.
    /// @throws InvalidArgument for a node that does not exist or has no position.
    [[nodiscard]] Point velocity(NodeId node) const { return value(node, Field::r, state().v); }

private:
    // Whether a load or a constraint is of this dimension, or of any.
    template <class What>
    static constexpr bool fits =
        detail::dimension_of<What>::value == 0 || detail::dimension_of<What>::value == Dimension;

    void set_vector(const char* call, VectorX& of, NodeId node, Field field,
                    const Point& vector) const {
        detail::require(detail::all_finite(vector), "Model::", call, ": ", to_string(field),
                        " of node ", node.index, " must be finite, got ",
                        detail::components(vector));
        check_unattached(call, node, field);
        const int first = coordinate(node, field);
        check_state(of, layout());
        for (int k = 0; k < Dimension; ++k) of[first + k] = vector[k];
        dependence().complete(of, first);
    }
};

using Model = BasicModel<3>;        ///< a model in space
using PlanarModel = BasicModel<2>;  ///< a model in the plane

}  // namespace ancf
