// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// The mass of every element, where the section's mass is spread otherwise than its stiffness.

#include <ancf/element/cable.hpp>
#include <ancf/element/continuum_beam.hpp>
#include <ancf/element/cross_section_beam.hpp>
#include <ancf/element/planar_beam.hpp>
#include <ancf/element/torsion_beam.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>

#include <support/catch.hpp>
#include <support/instances/cable.hpp>
#include <support/instances/continuum.hpp>
#include <support/instances/cross_section.hpp>
#include <support/instances/planar.hpp>

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

}  // namespace mass_test
