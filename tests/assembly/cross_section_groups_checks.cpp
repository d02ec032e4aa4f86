// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Groups of beams with a cross-section in space and of the beam with torsion.

#include <ancf/model/model.hpp>

#include <assembly/element_groups.hpp>

namespace ancf {

ANCF_ELEMENT_INSTANCE(, CrossSectionBeam<3>);
ANCF_ELEMENT_INSTANCE(, CrossSectionBeam<3, Geodesic>);
ANCF_ELEMENT_INSTANCE(, TorsionBeam);

}  // namespace ancf
