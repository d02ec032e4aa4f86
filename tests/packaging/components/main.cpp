// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Solves a cantilever with CHOLMOD; small load, so that the tip follows P L^3/(3 E I).

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/statics.hpp>
#include <ancf/suitesparse/cholmod.hpp>

#include <cmath>
#include <iostream>
#include <string>

std::string refusal_of_ida();

int main() {
    const auto steel = ancf::Material::isotropic(2.0e11, 0.3, 7850.0);
    const auto section = ancf::rectangle(0.01, 0.01);
    ancf::Model model;
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<3>>(model, steel, section,
                                                                     {0, 0, 0}, {1, 0, 0}, 8);
    model.clamp(beam.first());
    model.add(ancf::Force<3>(beam.last(), {0.0, 1e-2, 0.0}));

    ancf::suitesparse::Cholmod solver;
    const auto report = ancf::solve_statics(model, solver);
    const double tip = model.position(beam.last())[1];
    const double expected = 1e-2 / (3.0 * 2.0e11 * 1e-8 / 12.0);
    std::cout << to_string(report.status) << ", tip " << tip << ", expected " << expected << '\n';
    if (report.status != ancf::Status::converged) return 1;
    if (!(std::abs(tip - expected) <= 5e-3 * expected)) return 1;

    const std::string refusal = refusal_of_ida();
    std::cout << "refused: " << refusal << '\n';
    return refusal.find("tolerance") == std::string::npos ? 1 : 0;
}
