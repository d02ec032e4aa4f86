// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The mixed tangent of continuum beams in space.

#include <element/continuum_mixed_checks.hpp>
#include <support/catch.hpp>

TEST_CASE("ContinuumBeam: the mixed tangent in space has the stresses of linearised strains",
          "[element][continuum][tangent]") {
    ancf::test::check_mixed_continuum<3>();
}
