// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Static equilibrium of one scene by several processes.
///
///     ancf::Model model = ...;                      // the same in every process
///     ancf::petsc::DistributedStatics statics(model, PETSC_COMM_WORLD);
///     const auto report = statics.solve();          // in every process
///     statics.gather();                             // model.state() is the solution
///
/// The iteration is that of solve_statics: the same steps, tests and reports. docs/petsc.md says
/// what a process holds and what it tells the others.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/petsc/divided_scene.hpp>
#include <ancf/petsc/solver.hpp>
#include <ancf/solver/statics.hpp>

namespace ancf::petsc {

/// One scene, divided between processes. All calls are collective but part(), solver(),
/// partition() and runs().
class DistributedStatics : public detail::DividedScene {
public:
    /// Divides the scene, which outlives this and is the same in every process.
    /// @throws InvalidArgument for options that PETSc refuses, or where PETSc does not run.
    /// @throws std::runtime_error where it cannot be divided.
    explicit DistributedStatics(Scene& model, MPI_Comm comm = PETSC_COMM_WORLD,
                                const SolverOptions& options = {})
        : DividedScene(model, comm, options) {}

    /// Brings the parts to equilibrium.
    ///
    /// In the report, reactions are those of the coordinates of this process's part; the fault's
    /// element counts in the whole scene, in the process that has it. Status, message and all other
    /// numbers are the same in every process. Stability is not judged, and NewtonKind::automatic is
    /// iterated as NewtonKind::mixed. The options' `progress` is
    /// called with the part's state; one process that returns false, or throws, ends all.
    /// @throws InvalidArgument for options that cannot be meant, NewtonKind::turned among them:
    ///         its corrections tie all nodes of the scene.
    /// @throws std::runtime_error where a user's function threw in another process.
    [[nodiscard]] StaticsReport solve(const StaticsOptions& options = {});
};

}  // namespace ancf::petsc

#if !defined(ANCF_COMPILED)
#include <ancf/petsc/statics.ipp>  // IWYU pragma: export
#endif
