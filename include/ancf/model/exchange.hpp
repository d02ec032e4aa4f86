// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the parts of one scene tell each other where each part stands in a process of its own.
///
/// A part (Scene::part) evaluates elements of its own. Coordinates at its rim belong to other parts
/// as well. The assembly and the static solution of a part call these functions, all parts in the
/// same order; those of a whole scene call none.

#pragma once

#include <ancf/model/constraint.hpp>
#include <ancf/types.hpp>

#include <vector>

namespace ancf::detail {

/// Sums over the parts of a scene. Every call but owns() and constraints() is collective.
class Exchange {
public:
    virtual ~Exchange() = default;

    /// Replaces forces of all coordinates of the part by the sums over all parts that have them.
    virtual void add(VectorX& forces) const = 0;
    /// Tells whether this part answers for a coordinate of its own numbering; one part of all does.
    [[nodiscard]] virtual bool owns(int coordinate) const noexcept = 0;
    /// Replaces numbers by their sums over all parts.
    virtual void sum(double* values, int count) const = 0;
    /// Returns the largest of the values that the parts give.
    [[nodiscard]] virtual double largest(double value) const = 0;
    /// Returns the constraints of the whole scene.
    [[nodiscard]] virtual const std::vector<AnyConstraint>& constraints() const noexcept = 0;

protected:
    Exchange() = default;
    Exchange(const Exchange&) = default;             ///< by derived classes alone
    Exchange& operator=(const Exchange&) = default;  ///< by derived classes alone
};

}  // namespace ancf::detail
