// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Decompositions and products of dense matrices, compiled once: what tests compare with.
///
/// A unit that includes one of Eigen's own compiles a second longer for each.

#pragma once

#include <Eigen/Core>

namespace ancf::test {

/// Returns the eigenvalues of a symmetric matrix, the least first.
Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& symmetric);

/// Pairs of K x = value M x, the least first.
struct DenseModes {
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors;  ///< one a column, x^T M x = 1
};

/// Returns the modes of two symmetric matrices, M positive definite.
DenseModes dense_modes(const Eigen::MatrixXd& K, const Eigen::MatrixXd& M);

/// Returns the singular values, the largest first.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

/// Returns the solution by LU factors with row exchanges.
Eigen::VectorXd solved(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// Returns the inverse.
Eigen::MatrixXd inverted(const Eigen::MatrixXd& matrix);

/// Returns the product of a matrix and a vector.
Eigen::VectorXd product(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& vector);

/// Returns T^T K T: a quadratic form of x in y, x = T y.
Eigen::MatrixXd transformed(const Eigen::MatrixXd& K, const Eigen::MatrixXd& T);

}  // namespace ancf::test
