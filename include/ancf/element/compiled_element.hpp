// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the header of an element declares so that the compiled library holds it.
///
/// `extern template class Element;` at the end of an element's header makes the library hold the
/// element and its group; CMake finds the elements by these lines.

#pragma once

#include <memory>

namespace ancf {

class ElementGroup;

namespace detail {

/// Returns an empty group for elements of a type; defined where models are.
template <class Element>
[[nodiscard]] std::unique_ptr<ElementGroup> make_group();

}  // namespace detail

}  // namespace ancf
