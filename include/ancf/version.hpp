// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The version of the library, for the preprocessor and for programs that report it.

#pragma once

#include <string_view>

/// Changes with what breaks callers.
#define ANCF_VERSION_MAJOR 0
/// Changes with what is added.
#define ANCF_VERSION_MINOR 2
/// Changes with what is mended.
#define ANCF_VERSION_PATCH 0

namespace ancf {

/// "major.minor.patch"; equal to the version of the CMake package.
inline constexpr std::string_view version = "0.2.0";

}  // namespace ancf
