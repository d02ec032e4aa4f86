// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The planar beams with a quintic centre line: properties of every element, derivatives, results,
/// what they refuse, and the cubic beam within them.

#include <ancf/element/hermite.hpp>
#include <ancf/element/planar/beam.hpp>

#include <element/property_checks.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <type_traits>

namespace planar_quintic_test {

using namespace ancf;
using Quintic = PlanarQuinticBeam<>;
using Engineering = PlanarQuinticBeam<EngineeringMeasure>;
using WithLinearShear = CrossSectionBeam<2, Projected, LinearShear, GreenMeasure, QuinticLine>;
using Cubic = CrossSectionBeam<2>;

constexpr double length = 0.7, density = 7800.0;

Section odd_section() { return offset(rectangle(0.1, 0.2), 0.02, 0.0); }

template <class Element>
typename Element::Options options(TransverseStrain transverse, const Rule& rule) {
    typename Element::Options result;
    result.rule = rule;
    result.transverse = transverse;
    return result;
}

template <class Element>
Element sample(TransverseStrain transverse = TransverseStrain::green,
               const Rule& rule = Rule::quintic()) {
    return Element(Material::isotropic(2e7, 0.3, density), odd_section(), length,
                   options<Element>(transverse, rule));
}

/// Returns a state whose shear's sine is below 1 all along, which engineering strains need.
template <class Element>
typename Element::Coordinates mild_state(const Element& element, std::uint64_t seed) {
    test::Random random(seed);
    return test::random_state(element, random, 0.15);
}

TEMPLATE_TEST_CASE("planar quintic beam: it has the properties of every element",
                   "[element][planar][quintic]", Quintic, Engineering, WithLinearShear) {
    for (const auto transverse : {TransverseStrain::green, TransverseStrain::stretch}) {
        for (const Rule& rule : {Rule::quintic(), Rule::gauss(5)}) {
            INFO("rule " << rule.name());
            const auto element = sample<TestType>(transverse, rule);
            test::check_zero_at_rest(element);
            test::check_rigid_invariance(element, 0.15);
            test::check_rigid_invariance(element, 1e-3);
            test::check_derivatives(element, 0.15);
            test::check_zero_modes(element);
            test::check_turning(element);
            test::check_mass(element, density, odd_section().moments());
            test::check_gravity(element, density, odd_section().moments());
            const bool softens = !std::is_same_v<TestType, Engineering>;
            test::check_softened(element, test::reference_coordinates(element), softens);
        }
    }
}

TEST_CASE("planar quintic beam: derivatives hold for curved references as well",
          "[element][planar][quintic]") {
    for (const auto transverse : {TransverseStrain::green, TransverseStrain::stretch}) {
        Quintic::Coordinates bent;
        bent << 0, 0, 1, 0.1, -0.1, 1, -0.4, 0.02, 0.03, 0.5, 0.69, 0.1, 0.9, 0.3, -0.3, 0.95, -0.5,
            -0.1, -0.05, 0.4;
        const Quintic element(Material::isotropic(2e7, 0.3, density), odd_section(), bent, length,
                              options<Quintic>(transverse, Rule::quintic()));
        CHECK(element.energy(bent) <= 1e-20);
        test::check_derivatives(element, 0.15);
        // strains, e_yy among them, are counted from that state
        for (const double xi : {0.0, 0.4, 1.0}) {
            CHECK(element.strains(bent, xi).norm() == 0.0);
            CHECK(element.green_strain(bent, xi, 0.05).norm() <= 1e-16);
        }
    }
}

TEMPLATE_TEST_CASE("planar quintic beam: mixed tangents equal plain ones where no step led there",
                   "[element][planar][quintic]", Quintic, Engineering, WithLinearShear) {
    for (const auto transverse : {TransverseStrain::green, TransverseStrain::stretch}) {
        const auto element = sample<TestType>(transverse);
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const auto e = mild_state(element, seed);
            const typename TestType::Coordinates none = TestType::Coordinates::Zero();
            const auto plain = element.evaluate(e), mixed = element.evaluate(e, e, none);
            CHECK(test::relative_error(mixed.force, plain.force) <= 1e-14);
            CHECK(test::relative_error(mixed.tangent, plain.tangent) <= 1e-13);
        }
    }
}

