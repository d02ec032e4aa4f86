// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Joints in moving scenes of beams and cables: what each lets pass, and what it holds.

#include <ancf/constants.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace moving_joints_test {

using namespace ancf;
using Bar = CrossSectionBeam<3>;
using Rope = Cable<3>;
using Scene = Model;
using Point = Vector<double, 3>;

constexpr double gravity = 9.81;
constexpr double held = 1e-9;  // most that a constraint may be off after a step, m

Material steel() { return Material::isotropic(2e11, 0.3, 7800.0); }

/// Adds a straight bar with the rule that does not lock.
Beam<Bar> bar(Scene& model, const Point& from, const Point& to, int elements = 1) {
    return straight_beam<Bar>(model, steel(), rectangle(0.02, 0.02), from, to, elements,
                              CrossSectionOptions::best());
}

/// A motion and its largest constraint violation.
struct Course {
    DynamicsReport report;
    std::vector<double> totals;  ///< kinetic + strain + potential less the drives' work, J
};

/// Integrates a scene; calls look(state) at every step.
template <class Look>
Course run(Scene& model, double end, double step, const Look& look) {
    DynamicProblem problem(model);
    EigenLu solver;
    GeneralizedAlphaOptions options;
    options.step = step;
    options.rho = 0.9;
    Course course;
    double work = 0.0, before = 0.0, power_before = 0.0;
    Schedule schedule = equal_intervals(0.0, end, step);
    schedule.observe = [&](const Snapshot& seen) {
        const double time = seen.state.time, power = seen.energies.constraint_power;
        work += 0.5 * (power + power_before) * (time - before);
        before = time;
        power_before = power;
        course.totals.push_back(seen.energies.total() - work);
        look(seen.state);
    };
    course.report = GeneralizedAlpha(options).integrate(problem, solver, schedule);
    return course;
}

/// Returns the largest change of the total energy.
double drift(const Course& course) {
    const auto [least, most] = std::minmax_element(course.totals.begin(), course.totals.end());
    return *most - *least;
}

/// A turn by a - sin a with a = w t, w^2 t^2/2 at first: smooth from rest.
Motion turn(double angle, double duration) {
    const double w = 2.0 * ancf::pi / duration;
    const double scale = angle / (2.0 * ancf::pi);
    return {[=](double t) { return scale * (w * t - std::sin(w * t)); },
            [=](double t) { return scale * w * (1.0 - std::cos(w * t)); },
            [=](double t) { return scale * w * w * std::sin(w * t); }};
}

/// Returns a vector of a node in a state.
Point value(const Scene& model, const State& state, NodeId node, Field field) {
    return state.q.segment<3>(model.coordinate(node, field));
}

TEST_CASE("Universal: two shafts turn by Cardan's law, tan b = tan a cos(bend)",
          "[constraint][dynamics]") {
    const double bend = 0.5, end = 0.5;
    const Point along(1, 0, 0), leaning(std::cos(bend), std::sin(bend), 0);
    Scene model;
    const auto driving = bar(model, Point(-0.2, 0, 0), Point(0, 0, 0));
    const auto driven = bar(model, Point(0, 0, 0), Point(0.2 * leaning));
    // the cross has one arm along Z, in the first shaft, and one along Y turned by the bend
    model.add(DrivenRevolute(model, driving.first(), along, turn(-ancf::pi, end)));
    model.add(Universal(model, driving.last(), driven.first(), Point(0, 0, 1),
                        Point(-std::sin(bend), std::cos(bend), 0)));
    model.add(Revolute(model, driven.last(), leaning));
    double most = 0.0, turned = 0.0;
    const auto course = run(model, end, 2e-3, [&](const State& state) {
        const Point y = value(model, state, driving.first(), Field::r_y);
        const Point z = value(model, state, driven.first(), Field::r_z);
        const double a = std::atan2(y[2], y[1]);
        const Point across(-std::sin(bend), std::cos(bend), 0);
        const double b = std::atan2(-z.dot(across), z[2]);
        most = std::max(
            most, std::abs(std::sin(b) * std::cos(a) - std::cos(b) * std::sin(a) * std::cos(bend)));
        turned = std::max(turned, std::abs(a));
    });
    REQUIRE(course.report.status == Status::converged);
    CHECK(course.report.violation <= held);
    CHECK(turned > 3.0);  // half a turn
    CHECK(most <= 1e-4);  // the shafts twist by some 1e-6
}

