// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Why a tangent is singular: which vector of which node moves without stiffness.

#pragma once

#include <ancf/assembly/numbering.hpp>
#include <ancf/compiler.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <string>
#include <vector>

namespace ancf::detail {

/// Returns in words why a tangent cannot be factorised; empty where that does not show.
///
/// Weak springs at every coordinate make a tangent regular whose singular motions no constraint
/// holds; the softest one is then sought. Where springs do not help, constraints repeat each other.
/// @param solver  analysed for the matrix; it is left with another factorisation.
[[nodiscard]] std::string singular_cause(const Layout& layout, const Numbering& numbering,
                                         const SparseMatrix& tangent, LinearSolver& solver);

/// Returns the places of the diagonal entries among the values of a compressed matrix; -1: none.
[[nodiscard]] std::vector<int> diagonal_places(const SparseMatrix& matrix);

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/solver/mechanism.ipp>
#endif
