// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Dead forces: at a node and over elements.

#pragma once

#include <ancf/error.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/load.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

#include <utility>

namespace ancf {

/// A dead force at a node, N.
template <int Dimension = 3>
class Force {
public:
    static constexpr int dimension = Dimension;   ///< of the model it belongs to
    static constexpr bool constant_force = true;  ///< it has no derivatives

    /// @throws InvalidArgument unless the force is finite.
    Force(NodeId node, const VectorArgument<Dimension>& force) : node_(node), force_(force) {
        detail::require_finite("Force: components", detail::components(force));
    }

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, Field::r}}; }
    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const {
        for (int i = 0; i < Dimension; ++i) {
            out.force[i] = force_[i];
            out.potential -= force_[i] * state.q[i];
        }
    }

private:
    NodeId node_;
    Vector<double, Dimension> force_;
};

/// A constant generalised force on the coordinates of a coupling, such as a dead force per length.
///
/// `add_line_load` makes one per element.
class GeneralisedForce {
public:
    static constexpr bool constant_force = true;  ///< it has no derivatives

    /// @param force  in the order of the coupling; N and N m. A model refuses one of another size.
    /// @throws InvalidArgument unless the force is finite.
    GeneralisedForce(Coupling coupling, VectorX force)
        : coupling_(std::move(coupling)), force_(std::move(force)) {
        detail::require_finite("GeneralisedForce: components", detail::components(force_));
    }

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return coupling_; }
    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const {
        detail::require(force_.size() == state.q.size(), "GeneralisedForce: ", state.q.size(),
                        " coordinates are coupled, got ", force_.size(), " force components");
        out.force = force_;
        out.potential = -force_.dot(state.q);
    }

private:
    Coupling coupling_;
    VectorX force_;
};

/// A force's dimension is that of its vector.
template <int Dimension>
Force(NodeId, Vector<double, Dimension>) -> Force<Dimension>;

}  // namespace ancf
