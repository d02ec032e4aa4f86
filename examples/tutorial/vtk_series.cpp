// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Recipe: a motion as a series of files for ParaView.

#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/output/vtk.hpp>
#include <ancf/solver/eigen_lu.hpp>

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
    ancf::EigenLu solver;
    ancf::GeneralizedAlphaOptions options;
    options.step = 5e-4;  // s

    ancf::PlanarModel shown(model);                // a copy, to draw the states that are seen
    ancf::VtkSeries series("frames", "pendulum");  // folder, name
    auto schedule = ancf::equal_intervals(0.0, 0.5, 0.05);
    schedule.observe = [&](const ancf::Snapshot& seen) {
        shown.state() = seen.state;
        ancf::Surface surface;
        surface.add(shown, beam, section);
        series.add(seen.state.time, surface);
    };
    const auto report = ancf::GeneralizedAlpha(options).integrate(problem, solver, schedule);
    std::cout << to_string(report.status) << ", open " << series.index().string() << '\n';
    return report.status == ancf::Status::converged && series.size() == 11 ? 0 : 1;
}
