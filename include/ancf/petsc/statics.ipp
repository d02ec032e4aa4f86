// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of statics.hpp.

#pragma once

#include <ancf/error.hpp>
#include <ancf/petsc/statics.hpp>

namespace ancf::petsc {

ANCF_INLINE StaticsReport DistributedStatics::solve(const StaticsOptions& options) {
    options.check();
    ancf::detail::require(options.newton != NewtonKind::turned,
                          "petsc::DistributedStatics: NewtonKind::turned ties all nodes of a "
                          "scene; take mixed or plain");
    StaticsOptions own = options;
    if (options.progress)
        own.progress = [&](double factor, const State& state) {
            return all_go_on([&] { return options.progress(factor, state); });
        };
    StaticsReport report = solve_statics(*part_, solver_, own);
    if (report.softened)
        report.softened->element =
            partition_->element(report.softened->group, report.softened->element);
    settle(report.fault, report.message);
    return report;
}

}  // namespace ancf::petsc
