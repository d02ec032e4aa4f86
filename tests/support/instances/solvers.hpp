// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Eigen's sparse direct solvers, compiled once for all tests.

#pragma once

#include <ancf/instances.hpp>

#ifndef ANCF_TEST_SOLVERS
#define ANCF_TEST_SOLVERS extern
#endif

ANCF_SOLVER_INSTANCES(ANCF_TEST_SOLVERS);
