// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// Hard motions in the plane with engineering strains, against Reissner's theory.

#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/model/constraints_motion.hpp>
#include <ancf/model/constraints_points.hpp>
#include <ancf/solver/eigen_solver.hpp>

#include <hard_cases/planar.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace hard_cases {

namespace {

using namespace planar;
using ancf::Field;

/// Runs generalized-alpha without much damping and fills in what it tells.
void integrate(Scene& scene, Row& row, double step, const ancf::Schedule& schedule) {
    ancf::DynamicProblem<Scene> problem(scene);
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
    const auto beam = ancf::straight_beam(scene, ancf::Material::from_moduli(2.8e7, 1e7, 1.2),
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

/// The paper's rubber pendulum up to 1 s: its tip at three times relative to its length.
void pendulum(Rows& rows, bool quick) {
    Row row = make("pendulum", 16, 2e-3);
    const double start = now();
    Scene scene;
    const auto beam =
        ancf::straight_beam(scene, ancf::Material::from_moduli(0.7e6, 2.6923e5, 5540.0),
                            ancf::rectangle(0.05, 0.05).with_shear_correction(5.0 / 6.0, 5.0 / 6.0),
                            {0, 0}, {1.2, 0}, row.elements, mixed());
    scene.pin(beam.first());
    scene.set_gravity({0.0, -9.81});
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
        row.error = std::max(row.error, (tip - theory[seen++].second).norm() / 1.2);
    };
    integrate(scene, row, 5e-4, schedule);
    if (seen < schedule.times.size()) row.error = 1.0;
    row.seconds = now() - start;
    rows.push_back(row);
}

}  // namespace

std::vector<Case> planar_motion_cases() {
    return {
        {"spin_up", spin_up},
        {"pendulum", pendulum},
    };
}

}  // namespace hard_cases
