// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Assembly: evaluation of a scene, and of its elements, alone or several at once.

#pragma once

#include <ancf/assembly/assembly.hpp>
#include <ancf/assembly/schedule.hpp>
#include <ancf/element/pack.hpp>
#include <ancf/model/model.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace ancf {

template <class Scene>
std::optional<Fault> Assembly<Scene>::evaluate(const Configuration& at, Request request,
                                               const VectorX* increment, const Correction* last) {
    refresh();
    detail::require(at.q.size() == numbering_.coordinates() && at.v.size() == at.q.size() &&
                        at.multipliers.size() == numbering_.multipliers(),
                    "Assembly::evaluate: expected ", numbering_.coordinates(),
                    " coordinates and rates and ", numbering_.multipliers(), " multipliers, got ",
                    at.q.size(), ", ", at.v.size(), " and ", at.multipliers.size());
    if (increment) check_size("evaluate", "increments", *increment);
    if (last) {
        check_size("evaluate", "coordinates before the correction", last->before);
        check_size("evaluate", "corrections", last->change);
    }
    energy_known_ = request != Request::force || increment != nullptr;
    if (!energy_known_) force_q_ = at.q;
    internal_.setZero(numbering_.coordinates());
    constraint_.setZero(numbering_.coordinates());
    strain_energy_ = 0.0;
    if (request != Request::force) clear_values(cleared_first_);
    if (request == Request::tangent_and_damping) {
        if (damping_.nonZeros() != tangent_.nonZeros()) damping_ = pattern_.matrix();
        std::fill_n(damping_.valuePtr(), damping_.nonZeros(), 0.0);
    }
    std::size_t index = 0;
    model_.for_each_group([&](const auto& group) {
        strain_energy_ += add_elements(group, index++, at, request, increment, last);
    });
    const double gravity_scale = model_.gravity_scale(at.instant);
    external_ = gravity_scale * gravity_;
    load_potential_ = -external_.dot(at.q);
    add_loads(at, request);
    add_constraints(at, request);
    if (std::isfinite(strain_energy_) && internal_.allFinite() && external_.allFinite() &&
        constraint_.allFinite())
        return std::nullopt;
    return inspect(at.q).value_or(Fault{Status::not_finite, -1, -1});
}

template <class Scene>
double Assembly<Scene>::strain_energy() const {
    if (energy_known_) return strain_energy_;
    strain_energy_ = 0.0;
    std::size_t index = 0;
    for_each_group([&](const auto& group, const auto& slots) {
        using Element = typename std::decay_t<decltype(group.prototypes)>::value_type;
        strain_energy_ += schedules_[index++].sum([&](const ElementRun& run, std::size_t) {
            double energy = 0.0;
            for (int k = run.first; k < run.last; ++k) {
                int coordinate[Element::dofs];
                element_coordinates<Element>(slots[static_cast<std::size_t>(k)], coordinate);
                typename Element::Coordinates e;
                for (int i = 0; i < Element::dofs; ++i) e[i] = force_q_[coordinate[i]];
                energy += group.element(k).energy(e);
            }
            return energy;
        });
    });
    energy_known_ = true;
    return strain_energy_;
}

template <class Scene>
template <class Element>
double Assembly<Scene>::add_elements(const ElementGroup<Element>& group, std::size_t index,
                                     const Configuration& at, Request request,
                                     const VectorX* increment, const Correction* last) {
    const std::vector<Slots>& slots = slots_[index];
    return schedules_[index].sum([&](const ElementRun& run, std::size_t place) {
        if (request != Request::force) clear_values(cleared_[index][place]);
        double energy = 0.0;
        constexpr int lanes = detail::pack_lanes<Element>;
        const bool plain = increment == nullptr && last == nullptr;
        const auto equal = [&](int first) {
            const Connection* const part = &group.connections[static_cast<std::size_t>(first)];
            return std::all_of(part + 1, part + lanes, [part](const Connection& other) {
                return other.prototype == part->prototype;
            });
        };
        for (int k = run.first; k < run.last;) {
            if constexpr (lanes > 1) {
                if (plain && k + lanes <= run.last && equal(k)) {
                    energy += add_pack<lanes>(group.element(k), &slots[static_cast<std::size_t>(k)],
                                              at, request);
                    k += lanes;
                    continue;
                }
            }
            energy += add_element(group.element(k), slots[static_cast<std::size_t>(k)], at, request,
                                  increment, last);
            ++k;
        }
        return energy;
    });
}

