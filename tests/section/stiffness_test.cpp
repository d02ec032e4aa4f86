// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/section/polygon.hpp>
#include <ancf/section/stiffness.hpp>

#include <section/area_integral.hpp>
#include <support/catch.hpp>
#include <support/dense.hpp>
#include <support/random_state.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace stiffness_test {

using ancf::Material;
using ancf::Section;
using ancf::section_stiffness;
using ancf::SectionModel;
using ancf::SectionStiffness;
using ancf::Vector;
using ancf::test::Area;

const Material steel = Material::from_moduli(2.07e11, 7.9615e10, 7850.0);

/// The strains of a station: e1 to e12.
struct Strains {
    Vector<double, 6> axial;
    Vector<double, 3> shear_y, shear_z;
};

Strains random_strains(std::uint64_t seed) {
    ancf::test::Random random(seed);
    Strains s;
    s.axial = random.vector<6>();
    s.shear_y = random.vector<3>();
    s.shear_z = random.vector<3>();
    return s;
}

double energy(const SectionStiffness& c, const Strains& s) {
    return (s.axial.dot(c.axial * s.axial) + s.shear_y.dot(c.shear_y * s.shear_y) +
            s.shear_z.dot(c.shear_z * s.shear_z)) /
           2.0;
}

/// Returns the energy per length of [Dufva2006, Eq. 29] by quadrature over the area.
double energy_by_area(const Area& area, const Strains& s, double k_y, double k_z) {
    return ancf::test::integral(area, [&](double y, double z) {
        const Vector<double, 3> p{1.0, y, z};
        Vector<double, 6> q;
        q << 1.0, y, z, y * y, y * z, z * z;
        const double xx = q.dot(s.axial), xy = p.dot(s.shear_y), xz = p.dot(s.shear_z);
        return (steel.young * xx * xx + steel.shear * (k_y * xy * xy + k_z * xz * xz)) / 2.0;
    });
}

double least_eigenvalue(const ancf::MatrixX& matrix) { return ancf::test::eigenvalues(matrix)(0); }

TEST_CASE("section stiffness: the paper's energy equals the quadrature over the area",
          "[section][stiffness]") {
    constexpr double tolerance = 1e-13;  // round-off; measured 1e-15
    const ancf::SectionPoint a{0.1, 0.2}, b{0.5, 0.3}, c{0.2, 0.9};
    const std::vector<std::pair<Section, Area>> cases{
        {ancf::rectangle(0.3, 0.7), ancf::test::box(-0.35, 0.35, -0.15, 0.15)},
        {ancf::tube(0.4, 0.3), ancf::test::annulus(0.3, 0.4)},
        {ancf::offset(ancf::rectangle(0.3, 0.7), 0.5, -0.2),
         ancf::test::box(0.15, 0.85, -0.35, -0.05)},
        {ancf::polygon({a, b, c}), ancf::test::triangle(a, b, c)}};
    for (const auto& [section, area] : cases)
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            CAPTURE(seed);
            const auto stiffness =
                section_stiffness(steel, section.with_shear_correction(0.7, 0.9));
            const Strains strains = random_strains(seed);
            const double expected = energy_by_area(area, strains, 0.7, 0.9);
            REQUIRE(expected > 0.0);
            CHECK(std::abs(energy(stiffness, strains) / expected - 1.0) <= tolerance);
        }
}

TEST_CASE("section stiffness: transverse strains meet E A, E A and the mean k G A",
          "[section][stiffness]") {
    const Section section = ancf::rectangle(0.1, 0.5).with_shear_correction(0.7, 0.9);
    for (const auto model : {SectionModel::paper, SectionModel::saint_venant}) {
        const auto stiffness = section_stiffness(steel, section, model);
        CHECK(stiffness.transverse_yy == Approx(2.07e11 * 0.05));
        CHECK(stiffness.transverse_zz == Approx(2.07e11 * 0.05));
        CHECK(stiffness.transverse_yz == Approx(0.8 * 7.9615e10 * 0.05));
    }
}

TEST_CASE(
    "section stiffness: pure twist meets k G Ip in the paper's model and G J in Saint-Venant's",
    "[section][stiffness]") {
    // Section 5.3 of the paper: 0.00254 x 0.00635, half a turn on 0.254 m.
    const Material material = Material::from_moduli(8.27371e10, 3.17159e10, 1.0);
    const Section section = ancf::rectangle(0.00254, 0.00635);
    const double rate = std::acos(-1.0) / 0.254;
    const auto torque = [&](SectionModel model) {
        const auto stiffness = section_stiffness(material, section, model);
        return (stiffness.shear_z(1, 1) + stiffness.shear_y(2, 2)) * rate;  // h_yz = -h_zy = rate
    };
    CHECK(torque(SectionModel::paper) == Approx(20.5515028475).epsilon(1e-11));
    CHECK(torque(SectionModel::saint_venant) == Approx(10.1789668163).epsilon(1e-11));
}

