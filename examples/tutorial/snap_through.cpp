// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Recipe: the path of a deep arch beyond the load that it can bear.

#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/path.hpp>

#include <cmath>
#include <iostream>

int main() {
    const auto rubber = ancf::Material::isotropic(1.2e8, 0.0, 1000.0);  // Pa, 1, kg/m^3
    const auto section = ancf::rectangle(0.01, 0.01);                   // width, height, m
    const double radius = 1.0, angle = 215.0 * ancf::pi / 180.0;

    ancf::PlanarModel model;
    const auto arch = ancf::arc<ancf::CrossSectionBeam<2>>(
        model, rubber, section, {0, 0}, {std::cos(0.5 * angle), std::sin(0.5 * angle)}, radius,
        -angle, 32);
    model.clamp(arch.first());
    model.pin(arch.last());
    const auto crown = arch.nodes[16];
    model.add(ancf::Force<2>(crown, {0.0, -1.0}));  // N: the load factor is the load

    ancf::PathOptions options;
    options.progress = [&](const ancf::PathPoint&, const ancf::State& state) {
        // the path ends where the crown is as low as the supports
        return model.value(crown, ancf::Field::r, state.q)[1] > 0.0;
    };
    ancf::EigenLdlt solver;
    const auto report = ancf::follow_path(model, solver, options);
    if (report.status != ancf::Status::stopped || report.critical.empty()) {
        std::cout << to_string(report.status) << ": " << report.message << '\n';
        return 1;
    }
    std::cout << "the load turns round at";
    for (const auto& point : report.critical) std::cout << ' ' << point.factor << " N";
    std::cout << '\n';

    // an arch that neither shears nor stretches bears 8.97 E I/R^2 (DaDeppo and Schmidt, 1975)
    const double rigidity = rubber.young * section.moments().yy / (radius * radius);
    return std::abs(report.critical[0].factor / rigidity - 8.97) < 0.05 ? 0 : 1;
}
