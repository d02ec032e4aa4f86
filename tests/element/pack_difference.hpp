// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// How far an element evaluated side by side in a pack is off single evaluations.

#pragma once

#include <ancf/element/evaluation.hpp>
#include <ancf/element/pack.hpp>
#include <ancf/types.hpp>

#include <support/random_state.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ancf::test {

/// Returns the largest difference between the lanes of a pack's evaluation and single evaluations,
/// relative.
template <int Lanes, class Element, class Packed>
double pack_difference(const std::array<const Element*, Lanes>& elements, const Packed& packed) {
    double worst = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Random random(seed);
        constexpr int dofs = Element::dofs;
        Vector<Pack<Lanes>, dofs> e;
        std::array<Evaluation<double, dofs>, Lanes> expected;
        std::array<Vector<double, dofs>, Lanes> force;
        std::array<double, Lanes> energy;
        for (std::size_t k = 0; k < Lanes; ++k) {
            const auto state = random_state(*elements[k], random);
            for (int i = 0; i < dofs; ++i) e(i).set(static_cast<int>(k), state(i));
            expected[k] = elements[k]->evaluate(state);
            force[k] = elements[k]->force(state);
            energy[k] = elements[k]->energy(state);
        }
        const auto evaluation = packed.evaluate(e);
        const auto packed_force = packed.force(e);
        const auto packed_energy = packed.energy(e);
        for (std::size_t k = 0; k < Lanes; ++k) {
            const int lane = static_cast<int>(k);
            worst = std::max(worst, std::abs(evaluation.energy[lane] / expected[k].energy - 1.0));
            worst = std::max(worst, std::abs(packed_energy[lane] / energy[k] - 1.0));
            for (int i = 0; i < dofs; ++i) {
                worst = std::max(worst, std::abs(evaluation.force(i)[lane] - expected[k].force(i)) /
                                            force[k].norm());
                worst = std::max(worst,
                                 std::abs(packed_force(i)[lane] - force[k](i)) / force[k].norm());
                for (int j = 0; j < dofs; ++j) {
                    worst = std::max(worst, std::abs(evaluation.tangent(i, j)[lane] -
                                                     expected[k].tangent(i, j)) /
                                                expected[k].tangent.norm());
                }
            }
        }
    }
    return worst;
}

}  // namespace ancf::test
