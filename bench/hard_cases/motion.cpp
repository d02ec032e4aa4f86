// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// Hard motions in space with engineering strains, against Reissner's theory.

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/momentum.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints/joints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <hard_cases/cases.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace hard_cases {

namespace {

using Beam = ancf::CrossSectionBeam<3, ancf::Geodesic, ancf::LinearShear, ancf::EngineeringMeasure>;
using Scene = ancf::Model;
using Point = ancf::Vector<double, 3>;

Row make(std::string name, int elements, double limit) {
    return make_row("geodesic-engineering", "mixed", std::move(name), elements, limit);
}

/// A section given by its radius of gyration and GJ = EI, with rotary inertia of its own.
/// @param inertia  int y^2 dm = int z^2 dm per length over the density, m^4
ancf::Section section(double gyration, double inertia) {
    ancf::Moments moments;
    moments.area = 1.0;
    moments.yy = moments.zz = gyration * gyration;
    ancf::Moments mass = moments;
    mass.yy = mass.zz = inertia;
    return ancf::Section::from_moments(moments)
        .with_shear_correction(1.0, 1.0)
        .with_torsion_constant(moments.yy)
        .with_mass_moments(mass);
}

ancf::CrossSectionOptions options() {
    ancf::CrossSectionOptions result;
    result.rule = ancf::Rule::mixed();
    result.section_model = ancf::SectionModel::saint_venant;
    return result;
}

/// Runs an integrator and fills in what it tells.
template <class Integrator>
void integrate(const Integrator& integrator, ancf::DynamicProblem& problem, Row& row,
               const ancf::Schedule& schedule) {
    ancf::EigenLu solver;
    set(row, integrator.integrate(problem, solver, schedule));
}

/// Simo and Vu-Quoc's right-angle cantilever, struck at its elbow: the tip out of the plane.
void right_angle(Rows& rows, bool quick) {
    Row row = make("right_angle", 2 * (quick ? 4 : 10), quick ? 0.03 : 0.01);
    const double start = now();
    Scene scene;
    const auto material = ancf::Material::from_moduli(1e6, 1e6, 1.0);
    const auto slim = section(std::sqrt(1e-3), 10.0);
    const auto first = ancf::straight_beam<Beam>(scene, material, slim, {0, 0, 0}, {10, 0, 0},
                                                 row.elements / 2, options());
    const auto second = ancf::straight_beam<Beam>(scene, material, slim, {10, 0, 0}, {10, 10, 0},
                                                  row.elements / 2, options());
    scene.clamp(first.first(), ancf::Clamp::free_slope);
    scene.add(ancf::Weld(scene, first.last(), second.first()));
    scene.add(ancf::Force<3>(first.last(), {0, 0, 50}),
              [](double t) { return std::max(0.0, 1.0 - std::abs(t - 1.0)); });
    const std::array<std::pair<double, double>, 3> theory{
        {{5.0, 5.479398}, {10.0, 4.463120}, {15.0, -9.204403}}};
    ancf::Schedule schedule;
    for (const auto& [time, height] : theory)
        if (!quick || time < 6.0) schedule.times.push_back(time);
    schedule.end = quick ? 5.0 : 30.0;
    std::size_t seen = 0;
    schedule.observe = [&](const ancf::Snapshot& at) {
        const double height = at.state.q[scene.coordinate(second.last(), ancf::Field::r) + 2];
        worsen(row.error, std::abs(height / theory.at(seen++).second - 1.0));
    };
    ancf::DynamicProblem problem(scene);
    ancf::GeneralizedAlphaOptions how;
    how.step = 0.025;
    integrate(ancf::GeneralizedAlpha(how), problem, row, schedule);
    if (seen < schedule.times.size()) row.error = 1.0;
    row.seconds = now() - start;
    rows.push_back(row);
}

/// Simo and Vu-Quoc's flying spaghetti: what a free body keeps for 100 s once the loads are gone,
/// and the linear momentum that they gave it.
void spaghetti(Rows& rows, bool quick) {
    Row row = make("flying_spaghetti", 10, 1e-10);
    const double start = now();
    Scene scene;
    const auto beam = ancf::straight_beam<Beam>(scene, ancf::Material::from_moduli(1e4, 1e4, 1.0),
                                                section(std::sqrt(0.05), 10.0), {6, 0, 0},
                                                {0, 8, 0}, 10, options());
    const ancf::Amplitude torque = [](double t) {
        return std::max(0.0, 200.0 - 80.0 * std::abs(t - 2.5));
    };
    scene.add(ancf::Force<3>(beam.first(), {0.1, 0, 0}), torque);
    scene.add(ancf::Moment(beam.first(), {0, 0.5, 1}), torque);
    ancf::DynamicProblem problem(scene);
    ancf::Schedule schedule;
    schedule.end = quick ? 6.0 : 105.0;
    for (double time = 5.0; time <= schedule.end; time += 0.5) schedule.times.push_back(time);
    ancf::Momentum kept;
    double energy = 0.0;
    schedule.observe = [&](const ancf::Snapshot& at) {
        const ancf::Momentum momenta = ancf::momentum(problem, at.state);
        const double total = at.energies.total();
        if (at.state.time == 5.0) {
            kept = momenta;
            energy = total;
        }
        worsen(row.error, (momenta.linear - Point(50, 0, 0)).norm() / 50.0);
        worsen(row.error, (momenta.angular - kept.angular).norm() / kept.angular.norm());
        worsen(row.error, std::abs(total / energy - 1.0));
    };
    ancf::EnergyMomentumOptions how;
    how.step = 0.02;
    integrate(ancf::EnergyMomentum(how), problem, row, schedule);
    row.seconds = now() - start;
    rows.push_back(row);
}

}  // namespace

std::vector<Case> motion_cases() {
    const std::vector<Case> all = {
        {"right_angle", right_angle},
        {"flying_spaghetti", spaghetti},
    };
    return of_element("geodesic-engineering", all);
}

}  // namespace hard_cases
