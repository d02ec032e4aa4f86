// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The cross-section beam: properties of every element, derivatives, invariance, inertia.

#include <ancf/constants.hpp>
#include <ancf/element/cross_section/beam.hpp>

#include <element/cross_section_beam_samples.hpp>
#include <element/property_checks.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/dense.hpp>
#include <support/random_state.hpp>

#include <cstdint>

namespace cross_section_beam_test {

using namespace ancf;
using test::Carried;
using test::Paper;
using test::Pointwise;
using test::Transporting;

TEMPLATE_TEST_CASE(
    "CrossSectionBeam: energy and force vanish in every rigid motion of the rest state",
    "[element][cross-section]", Paper, Pointwise, Carried, Transporting) {
    const auto variant = test::any_variant<TestType>();
    INFO(variant.name);
    test::check_zero_at_rest(test::element_of<TestType>(variant));
}

TEMPLATE_TEST_CASE("CrossSectionBeam: energy is invariant under rigid motions, near and far",
                   "[element][cross-section]", Paper, Pointwise, Carried, Transporting) {
    const auto variant = test::any_variant<TestType>();
    INFO(variant.name);
    test::check_rigid_invariance(test::element_of<TestType>(variant));
    test::check_rigid_invariance(test::element_of<TestType>(variant), 1e-3);
}

TEMPLATE_TEST_CASE("CrossSectionBeam: a stress-free element has exactly six zero modes",
                   "[element][cross-section]", Paper, Pointwise, Carried, Transporting) {
    const auto variant = test::any_variant<TestType>();
    INFO(variant.name);
    test::check_zero_modes(test::element_of<TestType>(variant));
}

TEST_CASE("CrossSectionBeam: the fewest points that a rule may have leave six zero modes",
          "[element][cross-section]") {
    CrossSectionOptions options;
    options.rule = Rule::grouped("fewest", gauss_quadrature(3), gauss_quadrature(2),
                                 gauss_quadrature(2), gauss_quadrature(1));
    test::check_zero_modes(
        Paper(test::sample_material(), test::sample_odd_section(), 0.7, options));
    options.rule = Rule::grouped("fewest", gauss_quadrature(3), gauss_quadrature(2),
                                 gauss_quadrature(3), gauss_quadrature(1));
    test::check_zero_modes(
        Pointwise(test::sample_material(), test::sample_odd_section(), 0.7, options));
}

TEMPLATE_TEST_CASE("CrossSectionBeam: turning a stressed element turns its force",
                   "[element][cross-section]", Paper, Pointwise, Carried, Transporting) {
    const auto variant = test::any_variant<TestType>();
    INFO(variant.name);
    test::check_turning(test::element_of<TestType>(variant));
}

TEST_CASE("CrossSectionBeam: mass and gravity are those of the body", "[element][cross-section]") {
    const auto variant = test::any_variant();
    INFO(variant.name);
    const auto element = test::element_of(variant);
    const double density = test::sample_material().density;
    test::check_mass(element, density, test::section_of(variant).moments());
    test::check_gravity(element, density, test::section_of(variant).moments());
}

TEMPLATE_TEST_CASE(
    "CrossSectionBeam: planar motion of a section symmetric to the plane stays planar",
    "[element][cross-section]", Paper, Pointwise, Carried, Transporting) {
    const auto variant = test::any_variant<TestType>();
    if (variant.odd) return;
    INFO(variant.name);
    test::check_planar(test::element_of<TestType>(variant));
}

TEST_CASE("CrossSectionBeam: states without strains are refused", "[element][cross-section]") {
    const auto element = test::element_of(test::variants[0]);
    test::check_admissible(element);
    // A slope that turns over inside the element has next to no length somewhere: no station needs
    // to lie there.
    const auto turned = [&](double degrees) {
        auto e = test::reference_coordinates(element);
        const auto turn = test::rotation(Vector<double, 3>(degrees * ancf::pi / 180.0, 0.0, 0.0));
        e.segment<3>(18) = turn * e.segment<3>(18);
        e.segment<3>(21) = turn * e.segment<3>(21);
        return e;
    };
    CHECK(element.admissible(turned(119.0)));
    CHECK_FALSE(element.admissible(turned(121.0)));
    CHECK_FALSE(element.admissible(turned(180.0)));
    // A centre line that folds back between its nodes.
    auto folded = test::reference_coordinates(element);
    folded.segment<3>(12) = folded.segment<3>(0);
    CHECK_FALSE(element.admissible(folded));
    // A left-handed section, and one without an area.
    auto flat = test::reference_coordinates(element);
    flat.segment<3>(9) *= -1.0;
    CHECK_FALSE(element.admissible(flat));
    flat.segment<3>(9) = flat.segment<3>(6);
    CHECK_FALSE(element.admissible(flat));
}

TEMPLATE_TEST_CASE("CrossSectionBeam: directors are not carried round by 180 degrees",
                   "[element][cross-section]", Carried, Transporting) {
    const auto element = test::element_of<TestType>(test::variants[0]);
    test::check_admissible(element);
    auto e = test::reference_coordinates(element);
    e.template segment<3>(18) << 0.0, -1.0, 0.0;
    e.template segment<3>(21) << 0.0, 0.0, -1.0;
    CHECK_FALSE(element.admissible(e));
}

TEMPLATE_TEST_CASE(
    "CrossSectionBeam: the strains of a stressed element still see all but six motions",
    "[element][cross-section]", Paper, Pointwise, Carried, Transporting) {
    const auto variant = test::any_variant<TestType>();
    INFO(variant.name);
    const auto element = test::element_of<TestType>(variant);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        test::Random random(seed);
        const auto e = test::random_state(element, random);
        // B of all stations and of the transverse strains at the nodes, by complex step
        const auto stations = Rule::named(variant.rule).stations();
        MatrixX B(12 * static_cast<Eigen::Index>(stations.size()) + 6, 24);
        Eigen::Index row = 0;
        for (const RuleStation& station : stations) {
            auto strains = test::complex_step_jacobian(
                [&](const auto& z) { return element.strains(z, station.xi); }, e);
            if (station.axial_only()) strains.bottomRows(11).setZero();
            if (station.weight(StrainGroup::axial) == 0.0) strains.row(0).setZero();
            B.middleRows(row, 12) = strains;
            row += 12;
        }
        for (const double xi : {0.0, 1.0}) {
            B.middleRows(row, 3) = test::complex_step_jacobian(
                [&](const auto& z) { return element.transverse_strains(z, xi); }, e);
            row += 3;
        }
        const VectorX strengths = test::singular_values(B.topRows(row));
        const VectorX values = strengths / strengths(0);
        CHECK(values(17) >= 1e-4);
        CHECK(values(18) <= 1e-13);
    }
}

TEST_CASE("CrossSectionBeam: wrong arguments are refused with their value",
          "[element][cross-section]") {
    const auto material = test::sample_material();
    const auto section = test::sample_rectangle();
    CHECK_THROWS_WITH(Paper(material, section, 0.0), ContainsSubstring("length"));
    CHECK_THROWS_WITH(Paper(material, section, -1.5), ContainsSubstring("-1.5"));
    CrossSectionOptions options;
    options.rule = Rule::gauss(2);
    CHECK_THROWS_WITH(Paper(material, section, 1.0, options),
                      ContainsSubstring("gauss2") && ContainsSubstring("axial"));
    options.rule = Rule::mixed();
    CHECK_THROWS_WITH(Pointwise(material, section, 1.0, options), ContainsSubstring("shear"));
}

}  // namespace cross_section_beam_test
