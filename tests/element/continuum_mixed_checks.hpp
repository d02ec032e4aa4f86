// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The continuum beam's tangent of mixed integration points.

#pragma once

#include <ancf/element/continuum/beam.hpp>

#include <element/mixed_checks.hpp>

namespace ancf {

// compiled apart from the complex one: each unit within 700 MB
extern template MixedEvaluation<double, 24> detail::Evaluator<ContinuumBeam<3>>::evaluate(
    const Vector<double, 24>&, const Vector<double, 24>&, const Vector<double, 24>&) const noexcept;

}  // namespace ancf

namespace ancf::test {

/// Checks two laws by two rules; one has stations that integrate E A eps^2/2 alone.
template <int Dimension>
void check_mixed_continuum() {
    const Rule grouped = Rule::grouped("grouped", lobatto_quadrature(3), gauss_quadrature(2),
                                       gauss_quadrature(3), gauss_quadrature(2));
    const Section section =
        offset(rectangle(0.1, 0.2).with_shear_correction(0.8, 0.9), 0.02, -0.03);
    for (const auto law : {ContinuumMaterial::diagonal, ContinuumMaterial::enhanced})
        for (const Rule& rule : {Rule::paper(), grouped})
            check_mixed_tangent(ContinuumBeam<Dimension>(Material::isotropic(2e7, 0.3, 7800.0),
                                                         section, 0.7, {rule, law}));
}

}  // namespace ancf::test
