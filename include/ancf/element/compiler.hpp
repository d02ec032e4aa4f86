// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The one compiler extension that kernels need.

#pragma once

/// Keeps a stage of a kernel a function of its own: costs nothing at run time, and inlining the
/// stages into each other is what makes translation units slow to compile.
#if defined(__GNUC__)
#define ANCF_NOINLINE __attribute__((noinline))
#else
#define ANCF_NOINLINE
#endif
