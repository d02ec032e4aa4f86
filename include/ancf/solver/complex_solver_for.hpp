// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The solver of complex matrices that stands beside a real one.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/solver/complex_solver.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <memory>

namespace ancf {

/// Returns a solver of complex matrices of a pattern, already analysed: the one that the real
/// solver makes; else, of lower storage, L D L^T block by block where the pattern is a chain; else
/// Eigen's LU with partial pivoting.
/// @throws InvalidArgument for a pattern that is not square, compressed and of the solver's storage
ANCF_LAZY [[nodiscard]] std::unique_ptr<ComplexSolver> complex_solver_for(
    const LinearSolver& solver, const SparseMatrix& pattern);

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/complex_solver_for.ipp>  // IWYU pragma: export
#endif
