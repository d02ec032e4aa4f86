// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Builders of curved beams and frames: their geometry, mass and stiffness.

#include <ancf/constants.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace curve_test {

using namespace ancf;
using Spatial = CrossSectionBeam<3, Geodesic>;
using Planar = CrossSectionBeam<2>;
using P2 = Vector<double, 2>;
using P3 = Vector<double, 3>;

using ancf::pi;
constexpr double side = 0.02, density = 7800.0;

Material steel() { return Material::isotropic(2e11, 0.3, density); }
Section square() { return rectangle(side, side); }
CrossSectionOptions accurate() {
    return {Rule::mixed(), TransverseStrain::stretch, SectionModel::saint_venant};
}

/// Checks that slopes are orthonormal and right-handed.
void check_frame(const Model& model, NodeId node) {
    const P3 x = model.value(node, Field::r_x), y = model.value(node, Field::r_y);
    const P3 z = model.value(node, Field::r_z);
    CHECK(x.norm() == Approx(1.0).epsilon(1e-14));
    CHECK(y.norm() == Approx(1.0).epsilon(1e-14));
    CHECK((z - cross(x, y)).norm() <= 1e-14);
}

double total_length(const Scene& model) {
    double sum = 0.0;
    const auto& group = model.group<Spatial>();
    for (int k = 0; k < static_cast<int>(group.connections.size()); ++k)
        sum += group.element(k).length();
    return sum;
}

/// Returns the displacement of the tip of a quarter of a circle, radius 1, clamped at the origin,
/// that starts along X and turns towards Y.
P3 quarter_tip(int elements, const P3& force, const CrossSectionOptions& options = accurate()) {
    Model model;
    const auto beam = arc<Spatial>(model, steel(), square(), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1.0,
                                   0.5 * pi, elements, options);
    model.clamp(beam.first());
    model.add(Force<3>(beam.last(), force));
    const P3 start = model.position(beam.last());
    EigenLdlt solver;
    const auto report = solve_statics(model, solver);
    REQUIRE(report.status == Status::converged);
    return model.position(beam.last()) - start;
}

P2 quarter_tip(int elements, const P2& force) {
    PlanarModel model;
    const auto beam =
        arc<Planar>(model, steel(), square(), {0, 0}, {1, 0}, 1.0, 0.5 * pi, elements, accurate());
    model.clamp(beam.first());
    model.add(Force<2>(beam.last(), force));
    const P2 start = model.position(beam.last());
    EigenLdlt solver;
    const auto report = solve_statics(model, solver);
    REQUIRE(report.status == Status::converged);
    return model.position(beam.last()) - start;
}

/// Returns the order from the solutions of three meshes, each twice as fine as the one before.
template <class Point>
double order(const Point& coarse, const Point& middle, const Point& fine) {
    return std::log2((coarse - middle).norm() / (middle - fine).norm());
}

TEST_CASE("straight_beam_with_slopes: slopes under which it is not free of stress are refused",
          "[model][builders][bad-input]") {
    const auto spatial = [](const Matrix<double, 3>& slopes) {
        Model model;
        const auto beam = straight_beam_with_slopes<Spatial>(model, steel(), square(), {0, 0, 0},
                                                             {0, 0, 1}, slopes, 2);
        const auto e = model.element_coordinates<Spatial>(beam.elements[1]);
        return model.group<Spatial>().element(beam.elements[1]).force(e).norm();
    };
    Matrix<double, 3> upright;  // r_x along Z
    upright << 0, 1, 0, 0, 0, 1, 1, 0, 0;
    CHECK(spatial(upright) <= 1e-6);               // of E A = 8e7 N
    CHECK_NOTHROW(spatial(upright * (1 + 1e-9)));  // round-off of given numbers
    Matrix<double, 3> sheared = upright, left = upright;
    sheared.col(1) += 0.01 * sheared.col(0);
    left.col(2) *= -1.0;
    int refused = 0;
    for (const Matrix<double, 3>& slopes : {Matrix<double, 3>(Matrix<double, 3>::Identity()),
                                            Matrix<double, 3>(2.0 * upright), sheared, left}) {
        CHECK_THROWS_AS(spatial(slopes), InvalidArgument);
        ++refused;
    }
    CHECK(refused == 4);
    Model ropes;  // r_y and r_z are no vectors of a cable
    sheared.col(2) *= -1.0;
    CHECK_NOTHROW(straight_beam_with_slopes<Cable<3>>(ropes, steel(), square(), {0, 0, 0},
                                                      {0, 0, 1}, sheared, 2));
    PlanarModel plane;
    CHECK_THROWS_AS(straight_beam_with_slopes<Planar>(plane, steel(), square(), {0, 0}, {0, 1},
                                                      Matrix<double, 2>::Identity(), 2),
                    InvalidArgument);
    CHECK(plane.nodes() == 0);
}

