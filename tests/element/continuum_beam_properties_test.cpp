// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The continuum beam under the list of properties that every element has.

#include <ancf/element/continuum/beam.hpp>

#include <element/property_checks.hpp>
#include <support/catch.hpp>
#include <support/complex_elements.hpp>

#include <iterator>

namespace continuum_beam_properties_test {

using namespace ancf;

constexpr double density = 7800.0;

constexpr ContinuumMaterial all_laws[] = {ContinuumMaterial::diagonal, ContinuumMaterial::hooke,
                                          ContinuumMaterial::enhanced};

/// Returns a rule of one quadrature per group: some stations integrate E A eps^2/2 alone.
Rule grouped() {
    return Rule::grouped("grouped", lobatto_quadrature(3), gauss_quadrature(2), gauss_quadrature(3),
                         gauss_quadrature(2));
}

/// A section off the axis, two shear correction factors.
Section odd_section() {
    return offset(rectangle(0.1, 0.2).with_shear_correction(0.8, 0.9), 0.02, -0.03);
}

template <int Dimension>
ContinuumBeam<Dimension> sample(ContinuumMaterial law, const Section& section,
                                const Rule& rule = Rule::paper()) {
    return {Material::isotropic(2e7, 0.3, density), section, 0.7, {rule, law}};
}

TEMPLATE_TEST_CASE_SIG(
    "ContinuumBeam: force and tangent equal the complex-step derivatives of energy and force",
    "[element][continuum][tangent]", ((int Dimension), Dimension), 3, 2) {
    const auto law = GENERATE(from_range(std::begin(all_laws), std::end(all_laws)));
    for (const Rule& rule : {Rule::paper(), Rule::lobatto3(), grouped()}) {
        INFO(to_string(law) << ", rule " << rule.name());
        test::check_derivatives(sample<Dimension>(law, odd_section(), rule));  // measured 8e-16
    }
}

TEMPLATE_TEST_CASE_SIG("ContinuumBeam: a rigid motion strains nothing",
                       "[element][continuum][properties]", ((int Dimension), Dimension), 3, 2) {
    const auto law = GENERATE(from_range(std::begin(all_laws), std::end(all_laws)));
    INFO(to_string(law));
    const auto element = sample<Dimension>(law, odd_section());
    test::check_zero_at_rest(element);
    test::check_rigid_invariance(element);
}

TEMPLATE_TEST_CASE_SIG("ContinuumBeam: only rigid motions have no stiffness",
                       "[element][continuum][properties]", ((int Dimension), Dimension), 3, 2) {
    const auto law = GENERATE(from_range(std::begin(all_laws), std::end(all_laws)));
    for (const char* name : {"paper", "gauss3", "gauss5", "gauss6", "lobatto3"}) {
        INFO(to_string(law) << ", rule " << name);
        test::check_zero_modes(sample<Dimension>(law, odd_section(), Rule::named(name)));
    }
    INFO(to_string(law) << ", rule " << grouped().name());
    test::check_zero_modes(sample<Dimension>(law, odd_section(), grouped()));
}

TEMPLATE_TEST_CASE_SIG("ContinuumBeam: turning the element turns its force",
                       "[element][continuum][properties]", ((int Dimension), Dimension), 3, 2) {
    const auto law = GENERATE(from_range(std::begin(all_laws), std::end(all_laws)));
    INFO(to_string(law));
    test::check_turning(sample<Dimension>(law, odd_section()));
}

TEST_CASE("ContinuumBeam: mass and gravity are those of the body",
          "[element][continuum][properties]") {
    const Section section = odd_section();
    const auto space = sample<3>(ContinuumMaterial::diagonal, section);
    test::check_mass(space, density, section.moments());
    test::check_gravity(space, density, section.moments());
    const auto plane = sample<2>(ContinuumMaterial::diagonal, section);
    test::check_mass(plane, density, section.moments());
    test::check_gravity(plane, density, section.moments());
}

TEST_CASE("ContinuumBeam: planar motion stays planar", "[element][continuum][properties]") {
    const auto law = GENERATE(from_range(std::begin(all_laws), std::end(all_laws)));
    INFO(to_string(law));
    test::check_planar(sample<3>(law, offset(rectangle(0.1, 0.2), 0.02, 0.0)));
}

TEST_CASE("ContinuumBeam: degenerate states are not admissible",
          "[element][continuum][properties]") {
    test::check_admissible(sample<3>(ContinuumMaterial::diagonal, odd_section()));
    test::check_admissible(sample<2>(ContinuumMaterial::diagonal, odd_section()));
}

}  // namespace continuum_beam_properties_test
