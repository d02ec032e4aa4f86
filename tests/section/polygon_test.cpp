// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/section/polygon.hpp>
#include <ancf/section/profiles.hpp>

#include <section/area_integral.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace polygon_test {

using ancf::polygon;
using ancf::SectionPoint;
using ancf::test::difference;
using ancf::test::moments_of;

constexpr double tolerance = 1e-13;  // round-off; measured 3e-15

/// Returns a star-shaped polygon about a centre, its corners at random radii: rarely convex.
std::vector<SectionPoint> random_star(std::uint64_t seed, SectionPoint centre) {
    ancf::test::Random random(seed);
    const int count = 3 + static_cast<int>(seed % 9);
    std::vector<SectionPoint> points;
    for (int k = 0; k < count; ++k) {
        const double radius = random.uniform(0.2, 1.0);
        const double angle = 2.0 * std::acos(-1.0) * (k + random.uniform(0.0, 0.3)) / count;
        points.push_back(
            {centre.y + radius * std::cos(angle), centre.z + radius * std::sin(angle)});
    }
    return points;
}

TEST_CASE("polygon: a rectangle's corners give the rectangle", "[section][polygon]") {
    const auto section = polygon({{-0.25, -0.05}, {0.25, -0.05}, {0.25, 0.05}, {-0.25, 0.05}});
    CHECK(difference(section.moments(), ancf::rectangle(0.1, 0.5).moments()) <= tolerance);
}

TEST_CASE("polygon: an I-section's outline gives the I-section", "[section][polygon]") {
    const auto shape = ancf::i_section(0.2, 0.5, 0.03, 0.05);
    CHECK(difference(polygon(shape.outline()).moments(), shape.moments()) <= tolerance);
}

TEST_CASE(
    "polygon: random concave polygons equal the quadrature over their triangles, either way "
    "round",
    "[section][polygon]") {
    int checked = 0;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        const SectionPoint centre{0.3, -0.6};
        auto points = random_star(seed, centre);
        ancf::test::Area area;
        for (std::size_t i = 0; i < points.size(); ++i)
            area = area + ancf::test::triangle(centre, points[i], points[(i + 1) % points.size()]);
        const auto expected = moments_of(area);
        REQUIRE(expected.area > 0.0);
        const auto section = polygon(points);
        CHECK(difference(section.moments(), expected) <= tolerance);
        std::reverse(points.begin(), points.end());
        const auto reversed = polygon(points);
        CHECK(difference(reversed.moments(), expected) <= tolerance);
        const auto& outline = reversed.outline();
        double twice_area = 0.0;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const auto p = outline[i], q = outline[(i + 1) % outline.size()];
            twice_area += p.y * q.z - p.z * q.y;
        }
        CHECK(twice_area == Approx(2.0 * expected.area));
        ++checked;
    }
    CHECK(checked == 50);
}

TEST_CASE("polygon: regular polygons tend to the circle with the square of the angle",
          "[section][polygon]") {
    const auto error = [](int count) {
        std::vector<SectionPoint> points;
        for (int k = 0; k < count; ++k) {
            const double angle = 2.0 * std::acos(-1.0) * k / count;
            points.push_back({0.4 * std::cos(angle), 0.4 * std::sin(angle)});
        }
        return difference(polygon(points).moments(), ancf::circle(0.4).moments());
    };
    const double coarse = error(64), fine = error(256);
    CHECK(coarse < 2e-2);
    CHECK(coarse / fine == Approx(16.0).epsilon(0.01));
}

TEST_CASE("polygon: the origin says where the reference axis runs", "[section][polygon]") {
    const std::vector<SectionPoint> points{{1.0, 2.0}, {1.5, 2.0}, {1.5, 2.1}, {1.0, 2.1}};
    const auto centred = polygon(points, {1.25, 2.05});
    CHECK(difference(centred.moments(), ancf::rectangle(0.1, 0.5).moments()) <= tolerance);
    CHECK(centred.outline().front().y == Approx(-0.25));
    CHECK(difference(polygon(points).moments(),
                     ancf::offset(ancf::rectangle(0.1, 0.5), 1.25, 2.05).moments()) <= tolerance);
}

TEST_CASE("polygon: far from its axis it keeps its own second moments", "[section][polygon]") {
    // 1e4 widths away the raw moments about the axis lose 8 digits of the central ones.
    const auto far = polygon({{1e4, 0.0}, {1e4 + 1.0, 0.0}, {1e4 + 1.0, 1.0}, {1e4, 1.0}});
    CHECK(ancf::centroidal(far.moments()).yy == Approx(1.0 / 12.0).epsilon(1e-6));
    const auto near =
        polygon({{1e4, 0.0}, {1e4 + 1.0, 0.0}, {1e4 + 1.0, 1.0}, {1e4, 1.0}}, {1e4 + 0.5, 0.5});
    CHECK(near.moments().yy == Approx(1.0 / 12.0).epsilon(1e-11));
}

TEST_CASE("polygon: torsion and shear must be given", "[section][polygon]") {
    const auto section = polygon({{0, 0}, {1, 0}, {0, 1}});
    CHECK_THROWS_WITH(section.torsion_constant(), ContainsSubstring("with_torsion_constant"));
    CHECK_THROWS_WITH(section.shear_correction_y(), ContainsSubstring("with_shear_correction"));
    CHECK(section.with_torsion_constant(0.01).torsion_constant() == 0.01);
}

TEST_CASE("polygon: a thin strip in any direction is accepted", "[section][polygon]") {
    const double angle = GENERATE(0.0, 0.3, 0.785398, 1.4);
    const double c = std::cos(angle), s = std::sin(angle);
    std::vector<SectionPoint> points;
    for (const auto& [u, v] : {SectionPoint{-1, -1e-5}, {1, -1e-5}, {1, 1e-5}, {-1, 1e-5}})
        points.push_back({c * u - s * v, s * u + c * v});
    CHECK(polygon(points).moments().area == Approx(4e-5).epsilon(1e-9));
}

TEST_CASE("polygon: what bounds no area, or crosses itself, is refused with the place",
          "[section][polygon][invalid]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    struct Bad {
        std::vector<SectionPoint> points;
        const char* message;
    };
    const std::vector<Bad> table{
        {{}, "at least 3 points, got 0"},
        {{{0, 0}, {1, 0}}, "at least 3 points, got 2"},
        {{{0, 0}, {1, 0}, {nan, 1}}, "y of every polygon point"},
        {{{0, 0}, {1, 0}, {1, infinity}}, "z of every polygon point"},
        {{{0, 0}, {1, 0}, {1, 0}, {0, 1}}, "points 1 and 2 coincide"},
        {{{0, 0}, {1, 0}, {0, 1}, {0, 0}}, "points 3 and 0 coincide"},
        {{{0, 0}, {1, 0}, {2, 0}}, "folds back"},
        {{{0, 0}, {2, 0}, {1, 0}, {1, 1}}, "folds back at point 1"},
        {{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, "edge 0-1 meets edge 2-3"},
        {{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}, "must not touch or cross itself"},
        {{{0, 0}, {1, 0}, {1, 1}, {3, 1}, {3, 2}, {1, 1}, {0, 1}}, "must not touch or cross"},
    };
    for (const Bad& bad : table) {
        CAPTURE(bad.message);
        CHECK_THROWS_WITH(polygon(bad.points), ContainsSubstring(bad.message));
    }
    CHECK_THROWS_WITH(polygon({{0, 0}, {1, 0}, {0, 1}}, {nan, 0.0}), ContainsSubstring("origin"));
}

}  // namespace polygon_test