TEST_CASE("arc: nodes lie on the circle, y to its centre, elements are equal", "[model][curve]") {
    Model model;
    const P3 from(1.0, -2.0, 0.5), tangent(0.0, 3.0, 4.0), normal(1.0, 0.2, 0.0);
    const double radius = 2.5, angle = 2.0;
    const auto beam =
        arc<Spatial>(model, steel(), square(), from, tangent, normal, radius, angle, 8);
    const Matrix<double, 3> frame = reference_slopes(tangent, normal);
    const P3 centre = from + radius * frame.col(1);
    REQUIRE(beam.nodes.size() == 9);
    CHECK(beam.prototypes.size() == 1);
    for (int k = 0; k <= 8; ++k) {
        const NodeId node = beam.node(k);
        check_frame(model, node);
        const P3 inward = centre - model.position(node);
        CHECK(inward.norm() == Approx(radius).epsilon(1e-14));
        CHECK((model.value(node, Field::r_y) - inward / radius).norm() <= 1e-14);
        CHECK(std::acos(model.value(node, Field::r_x).dot(frame.col(0))) ==
              Approx(angle * k / 8).margin(1e-7));
    }
    // the Hermite lines are shorter than the arc by (angle of one element)^4/720
    CHECK(1.0 - total_length(model) / (radius * angle) ==
          Approx(std::pow(angle / 8, 4) / 720.0).epsilon(0.02));
    for (int k = 0; k < 8; ++k) {
        const auto e = model.element_coordinates<Spatial>(k);
        const double scale = steel().young * square().moments().area;
        CHECK(model.group<Spatial>().element(k).force(e).norm() <= 1e-13 * scale);
    }
}

TEST_CASE("arc: in the plane it turns to either side", "[model][curve][planar]") {
    for (const double angle : {1.5, -1.5}) {
        PlanarModel model;
        const auto beam = arc<Planar>(model, steel(), square(), {0, 0}, {0, 2}, 3.0, angle, 6);
        const double sign = angle > 0.0 ? 1.0 : -1.0;
        const P2 tip = model.position(beam.last());
        CHECK(tip[0] == Approx(-sign * 3.0 * (1.0 - std::cos(angle))));
        CHECK(tip[1] == Approx(3.0 * std::sin(1.5)));
        const P2 x = model.value(beam.last(), Field::r_x), y = model.value(beam.last(), Field::r_y);
        CHECK((x - P2(-std::sin(angle), std::cos(angle))).norm() <= 1e-14);
        CHECK((y - P2(-x[1], x[0])).norm() <= 1e-14);
    }
}

TEST_CASE("arc: its mass and weight are those of the ring's part", "[model][curve]") {
    Model model;
    const double radius = 1.0, angle = 0.5 * pi;
    const auto beam =
        arc<Spatial>(model, steel(), square(), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, radius, angle, 16);
    const double mass = density * side * side * radius * angle;
    const P3 g(0.0, -9.81, 0.0);
    P3 sum = P3::Zero();
    double work = 0.0;
    for (int k = 0; k < 16; ++k) {
        const auto weight = model.group<Spatial>().element(k).gravity(g);
        sum += weight.segment<3>(0) + weight.segment<3>(12);
        work += weight.dot(model.element_coordinates<Spatial>(k));
    }
    CHECK((sum - mass * g).norm() <= 1e-6 * mass * g.norm());  // (pi/32)^4/720 = 1.3e-7
    const double height = radius * (1.0 - std::sin(angle) / angle);
    CHECK(work == Approx(-9.81 * mass * height).epsilon(1e-5));
    CHECK(beam.elements.size() == 16);
}

