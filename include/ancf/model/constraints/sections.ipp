// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Sections that keep their shape: definitions.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/vec3.hpp>
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
    const auto y = detail::vec3<Scalar>(q), z = detail::vec3<Scalar>(q, 3);
    DynamicVector<Scalar> g(3);
    g[0] = Scalar(0.5) * (dot(y, y) - Scalar(1.0));
    g[1] = Scalar(0.5) * (dot(z, z) - Scalar(1.0));
    g[2] = dot(y, z);
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
    const auto dy = detail::vec3<double>(at.v), dz = detail::vec3<double>(at.v, 3);
    out.convection[0] = dot(dy, dy);
    out.convection[1] = dot(dz, dz);
    out.convection[2] = 2.0 * dot(dy, dz);
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
