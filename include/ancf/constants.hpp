// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Numbers of mathematics, for headers that need no linear algebra too.

#pragma once

namespace ancf {

/// The ratio of a circle's circumference to its diameter.
inline constexpr double pi = 3.14159265358979323846;

}  // namespace ancf
