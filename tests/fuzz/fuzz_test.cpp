// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Random coordinates for every element: huge, tiny, not finite, coincident nodes, parallel slopes.
///
/// What must hold whatever they are: the call returns, and where the coordinates are admissible and
/// of a size that cannot overflow, energy, force and tangent are finite and the energy is not
/// negative. Coordinates that are not finite are never admissible.
///
/// ANCF_FUZZ_SECONDS sets the time, ANCF_FUZZ_SEED the seed; one second and seed 1 without them.

#include <ancf/element/cable.hpp>
#include <ancf/element/continuum_beam.hpp>
#include <ancf/element/cross_section_beam.hpp>
#include <ancf/element/planar_beam.hpp>
#include <ancf/element/torsion_beam.hpp>
#include <ancf/section/section.hpp>

#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

namespace {

double setting(const char* name, double otherwise) {
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : std::strtod(text, nullptr);
}

/// Returns a number of a random kind; `tame` keeps it of a size whose powers do not overflow.
double number(ancf::test::Random& random, bool tame) {
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
typename Element::Coordinates coordinates(ancf::test::Random& random, bool tame) {
    constexpr int dimension = Element::dimension, half = Element::dofs / 2;
    typename Element::Coordinates e = Element::Coordinates::Zero();
    for (int node = 0; node < 2; ++node) {
        for (int k = 1; k < half / dimension; ++k) e[node * half + dimension * k + k - 1] = 1.0;
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

/// Returns how many states were tried.
template <class Element>
long try_out(const Element& element, std::uint64_t seed, double seconds) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    ancf::test::Random random(seed);
    long tried = 0, wrong = 0;
    while (Clock::now() < end && wrong == 0) {
        const bool tame = random.uniform(0.0, 1.0) < 0.5;
        const auto e = coordinates<Element>(random, tame);
        const auto result = element.evaluate(e);
        const auto force = element.force(e);
        const double energy = element.energy(e);
        const bool admissible = element.admissible(e);
        if (admissible && !e.allFinite()) ++wrong;
        if (admissible && e.template lpNorm<Eigen::Infinity>() < 1e3 &&
            !(std::isfinite(energy) && energy >= 0.0 && std::isfinite(result.energy) &&
              force.allFinite() && result.force.allFinite() && result.tangent.allFinite()))
            ++wrong;
        if (wrong > 0) UNSCOPED_INFO("state " << tried << ": " << e.transpose());
        ++tried;
    }
    CHECK(wrong == 0);
    return tried;
}

}  // namespace

TEST_CASE("fuzz: no coordinates crash an element, and admissible ones give finite results",
          "[fuzz]") {
    const double seconds = setting("ANCF_FUZZ_SECONDS", 1.0) / 7.0;
    const auto seed = static_cast<std::uint64_t>(setting("ANCF_FUZZ_SEED", 1.0));
    const auto steel = ancf::Material::isotropic(2e11, 0.3, 7850.0);
    const auto section = ancf::rectangle(0.01, 0.02);
    long tried = 0;
    tried += try_out(ancf::CrossSectionBeam<3>(steel, section, 1.0), seed, seconds);
    tried += try_out(ancf::CrossSectionBeam<2>(steel, section, 1.0), seed, seconds);
    tried += try_out(ancf::ContinuumBeam<3>(steel, section, 1.0), seed, seconds);
    tried += try_out(ancf::ContinuumBeam<2>(steel, section, 1.0), seed, seconds);
    tried += try_out(ancf::Cable<3>(steel, section, 1.0), seed, seconds);
    tried += try_out(ancf::Cable<2>(steel, section, 1.0), seed, seconds);
    tried += try_out(ancf::TorsionBeam(steel, section, 1.0), seed, seconds);
    WARN(tried << " states, seed " << seed);
    CHECK(tried > 100);
}
