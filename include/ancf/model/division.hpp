// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Who has what of a scene that several parts divide between them.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/scene.hpp>

#include <functional>
#include <utility>
#include <vector>

namespace ancf::detail {

/// Returns the part of each vertex of a graph. Edges may repeat, and end where they begin.
using GraphDivision =
    std::function<std::vector<int>(int vertices, const std::vector<std::pair<int, int>>& edges)>;

/// The division of a scene by its nodes, the same wherever it is made from the same graph division.
///
/// A node is of one part; an element and what couples nodes are of that of their first node; an
/// attached node is of that of its element.
struct Division {
    std::vector<int> follows;      ///< the node that each node is attached to, -1
    std::vector<int> part;         ///< of each node; -1 without vectors
    std::vector<char> eliminated;  ///< of each node: attached, and seen by one element alone

    /// Divides the graph of nodes, attached ones merged with those that they follow, and elements.
    Division(const Scene& whole, const GraphDivision& divide);

    /// Returns the node that stands for one: itself, or that at the end of its attachments.
    [[nodiscard]] int leader(NodeId of) const {
        int k = of.index;
        while (follows[k] >= 0) k = follows[k];
        return k;
    }
    /// Returns the part of an element.
    [[nodiscard]] int owner(const Connection& c) const { return part[leader(c.first)]; }
    /// Returns the part of what couples nodes, that of the first; 0 of what couples none.
    [[nodiscard]] int owner(const Coupling& coupling) const {
        return coupling.empty() ? 0 : part[coupling.front().node.index];
    }

    /// Returns what a part holds: its elements, loads, constraints and masses, its nodes, all nodes
    /// that these touch, and those that they follow.
    [[nodiscard]] ScenePart held(const Scene& whole, int by) const;

private:
    void divide_nodes(const Scene& whole, const GraphDivision& divide);
    void eliminate(const Scene& whole);
};

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/model/division.ipp>  // IWYU pragma: export
#endif
