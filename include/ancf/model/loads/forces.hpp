// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Dead forces: at a node and over elements.

#pragma once

#include <ancf/model/layout.hpp>
#include <ancf/model/load.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

namespace ancf {

/// A dead force at a node, N.
template <int Dimension = 3>
class Force {
public:
    static constexpr int dimension = Dimension;   ///< of the model it belongs to
    static constexpr bool constant_force = true;  ///< it has no derivatives

    /// @throws InvalidArgument unless the force is finite.
    Force(NodeId node, const VectorArgument<Dimension>& force);

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, Field::r}}; }
    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

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
    GeneralisedForce(Coupling coupling, VectorX force);

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return coupling_; }
    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    Coupling coupling_;
    VectorX force_;
};

/// A force's dimension is that of its vector.
template <int Dimension>
Force(NodeId, Vector<double, Dimension>) -> Force<Dimension>;

#if defined(ANCF_COMPILED)
extern template class Force<2>;
extern template class Force<3>;
#endif

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/loads/forces.ipp>  // IWYU pragma: export
#endif
