// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// GroupOf: evaluation of elements, alone or several at once, and where their results go.

#pragma once

#include <ancf/element/pack.hpp>
#include <ancf/model/element_group.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace ancf {
namespace detail {

template <class Element, class = void>
struct EvaluatesPacks : std::false_type {};
template <class Element>
struct EvaluatesPacks<Element, std::enable_if_t<Element::evaluates_packs>> : std::true_type {};

/// How many equal elements are evaluated at once: as many as a wide register has lanes where the
/// element takes packs, else one.
template <class Element>
inline constexpr int pack_lanes = EvaluatesPacks<Element>::value ? wide_lanes : 1;

/// Adds the part (a, b) of an element's block to the values of a tangent.
template <class Element, class Block>
void scatter_part(const GroupTarget& target, const ElementSlots& slots, int a, int b,
                  const Block& block) {
    constexpr int half = Element::dofs / 2;
    const auto rows = static_cast<std::size_t>(a), columns = static_cast<std::size_t>(b);
    if (slots.base[rows][columns] < 0) return;
    const bool lower = a == b && target.storage == Storage::lower;
    double* base = target.values + slots.base[rows][columns];
    const int node = slots.node[columns];
    if (slots.plain) {
        for (int j = 0; j < half; ++j) {
            double* column = base + target.column_offset(node, j);
            for (int i = lower ? j : 0; i < half; ++i) column[i] += block(i, j);
        }
        return;
    }
    int place[2 * half];  // within the node's block, -1 where held
    element_coordinates(target.layout, Element::dimension, Element::fields, slots, place);
    for (int i = 0; i < 2 * half; ++i) {
        const int equation = target.equation[place[i]];
        place[i] = equation < 0 ? -1 : equation - target.first_row[slots.node[i >= half ? 1 : 0]];
    }
    for (int j = 0; j < half; ++j) {
        const int own = place[b * half + j];
        if (own < 0) continue;
        double* column = base + target.column_offset(node, own);
        for (int i = 0; i < half; ++i) {
            const int row = place[a * half + i];
            if (row >= (lower ? own : 0)) column[row] += block(i, j);
        }
    }
}

}  // namespace detail

template <class Element>
double GroupOf<Element>::add(const ElementRun& run, const GroupTarget& target) const {
    constexpr int lanes = detail::pack_lanes<Element>;
    double energy = 0.0;
    const bool plain = target.increment == nullptr && target.before == nullptr;
    const auto equal = [&](int first) {
        const Connection* const part = &connections[static_cast<std::size_t>(first)];
        return std::all_of(part + 1, part + lanes, [part](const Connection& other) {
            return other.prototype == part->prototype;
        });
    };
    for (int k = run.first; k < run.last;) {
        if constexpr (lanes > 1) {
            if (plain && k + lanes <= run.last && equal(k)) {
                energy += add_pack<lanes>(k, target);
                k += lanes;
                continue;
            }
        }
        energy += add_element(k, target);
        ++k;
    }
    static_cast<void>(plain);
    static_cast<void>(equal);
    return energy;
}

template <class Element>
double GroupOf<Element>::add_element(int index, const GroupTarget& target) const {
    const ElementSlots& slots = target.slots[index];
    const Element& element = prototype(prototype_of(index));
    int coordinate[Element::dofs];
    detail::element_coordinates(target.layout, Element::dimension, Element::fields, slots,
                                coordinate);
    const auto gathered = [&](const double* all) {
        Coordinates own;
        for (int i = 0; i < Element::dofs; ++i) own[i] = all[coordinate[i]];
        return own;
    };
    const Coordinates e = gathered(target.q);
    if (!target.tangent && target.increment == nullptr) {
        const Coordinates force = element.force(e);
        for (int i = 0; i < Element::dofs; ++i) target.internal_force[coordinate[i]] += force[i];
        return 0.0;
    }
    auto result = [&] {
        if constexpr (detail::EvaluatesMixed<Element>::value)
            if (target.before != nullptr)
                return element.evaluate(e, gathered(target.before), gathered(target.change));
        return element.evaluate(e);
    }();
    if (target.increment != nullptr) {
        const Coordinates change = gathered(target.increment);
        for (int j = 0; j < Element::dofs; ++j)
            for (int i = 0; i < Element::dofs; ++i)
                result.force[i] += result.tangent(i, j) * change[j];
    }
    for (int i = 0; i < Element::dofs; ++i) target.internal_force[coordinate[i]] += result.force[i];
    if (!target.tangent) return result.energy;
    constexpr int half = Element::dofs / 2;
    for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b)
            detail::scatter_part<Element>(
                target, slots, a, b, result.tangent.template block<half, half>(a * half, b * half));
    return result.energy;
}

template <class Element>
template <int Lanes>
double GroupOf<Element>::add_pack(int first, const GroupTarget& target) const {
    const ElementSlots* slots = target.slots + first;
    const Element& element = prototype(prototype_of(first));
    int coordinate[Lanes][Element::dofs];
    Vector<Pack<Lanes>, Element::dofs> e;
    for (int lane = 0; lane < Lanes; ++lane) {
        detail::element_coordinates(target.layout, Element::dimension, Element::fields, slots[lane],
                                    coordinate[lane]);
        for (int i = 0; i < Element::dofs; ++i) e[i].set(lane, target.q[coordinate[lane][i]]);
    }
    const auto add_force = [&](const auto& force) {
        for (int lane = 0; lane < Lanes; ++lane)
            for (int i = 0; i < Element::dofs; ++i)
                target.internal_force[coordinate[lane][i]] += force[i][lane];
    };
    if (!target.tangent) {
        add_force(element.force(e));
        return 0.0;
    }
    const auto result = element.evaluate(e);
    add_force(result.force);
    // a block of all lanes at a time: the packs are read once, and what is written stays in cache
    constexpr int half = Element::dofs / 2;
    Matrix<double, half> blocks[Lanes];
    for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) {
            const auto stores = [&](const ElementSlots& one) {
                return one.base[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] >= 0;
            };
            if (std::none_of(slots, slots + Lanes, stores)) continue;
            for (int j = 0; j < half; ++j)
                for (int i = 0; i < half; ++i)
                    for (int lane = 0; lane < Lanes; ++lane)
                        blocks[lane](i, j) = result.tangent(a * half + i, b * half + j)[lane];
            for (int lane = 0; lane < Lanes; ++lane)
                detail::scatter_part<Element>(target, slots[lane], a, b, blocks[lane]);
        }
    return lane_sum(result.energy);
}

namespace detail {

template <class Element>
std::unique_ptr<ElementGroup> make_group() {
    return std::make_unique<GroupOf<Element>>();
}

}  // namespace detail

}  // namespace ancf
