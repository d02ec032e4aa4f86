// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Cables in space and in the plane, with both measures, compiled once for all tests.

#pragma once

#include <ancf/element/cable.hpp>
#include <ancf/instances.hpp>

#include <support/instances/solvers.hpp>

#ifndef ANCF_TEST_CABLE
#define ANCF_TEST_CABLE extern
#endif

ANCF_ELEMENT_INSTANCES(ANCF_TEST_CABLE, ancf::Cable<2>);
ANCF_ELEMENT_INSTANCES(ANCF_TEST_CABLE, ancf::Cable<3>);
ANCF_ELEMENT_INSTANCES(ANCF_TEST_CABLE, ancf::Cable<2, ancf::EngineeringAxial>);
ANCF_ELEMENT_INSTANCES(ANCF_TEST_CABLE, ancf::Cable<3, ancf::EngineeringAxial>);
ANCF_STATICS_INSTANCES(ANCF_TEST_CABLE, ancf::Cable<2>);
ANCF_STATICS_INSTANCES(ANCF_TEST_CABLE, ancf::Cable<3>);
ANCF_STATICS_INSTANCES(ANCF_TEST_CABLE, ancf::Cable<2, ancf::EngineeringAxial>);
ANCF_STATICS_INSTANCES(ANCF_TEST_CABLE, ancf::Cable<3, ancf::EngineeringAxial>);