TEST_CASE("helix: nodes lie on it, tangents have its slope, y points to the axis",
          "[model][curve]") {
    for (const double pitch : {0.8, -0.8, 0.0}) {
        Model model;
        const double radius = 0.5, turns = 1.5;
        const P3 centre(0.1, 0.2, 0.3);
        const auto beam = helix<Spatial>(model, steel(), square(), centre, P3(0, 0, 2), P3(1, 0, 1),
                                         radius, pitch, turns, 24);
        for (int k = 0; k <= 24; ++k) {
            const NodeId node = beam.node(k);
            check_frame(model, node);
            const double turn = 2.0 * pi * turns * k / 24;
            const P3 expected = centre + P3(radius * std::cos(turn), radius * std::sin(turn),
                                            pitch * turns * k / 24);
            CHECK((model.position(node) - expected).norm() <= 1e-14);
            CHECK(
                (model.value(node, Field::r_y) + P3(std::cos(turn), std::sin(turn), 0.0)).norm() <=
                1e-14);
            CHECK(model.value(node, Field::r_x)[2] ==
                  Approx(pitch / std::hypot(pitch, 2.0 * pi * radius)).margin(1e-15));
        }
        const double length = turns * std::hypot(pitch, 2.0 * pi * radius);
        CHECK(total_length(model) == Approx(length).epsilon(5e-5));  // (pi/8)^4/720 = 3.3e-5
    }
}

TEST_CASE("spline: it passes through its points, smooth and without needless twist",
          "[model][curve]") {
    SECTION("points of a parabola give its tangents") {
        Model model;
        std::vector<P3> through;
        for (const double x : {0.0, 0.3, 0.5, 1.0}) through.emplace_back(x, 0.0, x * x);
        const auto beam = spline<Spatial>(model, steel(), square(), through, P3(0, 1, 0));
        CHECK(beam.prototypes.size() == 3);
        for (std::size_t k = 0; k < through.size(); ++k) {
            const NodeId node = beam.nodes[k];
            check_frame(model, node);
            CHECK((model.position(node) - through[k]).norm() == 0.0);
            // a plane curve keeps the normal of its plane
            CHECK((model.value(node, Field::r_y) - P3(0, 1, 0)).norm() <= 1e-14);
        }
        // on an inner node between equal chords the secant is the tangent's direction
        const P3 x = model.value(beam.node(1), Field::r_x);
        CHECK(x[2] / x[0] == Approx(2.0 * 0.3).epsilon(0.1));
    }
    SECTION("a straight row of points is a straight beam") {
        Model model;
        const auto beam = spline<Spatial>(model, steel(), square(),
                                          {P3(0, 0, 0), P3(1, 1, 1), P3(3, 3, 3)}, P3(0, 0, 1));
        CHECK(total_length(model) == Approx(3.0 * std::sqrt(3.0)).epsilon(1e-14));
        CHECK(
            (model.value(beam.last(), Field::r_y) - model.value(beam.first(), Field::r_y)).norm() <=
            1e-14);
    }
    SECTION("points of a circle approach its length") {
        double error[2];
        for (int k = 0; k < 2; ++k) {
            Model model;
            std::vector<P3> through;
            const int elements = 16 << k;
            for (int n = 0; n <= elements; ++n) {
                const double turn = pi * n / elements;
                through.emplace_back(std::cos(turn), std::sin(turn), 0.0);
            }
            (void)spline<Spatial>(model, steel(), square(), through, P3(0, 0, 1));
            error[k] = std::abs(total_length(model) / pi - 1.0);
        }
        CHECK(error[0] <= 2e-3);
        CHECK(error[1] <= 0.26 * error[0]);  // chords for arcs: second order at least
    }
    SECTION("points that go straight back are named") {
        Model model;
        CHECK_THROWS_WITH(spline<Spatial>(model, steel(), square(),
                                          {P3(0, 0, 0), P3(1, 0, 0), P3(0.5, 0, 0)}, P3(0, 1, 0)),
                          ContainsSubstring("folds back on itself between points 0 and 1"));
    }
}

TEST_CASE("arc: a quarter of a circle yields as beam theory says", "[model][curve][statics]") {
    const double E = steel().young, G = steel().shear, A = side * side;
    const double I = square().moments().yy, J = square().torsion_constant();
    const double k = square().shear_correction_y();
    const double P = 1.0;  // moves the tip by 3e-4: linear to 1e-6, and far above round-off
    // unit radius; lever arms cos and sin of the angle, 1 - cos for the torque
    const double in_plane = 0.25 * pi * P * (1.0 / (E * I) + 1.0 / (E * A) + 1.0 / (k * G * A));
    const double aside =
        P * (0.25 * pi / (E * I) + (0.75 * pi - 2.0) / (G * J) + 0.5 * pi / (k * G * A));
    // what is left out is (depth/radius)^2/12 = 3e-5
    CHECK(quarter_tip(16, P3(P, 0, 0))[0] == Approx(in_plane).epsilon(1e-4));
    CHECK(quarter_tip(16, P3(0, 0, P))[2] == Approx(aside).epsilon(1e-3));  // see the orders below
    CHECK(quarter_tip(64, P3(0, 0, P))[2] == Approx(aside).epsilon(1e-4));
    CHECK(quarter_tip(16, P2(P, 0))[0] == Approx(in_plane).epsilon(1e-4));
}

