// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#if ANCF_WITH_SUITESPARSE
#include <ancf/suitesparse/solver_named.hpp>
#else
#include <ancf/solver/solver_named.hpp>
#endif

#include <linear_solvers.hpp>

namespace speed {

std::vector<std::string> linear_solvers() {
#if ANCF_WITH_SUITESPARSE
    return {"block-tridiagonal", "eigen-ldlt", "cholmod"};
#else
    return {"block-tridiagonal", "eigen-ldlt"};
#endif
}

std::unique_ptr<ancf::LinearSolver> linear_solver(const std::string& name) {
#if ANCF_WITH_SUITESPARSE
    return ancf::suitesparse::solver_named(name);
#else
    return ancf::solver_named(name);
#endif
}

}  // namespace speed
