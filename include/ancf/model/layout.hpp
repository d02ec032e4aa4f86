// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Nodes and the vectors at them: where each stands in the coordinates of a model, and how a torque
/// at a node divides between its slopes.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/list.hpp>

#include <type_traits>

namespace ancf {

/// A node of a model, as `Model::add_node` returned it.
struct NodeId {
    int index = -1;  ///< place in the model; -1: none

    /// Compares two nodes.
    friend constexpr bool operator==(NodeId a, NodeId b) noexcept { return a.index == b.index; }
    /// Compares two nodes.
    friend constexpr bool operator!=(NodeId a, NodeId b) noexcept { return a.index != b.index; }
};

/// One vector of nodal coordinates.
struct NodeField {
    NodeId node;  ///< where
    Field field;  ///< which vector
};

/// The vectors that a load or a constraint acts on, in the order of its local coordinates.
using Coupling = List<NodeField>;

namespace detail {

/// The dimension of the models that a load or a constraint belongs to; 0 for any.
template <class T, class = void>
struct dimension_of : std::integral_constant<int, 0> {};

template <class T>
struct dimension_of<T, std::enable_if_t<(T::dimension > 0)>>
    : std::integral_constant<int, T::dimension> {};

}  // namespace detail

/// The order of coordinates: node by node, the fields that the node carries, their components.
class Layout {
public:
    Layout() = default;

    /// Makes the order for the fields of every node.
    Layout(int dimension, const List<Fields>& fields) : dimension_(dimension) {
        for (const Fields of : fields) append(of);
    }

    /// Appends a node of these fields, its torsion_share() one half.
    void append(Fields fields) {
        fields_.push_back(fields);
        first_.push_back(first_.back() + dimension_ * fields.count());
        shares_.push_back(0.5);
    }
    /// Sets the torsion_share() of a node that was appended, 0 to 1.
    void set_torsion_share(NodeId node, double share) { shares_[node.index] = share; }

    /// Returns the number of nodes.
    [[nodiscard]] int nodes() const noexcept { return static_cast<int>(fields_.size()); }
    /// Returns the number of coordinates.
    [[nodiscard]] int size() const noexcept { return first_.back(); }
    /// Returns the dimension of space.
    [[nodiscard]] int dimension() const noexcept { return dimension_; }

    /// Returns the fields that a node carries.
    [[nodiscard]] Fields fields(int node) const { return fields_[node]; }

    /// Returns the index of a node's first coordinate.
    [[nodiscard]] int first(int node) const { return first_[node]; }

    /// Returns the node of a coordinate.
    [[nodiscard]] int node_of(int coordinate) const {
        int node = 0;
        for (int last = nodes(); last - node > 1;) {
            const int middle = node + (last - node) / 2;
            (first(middle) <= coordinate ? node : last) = middle;
        }
        return node;
    }

    /// Returns the field of a coordinate.
    [[nodiscard]] Field field_of(int coordinate) const {
        const int node = node_of(coordinate);
        return fields(node).at((coordinate - first(node)) / dimension_);
    }

    /// Returns the number of coordinates of a node.
    [[nodiscard]] int size(int node) const { return first(node + 1) - first(node); }

    /// Returns the index of a vector's first component, -1 where the node does not carry it or does
    /// not exist.
    [[nodiscard]] int index(NodeField at) const {
        if (at.node.index < 0 || at.node.index >= nodes()) return -1;
        const Fields carried = fields(at.node.index);
        if (!carried.contains(at.field)) return -1;
        return first(at.node.index) + dimension_ * carried.rank(at.field);
    }

    /// Returns the part of a torque on a node's section that belongs on r_y, 0 to 1; the rest
    /// belongs on r_z.
    ///
    /// It is the part that the torsion of the node's elements puts there (docs/theory-statics.md);
    /// one half where they do not say.
    [[nodiscard]] double torsion_share(NodeId node) const noexcept {
        if (node.index < 0 || node.index >= static_cast<int>(shares_.size())) return 0.5;
        return shares_[node.index];
    }

private:
    int dimension_ = 0;
    List<Fields> fields_;
    List<int> first_ = {0};
    List<double> shares_;
};

}  // namespace ancf
