// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// The planar pendulum of dynamics.cpp with Eigen's sparse LU.

#include <ancf/solver/eigen_lu.hpp>

#define SOLVER ancf::EigenLu
#include "dynamics.cpp"
