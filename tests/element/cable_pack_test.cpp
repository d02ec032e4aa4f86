// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The straight cable, several of them side by side.

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/pack.hpp>

#include <element/cable_samples.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cable_pack_test {

using namespace ancf;
using test::straight_cable;

TEMPLATE_TEST_CASE("Cable: a pack of doubles gives what each of its lanes gives",
                   "[element][cable][pack]", Cable<2>, Cable<3>, (Cable<2, EngineeringAxial>),
                   (Cable<3, EngineeringAxial>)) {
    constexpr int lanes = 4;
    constexpr int dofs = TestType::dofs;
    const auto element = straight_cable<TestType>({cable_rule(), GENERATE(1.0, 0.0)});
    double worst = 0.0;
    for (std::uint64_t seed = 0; seed < 25; ++seed) {
        Vector<Pack<lanes>, dofs> packed;
        Vector<double, dofs> single[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            test::Random random(lanes * seed + static_cast<std::uint64_t>(lane));
            single[lane] = test::random_state(element, random);
            for (int i = 0; i < dofs; ++i) packed(i).set(lane, single[lane](i));
        }
        const auto together = element.evaluate(packed);
        for (int lane = 0; lane < lanes; ++lane) {
            const auto alone = element.evaluate(single[lane]);
            worst = std::max(worst, std::abs(together.energy[lane] / alone.energy - 1.0));
            for (int i = 0; i < dofs; ++i) {
                worst = std::max(
                    worst, std::abs(together.force(i)[lane] - alone.force(i)) / alone.force.norm());
                for (int j = 0; j < dofs; ++j)
                    worst = std::max(worst,
                                     std::abs(together.tangent(i, j)[lane] - alone.tangent(i, j)) /
                                         alone.tangent.norm());
            }
        }
    }
    CHECK(worst <= 1e-14);  // the order of sums may differ; measured 4e-16
}

}  // namespace cable_pack_test
