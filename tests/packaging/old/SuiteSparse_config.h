// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Stands for a SuiteSparse that is too old.

#define SUITESPARSE_MAIN_VERSION 5
#define SUITESPARSE_SUB_VERSION 8
#define SUITESPARSE_SUBSUB_VERSION 1