TEST_CASE("arc: curved elements converge with the fourth order in their plane, the second across",
          "[model][curve][statics]") {
    const double P = steel().young * square().moments().yy;  // bends by more than a radian
    const P3 flat_in_space = P3(0.5, 0.0, 0.0) * P;
    CHECK(order(quarter_tip(4, flat_in_space), quarter_tip(8, flat_in_space),
                quarter_tip(16, flat_in_space)) >= 3.5);
    // across, the torque varies along the arc, and slopes that are linear make the twist linear
    const P3 skew = P3(0.4, 0.0, 0.5) * P;
    CHECK(order(quarter_tip(4, skew), quarter_tip(8, skew), quarter_tip(16, skew)) >= 1.9);
    const P2 flat = P2(0.5, 0.0) * P;
    CHECK(order(quarter_tip(4, flat), quarter_tip(8, flat), quarter_tip(16, flat)) >= 3.5);
}

TEST_CASE("welds and moments: a deep beam is as stiff as a clamped one, however fine the mesh",
          "[model][constraint][statics]") {
    const double depth = 0.2, small = 1e-3 * 2e11 * std::pow(depth, 4) / 12.0;
    const int elements = GENERATE(4, 16, 64);
    INFO("elements " << elements);
    SECTION("in space") {
        const auto tip = [&](bool welded, const auto& load) {
            Model model;
            const auto beam = straight_beam<Spatial>(model, steel(), rectangle(depth, depth),
                                                     {0, 0, 0}, {1, 0, 0}, elements, accurate());
            if (welded)
                model.add(Weld(model, beam.first()));
            else
                model.clamp(beam.first(), Clamp::free_slope);
            model.add(load(beam.last()));
            EigenLu solver;
            REQUIRE(solve_statics(model, solver).status == Status::converged);
            Vector<double, 9> all;
            all << model.position(beam.last()), model.value(beam.last(), Field::r_y),
                model.value(beam.last(), Field::r_z);
            return all;
        };
        const auto compare = [&](const auto& load) {
            const auto welded = tip(true, load), clamped = tip(false, load);
            // a weld leaves the section free to swell, which is of second order
            CHECK((welded - clamped).norm() <= 1e-10);
            return welded;
        };
        compare([&](NodeId end) { return Force<3>(end, {0, small, 0.5 * small}); });
        // the moments turn the end section as beam theory says, by 1e-3 or E I/(G J) times that
        const auto bent = compare([&](NodeId end) { return Moment(end, {0, 0, small}); });
        CHECK(-bent[3] == Approx(1e-3).epsilon(1e-5));
        const auto twisted = compare([&](NodeId end) { return Moment(end, {small, 0, 0}); });
        const double J = rectangle(depth, depth).torsion_constant();
        const double turn = small / (steel().shear * J);
        CHECK(twisted[5] == Approx(turn).epsilon(1e-5));
        CHECK(-twisted[7] == Approx(turn).epsilon(1e-5));
    }
    SECTION("in the plane") {
        const auto tip = [&](bool welded) {
            PlanarModel model;
            const auto beam = straight_beam<Planar>(model, steel(), rectangle(depth, depth), {0, 0},
                                                    {1, 0}, elements, accurate());
            if (welded)
                model.add(PlanarWeld(model, beam.first()));
            else
                model.clamp(beam.first(), Clamp::free_slope);
            model.add(Force<2>(beam.last(), {0, small}));
            EigenLu solver;
            REQUIRE(solve_statics(model, solver).status == Status::converged);
            return model.position(beam.last());
        };
        CHECK((tip(true) - tip(false)).norm() <= 1e-11);
    }
}

