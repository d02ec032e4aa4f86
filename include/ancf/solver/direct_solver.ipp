// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of direct_solver.hpp.

#pragma once

#include <ancf/solver/conditioning.hpp>
#include <ancf/solver/direct_solver.hpp>

namespace ancf::detail {

ANCF_INLINE DirectSolver::DirectSolver(double singular_rcond) : singular_rcond_(singular_rcond) {
    require_singular_rcond(singular_rcond);
}

ANCF_INLINE void DirectSolver::analyze(const SparseMatrix& matrix) {
    require_storage(name(), matrix, storage());
    stage_.reset();
    if (matrix.cols() > 0) analyze_pattern(matrix);
    stage_.analysed(matrix);
}

ANCF_INLINE FactorReport DirectSolver::factorize(const SparseMatrix& matrix) {
    stage_.begin_factorisation(name(), matrix);
    if (matrix.cols() == 0)
        return stage_.finished({Status::converged, -1, 1.0, storage() == Storage::lower ? 0 : -1});
    FactorReport report = factorize_values(matrix);
    if (report.status == Status::converged && report.rcond == 0.0)
        report_condition(
            matrix, singular_rcond_, [this](const VectorX& b, VectorX& x) { substitute(b, x); },
            report);
    return stage_.finished(report);
}

ANCF_INLINE void DirectSolver::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    if (b.size() > 0) {
        substitute(b, x);
    } else {
        x = b;
    }
}

}  // namespace ancf::detail
