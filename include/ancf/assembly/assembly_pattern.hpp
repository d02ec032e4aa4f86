// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Assembly: what is set up once, the pattern, each element's slots in it, and gravity.

#pragma once

#include <ancf/assembly/assembly.hpp>
#include <ancf/assembly/block_pattern.hpp>
#include <ancf/assembly/numbering.hpp>
#include <ancf/element/requirement.hpp>
#include <ancf/error.hpp>
#include <ancf/model/model.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace ancf {

template <class Scene>
Assembly<Scene>::Assembly(const Scene& model, Storage storage)
    : model_(model), numbering_(model), revision_(model.revision()) {
    list_coordinates();
    if (storage == Storage::lower) {
        detail::require(
            model.constraints().empty(),
            "Assembly: constraints make the tangent indefinite; choose a solver of full "
            "storage such as EigenLu, Klu or Umfpack");
        for (const ScaledLoad& load : model.loads())
            detail::require(
                load.load.symmetric(),
                "Assembly: a load has an unsymmetric stiffness; choose a solver of full storage "
                "such as EigenLu, Klu or Umfpack, or let a load of your own declare "
                "`constant_force` or `symmetric_stiffness` where that is so");
    }
    build_pattern(storage);
    model.for_each_group([&](const auto& group) { build_slots(group); });
    build_clearing();
    build_gravity();
    tangent_ = pattern_.matrix();
}

template <class Scene>
void Assembly<Scene>::refresh() {
    const Revision now = model_.revision();
    if (now == revision_) return;
    detail::require(now.scene == revision_.scene,
                    "nodes, elements, supports, loads or constraints of the model have changed: "
                    "make a new Assembly or DynamicProblem for it");
    build_gravity();
    revision_ = now;
}

template <class Scene>
std::vector<int> Assembly<Scene>::coordinates_of(const Coupling& coupling, const char* what) const {
    const Layout& layout = model_.layout();
    std::vector<int> coordinates;
    for (const NodeField& at : coupling) {
        const int first = layout.index(at);
        detail::require(first >= 0, "a ", what, " acts on ", to_string(at.field), " of node ",
                        at.node.index, ", which carries no such vector: no element there has one");
        for (int k = 0; k < layout.dimension(); ++k) coordinates.push_back(first + k);
    }
    return coordinates;
}

template <class Scene>
void Assembly<Scene>::list_coordinates() {
    for (const ScaledLoad& load : model_.loads())
        load_coordinates_.push_back(coordinates_of(load.load.coupling(), "load"));
    for (const AnyConstraint& constraint : model_.constraints()) {
        const Coupling coupling = constraint.coupling();
        constraint_coordinates_.push_back(coordinates_of(coupling, "constraint"));
        std::vector<int>& powers = constraint_powers_.emplace_back();
        for (const NodeField& at : coupling)
            powers.insert(powers.end(), Scene::dimension, length_power(at.field));
    }
}

template <class Scene>
void Assembly<Scene>::build_pattern(Storage storage) {
    std::vector<std::pair<int, int>> pairs;
    model_.for_each_group([&](const auto& group) {
        for (const Connection& c : group.connections)
            pairs.emplace_back(c.first.index, c.second.index);
    });
    std::vector<int> blocks;
    const auto couple_all = [&](const std::vector<int>& coordinates) {
        blocks.clear();
        for (const int k : coordinates) blocks.push_back(numbering_.block(k));
        std::sort(blocks.begin(), blocks.end());
        blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
        for (std::size_t a = 0; a < blocks.size(); ++a)
            for (std::size_t b = a + 1; b < blocks.size(); ++b)
                pairs.emplace_back(blocks[a], blocks[b]);
    };
    for (std::size_t k = 0; k < load_coordinates_.size(); ++k)
        if (!model_.loads()[k].load.constant()) couple_all(load_coordinates_[k]);
    for (std::size_t k = 0; k < constraint_coordinates_.size(); ++k) {
        couple_all(constraint_coordinates_[k]);
        for (const int block : blocks)
            pairs.emplace_back(block, numbering_.constraint_block(static_cast<int>(k)));
    }
    pattern_ = BlockPattern(numbering_.block_sizes(), std::move(pairs), storage);
}

