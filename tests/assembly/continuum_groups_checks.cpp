// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Groups of the continuum beam, which take the most memory.

#include <ancf/model/attachment.hpp>
#include <ancf/model/group_of.hpp>

#include <assembly/element_groups.hpp>

namespace ancf {

ANCF_ELEMENT_INSTANCE(, ContinuumBeam<3>);

}  // namespace ancf
