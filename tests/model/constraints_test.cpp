// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/model/constraints.hpp>
#include <ancf/model/constraints/slider.hpp>
#include <ancf/model/model.hpp>

#include <support/carrier.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/dense.hpp>
#include <support/random_state.hpp>

#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>

namespace constraints_test {

using ancf::Field;
using ancf::MatrixX;
using ancf::NodeId;
using ancf::VectorX;
using ancf::test::Random;
using Complex = std::complex<double>;
using ComplexX = ancf::DynamicVector<Complex>;
using Vector2 = ancf::Vector<double, 2>;
using Vector3 = ancf::Vector<double, 3>;

constexpr double tolerance = 1e-12;  // some hundred operations; measured 2e-15
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A scalar motion with distinct derivatives.
ancf::Motion wave(double amplitude) {
    return {[=](double t) { return amplitude * std::sin(1.3 * t); },
            [=](double t) { return 1.3 * amplitude * std::cos(1.3 * t); },
            [=](double t) { return -1.69 * amplitude * std::sin(1.3 * t); }};
}

ancf::Motion grown(double start, double amplitude) {
    const ancf::Motion motion = wave(amplitude);
    return {[=](double t) { return start + motion.value(t); }, motion.rate, motion.acceleration};
}

template <int Dimension>
ancf::PointMotion<Dimension> path(const ancf::Vector<double, Dimension>& direction) {
    using Point = ancf::Vector<double, Dimension>;
    return {[=](double t) -> Point { return direction * std::sin(0.9 * t); },
            [=](double t) -> Point { return 0.9 * direction * std::cos(0.9 * t); },
            [=](double t) -> Point { return -0.81 * direction * std::sin(0.9 * t); }};
}

/// Two nodes with beam vectors or a cable's, in random frames that are stretched and sheared.
template <class... Carriers>
auto random_scene(Random& random) {
    constexpr int dimension = (Carriers::dimension, ...);
    ancf::BasicModel<dimension> model;
    for (int k = 0; k < 2; ++k) {
        ancf::Matrix<double, dimension> slopes = ancf::test::random_rotation<dimension>(random);
        for (int i = 0; i < dimension; ++i) slopes.col(i) += 0.3 * random.vector<dimension>();
        model.add_node(random.vector<dimension>(), slopes);
    }
    (model.template connect<Carriers>(model.add_prototype(Carriers{}), NodeId{0}, NodeId{1}), ...);
    return model;
}

VectorX local_values(const ancf::Scene& model, const ancf::Coupling& coupling) {
    const int dimension = model.dimension();
    VectorX q(dimension * static_cast<int>(coupling.size()));
    int at = 0;
    for (const auto& [node, field] : coupling) {
        q.segment(at, dimension) =
            model.state().q.segment(model.coordinate(node, field), dimension);
        at += dimension;
    }
    return q;
}

VectorX random_vector(Random& random, Eigen::Index size, double scale) {
    VectorX x(size);
    for (Eigen::Index k = 0; k < size; ++k) x[k] = random.uniform(-scale, scale);
    return x;
}

ancf::ConstraintResult sized(int equations, Eigen::Index size) {
    ancf::ConstraintResult out;
    out.reset(equations, size, size);
    return out;
}

/// Returns g, G and g_t at any scalar.
template <class Constraint, class Scalar>
auto terms(const Constraint& constraint, const ancf::DynamicVector<Scalar>& q, const Scalar& time) {
    ancf::ConstraintTerms<Scalar> out;
    out.reset(constraint.equations(), q.size());
    constraint.terms(q, time, out);
    return out;
}

/// |value - expected| against the larger of the two and 1: derivatives may be zero.
template <class A, class B>
double gap(const A& value, const B& expected) {
    return (value - expected).norm() / std::max(1.0, expected.norm());
}

/// Checks G, (G^T lambda)_q, g_t and c by complex steps at a displaced state.
template <class Constraint>
void check_derivatives(const ancf::Scene& model, const Constraint& constraint, Random& random) {
    INFO(constraint.name());
    const double h = ancf::test::complex_step;
    const VectorX q0 = local_values(model, constraint.coupling());
    const Eigen::Index size = q0.size();
    const int equations = constraint.equations();
    const VectorX q = q0 + random_vector(random, size, 0.2);
    const VectorX v = random_vector(random, size, 1.0);
    const VectorX lambda = random_vector(random, equations, 1.0);
    const double time = random.uniform(0.1, 2.0);

    auto out = sized(equations, size);
    constraint.evaluate({q, v, lambda, time}, out);
    REQUIRE(out.violation.size() == equations);
    CHECK(gap(out.violation, terms(constraint, q, time).violation) == 0.0);

    const Complex at(time, 0.0);
    MatrixX jacobian(equations, size), stiffness(size, size);
    ComplexX z = q.cast<Complex>();
    for (Eigen::Index j = 0; j < size; ++j) {
        z[j] = {q[j], h};
        const auto here = terms(constraint, z, at);
        jacobian.col(j) = here.violation.imag() / h;
        const ComplexX force = here.jacobian.transpose() * lambda.cast<Complex>();
        stiffness.col(j) = force.imag() / h;
        z[j] = q[j];
    }
    REQUIRE(jacobian.norm() > 0.0);
    CHECK(gap(out.jacobian, jacobian) <= tolerance);
    MatrixX given = out.stiffness;  // in all coordinates
    if (!out.active.empty()) {
        given.setZero(size, size);
        for (std::size_t i = 0; i < out.active.size(); ++i)
            for (std::size_t j = 0; j < out.active.size(); ++j)
                given(out.active[i], out.active[j]) = out.stiffness(i, j);
    }
    CHECK(gap(given, stiffness) <= tolerance);
    CHECK(gap(given, given.transpose()) <= tolerance);

    const Complex later(time, h);
    const VectorX rate = terms(constraint, z, later).violation.imag() / h;
    CHECK(gap(out.rate, rate) <= tolerance);

    // d/ds of dg/dt = G v + g_t along q + s v, t + s
    const ComplexX moved = z + Complex(0.0, h) * v.cast<Complex>();
    const auto there = terms(constraint, moved, later);
    const ComplexX speed = there.jacobian * v.cast<Complex>() + there.rate;
    CHECK(gap(out.convection, VectorX(speed.imag() / h)) <= tolerance);
}

/// Checks that G has full rank where the joint was made, and that it holds there.
template <class Constraint>
void check_regular(const ancf::Scene& model, const Constraint& constraint, bool positions_apart) {
    INFO(constraint.name());
    const VectorX q = local_values(model, constraint.coupling());
    auto out = sized(constraint.equations(), q.size());
    constraint.evaluate({q, VectorX::Zero(q.size()), VectorX::Zero(constraint.equations()), 0.0},
                        out);
    const int skipped = positions_apart ? model.dimension() : 0;
    const int angles = constraint.equations() - skipped;
    CHECK(out.violation.tail(angles).norm() <= 1e-14);
    // slopes are stretched by less than 1.6: no equation is weaker than a third
    CHECK(ancf::test::singular_values(out.jacobian).minCoeff() > 0.1);
}

TEST_CASE("constraints on points: derivatives equal complex steps", "[constraint]") {
    const auto seed = GENERATE(range(0U, 30U));
    INFO("seed " << seed);
    Random random(seed);
    const auto model = random_scene<ancf::test::BeamCarrier>(random);
    const NodeId a{0}, b{1};
    const Vector3 place = random.vector<3>();
    const auto inner =
        ancf::point_along<ancf::test::BeamCarrier>(model, 0, random.uniform(0.0, 1.0));
    const auto outer =
        ancf::point_along<ancf::test::BeamCarrier>(model, 0, random.uniform(0.0, 1.0));

    check_derivatives(model, ancf::FixedCoordinate<3>(a, Field::r_y, 2, 0.3), random);
    check_derivatives(model, ancf::FixedCoordinate<3>(a, Field::r, 1, wave(0.2)), random);
    check_derivatives(model, ancf::Pin(a, place), random);
    check_derivatives(model, ancf::Pin<3>(a, b), random);
    check_derivatives(model, ancf::Pin<3>(inner, b), random);
    check_derivatives(model, ancf::Pin(a, path<3>(place)), random);
    check_derivatives(model, ancf::PointOnLine(inner, place, random.vector<3>()), random);
    check_derivatives(model, ancf::Distance(a, place, 0.7), random);
    check_derivatives(model, ancf::Distance<3>(a, b, 0.7), random);
    check_derivatives(model, ancf::Distance<3>(inner, outer, 0.7), random);
    check_derivatives(model, ancf::Distance(a, path<3>(place), 0.7), random);
    check_derivatives(model, ancf::Distance<3>(a, b, grown(1.0, 0.3)), random);
    check_derivatives(model, ancf::Distance<3>(a, place, grown(1.0, 0.3)), random);
    check_derivatives(model, ancf::Driven(ancf::Pin<3>(a, b), {{1, wave(0.4)}}), random);
    check_derivatives(model, ancf::Driven(ancf::Distance<3>(a, b, 1.0), {{0, wave(0.4)}}), random);
}

TEST_CASE("joints of frames: derivatives equal complex steps", "[constraint]") {
    const auto seed = GENERATE(range(0U, 30U));
    INFO("seed " << seed);
    Random random(seed);
    const auto model = random_scene<ancf::test::BeamCarrier>(random);
    const NodeId a{0}, b{1};
    const ancf::FrameAt tangent{a, Field::r_x, Field::r_y}, across{b, Field::r_z, Field::r_y};
    const Vector3 axis = random.direction<3>(), other = ancf::cross(axis, random.direction<3>());

    check_derivatives(model, ancf::Revolute(model, a, b, axis), random);
    check_derivatives(model, ancf::Revolute(model, a, across, axis), random);
    check_derivatives(model, ancf::Revolute(model, tangent, across, axis), random);
    check_derivatives(model, ancf::Revolute(model, a, axis), random);
    check_derivatives(model, ancf::Weld(model, a, b), random);
    check_derivatives(model, ancf::Weld(model, tangent, b), random);
    check_derivatives(model, ancf::Weld(model, b), random);
    check_derivatives(model, ancf::Weld(model, across), random);
    check_derivatives(model, ancf::FixedOrientation(model, a, across), random);
    check_derivatives(model, ancf::DrivenRevolute(model, a, b, axis, wave(1.5)), random);
    check_derivatives(model, ancf::DrivenRevolute(model, a, axis, wave(1.5)), random);
    check_derivatives(model, ancf::DrivenRevolute(model, tangent, axis, wave(1.5)), random);
    check_derivatives(model, ancf::Universal(model, a, b, axis, other), random);
    check_derivatives(model, ancf::Universal(model, a, axis, other), random);
    check_derivatives(
        model, ancf::Driven(ancf::Universal(model, a, b, axis, other), {{3, wave(0.4)}}), random);
    check_derivatives(model, ancf::AlignedTangent(model, a, b), random);
    check_derivatives(model, ancf::AlignedTangent(model, b), random);
    check_derivatives(model, ancf::RigidSection(b), random);
    check_derivatives(model, ancf::RigidNode<3>(b), random);
}

TEST_CASE("planar constraints: derivatives equal complex steps", "[constraint]") {
    const auto seed = GENERATE(range(0U, 30U));
    INFO("seed " << seed);
    Random random(seed);
    const auto model = random_scene<ancf::test::PlanarCarrier>(random);
    const NodeId a{0}, b{1};
    const Vector2 place = random.vector<2>();

    check_derivatives(model, ancf::Pin(a, place), random);
    check_derivatives(model, ancf::Distance<2>(a, b, 0.7), random);
    check_derivatives(model, ancf::PlanarWeld(model, a, b), random);
    check_derivatives(model, ancf::PlanarWeld(model, a, b, Field::r_x), random);
    check_derivatives(model, ancf::PlanarWeld(model, a), random);
    check_derivatives(model, ancf::PlanarWeld(model, a, b, wave(2.0)), random);
    check_derivatives(model, ancf::PlanarWeld(model, a, wave(2.0)), random);
    check_derivatives(model, ancf::RigidNode<2>(b), random);
}

/// Checks sliders near each of the places of a random chain: inside elements and beyond the ends.
template <class Carrier>
void check_sliders(unsigned seed) {
    constexpr int dimension = Carrier::dimension;
    using Point = ancf::Vector<double, dimension>;
    INFO("seed " << seed);
    Random random(seed);
    ancf::BasicModel<dimension> model;
    const int prototype = model.add_prototype(Carrier{});
    for (int k = 0; k < 3; ++k) {
        ancf::Matrix<double, dimension> slopes = ancf::Matrix<double, dimension>::Identity();
        for (int i = 0; i < dimension; ++i) slopes.col(i) += 0.2 * random.vector<dimension>();
        const Point place = Point::Unit(0) * k + 0.1 * random.vector<dimension>();
        model.add_node(place, slopes);
        if (k > 0) model.template connect<Carrier>(prototype, NodeId{k - 1}, NodeId{k});
    }
    const NodeId body =
        model.add_node(random.vector<dimension>(), ancf::test::random_rotation<dimension>(random));
    model.template connect<Carrier>(prototype, body, NodeId{2});  // it carries all slopes
    for (const double station : {-0.3, 0.4, 1.7, 2.3}) {
        const NodeId point = model.add_node(Point::Unit(0) * station);
        model.add_mass(point, 1.0);
        const Point across = Point::Unit(1) + 0.2 * random.vector<dimension>();
        ancf::Beam<Carrier> beam;
        beam.elements = {0, 1};
        const ancf::Slider<dimension> along(point, ancf::guide_along(model, beam, across));
        CHECK(along.station(model, model.state().q) == Approx(station).margin(0.4));
        check_derivatives(model, along, random);
        const Point direction = random.direction<dimension>();
        const ancf::Slider<dimension> straight(
            point, ancf::straight_guide<dimension>(model, body, direction));
        check_derivatives(model, straight, random);
    }
}

TEST_CASE("sliders: derivatives equal complex steps", "[constraint]") {
    const auto seed = GENERATE(range(0U, 30U));
    check_sliders<ancf::test::BeamCarrier>(seed);
    check_sliders<ancf::test::PlanarCarrier>(seed);
}

TEST_CASE("joints hold where they are made and no equation repeats another", "[constraint]") {
    const auto seed = GENERATE(range(0U, 30U));
    INFO("seed " << seed);
    Random random(seed);
    const auto model = random_scene<ancf::test::BeamCarrier>(random);
    const NodeId a{0}, b{1};
    const Vector3 axis = random.direction<3>();
    const Vector3 other = ancf::cross(axis, random.direction<3>());

    check_regular(model, ancf::Revolute(model, a, b, axis), true);
    check_regular(model, ancf::Revolute(model, a, axis), true);
    check_regular(model, ancf::Weld(model, a, b), true);
    check_regular(model, ancf::Weld(model, a), true);
    check_regular(model, ancf::FixedOrientation(model, a, b), false);
    check_regular(model, ancf::DrivenRevolute(model, a, b, axis, wave(1.0)), true);
    check_regular(model, ancf::Universal(model, a, b, axis, other), true);
    check_regular(model, ancf::AlignedTangent(model, a, b), false);
    check_regular(model, ancf::AlignedTangent(model, b), false);
}

TEST_CASE("joints see directions only: stretching the slopes changes no angle", "[constraint]") {
    Random random(7);
    auto model = random_scene<ancf::test::BeamCarrier>(random);
    const NodeId a{0}, b{1};
    const ancf::Weld weld(model, a, b);
    const ancf::Revolute hinge(model, a, b, random.direction<3>());
    for (const NodeId node : {a, b})
        for (const Field slope : {Field::r_x, Field::r_y, Field::r_z})
            model.set_value(node, slope, 1.7 * model.value(node, slope));
    const VectorX q = local_values(model, weld.coupling());
    CHECK(terms(weld, q, 0.0).violation.tail<3>().norm() <= 1e-14);
    CHECK(terms(hinge, q, 0.0).violation.tail<2>().norm() <= 1e-14);
}

TEST_CASE("frame_axes, section_angle: they turn with the node", "[constraint]") {
    Random random(11);
    ancf::Model model;
    const auto turn = ancf::test::rotation(Vector3(0.3, -1.1, 0.7));
    const NodeId node = model.add_node({0, 0, 0}, ancf::Matrix<double, 3>::Identity());
    model.connect<ancf::test::BeamCarrier>(model.add_prototype(ancf::test::BeamCarrier{}), node,
                                           model.add_node({1, 0, 0}));
    const ancf::FrameAt tangent(node, Field::r_x, Field::r_y);
    for (const ancf::FrameAt& frame : {ancf::FrameAt(node), tangent}) {
        const ancf::Matrix<double, 3> start = ancf::frame_axes(model, frame, model.state().q);
        CHECK((start - ancf::Matrix<double, 3>::Identity()).norm() < 1e-15);
        VectorX q = model.state().q;
        for (int k = 0; k < 3; ++k) {
            const Field slope = k == 0 ? Field::r_x : k == 1 ? Field::r_y : Field::r_z;
            q.segment<3>(model.coordinate(node, slope)) = turn.col(k);
        }
        CHECK((ancf::frame_axes(model, frame, q) - turn).norm() < 1e-14);
    }
    for (const double angle : {0.0, 1.0, 3.0, -2.0}) {
        ancf::PlanarModel plane;
        const Vector2 along(std::cos(angle), std::sin(angle));
        ancf::Matrix<double, 2> slopes;
        slopes << along[0], -along[1], along[1], along[0];
        const NodeId at = plane.add_node({0, 0}, slopes), other = plane.add_node({1, 0}, slopes);
        plane.connect<ancf::test::PlanarCarrier>(plane.add_prototype(ancf::test::PlanarCarrier{}),
                                                 at, other);
        CHECK(ancf::section_angle(plane, at, plane.state().q) == Approx(angle));
    }
}

/// Returns the scene with node 1 turned.
template <int Dimension>
ancf::BasicModel<Dimension> turned(ancf::BasicModel<Dimension> model,
                                   const ancf::Matrix<double, Dimension>& turn) {
    for (const Field slope : {Field::r_x, Field::r_y, Field::r_z})
        if (model.layout().index({NodeId{1}, slope}) >= 0)
            model.set_value(NodeId{1}, slope, turn * model.value(NodeId{1}, slope));
    return model;
}

TEST_CASE("joints far off: derivatives equal complex steps and g has no second root",
          "[constraint]") {
    const auto seed = GENERATE(range(0U, 30U));
    INFO("seed " << seed);
    Random random(seed);
    const auto model = random_scene<ancf::test::BeamCarrier>(random);
    const auto plane = random_scene<ancf::test::PlanarCarrier>(random);
    const NodeId a{0}, b{1};
    const Vector3 axis = random.direction<3>(), across = ancf::cross(axis, random.direction<3>());
    const ancf::Weld weld(model, a, b);
    const ancf::DrivenRevolute motor(model, a, b, axis, wave(0.3));
    const ancf::Revolute hinge(model, a, b, axis);
    const ancf::AlignedTangent aligned(model, a, b);
    const ancf::PlanarWeld flat(plane, a, b, wave(0.3));
    double before = 0.0;
    for (const double angle : {0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.14}) {
        CAPTURE(angle);
        const auto off = turned(model, ancf::test::rotation(Vector3(angle * axis)));
        const auto leaning =
            turned(model, ancf::test::rotation(Vector3(angle / across.norm() * across)));
        const Vector2 x(std::cos(angle), -std::sin(angle)), y(std::sin(angle), std::cos(angle));
        ancf::Matrix<double, 2> turn;
        turn << x.transpose(), y.transpose();
        const auto spun = turned(plane, turn);
        // beyond pi/3 the equations grow up to the angle
        const double g =
            terms(weld, local_values(off, weld.coupling()), 0.0).violation.tail<3>().norm();
        const double h =
            terms(hinge, local_values(leaning, hinge.coupling()), 0.0).violation.tail<2>().norm();
        const double p =
            std::abs(terms(flat, local_values(spun, flat.coupling()), 0.0).violation[2]);
        CHECK(g > before);
        CHECK(h == Approx(g).epsilon(1e-9));
        CHECK(p == Approx(g).epsilon(1e-9));
        before = g;
        if (angle > 2.6) continue;  // the round-off of the axis grows with 1/sin(angle)^3
        check_derivatives(off, weld, random);
        check_derivatives(off, motor, random);
        check_derivatives(leaning, hinge, random);
        check_derivatives(off, aligned, random);
        check_derivatives(spun, flat, random);
    }
    CHECK(before == Approx(3.14).epsilon(1e-4));
}

TEST_CASE("a weld measures the sine of the relative turn about its axis", "[constraint]") {
    Random random(3);
    auto model = random_scene<ancf::test::BeamCarrier>(random);
    const NodeId a{0}, b{1};
    const ancf::Weld weld(model, a, b);
    const Vector3 axis = random.direction<3>();
    const double angle = 0.4;
    const ancf::Matrix<double, 3> turn = ancf::test::rotation(Vector3(angle * axis));
    for (const Field slope : {Field::r_x, Field::r_y, Field::r_z})
        model.set_value(b, slope, turn * model.value(b, slope));
    const VectorX g = terms(weld, local_values(model, weld.coupling()), 0.0).violation.tail<3>();
    CHECK(g.norm() == Approx(std::sin(angle)).epsilon(1e-13));

    // turning it back by a driven hinge about the same axis finds the joint closed
    const ancf::DrivenRevolute motor(model, a, b, axis,
                                     {[=](double t) { return angle * t; },
                                      [=](double) { return angle; }, [](double) { return 0.0; }});
    for (const Field slope : {Field::r_x, Field::r_y, Field::r_z})
        model.set_value(b, slope, turn * model.value(b, slope));
    const VectorX closed =
        terms(motor, local_values(model, motor.coupling()), 1.0).violation.tail<3>();
    CHECK(closed.norm() <= 1e-14);
}

TEST_CASE("a cable's tangent can be aligned with a beam's frame", "[constraint]") {
    Random random(5);
    ancf::Model model;
    const auto beam = model.add_prototype(ancf::test::BeamCarrier{});
    const auto cable = model.add_prototype(ancf::test::CableCarrier{});
    for (int k = 0; k < 4; ++k)
        model.add_node(random.vector<3>(), ancf::test::random_rotation<3>(random));
    model.connect<ancf::test::BeamCarrier>(beam, NodeId{0}, NodeId{1});
    model.connect<ancf::test::CableCarrier>(cable, NodeId{2}, NodeId{3});
    const ancf::AlignedTangent joint(model, NodeId{1}, NodeId{2});
    CHECK(joint.equations() == 2);
    CHECK(joint.coupling().size() == 3);
    check_derivatives(model, joint, random);
    check_regular(model, joint, false);
    CHECK_THROWS_AS(ancf::Weld(model, NodeId{1}, NodeId{2}), ancf::InvalidArgument);
}

TEST_CASE("constraints name what they join", "[constraint]") {
    const NodeId a{3}, b{5};
    CHECK(ancf::Pin<3>(a, b).name() == "pin of node 3 and node 5");
    CHECK(ancf::Distance(a, Vector3(0.0, 1.0, 0.0), 1.0).name() ==
          "distance between node 3 and a point of space");
    CHECK(ancf::PointOnLine<2>(a, {0, 0}, {1, 0}).name() == "line of node 3 and a point of space");
    CHECK(ancf::FixedCoordinate<3>(a, Field::r_x, 1, 0.0).name() ==
          "fixed r_x, component 1, of node 3");
    CHECK(ancf::Driven(ancf::Pin<3>(a, b), {}).name() == "driven pin of node 3 and node 5");
}

TEST_CASE("constraints refuse what cannot be meant", "[constraint]") {
    Random random(1);
    const auto model = random_scene<ancf::test::BeamCarrier>(random);
    const auto plane = random_scene<ancf::test::PlanarCarrier>(random);
    const NodeId a{0}, b{1};
    const Vector3 place(0.0, 0.0, 0.0), axis(0.0, 0.0, 1.0), nowhere(0.0, 0.0, 0.0);
    using ancf::InvalidArgument;

    CHECK_THROWS_WITH(ancf::Distance(a, place, 0.0), ContainsSubstring("length must be positive"));
    CHECK_THROWS_AS(ancf::Distance(a, place, -1.0), InvalidArgument);
    CHECK_THROWS_AS(ancf::Distance(a, place, infinity), InvalidArgument);
    CHECK_THROWS_AS(ancf::Distance(a, Vector3(infinity, 0.0, 0.0), 1.0), InvalidArgument);
    CHECK_THROWS_WITH(ancf::Distance<3>(a, a, 1.0), ContainsSubstring("node 0 twice"));
    CHECK_THROWS_AS(ancf::Distance<3>(a, b, ancf::Motion{}), InvalidArgument);
    CHECK_THROWS_AS(ancf::Pin<3>(a, a), InvalidArgument);
    CHECK_THROWS_AS(ancf::Pin(a, Vector3(0.0, infinity, 0.0)), InvalidArgument);
    CHECK_THROWS_WITH(ancf::PointOnLine(a, place, nowhere),
                      ContainsSubstring("direction must have a length"));
    CHECK_THROWS_AS(ancf::PointOnLine<2>(a, {0.0, infinity}, {1.0, 0.0}), InvalidArgument);
    CHECK_THROWS_AS(ancf::FixedCoordinate<3>(a, Field::r, 3, 0.0), InvalidArgument);
    CHECK_THROWS_AS(ancf::FixedCoordinate<3>(a, Field::r, 0, infinity), InvalidArgument);
    CHECK_THROWS_AS(ancf::FixedCoordinate<3>(a, Field::r, 0, ancf::Motion{}), InvalidArgument);
    CHECK_THROWS_AS(ancf::Driven(ancf::Pin<3>(a, b), {{3, wave(1.0)}}), InvalidArgument);
    CHECK_THROWS_WITH(ancf::Revolute(model, a, b, nowhere),
                      ContainsSubstring("axis must have a length"));
    CHECK_THROWS_AS(ancf::Revolute(model, a, a, axis), InvalidArgument);
    CHECK_THROWS_AS(ancf::Weld(model, b, b), InvalidArgument);
    CHECK_THROWS_AS(ancf::DrivenRevolute(model, a, b, axis, ancf::Motion{}), InvalidArgument);
    CHECK_THROWS_WITH(ancf::Universal(model, a, b, axis, Vector3(-2.0 * axis)),
                      ContainsSubstring("parallel"));
    CHECK_THROWS_AS(ancf::FrameAt(a, Field::r, Field::r_y), InvalidArgument);
    CHECK_THROWS_AS(ancf::FrameAt(a, Field::r_y, Field::r_y), InvalidArgument);
    CHECK_THROWS_AS(ancf::point_along<ancf::test::BeamCarrier>(model, 1, 0.5), InvalidArgument);
    CHECK_THROWS_AS(ancf::point_along<ancf::test::BeamCarrier>(model, 0, 1.5), InvalidArgument);
    CHECK_THROWS_AS(ancf::PlanarWeld(plane, a, a), InvalidArgument);
    CHECK_THROWS_AS(ancf::PlanarWeld(plane, a, b, Field::r), InvalidArgument);
    CHECK_THROWS_WITH(ancf::PlanarWeld(plane, a, b, ancf::Motion{}),
                      ContainsSubstring("value, rate and acceleration, in statics too"));
}

}  // namespace constraints_test
