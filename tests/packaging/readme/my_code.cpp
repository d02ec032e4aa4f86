// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The program of README.md.

#include "../../../examples/tutorial/cantilever.cpp"
