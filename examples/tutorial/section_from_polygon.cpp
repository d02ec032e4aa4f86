// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Recipe: a cantilever whose section is a triangle.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/section/polygon.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/statics.hpp>

#include <cmath>
#include <iostream>

int main() {
    const auto steel = ancf::Material::isotropic(2.07e11, 0.3, 7850.0);  // Pa, 1, kg/m^3

    // corners (y, z) in m; the beam's axis runs through (0, 0), here the centroid
    const auto section = ancf::polygon({{-0.01, -0.01}, {-0.01, 0.01}, {0.02, 0.0}})
                             .with_shear_correction(5.0 / 6.0, 5.0 / 6.0);  // k_y, k_z

    ancf::Model model;
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<3>>(model, steel, section,
                                                                     {0, 0, 0}, {1, 0, 0}, 8);
    model.clamp(beam.first());
    model.add(ancf::Force<3>(beam.last(), {0.0, 10.0, 0.0}));  // N, along y

    ancf::EigenLdlt solver;
    const auto report = ancf::solve_statics(model, solver);
    const double deflection = model.position(beam.last())[1];
    const double theory = 10.0 / (3.0 * steel.young * section.moments().yy);  // F L^3/(3 E I)
    std::cout << to_string(report.status) << ", " << deflection << " m, theory " << theory << '\n';

    // I = b h^3/36 of a triangle; the difference is that of shear and of the mesh
    const double moment = 0.02 * std::pow(0.03, 3) / 36.0;
    const bool good = std::abs(section.moments().yy - moment) < 1e-9 * moment &&
                      std::abs(deflection / theory - 1.0) < 5e-3;
    return report.status == ancf::Status::converged && good ? 0 : 1;
}