TEST_CASE(
    "section stiffness: Saint-Venant changes only the entries of h_yz and h_zy of a symmetric "
    "section",
    "[section][stiffness]") {
    const Section section = ancf::rectangle(0.1, 0.5);
    const auto paper = section_stiffness(steel, section, SectionModel::paper);
    auto other = section_stiffness(steel, section, SectionModel::saint_venant);
    const auto& m = section.moments();
    const double torsion = steel.shear * section.torsion_constant();
    CHECK(other.shear_z(1, 1) == Approx(torsion * m.yy / m.polar()));
    CHECK(other.shear_y(2, 2) == Approx(torsion * m.zz / m.polar()));
    other.shear_z(1, 1) = paper.shear_z(1, 1);
    other.shear_y(2, 2) = paper.shear_y(2, 2);
    CHECK(other.axial == paper.axial);
    CHECK((other.shear_y - paper.shear_y).norm() <= 1e-15 * paper.shear_y.norm());
    CHECK((other.shear_z - paper.shear_z).norm() <= 1e-15 * paper.shear_z.norm());
}

TEST_CASE(
    "section stiffness: a moved section has the energy of the centred one in the strains of "
    "its centroid",
    "[section][stiffness]") {
    constexpr double tolerance = 1e-12;  // cancellation of the transport; measured 1e-15
    const double y = 0.5, z = -0.2;
    const Section full = ancf::rectangle(0.3, 0.7);
    ancf::Moments second_order = full.moments();
    second_order.yyyy = second_order.yyzz = second_order.zzzz = 0.0;
    const Section second = Section::from_moments(second_order)
                               .with_shear_correction(0.8, 0.7)
                               .with_torsion_constant(0.005);
    for (const auto& [centred, model] :
         {std::pair{full, SectionModel::paper}, std::pair{full, SectionModel::saint_venant},
          std::pair{second, SectionModel::paper}, std::pair{second, SectionModel::saint_venant}}) {
        CAPTURE(centred.moments().has_fourth_order());
        const auto here = section_stiffness(steel, centred, model);
        const auto there = section_stiffness(steel, ancf::offset(centred, y, z), model);
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const Strains s = random_strains(seed);
            Strains moved = s;  // p(y + y0, z + z0) in powers of y and z
            const auto& e = s.axial;
            moved.axial(0) += y * e(1) + z * e(2) + y * y * e(3) + y * z * e(4) + z * z * e(5);
            moved.axial(1) += 2.0 * y * e(3) + z * e(4);
            moved.axial(2) += y * e(4) + 2.0 * z * e(5);
            moved.shear_y(0) += y * s.shear_y(1) + z * s.shear_y(2);
            moved.shear_z(0) += y * s.shear_z(1) + z * s.shear_z(2);
            const double expected = energy(here, moved);
            CAPTURE(seed);
            CHECK(std::abs(energy(there, s) / expected - 1.0) <= tolerance);
        }
    }
}

TEST_CASE("section stiffness: every block is symmetric and positive definite, however small J is",
          "[section][stiffness]") {
    const Section angle = ancf::polygon({{0, 0}, {1, 0}, {1, 0.1}, {0.1, 0.1}, {0.1, 1}, {0, 1}})
                              .with_shear_correction(0.4, 0.4);
    for (const double torsion : {1e-9, 1e-4, 1.0})
        for (const auto model : {SectionModel::paper, SectionModel::saint_venant}) {
            const auto c = section_stiffness(steel, angle.with_torsion_constant(torsion), model);
            CAPTURE(torsion);
            CHECK(c.axial == c.axial.transpose());
            CHECK((c.shear_y - c.shear_y.transpose()).norm() <= 1e-15 * c.shear_y.norm());
            CHECK((c.shear_z - c.shear_z.transpose()).norm() <= 1e-15 * c.shear_z.norm());
            CHECK(least_eigenvalue(c.axial) > 0.0);
            CHECK(least_eigenvalue(c.shear_y) > 0.0);
            CHECK(least_eigenvalue(c.shear_z) > 0.0);
        }
}

TEST_CASE("section stiffness: a section known to second order stiffens no quadratic strain",
          "[section][stiffness]") {
    ancf::Moments m;
    m.area = 1e4;
    m.yy = m.zz = 100.0;
    const Section section =
        Section::from_moments(m).with_shear_correction(1.0, 1.0).with_torsion_constant(100.0);
    const auto c = section_stiffness(Material::from_moduli(1.0, 1.0, 1.0), section,
                                     SectionModel::saint_venant);
    ancf::Matrix<double, 6> expected = ancf::Matrix<double, 6>::Zero();
    expected.diagonal().head<3>() << 1e4, 100.0, 100.0;
    CHECK(c.axial == expected);
    CHECK(c.shear_y(2, 2) + c.shear_z(1, 1) == Approx(100.0));
    CHECK(least_eigenvalue(c.axial) >= 0.0);
}

TEST_CASE("section stiffness: what the model needs and the section lacks is named",
          "[section][stiffness][invalid]") {
    const Section bare = Section::from_moments(ancf::rectangle(1.0, 2.0).moments());
    CHECK_THROWS_WITH(section_stiffness(steel, bare), ContainsSubstring("shear_correction"));
    const Section half = bare.with_shear_correction(1.0, 1.0);
    CHECK(section_stiffness(steel, half).transverse_yy == Approx(2.0 * 2.07e11));
    CHECK_THROWS_WITH(section_stiffness(steel, half, SectionModel::saint_venant),
                      ContainsSubstring("torsion_constant"));
    CHECK_THROWS_WITH(section_stiffness(Material{1.0, 0.0, 1.0}, ancf::circle(1.0)),
                      ContainsSubstring("shear"));
}

}  // namespace stiffness_test
