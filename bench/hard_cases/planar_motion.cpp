// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// Hard motions in the plane with engineering strains, against Reissner's theory, and the paper's
// pendulum with Green's.

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/model/constraints/motion.hpp>
#include <ancf/model/constraints/points.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <hard_cases/planar.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace hard_cases {

namespace {

using namespace planar;
using ancf::Field;

/// Runs generalized-alpha without much damping and fills in what it tells.
void integrate(ancf::Scene& scene, Row& row, double step, const ancf::Schedule& schedule) {
    ancf::DynamicProblem problem(scene);
    ancf::GeneralizedAlphaOptions options;
    options.step = step;
    options.rho = 0.9;
    options.follow_energy = false;
    ancf::EigenLu solver;
    set(row, ancf::GeneralizedAlpha(options).integrate(problem, solver, schedule));
}

/// Kane's beam, turned at its end up to 6 rad/s in 15 s: how far the tip stays behind.
void spin_up(Rows& rows, bool quick) {
    Row row = make("spin_up", 10, 2e-3);
    const double start = now();
    Scene scene;
    ancf::Moments moments;
    moments.area = 1.0;
    moments.yy = moments.zz = 5e-4;
    const auto section =
        ancf::Section::from_moments(moments).with_shear_correction(1.0, 1.0).with_torsion_constant(
            1e-3);
    const auto beam = ancf::straight_beam<Beam>(scene, ancf::Material::from_moduli(2.8e7, 1e7, 1.2),
                                                section, {0, 0}, {10, 0}, row.elements, mixed());
    constexpr double rate = 2.0 * pi / 15.0;
    const auto angle = [](double t) {
        return t <= 15.0 ? 0.4 * (0.5 * t * t + (std::cos(rate * t) - 1.0) / (rate * rate))
                         : 6.0 * t - 45.0;
    };
    const auto speed = [](double t) {
        return t <= 15.0 ? 0.4 * (t - std::sin(rate * t) / rate) : 6.0;
    };
    const auto acceleration = [](double t) {
        return t <= 15.0 ? 0.4 * (1.0 - std::cos(rate * t)) : 0.0;
    };
    scene.pin(beam.first());
    // r_y turns: (-sin, cos), its rates by the chain rule
    for (int k = 0; k < 2; ++k) {
        const double quarter = k == 0 ? 0.5 * pi : 0.0;  // -sin a = cos(a + pi/2)
        const auto value = [=](double t) { return std::cos(angle(t) + quarter); };
        const auto first = [=](double t) { return -std::sin(angle(t) + quarter) * speed(t); };
        const auto second = [=](double t) {
            return -std::cos(angle(t) + quarter) * speed(t) * speed(t) -
                   std::sin(angle(t) + quarter) * acceleration(t);
        };
        scene.add(ancf::FixedCoordinate<2>(beam.first(), Field::r_y, k, {value, first, second}));
    }
    // the tip is farthest behind at 6.8 s
    double behind = 0.0;
    ancf::Schedule schedule = ancf::equal_intervals(0.0, quick ? 7.5 : 20.0, 0.05);
    schedule.observe = [&](const ancf::Snapshot& at) {
        const double turn = angle(at.state.time);
        const Plane tip = at.state.q.segment<2>(scene.coordinate(beam.last(), Field::r));
        behind = std::min(behind, -tip[0] * std::sin(turn) + tip[1] * std::cos(turn));
    };
    integrate(scene, row, 0.0125, schedule);
    row.error = std::abs(behind / -0.573761 - 1.0);
    row.seconds = now() - start;
    rows.push_back(row);
}

/// Adds a pendulum of square section, pinned and under gravity.
template <class Element>
ancf::Beam<Element> make_pendulum(ancf::PlanarModel& scene, const ancf::Material& material,
                                  double height, double length, int elements) {
    const auto section =
        ancf::rectangle(height, height).with_shear_correction(5.0 / 6.0, 5.0 / 6.0);
    const auto beam = ancf::straight_beam<Element>(scene, material, section, {0, 0}, {length, 0},
                                                   elements, mixed());
    scene.pin(beam.first());
    scene.set_gravity({0.0, -9.81});
    return beam;
}

/// Adds the paper's.
template <class Element>
ancf::Beam<Element> rubber_pendulum(ancf::PlanarModel& scene, int elements) {
    return make_pendulum<Element>(scene, ancf::Material::from_moduli(0.7e6, 2.6923e5, 5540.0), 0.05,
                                  1.2, elements);
}

/// Runs the energy-momentum scheme and fills in the energy that the scene gains or loses, relative
/// to the largest kinetic energy.
void keep_energy(Scene& scene, Row& row, double step, double duration) {
    ancf::DynamicProblem problem(scene);
    ancf::EnergyMomentumOptions options;
    options.step = step;
    ancf::EigenLu solver;
    ancf::Schedule schedule;
    schedule.end = duration;
    schedule.pass_degenerate = true;  // energy is kept where a coarse mesh folds too
    const auto report = ancf::EnergyMomentum(options).integrate(problem, solver, schedule);
    set(row, report);
    row.error = report.energy_drift / report.kinetic_largest;
}

/// The paper's rubber pendulum up to 1 s: its tip at three times relative to its length.
void pendulum(Rows& rows, bool quick) {
    Row row = make("pendulum", 16, 2e-3);
    const double start = now();
    Scene scene;
    const auto beam = rubber_pendulum<Beam>(scene, row.elements);
    const std::array<std::pair<double, Plane>, 3> theory{{
        {0.3, {1.087608741, -0.445045527}},
        {0.5, {0.374397683, -1.305257813}},
        {1.0, {-1.218647154, -0.238806259}},
    }};
    ancf::Schedule schedule;
    for (const auto& [time, tip] : theory)
        if (!quick || time < 1.0) schedule.times.push_back(time);
    schedule.end = schedule.times.back();
    std::size_t seen = 0;
    schedule.observe = [&](const ancf::Snapshot& at) {
        const Plane tip = at.state.q.segment<2>(scene.coordinate(beam.last(), Field::r));
        worsen(row.error, (tip - theory.at(seen++).second).norm() / 1.2);
    };
    integrate(scene, row, 5e-4, schedule);
    if (seen < schedule.times.size()) row.error = 1.0;
    row.seconds = now() - start;
    rows.push_back(row);
}

/// The same with Green's strain: tip relative to its length, kinetic, strain and potential energy
/// relative to what the paper's element tends to.
void green_pendulum(Rows& rows, bool quick) {
    struct Instant {
        double time;
        Plane tip;
        double kinetic, strain, potential;
    };
    const std::array<Instant, 5> theory{{
        {0.1, {1.200000, -0.049050}, 7.368997, 0.222992, -7.591988},
        {0.3, {1.082058, -0.446681}, 51.421438, 4.064134, -55.485572},
        {0.5, {0.337547, -1.301135}, 88.853499, 19.169309, -108.022808},
        {0.7, {-0.696049, -1.011694}, 83.657632, 4.968009, -88.625640},
        {1.0, {-1.188550, -0.128545}, 17.764223, 0.962546, -18.726769},
    }};
    const double start = now();
    ancf::PlanarModel scene;
    const auto beam = rubber_pendulum<ancf::CrossSectionBeam<2>>(scene, 32);
    double tip = 0.0, kinetic = 0.0, strain = 0.0, potential = 0.0;
    ancf::Schedule schedule;
    for (const Instant& instant : theory)
        if (!quick || instant.time < 1.0) schedule.times.push_back(instant.time);
    schedule.end = schedule.times.back();
    std::size_t seen = 0;
    schedule.observe = [&](const ancf::Snapshot& at) {
        const Instant& expected = theory.at(seen++);
        const Plane place = at.state.q.segment<2>(scene.coordinate(beam.last(), Field::r));
        worsen(tip, (place - expected.tip).norm() / 1.2);
        worsen(kinetic, std::abs(at.energies.kinetic / expected.kinetic - 1.0));
        worsen(strain, std::abs(at.energies.strain / expected.strain - 1.0));
        worsen(potential, std::abs(at.energies.potential / expected.potential - 1.0));
    };
    Row run;
    integrate(scene, run, 5e-4, schedule);
    const std::array<std::tuple<const char*, double, double>, 4> results{{
        {"pendulum_green", tip, 3e-4},
        {"pendulum_green_kinetic", kinetic, 1e-4},
        {"pendulum_green_strain", strain, 1e-3},
        {"pendulum_green_potential", potential, 1e-4},
    }};
    for (const auto& [name, error, limit] : results) {
        Row row = make_row("planar", "mixed", name, 32, limit);
        row.iterations = run.iterations;
        row.steps = run.steps;
        row.status = run.status;
        row.error = seen < schedule.times.size() ? 1.0 : error;
        row.seconds = now() - start;
        rows.push_back(row);
    }
}

/// The paper's rubber pendulum for 100 s: the energy that it gains or loses.
void long_pendulum(Rows& rows, bool quick) {
    Row row = make("pendulum_100_s", 8, 1e-10);
    const double start = now();
    Scene scene;
    rubber_pendulum<Beam>(scene, row.elements);
    keep_energy(scene, row, 5e-3, quick ? 2.0 : 100.0);
    row.seconds = now() - start;
    rows.push_back(row);
}

/// A pendulum of steel, its length 200 times its depth: the energy that it gains or loses.
void steel_pendulum(Rows& rows, bool quick) {
    Row row = make("pendulum_steel", 4, 1e-10);
    const double start = now();
    Scene scene;
    make_pendulum<Beam>(scene, ancf::Material::from_moduli(2.07e11, 7.9615e10, 7850.0), 0.01, 2.0,
                        row.elements);
    keep_energy(scene, row, 1e-3, quick ? 0.3 : 1.2);
    row.seconds = now() - start;
    rows.push_back(row);
}

/// A linkage of three steel bars that falls from its side, every joint stated twice: how far the
/// middle of its coupler is from where it falls with the joints stated once.
void redundant(Rows& rows, bool quick) {
    Row row = make("four_bar_redundant", 6, 1e-9);
    const double start = now();
    const auto fall = [&](int times, Plane& place) {
        Scene scene;
        const auto steel = ancf::Material::isotropic(2e11, 0.3, 7800.0);
        const auto bar = [&](const Plane& from, const Plane& to) {
            return ancf::straight_beam<ancf::CrossSectionBeam<2>>(
                scene, steel, ancf::rectangle(0.01, 0.01), from, to, row.elements / 3, mixed());
        };
        const auto crank = bar({0, 0}, {0, 0.2}), coupler = bar({0, 0.2}, {0.5, 0.35}),
                   rocker = bar({0.5, 0.35}, {0.4, 0});
        for (int k = 0; k < times; ++k) {
            scene.add(ancf::Pin<2>(crank.first(), Plane(0, 0)));
            scene.add(ancf::Pin<2>(crank.last(), coupler.first()));
            scene.add(ancf::Pin<2>(coupler.last(), rocker.first()));
            scene.add(ancf::Pin<2>(rocker.last(), Plane(0.4, 0)));
        }
        scene.set_gravity({9.81, 0.0});
        ancf::ProblemOptions twice;
        twice.redundancy = ancf::Redundancy::minimum_norm;
        ancf::DynamicProblem problem(scene, twice);
        ancf::GeneralizedAlphaOptions options;
        options.step = 1e-3;
        ancf::EigenLu solver;
        ancf::Schedule schedule;
        schedule.end = quick ? 0.1 : 1.0;
        set(row, ancf::GeneralizedAlpha(options).integrate(problem, solver, schedule));
        place = scene.position(coupler.nodes[coupler.nodes.size() / 2]);
    };
    Plane once, often;
    fall(1, once);
    fall(2, often);
    row.error = (often - once).norm() / 0.4;
    row.seconds = now() - start;
    rows.push_back(row);
}

}  // namespace

std::vector<Case> planar_motion_cases() {
    std::vector<Case> all = {
        {"spin_up", spin_up},
        {"pendulum", pendulum},
        {"pendulum_100_s", long_pendulum},
        {"pendulum_steel", steel_pendulum},
        {"four_bar_redundant", redundant},
    };
    all = of_element("planar-engineering", all);
    all.push_back({"pendulum_green", green_pendulum, "planar"});
    return all;
}

}  // namespace hard_cases
