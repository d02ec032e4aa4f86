// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Cross-section beams in space, compiled once for all tests.

#pragma once

#include <ancf/element/cross_section_beam.hpp>
#include <ancf/instances.hpp>

#include <support/instances/solvers.hpp>

#ifndef ANCF_TEST_CROSS_SECTION
#define ANCF_TEST_CROSS_SECTION extern
#endif

ANCF_ELEMENT_INSTANCES(ANCF_TEST_CROSS_SECTION, ancf::CrossSectionBeam<3>);
ANCF_STATICS_INSTANCES(ANCF_TEST_CROSS_SECTION, ancf::CrossSectionBeam<3>);
