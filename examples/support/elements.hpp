// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The element types that the example programs choose from when they run.
///
/// What is heavy to compile is compiled once for each of them, in this folder's sources.

#pragma once

#include <ancf/element/continuum_beam.hpp>
#include <ancf/element/cross_section_beam.hpp>

namespace examples {

using CrossSection = ancf::CrossSectionBeam<3>;
using CrossSectionPointwise = ancf::CrossSectionBeam<3, ancf::Projected, ancf::PointwiseShear>;
using Continuum = ancf::ContinuumBeam<3>;

}  // namespace examples

/// Calls a macro for every element type.
#define ANCF_EXAMPLES_FOR_EACH_ELEMENT(apply) \
    apply(CrossSection) apply(CrossSectionPointwise) apply(Continuum)
