// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of motion.hpp.

#pragma once

#include <ancf/dynamics/problem.hpp>
#include <ancf/error.hpp>
#include <ancf/petsc/motion.hpp>

#include <string>

namespace ancf::petsc {

ANCF_INLINE DistributedMotion::DistributedMotion(Scene& model, MPI_Comm comm,
                                                 const SolverOptions& options)
    : DividedScene(model, comm, options),
      // blocks of M are nearly alike: some thirty iterations at any size
      mass_solver_(*part_, {"-ksp_type bcgs -ksp_rtol 1e-13 -ksp_max_it 1000 -pc_type pbjacobi",
                            options.prefix.empty() ? std::string() : options.prefix + "mass_"}) {
    ancf::detail::require(model.constraints().empty(),
                          "petsc::DistributedMotion: the scene has constraints; GeneralizedAlpha "
                          "with a petsc::Solver moves it in one process");
}

ANCF_INLINE DynamicsReport DistributedMotion::integrate(const Schedule& schedule,
                                                        const GeneralizedAlphaOptions& options,
                                                        const Memory& memory) {
    ProblemOptions how;
    how.mass_solver = &mass_solver_;
    DynamicProblem problem(*part_, how);
    Schedule own = schedule;
    if (schedule.observe)
        own.observe = [&](const Snapshot& seen) {
            ancf::detail::together(partition_.get(), [&] { schedule.observe(seen); });
        };
    if (schedule.progress)
        own.progress = [&](double time, double end) {
            return all_go_on([&] { return schedule.progress(time, end); });
        };
    DynamicsReport report = GeneralizedAlpha(options).integrate(problem, solver_, own, memory);
    settle(report.fault, report.message);
    return report;
}

}  // namespace ancf::petsc
