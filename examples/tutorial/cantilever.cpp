// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Step 2 of the tutorial: a cantilever, bent by a force at its tip.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/statics.hpp>

#include <cmath>
#include <iostream>

int main() {
    const auto steel = ancf::Material::isotropic(2.07e11, 0.3, 7850.0);  // Pa, 1, kg/m^3
    const auto section = ancf::rectangle(0.01, 0.01);                    // width, height in m

    ancf::Model model;
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<3>>(model, steel, section,
                                                                     {0, 0, 0}, {2, 0, 0}, 8);
    model.clamp(beam.first());
    model.add(ancf::Force<3>(beam.last(), {0.0, 64.7, 0.0}));  // N, keeps its direction

    ancf::EigenLdlt solver;  // or ancf::suitesparse::Cholmod
    const auto report = ancf::solve_statics(model, solver);
    const auto tip = model.position(beam.last());
    std::cout << to_string(report.status) << ", tip " << tip.transpose() << " m\n";

    // the paper's Table 1 has (1.784, 0.821)
    const bool good = std::abs(tip[0] - 1.784) < 2e-3 && std::abs(tip[1] - 0.821) < 2e-3;
    return report.status == ancf::Status::converged && good ? 0 : 1;
}
