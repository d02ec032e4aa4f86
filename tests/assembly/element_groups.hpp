// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Elements whose groups and evaluation are compiled once for all tests of the assembly, as the
/// compiled library would: each test takes less memory.

#pragma once

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/compiled_element.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/torsion/beam.hpp>

namespace ancf {

ANCF_COMPILED_ELEMENT(CrossSectionBeam<3>);
ANCF_COMPILED_ELEMENT(CrossSectionBeam<3, Geodesic>);
ANCF_COMPILED_ELEMENT(CrossSectionBeam<2>);
ANCF_COMPILED_ELEMENT(ContinuumBeam<3>);
ANCF_COMPILED_ELEMENT(TorsionBeam);
ANCF_COMPILED_ELEMENT(Cable<3>);

}  // namespace ancf
