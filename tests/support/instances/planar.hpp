// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Cross-section beams in the plane, compiled once for all tests.

#pragma once

#include <ancf/element/planar_beam.hpp>
#include <ancf/instances.hpp>

#include <support/instances/solvers.hpp>

#ifndef ANCF_TEST_PLANAR
#define ANCF_TEST_PLANAR extern
#endif

ANCF_ELEMENT_INSTANCES(ANCF_TEST_PLANAR, ancf::CrossSectionBeam<2>);
ANCF_STATICS_INSTANCES(ANCF_TEST_PLANAR, ancf::CrossSectionBeam<2>);
