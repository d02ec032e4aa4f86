// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Cross-section beams side by side.

#include <element/pack_cross_section.hpp>
#include <support/catch.hpp>

namespace pack_transporting_test {

namespace test = ancf::test;

TEMPLATE_TEST_CASE(
    "CrossSectionBeam (transporting): equal elements in the lanes of a pack give what each gives "
    "alone",
    "[element][cross-section][pack]", test::Transporting) {
    test::check_equal_lanes<TestType>();
}

TEMPLATE_TEST_CASE(
    "CrossSectionBeam (transporting): elements of different length, section and material share a "
    "pack",
    "[element][cross-section][pack]", test::Transporting) {
    test::check_shared_pack<TestType>();
}

}  // namespace pack_transporting_test
