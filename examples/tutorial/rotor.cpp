// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Recipe: a shaft with an eccentric disc runs up through its critical speed.

#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/rigid_body.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads/damping.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/modal.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>

int main() {
    const auto steel = ancf::Material::isotropic(2.07e11, 0.3, 7850.0);  // Pa, 1, kg/m^3
    ancf::Model model;
    const auto shaft = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
        model, steel, ancf::circle(0.005), {0, 0, 0}, {1, 0, 0}, 4,
        ancf::CrossSectionOptions::best());

    // a disc of 10 kg, its centre of mass 1 mm beside the shaft
    const double eccentricity = 1e-3;
    const auto disc = model.add_node({0.5, 0, 0});
    ancf::add_body(model, disc, 10.0, ancf::Vector<double, 3>(0.02, 0.01, 0.01).asDiagonal(),
                   {0, eccentricity, 0});
    model.attach(shaft.node(2), disc);
    ancf::add_drag(model, shaft, 200.0);  // N s/m^2

    // a motor turns the first end, up to 100 rad/s in one second: the node turns by -angle; the
    // other end slides in a bearing that keeps its direction
    const double speed = 100.0;  // rad/s
    const auto rate = [=](double t) { return t < 1.0 ? speed * t * t * (3.0 - 2.0 * t) : speed; };
    const ancf::Motion angle{
        [=](double t) {
            return -(t < 1.0 ? speed * t * t * t * (1.0 - 0.5 * t) : speed * (t - 0.5));
        },
        [=](double t) { return -rate(t); },
        [=](double t) { return t < 1.0 ? -6.0 * speed * t * (1.0 - t) : 0.0; }};
    model.add(ancf::DrivenRevolute(model, shaft.first(), {1, 0, 0}, angle));
    model.add(ancf::PointOnLine<3>(shaft.last(), {1, 0, 0}, {1, 0, 0}));
    model.add(ancf::AlignedTangent(model, shaft.last()));

    ancf::EigenLu solver;
    // at mid-span the disc does not tilt: the critical speed is the frequency at rest
    ancf::ModalOptions modal;
    modal.count = 1;
    const double critical = std::sqrt(ancf::natural_modes(model, solver, modal).modes[0].value);

    ancf::DynamicProblem problem(model);
    auto schedule = ancf::equal_intervals(0.0, 2.0, 1e-3);
    double largest = 0.0, last = 0.0;  // distance of the shaft from its axis, m
    schedule.observe = [&](const ancf::Snapshot& seen) {
        const auto place = model.value(disc, ancf::Field::r, seen.state.q);
        last = std::hypot(place[1], place[2]);
        largest = std::max(largest, last);
    };
    const auto report = ancf::RadauIIA().integrate(problem, solver, schedule);
    std::cout << to_string(report.status) << ", critical speed " << critical
              << " rad/s, the shaft at most " << 1e3 * largest << " mm off its axis, at the end "
              << 1e3 * last << " mm\n";

    // beyond the critical speed the disc turns about its centre of mass: Jeffcott's rotor
    const double ratio = critical / speed, expected = eccentricity / (1.0 - ratio * ratio);
    const bool good = std::abs(last - expected) < 0.05 * expected;
    return report.status == ancf::Status::converged && good ? 0 : 1;
}
