// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The continuum beam's energy against its definition, in space and in the plane; what it refuses.

#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/pack.hpp>

#include <element/continuum_beam_reference.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

namespace continuum_beam_test {

using namespace ancf;
using test::Brick;

constexpr ContinuumMaterial all_laws[] = {ContinuumMaterial::diagonal, ContinuumMaterial::hooke,
                                          ContinuumMaterial::enhanced};

template <int Dimension>
ContinuumBeam<Dimension> sample(ContinuumMaterial law, const Rule& rule = Rule::paper()) {
    const Section section =
        offset(rectangle(0.1, 0.2).with_shear_correction(0.8, 0.9), 0.02, -0.03);
    return {Material::isotropic(2e7, 0.3, 7800.0), section, 0.7, {rule, law}};
}

TEST_CASE("ContinuumBeam: energy equals the volume integral of its definition",
          "[element][continuum]") {
    const auto law = GENERATE(from_range(std::begin(all_laws), std::end(all_laws)));
    const bool centred = GENERATE(true, false);
    INFO(to_string(law) << (centred ? ", centred" : ", off the axis"));
    const Brick brick = centred ? test::centred_brick(law) : test::odd_brick(law);
    const auto element = test::element_of(brick);
    int states = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed, ++states) {
        test::Random random(seed);
        const auto e = test::random_state(element, random);
        const double expected = test::brick_energy(brick, e);
        REQUIRE(expected > 0.0);
        CHECK(std::abs(element.energy(e) / expected - 1.0) <= 1e-12);  // round-off; measured 2e-15
    }
    CHECK(states == 100);
}

TEST_CASE(
    "ContinuumBeam: in the plane the diagonal law is the spatial element with r_z held at e_z",
    "[element][continuum][plane]") {
    const Material material = Material::isotropic(2e7, 0.3, 7800.0);
    const Section section = offset(rectangle(0.1, 0.2), 0.02, 0.0);
    const ContinuumBeam<2> plane(material, section, 0.7);
    const ContinuumBeam<3> space(material, section, 0.7);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        test::Random random(seed);
        const Vector<double, 12> e = test::random_state(plane, random);
        Vector<double, 24> lifted = Vector<double, 24>::Zero();
        for (int vector = 0; vector < 6; ++vector)
            lifted.segment<2>(12 * (vector / 3) + 3 * (vector % 3)) = e.segment<2>(2 * vector);
        lifted(11) = lifted(23) = 1.0;
        const auto flat = plane.evaluate(e);
        const auto solid = space.evaluate(lifted);
        CHECK(std::abs(flat.energy / solid.energy - 1.0) <= 1e-13);
        for (int a = 0; a < 12; ++a) {
            const int row = 12 * (a / 6) + 3 * (a / 2 % 3) + a % 2;
            CHECK(std::abs(flat.force(a) - solid.force(row)) <= 1e-13 * flat.force.norm());
            for (int b = 0; b < 12; ++b) {
                const int column = 12 * (b / 6) + 3 * (b / 2 % 3) + b % 2;
                CHECK(std::abs(flat.tangent(a, b) - solid.tangent(row, column)) <=
                      1e-13 * flat.tangent.norm());
            }
        }
    }
}

TEST_CASE("ContinuumBeam: in the plane Hooke's law is that of plane stress",
          "[element][continuum][plane]") {
    const Material material = Material::isotropic(2e7, 0.3, 7800.0);
    const Section section = rectangle(0.1, 0.2);
    const ContinuumBeam<2> plane(material, section, 0.7, {Rule::paper(), ContinuumMaterial::hooke});
    const ContinuumBeam<3> space(material, section, 0.7, {Rule::paper(), ContinuumMaterial::hooke});
    // A homogeneous stretch of axis and height; the width takes the strain that leaves S_zz = 0.
    const double e_xx = 0.1, e_yy = 0.04, e_zz = -0.3 / 0.7 * (e_xx + e_yy);
    Vector<double, 12> e = test::reference_coordinates(plane);
    Vector<double, 24> lifted = test::reference_coordinates(space);
    for (const int node : {0, 1}) {
        e.segment<4>(6 * node) *= std::sqrt(1.0 + 2.0 * e_xx);
        e.segment<2>(6 * node + 4) *= std::sqrt(1.0 + 2.0 * e_yy);
        lifted.segment<6>(12 * node) *= std::sqrt(1.0 + 2.0 * e_xx);
        lifted.segment<3>(12 * node + 6) *= std::sqrt(1.0 + 2.0 * e_yy);
        lifted.segment<3>(12 * node + 9) *= std::sqrt(1.0 + 2.0 * e_zz);
    }
    CHECK(space.stress(lifted, 0.3)(2) == Approx(0.0).margin(1e-12 * 2e7));
    CHECK(plane.energy(e) == Approx(space.energy(lifted)).epsilon(1e-13));
    CHECK(plane.stress(e, 0.3)(0) == Approx(space.stress(lifted, 0.3)(0)).epsilon(1e-13));
    CHECK(plane.stress(e, 0.3)(1) == Approx(space.stress(lifted, 0.3)(1)).epsilon(1e-13));
}

