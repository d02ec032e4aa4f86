// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// main() for a Catch2 2 that was installed as headers alone.

#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
