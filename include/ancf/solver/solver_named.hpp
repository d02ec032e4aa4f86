// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Linear solvers by name, for programs that pick one when they run.
///
/// It brings in every solver of the core; a program that names its solver includes the header of
/// that one alone.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/solver/linear_solver.hpp>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ancf {

/// Returns the names that solver_named knows: those of the core's solvers, and "automatic".
[[nodiscard]] std::vector<std::string> solver_names();

/// Returns a new linear solver of the core.
///
///     const std::unique_ptr<ancf::LinearSolver> solver = ancf::solver_named("eigen-ldlt");
///     const auto report = ancf::solve_statics(model, *solver);
///
/// @param name            one of solver_names(); component suitesparse knows more
/// @param singular_rcond  see default_singular_rcond; 0 refuses zero pivots only.
/// @throws InvalidArgument for any other name, and a singular_rcond outside of [0, 1).
ANCF_LAZY [[nodiscard]] std::unique_ptr<LinearSolver> solver_named(
    std::string_view name, double singular_rcond = default_singular_rcond);

namespace detail {

/// Throws InvalidArgument with the names that are known.
[[noreturn]] void reject_solver(std::string_view name, const std::vector<std::string>& known);

}  // namespace detail
}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/solver_named.ipp>  // IWYU pragma: export
#endif
