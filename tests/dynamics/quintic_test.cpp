// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Beams with a quintic centre line in whole scenes: moving, along a path, saved, joined to cubics.

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/momentum.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/output/state_file.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/path.hpp>
#include <ancf/solver/statics.hpp>

#include <dynamics/scenes.hpp>
#include <support/catch.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace quintic_scene_test {

using namespace ancf::test;
using ancf::Field;
using ancf::Status;
using Quintic = ancf::QuinticBeam<>;
using Cubic = ancf::CrossSectionBeam<3, ancf::Geodesic>;
using Scene = ancf::Model;
using Problem = ancf::DynamicProblem;

const ancf::Material rubber = ancf::Material::from_moduli(0.7e6, 2.6923e5, 5540.0);
const ancf::Section square = ancf::rectangle(0.05, 0.05);

/// The best, with the torsional stiffness of the paper: the limit below is that of its beam.
ancf::CrossSectionOptions cubic_options() {
    auto options = ancf::CrossSectionOptions::best();
    options.section_model = ancf::SectionModel::paper;
    return options;
}

/// A rubber beam without supports, flying and turning; a cubic element goes on from its end.
void add_flying(Scene& scene) {
    const auto beam =
        ancf::straight_beam<Quintic>(scene, rubber, square, {0, 0, 0}, {0.7, 0.2, 0.1}, 2);
    const int prototype = scene.add_prototype(Cubic(rubber, square, 0.4, cubic_options()));
    const auto end = scene.position(beam.last());
    const ancf::Matrix<double, 3> slopes = Eigen::Map<const ancf::Matrix<double, 3>>(
        scene.state().q.data() + scene.coordinate(beam.last(), Field::r_x));
    const auto tip = scene.add_node(Vector3(end + 0.4 * slopes.col(0)), slopes);
    scene.connect<Cubic>(prototype, beam.last(), tip);
    scene.set_rigid_rates({0.3, -0.2, 0.1}, {1.0, 3.0, -4.0});
}

ancf::DynamicsReport run(Scene& scene, const ancf::Schedule& schedule,
                         const ancf::Memory& memory = {}) {
    Problem problem(scene);
    ancf::EigenLu solver;
    ancf::EnergyMomentumOptions options;
    options.step = 2e-3;
    return ancf::EnergyMomentum(options).integrate(problem, solver, schedule, memory);
}

TEST_CASE("quintic: flying, joined to a cubic, it keeps its momenta and its energy",
          "[dynamics][quintic]") {
    Scene scene;
    add_flying(scene);
    Problem problem(scene);
    const ancf::Momentum start = momentum(problem, scene.state());
    double linear = 0.0, angular = 0.0;
    int snapshots = 0;
    ancf::Schedule schedule = ancf::equal_intervals(0.0, 0.2, 0.02);
    schedule.observe = [&](const ancf::Snapshot& at) {
        const ancf::Momentum now = momentum(problem, at.state);
        linear = std::max(linear, (now.linear - start.linear).norm() / start.linear.norm());
        angular = std::max(angular, (now.angular - start.angular).norm() / start.angular.norm());
        if (now.linear.allFinite() && now.angular.allFinite()) ++snapshots;
    };
    const auto report = run(scene, schedule);
    REQUIRE(report.status == Status::converged);
    CHECK(snapshots == 11);
    // as of the cubic beam: round-off of some hundred steps
    CHECK(linear <= 1e-11);
    CHECK(angular <= 1e-11);
    CHECK(report.energy_drift <= 1e-11 * report.kinetic_largest);
}

TEST_CASE("quintic: a motion read from a file goes on bit for bit", "[dynamics][quintic]") {
    Scene whole, parts, resumed;
    for (Scene* scene : {&whole, &parts, &resumed}) add_flying(*scene);
    const auto first = run(parts, until(0.02));
    REQUIRE(first.status == Status::converged);
    std::stringstream file;
    ancf::write_state(file, {parts.state(), first.memory});
    const ancf::SavedState saved = ancf::read_state(file);
    resumed.state() = saved.state;
    REQUIRE(run(resumed, until(0.04), saved.memory).status == Status::converged);
    REQUIRE(run(whole, until(0.04)).status == Status::converged);
    CHECK((whole.state().q - parts.state().q).norm() > 1e-3);
    CHECK(resumed.state().q == whole.state().q);
    CHECK(resumed.state().v == whole.state().v);
}

