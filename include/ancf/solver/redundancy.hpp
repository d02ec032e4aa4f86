// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Which equations of constraints follow from others or from supports.

#pragma once

#include <ancf/assembly/numbering.hpp>
#include <ancf/compiler.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/types.hpp>

#include <string>
#include <vector>

namespace ancf::detail {

/// Returns the rows of G that depend on the rows before them, ascending.
///
/// Each row is measured with the coordinates scaled and against its own length: a row is dependent
/// when what remains of it off the span of the earlier ones is not longer than the tolerance,
/// relative. The triangle of G^T = Q R is built by rotations, without Q (George and Heath, Linear
/// Algebra and its Applications 34, 1980); where its diagonal vanishes, the rest of that row goes
/// back into it.
/// @param matrix     compressed; G^T stands in its first rows, from column `first` on.
/// @param scales     sizes of the coordinates, one for each row of G^T, positive.
/// @param tolerance  from 0 to 1.
[[nodiscard]] std::vector<int> dependent_rows(const SparseMatrix& matrix, int first,
                                              const VectorX& scales, double tolerance);

/// Returns an equation in words: the constraint, its name, and which of its equations it is.
[[nodiscard]] std::string describe_equation(const std::vector<AnyConstraint>& constraints,
                                            int equation);

/// Returns in words which constraints of a scene follow from others or from supports, by the G in
/// its tangent; empty where none does, and for more than 200 equations: where these come in any
/// order the comparison may take longer than all else.
[[nodiscard]] std::string repeated_constraints(const Scene& model, const Numbering& numbering,
                                               const SparseMatrix& tangent);

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/solver/redundancy.ipp>  // IWYU pragma: export
#endif
