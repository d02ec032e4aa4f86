// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/path.hpp>

#include <ancf/model/loads.hpp>
#include <ancf/solver/eigen_solver.hpp>

#include <support/bar.hpp>
#include <support/catch.hpp>
#include <support/instances/solvers.hpp>

#include <cmath>
#include <limits>

namespace path_test {

using ancf::CriticalKind;
using ancf::Field;
using ancf::Status;
using Bar = ancf::test::Bar<3>;
using Truss = ancf::Model<Bar>;

constexpr double axial_stiffness = 100.0;
constexpr ancf::NodeId apex{2};

/// Two bars from (-1, 0) and (1, 0) to an apex at the given height, pushed down by a unit force.
Truss make_truss(double height) {
    Truss truss;
    const auto left = truss.add_node({-1, 0, 0});
    const auto right = truss.add_node({1, 0, 0});
    const auto top = truss.add_node({0, height, 0});
    const int bar =
        truss.add_prototype(Bar(axial_stiffness, 1.0, std::sqrt(1.0 + height * height)));
    truss.connect(bar, left, top);
    truss.connect(bar, right, top);
    truss.pin(left);
    truss.pin(right);
    truss.fix(top, Field::r, 2);
    truss.add(ancf::Force(top, {0, -1, 0}));
    return truss;
}

/// Load on the symmetric path with the apex at height y: EA (h^2 y - y^3)/l^3.
double load_at(double height, double y) {
    const double length = std::sqrt(1.0 + height * height);
    return axial_stiffness * (height * height * y - y * y * y) / (length * length * length);
}

double limit_load(double height) { return load_at(height, height / std::sqrt(3.0)); }

/// Load at which the steep truss gives way sideways: the tangent's sideways entry vanishes,
/// 1 + eps l^2 = 0 with 2 eps l^2 = y^2 - h^2.
double sideways_load(double height) { return load_at(height, std::sqrt(height * height - 2.0)); }

TEST_CASE("path: a shallow truss snaps through at its two limit loads", "[path]") {
    const auto control = GENERATE(ancf::PathControl::cylindrical, ancf::PathControl::spherical);
    Truss truss = make_truss(0.5);
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.control = control;
    options.first_step = 0.5;
    options.last_factor = 10.0;
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.status == Status::converged);
    REQUIRE(report.critical.size() == 2);
    for (const auto& critical : report.critical) CHECK(critical.kind == CriticalKind::limit);
    CHECK(report.critical[0].factor == Approx(limit_load(0.5)).epsilon(1e-9));
    CHECK(report.critical[1].factor == Approx(-limit_load(0.5)).epsilon(1e-9));
    CHECK(report.points.back().factor == 10.0);
    CHECK(-load_at(0.5, -truss.position(apex)[1]) == Approx(10.0).epsilon(1e-9));
    CHECK(report.points.front().negative_pivots == 0);
}

TEST_CASE("path: every point lies on the closed path", "[path]") {
    Truss truss = make_truss(0.5);
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.first_step = 0.5;
    options.max_points = 40;
    int seen = 0;
    options.progress = [&](const ancf::PathPoint& point, const ancf::State& state) {
        const double y = state.q[truss.coordinate(apex, Field::r) + 1];
        CHECK(std::abs(load_at(0.5, y) - point.factor) <=
              1e-7 * std::max(1.0, std::abs(point.factor)));
        ++seen;
        return y > -1.0;
    };
    const auto report = ancf::follow_path(truss, solver, options);
    CHECK(seen == static_cast<int>(report.points.size()));
    CHECK(seen >= 5);
}

