// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// A planar pendulum, one integrator, and a linear solver of a library unless another one is named.

#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints/points.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>

#ifndef SOLVER
#include <ancf/suitesparse/klu.hpp>
#define SOLVER ancf::suitesparse::Klu
#endif

int main() {
    using Scene = ancf::PlanarModel;
    Scene model;
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<2>>(
        model, ancf::Material::isotropic(7e5, 0.3, 5540.0), ancf::rectangle(0.05, 0.05), {0, 0},
        {1.2, 0}, 4);
    model.add(ancf::Pin<2>(beam.first(), {0.0, 0.0}));
    model.set_gravity({0.0, -9.81});
    ancf::DynamicProblem problem(model);
    SOLVER solver;
    const auto report = ancf::GeneralizedAlpha(ancf::GeneralizedAlphaOptions{})
                            .integrate(problem, solver, ancf::equal_intervals(0.0, 0.1, 0.05));
    return report.status == ancf::Status::converged ? 0 : 1;
}
