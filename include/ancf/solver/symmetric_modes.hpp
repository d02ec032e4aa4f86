// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Eigenvalues of small symmetric matrices, in a file of their own: Eigen's solver takes the most
/// memory of all to compile.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/types.hpp>

namespace ancf::detail {

/// All eigenvalues and eigenvectors of a symmetric matrix.
struct SymmetricModes {
    VectorX values;   ///< in ascending order
    MatrixX vectors;  ///< columns, of unit length
};

/// @param matrix  of which the lower triangle is read
ANCF_LAZY [[nodiscard]] SymmetricModes symmetric_modes(const MatrixX& matrix);

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/solver/symmetric_modes.ipp>
#endif
