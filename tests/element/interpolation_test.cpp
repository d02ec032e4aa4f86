// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Interpolation, quadrature rules and mass weights.

#include <ancf/element/hermite.hpp>
#include <ancf/element/mass.hpp>
#include <ancf/element/quadrature.hpp>

#include <support/catch.hpp>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <string>

namespace interpolation_test {

using namespace ancf;

TEST_CASE("hermite: a cubic, its slope and its curvature are reproduced",
          "[element][interpolation]") {
    constexpr double length = 1.7;
    const auto line = [](double x) { return 0.3 - 1.1 * x + 0.7 * x * x - 0.4 * x * x * x; };
    const auto slope = [](double x) { return -1.1 + 1.4 * x - 1.2 * x * x; };
    const auto curvature = [](double x) { return 1.4 - 2.4 * x; };
    const double nodal[4] = {line(0.0), slope(0.0), line(length), slope(length)};
    for (const double xi : {0.0, 0.21, 0.5, 0.83, 1.0}) {
        double value[3] = {};
        for (unsigned k = 0; k < 4; ++k) {
            value[0] += hermite(xi, length)[k] * nodal[k];
            value[1] += hermite_first(xi, length)[k] * nodal[k];
            value[2] += hermite_second(xi, length)[k] * nodal[k];
        }
        CHECK(value[0] == Approx(line(xi * length)).margin(1e-14));
        CHECK(value[1] == Approx(slope(xi * length)).margin(1e-14));
        CHECK(value[2] == Approx(curvature(xi * length)).margin(1e-14));
    }
}

double factorial(int n) { return std::tgamma(n + 1.0); }

/// Returns the error of a quadrature for x^degree on [0, 1].
double error(const Quadrature& quadrature, int degree) {
    double sum = 0.0;
    for (const QuadraturePoint& point : quadrature)
        sum += point.weight * std::pow(point.xi, degree);
    return std::abs(sum - 1.0 / (degree + 1));
}

TEST_CASE("quadrature: Gauss is exact to degree 2 n - 1, Lobatto to 2 n - 3",
          "[element][interpolation]") {
    for (int points = 1; points <= 16; ++points) {
        for (int degree = 0; degree < 2 * points; ++degree)
            CHECK(error(gauss_quadrature(points), degree) <= 1e-14);
        CHECK(error(gauss_quadrature(points), 2 * points) >= 1e-19 * std::pow(10.0, -points));
    }
    CHECK(error(gauss_quadrature(4), 8) >= 1e-5);
    for (int points = 2; points <= 5; ++points) {
        for (int degree = 0; degree <= 2 * points - 3; ++degree)
            CHECK(error(lobatto_quadrature(points), degree) <= 1e-15);
        // what the remainder of the formula says of the next degree
        const double next = points * std::pow(points - 1, 3) * std::pow(factorial(points - 2), 4) /
                            ((2 * points - 1) * std::pow(factorial(2 * points - 2), 2));
        CHECK(error(lobatto_quadrature(points), 2 * points - 2) == Approx(next));
        CHECK(lobatto_quadrature(points).front().xi == 0.0);
        CHECK(lobatto_quadrature(points).back().xi == 1.0);
    }
    CHECK_THROWS_WITH(gauss_quadrature(17), ContainsSubstring("17"));
    CHECK_THROWS_WITH(lobatto_quadrature(1), ContainsSubstring("1"));
}

TEST_CASE("Rule: every name gives a rule of that name, an unknown one lists them",
          "[element][interpolation]") {
    int names = 0;
    for (const std::string_view name : Rule::names()) {
        const Rule rule = Rule::named(name);
        CHECK(rule.name() == name);
        for (unsigned group = 0; group < strain_group_count; ++group) {
            double sum = 0.0;
            for (const RuleStation& station : rule.stations()) sum += station.weights[group];
            CHECK(sum == Approx(1.0).epsilon(1e-15));
        }
        ++names;
    }
    CHECK(names == 8);
    CHECK_THROWS_WITH(Rule::named("simpson"),
                      ContainsSubstring("simpson") && ContainsSubstring("lobatto3"));
}

TEST_CASE("Rule: groups that share points share stations", "[element][interpolation]") {
    CHECK(Rule::paper().stations().size() == 4);
    const Rule mixed = Rule::mixed();
    REQUIRE(mixed.stations().size() == 5);
    CHECK(mixed.points(StrainGroup::axial) == 3);
    CHECK(mixed.points(StrainGroup::bending) == 2);
    CHECK(Rule::quintic().points(StrainGroup::axial) == 5);
    CHECK(Rule::quintic().points(StrainGroup::bending) == 4);
    for (std::size_t k = 0; k < 5; ++k) CHECK(mixed.stations()[k].axial_only() == (k % 2 == 0));
    const Rule shared = Rule::grouped("shared", gauss_quadrature(3), gauss_quadrature(3),
                                      gauss_quadrature(1), gauss_quadrature(2));
    CHECK(shared.stations().size() == 5);  // the middle of three is the one of one
    CHECK_THROWS_WITH(Rule::grouped("bad", {{1.5, 1.0}}, {{0.5, 1.0}}, {{0.5, 1.0}}, {{0.5, 1.0}}),
                      ContainsSubstring("1.5"));
}

TEST_CASE("mass weights: a uniform bar has the textbook's cubic mass matrix",
          "[element][interpolation]") {
    Moments moments;
    moments.area = 2.0, moments.yy = 0.3, moments.zz = 0.5, moments.yz = -0.1;
    const double density = 7.0, length = 3.0, mass = density * moments.area * length;
    const auto weights = mass_weights<4>(density, moments, length);
    CHECK(weights(0, 0) == Approx(156.0 / 420.0 * mass));
    CHECK(weights(0, 1) == Approx(22.0 / 420.0 * mass * length));
    CHECK(weights(0, 4) == Approx(54.0 / 420.0 * mass));
    CHECK(weights(0, 5) == Approx(-13.0 / 420.0 * mass * length));
    CHECK(weights(1, 5) == Approx(-3.0 / 420.0 * mass * length * length));
    CHECK(weights(2, 2) == Approx(density * moments.yy * length / 3.0));
    CHECK(weights(2, 6) == Approx(density * moments.yy * length / 6.0));
    CHECK(weights(2, 3) == Approx(density * moments.yz * length / 3.0));
    CHECK(weights(0, 2) == 0.0);
    const auto planar = mass_weights<3>(density, moments, length);
    const auto cable = mass_weights<2>(density, moments, length);
    CHECK((planar.topLeftCorner<3, 3>() - weights.topLeftCorner<3, 3>()).norm() == 0.0);
    CHECK((cable.bottomRightCorner<2, 2>() - weights.block<2, 2>(4, 4)).norm() == 0.0);
}

}  // namespace interpolation_test
