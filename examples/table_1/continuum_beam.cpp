// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The continuum beam of table_1.cpp.

#include <ancf/element/continuum/beam.hpp>
#include <ancf/model/model.hpp>

namespace ancf {

ANCF_ELEMENT_INSTANCE(, ContinuumBeam<3>);

}  // namespace ancf