template <class Scene>
template <class Element>
double Assembly<Scene>::add_element(const Element& element, const Slots& slots,
                                    const Configuration& at, Request request,
                                    const VectorX* increment, const Correction* last) {
    int coordinate[Element::dofs];
    element_coordinates<Element>(slots, coordinate);
    const auto gathered = [&](const VectorX& all) {
        typename Element::Coordinates own;
        for (int i = 0; i < Element::dofs; ++i) own[i] = all[coordinate[i]];
        return own;
    };
    const typename Element::Coordinates e = gathered(at.q);
    if (request == Request::force && increment == nullptr) {
        const typename Element::Coordinates force = element.force(e);
        for (int i = 0; i < Element::dofs; ++i) internal_[coordinate[i]] += force[i];
        return 0.0;
    }
    auto result = [&] {
        if constexpr (detail::EvaluatesMixed<Element>::value)
            if (last != nullptr)
                return element.evaluate(e, gathered(last->before), gathered(last->change));
        return element.evaluate(e);
    }();
    if (increment != nullptr) {
        const typename Element::Coordinates change = gathered(*increment);
        for (int j = 0; j < Element::dofs; ++j)
            for (int i = 0; i < Element::dofs; ++i)
                result.force[i] += result.tangent(i, j) * change[j];
    }
    for (int i = 0; i < Element::dofs; ++i) internal_[coordinate[i]] += result.force[i];
    if (request != Request::force) scatter<Element>(slots, result.tangent, tangent_.valuePtr());
    return result.energy;
}

template <class Scene>
template <int Lanes, class Element>
double Assembly<Scene>::add_pack(const Element& element, const Slots* slots,
                                 const Configuration& at, Request request) {
    int coordinate[Lanes][Element::dofs];
    Vector<Pack<Lanes>, Element::dofs> e;
    for (int lane = 0; lane < Lanes; ++lane) {
        element_coordinates<Element>(slots[lane], coordinate[lane]);
        for (int i = 0; i < Element::dofs; ++i) e[i].set(lane, at.q[coordinate[lane][i]]);
    }
    const auto add_force = [&](const auto& force) {
        for (int lane = 0; lane < Lanes; ++lane)
            for (int i = 0; i < Element::dofs; ++i)
                internal_[coordinate[lane][i]] += force[i][lane];
    };
    if (request == Request::force) {
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
            const auto stores = [&](const Slots& one) { return one.base[a][b] >= 0; };
            if (std::none_of(slots, slots + Lanes, stores)) continue;
            for (int j = 0; j < half; ++j)
                for (int i = 0; i < half; ++i)
                    for (int lane = 0; lane < Lanes; ++lane)
                        blocks[lane](i, j) = result.tangent(a * half + i, b * half + j)[lane];
            for (int lane = 0; lane < Lanes; ++lane)
                scatter<Element>(slots[lane], a, b, blocks[lane], tangent_.valuePtr());
        }
    return lane_sum(result.energy);
}

template <class Scene>
template <class Element, class Block>
void Assembly<Scene>::scatter(const Slots& slots, const Block& block, double* values) const {
    constexpr int half = Element::dofs / 2;
    for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b)
            scatter<Element>(slots, a, b, block.template block<half, half>(a * half, b * half),
                             values);
}

template <class Scene>
template <class Element, class Block>
void Assembly<Scene>::scatter(const Slots& slots, int a, int b, const Block& block,
                              double* values) const {
    if (slots.base[a][b] < 0) return;
    constexpr int half = Element::dofs / 2;
    const bool lower = a == b && pattern_.storage() == Storage::lower;
    double* base = values + slots.base[a][b];
    if (slots.plain) {
        for (int j = 0; j < half; ++j) {
            double* column = base + pattern_.column_offset(slots.node[b], j);
            for (int i = lower ? j : 0; i < half; ++i) column[i] += block(i, j);
        }
        return;
    }
    int place[Element::dofs];  // within the node's block, -1 where held
    element_coordinates<Element>(slots, place);
    for (int i = 0; i < Element::dofs; ++i) {
        const int equation = numbering_.equation(place[i]);
        place[i] = equation < 0 ? -1 : equation - pattern_.first(slots.node[i >= half]);
    }
    for (int j = 0; j < half; ++j) {
        const int own = place[b * half + j];
        if (own < 0) continue;
        double* column = base + pattern_.column_offset(slots.node[b], own);
        for (int i = 0; i < half; ++i) {
            const int row = place[a * half + i];
            if (row >= (lower ? own : 0)) column[row] += block(i, j);
        }
    }
}

template <class Scene>
void Assembly<Scene>::add_value(int row, int column, double value, SparseMatrix& matrix) const {
    const int i = numbering_.equation(row);
    const int j = numbering_.equation(column);
    if (i < 0 || j < 0 || (pattern_.storage() == Storage::lower && i < j)) return;
    const int a = numbering_.block(row);
    const int b = numbering_.block(column);
    const int slot = pattern_.base(a, b) + pattern_.column_offset(b, j - pattern_.first(b)) + i -
                     pattern_.first(a);
    matrix.valuePtr()[slot] += value;
}

}  // namespace ancf
