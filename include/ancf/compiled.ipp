// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The guards of the compiled library: definitions.

#pragma once

#include <ancf/compiled.hpp>

#if defined(ANCF_COMPILED)
namespace ancf::detail {

const char ANCF_LAYOUT = 0;
const char header_only_and_compiled_units_do_not_mix = 0;

}  // namespace ancf::detail
#endif
