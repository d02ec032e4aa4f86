// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The options of a static solution, and the solution of a model.

#pragma once

#include <ancf/model/scene.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/solver/statics.hpp>

#include <support/command_line.hpp>

#include <memory>
#include <string>

namespace examples {

/// How a static problem is solved, from the command line.
struct SolverOptions {
    std::string solver;                ///< cholmod or umfpack where SuiteSparse is there, or eigen
    std::string newton = "automatic";  ///< plain, mixed or automatic
    ancf::StaticsOptions statics;

    SolverOptions();
    void add_to(CommandLine& line);
};

/// Returns a linear solver for any matrix.
[[nodiscard]] std::unique_ptr<ancf::LinearSolver> general_solver();

/// Returns the linear solver of integrators that bring none along and have symmetric matrices.
[[nodiscard]] std::unique_ptr<ancf::LinearSolver> motion_solver();

/// Brings a model to equilibrium.
/// @throws InvalidArgument for a linear solver that is not there.
[[nodiscard]] ancf::StaticsReport solve(ancf::Scene& model, const SolverOptions& options);

/// Returns the load steps of a run: those asked for, or those that an adaptive run tried.
[[nodiscard]] inline int steps(const SolverOptions& options, const ancf::StaticsReport& report) {
    return options.statics.adaptive ? static_cast<int>(report.steps.size()) : options.statics.steps;
}

/// Returns the number of unknown coordinates.
[[nodiscard]] inline int free_coordinates(const ancf::Scene& model) {
    const int attached = model.dimension() * static_cast<int>(model.attachments().size());
    return model.layout().size() - static_cast<int>(model.supports().size()) - attached;
}

}  // namespace examples
