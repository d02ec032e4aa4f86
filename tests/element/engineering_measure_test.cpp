// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The cross-section beam with engineering strains: derivatives, invariance, equality of plane and
/// space, results.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>

#include <element/cross_section_beam_samples.hpp>
#include <element/property_checks.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/random_state.hpp>

#include <cstdint>
#include <type_traits>

namespace engineering_measure_test {

using namespace ancf;

using Projecting = CrossSectionBeam<3, Projected, LinearShear, EngineeringMeasure>;
using Carrying = CrossSectionBeam<3, Geodesic, LinearShear, EngineeringMeasure>;
using Flat = CrossSectionBeam<2, Projected, LinearShear, EngineeringMeasure>;

template <class Element>
Element sample(const char* rule, const Section& section) {
    CrossSectionOptions options;
    options.rule = Rule::named(rule);
    return {test::sample_material(), section, 0.7, options};
}

TEMPLATE_TEST_CASE("engineering measure: the element has the properties of every element",
                   "[element][measure]", Projecting, Carrying, Flat) {
    for (const char* rule : {"paper", "mixed"}) {
        INFO(rule);
        const Section section = std::is_same_v<TestType, Flat>
                                    ? offset(test::sample_rectangle(), 0.02, 0.0)
                                    : test::sample_odd_section();
        const auto element = sample<TestType>(rule, section);
        test::check_zero_at_rest(element);
        test::check_rigid_invariance(element);
        test::check_derivatives(element);
        test::check_zero_modes(element);
        test::check_turning(element);
        test::check_softened(element, test::reference_coordinates(element), false);
    }
}

TEST_CASE("engineering measure: the plane's element is that of space", "[element][measure]") {
    constexpr int place[12] = {0, 1, 3, 4, 6, 7, 12, 13, 15, 16, 18, 19};
    const auto flat = sample<Flat>("mixed", test::sample_rectangle());
    const auto spatial = sample<Projecting>("mixed", test::sample_rectangle());
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        test::Random random(seed);
        Flat::Coordinates e;
        e << 0, 0, 1, 0, 0, 1, 0.7, 0, 1, 0, 0, 1;
        for (double& value : e) value += random.uniform(-0.2, 0.2);
        Projecting::Coordinates lifted = Projecting::Coordinates::Zero();
        for (int k = 0; k < 12; ++k) lifted[place[k]] = e[k];
        lifted[11] = lifted[23] = 1.0;
        const auto in_plane = flat.evaluate(e);
        const auto in_space = spatial.evaluate(lifted);
        CHECK(in_plane.energy == Approx(in_space.energy).epsilon(1e-12));
        for (int i = 0; i < 12; ++i) {
            CHECK(std::abs(in_plane.force[i] - in_space.force[place[i]]) <=
                  1e-12 * in_plane.force.norm());
            for (int j = 0; j < 12; ++j)
                CHECK(std::abs(in_plane.tangent(i, j) - in_space.tangent(place[i], place[j])) <=
                      1e-12 * in_plane.tangent.norm());
        }
        for (const double xi : {0.2, 0.9}) {
            const auto a = flat.section_forces(e, xi);
            const auto b = spatial.section_forces(lifted, xi);
            CHECK(a.axial == Approx(b.axial).epsilon(1e-10));
            CHECK(a.shear_y == Approx(b.shear_y).epsilon(1e-10));
            CHECK(a.moment_z == Approx(b.moment_z).epsilon(1e-10));
        }
    }
}

TEMPLATE_TEST_CASE("engineering measure: directors are unit vectors, positions have their Jacobian",
                   "[element][measure]", Projecting, Carrying) {
    const auto element = sample<TestType>("paper", test::sample_rectangle());
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        test::Random random(seed);
        const auto e = test::random_state(element, random);
        const auto directors = element.directors(e, 0.3);
        CHECK(directors.col(0).norm() == Approx(1.0).epsilon(1e-14));
        CHECK(directors.col(1).norm() == Approx(1.0).epsilon(1e-14));
        const Matrix<double, 3, 24> expected = test::complex_step_jacobian(
            [&](const auto& z) { return element.position(z, 0.3, 0.04, -0.07); }, e);
        CHECK(test::relative_error(element.position_jacobian(e, 0.3, 0.04, -0.07), expected) <=
              1e-13);
    }
}

TEST_CASE("engineering measure: a stretched bar pulls with E A times its elongation",
          "[element][measure]") {
    const auto element = sample<Projecting>("mixed", rectangle(0.1, 0.2));
    auto e = test::reference_coordinates(element);
    const double stretch = 1.3;
    e[12] = 0.7 * stretch;
    e[3] = e[15] = stretch;
    const double stiffness = test::sample_material().young * 0.02;
    CHECK(element.force(e)[12] == Approx(0.3 * stiffness).epsilon(1e-13));
    CHECK(element.section_forces(e, 0.4).axial == Approx(0.3 * stiffness).epsilon(1e-13));
}

}  // namespace engineering_measure_test
