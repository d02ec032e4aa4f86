// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Sections that keep their shape: definitions.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/model/constraints/sections.hpp>
#include <ancf/types.hpp>

#include <complex>
#include <string>

namespace ancf {

ANCF_INLINE std::string RigidSection::name() const {
    return "rigid section of node " + std::to_string(node_.index);
}

template <class Scalar>
DynamicVector<Scalar> RigidSection::violation(const DynamicVector<Scalar>& q,
                                              const Scalar& /*time*/) const {
    const Vector<Scalar, 3> y = q.template head<3>(), z = q.template tail<3>();
    DynamicVector<Scalar> g(3);
    g[0] = Scalar(0.5) * (Scalar(y.transpose() * y) - Scalar(1.0));
    g[1] = Scalar(0.5) * (Scalar(z.transpose() * z) - Scalar(1.0));
    g[2] = y.transpose() * z;
    return g;
}

template <class Scalar>
DynamicMatrix<Scalar> RigidSection::jacobian(const DynamicVector<Scalar>& q,
                                             const Scalar& /*time*/) const {
    DynamicMatrix<Scalar> g = DynamicMatrix<Scalar>::Zero(3, 6);
    for (int k = 0; k < 3; ++k) {
        g(0, k) = g(2, 3 + k) = q[k];
        g(1, 3 + k) = g(2, k) = q[3 + k];
    }
    return g;
}

template <class Scalar>
DynamicVector<Scalar> RigidSection::rate(const DynamicVector<Scalar>& /*q*/,
                                         const Scalar& /*time*/) const {
    return DynamicVector<Scalar>::Zero(3);
}

ANCF_INLINE void RigidSection::evaluate(const ConstraintState& at, ConstraintResult& out) const {
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

#if defined(ANCF_SOURCE)
ANCF_CONSTRAINT_INSTANCES(RigidSection)
#endif

}  // namespace ancf
