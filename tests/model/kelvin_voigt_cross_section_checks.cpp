// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Dampers of the beam with cross sections in space, apart from their tests: each half takes less
/// memory.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/loads/damping.hpp>

template class ancf::KelvinVoigt<ancf::CrossSectionBeam<3>>;
template class ancf::KelvinVoigt<ancf::CrossSectionBeam<3, ancf::Geodesic>>;
template class ancf::KelvinVoigt<ancf::CrossSectionBeam<3, ancf::Projected, ancf::PointwiseShear>>;
template class ancf::KelvinVoigt<ancf::QuinticBeam<>>;
