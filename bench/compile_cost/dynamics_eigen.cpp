// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// The planar pendulum of dynamics.cpp with Eigen's sparse LU, a template of its own.

#include <ancf/solver/eigen_solver.hpp>

#define SOLVER ancf::EigenLu
#include "dynamics.cpp"
