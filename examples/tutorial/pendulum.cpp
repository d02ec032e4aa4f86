// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Step 3 of the tutorial: a beam that falls about a pin, in the plane.

#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <cmath>
#include <iostream>

int main() {
    const auto rubber = ancf::Material::isotropic(0.7e6, 0.3, 5540.0);  // Pa, 1, kg/m^3
    const auto section = ancf::rectangle(0.05, 0.05);                   // m

    ancf::PlanarModel model;
    const auto beam =
        ancf::straight_beam<ancf::CrossSectionBeam<2>>(model, rubber, section, {0, 0}, {1.2, 0}, 4);
    model.pin(beam.first());
    model.set_gravity({0.0, -9.81});  // m/s^2

    ancf::DynamicProblem problem(model);
    ancf::EigenLu solver;  // or ancf::suitesparse::Klu
    ancf::GeneralizedAlphaOptions options;
    options.step = 5e-4;  // s

    double start = 0.0, drift = 0.0;                       // J
    auto schedule = ancf::equal_intervals(0.0, 0.5, 0.1);  // from, for, every; s
    schedule.observe = [&](const ancf::Snapshot& seen) {
        if (seen.state.time == 0.0) start = seen.energies.total();
        drift = std::max(drift, std::abs(seen.energies.total() - start));
        const auto tip = model.value(beam.last(), ancf::Field::r, seen.state.q);
        std::cout << seen.state.time << " s: tip " << tip.transpose() << " m, energy "
                  << seen.energies.total() << " J\n";
    };
    const auto report = ancf::GeneralizedAlpha(options).integrate(problem, solver, schedule);
    std::cout << to_string(report.status) << ", " << report.steps << " steps\n";

    // an independent solution has the tip at y = -1.303 m; the beam weighs 163 N
    const bool good = std::abs(model.position(beam.last())[1] + 1.303) < 1e-3 && drift < 0.1;
    return report.status == ancf::Status::converged && good ? 0 : 1;
}