/// The paper's slender cantilever, the root half quintic, the other half cubic.
struct Cantilever {
    Scene scene;
    ancf::NodeId root, tip;
    static constexpr double bending = 2.07e11 * 1e-8 / 12.0, length = 2.0;
    static constexpr double load = 1.5 * bending / (length * length);

    Cantilever() {
        const auto steel = ancf::Material::from_moduli(2.07e11, 7.9615e10, 7850.0);
        const auto section =
            ancf::rectangle(0.01, 0.01).with_shear_correction(5.0 / 6.0, 5.0 / 6.0);
        const auto beam =
            ancf::straight_beam<Quintic>(scene, steel, section, {0, 0, 0}, {1, 0, 0}, 2);
        const int prototype = scene.add_prototype(Cubic(steel, section, 0.125, cubic_options()));
        root = beam.first();
        tip = beam.last();
        for (int k = 1; k <= 8; ++k) {
            const auto next = scene.add_node(Vector3(1.0 + 0.125 * k, 0.0, 0.0));
            scene.connect<Cubic>(prototype, tip, next);
            tip = next;
        }
        scene.clamp(root, ancf::Clamp::free_slope);
        scene.add(ancf::Force<3>(tip, {0.0, load, 0.0}));
    }
};

TEST_CASE("quintic: a cantilever of both lines bends as one, its clamp leaves r_xx free",
          "[statics][quintic]") {
    Cantilever beam;
    ancf::EigenLu solver;
    const auto report = ancf::solve_statics(beam.scene, solver);
    REQUIRE(report.status == Status::converged);
    const Vector3 tip = beam.scene.position(beam.tip);
    // measured 1e-6: the eight cubic elements'
    CHECK((tip - Vector3(1.784108719196, 0.821973318973, 0.0)).norm() <= 4e-6);
    // at the clamp E I times the curvature is the moment of the load
    const Vector3 curvature =
        beam.scene.state().q.segment<3>(beam.scene.coordinate(beam.root, Field::r_xx));
    CHECK(curvature[1] * Cantilever::bending == Approx(Cantilever::load * tip[0]).epsilon(1e-3));
    const int joint = beam.scene.layout().index({{2}, Field::r_xx});
    CHECK(joint >= 0);  // of the quintic alone
    CHECK(beam.scene.layout().index({{3}, Field::r_xx}) < 0);
}

TEST_CASE("quintic: the end of its path is its equilibrium", "[path][quintic]") {
    Cantilever beam, followed;
    ancf::EigenLdlt factors;
    REQUIRE(ancf::solve_statics(beam.scene, factors).status == Status::converged);
    ancf::PathOptions options;
    options.last_factor = 1.0;
    const auto path = ancf::follow_path(followed.scene, factors, options);
    REQUIRE(path.status == Status::converged);
    // within the tolerance of corrections, 1e-6
    CHECK((followed.scene.state().q - beam.scene.state().q).norm() <= 1e-7);
}

TEST_CASE("quintic: scales of coordinates are those of their units", "[dynamics][quintic]") {
    Scene scene;
    const auto beam = ancf::straight_beam<Quintic>(scene, rubber, square, {0, 0, 0}, {1, 0, 0}, 1);
    const Problem problem(scene);
    for (const double length : {1.0, 2.0}) {
        const ancf::VectorX scales = problem.scales_of(length);
        CHECK(scales[scene.coordinate(beam.last(), Field::r)] == length);
        CHECK(scales[scene.coordinate(beam.last(), Field::r_x)] == 1.0);
        CHECK(scales[scene.coordinate(beam.last(), Field::r_xx)] == 1.0 / length);
    }
}

TEST_CASE("quintic: the scale of forces has the unit of a force", "[dynamics][quintic]") {
    const auto force = [](double unit) {  // how many make a metre
        Scene scene;
        const auto beam = ancf::straight_beam<Quintic>(
            scene, ancf::Material::isotropic(7e5 / unit, 0.3, 5540.0 / (unit * unit * unit)),
            ancf::rectangle(0.05 * unit, 0.05 * unit), {0, 0, 0}, {1.2 * unit, 0, 0}, 3);
        scene.state().q[scene.coordinate(beam.last(), Field::r_xx) + 1] = 0.1 / unit;
        Problem problem(scene);
        return problem.force_scale(problem.start()) / unit;
    };
    CHECK(force(1.0) > 0.0);
    CHECK(force(1e3) == Approx(force(1.0)).epsilon(1e-6));
    CHECK(force(1e-3) == Approx(force(1.0)).epsilon(1e-6));
}

}  // namespace quintic_scene_test
