// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Random coordinates for the beams with a cross-section frame.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>

#include <fuzz/try_out.hpp>

namespace cross_section_fuzz_test {

TEMPLATE_TEST_CASE(
    "fuzz: no coordinates crash an element, and admissible ones give finite results", "[fuzz]",
    ancf::CrossSectionBeam<3>, (ancf::CrossSectionBeam<3, ancf::Geodesic>),
    (ancf::CrossSectionBeam<3, ancf::Projected, ancf::LinearShear, ancf::EngineeringMeasure>),
    ancf::CrossSectionBeam<2>, ancf::QuinticBeam<>) {
    ancf::test::try_out<TestType>();
}

}  // namespace cross_section_fuzz_test
