// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/complex_block_tridiagonal.hpp>
#include <ancf/solver/complex_solver_for.hpp>
#include <ancf/solver/eigen_complex_lu.hpp>

namespace ancf {

ANCF_LAZY std::unique_ptr<ComplexSolver> complex_solver_for(const LinearSolver& solver,
                                                            const SparseMatrix& pattern) {
    std::unique_ptr<ComplexSolver> result = solver.complex_solver();
    if (result) result->take_general(std::make_unique<EigenComplexLu>(solver.storage()));
    if (!result && solver.storage() == Storage::lower && BlockTridiagonal::accepts(pattern))
        result = std::make_unique<ComplexBlockTridiagonal>();
    if (!result) result = std::make_unique<EigenComplexLu>(solver.storage());
    result->analyze(pattern);
    return result;
}

}  // namespace ancf
