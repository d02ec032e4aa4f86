// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The mixed tangent of cables in the plane.

#include <ancf/element/cable/cable.hpp>

#include <element/cable_samples.hpp>
#include <element/mixed_checks.hpp>
#include <support/catch.hpp>

namespace cable_mixed_plane_test {

using namespace ancf;

TEMPLATE_TEST_CASE("Cable: the mixed tangent in the plane has the forces of linearised strains",
                   "[element][cable][tangent]", Cable<2>, (Cable<2, EngineeringAxial>)) {
    test::check_mixed_tangent(
        test::straight_cable<TestType>(CableOptions{test::cable_rule_of(0), 1.0}));
}

TEST_CASE("Cable: the mixed tangent of a curved cable has its natural curvature",
          "[element][cable][tangent]") {
    const test::Helix arc{0.5, 0.0};
    test::check_mixed_tangent(
        Cable<2>(test::cable_material(), test::cable_section(), arc.coordinates<2>(0.0, 0.7), 0.7));
}

}  // namespace cable_mixed_plane_test
