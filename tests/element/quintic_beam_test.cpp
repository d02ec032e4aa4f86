// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The beam with a quintic centre line: interpolation, properties of every element, derivatives,
/// results.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/hermite.hpp>

#include <element/cross_section_beam_samples.hpp>
#include <element/property_checks.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>

namespace quintic_beam_test {

using namespace ancf;
using Quintic = QuinticBeam<>;
using Engineering = QuinticBeam<EngineeringMeasure>;
using Transporting = CrossSectionBeam<3, Transported, LinearShear, GreenMeasure, QuinticLine>;

template <class Element>
Element quintic_of(const test::Variant& variant, const Rule& rule = Rule::quintic()) {
    typename Element::Options options;
    options.rule = rule;
    options.transverse = variant.transverse;
    options.section_model = variant.model;
    return Element(test::sample_material(), test::section_of(variant), 0.7, options);
}

test::Variant any_variant() {
    return GENERATE(from_range(std::begin(test::variants), std::end(test::variants)));
}

TEST_CASE("QuinticLine: the curve of a polynomial of degree five is that polynomial",
          "[element][quintic]") {
    constexpr double l = 1.7;
    for (int degree = 0; degree <= 5; ++degree) {
        const auto power = [&](double x, int derivative) {
            double factor = 1.0;
            for (int k = 0; k < derivative; ++k) factor *= degree - k;
            return factor == 0.0 ? 0.0 : factor * std::pow(x, degree - derivative);
        };
        const double nodal[] = {power(l, 0) - power(0.0, 0), power(0.0, 1), power(l, 1),
                                power(0.0, 2), power(l, 2)};
        const auto sum = [&](const QuinticLine::Weights& weights) {
            double result = 0.0;
            for (std::size_t k = 0; k < weights.size(); ++k) result += weights[k] * nodal[k];
            return result;
        };
        for (const double xi : {0.0, 0.2, 0.5, 0.83, 1.0}) {
            INFO("degree " << degree << ", xi " << xi);
            CHECK(std::abs(power(0.0, 0) + sum(QuinticLine::value(xi, l)) - power(xi * l, 0)) <=
                  1e-13);
            CHECK(std::abs(sum(QuinticLine::first(xi, l)) - power(xi * l, 1)) <= 1e-13);
            CHECK(std::abs(sum(QuinticLine::second(xi, l)) - power(xi * l, 2)) <= 1e-12);
        }
    }
}

TEMPLATE_TEST_CASE("QuinticBeam: energy and force vanish at rest, and no motion changes the energy",
                   "[element][quintic]", Quintic, Engineering, Transporting) {
    const auto variant = any_variant();
    INFO(variant.name);
    const auto element = quintic_of<TestType>(variant);
    test::check_zero_at_rest(element);
    test::check_rigid_invariance(element);
    test::check_rigid_invariance(element, 1e-3);
    test::check_turning(element);
    const bool softens = !std::is_same_v<TestType, Engineering>;
    test::check_softened(element, test::reference_coordinates(element), softens);
}

TEMPLATE_TEST_CASE("QuinticBeam: force and tangent equal the complex-step derivatives",
                   "[element][quintic][tangent]", Quintic, Engineering, Transporting) {
    const auto variant = any_variant();
    INFO(variant.name);
    test::check_derivatives(quintic_of<TestType>(variant));
}

TEST_CASE("QuinticBeam: a stress-free element has exactly six zero modes", "[element][quintic]") {
    const auto variant = any_variant();
    INFO(variant.name);
    test::check_zero_modes(quintic_of<Quintic>(variant));
    test::check_zero_modes(quintic_of<Quintic>(variant, Rule::gauss(5)));
}

TEST_CASE("QuinticBeam: rules of too few points are refused", "[element][quintic]") {
    const auto& variant = test::variants[0];
    CHECK_THROWS_WITH(quintic_of<Quintic>(variant, Rule::paper()),
                      ContainsSubstring("axial") && ContainsSubstring("5 points"));
    const Rule thin = Rule::grouped("thin", gauss_quadrature(5), gauss_quadrature(3),
                                    gauss_quadrature(3), gauss_quadrature(3));
    CHECK_THROWS_WITH(quintic_of<Quintic>(variant, thin),
                      ContainsSubstring("bending") && ContainsSubstring("4 points"));
}

TEST_CASE("QuinticBeam: mass and gravity are those of the body", "[element][quintic]") {
    const auto variant = any_variant();
    INFO(variant.name);
    const auto element = quintic_of<Quintic>(variant);
    const double density = test::sample_material().density;
    test::check_mass(element, density, test::section_of(variant).moments());
    test::check_gravity(element, density, test::section_of(variant).moments());
}

TEST_CASE("QuinticBeam: states without strains are refused", "[element][quintic]") {
    const auto element = quintic_of<Quintic>(test::variants[0]);
    test::check_admissible(element);
    // a curvature that folds the centre line back between its nodes
    auto folded = test::reference_coordinates(element);
    folded[12] = 60.0;
    folded[27] = -60.0;
    CHECK_FALSE(element.admissible(folded));
}

TEST_CASE("QuinticBeam: with the curvature of a cubic it is the beam of the cubic",
          "[element][quintic]") {
    const auto& variant = test::variants[0];
    const auto element = quintic_of<Quintic>(variant, Rule::gauss(5));
    CrossSectionOptions options;
    options.rule = Rule::gauss(5);
    const CrossSectionBeam<3, Geodesic> cubic(test::sample_material(), test::section_of(variant),
                                              0.7, options);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        test::Random random(seed);
        const auto e = test::random_state(cubic, random);
        Vector<double, 30> q;
        for (int node = 0; node < 2; ++node) {
            q.segment<12>(15 * node) = e.segment<12>(12 * node);
            const auto second = hermite_second(static_cast<double>(node), 0.7);
            q.segment<3>(15 * node + 12) =
                second[0] * e.segment<3>(0) + second[1] * e.segment<3>(3) +
                second[2] * e.segment<3>(12) + second[3] * e.segment<3>(15);
        }
        CHECK(element.energy(q) == Approx(cubic.energy(e)).epsilon(1e-12));
        for (const double xi : {0.1, 0.5, 0.8}) {
            CHECK((element.position(q, xi, 0.02, -0.03) - cubic.position(e, xi, 0.02, -0.03))
                      .norm() <= 1e-13);
            CHECK((element.strains(q, xi) - cubic.strains(e, xi)).norm() <= 1e-11);
        }
    }
}

