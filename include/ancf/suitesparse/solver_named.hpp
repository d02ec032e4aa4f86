// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Linear solvers by name: those of SuiteSparse and of the core.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/solver/linear_solver.hpp>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ancf::suitesparse {

/// Returns the names that solver_named knows, the core's among them.
///
/// "cholmod-simplicial" is Cholmod as L D L^T, which indefinite matrices may need; it calls itself
/// "cholmod". "bordered-chain" has Klu as its general solver here, EigenLu in ancf::solver_named.
[[nodiscard]] std::vector<std::string> solver_names();

/// Returns a new linear solver of SuiteSparse or of the core.
/// @param name            one of solver_names()
/// @param singular_rcond  see default_singular_rcond; 0 refuses zero pivots only.
/// @throws InvalidArgument for any other name, and a singular_rcond outside of [0, 1).
ANCF_LAZY [[nodiscard]] std::unique_ptr<LinearSolver> solver_named(
    std::string_view name, double singular_rcond = default_singular_rcond);

}  // namespace ancf::suitesparse

#if !defined(ANCF_COMPILED)
#include <ancf/suitesparse/solver_named.ipp>  // IWYU pragma: export
#endif
