// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/constants.hpp>
#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <support/catch.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace slope_moment_test {

using ancf::Field;
using Scene = ancf::PlanarModel;
using Problem = ancf::DynamicProblem;

/// A steel strip with a moment on its last slope, free or clamped at its other end.
Scene strip(double moment, bool clamped) {
    Scene model;
    const auto beam =
        ancf::straight_beam<ancf::Cable<2>>(model, ancf::Material::isotropic(2.07e11, 0.3, 7850.0),
                                            ancf::rectangle(0.01, 0.01), {0.0, 0.0}, {1.0, 0.0}, 2);
    if (clamped) model.clamp(beam.first());
    model.add(ancf::PlanarSlopeMoment(beam.last(), Field::r_x, moment));
    return model;
}

ancf::Schedule until(double end) {
    ancf::Schedule schedule;
    schedule.end = end;
    return schedule;
}

/// Moves a scene from rest by energy-momentum, which keeps the energy of a load with a potential.
void check_energy_kept(ancf::Scene& model) {
    Problem problem(model);
    ancf::EigenLu solver;
    const auto report = ancf::EnergyMomentum().integrate(problem, solver, until(0.1));
    CAPTURE(report.message, report.kinetic_largest);
    REQUIRE(report.status == ancf::Status::converged);
    CHECK(report.kinetic_largest > 0.5);
    CHECK(report.energy_drift <= 1e-10);  // J; 2e-12 measured, without the potential 4.2 and more
}

TEST_CASE("PlanarSlopeMoment: energy-momentum keeps the energy of a strip that it bends",
          "[dynamics][load]") {
    Scene model = strip(20.0, true);
    check_energy_kept(model);
}

TEST_CASE("SlopeMoment: energy-momentum keeps the energy of a strip that it bends in space",
          "[dynamics][load]") {
    const ancf::Vector<double, 3> start(0.0, 0.0, 0.0), end(0.6, 0.8, 0.0);
    // across the strip, and so that its slope has a part along the axis
    for (const ancf::Vector<double, 3>& axis :
         {ancf::Vector<double, 3>(0.8, -0.6, 1.0), ancf::Vector<double, 3>(1.0, 2.0, 2.0)}) {
        CAPTURE(axis.transpose());
        ancf::Model model;
        const auto beam = ancf::straight_beam<ancf::Cable<3>>(
            model, ancf::Material::isotropic(2.07e11, 0.3, 7850.0), ancf::rectangle(0.01, 0.01),
            start, end, 2);
        model.clamp(beam.first());
        model.add(ancf::SlopeMoment(beam.last(), Field::r_x, axis, 20.0));
        check_energy_kept(model);
    }
}

TEST_CASE("PlanarSlopeMoment: its potential counts the turns of a free strip", "[dynamics][load]") {
    constexpr double moment = 20.0;
    const auto check = [](const auto& integrator, double drift) {
        Scene model = strip(moment, false);
        Problem problem(model);
        ancf::EigenLu solver;
        ancf::Schedule schedule = ancf::equal_intervals(0.0, 0.4, 0.01);
        double before = 0.0, fall = 0.0;
        int later = 0;
        schedule.observe = [&](const ancf::Snapshot& at) {
            if (later++ > 0) fall = std::max(fall, before - at.energies.potential);
            before = at.energies.potential;
        };
        const auto report = integrator.integrate(problem, solver, schedule);
        CAPTURE(report.message, report.kinetic_largest);
        REQUIRE(report.status == ancf::Status::converged);
        CHECK(later == 41);
        // three turns and more, no jump between two of the 40 times
        CHECK(before < -3.0 * 2.0 * ancf::pi * moment);
        CHECK(fall < ancf::pi * moment);
        CHECK(report.energy_drift <= drift * report.kinetic_largest);
    };
    check(ancf::EnergyMomentum(), 1e-12);  // 1e-14 measured
    // it damps the vibrations that the sudden load starts; 6e-3 measured
    check(ancf::GeneralizedAlpha(), 1e-2);
}

TEST_CASE("PlanarSlopeMoment: its potential counts turns between outputs that are far apart",
          "[dynamics][load]") {
    std::vector<double> totals[2];
    for (const bool follows : {true, false}) {
        Scene model = strip(20.0, false);
        Problem problem(model);
        ancf::EigenLu solver;
        ancf::EnergyMomentumOptions options;
        options.follow_energy = follows;
        ancf::Schedule schedule = ancf::equal_intervals(0.0, 0.4, 0.2);
        schedule.observe = [&](const ancf::Snapshot& at) {
            totals[follows ? 1 : 0].push_back(at.energies.total());
        };
        const auto report = ancf::EnergyMomentum(options).integrate(problem, solver, schedule);
        CAPTURE(follows, report.message);
        REQUIRE(report.status == ancf::Status::converged);
    }
    CHECK(totals[0].size() == 3);
    CHECK(totals[0] == totals[1]);  // to the bit: outputs do not change the run
}

TEST_CASE("PlanarSlopeMoment: a run that goes on by a memory keeps the turns of its potential",
          "[dynamics][load]") {
    constexpr double moment = 20.0, cut = 0.3, end = 0.32;  // s; two turns and more by then
    const auto check = [](const auto& integrator) {
        const auto run = [&](Scene& model, double until_time, const ancf::Memory& memory = {}) {
            Problem problem(model);
            ancf::EigenLu solver;
            double potential = 0.0;
            ancf::Schedule schedule = until(until_time);
            schedule.times = {until_time};
            schedule.observe = [&](const ancf::Snapshot& at) { potential = at.energies.potential; };
            const auto report = integrator.integrate(problem, solver, schedule, memory);
            CAPTURE(report.message);
            REQUIRE(report.status == ancf::Status::converged);
            return std::pair(potential, report.memory);
        };
        Scene whole = strip(moment, false), parts = strip(moment, false);
        const double expected = run(whole, end).first;
        CHECK(expected < -2.0 * 2.0 * ancf::pi * moment);
        // its steps are the same to the bit
        CHECK(run(parts, end, run(parts, cut).second).first == expected);
    };
    check(ancf::EnergyMomentum());
    check(ancf::GeneralizedAlpha());
    ancf::RadauOptions fixed;
    fixed.tolerance = 0.0;
    check(ancf::RadauIIA(fixed));
}

}  // namespace slope_moment_test