TEST_CASE("ContinuumBeam: homogeneous stretch has the exact energy of each law",
          "[element][continuum][patch]") {
    const Material material = Material::isotropic(2e7, 0.3, 7800.0);
    const Section section = rectangle(0.1, 0.2);
    const double stretch = GENERATE(0.8, 1.0, 1.3);
    const double e_xx = (stretch * stretch - 1.0) / 2.0;
    const double volume = 0.7 * 0.02;
    const double p_wave = 2e7 * 0.7 / (1.3 * 0.4);  // lambda + 2 mu
    const auto rigid = [&](ContinuumMaterial law) {
        const ContinuumBeam<3> element(material, section, 0.7, {Rule::paper(), law});
        Vector<double, 24> e = test::reference_coordinates(element);
        for (const int node : {0, 1}) e.segment<6>(12 * node) *= stretch;
        return element.energy(e);
    };
    const double margin = 1e-12 * 2e7 * volume;
    CHECK(rigid(ContinuumMaterial::diagonal) ==
          Approx(0.5 * 2e7 * e_xx * e_xx * volume).epsilon(1e-13).margin(margin));
    CHECK(rigid(ContinuumMaterial::hooke) ==
          Approx(0.5 * p_wave * e_xx * e_xx * volume).epsilon(1e-13).margin(margin));
    CHECK(rigid(ContinuumMaterial::enhanced) ==
          Approx(rigid(ContinuumMaterial::hooke)).epsilon(1e-13).margin(margin));
}

TEST_CASE(
    "ContinuumBeam: with the sides free to contract, Hooke's law stretches with Young's modulus",
    "[element][continuum][patch]") {
    const auto law = GENERATE(ContinuumMaterial::hooke, ContinuumMaterial::enhanced);
    const ContinuumBeam<3> element(Material::isotropic(2e7, 0.3, 7800.0), rectangle(0.1, 0.2), 0.7,
                                   {Rule::paper(), law});
    const double e_xx = 0.1;
    Vector<double, 24> e = test::reference_coordinates(element);
    for (const int node : {0, 1}) {
        e.segment<6>(12 * node) *= std::sqrt(1.0 + 2.0 * e_xx);
        e.segment<6>(12 * node + 6) *= std::sqrt(1.0 - 2.0 * 0.3 * e_xx);
    }
    CHECK(element.energy(e) == Approx(0.5 * 2e7 * e_xx * e_xx * 0.7 * 0.02).epsilon(1e-12));
    CHECK(element.stress(e, 0.4, 0.03, -0.02)(0) == Approx(2e7 * e_xx).epsilon(1e-12));
    CHECK(std::abs(element.stress(e, 0.4, 0.03, -0.02)(1)) <= 1e-12 * 2e7);
}

TEST_CASE("ContinuumBeam: simple shear has the exact energy", "[element][continuum][patch]") {
    const Material material = Material::from_moduli(2e7, 9e6, 7800.0);
    const Section section = rectangle(0.1, 0.2).with_shear_correction(0.8, 0.9);
    const ContinuumBeam<3> element(material, section, 0.7);
    const double volume = 0.7 * 0.02, shear = 0.2;
    const auto sheared = [&](int slope, int along) {
        Vector<double, 24> e = test::reference_coordinates(element);
        for (const int node : {0, 1}) e(12 * node + 3 * slope + along) = shear;
        return element.energy(e);
    };
    // 2 e_ij = shear; the leaning slope is longer by shear^2/2 in Green's measure.
    const double longer = 0.5 * 2e7 * std::pow(shear * shear / 2.0, 2) * volume;
    const double g = 0.5 * 9e6 * shear * shear * volume;
    CHECK(sheared(2, 0) == Approx(0.8 * g + longer).epsilon(1e-13));
    CHECK(sheared(3, 0) == Approx(0.9 * g + longer).epsilon(1e-13));
    CHECK(sheared(3, 1) == Approx(0.85 * g + longer).epsilon(1e-13));
}

TEST_CASE("ContinuumBeam: without Poisson's ratio and shear correction the three laws are one",
          "[element][continuum]") {
    const Material material = Material::isotropic(2e7, 0.0, 7800.0);
    const Section section = offset(rectangle(0.1, 0.2).with_shear_correction(1.0, 1.0), 0.01, 0.02);
    const ContinuumBeam<3> diagonal(material, section, 0.7);
    test::Random random(5);
    const Vector<double, 24> e = test::random_state(diagonal, random);
    const double expected = diagonal.energy(e);
    for (const auto law : {ContinuumMaterial::hooke, ContinuumMaterial::enhanced}) {
        const ContinuumBeam<3> element(material, section, 0.7, {Rule::paper(), law});
        CHECK(element.energy(e) == Approx(expected).epsilon(1e-13));
    }
}

