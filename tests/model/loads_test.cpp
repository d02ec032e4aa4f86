// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/constants.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/loads.hpp>

#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/load_theory.hpp>
#include <support/random_state.hpp>

#include <limits>

namespace loads_test {

using ancf::Field;
using ancf::NodeId;
using Vector3 = ancf::Vector<double, 3>;
using Vector6 = ancf::Vector<double, 6>;

constexpr double tolerance = 1e-13;  // round-off of some tens of operations; measured 4e-16
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Slopes r_x, r_y of a stretched, sheared, rotated node.
Vector6 random_slopes(ancf::test::Random& random) {
    const ancf::Matrix<double, 3> turn = ancf::test::random_rotation<3>(random);
    Vector6 slopes;
    slopes << turn.col(0) + 0.3 * random.vector<3>(), turn.col(1) + 0.3 * random.vector<3>();
    return slopes;
}

template <class Load>
ancf::LoadResult evaluate(const Load& load, const ancf::VectorX& q) {
    ancf::LoadResult out;
    out.force.setZero(q.size());
    out.stiffness.setZero(q.size(), q.size());
    out.damping.setZero(q.size(), q.size());
    load.evaluate({q, ancf::VectorX::Zero(q.size()), 0.0}, out);
    return out;
}

/// Returns a moment on the section of a node that carries all vectors.
ancf::Moment on_section(const Vector3& moment,
                        ancf::Attachment attachment = ancf::Attachment::space) {
    ancf::Moment load(NodeId{0}, moment, attachment);
    load.settle(ancf::Layout(3, {Field::r | Field::r_x | Field::r_y | Field::r_z}));
    return load;
}

/// @param force  of the theory, on any scalar.
template <class Load, class Force, int Size>
void check_load(const Load& load, const Force& force, const ancf::Vector<double, Size>& q) {
    const auto out = evaluate(load, q);
    const auto expected = ancf::test::complex_step_jacobian(force, q);
    REQUIRE(expected.norm() > 0.0);
    CHECK((out.force - force(q)).norm() <= tolerance * out.force.norm());
    CHECK(ancf::test::relative_error(out.stiffness, expected) <= tolerance);
}

TEST_CASE("moments on slopes: force of the theory, stiffness equals its complex-step derivative",
          "[load]") {
    const auto seed = GENERATE(range(0U, 50U));
    INFO("seed " << seed);
    ancf::test::Random random(seed);
    const Vector3 vector = random.vector<3>();
    const Vector6 slopes = random_slopes(random);
    const Vector3 axis = random.direction<3>();

    check_load(
        ancf::SlopeMoment(NodeId{0}, Field::r_y, axis, 2.5),
        [&](const auto& z) { return ancf::test::slope_moment(axis, 2.5, z); },
        Vector3(slopes.tail<3>()));
    check_load(
        ancf::PlanarSlopeMoment(NodeId{0}, Field::r_x, -1.5),
        [](const auto& z) { return ancf::test::planar_slope_moment(-1.5, z); },
        ancf::Vector<double, 2>(slopes.head<2>()));
    check_load(
        ancf::TangentMoment(NodeId{0}, vector),
        [&](const auto& z) { return ancf::test::tangent_moment(vector, z); },
        Vector3(slopes.head<3>()));
    for (const bool in_frame : {false, true}) {
        const auto attachment = in_frame ? ancf::Attachment::frame : ancf::Attachment::space;
        check_load(
            ancf::Moment(NodeId{0}, vector, attachment),
            [&](const auto& z) { return ancf::test::moment_on_tangent(vector, in_frame, z); },
            slopes);
        check_load(
            on_section(vector, attachment),
            [&](const auto& z) { return ancf::test::moment_on_section(vector, in_frame, z); },
            slopes);
    }
}

TEST_CASE("FollowerForce: force of the theory, stiffness equals its complex-step derivative",
          "[load]") {
    const auto seed = GENERATE(range(0U, 50U));
    INFO("seed " << seed);
    ancf::test::Random random(seed);
    const Vector3 force = random.vector<3>();
    const ancf::FollowerForce load(NodeId{0}, force);
    const Vector6 slopes = random_slopes(random);
    ancf::VectorX q(9);
    q << random.vector<3>(), slopes;

    const auto out = evaluate(load, q);
    const auto expected = ancf::test::complex_step_jacobian(
        [&](const auto& z) { return ancf::test::follower_force(force, z); }, slopes);
    CHECK(ancf::test::relative_error(out.stiffness.topRightCorner<3, 6>(), expected) <= tolerance);
    CHECK(out.stiffness.leftCols<3>().norm() == 0.0);
    CHECK(out.stiffness.bottomRows<6>().norm() == 0.0);
    CHECK((out.force.head<3>() - ancf::test::follower_force(force, slopes)).norm() <= tolerance);
}

TEST_CASE("PlanarFollowerForce: it turns with the tangent, and its stiffness is the derivative",
          "[load]") {
    const auto seed = GENERATE(range(0U, 20U));
    INFO("seed " << seed);
    ancf::test::Random random(seed);
    const ancf::Vector<double, 2> given = random.vector<2>();
    const ancf::Vector<double, 4> q = random.vector<4>();
    const auto force = [&](const auto& z) {  // on r alone, along r_x and along r_x turned
        using S = typename std::decay_t<decltype(z)>::Scalar;
        const S length = sqrt(z[2] * z[2] + z[3] * z[3]);
        ancf::Vector<S, 4> out = ancf::Vector<S, 4>::Zero();
        out[0] = (z[2] * given[0] - z[3] * given[1]) / length;
        out[1] = (z[3] * given[0] + z[2] * given[1]) / length;
        return out;
    };
    check_load(ancf::PlanarFollowerForce(NodeId{0}, given), force, q);
}

TEST_CASE("Moment: the generalised force has the moment as its resultant", "[load]") {
    const auto seed = GENERATE(range(0U, 50U));
    INFO("seed " << seed);
    ancf::test::Random random(seed);
    const Vector3 moment = random.vector<3>();
    const Vector6 slopes = random_slopes(random);
    for (const ancf::Moment& load : {ancf::Moment(NodeId{0}, moment), on_section(moment)}) {
        const Vector6 force = evaluate(load, slopes).force;
        const Vector3 sum = ancf::cross(Vector3(slopes.head<3>()), Vector3(force.head<3>())) +
                            ancf::cross(Vector3(slopes.tail<3>()), Vector3(force.tail<3>()));
        CHECK((sum - moment).norm() <= tolerance * moment.norm());
    }
}

TEST_CASE("Moment: on a section it stretches no slope; without shares a torque divides evenly",
          "[load]") {
    const Vector3 y(0.0, 1.1, 0.0), z(0.0, 0.0, 0.9);
    Vector6 slopes;
    slopes << y, z;
    const Vector6 torque = evaluate(on_section({2.0, 0.0, 0.0}), slopes).force;
    CHECK((torque.head<3>() - Vector3(0.0, 0.0, 1.0 / 1.1)).norm() <= tolerance);
    CHECK((torque.tail<3>() - Vector3(0.0, -1.0 / 0.9, 0.0)).norm() <= tolerance);
    const Vector6 bending = evaluate(on_section({0.0, 0.0, 2.0}), slopes).force;
    CHECK((bending.head<3>() - Vector3(-2.0 / 1.1, 0.0, 0.0)).norm() <= tolerance);
    CHECK(bending.tail<3>().norm() <= tolerance);
}

TEST_CASE("SlopeMoment: the work over one turn of a normal slope is 2 pi m", "[load]") {
    const ancf::SlopeMoment load(NodeId{0}, Field::r_y, {0.0, 0.0, 2.0}, 3.0);
    constexpr int parts = 1000;
    double work = 0.0;
    for (int k = 0; k < parts; ++k) {
        const double angle = 2.0 * ancf::pi * k / parts;
        const Vector3 slope(1.2 * std::cos(angle), 1.2 * std::sin(angle), 0.0);
        const Vector3 step = 2.0 * ancf::pi / parts * Vector3(-slope[1], slope[0], 0.0);
        work += evaluate(load, slope).force.dot(step);
    }
    CHECK(work == Approx(6.0 * ancf::pi).epsilon(1e-12));
}

TEST_CASE("moments on one slope: the force is the derivative of the potential", "[load]") {
    const auto seed = GENERATE(range(0U, 50U));
    INFO("seed " << seed);
    ancf::test::Random random(seed);
    // central differences: h^2 and eps/h, 3e-10 measured
    constexpr double h = 1e-5, close = 1e-8;
    const auto check = [&](const auto& load, const auto& slope, double moment) {
        const auto here = evaluate(load, slope);
        CHECK(here.period == Approx(2.0 * ancf::pi * moment).epsilon(1e-15));
        for (int k = 0; k < slope.size(); ++k) {
            auto less = slope, more = slope;
            less[k] -= h;
            more[k] += h;
            // where the step passes the end of the angle, the period tells
            const double fall = std::remainder(
                evaluate(load, less).potential - evaluate(load, more).potential, here.period);
            CHECK(fall / (2.0 * h) == Approx(here.force[k]).margin(close));
        }
    };
    const Vector6 slopes = random_slopes(random);
    check(ancf::SlopeMoment(NodeId{0}, Field::r_y, random.direction<3>(), -2.5),
          Vector3(slopes.tail<3>()), 2.5);
    check(ancf::PlanarSlopeMoment(NodeId{0}, Field::r_x, 1.5),
          ancf::Vector<double, 2>(slopes.head<2>()), 1.5);
}

TEST_CASE("Force: its potential falls by the work it does", "[load]") {
    const ancf::Force load(NodeId{0}, {1.0, -2.0, 3.0});
    const auto at_origin = evaluate(load, Vector3::Zero());
    const auto moved = evaluate(load, Vector3(0.5, 0.25, -1.0));
    CHECK(moved.potential - at_origin.potential == Approx(-(0.5 - 0.5 - 3.0)));
    CHECK(moved.force == at_origin.force);
}

TEST_CASE("loads: values that cannot be meant are refused", "[load][bad-input]") {
    const NodeId node{0};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(ancf::Force(node, {nan, 0.0, 0.0}), ancf::InvalidArgument);
    CHECK_THROWS_AS(ancf::Moment(node, {0.0, infinity, 0.0}), ancf::InvalidArgument);
    CHECK_THROWS_AS(ancf::FollowerForce(node, {0.0, 0.0, nan}), ancf::InvalidArgument);
    CHECK_THROWS_AS(ancf::TangentMoment(node, {nan, 0.0, 0.0}), ancf::InvalidArgument);
    CHECK_THROWS_AS(ancf::SlopeMoment(node, Field::r, {0.0, 0.0, 1.0}, 1.0), ancf::InvalidArgument);
    CHECK_THROWS_AS(ancf::SlopeMoment(node, Field::r_y, {0.0, 0.0, 0.0}, 1.0),
                    ancf::InvalidArgument);
    CHECK_THROWS_AS(ancf::SlopeMoment(node, Field::r_y, {0.0, 0.0, 1.0}, nan),
                    ancf::InvalidArgument);
    CHECK_THROWS_AS(ancf::PlanarSlopeMoment(node, Field::r, 1.0), ancf::InvalidArgument);
    CHECK_THROWS_AS(ancf::PlanarSlopeMoment(node, Field::r_x, infinity), ancf::InvalidArgument);
}

}  // namespace loads_test
