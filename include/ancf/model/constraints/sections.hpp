// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Sections that keep their shape, as Reissner's beam has them.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/model/node.hpp>
#include <ancf/types.hpp>

#include <string>

namespace ancf {

/// The section of a node held in shape: r_y and r_z of unit length and normal to each other;
/// 3 equations, g = ((r_y.r_y - 1)/2, (r_z.r_z - 1)/2, r_y.r_z).
///
/// Bending aside of the slopes shears a section in its plane by E I kappa^2/(2 k G A), which counts
/// where a beam is bent to a radius of a few of its depths.
class RigidSection {
public:
    static constexpr int dimension = 3;  ///< of the model it belongs to

    /// Holds the section of a node that carries r_y and r_z.
    explicit RigidSection(NodeId node) : node_(node) {}

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, Field::r_y}, {node_, Field::r_z}}; }
    /// Returns the number of equations.
    [[nodiscard]] int equations() const { return 3; }
    /// Returns the word that messages use.
    [[nodiscard]] std::string name() const;

    /// Writes g, G and g_t.
    template <class Scalar>
    void terms(const DynamicVector<Scalar>& q, const Scalar& time,
               ConstraintTerms<Scalar>& out) const;
    /// Evaluates it where it stands.
    void evaluate(const ConstraintState& at, ConstraintResult& out) const;

private:
    NodeId node_;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/constraints/sections.ipp>  // IWYU pragma: export
#endif