TEST_CASE("planar quintic beam: with lines and shears of the cubic beam it is the cubic beam",
          "[element][planar][quintic]") {
    const auto element = sample<Quintic>(TransverseStrain::stretch, Rule::gauss(5));
    const Cubic cubic(Material::isotropic(2e7, 0.3, density), odd_section(), length,
                      {Rule::gauss(5), TransverseStrain::stretch, SectionModel::paper,
                       RotaryInertia::consistent, false});
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        INFO("seed " << seed);
        const Cubic::Coordinates e = mild_state(cubic, seed);
        const auto sine = [&](int node) {
            const Vector<double, 2> g = e.segment<2>(6 * node + 2), a = e.segment<2>(6 * node + 4);
            return g.dot(a) / (g.norm() * a.norm());
        };
        const double rate = (sine(1) - sine(0)) / length;
        const double stretch = (e.segment<2>(10).norm() - e.segment<2>(4).norm()) / length;
        Quintic::Coordinates q;
        for (int node = 0; node < 2; ++node) {
            const Vector<double, 2> g = e.segment<2>(6 * node + 2), a = e.segment<2>(6 * node + 4);
            const auto second = hermite_second(static_cast<double>(node), length);
            const Vector<double, 2> k = second[0] * e.segment<2>(0) + second[1] * e.segment<2>(2) +
                                        second[2] * e.segment<2>(6) + second[3] * e.segment<2>(8);
            // r_y turns with r_x but for the rate of the shear's angle, and its length is linear
            const double s = sine(node), turn = (g[0] * k[1] - g[1] * k[0]) / g.squaredNorm();
            const double spin = turn - rate / std::sqrt(1.0 - s * s);
            q.segment<6>(10 * node) = e.segment<6>(6 * node);
            q.segment<2>(10 * node + 6) =
                Vector<double, 2>(-spin * a[1], spin * a[0]) + stretch / a.norm() * a;
            q.segment<2>(10 * node + 8) = k;
        }
        CHECK(element.energy(q) == Approx(cubic.energy(e)).epsilon(1e-12));
        for (const double xi : {0.1, 0.5, 0.8}) {
            CHECK((element.position(q, xi, 0.02) - cubic.position(e, xi, 0.02)).norm() <= 1e-13);
            CHECK((element.strains(q, xi) - cubic.strains(e, xi)).norm() <= 1e-11);
            CHECK((element.green_strain(q, xi, 0.03) - cubic.green_strain(e, xi, 0.03)).norm() <=
                  1e-12);
            const auto own = element.section_forces(q, xi), other = cubic.section_forces(e, xi);
            CHECK(own.axial == Approx(other.axial).epsilon(1e-10));
            CHECK(own.shear_y == Approx(other.shear_y).epsilon(1e-10));
            CHECK(own.moment_z == Approx(other.moment_z).epsilon(1e-10));
        }
    }
}

TEMPLATE_TEST_CASE("planar quintic beam: the Jacobian of positions is their derivative",
                   "[element][planar][quintic]", Quintic, Engineering, WithLinearShear) {
    const auto element = sample<TestType>();
    double worst = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const auto e = mild_state(element, seed);
        for (const double xi : {0.0, 0.3, 1.0}) {
            const auto jacobian = element.position_jacobian(e, xi, 0.04);
            Matrix<double, 2, TestType::dofs> differences;
            constexpr double step = 1e-6;
            for (int k = 0; k < TestType::dofs; ++k) {
                auto above = e, below = e;
                above[k] += step;
                below[k] -= step;
                differences.col(k) =
                    (element.position(above, xi, 0.04) - element.position(below, xi, 0.04)) /
                    (2.0 * step);
            }
            worst = std::max(worst, (jacobian - differences).norm());
        }
    }
    CHECK(worst <= 1e-9);  // of central differences
}

TEST_CASE("planar quintic beam: a pack evaluates every state as alone",
          "[element][planar][quintic]") {
    const auto element = sample<Quintic>();
    constexpr int lanes = 4, dofs = Quintic::dofs;
    Vector<Pack<lanes>, dofs> packed;
    Vector<double, dofs> states[lanes];
    for (int lane = 0; lane < lanes; ++lane) {
        states[lane] = mild_state(element, static_cast<std::uint64_t>(lane));
        for (int i = 0; i < dofs; ++i) packed[i].set(lane, states[lane][i]);
    }
    const auto together = element.evaluate(packed);
    for (int lane = 0; lane < lanes; ++lane) {
        const auto alone = element.evaluate(states[lane]);
        Vector<double, dofs> force;
        Matrix<double, dofs> tangent;
        for (int i = 0; i < dofs; ++i) {
            force[i] = together.force[i][lane];
            for (int j = 0; j < dofs; ++j) tangent(i, j) = together.tangent(i, j)[lane];
        }
        CHECK(test::relative_error(force, alone.force) <= 1e-13);
        CHECK(test::relative_error(tangent, alone.tangent) <= 1e-13);
    }
}

TEST_CASE("planar quintic beam: what leaves it a mechanism or without strains is refused",
          "[element][planar][quintic][bad-input]") {
    const auto with = [](const Rule& rule) {
        return sample<Quintic>(TransverseStrain::green, rule);
    };
    CHECK_THROWS_WITH(with(Rule::paper()),
                      ContainsSubstring("axial") && ContainsSubstring("5 points"));
    const auto rule = [](int bending, int shear) {
        return Rule::grouped("own", gauss_quadrature(5), gauss_quadrature(bending),
                             gauss_quadrature(shear), gauss_quadrature(4));
    };
    CHECK_THROWS_WITH(with(rule(3, 4)), ContainsSubstring("bending"));
    CHECK_THROWS_WITH(with(rule(4, 3)), ContainsSubstring("shear"));
    CHECK_NOTHROW(sample<WithLinearShear>(TransverseStrain::green, rule(4, 3)));

    PlanarQuinticOptions lumped;
    lumped.rotary_inertia = RotaryInertia::lumped;
    CHECK_THROWS_WITH(
        Quintic(Material::isotropic(2e7, 0.3, density), odd_section(), length, lumped),
        ContainsSubstring("consistent"));

    const auto element = sample<Quintic>();
    test::check_admissible(element);
    auto folded = test::reference_coordinates(element);
    folded[8] = 60.0, folded[18] = -60.0;  // the line turns back between its nodes
    CHECK_FALSE(element.admissible(folded));
    auto sheared = test::reference_coordinates(element);
    CHECK(element.admissible(sheared));
    sheared[6] = 12.0, sheared[16] = -12.0;  // the sine of the shear exceeds 1
    CHECK_FALSE(element.admissible(sheared));
}

}  // namespace planar_quintic_test
