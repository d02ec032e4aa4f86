// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Recipe: a beam whose root is turned by a quarter of a turn.

#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <cmath>
#include <iostream>

int main() {
    const auto steel = ancf::Material::isotropic(2.07e11, 0.3, 7850.0);  // Pa, 1, kg/m^3
    ancf::Model model;
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
        model, steel, ancf::rectangle(0.03, 0.03), {0, 0, 0}, {2, 0, 0}, 4);

    // the node turns by -angle about Z: from 0 to pi/2 in two seconds, smoothly
    const double w = ancf::pi / 2.0;  // rad/s
    const ancf::Motion angle{[=](double t) { return -ancf::pi / 4.0 * (1.0 - std::cos(w * t)); },
                             [=](double t) { return -ancf::pi / 4.0 * w * std::sin(w * t); },
                             [=](double t) { return -ancf::pi / 4.0 * w * w * std::cos(w * t); }};
    model.add(ancf::DrivenRevolute(model, beam.first(), {0, 0, 1}, angle));  // about Z

    ancf::DynamicProblem problem(model);
    ancf::EigenLu solver;  // joints bring multipliers
    ancf::GeneralizedAlphaOptions options;
    options.step = 1e-3;  // s
    const auto schedule = ancf::equal_intervals(0.0, 2.0, 0.5);
    const auto report = ancf::GeneralizedAlpha(options).integrate(problem, solver, schedule);
    const auto tip = model.position(beam.last());
    std::cout << to_string(report.status) << ", tip " << tip.transpose() << " m\n";

    const bool good = std::abs(tip[0]) < 2e-3 && std::abs(tip[1] - 2.0) < 2e-3;
    return report.status == ancf::Status::converged && good ? 0 : 1;
}
