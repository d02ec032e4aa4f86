// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Rigid bodies: their energy, weight and motion against the mechanics of rigid bodies.

#include <ancf/constants.hpp>
#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/leapfrog.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/rigid_body.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/modal.hpp>
#include <ancf/solver/path.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <cmath>
#include <limits>
#include <type_traits>

namespace rigid_body_test {

using namespace ancf;
using Point = Vector<double, 3>;
using Square = Matrix<double, 3>;
using Bar = CrossSectionBeam<3>;

constexpr double g = 9.81;

Square diagonal(double x, double y, double z) { return Point(x, y, z).asDiagonal(); }

/// Returns the energies of a scene as it stands.
Energies energies(Scene& model) {
    DynamicProblem problem(model);
    EigenLu solver;
    Schedule schedule;
    schedule.end = 1e-9;
    schedule.times = {0.0};
    Energies found;
    schedule.observe = [&](const Snapshot& seen) { found = seen.energies; };
    (void)RadauIIA().integrate(problem, solver, schedule);
    return found;
}

/// Moves a scene from rest or its rates.
template <class Integrator>
DynamicsReport run(Scene& model, const Integrator& integrator, double end) {
    DynamicProblem problem(model);
    Schedule schedule;
    schedule.end = end;
    DynamicsReport report;
    if constexpr (std::is_same_v<Integrator, Leapfrog>) {
        report = integrator.integrate(problem, schedule);
    } else {
        EigenLu solver;
        report = integrator.integrate(problem, solver, schedule);
    }
    INFO(report.message);
    REQUIRE(report.status == Status::converged);
    return report;
}

RadauIIA accurate() {
    RadauOptions options;
    options.tolerance = 1e-8;
    return RadauIIA(options);
}

TEST_CASE("add_body: energy and weight are those of the rigid body, in any frame",
          "[model][body]") {
    test::Random random(7);
    for (int k = 0; k < 10; ++k) {
        const Square axes = reference_slopes(random.direction<3>(), random.direction<3>());
        const Square turn = reference_slopes(random.direction<3>(), random.direction<3>());
        const Square inertia = turn * diagonal(1.0, 2.0, 2.5) * turn.transpose();
        const Point place = random.vector<3>(), centre = random.vector<3>();
        const Point spin = random.vector<3>(), velocity = random.vector<3>();
        constexpr double mass = 3.0;
        Model model;
        const NodeId body = model.add_node(place, axes);
        add_body(model, body, mass, inertia, centre);
        model.set_gravity({0.0, 0.0, -g});
        model.set_rigid_rates(velocity, spin, place);
        const Point arm = axes * centre, local = axes.transpose() * spin;
        const Point of_centre = velocity + cross(spin, arm);
        const Energies seen = energies(model);
        CHECK(seen.kinetic ==
              Approx(0.5 * mass * of_centre.squaredNorm() + 0.5 * local.dot(inertia * local)));
        CHECK(seen.potential == Approx(mass * g * (place + arm)[2]));
    }
}

TEST_CASE("add_body: in the plane likewise", "[model][body]") {
    PlanarModel model;
    const NodeId body = model.add_node({1.0, 2.0});
    add_body(model, body, 3.0, 0.7, {0.3, -0.4});
    model.set_gravity({0.0, -g});
    model.set_rigid_rates({1.0, 0.0}, 2.0, {1.0, 2.0});
    const Energies seen = energies(model);
    // v = (1, 0) + 2 (0.4, 0.3) at the centre
    CHECK(seen.kinetic == Approx(1.5 * (1.8 * 1.8 + 0.36) + 0.5 * 0.7 * 4.0));
    CHECK(seen.potential == Approx(3.0 * g * 1.6));

    const NodeId point = point_of_body(model, body, {2.0, 2.0});
    CHECK_THROWS_WITH(model.set_rigid_rates({point}, {1.0, 0.0}, 0.0),
                      Catch::Matchers::Contains("attached"));
    CHECK_NOTHROW(model.set_rigid_rates({point, body}, {1.0, 0.0}, 0.0));
}

TEST_CASE("add_body: a free disc, flat or thick, precesses as a symmetric top", "[model][body]") {
    const double polar = GENERATE(0.2, 0.1, 0.05);  // kg m^2; 0.2 is that of a flat disc
    const Square inertia = diagonal(0.1, 0.1, polar);
    Model model;
    const NodeId body = model.add_node({0.0, 0.0, 0.0});
    add_body(model, body, 2.0, inertia);
    const Point spin(1.0, 0.0, 8.0);
    model.set_rigid_rates(Point(0.0, 0.3, 0.0), spin);
    const Point momentum = inertia * spin, axis = momentum.normalized();
    constexpr double end = 3.0;
    run(model, accurate(), end);
    const double angle = momentum.norm() / inertia(0, 0) * end;
    const Point z = Point::UnitZ();
    const Point turned = std::cos(angle) * z + std::sin(angle) * cross(axis, z) +
                         (1.0 - std::cos(angle)) * axis.dot(z) * axis;
    CHECK((model.value(body, Field::r_z) - turned).norm() < 1e-6);
    CHECK((model.position(body) - Point(0.0, 0.9, 0.0)).norm() < 1e-9);
}

TEST_CASE("add_body: a heavy top turns as Euler's equations say", "[model][body][long]") {
    constexpr double mass = 15.0, end = 0.5;
    const Square inertia = diagonal(0.234375, 0.46875, 0.234375);
    const Point spin(0.0, 150.0, -4.61538), centre(0.0, 1.0, 0.0);
    Model model;
    const NodeId pivot = model.add_node({0.0, 0.0, 0.0});
    add_body(model, pivot, mass, inertia, centre);
    model.pin(pivot);
    model.set_gravity({0.0, 0.0, -g});
    model.set_rigid_rates(Point::Zero(), spin);
    run(model, accurate(), end);

    // J w' = (J w) x w + c x m R^T g, R' = R [w]x, by Runge's and Kutta's formula
    const Square about = inertia + mass * diagonal(1.0, 0.0, 1.0);
    Matrix<double, 4> now = Matrix<double, 4>::Zero();  // R, and w in the last column
    now.topLeftCorner<3, 3>().setIdentity();
    now.col(3).head<3>() = spin;
    const auto rate = [&](const Matrix<double, 4>& at) {
        const Square turn = at.topLeftCorner<3, 3>();
        const Point w = at.col(3).head<3>();
        const Point weight = mass * (turn.transpose() * Point(0.0, 0.0, -g));
        Matrix<double, 4> out = Matrix<double, 4>::Zero();
        for (int k = 0; k < 3; ++k) out.col(k).head<3>() = turn * cross(w, Point(Point::Unit(k)));
        const Point moment = cross(Point(about * w), w) + cross(centre, weight);
        for (int k = 0; k < 3; ++k) out(k, 3) = moment[k] / about(k, k);
        return out;
    };
    constexpr int steps = 20000;
    constexpr double h = end / steps;
    for (int k = 0; k < steps; ++k) {
        const Matrix<double, 4> a = rate(now), b = rate(now + 0.5 * h * a),
                                c = rate(now + 0.5 * h * b), d = rate(now + h * c);
        now += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    CHECK((model.value(pivot, Field::r_y) - now.col(1).head<3>()).norm() < 5e-6);
}

TEST_CASE("add_body: energy-momentum keeps the energy of two hinged bodies",
          "[model][body][long]") {
    Model model;
    const NodeId upper = model.add_node({0.3, 0.0, -0.4});
    const NodeId lower = model.add_node({0.9, 0.0, -0.8});
    add_body(model, upper, 2.0, diagonal(0.02, 0.03, 0.04));
    add_body(model, lower, 1.0, diagonal(0.01, 0.02, 0.02));
    const NodeId hook = point_of_body(model, upper, {0.0, 0.0, 0.0});
    const NodeId elbow = point_of_body(model, upper, {0.6, 0.0, -0.6});
    const NodeId tip = point_of_body(model, lower, {0.6, 0.0, -0.6});
    model.add(Revolute(model, hook, {0.0, 1.0, 0.0}));
    model.add(Revolute(model, elbow, tip, {0.0, 0.6, 0.8}));
    model.set_gravity({0.0, 0.0, -g});
    EnergyMomentumOptions options;
    options.step = 5e-3;
    const DynamicsReport report = run(model, EnergyMomentum(options), 2.0);
    CHECK(report.kinetic_largest > 5.0);
    CHECK(report.energy_drift < 1e-9 * report.kinetic_largest);
    CHECK(report.violation < 1e-9);
}

TEST_CASE("add_body: by energy-momentum a spinning body falls back by (w h)^2/12 of its turns",
          "[model][body][long]") {
    constexpr double speed = 50.0, step = 2e-3, end = 1.0;
    Model model;
    const NodeId body = model.add_node({0.0, 0.0, 0.0});
    add_body(model, body, 1.0, diagonal(0.1, 0.1, 0.2));
    model.set_rigid_rates(Point::Zero(), Point(0.0, 0.0, speed));
    EnergyMomentumOptions options;
    options.step = step;
    run(model, EnergyMomentum(options), end);
    const Point x = model.value(body, Field::r_x);
    const double ahead = std::remainder(std::atan2(x[1], x[0]) - speed * end, 2.0 * pi);
    // a step turns it by 2 atan(w h/2): the next term is 1.5e-3 of this one
    CHECK(-ahead == Approx(speed * end * std::pow(speed * step, 2) / 12.0).epsilon(2e-3));
}

TEST_CASE("add_body: a body at the end of a light beam swings and sags", "[model][body][modal]") {
    // without mass of its own the beam is K = E I/L^3 [12, -6 L; -6 L, 4 L^2] of (w, w')
    constexpr double length = 1.0, mass = 2.0, inertia = 0.3, centre = 0.2;
    const Material light = Material::isotropic(2e11, 0.3, 1e-3);
    const Section section = rectangle(0.01, 0.02);
    const double bending = light.young * section.moments().zz;  // along Z
    const double k = bending / (length * length * length);
    const double k_ww = 12.0 * k, k_wt = -6.0 * k * length, k_tt = 4.0 * k * length * length;
    const double m_wt = mass * centre, m_tt = inertia + mass * centre * centre;
    const double a = mass * m_tt - m_wt * m_wt;
    const double b = mass * k_tt + m_tt * k_ww - 2.0 * m_wt * k_wt;
    const double root = std::sqrt(b * b - 4.0 * a * (k_ww * k_tt - k_wt * k_wt));

    const bool first = GENERATE(true, false);  // whether the body is made before it is attached
    Model model;
    const auto beam = straight_beam<Bar>(model, light, section, {0, 0, 0}, {length, 0, 0}, 4,
                                         CrossSectionOptions::best());
    model.clamp(beam.first(), Clamp::free_slope);
    const NodeId body = model.add_node({length, 0, 0});
    const auto add = [&] {
        add_body(model, body, mass, diagonal(1e-3, inertia, inertia), {centre, 0.0, 0.0});
    };
    if (first) add();
    model.attach(beam.last(), body);
    if (!first) add();
    for (int node = 0; node < 4; ++node) model.fix(beam.nodes[node], Field::r, 1);
    model.fix(body, Field::r, 1);
    EigenLu solver;
    ModalOptions options;
    options.count = 2;
    const ModalReport report = natural_modes(model, solver, options);
    INFO(report.message);
    REQUIRE(report.status == Status::converged);
    CHECK(report.modes[0].value == Approx((b - root) / (2.0 * a)).epsilon(1e-3));
    CHECK(report.modes[1].value == Approx((b + root) / (2.0 * a)).epsilon(2e-3));

    model.set_gravity({0.0, 0.0, -g});
    REQUIRE(solve_statics(model, solver).status == Status::converged);
    const double sag = mass * g / bending * (1.0 / 3.0 + 0.5 * centre);
    CHECK(model.position(beam.last())[2] == Approx(-sag).epsilon(1e-3));
}

TEST_CASE("add_body: a disc that tilts on a shaft has one frequency with 4 and 64 elements",
          "[model][body][modal]") {
    const auto frequency = [](int elements) {
        Model model;
        const auto shaft =
            straight_beam<Bar>(model, Material::isotropic(2e11, 0.3, 7800.0), rectangle(0.05, 0.05),
                               {0, 0, 0}, {1, 0, 0}, elements, CrossSectionOptions::best());
        for (const NodeId end : {shaft.first(), shaft.last()}) model.clamp(end, Clamp::free_slope);
        const NodeId disc = model.add_node({0.5, 0.0, 0.0});
        add_body(model, disc, 10.0, diagonal(1.0, 20.0, 20.0));
        model.attach(shaft.node(elements / 2), disc);
        EigenLu solver;
        ModalOptions options;
        options.count = 1;
        const ModalReport report = natural_modes(model, solver, options);
        REQUIRE(report.status == Status::converged);
        return std::sqrt(report.modes[0].value);
    };
    CHECK(frequency(4) == Approx(frequency(64)).epsilon(1e-3));
}

TEST_CASE("add_body: a body without load leaves buckling loads as they are",
          "[model][body][modal]") {
    const auto load = [](bool with_body) {
        Model model;
        const auto column =
            straight_beam<Bar>(model, Material::isotropic(2e11, 0.3, 7800.0), rectangle(0.1, 0.1),
                               {0, 0, 0}, {1, 0, 0}, 4, CrossSectionOptions::best());
        model.clamp(column.first());
        model.add(Force<3>(column.last(), {-1.0, 0.0, 0.0}));
        if (with_body) {
            const NodeId body = model.add_node({1.0, 0.0, 0.0});
            add_body(model, body, 1e-3, diagonal(1.0, 1.0, 1.0));
            model.add(Weld(model, column.last(), body));
        }
        EigenLu solver;
        const ModalReport report = buckling_modes(model, solver);
        REQUIRE(report.status == Status::converged);
        return report.modes[0].value;
    };
    CHECK(load(true) == Approx(load(false)).epsilon(1e-9));
}

TEST_CASE("add_body: a compound pendulum in the plane by leapfrog", "[model][body]") {
    // from rest at the height of its pivot: it gains what its weight does
    constexpr double mass = 2.0, inertia = 0.1, arm = 0.4;
    PlanarModel model;
    const NodeId body = model.add_node({arm, 0.0});
    add_body(model, body, mass, inertia);
    model.add(Pin<2>(point_of_body(model, body, {0.0, 0.0}), {0.0, 0.0}));
    model.set_gravity({0.0, -g});
    LeapfrogOptions options;
    options.step = 1e-3;
    const DynamicsReport report = run(model, Leapfrog(options), 1.0);
    CHECK(report.kinetic_largest == Approx(mass * g * arm).epsilon(1e-4));
    CHECK(report.energy_drift < 1e-6 * mass * g * arm);
    // the rate at the end has the inertia about the pivot
    const double rate = model.velocity(body).norm() / arm;
    CHECK(0.5 * (inertia + mass * arm * arm) * rate * rate ==
          Approx(-mass * g * model.position(body)[1]).epsilon(1e-5));
}

TEST_CASE("add_body: a free body by leapfrog, whose multipliers are none", "[model][body]") {
    // the highest frequency was no number: forces of round-off, whose squares vanish
    Model model;
    const NodeId body = model.add_node({0.0, 0.0, 0.0});
    add_body(model, body, 1.0, diagonal(0.1, 0.12, 0.15));
    model.set_rigid_rates(Point::Zero(), Point(1.0, 2.0, 8.0));
    LeapfrogOptions options;
    options.step = 1e-3;
    const DynamicsReport report = run(model, Leapfrog(options), 0.1);
    CHECK(report.energy_drift < 1e-6 * report.kinetic_largest);
}

TEST_CASE("add: the place of a constraint counts those of bodies", "[model][body]") {
    Model model;
    const NodeId first = model.add_node({0.0, 0.0, 0.0}), second = model.add_node({1.0, 0.0, 0.0});
    add_body(model, first, 1.0, diagonal(1.0, 1.0, 1.0));
    const int pin = model.add(Pin<3>(first, {0.0, 0.0, 0.0}));
    add_body(model, second, 1.0, diagonal(1.0, 1.0, 1.0));
    const int weld = model.add(Weld(model, first, second));
    CHECK(pin == 1);
    CHECK(weld == 3);
    CHECK(model.constraints()[pin].name() == Pin<3>(first, {0.0, 0.0, 0.0}).name());
    CHECK(model.constraints()[weld].name() == Weld(model, first, second).name());
}

TEST_CASE("add_body, point_of_body: what cannot be meant is refused", "[model][body][bad-input]") {
    const auto says = [](const char* text, const auto& act) {
        Model model;
        const NodeId node = model.add_node({1.0, 2.0, 3.0});
        CHECK_THROWS_WITH(act(model, node), Catch::Matchers::Contains(text));
        CHECK(model.groups().empty());
        CHECK(model.constraints().empty());
    };
    const double not_a_number = std::numeric_limits<double>::quiet_NaN();
    const Square good = diagonal(1.0, 1.0, 1.0);
    Square unsymmetric = good;
    unsymmetric(0, 1) = 0.1;
    says("mass", [&](Model& of, NodeId at) { add_body(of, at, 0.0, good); });
    says("centre", [&](Model& of, NodeId at) {
        add_body(of, at, 1.0, good, {not_a_number, 0, 0});
    });
    says("symmetric", [&](Model& of, NodeId at) { add_body(of, at, 1.0, unsymmetric); });
    says("no body", [&](Model& of, NodeId at) { add_body(of, at, 1.0, diagonal(1.0, 1.0, 2.1)); });
    says("finite", [&](Model& of, NodeId at) { add_body(of, at, 1.0, not_a_number * good); });
    says("no body", [&](Model& of, NodeId at) { add_body(of, at, 1.0, diagonal(-1.0, 1.0, 1.0)); });
    says("every axis",
         [&](Model& of, NodeId at) { add_body(of, at, 1.0, diagonal(0.0, 1.0, 1.0)); });
    says("no body", [&](Model& of, NodeId at) { add_body(of, at, 1.0, 0.0 * good); });
    says("there are 1 nodes", [&](Model& of, NodeId) { add_body(of, NodeId{1}, 1.0, good); });
    says("no body", [](Model& of, NodeId at) { (void)point_of_body(of, at, {0.0, 0.0, 0.0}); });

    Model model;
    const auto beam = straight_beam<Bar>(model, Material::isotropic(2e11, 0.3, 7800.0),
                                         circle(0.01), {0, 0, 0}, {1, 0, 0}, 2);
    CHECK_THROWS_WITH(add_body(model, beam.last(), 1.0, good),
                      Catch::Matchers::Contains("a node of its own"));
    CHECK_THROWS_WITH(point_of_body(model, beam.last(), {1.0, 1.0, 0.0}),
                      Catch::Matchers::Contains("a node of its own"));
    const NodeId body = model.add_node({1.0, 0.0, 0.0});
    // a flat one, rounded
    add_body(model, body, 1.0, diagonal(1.23457, 2.34568, 3.58026));
    CHECK_THROWS_WITH(point_of_body(model, body, {1.0, not_a_number, 0.0}),
                      Catch::Matchers::Contains("finite"));
    CHECK_THROWS_WITH(point_of_body(model, body, {1.0, 0.0, 0.0}),
                      Catch::Matchers::Contains("take that node"));
    CHECK_THROWS_WITH(model.pin(point_of_body(model, body, {2.0, 0.0, 0.0})),
                      Catch::Matchers::Contains("a joint such as Pin"));
    const NodeId twice = model.add_node({0.0, 0.0, 0.0}, 2.0 * good);
    CHECK_THROWS_WITH(add_body(model, twice, 1.0, good), Catch::Matchers::Contains("orthonormal"));
    PlanarModel plane;
    CHECK_THROWS_WITH(add_body(plane, plane.add_node({0.0, 0.0}), 1.0, -1.0),
                      Catch::Matchers::Contains("inertia must be positive"));
}

TEST_CASE("point_of_body: the point is one of the reference, wherever the body is",
          "[model][body]") {
    Model model;
    const NodeId body = model.add_node({1.0, 0.0, 0.0});
    add_body(model, body, 1.0, diagonal(1.0, 1.0, 1.0));
    model.set_value(body, Field::r, {3.0, 0.0, 0.0});
    const NodeId point = point_of_body(model, body, {3.0, 0.0, 0.0});
    CHECK(model.position(point) == Point(5.0, 0.0, 0.0));
    CHECK(model.reference(point, Field::r) == Point(3.0, 0.0, 0.0));
    CHECK_THROWS_AS(point_of_body(model, body, {1.0, 0.0, 0.0}), InvalidArgument);
    CHECK_THROWS_AS(model.reference(NodeId{9}, Field::r), InvalidArgument);
}

TEST_CASE("add_body: a beam on a body that joints hold to the ground bends as a clamped one",
          "[model][body][statics]") {
    for (const bool weld : {true, false}) {
        CAPTURE(weld);
        Model model;
        const NodeId body = model.add_node({1, 0, 0});
        add_body(model, body, 5.0, diagonal(0.1, 0.1, 0.1));
        model.add(Weld(model, body));
        const auto beam =
            straight_beam<Bar>(model, Material::isotropic(2e11, 0.3, 7800.0), rectangle(0.02, 0.02),
                               {1, 0, 0}, {2, 0, 0}, 6, CrossSectionOptions::best());
        if (weld) {
            model.add(Weld(model, body, beam.first()));
        } else {
            model.pin(beam.first());
            model.add(FixedOrientation(model, body, beam.first()));
        }
        model.add(Force<3>(beam.last(), {0, -5, 10}));
        EigenLu solver;
        const auto report = solve_statics(model, solver);
        INFO(report.message);
        REQUIRE(report.status == Status::converged);
        CHECK(report.iterations() <= 4);
        const double stiffness = 3.0 * 2e11 * std::pow(0.02, 4) / 12.0;
        CHECK(model.position(beam.last())[1] == Approx(-5.0 / stiffness).epsilon(1e-3));
        CHECK(model.position(beam.last())[2] == Approx(10.0 / stiffness).epsilon(1e-3));
    }
}

TEST_CASE("add_body: a column on a body is judged like a clamped one, whatever the body bears",
          "[model][body][statics][stability]") {
    const double side = 0.02, bending = 2e11 * std::pow(side, 4) / 12.0;
    int judged = 0;
    for (const double load : {0.5, 0.9, 1.1})                  // of Euler's
        for (const double pull : {0.0, 1e-10, 1e-4, -1e-6}) {  // of E I/L^2
            CAPTURE(load, pull);
            Model model;
            const NodeId body = model.add_node({0, 0, 0});
            add_body(model, body, 5.0, diagonal(0.1, 0.1, 0.1));
            model.add(Weld(model, body));
            const auto column = straight_beam<Bar>(model, Material::isotropic(2e11, 0.3, 7800.0),
                                                   rectangle(side, 1.1 * side), {0, 0, 0},
                                                   {1, 0, 0}, 6, CrossSectionOptions::best());
            model.add(Weld(model, body, column.first()));
            model.add(Force<3>(column.last(), {-load * 1.1 * pi * pi / 4.0 * bending, 0, 0}));
            // the body's stiffness is that of the forces that hold it together
            if (pull != 0.0)
                model.add(Force<3>(point_of_body(model, body, {0, 1, 0}), {0, pull * bending, 0}));
            EigenLu solver;
            const auto report = solve_statics(model, solver);
            REQUIRE(report.status == Status::converged);
            CHECK(report.stability == (load < 1.0 ? Stability::stable : Stability::unstable));
            ++judged;
        }
    CHECK(judged == 12);
}

/// Two clamped steel beams with a body welded between them, which a load pushes.
struct WeldedBody {
    Model model;
    NodeId body{};
};

WeldedBody welded_body(double slant, double load) {
    const Material steel = Material::isotropic(2.1e11, 0.3, 7800.0);
    const Section square = rectangle(0.02 + 0.01 * slant, 0.02);
    const Point middle(1.0, 0.2 * slant, -0.1 * slant);
    WeldedBody scene;
    Model& model = scene.model;
    const auto left = straight_beam<Bar>(model, steel, square, Point(0, 0, 0), middle, 3);
    scene.body = model.add_node(middle);
    add_body(model, scene.body, 2.0, diagonal(0.03, 0.04, 0.05));
    const auto right =
        straight_beam<Bar>(model, steel, square, middle, Point(2.0, 0.3, 0.4 * slant), 3);
    model.clamp(left.first());
    model.clamp(right.last());
    model.add(Weld(model, left.last(), scene.body));
    model.add(Weld(model, scene.body, right.first()));
    model.add(Force<3>(scene.body, load * Point(0.3, 1.0, -0.6)));
    return scene;
}

TEST_CASE("add_body: a body between welds has its modes, however little it bears",
          "[model][body][modal]") {
    // far below Euler's load the frequencies are those of the unloaded scene
    const auto modes = [](double slant, double load) {
        Model model = welded_body(slant, load).model;
        EigenLu solver;
        REQUIRE(solve_statics(model, solver).status == Status::converged);
        ModalOptions options;
        options.count = 4;
        const ModalReport report = natural_modes(model, solver, options);
        CAPTURE(slant, load, report.message);
        REQUIRE(report.status == Status::converged);
        REQUIRE(report.modes.size() == 4);
        return report.modes;
    };
    for (const double slant : {0.1, 0.4, 0.7, 1.0}) {
        const auto unloaded = modes(slant, 0.0);
        for (const double load : {1e-9, 1e-6, 1e-4, 1e-3}) {
            const auto loaded = modes(slant, load);
            for (std::size_t k = 0; k < 4; ++k)
                CHECK(loaded[k].value == Approx(unloaded[k].value).epsilon(1e-6));
        }
    }
}

TEST_CASE("add_body: the path of a body between welds can be followed", "[model][body][path]") {
    // along it the body's own stiffness is that of the forces in it, or their round-off
    int followed = 0;
    for (const double slant : {0.1, 0.4, 0.7, 1.0})
        for (const double load : {1e-5, 1e-3, 0.1, 10.0, 1e3}) {
            CAPTURE(slant, load);
            WeldedBody scene = welded_body(slant, load), once = welded_body(slant, load);
            PathOptions options;
            options.first_step = 0.3;
            options.last_factor = 1.0;
            EigenLu solver;
            const PathReport report = follow_path(scene.model, solver, options);
            CAPTURE(report.message);
            CHECK(report.status == Status::converged);
            CHECK(report.points.size() <= 4);  // 3 measured
            REQUIRE(solve_statics(once.model, solver).status == Status::converged);
            const Point place = once.model.position(once.body);
            // 3.4e-14 measured; the smallest load moves the body by 1.2e-10
            CHECK((scene.model.position(scene.body) - place).norm() <= 1e-12);
            ++followed;
        }
    CHECK(followed == 20);
}

TEST_CASE("add_body: two beams welded to a body are stable", "[model][body][statics][stability]") {
    // the body's own stiffness is that of the forces in it: the smaller the load, the more of it is
    // round-off
    for (const double length : {1e-3, 1.0, 1e3})
        for (const double load : {1e-6, 3e-5, 1e-3, 3e-2, 1.0}) {
            CAPTURE(length, load);
            Model model;
            const auto material = Material::isotropic(2e11, 0.3, 7800.0);
            const auto section = rectangle(0.03 * length, 0.02 * length);
            const Point middle = length * Point(1.0, 0.3, -0.2);
            const Point end = length * Point(0.4, 1.3, 0.5);
            const auto first = straight_beam<Bar>(model, material, section, {0, 0, 0},
                                                  {middle[0], middle[1], middle[2]}, 2,
                                                  CrossSectionOptions::best());
            const auto second =
                straight_beam<Bar>(model, material, section, {middle[0], middle[1], middle[2]},
                                   {end[0], end[1], end[2]}, 2, CrossSectionOptions::best());
            const NodeId body = model.add_node({middle[0], middle[1], middle[2]});
            const double mass = 5.0 * std::pow(length, 3);
            add_body(model, body, mass, 0.1 * mass * length * length * diagonal(1, 1, 1));
            model.clamp(first.first());
            const double force = load * length * length;
            model.add(Force<3>(second.last(), {0.3 * force, force, -0.5 * force}));
            for (const NodeId joined : {first.last(), second.first()})
                model.add(Weld(model, joined, body));
            EigenLu solver;
            const auto report = solve_statics(model, solver);
            REQUIRE(report.status == Status::converged);
            CHECK(report.stability == Stability::stable);
        }
}

}  // namespace rigid_body_test
