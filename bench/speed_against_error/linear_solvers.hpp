// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The linear solvers of symmetric matrices that are compared.

#pragma once

#include <ancf/solver/linear_solver.hpp>

#include <memory>
#include <string>
#include <vector>

namespace speed {

/// Returns the names of the linear solvers.
std::vector<std::string> linear_solvers();

/// Returns the linear solver of one of these names.
std::unique_ptr<ancf::LinearSolver> linear_solver(const std::string& name);

}  // namespace speed