template <class Scene>
template <class Element>
void Assembly<Scene>::build_slots(const ElementGroup<Element>& group) {
    static_assert(require_element<Element>());
    const Layout& layout = model_.layout();
    std::vector<Slots> all;
    all.reserve(group.connections.size());
    for (const Connection& c : group.connections) {
        Slots slots;
        slots.node = {c.first.index, c.second.index};
        slots.plain = true;
        for (std::size_t a = 0; a < 2; ++a) {
            const int node = slots.node[a];
            const int size = pattern_.first(node + 1) - pattern_.first(node);
            slots.plain =
                slots.plain && layout.fields(node) == Element::fields && size == Element::dofs / 2;
            for (std::size_t b = 0; b < 2; ++b)
                slots.base[a][b] =
                    pattern_.stored(node, slots.node[b]) ? pattern_.base(node, slots.node[b]) : -1;
        }
        all.push_back(slots);
    }
    slots_.push_back(std::move(all));
    schedules_.emplace_back(group.connections, layout.nodes());
}

// Each run clears the columns of the nodes that no run before it touched, just before it adds to
// them: they come from memory once, and threads share that work too.
template <class Scene>
void Assembly<Scene>::build_clearing() {
    const int nodes = model_.layout().nodes();
    std::vector<char> seen(static_cast<std::size_t>(nodes), 0);
    const auto append = [&](int block, std::vector<ValueRange>& ranges) {
        const ValueRange next{pattern_.first_value(block), pattern_.first_value(block + 1)};
        if (!ranges.empty() && ranges.back().last == next.first)
            ranges.back().last = next.last;
        else
            ranges.push_back(next);
    };
    std::size_t index = 0;
    model_.for_each_group([&](const auto& group) {
        cleared_.emplace_back();
        schedules_[index++].for_each_colour([&](const std::vector<ElementRun>& runs) {
            for (const ElementRun& run : runs) {
                std::vector<int> fresh;
                ElementSchedule::visit_nodes(group.connections, run, [&](std::size_t node) {
                    if (seen[node] == 0) fresh.push_back(static_cast<int>(node));
                    seen[node] = 1;
                });
                std::sort(fresh.begin(), fresh.end());
                cleared_.back().emplace_back();
                for (const int node : fresh) append(node, cleared_.back().back());
            }
        });
    });
    const int blocks = static_cast<int>(numbering_.block_sizes().size());
    for (int block = 0; block < blocks; ++block)
        if (block >= nodes || seen[static_cast<std::size_t>(block)] == 0)
            append(block, cleared_first_);
}

template <class Scene>
void Assembly<Scene>::clear_values(const std::vector<ValueRange>& ranges) {
    for (const ValueRange& range : ranges)
        std::fill(tangent_.valuePtr() + range.first, tangent_.valuePtr() + range.last, 0.0);
}

template <class Scene>
template <class Element>
void Assembly<Scene>::element_coordinates(const Slots& slots, int (&out)[Element::dofs]) const {
    const Layout& layout = model_.layout();
    if (slots.plain) {
        constexpr int half = Element::dofs / 2;
        for (int a = 0; a < 2; ++a)
            for (int i = 0; i < half; ++i)
                out[a * half + i] = layout.first(slots.node[static_cast<std::size_t>(a)]) + i;
        return;
    }
    int at = 0;
    for (const int node : slots.node)
        for (int k = 0; k < field_count; ++k) {
            const auto field = static_cast<Field>(k);
            if (!Element::fields.contains(field)) continue;
            const int first = layout.index({{node}, field});
            for (int i = 0; i < Scene::dimension; ++i) out[at++] = first + i;
        }
}

template <class Scene>
void Assembly<Scene>::build_gravity() {
    gravity_.setZero(numbering_.coordinates());
    for_each_group([&](const auto& group, const auto& slots) {
        using Element = typename std::decay_t<decltype(group.prototypes)>::value_type;
        std::vector<Vector<double, Element::dofs>> forces;
        for (const Element& prototype : group.prototypes)
            forces.push_back(prototype.gravity(model_.gravity()));
        int coordinate[Element::dofs];
        for (std::size_t k = 0; k < slots.size(); ++k) {
            element_coordinates<Element>(slots[k], coordinate);
            const auto prototype = static_cast<std::size_t>(group.connections[k].prototype);
            for (int i = 0; i < Element::dofs; ++i) gravity_[coordinate[i]] += forces[prototype][i];
        }
    });
    for (const PointMass& point : model_.masses())
        gravity_.template segment<Scene::dimension>(model_.coordinate(point.node, Field::r)) +=
            point.mass * model_.gravity();
}

}  // namespace ancf
