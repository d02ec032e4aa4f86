// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Cross-section beams side by side.

#include <element/pack_cross_section.hpp>
#include <support/catch.hpp>

namespace pack_carried_test {

namespace test = ancf::test;

TEMPLATE_TEST_CASE(
    "CrossSectionBeam (carried): equal elements in the lanes of a pack give what each gives alone",
    "[element][cross-section][pack]", test::Carried) {
    test::check_equal_lanes<TestType>();
}

TEMPLATE_TEST_CASE(
    "CrossSectionBeam (carried): elements of different length, section and material share a pack",
    "[element][cross-section][pack]", test::Carried) {
    test::check_shared_pack<TestType>();
}

}  // namespace pack_carried_test
