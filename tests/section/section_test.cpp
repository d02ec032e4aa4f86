// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/constants.hpp>
#include <ancf/error.hpp>
#include <ancf/section/section.hpp>

#include <section/area_integral.hpp>
#include <support/catch.hpp>

#include <cmath>
#include <limits>

namespace section_test {

using ancf::Moments;
using ancf::Section;
using ancf::test::difference;
using ancf::test::moments_of;

using ancf::pi;

TEST_CASE("rectangle: width lies along z and height along y, as closed forms say",
          "[section][rectangle]") {
    const double w = 0.1, h = 0.5;
    const Moments m = ancf::rectangle(w, h).moments();
    CHECK(m.area == Approx(w * h));
    CHECK(m.yy == Approx(w * h * h * h / 12.0));
    CHECK(m.zz == Approx(h * w * w * w / 12.0));
    CHECK(m.yyyy == Approx(w * h * h * h * h * h / 80.0));
    CHECK(m.zzzz == Approx(h * w * w * w * w * w / 80.0));
    CHECK(m.yyzz == Approx(w * w * w * h * h * h / 144.0));
    CHECK(m.polar() == m.yy + m.zz);
    CHECK(m.has_fourth_order());
}

TEST_CASE("rectangle, circle, tube: moments equal those by quadrature over the area",
          "[section][moments]") {
    constexpr double tolerance = 1e-13;  // round-off of the quadrature; measured below 3e-14
    CHECK(difference(ancf::rectangle(0.3, 0.7).moments(),
                     moments_of(ancf::test::box(-0.35, 0.35, -0.15, 0.15))) <= tolerance);
    CHECK(difference(ancf::circle(0.4).moments(), moments_of(ancf::test::annulus(0.0, 0.4))) <=
          tolerance);
    CHECK(difference(ancf::tube(0.4, 0.3).moments(), moments_of(ancf::test::annulus(0.3, 0.4))) <=
          tolerance);
}

TEST_CASE("rectangle, circle, tube: default shear correction and torsion constant",
          "[section][defaults]") {
    CHECK(ancf::rectangle(1.0, 2.0).shear_correction_y() == 5.0 / 6.0);
    CHECK(ancf::rectangle(1.0, 2.0).shear_correction_z() == 5.0 / 6.0);
    CHECK(ancf::circle(1.0).shear_correction_y() == 6.0 / 7.0);
    CHECK(ancf::circle(2.0).torsion_constant() == Approx(pi * 16.0 / 2.0));
    CHECK(ancf::tube(2.0, 1.0).torsion_constant() == Approx(pi * 15.0 / 2.0));
    // The tube lies between the circle and the thin wall.
    CHECK(ancf::tube(1.0, 1e-6).shear_correction_y() == Approx(6.0 / 7.0).epsilon(1e-10));
    CHECK(ancf::tube(1.0, 0.999999).shear_correction_z() == Approx(0.5).epsilon(1e-10));
}

TEST_CASE("Section: with_ functions change a copy and nothing else", "[section]") {
    const Section plain = ancf::rectangle(0.1, 0.2);
    const Section changed =
        plain.with_shear_correction(0.7, 0.9).with_torsion_constant(1.25e-5).with_outline({});
    CHECK(changed.shear_correction_y() == 0.7);
    CHECK(changed.shear_correction_z() == 0.9);
    CHECK(changed.torsion_constant() == 1.25e-5);
    CHECK(changed.outline().empty());
    CHECK(difference(changed.moments(), plain.moments()) == 0.0);
    CHECK(plain.shear_correction_y() == 5.0 / 6.0);
    CHECK(plain.outline().size() == 4);
}

TEST_CASE("Section: mass has the moments of the stiffness until others are given", "[section]") {
    const Section plain = ancf::rectangle(0.1, 0.2);
    CHECK(difference(plain.mass_moments(), plain.moments()) == 0.0);
    const ancf::Moments mass = ancf::tube(0.3, 0.2).moments();
    const Section coated = plain.with_mass_moments(mass);
    CHECK(difference(coated.mass_moments(), mass) == 0.0);
    CHECK(difference(coated.moments(), plain.moments()) == 0.0);
    const Section moved = ancf::offset(coated, 0.01, -0.02);
    CHECK(difference(moved.mass_moments(), ancf::translated(mass, 0.01, -0.02)) == 0.0);
    CHECK_THROWS_AS(plain.with_mass_moments(ancf::Moments{}), ancf::InvalidArgument);
}

TEST_CASE("Section: what was never given is refused with the way to give it", "[section]") {
    const Section section = Section::from_moments(ancf::rectangle(1.0, 2.0).moments());
    CHECK_THROWS_WITH(section.shear_correction_y(), ContainsSubstring("with_shear_correction"));
    CHECK_THROWS_WITH(section.shear_correction_z(), ContainsSubstring("with_shear_correction"));
    CHECK_THROWS_WITH(section.torsion_constant(), ContainsSubstring("with_torsion_constant"));
}

TEST_CASE("Section: bad dimensions are refused by name", "[section][invalid]") {
    const double bad = GENERATE(0.0, -1.0, std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::quiet_NaN());
    CAPTURE(bad);
    CHECK_THROWS_WITH(ancf::rectangle(bad, 1.0), ContainsSubstring("width"));
    CHECK_THROWS_WITH(ancf::rectangle(1.0, bad), ContainsSubstring("height"));
    CHECK_THROWS_WITH(ancf::circle(bad), ContainsSubstring("radius"));
    CHECK_THROWS_WITH(ancf::tube(bad, 1.0), ContainsSubstring("outer_radius"));
    CHECK_THROWS_WITH(ancf::tube(1.0, bad), ContainsSubstring("inner_radius"));
    const Section good = ancf::rectangle(1.0, 1.0);
    CHECK_THROWS_WITH(good.with_shear_correction(bad, 1.0), ContainsSubstring("correction_y"));
    CHECK_THROWS_WITH(good.with_shear_correction(1.0, bad), ContainsSubstring("correction_z"));
    CHECK_THROWS_WITH(good.with_torsion_constant(bad), ContainsSubstring("torsion_constant"));
}

TEST_CASE("Section: dimensions that only together make no sense are refused",
          "[section][invalid]") {
    CHECK_THROWS_WITH(ancf::tube(1.0, 1.0), ContainsSubstring("less than outer_radius"));
    CHECK_THROWS_WITH(ancf::tube(1.0, 2.0), ContainsSubstring("got 2"));
    // Sides so small or large that a moment leaves the range of double.
    CHECK_THROWS_AS(ancf::rectangle(1e-200, 1e-200), ancf::InvalidArgument);
    CHECK_THROWS_AS(ancf::circle(1e80), ancf::InvalidArgument);
}

TEST_CASE("offset: moments are those of the moved area, torsion and shear stay",
          "[section][offset]") {
    constexpr double tolerance = 1e-13;  // round-off; measured below 3e-14
    const Section plain = ancf::rectangle(0.3, 0.7);
    const Section moved = ancf::offset(plain, 0.5, -0.2);
    CHECK(difference(moved.moments(), moments_of(ancf::test::box(0.15, 0.85, -0.35, -0.05))) <=
          tolerance);
    CHECK(moved.torsion_constant() == plain.torsion_constant());
    CHECK(moved.shear_correction_y() == plain.shear_correction_y());
    CHECK(moved.outline().front().y == Approx(plain.outline().front().y + 0.5));
    CHECK(moved.outline().front().z == Approx(plain.outline().front().z - 0.2));
    CHECK(difference(ancf::offset(moved, -0.5, 0.2).moments(), plain.moments()) <= tolerance);
    CHECK(difference(ancf::centroidal(moved.moments()), plain.moments()) <= tolerance);
    const double bad = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(ancf::offset(plain, bad, 0.0), ContainsSubstring("dy"));
    CHECK_THROWS_WITH(ancf::offset(plain, 0.0, bad), ContainsSubstring("dz"));
}

TEST_CASE("from_moments: takes the moments of every shape, centred or not", "[section][moments]") {
    const Section shapes[] = {ancf::rectangle(1.0, 1e-6), ancf::rectangle(3e-6, 2e-6),
                              ancf::circle(7.0), ancf::tube(1.0, 0.9999),
                              ancf::offset(ancf::rectangle(0.1, 0.2), 1.0, 2.0)};
    for (const Section& shape : shapes)
        CHECK(difference(Section::from_moments(shape.moments()).moments(), shape.moments()) == 0.0);
}

TEST_CASE("from_moments: a section known to second order stays so when it is moved",
          "[section][moments]") {
    Moments m;
    m.area = 1e4;
    m.yy = m.zz = 100.0;
    const Section section = Section::from_moments(m);
    CHECK_FALSE(section.moments().has_fourth_order());
    const Moments moved = ancf::offset(section, 0.1, 0.2).moments();
    CHECK_FALSE(moved.has_fourth_order());
    CHECK(moved.y == Approx(1e3));
    CHECK(moved.yy == Approx(100.0 + 1e4 * 0.01));
    CHECK(moved.yz == Approx(1e4 * 0.02));
}

TEST_CASE("from_moments: what belongs to no area is refused", "[section][moments][invalid]") {
    const Moments good = ancf::rectangle(1.0, 2.0).moments();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    struct Bad {
        double Moments::*member;
        double value;
        const char* message;
    };
    const Bad table[] = {
        {&Moments::area, 0.0, "area must be positive"},
        {&Moments::area, -2.0, "got -2"},
        {&Moments::area, nan, "area"},
        {&Moments::yy, 0.0, "yy"},
        {&Moments::zz, -1.0, "zz"},
        {&Moments::yz, nan, "finite"},
        {&Moments::yzzz, nan, "finite"},
        {&Moments::y, 10.0, "second order"},
        {&Moments::yz, 0.7, "second order"},
        {&Moments::yyyy, 0.1, "fourth order"},
        {&Moments::yyzz, 0.0, "fourth order"},
        {&Moments::yyzz, -0.1, "fourth order"},
        {&Moments::zzzz, 0.0, "fourth order"},
        {&Moments::yyy, 5.0, "fourth order"},
        {&Moments::yyyz, 5.0, "fourth order"},
    };
    for (const Bad& bad : table) {
        Moments m = good;
        m.*bad.member = bad.value;
        CAPTURE(bad.message, bad.value);
        CHECK_THROWS_WITH(Section::from_moments(m), ContainsSubstring(bad.message));
    }
}

TEST_CASE("from_moments: the outline has the centroid and radii of gyration of the moments",
          "[section][outline]") {
    const Moments m = moments_of(ancf::test::triangle({0.1, 0.2}, {0.5, 0.3}, {0.2, 0.9}));
    const auto outline = Section::from_moments(m).outline();
    REQUIRE(outline.size() == 4);
    const Moments drawn = moments_of(ancf::test::parallelogram(outline[0], outline[1], outline[3]));
    REQUIRE(drawn.area > 0.0);  // counter-clockwise
    CHECK(drawn.y / drawn.area == Approx(m.y / m.area));
    CHECK(drawn.z / drawn.area == Approx(m.z / m.area));
    CHECK(drawn.yy / drawn.area == Approx(m.yy / m.area));
    CHECK(drawn.yz / drawn.area == Approx(m.yz / m.area));
    CHECK(drawn.zz / drawn.area == Approx(m.zz / m.area));
}

}  // namespace section_test
