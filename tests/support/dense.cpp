// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <support/dense.hpp>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace ancf::test {

using Eigen::MatrixXd, Eigen::VectorXd;

VectorXd eigenvalues(const MatrixXd& symmetric) {
    return Eigen::SelfAdjointEigenSolver<MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

DenseModes dense_modes(const MatrixXd& K, const MatrixXd& M) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(K, M);
    return {modes.eigenvalues(), modes.eigenvectors()};
}

VectorXd singular_values(const MatrixXd& matrix) {
    return Eigen::JacobiSVD<MatrixXd>(matrix).singularValues();
}

VectorXd solved(const MatrixXd& matrix, const VectorXd& right) {
    return matrix.partialPivLu().solve(right);
}

MatrixXd inverted(const MatrixXd& matrix) { return matrix.inverse(); }

}  // namespace ancf::test
