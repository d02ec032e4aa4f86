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
    [[nodiscard]] std::string name() const {
        return "rigid section of node " + std::to_string(node_.index);
    }

    /// Returns g.
    template <class Scalar>
    [[nodiscard]] DynamicVector<Scalar> violation(const DynamicVector<Scalar>& q,
                                                  const Scalar& /*time*/) const {
        const Vector<Scalar, 3> y = q.template head<3>(), z = q.template tail<3>();
        DynamicVector<Scalar> g(3);
        g[0] = Scalar(0.5) * (Scalar(y.transpose() * y) - Scalar(1.0));
        g[1] = Scalar(0.5) * (Scalar(z.transpose() * z) - Scalar(1.0));
        g[2] = y.transpose() * z;
        return g;
    }

    /// Returns G = dg/dq.
    template <class Scalar>
    [[nodiscard]] DynamicMatrix<Scalar> jacobian(const DynamicVector<Scalar>& q,
                                                 const Scalar& /*time*/) const {
        DynamicMatrix<Scalar> g = DynamicMatrix<Scalar>::Zero(3, 6);
        for (int k = 0; k < 3; ++k) {
            g(0, k) = g(2, 3 + k) = q[k];
            g(1, 3 + k) = g(2, k) = q[3 + k];
        }
        return g;
    }

    /// Returns g_t.
    template <class Scalar>
    [[nodiscard]] DynamicVector<Scalar> rate(const DynamicVector<Scalar>& /*q*/,
                                             const Scalar& /*time*/) const {
        return DynamicVector<Scalar>::Zero(3);
    }

    /// Evaluates it where it stands.
    void evaluate(const ConstraintState& at, ConstraintResult& out) const {
        out.violation = violation(at.q, at.time);
        out.jacobian = jacobian(at.q, at.time);
        const Vector<double, 3> dy = at.v.head<3>(), dz = at.v.tail<3>();
        out.convection << dy.squaredNorm(), dz.squaredNorm(), 2.0 * dy.dot(dz);
        for (int k = 0; k < 3; ++k) {
            out.stiffness(k, k) = at.multipliers[0];
            out.stiffness(3 + k, 3 + k) = at.multipliers[1];
            out.stiffness(k, 3 + k) = out.stiffness(3 + k, k) = at.multipliers[2];
        }
    }

private:
    NodeId node_;
};

}  // namespace ancf
