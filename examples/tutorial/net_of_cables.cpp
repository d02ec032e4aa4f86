// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Recipe: a net of four cables that meet in the middle, under a load there.

#include <ancf/element/cable/cable.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/statics.hpp>

#include <cmath>
#include <cstddef>
#include <iostream>

int main() {
    const auto steel = ancf::Material::isotropic(2.07e11, 0.3, 7850.0);  // Pa, 1, kg/m^3
    const auto wire = ancf::circle(0.001);                               // radius in m

    ancf::Model model;
    const auto net = ancf::net<ancf::Cable<3>>(
        model, {{steel, wire}},                                        // made of
        {{0, 0, -0.1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},  // joints, m
        {{0, 1, 0, 4}, {0, 2, 0, 4}, {0, 3, 0, 4}, {0, 4, 0, 4}});     // members
    for (std::size_t border = 1; border <= 4; ++border) model.pin(net.joints[border]);
    model.add(ancf::Force<3>(net.joints[0], {0.0, 0.0, -1000.0}));  // N

    ancf::EigenLdlt solver;
    const auto report = ancf::solve_statics(model, solver);
    const double depth = -model.position(net.joints[0])[2];
    std::cout << to_string(report.status) << ", the middle hangs " << depth << " m deep\n";

    // four straight bars: 4 N depth/length = 1000 N
    const double rest = std::hypot(1.0, 0.1), stretch = std::hypot(1.0, depth) / rest;
    const double tension = 2.07e11 * wire.moments().area * 0.5 * (stretch * stretch - 1) * stretch;
    const double carried = 4.0 * tension * depth / std::hypot(1.0, depth);
    const bool good = std::abs(carried - 1000.0) < 1.0;
    return report.status == ancf::Status::converged && good ? 0 : 1;
}
