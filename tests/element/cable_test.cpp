// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The straight cable: its energy by definition, the plane as part of space, and refusals.

#include <ancf/element/cable/cable.hpp>

#include <element/cable_samples.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace cable_test {

using namespace ancf;
using test::cable_length;
using test::cable_material;
using test::cable_section;
using test::straight_cable;

TEMPLATE_TEST_CASE_SIG("Cable: energy equals its definition", "[element][cable]",
                       ((int Dimension), Dimension), 2, 3) {
    const CableOptions options{test::cable_rule_of(GENERATE(range(0, 5))), 1.0};
    const auto green = straight_cable<Cable<Dimension>>(options);
    const auto engineering = straight_cable<Cable<Dimension, EngineeringAxial>>(options);
    int count = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed, ++count) {
        test::Random random(seed);
        const auto e = test::random_state(green, random);
        const double by_green = test::defined_energy<Dimension>(
            e, options.rule, [](double stretch) { return 0.5 * (stretch * stretch - 1.0); });
        const double by_stretch = test::defined_energy<Dimension>(
            e, options.rule, [](double stretch) { return stretch - 1.0; });
        REQUIRE(by_green > 0.0);
        // round-off; measured 2e-15
        CHECK(std::abs(green.energy(e) / by_green - 1.0) <= 1e-13);
        CHECK(std::abs(engineering.energy(e) / by_stretch - 1.0) <= 1e-13);
    }
    CHECK(count == 100);
}

TEST_CASE("Cable: in the plane it is the spatial element", "[element][cable][plane]") {
    const auto plane = straight_cable<Cable<2>>();
    const auto space = straight_cable<Cable<3>>();
    int count = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed, ++count) {
        test::Random random(seed);
        const auto e = test::random_state(plane, random);
        Vector<double, 12> lifted = Vector<double, 12>::Zero();
        for (int a = 0; a < 4; ++a) lifted.segment<2>(3 * a) = e.segment<2>(2 * a);
        const auto flat = plane.evaluate(e);
        const auto solid = space.evaluate(lifted);
        CHECK(std::abs(flat.energy / solid.energy - 1.0) <= 1e-14);
        for (int a = 0; a < 8; ++a) {
            const int row = 3 * (a / 2) + a % 2;
            CHECK(std::abs(flat.force(a) - solid.force(row)) <= 1e-14 * flat.force.norm());
            for (int b = 0; b < 8; ++b)
                CHECK(std::abs(flat.tangent(a, b) - solid.tangent(row, 3 * (b / 2) + b % 2)) <=
                      1e-14 * flat.tangent.norm());
        }
    }
    CHECK(count == 100);
}

TEMPLATE_TEST_CASE("Cable: refuses coordinates that are no line", "[element][cable]", Cable<2>,
                   Cable<3>) {
    const auto element = straight_cable<TestType>();
    constexpr int dimension = TestType::dimension;
    test::Random random(5);
    const auto e = test::random_state(element, random, 0.2);
    CHECK(element.admissible(e));
    for (int i = 0; i < TestType::dofs; ++i) {
        for (const double value :
             {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            auto broken = e;
            broken(i) = value;
            CHECK_FALSE(element.admissible(broken));
        }
    }
    for (const int slope : {dimension, 3 * dimension}) {
        auto broken = e;
        broken.template segment<dimension>(slope).setZero();
        CHECK_FALSE(element.admissible(broken));
    }
    // a chord that vanishes at the mid station: r' = 3/2 (r_j - r_i)/l - (g_i + g_j)/4
    auto folded = test::reference_coordinates(element);
    folded(2 * dimension) = cable_length / 3.0;
    CHECK_FALSE(element.admissible(folded));
    // on, back and on again: unit tangents at all axial stations and nothing bent
    folded(2 * dimension) = -cable_length / 3.0;
    CHECK(element.energy(folded) <= 1e-28 * element.energy((1.1 * e).eval()));
    CHECK_FALSE(element.admissible(folded));
}

TEST_CASE("Cable: refuses what is no cable and says what it got", "[element][cable][errors]") {
    const Material material = cable_material();
    const Section section = cable_section();
    const auto make = [&](double length, const CableOptions& options = {}) {
        return Cable<3>(material, section, length, options);
    };
    for (const double length : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity()})
        CHECK_THROWS_WITH(make(length), ContainsSubstring("length must be positive"));
    for (const double compression : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()})
        CHECK_THROWS_WITH(make(1.0, {cable_rule(), compression}),
                          ContainsSubstring("compression must lie in [0, 1]"));
    CHECK_THROWS_WITH(make(1.0, {Rule::gauss(2), 1.0}),
                      ContainsSubstring("at least 3") && ContainsSubstring("got 2"));
    const Quadrature one = gauss_quadrature(1), three = lobatto_quadrature(3);
    CHECK_THROWS_WITH(make(1.0, {Rule::grouped("thin", three, one, one, one), 1.0}),
                      ContainsSubstring("thin") && ContainsSubstring("bending"));
    Material broken = material;
    broken.young = -1.0;
    CHECK_THROWS_WITH(Cable<2>(broken, section, 1.0), ContainsSubstring("young"));
    // in space no direction is left to tell the stiff axis from the weak one
    CHECK_THROWS_WITH(Cable<3>(material, rectangle(0.1, 0.2), 1.0),
                      ContainsSubstring("bends equally"));
    CHECK_NOTHROW(Cable<2>(material, rectangle(0.1, 0.2), 1.0));
    CHECK_NOTHROW(Cable<3>(material, rectangle(0.1, 0.1), 1.0));
    CHECK_THROWS_WITH(Cable<2>(material, offset(section, 0.01, 0.0), 1.0),
                      ContainsSubstring("centroid"));
    CHECK_THROWS_WITH(Cable<3>(material, offset(section, 0.0, 0.01), 1.0),
                      ContainsSubstring("centroid"));

    Cable<2>::Coordinates curve = test::Helix{1.0, 0.0}.coordinates<2>(0.0, 0.7);
    CHECK_NOTHROW(Cable<2>(material, section, curve, 0.7));
    curve.segment<2>(2).setZero();
    CHECK_THROWS_WITH(Cable<2>(material, section, curve, 0.7), ContainsSubstring("slope"));
    curve(0) = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(Cable<2>(material, section, curve, 0.7), ContainsSubstring("finite"));
}

}  // namespace cable_test
