// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Vectors as arguments of calls that people write with braces.

#pragma once

#include <ancf/error.hpp>
#include <ancf/types.hpp>

#include <cstddef>
#include <initializer_list>

namespace ancf {

/// A vector given by an expression of Eigen or by its components in braces, as many as it has.
///
/// A fixed vector of Eigen's takes two integers, as in `set_gravity({0, -10})` of a scene in space,
/// for a number of rows and columns: its components are then whatever stood in memory.
template <int Dimension>
class VectorArgument : public Vector<double, Dimension> {
public:
    /// The components. @throws InvalidArgument for another number of them.
    VectorArgument(std::initializer_list<double> components) {
        detail::require(
            components.size() == static_cast<std::size_t>(Dimension), "expected a vector of ",
            Dimension, " components, got ", components.size(), ": ",
            detail::Components{components.begin(), static_cast<std::ptrdiff_t>(components.size())});
        int k = 0;
        for (const double component : components) (*this)[k++] = component;
    }

    /// Any expression of that size.
    template <class Derived>
    VectorArgument(const Eigen::MatrixBase<Derived>& vector)  // NOLINT: it is a vector
        : Vector<double, Dimension>(vector) {}
};

}  // namespace ancf
