// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/error.hpp>
#include <ancf/solver/automatic.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/bordered_chain.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/solver_named.hpp>

namespace ancf {

ANCF_INLINE std::vector<std::string> solver_names() {
    return {"automatic", "block-tridiagonal", "bordered-chain", "eigen-ldlt", "eigen-lu"};
}

ANCF_LAZY std::unique_ptr<LinearSolver> solver_named(std::string_view name, double singular_rcond) {
    if (name == "eigen-ldlt") return std::make_unique<EigenLdlt>(singular_rcond);
    if (name == "eigen-lu") return std::make_unique<EigenLu>(singular_rcond);
    if (name == "block-tridiagonal") return std::make_unique<BlockTridiagonal>(singular_rcond);
    if (name == "bordered-chain")
        return std::make_unique<BorderedChain>(EigenLu(singular_rcond), singular_rcond);
    if (name == "automatic")
        return std::make_unique<Automatic>(EigenLdlt(singular_rcond),
                                           BlockTridiagonal(singular_rcond));
    detail::reject_solver(name, solver_names());
}

ANCF_INLINE void detail::reject_solver(std::string_view name,
                                       const std::vector<std::string>& known) {
    std::string list;
    for (const std::string& one : known) list += (list.empty() ? "" : ", ") + one;
    reject("there is no linear solver \"", name, "\", only ", list);
}

}  // namespace ancf
