// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Packs of doubles, and elements evaluated side by side.

#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/pack.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/torsion/beam.hpp>

#include <element/cross_section_beam_samples.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace pack_test {

using namespace ancf;
using test::Carried;
using test::Paper;
using test::Transporting;

TEMPLATE_TEST_CASE_SIG("Pack: arithmetic acts lane by lane", "[element][pack]",
                       ((int Lanes), Lanes), 1, 2, 4, 8) {
    Pack<Lanes> a(3.0), b(-0.5);
    for (int k = 0; k < Lanes; ++k) {
        CHECK(a[k] == 3.0);
        a.set(k, 1.5 + k);
        b.set(k, 0.25 - 2.0 * k);
    }
    const Pack<Lanes> sum = a + b, difference = a - b, product = a * b, quotient = a / b;
    const Pack<Lanes> root = sqrt(a), negative = -a, mixed = 2.0 * a - 1.0;
    Pack<Lanes> chain = a;
    chain += b;
    chain *= a;
    chain -= b;
    chain /= a;
    double total = 0.0;
    for (int k = 0; k < Lanes; ++k) {
        const double x = 1.5 + k, y = 0.25 - 2.0 * k;
        CHECK(sum[k] == x + y);
        CHECK(difference[k] == x - y);
        CHECK(product[k] == x * y);
        CHECK(quotient[k] == x / y);
        CHECK(root[k] == std::sqrt(x));
        CHECK(negative[k] == -x);
        CHECK(mixed[k] == 2.0 * x - 1.0);
        CHECK(chain[k] == Approx(((x + y) * x - y) / x).epsilon(1e-15));
        CHECK(cos(a)[k] == std::cos(x));
        CHECK(sin(a)[k] == std::sin(x));
        CHECK(atan(a)[k] == std::atan(x));
        total += x;
    }
    CHECK(lane_sum(a) == total);
}

/// Returns the largest difference between the lanes of a pack's evaluation and single evaluations,
/// relative.
template <int Lanes, class Element, class Packed>
double difference(const std::array<const Element*, Lanes>& elements, const Packed& packed) {
    double worst = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        test::Random random(seed);
        constexpr int dofs = Element::dofs;
        Vector<Pack<Lanes>, dofs> e;
        std::array<Evaluation<double, dofs>, Lanes> expected;
        std::array<Vector<double, dofs>, Lanes> force;
        std::array<double, Lanes> energy;
        for (std::size_t k = 0; k < Lanes; ++k) {
            const auto state = test::random_state(*elements[k], random);
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

TEMPLATE_TEST_CASE(
    "CrossSectionBeam: equal elements in the lanes of a pack give what each gives alone",
    "[element][cross-section][pack]", Paper, Carried, Transporting) {
    const auto variant = GENERATE(from_range(std::begin(test::variants), std::end(test::variants)));
    INFO(variant.name);
    const auto element = test::element_of<TestType>(variant);
    CHECK(difference<4>(std::array{&element, &element, &element, &element}, element) <=
          1e-14);  // round-off
}

TEST_CASE("CrossSectionBeam: eight equal elements in a pack give what each gives alone",
          "[element][cross-section][pack]") {
    const Paper element(test::sample_material(), test::sample_rectangle(), 0.7);
    std::array<const Paper*, 8> elements{};
    elements.fill(&element);
    CHECK(difference<8>(elements, element) <= 1e-14);  // round-off
}

TEMPLATE_TEST_CASE("other beams: equal elements in the lanes of a pack give what each gives alone",
                   "[element][pack]", TorsionBeam, ContinuumBeam<3>, ContinuumBeam<2>,
                   CrossSectionBeam<2>) {
    const TestType element(test::sample_material(), test::sample_rectangle(), 0.7);
    CHECK(difference<4>(std::array{&element, &element, &element, &element}, element) <=
          1e-14);  // round-off
}

TEMPLATE_TEST_CASE(
    "CrossSectionBeam: elements of different length, section and material share a pack",
    "[element][cross-section][pack]", Paper, Carried, Transporting) {
    CrossSectionOptions options;
    options.rule = Rule::mixed();
    const TestType one(test::sample_material(), test::sample_rectangle(), 0.7, options);
    const TestType two(test::sample_material(), test::sample_odd_section(), 1.3, options);
    const TestType three(Material::from_moduli(1e9, 3e8, 100.0), test::sample_rectangle(), 0.2,
                         options);
    const std::array<const TestType*, 4> elements{&one, &two, &three, &one};
    CHECK(difference<4>(elements, TestType::template together<4>(elements)) <= 1e-14);  // round-off
}

TEST_CASE("CrossSectionBeam: elements of different rules are not put together",
          "[element][cross-section][pack]") {
    const auto one = test::element_of(test::variants[0]), two = test::element_of(test::variants[1]);
    const auto three = test::element_of(test::variants[2]);
    CHECK_THROWS_WITH(Paper::together<2>({&one, &two}), ContainsSubstring("mixed"));
    CHECK_THROWS_WITH(Paper::together<2>({&one, &three}), ContainsSubstring("transverse"));
}

}  // namespace pack_test
