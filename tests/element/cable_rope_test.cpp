// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Cables that are softer in compression than in tension, down to ropes that only pull.

#include <ancf/element/cable.hpp>

#include <element/cable_samples.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/element_properties.hpp>
#include <support/random_state.hpp>

#include <cstdint>

namespace cable_rope_test {

using namespace ancf;
using test::straight_cable;

TEMPLATE_TEST_CASE("Cable: a rope that only pulls has no axial energy in compression",
                   "[element][cable][rope]", Cable<2>, Cable<3>, (Cable<2, EngineeringAxial>),
                   (Cable<3, EngineeringAxial>)) {
    const auto rope = straight_cable<TestType>({cable_rule(), 0.0});
    const auto soft = straight_cable<TestType>({cable_rule(), 0.25});
    const auto bar = straight_cable<TestType>();
    const auto stretched = [&](double stretch) {
        return typename TestType::Coordinates(stretch * test::reference_coordinates(bar));
    };
    for (const double stretch : {1.0, 1.001, 1.3}) {
        const auto e = stretched(stretch);
        CHECK(rope.energy(e) == bar.energy(e));
        CHECK(rope.evaluate(e).tangent == bar.evaluate(e).tangent);
    }
    for (const double stretch : {0.7, 0.999}) {
        const auto e = stretched(stretch);
        REQUIRE(bar.energy(e) > 0.0);
        CHECK(rope.energy(e) <= 1e-28 * bar.energy(e));  // what round-off bends
        CHECK(rope.force(e).norm() <= 1e-14 * bar.force(e).norm());
        CHECK(soft.energy(e) == Approx(0.25 * bar.energy(e)).epsilon(1e-14));
        CHECK(test::relative_error(soft.force(e), (0.25 * bar.force(e)).eval()) <= 1e-14);
    }
    // no jump of the force where the law changes
    const double step = 1e-9;
    const double jump =
        (rope.force(stretched(1.0 + step)) - rope.force(stretched(1.0 - step))).norm();
    CHECK(jump <= 2.0 * step * bar.evaluate(stretched(1.0)).tangent.norm() * stretched(1.0).norm());
    // at rest, in any orientation, the tangent is the taut one: round-off is no compression
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        test::Random random(seed);
        const auto e = test::rigid_state(bar, random, 1.0);
        CHECK(test::relative_error(rope.evaluate(e).tangent, bar.evaluate(e).tangent) <= 1e-12);
    }
}

TEMPLATE_TEST_CASE("Cable: derivatives hold across taut and slack stations",
                   "[element][cable][rope]", Cable<2>, Cable<3>, (Cable<2, EngineeringAxial>),
                   (Cable<3, EngineeringAxial>)) {
    test::check_derivatives(straight_cable<TestType>({Rule::gauss(5), 0.0}));
}

}  // namespace cable_rope_test
