// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/solver/symmetric_modes.hpp>

#include <Eigen/Eigenvalues>

namespace ancf::detail {

ANCF_LAZY SymmetricModes symmetric_modes(const MatrixX& matrix) {
    const Eigen::SelfAdjointEigenSolver<MatrixX> found(matrix);
    return {found.eigenvalues(), found.eigenvectors()};
}

}  // namespace ancf::detail