TEST_CASE("Weld: beams joined at any angle spin as one body", "[constraint][dynamics]") {
    test::Random random(8);
    const Point direction = random.direction<3>();
    Scene model;
    const auto first = bar(model, Point(0, 0, 0), Point(0.5, 0, 0));
    const auto second = bar(model, Point(0.5, 0, 0), Point(0.5, 0, 0) + 0.4 * direction);
    model.add(Weld(model, first.last(), second.first()));
    const Point spin(2.0, -1.0, 3.0);
    for (int node = 0; node < model.nodes(); ++node)
        for (const Field field : {Field::r, Field::r_x, Field::r_y, Field::r_z})
            model.set_rate({node}, field, cross(spin, model.value({node}, field)));
    const auto angle = [&](const State& state) {
        const auto normal = [&](NodeId node) {  // of the section
            return cross(value(model, state, node, Field::r_y),
                         value(model, state, node, Field::r_z));
        };
        const Point a = normal(first.last()), b = normal(second.first());
        return std::acos(a.dot(b) / (a.norm() * b.norm()));
    };
    const double start = angle(model.state());
    double most = 0.0;
    // 0.4 degrees a step: much more, and the stiff bars stretch too far in the prediction
    const auto course = run(model, 0.4, 2e-3, [&](const State& state) {
        most = std::max(most, std::abs(angle(state) - start));
    });
    REQUIRE(course.report.status == Status::converged);
    CHECK(course.report.violation <= held);
    CHECK(most <= 1e-8);
    CHECK(drift(course) <= 1e-3 * course.report.kinetic_largest);
}

TEST_CASE("point_along: a pendulum hangs on the middle of another beam", "[constraint][dynamics]") {
    Scene model;
    const auto girder = bar(model, Point(-0.5, 0, 0), Point(0.5, 0, 0));
    const auto pendulum = bar(model, Point(0, 0, 0), Point(0, 0, -0.6));
    model.clamp(girder.first());
    model.clamp(girder.last());
    model.add(Pin<3>(point_along<Bar>(model, girder.elements.front(), 0.5), pendulum.first()));
    model.set_gravity(Point(0, -gravity, 0));  // across the pendulum: it falls from the side
    double lowest = 0.0, apart = 0.0;
    const auto course = run(model, 0.7, 2e-3, [&](const State& state) {
        const Point top = value(model, state, pendulum.first(), Field::r);
        const Point tip = value(model, state, pendulum.last(), Field::r);
        lowest = std::min(lowest, tip[1]);
        const auto e = model.element_coordinates<Bar>(girder.elements.front(), state.q);
        apart = std::max(
            apart,
            (model.group<Bar>().element(girder.elements.front()).position(e, 0.5) - top).norm());
    });
    REQUIRE(course.report.status == Status::converged);
    CHECK(apart <= held);
    CHECK(lowest == Approx(-0.6).epsilon(1e-3));  // it passes the lowest point
    CHECK(drift(course) <= 2e-3 * course.report.kinetic_largest);
}

