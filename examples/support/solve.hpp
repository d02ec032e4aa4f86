// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Static solution of scenes of any elements.

#pragma once

#include <ancf/solver/statics.hpp>

#include <support/solver.hpp>

#include <memory>

namespace examples {

/// Brings a model to equilibrium.
template <class Scene>
[[nodiscard]] ancf::StaticsReport solve_scene(Scene& model, const SolverOptions& options) {
    ancf::StaticsOptions statics = options.statics;
    statics.newton = options.newton == "plain"   ? ancf::NewtonKind::plain
                     : options.newton == "mixed" ? ancf::NewtonKind::mixed
                                                 : ancf::NewtonKind::turned;
    const std::unique_ptr<ancf::LinearSolver> solver = linear_solver(options.solver);
    return ancf::solve_statics(model, *solver, statics);
}

template <class Element>
ancf::StaticsReport solve(ancf::Model<Element>& model, const SolverOptions& options) {
    return solve_scene(model, options);
}

}  // namespace examples
