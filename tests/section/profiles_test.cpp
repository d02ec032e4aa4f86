// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/section/profiles.hpp>

#include <section/area_integral.hpp>
#include <support/catch.hpp>

#include <cmath>
#include <limits>

namespace profiles_test {

using ancf::hollow_rectangle;
using ancf::i_section;
using ancf::test::box;
using ancf::test::difference;
using ancf::test::moments_of;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Returns V^2/(A int tau^2 dA) of the thin-walled shear flow q = V Q/I of half an I-section, by
/// Simpson's rule: four half flanges of width b/2 at h/2, and the web of height h.
double shear_flow_correction(double b, double h, double flange, double web) {
    constexpr int intervals = 2000;
    const double second_moment = web * h * h * h / 12.0 + 2.0 * b * flange * h * h / 4.0;
    const double area = web * h + 2.0 * b * flange;
    const auto simpson = [](double length, const auto& f) {
        double sum = 0.0;
        for (int k = 0; k <= intervals; ++k) {
            const double weight = k == 0 || k == intervals ? 1.0 : (k % 2 == 1 ? 4.0 : 2.0);
            sum += weight * f(length * k / intervals);
        }
        return sum * length / intervals / 3.0;
    };
    const double flanges = 4.0 * simpson(b / 2.0, [&](double s) {
                               return std::pow(flange * s * h / 2.0, 2) / flange;
                           });
    const double webs = simpson(h, [&](double s) {
        return std::pow(b * flange * h / 2.0 + web * s * (h - s) / 2.0, 2) / web;
    });
    return second_moment * second_moment / (area * (flanges + webs));
}

TEST_CASE("hollow rectangle and I-section: moments equal those by quadrature over the area",
          "[section][profiles]") {
    constexpr double tolerance = 1e-13;  // round-off; measured 1e-15
    CHECK(difference(hollow_rectangle(0.2, 0.5, 0.16, 0.4).moments(),
                     moments_of(box(-0.25, 0.25, 0.08, 0.1) + box(-0.25, 0.25, -0.1, -0.08) +
                                box(0.2, 0.25, -0.08, 0.08) + box(-0.25, -0.2, -0.08, 0.08))) <=
          tolerance);
    CHECK(difference(i_section(0.2, 0.5, 0.03, 0.05).moments(),
                     moments_of(box(0.2, 0.25, -0.1, 0.1) + box(-0.25, -0.2, -0.1, 0.1) +
                                box(-0.2, 0.2, -0.015, 0.015))) <= tolerance);
}

TEST_CASE("hollow rectangle: torsion constant has the accuracy that its page states",
          "[section][profiles]") {
    struct Row {
        double width, height, side_wall, end_wall, torsion, low;
    };
    // Finite differences, extrapolated: about four digits.
    const Row table[] = {{20, 20, 1, 1, 7031.2, 0.025},  {20, 20, 2, 2, 12334.2, 0.045},
                         {20, 20, 4, 4, 18897.0, 0.065}, {10, 20, 1, 1, 2164.9, 0.03},
                         {10, 20, 1, 2, 2484.3, 0.04},   {20, 40, 1, 1, 19243.2, 0.02},
                         {20, 20, 4, 1, 10479.2, 0.075}};
    for (const Row& row : table) {
        CAPTURE(row.width, row.height, row.side_wall, row.end_wall);
        const double torsion =
            hollow_rectangle(row.width, row.height, row.width - 2 * row.side_wall,
                             row.height - 2 * row.end_wall)
                .torsion_constant();
        CHECK(torsion < row.torsion);
        CHECK(torsion > row.torsion * (1.0 - row.low));
    }
}

TEST_CASE("hollow rectangle: a thin square box has J = a^3 t", "[section][profiles]") {
    CHECK(hollow_rectangle(1.0, 1.0, 0.9998, 0.9998).torsion_constant() ==
          Approx(1e-4).epsilon(1e-3));
}

TEST_CASE("I-section: torsion constant has the accuracy that its page states",
          "[section][profiles]") {
    struct Row {
        double width, height, web, flange, torsion, tolerance;
    };
    // Finite differences, extrapolated: about three digits.
    const Row table[] = {{20, 20, 1, 1, 19.493, 0.015},  {10, 20, 1, 2, 53.864, 0.015},
                         {10, 20, 2, 2, 98.583, 0.015},  {20, 20, 1, 2, 107.198, 0.015},
                         {10, 20, 2, 1, 56.398, 0.025},  {10, 20, 4, 4, 713.90, 0.015},
                         {20, 40, 1, 2, 113.864, 0.015}, {10, 10, 2, 2, 71.919, 0.015},
                         {10, 20, 1, 5, 583.5, 0.02}};
    for (const Row& row : table) {
        CAPTURE(row.width, row.height, row.web, row.flange);
        CHECK(i_section(row.width, row.height, row.web, row.flange).torsion_constant() ==
              Approx(row.torsion).epsilon(row.tolerance));
    }
}

TEST_CASE("hollow rectangle and I-section: shear correction is that of the thin-walled shear flow",
          "[section][profiles]") {
    const double b = 0.3, h = 0.5, flange = 0.004, web = 0.003;
    const auto shape = i_section(b, h + flange, web, flange);
    CHECK(shape.shear_correction_y() ==
          Approx(shear_flow_correction(b, h, flange, web)).epsilon(1e-9));
    const double flanges = 2.0 * b * flange;
    CHECK(shape.shear_correction_z() ==
          Approx(5.0 / 6.0 * flanges / shape.moments().area).epsilon(1e-12));

    // A box is an I-section with its web split in two; across, the walls change their parts.
    const auto hollow = hollow_rectangle(b + web, h + flange, b - web, h - flange);
    CHECK(hollow.shear_correction_y() ==
          Approx(shear_flow_correction(b, h, flange, 2.0 * web)).epsilon(1e-9));
    CHECK(hollow.shear_correction_z() ==
          Approx(shear_flow_correction(h, b, web, 2.0 * flange)).epsilon(1e-9));
}

TEST_CASE("hollow rectangle: turning it by a right angle swaps the axes", "[section][profiles]") {
    const auto upright = hollow_rectangle(0.2, 0.5, 0.16, 0.4);
    const auto flat = hollow_rectangle(0.5, 0.2, 0.4, 0.16);
    CHECK(upright.moments().yy == Approx(flat.moments().zz));
    CHECK(upright.shear_correction_y() == Approx(flat.shear_correction_z()));
    CHECK(upright.torsion_constant() == Approx(flat.torsion_constant()));
}

TEST_CASE("I-section: the outline encloses the area of the moments, counter-clockwise",
          "[section][profiles]") {
    const auto shape = i_section(0.2, 0.5, 0.03, 0.05);
    double area = 0.0;
    const auto& points = shape.outline();
    REQUIRE(points.size() == 12);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto p = points[i], q = points[(i + 1) % points.size()];
        area += (p.y * q.z - p.z * q.y) / 2.0;
    }
    CHECK(area == Approx(shape.moments().area));
}

