// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the header of an element declares so that the compiled library holds it.
///
/// `ANCF_COMPILED_ELEMENT(Element);` at the end of an element's header makes the library hold its
/// group, and its energy, force and tangent of doubles; `ANCF_COMPILED_TEMPLATE(Element<3>);` those
/// of an instance of a class template and the rest of it. CMake finds the elements by these lines.

#pragma once

#include <memory>
#include <type_traits>

/// Declares that the library holds an element.
#define ANCF_COMPILED_ELEMENT(...) ANCF_ELEMENT_INSTANCE(extern, __VA_ARGS__)
/// Declares that the library holds an element whose class is the instance of a template.
#define ANCF_COMPILED_TEMPLATE(...)    \
    extern template class __VA_ARGS__; \
    ANCF_ELEMENT_INSTANCE(extern, __VA_ARGS__)
/// Declares (`extern`) or defines (nothing) what of an element is not in its class's own instance.
#define ANCF_ELEMENT_INSTANCE(linkage, ...)                                                   \
    linkage template std::unique_ptr<ElementGroup> detail::make_group<__VA_ARGS__>();         \
    linkage template int detail::append_prototype(ElementGroup&, __VA_ARGS__&&);              \
    linkage template double detail::Evaluator<__VA_ARGS__>::energy(                           \
        const Vector<double, __VA_ARGS__::dofs>&) const noexcept;                             \
    linkage template Vector<double, __VA_ARGS__::dofs> detail::Evaluator<__VA_ARGS__>::force( \
        const Vector<double, __VA_ARGS__::dofs>&) const noexcept;                             \
    linkage template Evaluation<double, __VA_ARGS__::dofs>                                    \
    detail::Evaluator<__VA_ARGS__>::evaluate(const Vector<double, __VA_ARGS__::dofs>&)        \
        const noexcept

namespace ancf {

class ElementGroup;

namespace detail {

/// Returns an empty group for elements of a type; defined where models are.
template <class Element>
[[nodiscard]] std::unique_ptr<ElementGroup> make_group();

/// Adds a prototype to the group of its type and returns its index.
template <class Element>
int append_prototype(ElementGroup& group, Element&& element);

template <class Element, class = void>
struct EvaluatorOf {
    using type = Element;
};
template <class Element>
struct EvaluatorOf<Element, std::void_t<typename Element::Evaluator>> {
    using type = typename Element::Evaluator;
};

/// The class that has an element's energy, force and tangent: its kernel, or the element itself.
template <class Element>
using Evaluator = typename EvaluatorOf<Element>::type;

}  // namespace detail

}  // namespace ancf
