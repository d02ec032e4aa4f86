// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Eigen's sparse direct solvers, for a build that has nothing else: EigenLdlt and EigenLu.
///
/// Each has a header of its own, so that a program compiles only what it uses.

#pragma once

#include <ancf/solver/eigen_ldlt.hpp>  // IWYU pragma: export
#include <ancf/solver/eigen_lu.hpp>    // IWYU pragma: export
