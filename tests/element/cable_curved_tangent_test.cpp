// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Force and tangent of cables whose stress-free state is a curve.

#include <ancf/element/cable/cable.hpp>

#include <element/cable_curved_samples.hpp>
#include <element/property_checks.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <cstdint>

namespace cable_curved_tangent_test {

using namespace ancf;
using test::AnyElement;
using test::disturbed;
using test::for_each_curved;
using test::Random;

TEMPLATE_TEST_CASE(
    "Cable: force and tangent of a curved element equal the complex-step derivatives",
    "[element][cable][curved]", Cable<2>, Cable<3>, (Cable<3, EngineeringAxial>)) {
    test::DerivativeErrors worst;
    const int count = for_each_curved<TestType>([&](const auto& curve, const VectorX& reference) {
        const AnyElement element(curve);
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            Random random(seed);
            test::raise(worst, element, curve, disturbed(element.shape, reference, random, 0.2));
        }
    });
    CHECK(count >= 12);
    CHECK(worst.force <= 1e-12);    // measured 2e-15
    CHECK(worst.tangent <= 1e-12);  // measured 3e-15
    CHECK(worst.symmetry <= 1e-14);
}

}  // namespace cable_curved_tangent_test
