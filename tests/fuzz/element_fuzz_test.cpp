// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Random coordinates for the cables, the continuum beams and the beam with torsion.

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/torsion/beam.hpp>

#include <fuzz/try_out.hpp>

namespace element_fuzz_test {

TEMPLATE_TEST_CASE("fuzz: no coordinates crash an element, and admissible ones give finite results",
                   "[fuzz]", ancf::Cable<3>, ancf::Cable<2>, ancf::ContinuumBeam<3>,
                   ancf::ContinuumBeam<2>, ancf::TorsionBeam) {
    ancf::test::try_out<TestType>();
}

}  // namespace element_fuzz_test