TEST_CASE("QuinticBeam: Jacobians of position and directors equal the complex-step derivatives",
          "[element][quintic]") {
    const auto element = quintic_of<Quintic>(test::variants[0]);
    double position = 0.0, directors = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        test::Random random(seed);
        const auto e = test::random_state(element, random);
        for (const double xi : {0.0, 0.3, 1.0}) {
            const auto jacobian = test::complex_step_jacobian(
                [&](const auto& c) { return element.position(c, xi, 0.04, -0.02); }, e);
            position = std::max(
                position,
                test::relative_error(element.position_jacobian(e, xi, 0.04, -0.02), jacobian));
            const auto turning = test::complex_step_jacobian(
                [&](const auto& c) {
                    const auto d = element.directors(c, xi);
                    Vector<std::complex<double>, 6> column;
                    column << d.col(0), d.col(1);
                    return column;
                },
                e);
            const auto axis = element.position_jacobian(e, xi);
            Matrix<double, 6, 30> by_directors;  // a point at a distance of 1, less the axis
            by_directors << element.position_jacobian(e, xi, 1.0, 0.0) - axis,
                element.position_jacobian(e, xi, 0.0, 1.0) - axis;
            directors = std::max(directors, test::relative_error(by_directors, turning));
        }
    }
    CHECK(position <= 1e-13);
    CHECK(directors <= 1e-13);
}

TEST_CASE("QuinticBeam: a pack evaluates every state as alone", "[element][quintic]") {
    const auto element = quintic_of<Quintic>(test::variants[1]);
    constexpr int lanes = 4;
    Vector<Pack<lanes>, 30> packed;
    Vector<double, 30> states[lanes];
    for (int lane = 0; lane < lanes; ++lane) {
        test::Random random(static_cast<std::uint64_t>(lane));
        states[lane] = test::random_state(element, random);
        for (int i = 0; i < 30; ++i) packed[i].set(lane, states[lane][i]);
    }
    const auto together = element.evaluate(packed);
    for (int lane = 0; lane < lanes; ++lane) {
        const auto alone = element.evaluate(states[lane]);
        Vector<double, 30> force;
        Matrix<double, 30> tangent;
        for (int i = 0; i < 30; ++i) {
            force[i] = together.force[i][lane];
            for (int j = 0; j < 30; ++j) tangent(i, j) = together.tangent(i, j)[lane];
        }
        CHECK(test::relative_error(force, alone.force) <= 1e-13);
        CHECK(test::relative_error(tangent, alone.tangent) <= 1e-13);
        CHECK(together.energy[lane] == Approx(alone.energy).epsilon(1e-13));
    }
}

}  // namespace quintic_beam_test