TEST_CASE("AlignedTangent: a pinned bar keeps its tangent in another one's section",
          "[constraint][dynamics]") {
    Scene model;
    const auto first = bar(model, Point(0, 0, 0), Point(0.5, 0, 0));
    const auto second = bar(model, Point(0.5, 0, 0), Point(0.7, 0.3, 0.1));
    model.add(Pin<3>(first.last(), second.first()));
    model.add(AlignedTangent(model, first.last(), second.first()));
    const Point spin(2.0, -1.0, 3.0);
    for (int node = 0; node < model.nodes(); ++node)
        for (const Field field : {Field::r, Field::r_x, Field::r_y, Field::r_z})
            model.set_rate({node}, field, cross(spin, model.value({node}, field)));
    const auto cosines = [&](const State& state) {
        const Point t = value(model, state, second.first(), Field::r_x).normalized();
        const Point y = value(model, state, first.last(), Field::r_y).normalized();
        const Point z = value(model, state, first.last(), Field::r_z).normalized();
        return Point(t.dot(y), t.dot(z), 0.0);
    };
    const Point start = cosines(model.state());
    double most = 0.0;
    const auto course = run(model, 0.2, 2e-3, [&](const State& state) {
        most = std::max(most, (cosines(state) - start).norm());
    });
    REQUIRE(course.report.status == Status::converged);
    CHECK(course.report.violation <= held);
    CHECK(most <= 1e-5);  // r_y and r_z may shear against each other
    CHECK(drift(course) <= 1e-3 * course.report.kinetic_largest);
}

TEST_CASE("Driven: one equation of a pin follows its motion, and its work is the energy's",
          "[constraint][dynamics]") {
    const double end = 0.5;
    Scene model;
    const auto arm = bar(model, Point(0, 0, 0), Point(0.5, 0, 0));
    const Motion course_of = turn(0.3, end);
    model.add(Driven(Pin<3>(arm.first(), Point(0, 0, 0)), {{1, course_of}}));
    double most = 0.0;
    const auto course = run(model, end, 1e-3, [&](const State& state) {
        const Point at = value(model, state, arm.first(), Field::r);
        most = std::max(most, (at - Point(0.0, course_of.value(state.time), 0.0)).norm());
    });
    REQUIRE(course.report.status == Status::converged);
    CHECK(most <= held);
    CHECK(course.report.kinetic_largest > 0.1);
    CHECK(drift(course) <= 5e-3 * course.report.kinetic_largest);
}

TEST_CASE("PlanarWeld: a driven angle between two bars is the one prescribed",
          "[constraint][dynamics][planar]") {
    using Plane = PlanarModel;
    using Point2 = Vector<double, 2>;
    constexpr double end = 0.5;
    Plane model;
    const auto flat = [&](const Point2& from, const Point2& to) {
        return straight_beam<CrossSectionBeam<2>>(model, steel(), rectangle(0.02, 0.02), from, to,
                                                  1, CrossSectionOptions::best());
    };
    const auto first = flat({0.0, 0.0}, {0.5, 0.0}), second = flat({0.5, 0.0}, {0.8, 0.1});
    model.pin(first.first());
    const Motion course_of = turn(0.8, end);
    model.add(PlanarWeld(model, first.last(), second.first(), course_of));
    const auto angle = [&](const State& state) {
        const auto heading = [&](NodeId node) {
            const int at = model.coordinate(node, Field::r_y);
            return std::atan2(state.q[at + 1], state.q[at]);
        };
        return heading(second.first()) - heading(first.last());
    };
    const double start = angle(model.state());
    double most = 0.0;
    DynamicProblem problem(model);
    EigenLu solver;
    GeneralizedAlphaOptions options;
    options.step = 1e-3;
    options.rho = 0.9;
    Schedule schedule = equal_intervals(0.0, end, 1e-3);
    schedule.observe = [&](const Snapshot& seen) {
        const double wanted = start + course_of.value(seen.state.time);
        most = std::max(most, std::abs(angle(seen.state) - wanted));
    };
    const DynamicsReport report = GeneralizedAlpha(options).integrate(problem, solver, schedule);
    REQUIRE(report.status == Status::converged);
    CHECK(report.violation <= held);
    CHECK(most <= held);
    CHECK(report.kinetic_largest > 0.05);
}

