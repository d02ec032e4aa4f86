// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Springs and dampers of hinges: derivatives, and scenes with a closed form.

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/momentum.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/loads/rotational_springs.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/load_result.hpp>
#include <support/random_state.hpp>

#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>

namespace rotational_springs_test {

using namespace ancf;
using Complex = DynamicVector<std::complex<double>>;
using Point = Vector<double, 3>;
using Point2 = Vector<double, 2>;
using Bar = CrossSectionBeam<3>;
using Flat = CrossSectionBeam<2>;

constexpr double tolerance = 1e-12;  // round-off; measured 1e-14

VectorX local(const Scene& model, const Coupling& coupling) {
    const int dimension = model.dimension();
    VectorX q(dimension * static_cast<int>(coupling.size()));
    for (std::size_t k = 0; k < coupling.size(); ++k)
        q.segment(dimension * static_cast<int>(k), dimension) = model.state().q.segment(
            model.coordinate(coupling[k].node, coupling[k].field), dimension);
    return q;
}

template <class Spring, class Damper>
void check_derivatives(const Scene& model, const Spring& spring, const Damper& damper,
                       test::Random& random) {
    VectorX q = local(model, spring.coupling()), v(q.size());
    CHECK(test::load_result(spring, q, v).force.norm() <= 1e-12);  // at rest where it was made
    for (Eigen::Index i = 0; i < q.size(); ++i) {
        q[i] += random.uniform(-0.4, 0.4);
        v[i] = random.uniform(-2.0, 2.0);
    }
    const LoadResult at = test::load_result(spring, q, v);
    const auto expected =
        test::complex_step_jacobian([&](const Complex& z) { return spring.force(z); }, q);
    CHECK(test::relative_error(at.stiffness, expected) < tolerance);
    CHECK(test::relative_error(at.force, spring.force(q)) < tolerance);
    CHECK(test::relative_error(at.stiffness, at.stiffness.transpose()) < tolerance);
    // Q = -dV/dq, by a central difference
    const double h = 1e-5;
    const double slope = (test::load_result(spring, q + h * v, v).potential -
                          test::load_result(spring, q - h * v, v).potential) /
                         (2.0 * h);
    CHECK(slope == Approx(-at.force.dot(v)).epsilon(1e-7).margin(1e-8));
    test::check_damper(damper, q, v, tolerance);
}

/// A hundred times as stiff as steel: bars hardly bend.
Material stiff() { return Material::isotropic(2e13, 0.3, 7800.0); }

Beam<Bar> bar(Model& model, const Point& from, const Point& to, int elements = 1) {
    return straight_beam<Bar>(model, stiff(), rectangle(0.02, 0.03), from, to, elements,
                              CrossSectionOptions::best());
}

Beam<Flat> flat(PlanarModel& model, const Point2& from, const Point2& to, int elements = 1) {
    return straight_beam<Flat>(model, stiff(), rectangle(0.02, 0.03), from, to, elements,
                               CrossSectionOptions::best());
}

TEST_CASE("RotationalSpring, RotationalDamper: derivatives equal the complex step's",
          "[model][springs]") {
    const auto seed = GENERATE(range(0U, 20U));
    INFO("seed " << seed);
    test::Random random(seed);
    Model model;
    const NodeId a = bar(model, {0, 0, 0}, random.vector<3>()).last(),
                 b = bar(model, {0, 0, 0}, random.vector<3>()).first();
    const Point axis = random.vector<3>();
    const FrameAt tangent(a, Field::r_x, Field::r_y);
    check_derivatives(model, RotationalSpring(model, a, b, axis, 3.0),
                      RotationalDamper(model, a, b, axis, 0.3), random);
    check_derivatives(model, RotationalSpring(model, tangent, b, axis, 3.0),
                      RotationalDamper(model, tangent, b, axis, 0.3), random);
    check_derivatives(model, RotationalSpring(model, b, axis, 3.0),
                      RotationalDamper(model, b, axis, 0.3), random);
    PlanarModel plane;
    const NodeId c = flat(plane, {0, 0}, random.vector<2>()).last(),
                 d = flat(plane, {0, 0}, random.vector<2>()).first();
    check_derivatives(plane, PlanarRotationalSpring(plane, c, d, 3.0),
                      PlanarRotationalDamper(plane, c, d, 0.3), random);
    check_derivatives(plane, PlanarRotationalSpring(plane, d, 3.0),
                      PlanarRotationalDamper(plane, d, 0.3), random);
}

TEST_CASE("a hinge with a spring turns by the moment over its stiffness, about any axis",
          "[model][springs][statics]") {
    // Two bars; a moment about the axis of the hinge between them, up to 2.4 rad.
    const Point along = Point(0.6, -0.3, 0.5).normalized();
    const Point axis = cross(along, Point(0.2, 1.0, -0.4)).normalized(),
                across = cross(axis, along);
    int checked = 0;
    for (const double angle : {-1.3, 0.4, 2.4}) {
        Model model;
        const auto first = bar(model, Point::Zero(), 0.5 * along),
                   second = bar(model, 0.5 * along, along);
        model.clamp(first.first());
        model.add(Revolute(model, first.last(), second.first(), axis));
        model.add(RotationalSpring(model, first.last(), second.first(), axis, 20.0));
        model.add(Moment(second.last(), 20.0 * angle * axis));
        EigenLu solver;
        StaticsOptions options;
        options.steps = 4;
        const StaticsReport report = solve_statics(model, solver, options);
        CAPTURE(angle, report.message);
        REQUIRE(report.status == Status::converged);
        const Point arm =
            model.value(second.last(), Field::r) - model.value(second.first(), Field::r);
        const double turn = std::atan2(arm.dot(across), arm.dot(along));
        CHECK(std::abs(turn - angle) <= 1e-4);  // the bars bend by up to 4.5e-5 rad
        ++checked;
    }
    CHECK(checked == 3);
}

TEST_CASE(
    "a bar on a hinge with a spring and a damper swings as the closed form, in plane and space",
    "[model][springs][dynamics][long]") {
    // J phi'' + c phi' + k phi = 0 about the hinge, J = m L^2/3.
    constexpr double stiffness = 30.0, damping = 0.15, start = 0.2;
    const double inertia =
        7800.0 * 0.02 * 0.03 * (0.25 / 3.0 * 0.5) + 7800.0 * 0.5 * 0.02 * std::pow(0.03, 3) / 12.0;
    const double decay = damping / (2.0 * inertia);
    const double frequency = std::sqrt(stiffness / inertia - decay * decay);
    const double end = 0.9;
    const double expected =
        start * std::exp(-decay * end) *
        (std::cos(frequency * end) + decay / frequency * std::sin(frequency * end));
    const auto run = [&](auto& model) {
        EigenLu solver;
        DynamicProblem problem(model);
        RadauOptions options;
        options.tolerance = 1e-7;
        Schedule schedule;
        schedule.end = end;
        REQUIRE(RadauIIA(options).integrate(problem, solver, schedule).status == Status::converged);
    };
    PlanarModel plane;
    const auto rod = flat(plane, {0, 0}, {0.5, 0});
    plane.pin(rod.first());
    plane.add(PlanarRotationalSpring(plane, rod.first(), stiffness));
    plane.add(PlanarRotationalDamper(plane, rod.first(), damping));
    const auto turned = [&](const Point2& v) {
        return Point2(std::cos(start) * v[0] - std::sin(start) * v[1],
                      std::sin(start) * v[0] + std::cos(start) * v[1]);
    };
    for (const NodeId node : rod.nodes)
        for (const Field field : {Field::r, Field::r_x, Field::r_y})
            plane.set_value(node, field, turned(plane.value(node, field)));
    run(plane);
    const Point2 tip = plane.value(rod.last(), Field::r);
    CHECK(std::atan2(tip[1], tip[0]) == Approx(expected).margin(2e-4 * start));

    Model model;
    const Point axis(0.0, 0.0, 1.0);
    const auto beam = bar(model, Point::Zero(), Point(0.5, 0.0, 0.0));
    model.add(Revolute(model, beam.first(), axis));
    model.add(RotationalSpring(model, beam.first(), axis, stiffness));
    model.add(RotationalDamper(model, beam.first(), axis, damping));
    for (const NodeId node : beam.nodes)
        for (const Field field : {Field::r, Field::r_x, Field::r_y}) {
            const Point at = model.value(node, field);
            const Point2 in_plane = turned({at[0], at[1]});
            model.set_value(node, field, Point(in_plane[0], in_plane[1], at[2]));
        }
    run(model);
    const Point place = model.value(beam.last(), Field::r);
    CHECK(std::atan2(place[1], place[0]) == Approx(expected).margin(2e-4 * start));
}

TEST_CASE("EnergyMomentum keeps energy and momenta of a hinge with a spring",
          "[model][springs][dynamics][long]") {
    Model model;
    const Point axis = Point(0.1, 0.3, 1.0).normalized();
    const auto first = bar(model, {0, 0, 0}, {0.5, 0, 0}),
               second = bar(model, {0.5, 0, 0}, {1.0, 0, 0});
    model.add(Revolute(model, first.last(), second.first(), axis));
    model.add(RotationalSpring(model, first.last(), second.first(), axis, 50.0));
    model.set_rigid_rates(second.nodes, Point::Zero(), 4.0 * axis, Point(0.5, 0, 0));
    EigenLu solver;
    DynamicProblem problem(model);
    const Momentum start = momentum(problem, model.state());
    EnergyMomentumOptions options;
    options.step = 2e-3;
    Schedule schedule;
    schedule.end = 0.4;
    const DynamicsReport report = EnergyMomentum(options).integrate(problem, solver, schedule);
    REQUIRE(report.status == Status::converged);
    CHECK(report.energy_drift <= 1e-9 * report.kinetic_largest);
    const Momentum end = momentum(problem, model.state());
    CHECK((end.linear - start.linear).norm() < 1e-11 * start.linear.norm());
    // measured 1e-15; 5e-7 where a spring at rest counted as one that a turn stretches
    CHECK((end.angular - start.angular).norm() < 1e-11 * start.angular.norm());
}

TEST_CASE("rotational springs and dampers refuse what cannot be meant", "[model][springs]") {
    Model model;
    const auto beam = bar(model, {0, 0, 0}, {1, 0, 0});
    const NodeId a = beam.first(), b = beam.last();
    const Point axis(0, 0, 1);
    CHECK_THROWS_AS(RotationalSpring(model, a, a, axis, 1.0), InvalidArgument);
    CHECK_THROWS_AS(RotationalSpring(model, a, b, Point::Zero(), 1.0), InvalidArgument);
    CHECK_THROWS_AS(RotationalSpring(model, a, b, axis, -1.0), InvalidArgument);
    CHECK_THROWS_AS(RotationalDamper(model, a, axis, std::numeric_limits<double>::quiet_NaN()),
                    InvalidArgument);
    PlanarModel plane;
    const auto rod = flat(plane, {0, 0}, {1, 0});
    CHECK_THROWS_AS(PlanarRotationalSpring(plane, rod.first(), rod.first(), 1.0), InvalidArgument);
    CHECK_THROWS_AS(PlanarRotationalDamper(plane, rod.first(), -1.0), InvalidArgument);
}

}  // namespace rotational_springs_test
