// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The straight cable has the properties of every element.

#include <ancf/element/cable/cable.hpp>

#include <element/cable_samples.hpp>
#include <element/property_checks.hpp>
#include <support/catch.hpp>

namespace cable_properties_test {

using namespace ancf;
using test::cable_material;
using test::cable_section;
using test::straight_cable;

Moments line_moments() {
    Moments line;  // no rotary inertia
    line.area = cable_section().moments().area;
    return line;
}

TEMPLATE_TEST_CASE("Cable: the straight element has the properties of every element",
                   "[element][cable]", Cable<2>, Cable<3>, (Cable<2, EngineeringAxial>),
                   (Cable<3, EngineeringAxial>)) {
    const CableOptions options{test::cable_rule_of(GENERATE(range(0, 5))), GENERATE(1.0, 0.3)};
    INFO("rule " << options.rule.name() << ", compression " << options.compression);
    const auto element = straight_cable<TestType>(options);
    test::check_zero_at_rest(element);
    test::check_rigid_invariance(element);
    test::check_derivatives(element);  // measured 7e-16
    test::check_turning(element);
    test::check_zero_modes(element);
    if constexpr (TestType::dimension == 3) test::check_planar(element);
    test::check_mass(element, cable_material().density, line_moments());
    test::check_gravity(element, cable_material().density, line_moments());
}

}  // namespace cable_properties_test
