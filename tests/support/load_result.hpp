// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What a load gives at its own coordinates, and a check of a damper's derivatives.

#pragma once

#include <ancf/model/load.hpp>
#include <ancf/types.hpp>

#include <support/catch.hpp>
#include <support/complex_step.hpp>

#include <complex>

namespace ancf::test {

template <class Load>
LoadResult load_result(const Load& load, const VectorX& q, const VectorX& v) {
    LoadResult out;
    out.force.setZero(q.size());
    out.stiffness.setZero(q.size(), q.size());
    out.damping.setZero(q.size(), q.size());
    load.evaluate({q, v, 0.0}, out);
    return out;
}

/// Checks Q of a damper, and dQ/dq and dQ/dv by complex steps.
/// @param force  Q(q, v) of the theory, on any scalar.
template <class Damper, class Force>
void check_damper(const Damper& damper, const Force& force, const VectorX& q, const VectorX& v,
                  double tolerance) {
    using Complex = DynamicVector<std::complex<double>>;
    const LoadResult result = load_result(damper, q, v);
    const Complex at_q = q.cast<std::complex<double>>(), at_v = v.cast<std::complex<double>>();
    const auto by_q = complex_step_jacobian([&](const Complex& z) { return force(z, at_v); }, q);
    const auto by_v = complex_step_jacobian([&](const Complex& z) { return force(at_q, z); }, v);
    CHECK(relative_error(result.stiffness, by_q) < tolerance);
    CHECK(relative_error(result.damping, by_v) < tolerance);
    CHECK(relative_error(result.force, force(q, v)) < tolerance);
}

}  // namespace ancf::test
