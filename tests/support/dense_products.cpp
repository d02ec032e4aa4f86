// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <support/dense.hpp>

namespace ancf::test {

using Eigen::MatrixXd, Eigen::VectorXd;

VectorXd product(const MatrixXd& matrix, const VectorXd& vector) { return matrix * vector; }

MatrixXd transformed(const MatrixXd& K, const MatrixXd& T) { return T.transpose() * K * T; }

}  // namespace ancf::test