TEMPLATE_TEST_CASE("point_along: it lies on the centre line of curved elements", "[model][curve]",
                   Spatial, QuinticBeam<>) {
    Model model;
    const auto beam = spline<TestType>(
        model, steel(), square(), {P3(0, 0, 0), P3(0.5, 0.3, 0), P3(0.7, 0.9, 0.3)}, P3(0, 0, 1));
    const auto& group = model.group<TestType>();
    for (const int k : beam.elements)
        for (const double xi : {0.0, 0.3, 0.5, 1.0}) {
            const MaterialPoint point = point_along<TestType>(model, k, xi);
            P3 place = P3::Zero();
            for (std::size_t i = 0; i < point.vectors.size(); ++i)
                place +=
                    point.weights[i] * model.value(point.vectors[i].node, point.vectors[i].field);
            const auto e = model.element_coordinates<TestType>(k);
            CHECK((place - group.element(k).position(e, xi)).norm() <= 1e-15);
        }
}

TEST_CASE("polyline: a right angle yields as its two legs and keeps its corner",
          "[model][curve][statics]") {
    const double E = steel().young, G = steel().shear, I = square().moments().yy;
    const double J = square().torsion_constant(), P = 1.0;
    SECTION("in space, loaded across the plane") {
        Model model;
        const auto line = polyline<Spatial>(model, steel(), square(),
                                            {P3(0, 0, 0), P3(1, 0, 0), P3(1, 1, 0)}, 4, accurate());
        const auto& legs = line.members;
        REQUIRE(legs.size() == 2);
        model.clamp(line.joints[0]);
        model.add(Force<3>(legs[1].last(), P3(0, 0, P)));
        EigenLu solver;
        REQUIRE(solve_statics(model, solver).status == Status::converged);
        const double expected = P * (2.0 / (3.0 * E * I) + 1.0 / (G * J));
        // shear adds 1e-4 of it
        CHECK(model.position(legs[1].last())[2] == Approx(expected).epsilon(2e-4));
        CHECK((model.position(legs[0].last()) - model.position(legs[1].first())).norm() <= 1e-14);
    }
    SECTION("in the plane, far bent") {
        PlanarModel model;
        const auto line = polyline<Planar>(model, steel(), square(),
                                           {P2(0, 0), P2(1, 0), P2(1, 1), P2(2, 1)}, 4, accurate());
        const auto& legs = line.members;
        REQUIRE(legs.size() == 3);
        model.clamp(line.joints[0]);
        model.add(Force<2>(legs[2].last(), P2(0.0, 0.5 * E * I)));
        EigenLu solver;
        REQUIRE(solve_statics(model, solver).status == Status::converged);
        for (int k = 0; k < 2; ++k) {
            const auto& before = legs[static_cast<std::size_t>(k)];
            const auto& after = legs[static_cast<std::size_t>(k + 1)];
            const P2 a = model.value(before.last(), Field::r_y),
                     b = model.value(after.first(), Field::r_y);
            // a joint yields by M/(k G A h), k = 100, M at most the force times 1 m
            const double yielding = 0.5 * E * I / (100.0 * G * side * side * side);
            CHECK(std::abs(a.dot(b)) <= yielding);
            CHECK(a[0] * b[1] - a[1] * b[0] == Approx(k == 0 ? 1.0 : -1.0).epsilon(0.01));
        }
        CHECK(model.position(legs[2].last())[1] > 1.3);
    }
}

