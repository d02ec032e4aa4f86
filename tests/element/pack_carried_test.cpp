// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Cross-section beams side by side.

#include <ancf/element/cross_section/beam.hpp>

#include <element/cross_section_beam_samples.hpp>
#include <element/pack_difference.hpp>
#include <support/catch.hpp>

#include <array>
#include <iterator>

namespace pack_carried_test {

using namespace ancf;

TEMPLATE_TEST_CASE(
    "CrossSectionBeam (carried): equal elements in the lanes of a pack give what each gives alone",
    "[element][cross-section][pack]", test::Carried) {
    const auto variant = GENERATE(from_range(std::begin(test::variants), std::end(test::variants)));
    INFO(variant.name);
    const auto element = test::element_of<TestType>(variant);
    CHECK(test::pack_difference<4>(std::array{&element, &element, &element, &element}, element) <=
          1e-14);  // round-off
}

TEMPLATE_TEST_CASE(
    "CrossSectionBeam (carried): elements of different length, section and material share a pack",
    "[element][cross-section][pack]", test::Carried) {
    CrossSectionOptions options;
    options.rule = Rule::mixed();
    const TestType one(test::sample_material(), test::sample_rectangle(), 0.7, options);
    const TestType two(test::sample_material(), test::sample_odd_section(), 1.3, options);
    const TestType three(Material::from_moduli(1e9, 3e8, 100.0), test::sample_rectangle(), 0.2,
                         options);
    const std::array<const TestType*, 4> elements{&one, &two, &three, &one};
    CHECK(test::pack_difference<4>(elements, TestType::template together<4>(elements)) <=
          1e-14);  // round-off
}

}  // namespace pack_carried_test
