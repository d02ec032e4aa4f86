// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Recipe: the load under which a portal with clamped feet buckles aside.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/modal.hpp>

#include <cmath>
#include <iostream>

int main() {
    const auto steel = ancf::Material::isotropic(2.07e11, 0.3, 7850.0);  // Pa, 1, kg/m^3
    const auto section = ancf::rectangle(0.02, 0.01);                    // width along Z, height

    ancf::Model model;
    const auto portal = ancf::frame<ancf::CrossSectionBeam<3>>(
        model, {{steel, section}}, {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}},
        {{0, 1, 0, 8}, {1, 2, 0, 8}, {2, 3, 0, 8}});
    model.clamp(portal.joints[0]);
    model.clamp(portal.joints[3]);
    for (const auto top : {1U, 2U})  // 1 N down on each post: the factor is the load in N
        model.add(ancf::Force<3>(portal.joints[top], {0.0, -1.0, 0.0}));

    ancf::EigenLdlt solver;
    ancf::ModalOptions options;
    options.count = 2;
    const auto report = ancf::buckling_modes(model, solver, options);
    if (report.status != ancf::Status::converged) {
        std::cout << report.message << '\n';
        return 1;
    }
    const double load = report.modes[0].value;
    std::cout << "each post buckles under " << load << " N\n";

    // posts and girder alike, as long as each other, neither shear nor stretch: P = x^2 E I/h^2 of
    // the first root of x cos x = -6 sin x
    const double ratio = load / (steel.young * section.moments().yy);
    return std::abs(ratio - 7.379) < 0.01 ? 0 : 1;
}
