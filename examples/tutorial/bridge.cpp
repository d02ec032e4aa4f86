// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Recipe: a trolley runs over a beam that bends under it.

#include <ancf/constants.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>

int main() {
    const double length = 4.0, side = 0.05, mass = 2.0, speed = 20.0, g = 9.81;  // SI units
    const auto steel = ancf::Material::isotropic(2e11, 0.3, 7800.0);
    ancf::PlanarModel model;
    const auto bridge = ancf::straight_beam<ancf::CrossSectionBeam<2>>(
        model, steel, ancf::rectangle(side, side), {0, 0}, {length, 0}, 8,
        ancf::CrossSectionOptions::best());
    model.pin(bridge.first());
    model.fix(bridge.last(), ancf::Field::r, 1);

    // the trolley comes from the left: the guide goes on straight before the bridge
    const auto trolley = model.add_node({-0.1, 0});
    model.add_mass(trolley, mass);
    model.set_rate(trolley, ancf::Field::r, {speed, 0});
    const ancf::Slider<2> slider(trolley, ancf::guide_along(model, bridge));
    model.add(slider);
    // only the trolley is heavy here
    model.add(ancf::Force<2>(trolley, {0, -mass * g}));

    ancf::DynamicProblem problem(model);
    ancf::EigenLu solver;
    auto schedule = ancf::equal_intervals(0.0, (length + 0.1) / speed, 1e-3);
    double most = 0.0, station = 0.0;
    schedule.observe = [&](const ancf::Snapshot& seen) {
        const double sag = -model.value(bridge.node(4), ancf::Field::r, seen.state.q)[1];
        if (sag > most) station = slider.station(model, seen.state.q);
        most = std::max(most, sag);
    };
    const auto report = ancf::RadauIIA().integrate(problem, solver, schedule);
    std::cout << to_string(report.status) << ", the middle sags by " << 1e3 * most
              << " mm at the most, with the trolley on element " << station << "\n";

    // a force that runs over a beam, first mode: its frequency w, the force's angular speed a w
    const double stiffness = 2e11 * std::pow(side, 4) / 12.0, line = 7800.0 * side * side;
    const double wave = ancf::pi / length, w = wave * wave * std::sqrt(stiffness / line);
    const double a = wave * speed / w;
    double expected = 0.0;
    for (double t = 0.0; t < length / speed; t += 1e-4)
        expected = std::max(expected, std::sin(a * w * t) - a * std::sin(w * t));
    expected *= 2.0 * mass * g / (length * line * w * w * (1.0 - a * a));
    const bool good = std::abs(most - expected) < 0.05 * expected;
    std::cout << "a force without mass: " << 1e3 * expected << " mm\n";
    return report.status == ancf::Status::converged && good ? 0 : 1;
}
