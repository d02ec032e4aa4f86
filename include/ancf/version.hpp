// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The version of the library, for the preprocessor and for programs that report it.

#pragma once

#include <string_view>

#define ANCF_VERSION_MAJOR 0
#define ANCF_VERSION_MINOR 1
#define ANCF_VERSION_PATCH 0

namespace ancf {

/// "major.minor.patch"; equal to the version of the CMake package.
inline constexpr std::string_view version = "0.1.0";

}  // namespace ancf
