// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The cross-section beam against its definition at volume points and against the tables of
/// [Dufva2006].

#include <ancf/element/cross_section/beam.hpp>

#include <element/cross_section_beam_samples.hpp>
#include <element/cross_section_reference.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/dense_chain.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

namespace cross_section_reference_test {

using namespace ancf;
using test::Paper;
using test::Pointwise;

TEMPLATE_TEST_CASE(
    "CrossSectionBeam: energy and force equal those of the volume integral of the definition",
    "[element][cross-section]", Paper, Pointwise) {
    const bool stretch = GENERATE(false, true);
    INFO((stretch ? "Eq. 25" : "Eq. 24"));
    const auto material = test::sample_material();
    const test::Bar bar{0.7,
                        0.2,
                        0.1,
                        material.young,
                        0.8 * material.shear,
                        0.9 * material.shear,
                        std::is_same_v<TestType, Pointwise>,
                        stretch};
    CrossSectionOptions options;
    if (stretch) options.transverse = TransverseStrain::stretch;
    const TestType element(material, test::sample_rectangle(), bar.length, options);
    double energy = 0.0, force = 0.0;
    int states = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed, ++states) {
        test::Random random(seed);
        const auto e = test::random_state(element, random);
        const double expected = test::bar_energy(bar, e);
        REQUIRE(expected > 0.0);
        energy = std::max(energy, std::abs(element.energy(e) / expected - 1.0));
        const auto gradient =
            test::complex_step_gradient([&](const auto& z) { return test::bar_energy(bar, z); }, e);
        force = std::max(force, test::relative_error(element.force(e), gradient));
    }
    CHECK(states == 100);
    CHECK(energy <= 1e-12);  // round-off; measured 2e-15
    CHECK(force <= 1e-12);   // round-off; measured 3e-15
}

/// The material of [Dufva2006, section 5.2].
Material table_material() { return Material::from_moduli(2.07e11, 7.9615e10, 7850.0); }

struct Tip {
    double x, y;
};

/// Returns the tip of a cantilever of length 2 under a force along y.
template <class Element>
Tip tip_of(int elements, double width, double height, double force) {
    const Element element(table_material(), rectangle(width, height), 2.0 / elements);
    test::DenseChain<Element> chain(element, elements);
    const int iterations = chain.solve({0.0, force, 0.0});
    INFO(elements << " elements, " << iterations << " iterations");
    REQUIRE(iterations > 0);
    CHECK(std::abs(chain.tip()(2)) <= 1e-12);
    return {chain.tip()(0), chain.tip()(1)};
}

/// Load of Model II: 1.5 E I/L^2.
double model_two_load() { return 1.5 * 2.07e11 * 1e-8 / 12.0 / 4.0; }

TEST_CASE("CrossSectionBeam: tip positions of Table 1 with linear shear",
          "[element][cross-section]") {
    const Tip one = tip_of<Paper>(1, 0.01, 0.01, model_two_load());
    CHECK(std::abs(one.x - 1.8548) <= 5e-5);  // half of the last digit printed
    CHECK(std::abs(one.y - 0.6444) <= 5e-5);
    const Tip two = tip_of<Paper>(2, 0.01, 0.01, model_two_load());
    CHECK(std::abs(two.x - 1.8008) <= 5e-5);
    CHECK(std::abs(two.y - 0.7815) <= 5e-5);
    const Tip four = tip_of<Paper>(4, 0.01, 0.01, model_two_load());
    CHECK(std::abs(four.x - 1.7872) <= 5e-5);
    CHECK(std::abs(four.y - 0.8139) <= 5e-5);
}

TEST_CASE("CrossSectionBeam: tip positions of Table 1 with pointwise shear",
          "[element][cross-section]") {
    const Tip one = tip_of<Pointwise>(1, 0.01, 0.01, model_two_load());
    CHECK(std::abs(one.x - 1.9520) <= 5e-5);
    CHECK(std::abs(one.y - 0.3758) <= 5e-5);
    const Tip two = tip_of<Pointwise>(2, 0.01, 0.01, model_two_load());
    CHECK(std::abs(two.x - 1.8683) <= 5e-5);
    CHECK(std::abs(two.y - 0.6383) <= 5e-5);
}

TEST_CASE("CrossSectionBeam: tip positions of Table 3", "[element][cross-section]") {
    const Tip one = tip_of<Paper>(1, 0.1, 0.5, 2.5e6);
    CHECK(std::abs(one.x - 1.9996858) <= 5e-8);
    CHECK(std::abs(one.y - 0.0324155) <= 5e-8);
    const Tip four = tip_of<Paper>(4, 0.1, 0.5, 2.5e6);
    CHECK(std::abs(four.x - 1.9996858) <= 5e-8);
    CHECK(std::abs(four.y - 0.0324172) <= 5e-8);
    const Tip pointwise = tip_of<Pointwise>(1, 0.1, 0.5, 2.5e6);
    CHECK(std::abs(pointwise.y - 0.02469) <= 5e-6);
}

TEST_CASE("CrossSectionBeam: the mixed rule converges with fourth order in Model II",
          "[element][cross-section]") {
    // Limit of a Green-strain beam with these loads and stiffnesses, computed without finite
    // elements.
    constexpr double x = 1.784108719196, y = 0.821973318973;
    CrossSectionOptions options;
    options.rule = Rule::mixed();
    double error[4];
    for (int k = 0; k < 4; ++k) {
        const int elements = 2 << k;
        const Paper element(table_material(), rectangle(0.01, 0.01), 2.0 / elements, options);
        test::DenseChain<Paper> chain(element, elements);
        REQUIRE(chain.solve({0.0, model_two_load(), 0.0}) > 0);
        error[k] = std::hypot(chain.tip()(0) - x, chain.tip()(1) - y);
    }
    for (int k = 1; k < 4; ++k) CHECK(error[k - 1] / error[k] >= 14.0);
    // measured 2.7e-3, 1.7e-4, 1.1e-5, 6.6e-7 of the length
    const double most[] = {4e-3, 2.5e-4, 2e-5, 1.5e-6};
    for (int k = 0; k < 4; ++k) CHECK(error[k] <= most[k] * 2.0);
}

}  // namespace cross_section_reference_test
