// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Cross-section beams side by side.

#include <element/pack_cross_section.hpp>
#include <support/catch.hpp>

#include <array>

namespace pack_paper_test {

using namespace ancf;

TEMPLATE_TEST_CASE(
    "CrossSectionBeam (paper): equal elements in the lanes of a pack give what each gives alone",
    "[element][cross-section][pack]", test::Paper) {
    test::check_equal_lanes<TestType>();
}

TEST_CASE("CrossSectionBeam: eight equal elements in a pack give what each gives alone",
          "[element][cross-section][pack]") {
    const test::Paper element(test::sample_material(), test::sample_rectangle(), 0.7);
    std::array<const test::Paper*, 8> elements{};
    elements.fill(&element);
    CHECK(test::pack_difference<8>(elements, element) <= 1e-14);  // round-off
}

TEMPLATE_TEST_CASE(
    "CrossSectionBeam (paper): elements of different length, section and material share a pack",
    "[element][cross-section][pack]", test::Paper) {
    test::check_shared_pack<TestType>();
}

}  // namespace pack_paper_test