TEST_CASE("ContinuumBeam: what cannot be meant is refused with its value",
          "[element][continuum][errors]") {
    const Material steel = Material::isotropic(2e11, 0.3, 7800.0);
    const Section section = rectangle(0.1, 0.2);
    const auto make = [&](const Material& material, const Section& shape, double length,
                          ContinuumMaterial law) {
        return ContinuumBeam<3>(material, shape, length, {Rule::paper(), law});
    };
    CHECK_THROWS_AS(make(steel, section, 0.0, ContinuumMaterial::diagonal), InvalidArgument);
    CHECK_THROWS_AS(
        make(steel, section, std::numeric_limits<double>::quiet_NaN(), ContinuumMaterial::diagonal),
        InvalidArgument);
    const Material stiff = Material::from_moduli(2e11, 0.5e11, 7800.0);  // nu = 1
    CHECK_NOTHROW(make(stiff, section, 1.0, ContinuumMaterial::diagonal));
    CHECK_THROWS_WITH(make(stiff, section, 1.0, ContinuumMaterial::hooke),
                      ContainsSubstring("got 1"));
    CHECK_THROWS_AS(
        make(Material::isotropic(2e11, 0.5, 7800.0), section, 1.0, ContinuumMaterial::enhanced),
        InvalidArgument);
    Moments moments;
    moments.area = 1e-2;
    moments.yy = moments.zz = 1e-5;
    const Section numbers = Section::from_moments(moments).with_shear_correction(1.0, 1.0);
    CHECK_THROWS_WITH(make(steel, numbers, 1.0, ContinuumMaterial::diagonal),
                      ContainsSubstring("fourth order"));
}

TEST_CASE("ContinuumBeam: a rule that leaves modes without energy is refused",
          "[element][continuum][errors]") {
    // r0' is quadratic, and its curvature is in no strain but the shear: two points miss a mode.
    CHECK_THROWS_WITH(sample<3>(ContinuumMaterial::diagonal, Rule::mixed()),
                      ContainsSubstring("rule \"mixed\": the shear term needs at least 3 points"));
    CHECK_THROWS_AS(sample<3>(ContinuumMaterial::diagonal, Rule::gauss(2)), InvalidArgument);
    const Quadrature three = gauss_quadrature(3);
    CHECK_THROWS_AS(sample<2>(ContinuumMaterial::diagonal,
                              Rule::grouped("thin", three, gauss_quadrature(1), three, three)),
                    InvalidArgument);
}

TEST_CASE("ContinuumBeam: a pack evaluates its lanes as doubles would", "[element][continuum]") {
    constexpr int lanes = 2;  // 16 bytes: what every target aligns
    const auto element = sample<3>(ContinuumMaterial::enhanced);
    Vector<double, 24> states[lanes];
    Vector<Pack<lanes>, 24> packed;
    for (int lane = 0; lane < lanes; ++lane) {
        test::Random random(static_cast<std::uint64_t>(lane));
        states[lane] = test::random_state(element, random);
        for (int i = 0; i < 24; ++i) packed(i).set(lane, states[lane](i));
    }
    const auto together = element.evaluate(packed);
    for (int lane = 0; lane < lanes; ++lane) {
        const auto alone = element.evaluate(states[lane]);
        double force = 0.0, tangent = 0.0;
        for (int i = 0; i < 24; ++i) {
            force = std::max(force, std::abs(together.force(i)[lane] - alone.force(i)));
            for (int j = 0; j < 24; ++j)
                tangent =
                    std::max(tangent, std::abs(together.tangent(i, j)[lane] - alone.tangent(i, j)));
        }
        CHECK(together.energy[lane] == Approx(alone.energy).epsilon(1e-14));
        CHECK(force <= 1e-14 * alone.force.norm());
        CHECK(tangent <= 1e-14 * alone.tangent.norm());
    }
}

TEST_CASE("ContinuumBeam: a section turned inside out is not admissible",
          "[element][continuum][errors]") {
    const auto element = sample<3>(ContinuumMaterial::diagonal);
    const Vector<double, 24> rest = test::reference_coordinates(element);
    CHECK(element.admissible(rest));
    Vector<double, 24> e = rest;
    e.segment<3>(21) *= -1.0;  // r_z at the far end turned over
    CHECK_FALSE(element.admissible(e));
    int admissible = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        test::Random random(seed);
        admissible += element.admissible(test::random_state(element, random, 0.2)) ? 1 : 0;
    }
    CHECK(admissible == 100);
}

}  // namespace continuum_beam_test
