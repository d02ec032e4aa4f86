// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Step 5 of the tutorial: a portal of three members that are joined rigidly, pushed sideways.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/statics.hpp>

#include <cmath>
#include <iostream>

int main() {
    const auto steel = ancf::Material::isotropic(2e11, 0.3, 7850.0);
    const auto post = ancf::rectangle(0.1, 0.1), girder = ancf::rectangle(0.1, 0.2);

    ancf::Model model;
    const auto portal = ancf::frame<ancf::CrossSectionBeam<3>>(
        model, {{steel, post}, {steel, girder}},       // what members are made of
        {{0, 0, 0}, {0, 3, 0}, {4, 3, 0}, {4, 0, 0}},  // joints, m
        {{0, 1, 0, 4}, {1, 2, 1, 4}, {2, 3, 0, 4}});   // from, to, made of, elements
    model.clamp(portal.joints[0]);
    model.clamp(portal.joints[3]);
    model.add(ancf::Force<3>(portal.joints[1], {10e3, 0, 0}));  // N

    ancf::EigenLdlt solver;
    const auto report = ancf::solve_statics(model, solver);
    const double sway = model.position(portal.joints[1])[0];
    std::cout << to_string(report.status) << ", sway " << 1e3 * sway << " mm\n";

    // of members that neither shear nor stretch: F h^3/(24 E I) (6 k + 4)/(6 k + 1) = 7.30 mm
    return report.status == ancf::Status::converged && std::abs(sway - 7.33e-3) < 1e-5 ? 0 : 1;
}
