// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Step 4 of the tutorial: two beams, a hinge to the ground and a hinge between them.

#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <iostream>

int main() {
    const auto rubber = ancf::Material::isotropic(1e7, 0.3, 1200.0);  // Pa, 1, kg/m^3
    const auto section = ancf::rectangle(0.03, 0.03);                 // m

    ancf::Model model;
    const auto upper = ancf::straight_beam<ancf::CrossSectionBeam<3>>(model, rubber, section,
                                                                      {0, 0, 0}, {0.5, 0, 0}, 2);
    const auto lower = ancf::straight_beam<ancf::CrossSectionBeam<3>>(model, rubber, section,
                                                                      {0.5, 0, 0}, {1, 0, 0}, 2);
    model.add(ancf::Revolute(model, upper.first(), {0, 0, 1}));                // to the ground
    model.add(ancf::Revolute(model, upper.last(), lower.first(), {0, 0, 1}));  // about Z
    model.set_gravity({0.0, -9.81, 0.0});

    ancf::DynamicProblem problem(model);
    ancf::EigenLu solver;
    ancf::GeneralizedAlphaOptions options;
    options.step = 1e-3;  // s
    const auto schedule = ancf::equal_intervals(0.0, 0.3, 0.1);
    const auto report = ancf::GeneralizedAlpha(options).integrate(problem, solver, schedule);

    const ancf::Vector<double, 3> gap =
        model.position(upper.last()) - model.position(lower.first());
    std::cout << to_string(report.status) << ", tip " << model.position(lower.last()).transpose()
              << " m, the hinge is open by " << gap.norm() << " m\n";
    const bool good = gap.norm() < 1e-12 && model.position(lower.last())[1] < -0.3;
    return report.status == ancf::Status::converged && good ? 0 : 1;
}