TEST_CASE(
    "DrivenRevolute and a driven Pin: the motion is the one prescribed and its work the "
    "energy's",
    "[constraint][dynamics]") {
    const double end = 0.5;
    for (const bool turning : {true, false}) {
        Scene model;
        const auto arm = bar(model, Point(0, 0, 0), Point(0.5, 0, 0));
        const Motion course_of = turn(1.2, end);
        if (turning) {
            model.add(DrivenRevolute(model, arm.first(), Point(0, 0, 1), course_of));
        } else {
            const auto along = [](const auto& f) {
                return [=](double t) -> Point { return f(t) * Point(0.1, 0.2, 0.0); };
            };
            model.add(
                Pin<3>(arm.first(), PointMotion<3>{along(course_of.value), along(course_of.rate),
                                                   along(course_of.acceleration)}));
        }
        double most = 0.0;
        const auto course = run(model, end, 1e-3, [&](const State& state) {
            const double wanted = course_of.value(state.time);
            if (turning) {
                const Point n = value(model, state, arm.first(), Field::r_y);
                // the joint turns space against the section
                most = std::max(most, std::abs(std::atan2(-n[0], n[1]) + wanted));
            } else {
                const Point at = value(model, state, arm.first(), Field::r);
                most = std::max(most, (at - wanted * Point(0.1, 0.2, 0.0)).norm());
            }
        });
        REQUIRE(course.report.status == Status::converged);
        CHECK(most <= held);
        CHECK(course.report.kinetic_largest > 0.1);
        CHECK(drift(course) <= 5e-3 * course.report.kinetic_largest);
    }
}

TEST_CASE("a cable hung on a beam: its weight bends the beam, and both swing with their energy",
          "[model][mixed][dynamics]") {
    Scene model;
    const double length = 0.5;
    const auto girder = bar(model, Point(0, 0, 0), Point(1, 0, 0), 2);
    const auto section = circle(0.005);
    const auto rope =
        straight_beam<Rope>(model, steel(), section, Point(1, 0, 0), Point(1, -length, 0), 2);
    model.clamp(girder.first());
    model.add(Pin<3>(girder.last(), rope.first()));
    model.add_mass(rope.last(), 3.0);
    model.set_gravity(Point(0, -gravity, 0));
    CHECK(model.layout().fields(rope.last().index).count() == 2);  // r and r_x
    CHECK(model.layout().fields(girder.last().index).count() == 4);

    // a rope free of tension is free to swing: statics starts from one that is pulled
    const double pulled = 1.0 + 2e-6;
    for (int k = 0; k <= 2; ++k) {
        model.set_value(rope.node(k), Field::r, Point(1, -0.5 * pulled * length * k, 0));
        model.set_value(rope.node(k), Field::r_x, Point(0, -pulled, 0));
    }
    EigenLu solver;
    REQUIRE(solve_statics(model, solver, {}).status == Status::converged);
    const double rope_weight = gravity * 7800.0 * section.moments().area * length;
    const double hung = rope_weight + 3.0 * gravity;
    const double stiffness = 2e11 * std::pow(0.02, 4) / 12.0;
    const double own = 7800.0 * 0.02 * 0.02 * gravity;
    const double sag = (hung / 3.0 + own / 8.0) / stiffness;
    // slender beam theory without shear, and small angles: sag^2
    CHECK(-model.position(girder.last())[1] == Approx(sag).epsilon(2e-3));
    const double stretch =
        (3.0 * gravity + 0.5 * rope_weight) * length / (2e11 * section.moments().area);
    const double hangs = model.position(rope.first())[1] - model.position(rope.last())[1];
    CHECK(hangs - length == Approx(stretch).epsilon(1e-3));

    model.state().time = 0.0;  // statics keeps its load factor there
    model.set_rate(rope.last(), Field::r, Point(0.5, 0.0, 0.3));
    const auto course = run(model, 0.2, 1e-3, [](const State&) {});
    REQUIRE(course.report.status == Status::converged);
    CHECK(course.report.violation <= held);
    CHECK(drift(course) <= 2e-2 * course.report.kinetic_largest);
}

}  // namespace moving_joints_test
