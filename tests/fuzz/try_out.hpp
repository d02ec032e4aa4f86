// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Random coordinates for every element: huge, tiny, not finite, coincident nodes, parallel slopes.
///
/// What must hold whatever they are: the call returns, and where the coordinates are admissible and
/// of a size that cannot overflow, energy, force and tangent are finite and the energy is not
/// negative beyond round-off. Coordinates that are not finite are never admissible.
///
/// ANCF_FUZZ_SECONDS sets the time of all elements, ANCF_FUZZ_SEED the seed; 15 and 1 without them.

#pragma once

#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>

#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace ancf::test {

inline double setting(const char* name, double otherwise) {
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : std::strtod(text, nullptr);
}

/// Returns a number of a random kind; `tame` keeps it of a size whose powers do not overflow.
inline double number(Random& random, bool tame) {
    const double size = random.uniform(-1.0, 1.0);
    switch (static_cast<int>(random.uniform(0.0, tame ? 4.0 : 9.0))) {
        case 0: return size;
        case 1: return 0.0;
        case 2: return 1e-9 * size;
        case 3: return 100.0 * size;
        case 4: return 1e200 * size;
        case 5: return std::numeric_limits<double>::denorm_min();
        case 6: return std::numeric_limits<double>::quiet_NaN();
        case 7: return std::numeric_limits<double>::infinity();
        default: return std::numeric_limits<double>::max();
    }
}

/// Returns coordinates: of a random kind each, or a straight element with some of them changed, a
/// vector copied over another, or one node on the other.
template <class Element>
typename Element::Coordinates coordinates(Random& random, bool tame) {
    constexpr int dimension = Element::dimension, half = Element::dofs / 2;
    typename Element::Coordinates e = Element::Coordinates::Zero();
    for (int node = 0; node < 2; ++node) {
        for (int k = 1; k < half / dimension && k <= dimension; ++k)
            e[node * half + dimension * k + k - 1] = 1.0;
        e[node * half] = node;
    }
    const int kind = static_cast<int>(random.uniform(0.0, 5.0));
    const auto any = [&](int count) { return static_cast<int>(random.uniform(0.0, count - 1e-9)); };
    if (kind == 0)
        for (int k = 0; k < e.size(); ++k) e[k] = number(random, tame);
    if (kind == 1) e[any(Element::dofs)] = number(random, tame);
    if (kind == 2) {
        const int from = dimension * any(Element::dofs / dimension);
        const int to = dimension * any(Element::dofs / dimension);
        e.template segment<dimension>(to) = e.template segment<dimension>(from).eval();
    }
    if (kind == 3) e.template tail<half>() = e.template head<half>().eval();
    if (kind == 4)
        for (int k = 0; k < e.size(); ++k) e[k] += random.uniform(-1.0, 1.0);
    return e;
}

/// Tries an element of a square steel bar for a tenth of the time (there are ten), or with a
/// thousand states if that takes longer.
template <class Element>
void try_out() {
    const Element element(Material::isotropic(2e11, 0.3, 7850.0), rectangle(0.01, 0.01), 1.0);
    const double seconds = setting("ANCF_FUZZ_SECONDS", 15.0) / 10.0;
    const auto seed = static_cast<std::uint64_t>(setting("ANCF_FUZZ_SEED", 1.0));
    constexpr double axial = 2e11 * 1e-4;  // E A times the length, J
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    Random random(seed);
    long tried = 0, used = 0, wrong = 0;
    while (wrong == 0 && (tried < 1000 || Clock::now() < end)) {
        const bool tame = random.uniform(0.0, 1.0) < 0.5;
        const auto e = coordinates<Element>(random, tame);
        const auto result = element.evaluate(e);
        const auto force = element.force(e);
        const double energy = element.energy(e);
        const bool admissible = element.admissible(e);
        if (admissible && !e.allFinite()) ++wrong;
        const double size = e.template lpNorm<Eigen::Infinity>();
        const double round_off =
            1e-15 * axial * (1.0 + std::pow(size, 4));  // Green's strain squared
        if (admissible && size < 1e3 &&
            !(std::isfinite(energy) && energy >= -round_off && std::isfinite(result.energy) &&
              force.allFinite() && result.force.allFinite() && result.tangent.allFinite()))
            ++wrong;
        if (wrong > 0) UNSCOPED_INFO("state " << tried << ": " << e.transpose());
        ++tried;
        used += admissible ? 1 : 0;
    }
    CHECK(wrong == 0);
    WARN(tried << " states, " << used << " of them admissible, seed " << seed);
    CHECK(used > 10);
}

}  // namespace ancf::test
