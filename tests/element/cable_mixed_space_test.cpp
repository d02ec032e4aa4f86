// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The mixed tangent of cables in space.

#include <ancf/element/cable/cable.hpp>

#include <element/cable_samples.hpp>
#include <element/mixed_checks.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/random_state.hpp>

namespace cable_mixed_space_test {

using namespace ancf;

TEMPLATE_TEST_CASE("Cable: the mixed tangent in space has the forces of linearised strains",
                   "[element][cable][tangent]", Cable<3>, (Cable<3, EngineeringAxial>)) {
    test::check_mixed_tangent(
        test::straight_cable<TestType>(CableOptions{test::cable_rule_of(0), 1.0}));
}

TEST_CASE(
    "Cable: without a correction the mixed tangent of a curved cable in space is the plain one",
    "[element][cable][tangent]") {
    const test::Helix helix{0.5, 0.1};
    const Cable<3> cable(test::cable_material(), test::cable_section(),
                         helix.coordinates<3>(0.0, 0.7), 0.7);
    test::Random random(1);
    const Vector<double, 12> e = test::random_state(cable, random);
    const auto plain = cable.evaluate(e);
    const auto mixed = cable.evaluate(e, e, Vector<double, 12>(Vector<double, 12>::Zero()));
    CHECK(test::relative_error(mixed.tangent, plain.tangent) <= 1e-13);
    CHECK(test::relative_error(mixed.predicted, plain.force) <= 1e-13);
}

TEST_CASE("Cable: a rope's predicted force is that of its law at the predicted strain",
          "[element][cable][tangent]") {
    const auto rope = test::straight_cable<Cable<3>>(CableOptions{test::cable_rule_of(0), 0.25});
    const Vector<double, 12> rest = test::reference_coordinates(rope);
    for (const double strain : {0.004, -0.004}) {
        INFO(strain);
        Vector<double, 12> change = Vector<double, 12>::Zero();
        change[6] = strain * rope.length();
        change[3] = change[9] = strain;
        const auto mixed = rope.evaluate(rest, rest, change);
        const Vector<double, 12> pulled = rest + change;
        // the stretch enters the strain by strain (1 + strain/2), and B by 1 + strain: not here
        CHECK(mixed.predicted[6] ==
              Approx(rope.force(pulled)[6] / (1.0 + strain) / (1.0 + 0.5 * strain)).epsilon(1e-12));
    }
}

}  // namespace cable_mixed_space_test
