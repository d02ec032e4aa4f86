// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/section/section.hpp>

#include <support/catch.hpp>

#include <cmath>
#include <limits>

namespace torsion_test {

using ancf::rectangle_torsion_constant;

/// The series as textbooks print it, tanh and all, summed until its tail is below round-off.
long double textbook_series(long double a, long double b) {
    const long double pi = std::acos(-1.0L);
    long double sum = 0.0L;
    for (int n = 8001; n >= 1; n -= 2)  // tail: 8001^-4/8 < 4e-17
        sum += std::tanh(n * pi * a / (2.0L * b)) / std::pow(static_cast<long double>(n), 5);
    return a * b * b * b * (1.0L / 3.0L - 64.0L * b / (std::pow(pi, 5) * a) * sum);
}

TEST_CASE("torsion constant: the square's is 0.1405770149... a^4", "[section][torsion]") {
    CHECK(rectangle_torsion_constant(1.0, 1.0) == Approx(0.14057701495515372).epsilon(1e-13));
    CHECK(ancf::rectangle(2.0, 2.0).torsion_constant() ==
          Approx(16.0 * 0.14057701495515372).epsilon(1e-13));
}

TEST_CASE("torsion constant: 0.00254 x 0.00635 m gives 2.59483951352e-11 m^4",
          "[section][torsion]") {
    CHECK(rectangle_torsion_constant(0.00254, 0.00635) == Approx(2.59483951352e-11).epsilon(1e-11));
}

TEST_CASE("torsion constant: equals the textbook series at any aspect ratio and order of sides",
          "[section][torsion]") {
    constexpr double tolerance = 1e-13;  // asked 1e-10; measured 1e-15
    const double aspect = GENERATE(1.0, 1.0001, 1.2, 1.5, 2.0, 2.5, 3.0, 5.0, 10.0, 100.0, 1e4);
    const auto expected = static_cast<double>(textbook_series(aspect, 1.0L));
    CHECK(std::abs(rectangle_torsion_constant(aspect, 1.0) / expected - 1.0) <= tolerance);
    CHECK(rectangle_torsion_constant(1.0, aspect) == rectangle_torsion_constant(aspect, 1.0));
}

TEST_CASE("torsion constant: a strip of aspect ratio 1e12 has a b^3/3", "[section][torsion]") {
    // a b^3 (1/3 - 0.21 b/a): the second term is 6e-13 of the first.
    CHECK(rectangle_torsion_constant(1e6, 1e-6) == Approx(1e-12 / 3.0).epsilon(1e-11));
}

TEST_CASE("torsion constant: scales with the fourth power of length from micrometres to kilometres",
          "[section][torsion]") {
    const double scale = GENERATE(1e-6, 1e-3, 1e3);
    CHECK(rectangle_torsion_constant(2.0 * scale, 3.0 * scale) ==
          Approx(rectangle_torsion_constant(2.0, 3.0) * std::pow(scale, 4)).epsilon(1e-13));
}

TEST_CASE("torsion constant: sides that are not positive and finite are refused by name",
          "[section][torsion]") {
    const double bad = GENERATE(0.0, -1.0, std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::quiet_NaN());
    CHECK_THROWS_WITH(rectangle_torsion_constant(bad, 1.0), ContainsSubstring("width"));
    CHECK_THROWS_WITH(rectangle_torsion_constant(1.0, bad), ContainsSubstring("height"));
}

}  // namespace torsion_test
