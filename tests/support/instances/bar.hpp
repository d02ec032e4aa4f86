// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Bars in space, compiled once for all tests.

#pragma once

#include <ancf/instances.hpp>

#include <support/bar.hpp>
#include <support/instances/solvers.hpp>

#ifndef ANCF_TEST_BAR
#define ANCF_TEST_BAR extern
#endif

ANCF_ELEMENT_INSTANCES(ANCF_TEST_BAR, ancf::test::Bar<3>);
ANCF_STATICS_INSTANCES(ANCF_TEST_BAR, ancf::test::Bar<3>);
