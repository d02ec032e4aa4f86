// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The interface of linear solvers of complex matrices, which implicit Runge-Kutta methods need.

#pragma once

#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/types.hpp>

#include <complex>
#include <memory>
#include <string_view>

namespace ancf {

/// A column of complex numbers.
using ComplexVectorX = Eigen::VectorXcd;

/// Solves A x = b, A complex, in the pattern of a real matrix.
///
/// Such a solver belongs to a LinearSolver, which makes it (LinearSolver::complex_solver), and
/// reads matrices of the same storage. Of the lower half of a matrix, the matrix is symmetric and
/// not Hermitian.
class ComplexSolver {
public:
    virtual ~ComplexSolver() = default;

    /// Prepares for a pattern; called once for each. The values do not matter.
    /// @throws InvalidArgument for a matrix that the solver cannot take.
    virtual void analyze(const SparseMatrix& pattern) = 0;

    /// Factorises values in the order of the pattern's.
    /// @param values  as many as the pattern has.
    /// @return converged, singular or not_finite.
    [[nodiscard]] virtual Status factorize(const List<std::complex<double>>& values) = 0;

    /// Replaces b by the solution, after a factorisation that converged.
    virtual void solve(ComplexVectorX& b) const = 0;

    /// The word that tables print.
    [[nodiscard]] virtual std::string_view name() const noexcept = 0;

    /// Takes a solver for what this one cannot factorise, before the first pattern.
    virtual void take_general(std::unique_ptr<ComplexSolver> /*general*/) {}

protected:
    ComplexSolver() = default;
    ComplexSolver(const ComplexSolver&) = default;             ///< by derived classes alone
    ComplexSolver(ComplexSolver&&) = default;                  ///< by derived classes alone
    ComplexSolver& operator=(const ComplexSolver&) = default;  ///< by derived classes alone
    ComplexSolver& operator=(ComplexSolver&&) = default;       ///< by derived classes alone
};

}  // namespace ancf
