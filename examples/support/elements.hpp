// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The element types that the example programs choose from when they run.

#pragma once

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/model.hpp>

namespace examples {

using CrossSection = ancf::CrossSectionBeam<3>;
using CrossSectionTransported = ancf::CrossSectionBeam<3, ancf::Transported>;
using CrossSectionGeodesic = ancf::CrossSectionBeam<3, ancf::Geodesic>;
using CrossSectionQuintic = ancf::QuinticBeam<>;
using CrossSectionPointwise = ancf::CrossSectionBeam<3, ancf::Projected, ancf::PointwiseShear>;
using Continuum = ancf::ContinuumBeam<3>;
using PlanarCrossSection = ancf::CrossSectionBeam<2>;
using PlanarContinuum = ancf::ContinuumBeam<2>;
using Cable = ancf::Cable<3>;
using PlanarCable = ancf::Cable<2>;

/// The elements that a program offers.
template <class... Elements>
struct ElementList {};

using CrossSectionBeams = ElementList<CrossSection, CrossSectionTransported, CrossSectionGeodesic,
                                      CrossSectionQuintic, CrossSectionPointwise>;
using SpatialBeams = ElementList<CrossSection, CrossSectionTransported, CrossSectionGeodesic,
                                 CrossSectionQuintic, CrossSectionPointwise, Continuum>;
using AllElements = ElementList<CrossSection, CrossSectionTransported, CrossSectionGeodesic,
                                CrossSectionQuintic, CrossSectionPointwise, Continuum,
                                PlanarCrossSection, PlanarContinuum, Cable, PlanarCable>;

}  // namespace examples
