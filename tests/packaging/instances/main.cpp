// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Solves a cantilever without compiling element, assembly and solver; small load, so that the tip
/// follows P L^3/(3 E I).

#include "scene.hpp"

#include <cmath>
#include <iostream>

int main() {
    const auto steel = ancf::Material::isotropic(2.0e11, 0.3, 7850.0);  // Pa, 1, kg/m^3
    ancf::Model<ancf::CrossSectionBeam<2>> model;
    const auto beam =
        ancf::straight_beam(model, steel, ancf::rectangle(0.01, 0.01), {0, 0}, {1, 0}, 4);
    model.clamp(beam.first());
    model.add(ancf::Force<2>(beam.last(), {0.0, 1e-2}));  // N

    ancf::EigenLdlt solver;
    const auto report = ancf::solve_statics(model, solver);
    const double tip = model.position(beam.last())[1];
    const double expected = 1e-2 / (3.0 * 2.0e11 * 1e-8 / 12.0);
    std::cout << to_string(report.status) << ", tip " << tip << ", expected " << expected << '\n';
    // shear adds 7e-5 of it
    const bool good = std::abs(tip - expected) <= 1e-3 * expected;
    return report.status == ancf::Status::converged && good ? 0 : 1;
}
