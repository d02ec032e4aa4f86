// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Joints in equilibrium: a driven one reaches its angle, with its turns, and none holds half a
/// turn off.

#include <ancf/constants.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/path.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <cmath>
#include <vector>

namespace driven_joints_test {

using namespace ancf;
using Flat = CrossSectionBeam<2>;
using Bar = CrossSectionBeam<3>;
using Plane = PlanarModel;
using Space = Model;
using Point2 = Vector<double, 2>;
using Point3 = Vector<double, 3>;

const std::vector<double> angles = {0.1, 1.0, 1.5, 1.7, 2.5, pi, 4.0, 2.0 * pi, 10.0, 20.0};

Material steel() { return Material::isotropic(2e11, 0.3, 7800.0); }

Motion ramp(double angle) {
    return {[=](double t) { return angle * t; }, [=](double) { return angle; },
            [](double) { return 0.0; }};
}

Beam<Flat> flat(Plane& model, const Point2& from, const Point2& to, int elements = 1) {
    return straight_beam<Flat>(model, steel(), rectangle(0.02, 0.02), from, to, elements,
                               CrossSectionOptions::best());
}

Beam<Bar> bar(Space& model, const Point3& from, const Point3& to, int elements = 1) {
    return straight_beam<Bar>(model, steel(), rectangle(0.02, 0.02), from, to, elements,
                              CrossSectionOptions::best());
}

/// Returns the angle in the plane of y and z, or of x and y, from one vector to another.
double turn_between(const Point2& a, const Point2& b) {
    return std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b));
}
double turn_about_x(const Point3& a, const Point3& b) {
    return turn_between({a[1], a[2]}, {b[1], b[2]});
}

StaticsOptions in_steps(int steps) {
    StaticsOptions options;
    options.steps = steps;
    return options;
}

