// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Dampers of the continuum beam in space, apart from their tests: each half takes less memory.

#include <ancf/element/continuum/beam.hpp>
#include <ancf/model/loads/damping.hpp>

template class ancf::KelvinVoigt<ancf::ContinuumBeam<3>>;
