// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// The mass of every element, where the section's mass is spread otherwise than its stiffness.

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/error.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/polygon.hpp>
#include <ancf/section/section.hpp>

#include <element/property_checks.hpp>
#include <support/catch.hpp>

namespace mass_test {

TEMPLATE_TEST_CASE("mass: it has the mass moments of the section and nothing else of it",
                   "[element][mass]", ancf::CrossSectionBeam<3>, ancf::CrossSectionBeam<2>,
                   ancf::ContinuumBeam<3>, ancf::Cable<3>, ancf::TorsionBeam) {
    const auto material = ancf::Material::from_moduli(2e9, 8e8, 1200.0);
    const ancf::Section plain = ancf::rectangle(0.2, 0.2);
    const ancf::Section other = ancf::tube(0.15, 0.12);
    const ancf::Section both = plain.with_mass_moments(other.moments());
    const TestType element(material, both, 0.7);
    CHECK(element.mass() == TestType(material, other, 0.7).mass());
    CHECK(element.mass() != TestType(material, plain, 0.7).mass());
}

TEMPLATE_TEST_CASE("mass: rotary inertia at the nodes is the whole of it and couples no nodes",
                   "[element][mass]", ancf::CrossSectionBeam<3>, ancf::CrossSectionBeam<2>) {
    const auto material = ancf::Material::from_moduli(2e9, 8e8, 1200.0);
    const ancf::Section section =
        ancf::polygon({{-0.06, -0.09}, {0.11, -0.07}, {0.09, 0.05}, {-0.04, 0.12}})
            .with_shear_correction(0.8, 0.9);
    ancf::CrossSectionOptions options;
    options.rotary_inertia = ancf::RotaryInertia::lumped;
    const TestType element(material, section, 0.7, options);
    ancf::test::check_mass(element, material.density, section.moments());
    ancf::test::check_gravity(element, material.density, section.moments());
    const auto mass = element.mass();
    const auto consistent = TestType(material, section, 0.7).mass();
    constexpr int dimension = TestType::dimension, node = TestType::dofs / 2, line = 2 * dimension;
    const auto across = [&](const auto& matrix, int row, int column) {
        return matrix.template block<node - line, node - line>(row + line, column + line).norm();
    };
    CHECK(across(mass, 0, node) == 0.0);
    CHECK(across(consistent, 0, node) > 0.0);
    CHECK(across(mass, 0, 0) == Approx(1.5 * across(consistent, 0, 0)));
    CHECK(mass.template topLeftCorner<line, line>() ==
          consistent.template topLeftCorner<line, line>());
}

TEMPLATE_TEST_CASE("mass: elements that have it on their line refuse a centre beside the line",
                   "[element][mass][errors]", ancf::Cable<2>, ancf::Cable<3>, ancf::TorsionBeam) {
    const auto material = ancf::Material::from_moduli(2e9, 8e8, 1200.0);
    const ancf::Section plain = ancf::circle(0.1);
    const auto with = [&](double y, double z) {
        const ancf::Moments mass = ancf::offset(ancf::circle(0.15), y, z).moments();
        return TestType(material, plain.with_mass_moments(mass), 0.7);
    };
    CHECK_NOTHROW(with(0.0, 0.0));
    CHECK_THROWS_WITH(with(0.02, 0.0), ContainsSubstring("mass") && ContainsSubstring("0.02 m"));
    if (TestType::dimension == 3)
        CHECK_THROWS_AS(with(0.0, 0.02), ancf::InvalidArgument);
    else
        CHECK_NOTHROW(with(0.0, 0.02));  // it moves with the plane
}

}  // namespace mass_test