TEST_CASE("curve builders: what is no curve is refused", "[model][curve][bad-input]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Material m = steel();
    const Section s = square();
    const P3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0);
    struct Case {
        const char* what;
        std::function<void(Model&)> build;
    };
    const Case cases[] = {
        {"arc: no radius", [&](Model& a) { arc<Spatial>(a, m, s, o, x, y, 0.0, 1.0, 4); }},
        {"arc: negative radius", [&](Model& a) { arc<Spatial>(a, m, s, o, x, y, -1.0, 1.0, 4); }},
        {"arc: no angle", [&](Model& a) { arc<Spatial>(a, m, s, o, x, y, 1.0, 0.0, 4); }},
        {"arc: angle no number", [&](Model& a) { arc<Spatial>(a, m, s, o, x, y, 1.0, nan, 4); }},
        {"arc: no elements", [&](Model& a) { arc<Spatial>(a, m, s, o, x, y, 1.0, 1.0, 0); }},
        {"arc: parallel directions",
         [&](Model& a) { arc<Spatial>(a, m, s, o, x, x, 1.0, 1.0, 4); }},
        {"arc: no tangent", [&](Model& a) { arc<Spatial>(a, m, s, o, o, y, 1.0, 1.0, 4); }},
        {"arc: start no number",
         [&](Model& a) { arc<Spatial>(a, m, s, P3(nan, 0, 0), x, y, 1.0, 1.0, 4); }},
        {"helix: no radius", [&](Model& a) { helix<Spatial>(a, m, s, o, x, y, 0.0, 1.0, 1.0, 4); }},
        {"helix: pitch no number",
         [&](Model& a) { helix<Spatial>(a, m, s, o, x, y, 1.0, nan, 1.0, 4); }},
        {"helix: no turns", [&](Model& a) { helix<Spatial>(a, m, s, o, x, y, 1.0, 1.0, 0.0, 4); }},
        {"helix: no elements",
         [&](Model& a) { helix<Spatial>(a, m, s, o, x, y, 1.0, 1.0, 1.0, 0); }},
        {"helix: parallel directions",
         [&](Model& a) { helix<Spatial>(a, m, s, o, x, x, 1.0, 1.0, 1.0, 4); }},
        {"spline: one point", [&](Model& a) { spline<Spatial>(a, m, s, {o}, y); }},
        {"spline: a point twice",
         [&](Model& a) {
             spline<Spatial>(a, m, s, {o, x, x}, y);
         }},
        {"spline: no number",
         [&](Model& a) {
             spline<Spatial>(a, m, s, {o, P3(nan, 0, 0)}, y);
         }},
        {"spline: y along it",
         [&](Model& a) {
             spline<Spatial>(a, m, s, {o, x}, x);
         }},
        {"polyline: one point", [&](Model& a) { polyline<Spatial>(a, m, s, {o}, 4); }},
        {"polyline: a point twice",
         [&](Model& a) {
             polyline<Spatial>(a, m, s, {o, o}, 4);
         }},
        {"polyline: no elements",
         [&](Model& a) {
             polyline<Spatial>(a, m, s, {o, x, y}, 0);
         }},
        {"beam_through: one point",
         [&](Model& a) {
             beam_through<Spatial>(a, m, s, {{o, reference_slopes(x)}}, {1.0});
         }},
        {"beam_through: lengths that do not fit",
         [&](Model& a) {
             beam_through<Spatial>(a, m, s, {{o, reference_slopes(x)}, {x, reference_slopes(x)}},
                                   {1.0, 1.0});
         }},
        {"beam_through: one length, the second element twice as long",
         [&](Model& a) {
             beam_through<Spatial>(a, m, s,
                                   {{o, reference_slopes(x)},
                                    {x, reference_slopes(x)},
                                    {3.0 * x, reference_slopes(x)}},
                                   {1.0});
         }},
        {"beam_through: one length, the second element bent",
         [&](Model& a) {
             beam_through<Spatial>(a, m, s,
                                   {{o, reference_slopes(x)},
                                    {x, reference_slopes(x)},
                                    {2.0 * x, reference_slopes(P3(1.0, 0.1, 0.0))}},
                                   {1.0});
         }},
    };
    for (const Case& each : cases) {
        INFO(each.what);
        Model model;
        CHECK_THROWS_AS(each.build(model), InvalidArgument);
    }
    Model model;
    CHECK_THROWS_WITH(
        arc<Spatial>(model, m, s, o, x, x, 1.0, 1.0, 4),
        ContainsSubstring("arc: tangent and normal") && ContainsSubstring("1 0 0 and 1 0 0"));
    CHECK_THROWS_WITH(helix<Spatial>(model, m, s, o, o, y, 1.0, 1.0, 1.0, 4),
                      ContainsSubstring("helix: axis and outward"));
    // a cable has no slopes across: they may differ
    Model cables;
    CHECK_NOTHROW(beam_through<Cable<3>>(cables, m, circle(0.1),
                                         {{o, reference_slopes(x, y)},
                                          {x, reference_slopes(x)},
                                          {2.0 * x, reference_slopes(x, P3(0, 0, 1))}},
                                         {1.0}));
    PlanarModel plane;
    CHECK_THROWS_AS(arc<Planar>(plane, m, s, P2(0, 0), P2(1, 0), 0.0, 1.0, 4), InvalidArgument);
    CHECK_THROWS_AS(arc<Planar>(plane, m, s, P2(0, 0), P2(1, 0), 1.0, 0.0, 4), InvalidArgument);
    CHECK_THROWS_AS(arc<Planar>(plane, m, s, P2(0, 0), P2(0, 0), 1.0, 1.0, 4), InvalidArgument);
}

}  // namespace curve_test
