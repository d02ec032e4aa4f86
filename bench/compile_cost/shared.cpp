// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// The planar pendulum of dynamics_eigen.cpp in a program that compiles its instances in another
// unit.

#include <ancf/element/planar_beam.hpp>
#include <ancf/instances.hpp>

ANCF_SOLVER_INSTANCES(extern);
ANCF_ELEMENT_INSTANCES(extern, ancf::CrossSectionBeam<2>);

#define SOLVER ancf::EigenLu
#include "dynamics.cpp"
