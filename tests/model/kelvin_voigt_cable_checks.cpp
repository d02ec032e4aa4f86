// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Dampers of cables, apart from their tests: each half takes less memory.

#include <ancf/element/cable/cable.hpp>
#include <ancf/model/loads/damping.hpp>

template class ancf::KelvinVoigt<ancf::Cable<2>>;
template class ancf::KelvinVoigt<ancf::Cable<2, ancf::EngineeringAxial>>;
template class ancf::KelvinVoigt<ancf::Cable<3>>;
