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
void RigidSection::terms(const DynamicVector<Scalar>& q, const Scalar& /*time*/,
                         ConstraintTerms<Scalar>& out) const {
    const auto y = detail::vec3<Scalar>(q), z = detail::vec3<Scalar>(q, 3);
    out.violation[0] = Scalar(0.5) * (dot(y, y) - Scalar(1.0));
    out.violation[1] = Scalar(0.5) * (dot(z, z) - Scalar(1.0));
    out.violation[2] = dot(y, z);
    for (int k = 0; k < 3; ++k) {
        out.jacobian(0, k) = out.jacobian(2, 3 + k) = y[k];
        out.jacobian(1, 3 + k) = out.jacobian(2, k) = z[k];
    }
}

ANCF_INLINE void RigidSection::evaluate(const ConstraintState& at, ConstraintResult& out) const {
    terms(at.q, at.time, out);
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
