// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Continuum beams in space and in the plane, compiled once for all tests.

#pragma once

#include <ancf/element/continuum_beam.hpp>
#include <ancf/instances.hpp>

#include <support/instances/solvers.hpp>

#ifndef ANCF_TEST_CONTINUUM
#define ANCF_TEST_CONTINUUM extern
#endif

ANCF_ELEMENT_INSTANCES(ANCF_TEST_CONTINUUM, ancf::ContinuumBeam<2>);
ANCF_ELEMENT_INSTANCES(ANCF_TEST_CONTINUUM, ancf::ContinuumBeam<3>);
ANCF_STATICS_INSTANCES(ANCF_TEST_CONTINUUM, ancf::ContinuumBeam<2>);
ANCF_STATICS_INSTANCES(ANCF_TEST_CONTINUUM, ancf::ContinuumBeam<3>);
