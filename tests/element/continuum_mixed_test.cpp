// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The continuum beam's tangent of mixed integration points.

#include <ancf/element/continuum/beam.hpp>

#include <element/mixed_checks.hpp>
#include <support/catch.hpp>

namespace continuum_mixed_test {

using namespace ancf;

TEMPLATE_TEST_CASE("ContinuumBeam: the mixed tangent has the stresses of linearised strains",
                   "[element][continuum][tangent]", ContinuumBeam<2>, ContinuumBeam<3>) {
    // of a rule whose stations integrate E A eps^2/2 alone, too
    const Rule grouped = Rule::grouped("grouped", lobatto_quadrature(3), gauss_quadrature(2),
                                       gauss_quadrature(3), gauss_quadrature(2));
    const Section section =
        offset(rectangle(0.1, 0.2).with_shear_correction(0.8, 0.9), 0.02, -0.03);
    for (const auto law : {ContinuumMaterial::diagonal, ContinuumMaterial::enhanced})
        for (const Rule& rule : {Rule::paper(), grouped})
            test::check_mixed_tangent(
                TestType(Material::isotropic(2e7, 0.3, 7800.0), section, 0.7, {rule, law}));
}

}  // namespace continuum_mixed_test