TEST_CASE("path: a steep truss bifurcates sideways before its limit load", "[path]") {
    Truss truss = make_truss(2.0);
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.first_step = 0.5;
    options.last_factor = -1.0;
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.critical.size() >= 2);
    CHECK(report.critical[0].kind == CriticalKind::bifurcation);
    CHECK(report.critical[0].factor == Approx(sideways_load(2.0)).epsilon(1e-7));
    CHECK(report.critical[1].kind == CriticalKind::limit);
    CHECK(report.critical[1].factor == Approx(limit_load(2.0)).epsilon(1e-9));

    SECTION("its mode leads to the branch, where the load falls") {
        const double side = GENERATE(-1.0, 1.0);
        truss.state() = report.critical[0].state;
        ancf::PathOptions branch;
        branch.first_factor = report.critical[0].factor;
        branch.direction = report.critical[0].mode;
        branch.branch_step = side * 0.05;
        branch.max_points = 8;
        const auto along = ancf::follow_path(truss, solver, branch);
        REQUIRE(along.points.size() == 8);
        CHECK(along.points.back().factor < 0.999 * branch.first_factor);
        const double sideways = truss.position(apex)[0];
        CHECK(std::abs(sideways) > 0.1);
        const int coordinate = truss.coordinate(apex, Field::r);
        CHECK(sideways * side * branch.direction[coordinate] > 0.0);
    }
}

TEST_CASE("path: displacement control passes the limit point of the load", "[path]") {
    Truss truss = make_truss(0.5);
    ancf::EigenLdlt solver;
    ancf::PathOptions options;
    options.control = ancf::PathControl::displacement;
    options.at = {apex, Field::r};
    options.component = 1;
    options.first_step = 1.0;
    options.progress = [](const ancf::PathPoint&, const ancf::State& state) {
        return state.q[7] > -0.45;
    };
    const auto report = ancf::follow_path(truss, solver, options);
    CHECK(report.status == Status::converged);
    CHECK(truss.position(apex)[1] <= -0.45);
    REQUIRE(report.critical.size() == 2);
    CHECK(report.critical[0].factor == Approx(limit_load(0.5)).epsilon(1e-9));
}

TEST_CASE("path: without a count of pivots limit points are still found", "[path]") {
    Truss truss = make_truss(0.5);
    ancf::EigenLu solver;
    ancf::PathOptions options;
    options.first_step = 0.5;
    options.last_factor = 10.0;
    const auto report = ancf::follow_path(truss, solver, options);
    REQUIRE(report.critical.size() == 2);
    CHECK(report.critical[0].factor == Approx(limit_load(0.5)).epsilon(1e-9));
}

TEST_CASE("path: calls that cannot be meant are refused", "[path][bad-input]") {
    Truss truss = make_truss(0.5);
    ancf::EigenLdlt solver;
    const auto refused = [&](auto change) {
        ancf::PathOptions options;
        change(options);
        CHECK_THROWS_AS(ancf::follow_path(truss, solver, options), ancf::InvalidArgument);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    refused([&](auto& o) { o.first_factor = nan; });
    refused([](auto& o) { o.first_step = 0.0; });
    refused([](auto& o) { o.largest_step = -1.0; });
    refused([](auto& o) { o.smallest_step = 0.0; });
    refused([](auto& o) { o.max_iterations = 2; });
    refused([](auto& o) { o.wanted_iterations = 0; });
    refused([](auto& o) { o.max_points = 0; });
    refused([](auto& o) { o.residual_tolerance = -1.0; });
    refused([&](auto& o) { o.correction_tolerance = nan; });
    refused([](auto& o) { o.branch_step = 0.0; });
    refused([&](auto& o) { o.last_factor = nan; });
    refused([](auto& o) { o.direction = ancf::VectorX::Ones(2); });
    refused([](auto& o) {
        o.control = ancf::PathControl::displacement;
        o.at = {{0}, Field::r};  // held
    });
    refused([](auto& o) {
        o.control = ancf::PathControl::displacement;
        o.at = {apex, Field::r};
        o.component = 3;
    });
    truss.prescribe(apex, Field::r, 0, [](double factor) { return factor; });
    refused([](auto&) {});
}

}  // namespace path_test
