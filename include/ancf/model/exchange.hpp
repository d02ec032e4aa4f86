// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the parts of one scene tell each other where each part stands in a process of its own.
///
/// A part (Scene::part) evaluates elements of its own. Coordinates at its rim belong to other parts
/// as well. The assembly and the static solution of a part call these functions, all parts in the
/// same order; those of a whole scene call none.

#pragma once

#include <ancf/list.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/types.hpp>

#include <exception>
#include <stdexcept>

namespace ancf::detail {

/// Sums over the parts of a scene. Every call is collective but owns(), constraints() and those
/// that return a number in the whole scene.
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
    /// Returns the number in the whole scene of an element of this part.
    [[nodiscard]] virtual int element(int group, int element) const noexcept = 0;
    /// Returns the constraints of the whole scene.
    [[nodiscard]] virtual const List<AnyConstraint>& constraints() const noexcept = 0;
    /// Returns the number in the whole scene of a load of this part.
    [[nodiscard]] virtual int load(int load) const noexcept = 0;
    /// Returns the number in the whole scene of a constraint of this part.
    [[nodiscard]] virtual int constraint(int constraint) const noexcept = 0;
};

/// Returns the largest of the numbers below 1000 that a call gives in the parts of a scene. Where
/// it throws in one of them, all throw.
/// @throws std::runtime_error where only others did; else what the call throws.
template <class Call>
[[nodiscard]] double largest_of(const Exchange& exchange, const Call& call) {
    constexpr double threw = 1000.0;
    double own = threw;
    std::exception_ptr thrown;  // none may leave the other parts waiting
    try {
        own = call();
    } catch (...) {
        thrown = std::current_exception();
    }
    const double largest = exchange.largest(own);
    if (thrown) std::rethrow_exception(thrown);
    if (largest == threw) throw std::runtime_error("another part of the scene threw an exception");
    return largest;
}

/// Calls what may throw in one part of a scene alone: then all parts throw, likewise.
/// @param exchange  none of a whole scene
template <class Call>
void together(const Exchange* exchange, const Call& call) {
    if (exchange == nullptr) return call();
    const auto none = [&] { return call(), 0.0; };
    static_cast<void>(largest_of(*exchange, none));
}

}  // namespace ancf::detail
