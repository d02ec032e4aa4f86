// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The cross-section beam: force and tangent against derivatives.

#include <ancf/element/cross_section/beam.hpp>

#include <element/cross_section_beam_samples.hpp>
#include <element/mixed_checks.hpp>
#include <element/property_checks.hpp>
#include <support/catch.hpp>

namespace cross_section_tangent_test {

using namespace ancf;
using test::Carried;
using test::Paper;
using test::Pointwise;
using test::Transporting;

TEMPLATE_TEST_CASE("CrossSectionBeam: force and tangent equal the complex-step derivatives",
                   "[element][cross-section][tangent]", Paper, Pointwise, Carried, Transporting) {
    const auto variant = test::any_variant<TestType>();
    INFO(variant.name);
    test::check_derivatives(test::element_of<TestType>(variant));
}

TEMPLATE_TEST_CASE("CrossSectionBeam: the mixed tangent has the stresses of linearised strains",
                   "[element][cross-section][tangent]", Paper, Pointwise, Carried, Transporting) {
    const auto variant = test::any_variant<TestType>();
    INFO(variant.name);
    test::check_mixed_tangent(test::element_of<TestType>(variant));
}

}  // namespace cross_section_tangent_test
