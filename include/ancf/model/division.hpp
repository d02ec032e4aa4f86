// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Who has what of a scene that several parts divide between them.

#pragma once

#include <ancf/list.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/scene.hpp>

#include <cstddef>
#include <functional>
#include <utility>

namespace ancf::detail {

/// Returns the part of each vertex of a graph. Edges may repeat, and end where they begin.
using GraphDivision =
    std::function<List<int>(int vertices, const List<std::pair<int, int>>& edges)>;

/// The division of a scene by its nodes, the same wherever it is made from the same graph division.
///
/// A node is of one part; an element and what couples nodes are of that of their first node; an
/// attached node is of that of its element.
struct Division {
    List<int> follows;      ///< the node that each node is attached to, -1
    List<int> part;         ///< of each node; -1 without vectors
    List<char> eliminated;  ///< of each node: attached, and seen by one element alone

    /// Divides the graph of nodes, attached ones merged with those that they follow, and elements.
    Division(const Scene& whole, const GraphDivision& divide)
        : follows(whole.nodes(), -1), part(follows.size(), -1), eliminated(follows.size(), 0) {
        for (const AttachedVector& attachment : whole.attachments())
            follows[attachment.vector.node.index] = attachment.to.index;
        divide_nodes(whole, divide);
        for (const auto& group : whole.groups())
            for (const Connection& c : group->connections)
                for (const NodeId end : {c.first, c.second})
                    if (int& of = part[end.index]; of < 0) of = owner(c);
        for (int k = 0; k < whole.nodes(); ++k)
            if (int& of = part[k]; of < 0 && whole.layout().size(k) > 0) of = part[leader({k})];
        eliminate(whole);
    }

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
    [[nodiscard]] ScenePart held(const Scene& whole, int by) const {
        ScenePart result;
        result.nodes.assign(part.size(), 0);
        const auto take = [&](NodeId of) {
            for (int k = of.index; k >= 0; k = follows[k]) result.nodes[k] = 1;
        };
        const auto takes = [&](const Coupling& coupling) {
            if (owner(coupling) != by) return false;
            for (const NodeField& vector : coupling) take(vector.node);
            return true;
        };
        const auto places = [](const auto& list, const auto& wanted) {
            List<int> found;
            for (std::size_t k = 0; k < list.size(); ++k)
                if (wanted(list[k])) found.push_back(static_cast<int>(k));
            return found;
        };
        for (int node = 0; node < whole.nodes(); ++node)
            if (part[node] == by) take({node});
        for (const auto& group : whole.groups())
            result.elements.push_back(places(group->connections, [&](const Connection& c) {
                if (owner(c) != by) return false;
                take(c.first);
                take(c.second);
                return true;
            }));
        result.loads = places(whole.loads(),
                              [&](const ScaledLoad& each) { return takes(each.load.coupling()); });
        result.constraints = places(
            whole.constraints(), [&](const AnyConstraint& each) { return takes(each.coupling()); });
        result.masses =
            places(whole.masses(), [&](const auto& each) { return part[each.node.index] == by; });
        return result;
    }

private:
    void divide_nodes(const Scene& whole, const GraphDivision& divide) {
        List<int> vertex(part.size(), -1), leaders;
        for (int k = 0; k < whole.nodes(); ++k)
            if (whole.layout().size(k) > 0 && follows[k] < 0) {
                vertex[k] = static_cast<int>(leaders.size());
                leaders.push_back(k);
            }
        List<std::pair<int, int>> edges;
        for (const auto& group : whole.groups())
            for (const Connection& c : group->connections)
                edges.emplace_back(vertex[leader(c.first)], vertex[leader(c.second)]);
        const List<int> parts = divide(static_cast<int>(leaders.size()), edges);
        for (std::size_t k = 0; k < leaders.size(); ++k) part[leaders[k]] = parts[k];
    }
    void eliminate(const Scene& whole) {
        List<int> seen(part.size(), 0);
        const auto see = [&](NodeId of) { seen[of.index] += 1; };
        const auto see_all = [&](const Coupling& coupling) {
            for (const NodeField& vector : coupling) see(vector.node);
        };
        for (const auto& group : whole.groups())
            for (const Connection& c : group->connections) {
                see(c.first);
                if (c.second != c.first) see(c.second);
            }
        for (const ScaledLoad& load : whole.loads())
            if (!load.load.constant()) see_all(load.load.coupling());
        for (const AnyConstraint& each : whole.constraints()) see_all(each.coupling());
        for (const AttachedVector& attachment : whole.attachments()) see(attachment.to);
        for (std::size_t k = 0; k < part.size(); ++k)
            eliminated[k] = follows[k] >= 0 && seen[k] == 1;
    }
};

}  // namespace ancf::detail
