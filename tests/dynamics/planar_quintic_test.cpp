// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Planar beams with a quintic centre line in motion: a pendulum's energy and mesh, damping, drag,
/// scales.

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/loads/damping.hpp>
#include <ancf/solver/eigen_solver.hpp>

#include <support/catch.hpp>

#include <cmath>
#include <vector>

namespace planar_quintic_scene_test {

using namespace ancf;
using Quintic = PlanarQuinticBeam<>;
using Cubic = CrossSectionBeam<2>;
using Point = Vector<double, 2>;

const Material rubber = Material::from_moduli(0.7e6, 2.6923e5, 5540.0);

/// A rubber pendulum of length 1.2 let go from the level.
template <class Element>
struct Pendulum {
    PlanarModel scene;
    Beam<Element> beam;

    explicit Pendulum(int elements, typename Element::Options options = {}) {
        beam = straight_beam<Element>(scene, rubber, rectangle(0.05, 0.05), {0, 0}, {1.2, 0},
                                      elements, options);
        scene.pin(beam.first());
        scene.set_gravity({0, -9.81});
    }

    /// Swings, and returns the tip.
    Point swing(DynamicsReport* out = nullptr) {
        DynamicProblem problem(scene);
        EigenLu solver;
        Schedule schedule;
        schedule.end = 0.3;
        EnergyMomentumOptions options;
        options.step = 5e-3;
        const auto report = EnergyMomentum(options).integrate(problem, solver, schedule);
        REQUIRE(report.status == Status::converged);
        if (out != nullptr) *out = report;
        return scene.position(beam.last());
    }
};

TEST_CASE("planar quintic: a swinging pendulum keeps its energy, and few elements are enough",
          "[dynamics][quintic]") {
    DynamicsReport report;
    const Point limit = Pendulum<Quintic>(12).swing();
    const double two = (Pendulum<Quintic>(2).swing(&report) - limit).norm();
    const double four = (Pendulum<Quintic>(4).swing() - limit).norm();
    CHECK(report.energy_drift <= 1e-11 * report.kinetic_largest);
    CrossSectionOptions mixed;
    mixed.rule = Rule::mixed();
    const double cubic = (Pendulum<Cubic>(8, mixed).swing() - limit).norm();
    CAPTURE(two, four, cubic);
    // measured 1.0e-3, 2.0e-4, and 2.4e-3 of eight cubic ones
    CHECK(two <= 1.5e-3);
    CHECK(four <= 3e-4);
    CHECK(two <= 0.6 * cubic);
}

TEST_CASE("planar quintic: bending within an element is no reason to cut a step",
          "[dynamics][quintic]") {
    // a free beam of length 10 that a force and a moment throw: r_xx changes by several tenths of
    // its inverse length in a correction, slopes and positions by far less than allowed
    PlanarModel scene;
    const double depth = std::sqrt(0.6);
    const auto beam = straight_beam<Quintic>(
        scene, Material::from_moduli(1e4 / (depth * depth), 5e3 / (depth * depth), 1.0 / 0.6),
        rectangle(depth, depth), {6, 8}, {0, 0}, 4);
    scene.add(Force<2>(beam.first(), {8, 0}));
    scene.add(PlanarSlopeMoment(beam.first(), Field::r_y, -80));
    DynamicProblem problem(scene);
    EigenLu solver;
    Schedule schedule;
    schedule.end = 0.1;
    EnergyMomentumOptions options;
    options.step = 5e-3;
    const auto report = EnergyMomentum(options).integrate(problem, solver, schedule);
    REQUIRE(report.status == Status::converged);
    CHECK(report.convergence_failures == 0);  // 19 where r_xx counts by the scene's size
    CHECK(report.steps == 20);
    CHECK(report.energy_drift <= 1e-11);
}

TEST_CASE("planar quintic: internal damping takes energy, and a short swing changes little",
          "[dynamics][quintic][damping]") {
    Pendulum<Quintic> pendulum(2);
    add_kelvin_voigt(pendulum.scene, pendulum.beam, 1e-2);
    DynamicsReport report;
    Pendulum<Quintic> free(2);
    const Point damped = pendulum.swing(&report), undamped = free.swing();
    CHECK(report.energy_drift > 5e-3 * report.kinetic_largest);  // 1.1e-2; the free one: 1e-11
    CHECK((damped - undamped).norm() > 1e-4);
    CHECK((damped - undamped).norm() < 0.2);
}

TEST_CASE("planar quintic: scales of coordinates are those of their units", "[dynamics][quintic]") {
    PlanarModel scene;
    const auto beam =
        straight_beam<Quintic>(scene, rubber, rectangle(0.05, 0.05), {0, 0}, {1, 0}, 1);
    const DynamicProblem problem(scene);
    const VectorX scales = problem.scales_of(2.0);
    CHECK(scales[scene.coordinate(beam.last(), Field::r)] == 2.0);
    CHECK(scales[scene.coordinate(beam.last(), Field::r_y)] == 1.0);
    CHECK(scales[scene.coordinate(beam.last(), Field::r_xy)] == 0.5);
    CHECK(scales[scene.coordinate(beam.last(), Field::r_xx)] == 0.5);
}

TEST_CASE("planar quintic: r_xy follows no other vector", "[quintic][bad-input]") {
    PlanarModel scene;
    const auto beam =
        straight_beam<Quintic>(scene, rubber, rectangle(0.05, 0.05), {0, 0}, {1, 0}, 1);
    const NodeId joint = scene.add_node({1, 0});
    CHECK_THROWS_WITH(scene.attach(beam.last(), joint, Field::r_xy), ContainsSubstring("r_xy"));
}

}  // namespace planar_quintic_scene_test
