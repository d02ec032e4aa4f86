// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Names of nodes and of the vectors at them, and the list of vectors that a load or a constraint
/// acts on.

#pragma once

#include <ancf/element/fields.hpp>

#include <type_traits>
#include <vector>

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
using Coupling = std::vector<NodeField>;

namespace detail {

/// The dimension of the models that a load or a constraint belongs to; 0 for any.
template <class T, class = void>
struct dimension_of : std::integral_constant<int, 0> {};

template <class T>
struct dimension_of<T, std::enable_if_t<(T::dimension > 0)>>
    : std::integral_constant<int, T::dimension> {};

}  // namespace detail

}  // namespace ancf
