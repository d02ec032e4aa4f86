// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Continuum beams side by side.

#include <ancf/element/continuum/beam.hpp>

#include <element/cross_section_beam_samples.hpp>
#include <element/pack_difference.hpp>
#include <support/catch.hpp>

#include <array>

namespace pack_continuum_plane_test {

using namespace ancf;

TEMPLATE_TEST_CASE(
    "continuum beams in the plane: equal elements in the lanes of a pack give what each gives "
    "alone",
    "[element][pack]", ContinuumBeam<2>) {
    const TestType element(test::sample_material(), test::sample_rectangle(), 0.7);
    CHECK(test::pack_difference<4>(std::array{&element, &element, &element, &element}, element) <=
          1e-14);  // round-off
}

}  // namespace pack_continuum_plane_test
