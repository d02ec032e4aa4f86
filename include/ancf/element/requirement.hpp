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
#include <utility>

namespace ancf {
namespace detail {

template <class Element, class = void>
struct HasElementSizes : std::false_type {};
template <class Element>
struct HasElementSizes<
    Element, std::void_t<std::integral_constant<int, Element::dimension>,
                         std::integral_constant<int, Element::dofs>, typename Element::Coordinates,
                         decltype(Fields(Element::fields))>>
    : std::bool_constant<
          Element::dofs == 2 * Element::dimension * Fields(Element::fields).count() &&
          std::is_same_v<typename Element::Coordinates, Vector<double, Element::dofs>>> {};

template <class Element>
using ElementArgument = const typename Element::Coordinates&;

template <class Element, class = void>
struct HasEvaluate : std::false_type {};
template <class Element>
struct HasEvaluate<Element, std::void_t<decltype(std::declval<const Element&>().evaluate(
                                std::declval<ElementArgument<Element>>()))>>
    : std::is_same<decltype(std::declval<const Element&>().evaluate(
                       std::declval<ElementArgument<Element>>())),
                   Evaluation<double, Element::dofs>> {};

template <class Element, class = void>
struct HasForce : std::false_type {};
template <class Element>
struct HasForce<Element, std::void_t<decltype(typename Element::Coordinates(
                                         std::declval<const Element&>().force(
                                             std::declval<ElementArgument<Element>>()))),
                                     decltype(double(std::declval<const Element&>().energy(
                                         std::declval<ElementArgument<Element>>())))>>
    : std::true_type {};

template <class Element, class = void>
struct HasInertia : std::false_type {};
template <class Element>
struct HasInertia<
    Element,
    std::void_t<decltype(Matrix<double, Element::dofs>(std::declval<const Element&>().mass())),
                decltype(typename Element::Coordinates(std::declval<const Element&>().gravity(
                    std::declval<const Vector<double, Element::dimension>&>())))>>
    : std::true_type {};

template <class Element, class = void>
struct HasAdmissible : std::false_type {};
template <class Element>
struct HasAdmissible<Element,
                     std::void_t<decltype(bool(std::declval<const Element&>().admissible(
                                     std::declval<ElementArgument<Element>>()))),
                                 decltype(double(std::declval<const Element&>().length()))>>
    : std::true_type {};

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
///   `double length() const`, m.
///
/// An element may offer more; docs/requirements.md lists what the library looks for.
template <class Element>
inline constexpr bool is_element_v =
    std::conjunction_v<detail::HasElementSizes<Element>, detail::HasEvaluate<Element>,
                       detail::HasForce<Element>, detail::HasInertia<Element>,
                       detail::HasAdmissible<Element>>;

/// Stops the compilation, naming each missing member, unless is_element_v holds; returns true.
template <class Element>
constexpr bool require_element() noexcept {
    static_assert(detail::HasElementSizes<Element>::value,
                  "an element needs: static constexpr int dimension, dofs; static constexpr "
                  "ancf::Fields fields; using Coordinates = ancf::Vector<double, dofs>; with "
                  "dofs = 2 * dimension * fields.count()");
    static_assert(detail::HasEvaluate<Element>::value,
                  "an element needs: ancf::Evaluation<double, dofs> evaluate(const Coordinates&) "
                  "const;");
    static_assert(detail::HasForce<Element>::value,
                  "an element needs: Coordinates force(const Coordinates&) const; and double "
                  "energy(const Coordinates&) const;");
    static_assert(detail::HasInertia<Element>::value,
                  "an element needs: ancf::Matrix<double, dofs> mass() const; and Coordinates "
                  "gravity(const ancf::Vector<double, dimension>&) const;");
    static_assert(detail::HasAdmissible<Element>::value,
                  "an element needs: bool admissible(const Coordinates&) const; and double "
                  "length() const;");
    return true;
}

namespace detail {

template <class Element, class = void>
struct has_parameter_length : std::false_type {};
template <class Element>
struct has_parameter_length<
    Element, std::void_t<decltype(std::declval<const Element&>().parameter_length())>>
    : std::true_type {};

/// Returns the range of an element's parameter; elements without a say in it are straight.
template <class Element>
[[nodiscard]] double parameter_length(const Element& element) {
    if constexpr (has_parameter_length<Element>::value)
        return element.parameter_length();
    else
        return element.length();
}

}  // namespace detail

}  // namespace ancf