TEST_CASE("hollow rectangle and I-section: bad dimensions are refused by name",
          "[section][profiles][invalid]") {
    struct Bad {
        double a, b, c, d;
        const char* message;
    };
    const Bad hollow[] = {{0, 1, 1, 1, "width"},
                          {1, -1, 1, 1, "height"},
                          {1, 1, 0, 0.5, "inner_width must be positive"},
                          {1, 1, 0.5, not_a_number, "inner_height must be positive"},
                          {1, 1, 1, 0.5, "less than width 1"},
                          {1, 1, 0.5, 2, "less than height 1"},
                          {infinity, 1, 0.5, 0.5, "width"}};
    for (const Bad& bad : hollow)
        CHECK_THROWS_WITH(hollow_rectangle(bad.a, bad.b, bad.c, bad.d),
                          ContainsSubstring(bad.message));
    const Bad beam[] = {{0, 1, 0.1, 0.1, "width"},
                        {1, not_a_number, 0.1, 0.1, "height"},
                        {1, 1, -0.1, 0.1, "web_thickness must be positive"},
                        {1, 1, 0.1, 0, "flange_thickness must be positive"},
                        {1, 4, 1, 1, "less than width 1"},
                        {1, 1, 0.1, 0.5, "half the height 1"},
                        {0.2, 1, 0.02, 0.45, "at most half the width 0.2"},
                        {1, 1, 0.3, 0.1, "twice flange_thickness"}};
    for (const Bad& bad : beam)
        CHECK_THROWS_WITH(i_section(bad.a, bad.b, bad.c, bad.d), ContainsSubstring(bad.message));
}

}  // namespace profiles_test