TEST_CASE("a free beam driven at its root turns by the angle, in any number of load steps",
          "[constraint][statics]") {
    int checked = 0;
    for (const double angle : angles)
        for (const int steps : {1, 2, 4, 16})
            for (const bool adaptive : {false, true}) {
                CAPTURE(angle, steps, adaptive);
                EigenLu solver;
                StaticsOptions options = in_steps(steps);
                options.adaptive = adaptive;
                const Point3 turned(std::cos(angle), std::sin(angle), 0.0);
                // a joint to space turns its node by the negative angle
                Plane plane;
                const auto one = flat(plane, {0.0, 0.0}, {1.0, 0.0});
                plane.add(PlanarWeld(plane, one.first(), ramp(-angle)));
                const StaticsReport first = solve_statics(plane, solver, options);
                CHECK(first.status == Status::converged);
                // round-off of the angle; measured 2e-15
                CHECK((plane.position(one.last()) - turned.head<2>()).norm() <= 1e-12);

                Space space;
                const auto two = bar(space, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
                space.add(DrivenRevolute(space, two.first(), Point3(0.0, 0.0, 1.0), ramp(-angle)));
                const StaticsReport second = solve_statics(space, solver, options);
                CHECK(second.status == Status::converged);
                CHECK((space.position(two.last()) - turned).norm() <= 1e-12);
                ++checked;
            }
    CHECK(checked == 80);
}

TEST_CASE("DrivenRevolute: the last multipliers are the moment on the node along t, n and t x n",
          "[constraint][statics]") {
    Space space;
    const auto beam = bar(space, {0.0, 0.0, 0.0}, {0.6, 0.8, 0.0}, 4);
    space.add(DrivenRevolute(space, beam.first(), Point3(0.6, 0.0, 0.8), ramp(0.5)));
    const Point3 force(3.0, -50.0, 20.0);
    space.add(Force<3>(beam.last(), force));
    EigenLu solver;
    REQUIRE(solve_statics(space, solver).status == Status::converged);
    const Point3 n = space.value(beam.first(), Field::r_y).normalized();
    const Point3 c = space.value(beam.first(), Field::r_z).normalized();
    const auto& multipliers = space.state().multipliers;
    const Point3 moment = multipliers[3] * cross(n, c) + multipliers[4] * n + multipliers[5] * c;
    const Point3 arm = space.position(beam.last());
    // r_y and r_z are normal to each other but for a strain; measured 2e-9
    CHECK((moment + cross(arm, force)).norm() <= 1e-7 * moment.norm());
}

TEST_CASE("a torsion beam is not twisted past half a turn of an element unseen",
          "[constraint][statics]") {
    int checked = 0;
    for (const double twist : {2.5, 2.61, 2.63, 3.5, 5.0, 7.0})
        for (const int elements : {1, 2})
            for (const int steps : {1, 20}) {
                CAPTURE(twist, elements, steps);
                EigenLu solver;
                Space model;
                const auto beam = straight_beam<TorsionBeam>(model, steel(), rectangle(0.02, 0.02),
                                                             {0, 0, 0}, {3, 0, 0}, elements);
                model.clamp(beam.first());
                model.add(DrivenRevolute(model, beam.last(), Point3(1.0, 0.0, 0.0),
                                         ramp(-twist * elements)));
                const Status status = solve_statics(model, solver, in_steps(steps)).status;
                CHECK(status == (twist < 2.618 ? Status::converged : Status::degenerate));
                ++checked;
            }
    CHECK(checked == 24);
}

TEST_CASE("a beam between two joints is wound by the whole angle driven", "[constraint][statics]") {
    int checked = 0;
    for (const double angle : {1.7, pi, 4.0, 20.0})
        for (const int steps : {1, 16}) {
            CAPTURE(angle, steps);
            constexpr int elements = 24;  // 0.8 rad each at most
            EigenLu solver;
            // the tip keeps its direction but not its place: a circle's arc of pure bending
            Plane plane;
            const auto line = flat(plane, {0.0, 0.0}, {10.0, 0.0}, elements);
            plane.add(PlanarWeld(plane, line.first(), ramp(-angle)));
            for (const Field field : {Field::r_x, Field::r_y})
                for (const int k : {0, 1}) plane.fix(line.last(), field, k);
            const StaticsReport rolled = solve_statics(plane, solver, in_steps(steps));
            REQUIRE(rolled.status == Status::converged);
            double sum = 0.0;
            for (int k = 0; k < elements; ++k)
                sum += turn_between(plane.value(line.node(k), Field::r_y),
                                    plane.value(line.node(k + 1), Field::r_y));
            CHECK(sum == Approx(-angle).epsilon(1e-12));  // of angles; measured 1e-15
            const double bending = 2e11 * std::pow(0.02, 4) / 12.0;
            CHECK(rolled.strain_energy ==
                  Approx(0.5 * bending * angle * angle / 10.0).epsilon(0.02));

            // a shaft: the tip is held, the root driven about the axis
            Space space;
            const auto shaft = bar(space, {0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}, elements);
            space.clamp(shaft.last());
            space.add(DrivenRevolute(space, shaft.first(), Point3(1.0, 0.0, 0.0), ramp(-angle)));
            const StaticsReport twisted = solve_statics(space, solver, in_steps(steps));
            REQUIRE(twisted.status == Status::converged);
            sum = 0.0;
            for (int k = 0; k < elements; ++k)
                sum += turn_about_x(space.value(shaft.node(k), Field::r_y),
                                    space.value(shaft.node(k + 1), Field::r_y));
            CHECK(sum == Approx(-angle).epsilon(1e-6));  // r_y and r_z may shear
            ++checked;
        }
    CHECK(checked == 8);
}

TEST_CASE("a joint between two nodes reaches the angle that it is driven to",
          "[constraint][statics]") {
    int checked = 0;
    for (const double angle : angles) {
        CAPTURE(angle);
        EigenLu solver;
        Plane plane;
        const auto root = flat(plane, {0.0, 0.0}, {1.0, 0.0}, 2);
        const auto arm = flat(plane, {1.0, 0.0}, {1.0, 0.5}, 2);
        plane.clamp(root.first());
        plane.add(PlanarWeld(plane, root.last(), arm.first(), ramp(angle)));
        REQUIRE(solve_statics(plane, solver).status == Status::converged);
        const Point2 reach(-std::sin(angle), std::cos(angle));
        CHECK((plane.position(arm.last()) - Point2(1.0, 0.0) - 0.5 * reach).norm() <= 1e-12);

        Space space;
        const auto base = bar(space, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 2);
        const auto crank = bar(space, {1.0, 0.0, 0.0}, {1.0, 0.5, 0.0}, 2);
        space.clamp(base.first());
        space.add(
            DrivenRevolute(space, base.last(), crank.first(), Point3(0.0, 0.0, 1.0), ramp(angle)));
        REQUIRE(solve_statics(space, solver).status == Status::converged);
        CHECK((space.position(crank.last()) - Point3(1.0, 0.0, 0.0) -
               0.5 * Point3(reach[0], reach[1], 0.0))
                  .norm() <= 1e-12);
        ++checked;
    }
    CHECK(checked == 10);
}

TEST_CASE("joints assembled the wrong way round are not accepted there", "[constraint][statics]") {
    test::Random random(11);
    int converged = 0, tried = 0;
    for (const double angle : {1.0, 2.0, 2.5, 3.0, pi})
        for (int kind = 0; kind < 4; ++kind) {
            CAPTURE(angle, kind);
            Space model;
            const auto beam = bar(model, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
            const Point3 across(0.0, 0.0, 1.0);
            if (kind == 0) model.add(Weld(model, beam.first()));
            if (kind == 1) model.add(Revolute(model, beam.first(), Point3(1.0, 0.0, 0.0)));
            if (kind == 2) model.add(DrivenRevolute(model, beam.first(), across, ramp(0.0)));
            if (kind == 3) {
                model.add(AlignedTangent(model, beam.first()));
                for (const int k : {0, 1, 2}) model.fix(beam.first(), Field::r, k);
            }
            if (kind % 2 == 1) model.fix(beam.last(), Field::r_y, 2);  // no spin about the beam
            const Matrix<double, 3> turn = test::rotation(Point3(angle * across));
            for (int node = 0; node < model.nodes(); ++node)
                for (const Field field : {Field::r, Field::r_x, Field::r_y, Field::r_z})
                    model.set_value({node}, field, turn * model.value({node}, field));
            EigenLu solver;
            const StaticsReport report = solve_statics(model, solver);
            ++tried;
            if (report.status != Status::converged) continue;
            ++converged;
            // the joint alone: a single element thrown about may end folded
            const Point3 normal = cross(Point3(model.value(beam.first(), Field::r_y)),
                                        Point3(model.value(beam.first(), Field::r_z)));
            const Point3 held = kind == 3 ? Point3(model.value(beam.first(), Field::r_x)) : normal;
            CHECK((held / held.norm() - Point3(1.0, 0.0, 0.0)).norm() <= 1e-9);
        }
    CHECK(tried == 20);
    CHECK(converged >= 8);  // measured 15
}

TEST_CASE("planar welds assembled the wrong way round turn back", "[constraint][statics]") {
    int converged = 0;
    for (const double angle : {1.0, 2.0, 2.5, 3.0, pi, -2.0, -3.0}) {
        CAPTURE(angle);
        Plane model;
        const auto beam = flat(model, {0.0, 0.0}, {1.0, 0.0});
        model.add(PlanarWeld(model, beam.first()));
        const Matrix<double, 2> turn{{std::cos(angle), -std::sin(angle)},
                                     {std::sin(angle), std::cos(angle)}};
        for (int node = 0; node < model.nodes(); ++node)
            for (const Field field : {Field::r, Field::r_x, Field::r_y})
                model.set_value({node}, field, turn * model.value({node}, field));
        EigenLu solver;
        const StaticsReport report = solve_statics(model, solver);
        if (report.status != Status::converged) continue;
        ++converged;
        CHECK(std::abs(turn_between({0.0, 1.0}, model.value(beam.first(), Field::r_y))) <= 1e-9);
    }
    CHECK(converged >= 4);  // of 7, measured 6
}

TEST_CASE("a weld that Newton's method throws about never ends half a turn off",
          "[constraint][statics]") {
    int converged = 0, tried = 0;
    for (int power = 0; power <= 40; ++power) {
        const double load = std::pow(10.0, 0.1 * power);  // of EI/L^2
        CAPTURE(load);
        Plane model;
        const auto column = flat(model, {0.0, 0.0}, {0.0, 1.0}, 2);
        const auto girder = flat(model, {0.0, 1.0}, {1.0, 1.0}, 2);
        model.clamp(column.first());
        model.add(PlanarWeld(model, column.last(), girder.first()));
        const double bending = 2e11 * std::pow(0.02, 4) / 12.0;
        model.add(Force<2>(girder.last(), Point2(0.0, -load * bending)));
        EigenLu solver;
        ++tried;
        const StaticsReport report = solve_statics(model, solver);
        if (report.status != Status::converged) continue;
        ++converged;
        const Point2 a = model.value(column.last(), Field::r_y);
        const Point2 b = model.value(girder.first(), Field::r_y);
        CHECK(std::abs(turn_between(a, b) + 0.5 * pi) <= 1e-9);
    }
    CHECK(converged >= 5);  // measured 7
    CHECK(tried == 41);
}

TEST_CASE("a driven angle that jumps by more than half a turn is refused with the reason",
          "[constraint][statics]") {
    const auto jump = [](double angle) -> Motion {
        return {[=](double t) { return t > 0.5 ? angle : 0.0; }, [](double) { return 0.0; },
                [](double) { return 0.0; }};
    };
    EigenLu solver;
    for (const int steps : {1, 2, 16}) {
        CAPTURE(steps);
        Plane model;
        const auto beam = flat(model, {0.0, 0.0}, {1.0, 0.0});
        model.add(PlanarWeld(model, beam.first(), jump(-4.0)));
        const StaticsReport report = solve_statics(model, solver, in_steps(steps));
        CHECK(report.status == Status::diverged);
        CHECK_THAT(report.message, ContainsSubstring("planar weld of node 0 and space"));
        CHECK_THAT(report.message, ContainsSubstring("driven by 4 rad"));
        CHECK((model.position(beam.last()) - Point2(1.0, 0.0)).norm() <= 1e-12);
    }
    Plane model;
    const auto beam = flat(model, {0.0, 0.0}, {1.0, 0.0});
    model.add(PlanarWeld(model, beam.first(), jump(-1.0)));
    CHECK(solve_statics(model, solver).status == Status::converged);
    CHECK(model.position(beam.last())[1] == Approx(std::sin(1.0)).epsilon(1e-12));
}

TEST_CASE("the parts of a load step are its own: progress sees the steps asked for",
          "[constraint][statics]") {
    Plane model;
    const auto beam = flat(model, {0.0, 0.0}, {1.0, 0.0});
    model.add(PlanarWeld(model, beam.first(), ramp(-4.0)));
    EigenLu solver;
    StaticsOptions options = in_steps(2);
    std::vector<double> seen;
    options.progress = [&](double factor, const State&) {
        seen.push_back(factor);
        return true;
    };
    const StaticsReport report = solve_statics(model, solver, options);
    CHECK(report.status == Status::converged);
    CHECK(seen == std::vector<double>{0.5, 1.0});
    CHECK(report.steps.size() == 4);  // 2 rad in two parts each
}

TEST_CASE("solve_statics: a joint that an angle holds far off from the start is reached or named",
          "[constraint][statics]") {
    int refused = 0;
    const auto check = [&](auto& model, double angle) {
        EigenLu solver;
        const StaticsReport report = solve_statics(model, solver);
        CAPTURE(angle, report.message);
        if (report.status == Status::converged) return;
        ++refused;
        CHECK_THAT(report.message,
                   ContainsSubstring("constraint 0 (") &&
                       ContainsSubstring("began more than 1.0472 rad off the angle"));
    };
    for (const double angle : {2.5, 3.0, pi, 4.0}) {
        const Motion held{[=](double) { return -angle; }, [](double) { return 0.0; },
                          [](double) { return 0.0; }};
        Plane plane;
        plane.add(PlanarWeld(plane, flat(plane, {0.0, 0.0}, {1.0, 0.0}, 3).first(), held));
        check(plane, angle);
        Space space;
        const NodeId root =
            straight_beam<Bar>(space, steel(), rectangle(0.03, 0.02), {0.0, 0.0, 0.0},
                               {1.0, 0.0, 0.0}, 3, CrossSectionOptions::best())
                .first();
        space.add(DrivenRevolute(space, root, Point3(0.0, 0.0, 1.0), held));
        check(space, angle);
    }
    CHECK(refused > 0);  // 3 of 8
    // a failure of another cause does not blame the joint
    Plane plane;
    const auto beam = flat(plane, {0.0, 0.0}, {1.0, 0.0}, 3);
    plane.add(PlanarWeld(plane, beam.first(), ramp(-1.0)));
    plane.add(Force<2>(beam.last(), {0.0, 1e3}));
    EigenLu solver;
    StaticsOptions options;
    options.max_iterations = 1;
    const StaticsReport report = solve_statics(plane, solver, options);
    CHECK(report.status != Status::converged);
    CHECK_THAT(report.message, !ContainsSubstring("began more than"));
}

TEST_CASE("follow_path: a driven joint reaches its angle with the load factor",
          "[constraint][path]") {
    for (const double angle : {1.0, pi, 4.0, 10.0}) {
        CAPTURE(angle);
        Plane model;
        const auto beam = flat(model, {0.0, 0.0}, {1.0, 0.0}, 8);
        model.add(PlanarWeld(model, beam.first(), ramp(-angle)));
        for (const Field field : {Field::r_x, Field::r_y})
            for (const int k : {0, 1}) model.fix(beam.last(), field, k);
        EigenLu solver;
        PathOptions options;
        options.last_factor = 1.0;
        options.first_step = 1.0;
        options.branch_step = 10.0;
        const PathReport report = follow_path(model, solver, options);
        REQUIRE(report.status == Status::converged);
        double sum = 0.0;
        for (int k = 0; k < 8; ++k)
            sum += turn_between(model.value(beam.node(k), Field::r_y),
                                model.value(beam.node(k + 1), Field::r_y));
        CHECK(sum == Approx(-angle).epsilon(1e-12));
    }
}

TEST_CASE("a slider-crank's slider is where the crank's angle puts it, on any line",
          "[constraint][statics]") {
    // The guide passes through the crank's axis; crank 0.3 m, rod 0.5 m.
    const Point3 along = Point3(0.6, -0.2, 0.5).normalized();
    const Point3 across = cross(along, Point3(0.1, 1.0, 0.3)).normalized();
    const Point3 axis = cross(along, across), root(0.2, 0.1, -0.3);
    int checked = 0;
    for (const double angle : {0.5, 1.6, 3.0, 4.0, 6.2}) {
        Space model;
        const auto crank = bar(model, root, root + 0.3 * along),
                   rod = bar(model, root + 0.3 * along, root + 0.8 * along);
        // the node against space, so by the opposite angle
        model.add(DrivenRevolute(model, crank.first(), axis, ramp(-angle)));
        model.add(Revolute(model, crank.last(), rod.first(), axis));
        model.add(PointOnLine(rod.last(), root, along));
        EigenLu solver;
        const StaticsReport report = solve_statics(model, solver, in_steps(16));
        CAPTURE(angle, report.message);
        REQUIRE(report.status == Status::converged);
        const double place =
            0.3 * std::cos(angle) + std::sqrt(0.25 - std::pow(0.3 * std::sin(angle), 2));
        CHECK((model.value(rod.last(), Field::r) - root - place * along).norm() <= 1e-9);
        CHECK(report.strain_energy <= 1e-6);
        ++checked;
    }
    CHECK(checked == 5);
}

TEST_CASE("a weighted slider rests on its guide by the force across it", "[constraint][statics]") {
    // A rod pinned at one end, its other end on a slope of 30 degrees.
    Plane model;
    const auto rod = flat(model, {0.0, 0.0}, {1.0, 0.0});
    model.pin(rod.first());
    const Point2 slope(std::cos(pi / 6.0), std::sin(pi / 6.0));
    model.add(PointOnLine(rod.last(), {1.0, 0.0}, slope));
    model.add(Force<2>(rod.last(), {0.0, -100.0}));
    EigenLu solver;
    REQUIRE(solve_statics(model, solver).status == Status::converged);
    // The rod carries no shear; -1.0000 of the force measured.
    REQUIRE(model.state().multipliers.size() == 1);
    CHECK(std::abs(model.state().multipliers[0] + 100.0 / slope[0]) <= 1e-3);
}

}  // namespace driven_joints_test
