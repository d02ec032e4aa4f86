// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Torsion beams and planar cross-section beams side by side.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/torsion/beam.hpp>

#include <element/cross_section_beam_samples.hpp>
#include <element/pack_difference.hpp>
#include <support/catch.hpp>

#include <array>

namespace pack_slender_test {

using namespace ancf;

TEMPLATE_TEST_CASE(
    "torsion beams and planar cross-section beams: equal elements in the lanes of a pack give what "
    "each gives alone",
    "[element][pack]", TorsionBeam, CrossSectionBeam<2>) {
    const TestType element(test::sample_material(), test::sample_rectangle(), 0.7);
    CHECK(test::pack_difference<4>(std::array{&element, &element, &element, &element}, element) <=
          1e-14);  // round-off
}

}  // namespace pack_slender_test
