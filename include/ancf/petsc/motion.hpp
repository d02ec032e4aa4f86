// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Motion of one scene by several processes.
///
///     ancf::Model model = ...;                      // the same in every process
///     ancf::petsc::DistributedMotion motion(model, PETSC_COMM_WORLD);
///     const auto report = motion.integrate(ancf::equal_intervals(0.0, 1.0, 0.01));
///     motion.gather();                              // model.state() is the end
///
/// The integrator is GeneralizedAlpha: the same steps, tests and reports, fixed or adaptive.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/petsc/divided_scene.hpp>
#include <ancf/petsc/solver.hpp>

namespace ancf::petsc {

/// The motion of one scene, divided between processes. All calls are collective but part(),
/// solver(), partition() and runs().
class DistributedMotion : public detail::DividedScene {
public:
    /// Divides the scene, which outlives this and is the same in every process. Its state is where
    /// the motion starts.
    /// @param options  of the solver of M + h gamma D + h^2 beta K; M alone is solved by
    ///                 stabilised bi-conjugate gradients, whose options have the prefix and "mass_"
    /// @throws InvalidArgument for a scene with constraints, options that PETSc refuses, or where
    ///         PETSc does not run.
    /// @throws std::runtime_error where it cannot be divided.
    explicit DistributedMotion(Scene& model, MPI_Comm comm = PETSC_COMM_WORLD,
                               const SolverOptions& options = {});

    /// Integrates from the parts' state to the schedule's end, as GeneralizedAlpha::integrate does.
    ///
    /// Status, message and all numbers of the report are the same in every process; the fault's
    /// element counts in the whole scene, in the process that has it. The memory is that of this
    /// process's part: it continues the run of a scene divided in the same way. `observe` sees the
    /// part's state and the whole scene's energies, and may call gathered(); one process whose
    /// `progress` returns false, or that throws, ends all.
    /// @throws InvalidArgument as GeneralizedAlpha::integrate does.
    /// @throws std::runtime_error where another process threw alone.
    [[nodiscard]] DynamicsReport integrate(const Schedule& schedule,
                                           const GeneralizedAlphaOptions& options = {},
                                           const Memory& memory = {});

private:
    Solver mass_solver_;
};

}  // namespace ancf::petsc

#if !defined(ANCF_COMPILED)
#include <ancf/petsc/motion.ipp>  // IWYU pragma: export
#endif
