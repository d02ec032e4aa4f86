// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What an element class must offer so that an assembly can take it, and the message where it does
/// not.
///
/// docs/requirements.md shows the smallest one.

#pragma once

#include <ancf/element/evaluation.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/types.hpp>

#include <type_traits>

namespace ancf {
namespace detail {

template <class Element>
using ElementSizes =
    std::enable_if_t<Element::dofs == 2 * Element::dimension * Fields(Element::fields).count() &&
                     std::is_same_v<typename Element::Coordinates, Vector<double, Element::dofs>>>;

template <class Element>
using ElementEvaluation = std::enable_if_t<
    std::is_same_v<decltype(some<Element>().evaluate(some<typename Element::Coordinates>())),
                   Evaluation<double, Element::dofs>>>;

template <class Element>
using ElementForce =
    std::void_t<decltype(typename Element::Coordinates(
                    some<Element>().force(some<typename Element::Coordinates>()))),
                decltype(double(some<Element>().energy(some<typename Element::Coordinates>())))>;

template <class Element>
using ElementInertia = std::void_t<decltype(Matrix<double, Element::dofs>(some<Element>().mass())),
                                   decltype(typename Element::Coordinates(some<Element>().gravity(
                                       some<Vector<double, Element::dimension>>())))>;

template <class Element>
using ElementLimits =
    std::void_t<decltype(bool(some<Element>().admissible(some<typename Element::Coordinates>()))),
                decltype(double(some<Element>().length()))>;

template <class Element>
using ElementMembers =
    std::void_t<ElementSizes<Element>, ElementEvaluation<Element>, ElementForce<Element>,
                ElementInertia<Element>, ElementLimits<Element>>;

template <class Element>
using ParameterLength = decltype(some<Element>().parameter_length());

/// Returns the range of an element's parameter x, m; length() of an element without the member.
template <class Element>
[[nodiscard]] double parameter_length(const Element& element) {
    if constexpr (offers<ParameterLength, Element>)
        return element.parameter_length();
    else
        return element.length();
}

}  // namespace detail

/// True if `Element` meets the requirement, d standing for its dimension and n for its dofs:
///
/// - `static constexpr int dimension`, 2 or 3, `static constexpr int dofs` and
///   `static constexpr Fields fields`, the vectors of a node: n = 2 d fields.count();
/// - `using Coordinates = Vector<double, n>`, the vectors of the first node, then of the second;
/// - `Evaluation<double, n> evaluate(const Coordinates&) const`: energy, force and tangent;
/// - `Coordinates force(const Coordinates&) const`, `double energy(const Coordinates&) const`;
/// - `Matrix<double, n> mass() const`, `Coordinates gravity(const Vector<double, d>&) const`;
/// - `bool admissible(const Coordinates&) const`, whether the strains are defined there, and
///   `double length() const`, m, positive.
///
/// An element may offer more; docs/requirements.md lists what the library looks for.
template <class Element>
inline constexpr bool is_element_v = detail::offers<detail::ElementMembers, Element>;

/// Stops the compilation, naming each missing member, unless is_element_v holds; returns true.
template <class Element>
constexpr bool require_element() noexcept {
    static_assert(detail::offers<detail::ElementSizes, Element>,
                  "an element needs: static constexpr int dimension, dofs; static constexpr "
                  "ancf::Fields fields; using Coordinates = ancf::Vector<double, dofs>; with "
                  "dofs = 2 * dimension * fields.count()");
    static_assert(detail::offers<detail::ElementEvaluation, Element>,
                  "an element needs: ancf::Evaluation<double, dofs> evaluate(const Coordinates&) "
                  "const;");
    static_assert(detail::offers<detail::ElementForce, Element>,
                  "an element needs: Coordinates force(const Coordinates&) const; and double "
                  "energy(const Coordinates&) const;");
    static_assert(detail::offers<detail::ElementInertia, Element>,
                  "an element needs: ancf::Matrix<double, dofs> mass() const; and Coordinates "
                  "gravity(const ancf::Vector<double, dimension>&) const;");
    static_assert(detail::offers<detail::ElementLimits, Element>,
                  "an element needs: bool admissible(const Coordinates&) const; and double "
                  "length() const;");
    return true;
}

}  // namespace ancf
