// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Groups of the planar beam, the continuum beam and the cable.

#include <ancf/model/model.hpp>

#include <assembly/element_groups.hpp>

namespace ancf {

ANCF_ELEMENT_INSTANCE(, CrossSectionBeam<2>);
ANCF_ELEMENT_INSTANCE(, ContinuumBeam<3>);
ANCF_ELEMENT_INSTANCE(, Cable<3>);

}  // namespace ancf
