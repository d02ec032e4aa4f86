// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/solver/bordered_chain.hpp>
#include <ancf/solver/solver_named.hpp>
#include <ancf/suitesparse/cholmod.hpp>
#include <ancf/suitesparse/klu.hpp>
#include <ancf/suitesparse/solver_named.hpp>
#include <ancf/suitesparse/umfpack.hpp>

#include <algorithm>

namespace ancf::suitesparse {

ANCF_INLINE std::vector<std::string> solver_names() {
    std::vector<std::string> names = ancf::solver_names();
    names.insert(names.end(), {"cholmod", "cholmod-simplicial", "klu", "umfpack"});
    return names;
}

ANCF_LAZY std::unique_ptr<LinearSolver> solver_named(std::string_view name, double singular_rcond) {
    if (name == "cholmod" || name == "cholmod-simplicial") {
        CholmodOptions options;
        if (name == "cholmod-simplicial") options.mode = CholmodMode::simplicial;
        options.singular_rcond = singular_rcond;
        return std::make_unique<Cholmod>(options);
    }
    KluOptions klu;
    klu.singular_rcond = singular_rcond;
    if (name == "klu") return std::make_unique<Klu>(klu);
    if (name == "bordered-chain") return std::make_unique<BorderedChain>(Klu(klu), singular_rcond);
    if (name == "umfpack") {
        UmfpackOptions options;
        options.singular_rcond = singular_rcond;
        return std::make_unique<Umfpack>(options);
    }
    const std::vector<std::string> core = ancf::solver_names();
    if (std::find(core.begin(), core.end(), name) == core.end())
        ancf::detail::reject_solver(name, solver_names());
    return ancf::solver_named(name, singular_rcond);
}

}  // namespace ancf::suitesparse
