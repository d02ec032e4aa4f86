// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// GroupOf<Element>: the one place above an element that knows its type.
///
/// It gathers coordinates, evaluates one element or several side by side, and adds force and
/// tangent where the assembly wants them.

#pragma once

#include <ancf/element/compiled_element.hpp>
#include <ancf/element/pack.hpp>
#include <ancf/element/requirement.hpp>
#include <ancf/list.hpp>
#include <ancf/model/element_group.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string_view>
#include <type_traits>
#include <utility>

namespace ancf {
namespace detail {

/// Returns the name of a type as the compiler writes it, without the library's namespace.
template <class T>
[[nodiscard]] constexpr std::string_view type_name() noexcept {
#if defined(__GNUC__)
    std::string_view text = __PRETTY_FUNCTION__;
    text.remove_prefix(text.find("T = ") + 4);
    text = text.substr(0, text.find_first_of(";]"));
#elif defined(_MSC_VER)
    std::string_view text = __FUNCSIG__;
    text.remove_prefix(text.find("type_name<") + 10);
    text = text.substr(0, text.rfind(">(void)"));
    text.remove_prefix(text.find(' ') + 1);
#else
    std::string_view text = "element";
#endif
    constexpr std::string_view own = "ancf::";
    if (text.substr(0, own.size()) == own) text.remove_prefix(own.size());
    return text;
}

// What an element may offer: docs/requirements.md.
template <class Element>
using Softening = decltype(some<Element>().softened(some<typename Element::Coordinates>()));
template <class Element>
using MixedEvaluationOf = decltype(some<Element>().evaluate(some<typename Element::Coordinates>(),
                                                            some<typename Element::Coordinates>(),
                                                            some<typename Element::Coordinates>()));
template <class Result>
using PredictedForce = decltype(some<Result>().predicted);
template <class Element>
using OneNode = std::enable_if_t<Element::one_node>;
template <class Element>
using Packs = std::enable_if_t<Element::evaluates_packs>;
template <class Element>
using TorsionStiffness = decltype(Vector<double, 2>(some<Element>().torsion_stiffness()));

/// How many equal elements are evaluated at once: as many as a wide register has lanes where the
/// element takes packs, else one.
template <class Element>
inline constexpr int pack_lanes = offers<Packs, Element> ? wide_lanes : 1;

/// Adds the part (a, b) of an element's block to the values of a tangent.
template <class Element, class Block>
void scatter_part(const GroupTarget& target, const ElementSlots& slots, int a, int b,
                  const Block& block) {
    constexpr int half = Element::dofs / 2;
    const auto rows = static_cast<std::size_t>(a), columns = static_cast<std::size_t>(b);
    if (slots.base[rows][columns] < 0) return;
    const bool lower = slots.node[rows] == slots.node[columns] && target.storage == Storage::lower;
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

/// The elements of one type, with their type.
template <class Element>
class GroupOf final : public ElementGroup {
    static_assert(require_element<Element>());

public:
    using Coordinates = typename Element::Coordinates;  ///< of one element

    GroupOf()
        : ElementGroup({type_id<Element>(), detail::type_name<Element>(), Element::fields,
                        Element::dofs, detail::offers<detail::MixedEvaluationOf, Element>,
                        detail::offers<detail::OneNode, Element>}) {}

    List<Element> prototypes;  ///< constant data, shared by equal elements

    /// Returns the prototype of an element.
    /// @throws InvalidArgument for an index of no element.
    [[nodiscard]] const Element& element(int index) const {
        return prototype(connection(index).prototype);
    }

    [[nodiscard]] std::unique_ptr<ElementGroup> clone() const override {
        return std::unique_ptr<ElementGroup>(new GroupOf(*this));
    }
    [[nodiscard]] int prototype_count() const noexcept override {
        return static_cast<int>(prototypes.size());
    }
    [[nodiscard]] double length(int k) const override { return prototype(k).length(); }
    [[nodiscard]] double energy(int k, const double* e) const override {
        return prototype(k).energy(copied(e));
    }
    void force(int k, const double* e, double* out) const override {
        copy(prototype(k).force(copied(e)), out);
    }
    double evaluate(int k, const double* e, double* force, double* tangent) const override {
        const auto result = prototype(k).evaluate(copied(e));
        copy(result.force, force);
        copy(result.tangent, tangent);
        return result.energy;
    }
    [[nodiscard]] bool admissible(int k, const double* e) const override {
        return prototype(k).admissible(copied(e));
    }
    [[nodiscard]] bool softened([[maybe_unused]] int k,
                                [[maybe_unused]] const double* e) const override {
        if constexpr (detail::offers<detail::Softening, Element>)
            return prototype(k).softened(copied(e));
        else
            return false;
    }
    void mass(int k, double* out) const override { copy(prototype(k).mass(), out); }
    void gravity(int k, const double* acceleration, double* out) const override {
        Vector<double, Element::dimension> g;
        std::copy_n(acceleration, Element::dimension, g.data());
        copy(prototype(k).gravity(g), out);
    }
    void torsion_stiffness([[maybe_unused]] int k, double (&out)[2]) const override {
        Vector<double, 2> own = {0.0, 0.0};
        if constexpr (detail::offers<detail::TorsionStiffness, Element>)
            own = prototype(k).torsion_stiffness();
        std::copy_n(own.data(), 2, out);
    }
    double add(const ElementRun& run, const GroupTarget& target) const override {
        constexpr int lanes = detail::pack_lanes<Element>;
        double energy = 0.0;
        [[maybe_unused]] const bool plain = target.increment == nullptr && target.before == nullptr;
        [[maybe_unused]] const auto equal = [&](int first) {
            const Connection* const part = &connections[first];
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
        return energy;
    }
    void add_block(int index, const GroupTarget& target, const double* block) const override {
        Matrix<double, Element::dofs> own;
        std::copy_n(block, Element::dofs * Element::dofs, own.data());
        add_block(target.slots[index], target, own);
    }

private:
    [[nodiscard]] const Element& prototype(int k) const { return prototypes[k]; }
    [[nodiscard]] static Coordinates copied(const double* e) {
        Coordinates own;
        std::copy_n(e, Element::dofs, own.data());
        return own;
    }
    static void copy(const Coordinates& from, double* to) {
        std::copy_n(from.data(), Element::dofs, to);
    }
    static void copy(const Matrix<double, Element::dofs>& from, double* to) {
        std::copy_n(from.data(), Element::dofs * Element::dofs, to);
    }

    static void add_block(const ElementSlots& slots, const GroupTarget& target,
                          const Matrix<double, Element::dofs>& tangent) {
        if (slots.attached >= 0) {
            detail::add_attached(target, slots.attached, tangent.data());
            return;
        }
        constexpr int half = Element::dofs / 2;
        for (int b = 0; b < 2; ++b)
            for (int a = 0; a < 2; ++a)
                detail::scatter_part<Element>(
                    target, slots, a, b, tangent.template block<half, half>(a * half, b * half));
    }
    double add_element(int index, const GroupTarget& target) const {
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
            for (int i = 0; i < Element::dofs; ++i)
                target.internal_force[coordinate[i]] += force[i];
            return 0.0;
        }
        const auto predict = [&](const Coordinates& force) {
            for (int i = 0; target.predicted_force != nullptr && i < Element::dofs; ++i)
                target.predicted_force[coordinate[i]] += force[i];
        };
        auto result = [&]() -> Evaluation<double, Element::dofs> {
            if constexpr (detail::offers<detail::MixedEvaluationOf, Element>)
                if (target.before != nullptr) {
                    const auto mixed =
                        element.evaluate(e, gathered(target.before), gathered(target.change));
                    if constexpr (detail::offers<detail::PredictedForce, decltype(mixed)>)
                        predict(mixed.predicted);
                    else
                        predict(mixed.force);
                    return mixed;
                }
            auto plain = element.evaluate(e);
            predict(plain.force);
            return plain;
        }();
        if (target.increment != nullptr) {
            const Coordinates change = gathered(target.increment);
            for (int j = 0; j < Element::dofs; ++j)
                for (int i = 0; i < Element::dofs; ++i)
                    result.force[i] += result.tangent(i, j) * change[j];
        }
        for (int i = 0; i < Element::dofs; ++i)
            target.internal_force[coordinate[i]] += result.force[i];
        if (!target.tangent) return result.energy;
        add_block(slots, target, result.tangent);
        return result.energy;
    }
    template <int Lanes>
    double add_pack(int first, const GroupTarget& target) const {
        const ElementSlots* slots = target.slots + first;
        const Element& element = prototype(prototype_of(first));
        int coordinate[Lanes][Element::dofs];
        Vector<Pack<Lanes>, Element::dofs> e;
        for (int lane = 0; lane < Lanes; ++lane) {
            detail::element_coordinates(target.layout, Element::dimension, Element::fields,
                                        slots[lane], coordinate[lane]);
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
        // a block of all lanes at a time: packs are read once, and what is written stays in cache
        constexpr int half = Element::dofs / 2;
        if (target.attached != nullptr) {
            Matrix<double, Element::dofs> own;
            for (int lane = 0; lane < Lanes; ++lane) {
                for (int j = 0; j < Element::dofs; ++j)
                    for (int i = 0; i < Element::dofs; ++i) own(i, j) = result.tangent(i, j)[lane];
                add_block(slots[lane], target, own);
            }
            return lane_sum(result.energy);
        }
        Matrix<double, half> blocks[Lanes];
        for (int a = 0; a < 2; ++a)
            for (int b = 0; b < 2; ++b) {
                const auto stores = [&](const ElementSlots& one) { return one.base[a][b] >= 0; };
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
};

namespace detail {

template <class Element>
std::unique_ptr<ElementGroup> make_group() {
    return std::unique_ptr<ElementGroup>(new GroupOf<Element>);
}

template <class Element>
int append_prototype(ElementGroup& group, Element&& element) {
    auto& prototypes = static_cast<GroupOf<Element>&>(group).prototypes;
    prototypes.push_back(std::move(element));
    return static_cast<int>(prototypes.size()) - 1;
}

}  // namespace detail

}  // namespace ancf
