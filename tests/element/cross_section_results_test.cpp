// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Results of the cross-section beam at a place: positions, directors, strains, stresses, section
/// forces.

#include <ancf/element/cross_section/beam.hpp>

#include <element/cross_section_beam_samples.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/dense_chain.hpp>
#include <support/random_state.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace cross_section_results_test {

using namespace ancf;
using test::Carried;
using test::Paper;
using test::Pointwise;
using test::Transporting;

TEMPLATE_TEST_CASE(
    "CrossSectionBeam: Jacobians of position and directors equal the complex-step derivatives",
    "[element][cross-section][results]", Paper, Pointwise, Carried, Transporting) {
    const auto element = test::element_of<TestType>(test::variants[0]);
    double position = 0.0, directors = 0.0, velocity = 0.0;
    int places = 0;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        test::Random random(seed);
        const auto e = test::random_state(element, random);
        const auto rate = test::random_state(element, random);
        for (const double xi : {0.0, 0.3, 1.0}) {
            const double y = random.uniform(-0.1, 0.1), z = random.uniform(-0.05, 0.05);
            const auto jacobian = test::complex_step_jacobian(
                [&](const auto& c) { return element.position(c, xi, y, z); }, e);
            position = std::max(
                position, test::relative_error(element.position_jacobian(e, xi, y, z), jacobian));
            velocity = std::max(velocity, test::relative_error(element.velocity(e, rate, xi, y, z),
                                                               (jacobian * rate).eval()));
            const auto turning = test::complex_step_jacobian(
                [&](const auto& c) {
                    const auto d = element.directors(c, xi);
                    Vector<std::complex<double>, 6> column;
                    column << d.col(0), d.col(1);
                    return column;
                },
                e);
            const auto axis = element.position_jacobian(e, xi);
            Matrix<double, 6, 24> by_directors;  // a point at a distance of 1, less the axis
            by_directors << element.position_jacobian(e, xi, 1.0, 0.0) - axis,
                element.position_jacobian(e, xi, 0.0, 1.0) - axis;
            directors = std::max(directors, test::relative_error(by_directors, turning));
            ++places;
        }
    }
    CHECK(places == 150);
    CHECK(position <= 1e-13);  // round-off; measured 4e-16
    CHECK(directors <= 1e-13);
    CHECK(velocity <= 1e-13);
}

TEMPLATE_TEST_CASE("CrossSectionBeam: a rigid motion carries points and directors along",
                   "[element][cross-section][results]", Paper, Pointwise, Carried, Transporting) {
    const auto element = test::element_of<TestType>(test::variants[0]);
    test::Random random(3);
    for (int k = 0; k < 20; ++k) {
        const auto turn = test::random_rotation<3>(random);
        const Vector<double, 3> shift = random.vector<3>();
        const auto e = test::moved<TestType>(test::reference_coordinates(element), turn, shift);
        const double xi = random.uniform(0.0, 1.0), y = 0.07, z = -0.03;
        const Vector<double, 3> expected = turn * Vector<double, 3>(xi * 0.7, y, z) + shift;
        CHECK((element.position(e, xi, y, z) - expected).norm() <= 1e-14);
        CHECK((element.directors(e, xi) - turn.rightCols<2>()).norm() <= 1e-14);
        CHECK(element.green_strain(e, xi, y, z).norm() <= 1e-14);
        CHECK(element.stress(e, xi, y, z).norm() <= 1e-14 * test::sample_material().young);
    }
}

TEMPLATE_TEST_CASE("CrossSectionBeam: strains of a point are those of the gradient of positions",
                   "[element][cross-section][results]", Paper, Pointwise, Carried, Transporting) {
    const auto element = test::element_of<TestType>(test::variants[0]);
    constexpr double h = 1e-5;  // central differences in xi: an error of h^2 = 1e-10
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        test::Random random(seed);
        const auto e = test::random_state(element, random);
        const double xi = random.uniform(0.1, 0.9);
        const double y = random.uniform(-0.1, 0.1), z = random.uniform(-0.05, 0.05);
        const Vector<double, 3> F_x =
            (element.position(e, xi + h, y, z) - element.position(e, xi - h, y, z)) /
            (2.0 * h * element.length());
        const auto directors = element.directors(e, xi);
        const auto strain = element.green_strain(e, xi, y, z);
        CHECK(strain(0) == Approx((F_x.squaredNorm() - 1.0) / 2.0).margin(1e-7));
        CHECK(strain(4) == Approx(F_x.dot(directors.col(1))).margin(1e-7));
        CHECK(strain(5) == Approx(F_x.dot(directors.col(0))).margin(1e-7));
    }
}

TEST_CASE("CrossSectionBeam: transverse strains are linear between the nodes' slopes",
          "[element][cross-section][results]") {
    const auto green = test::element_of(test::variants[0]);
    const auto stretch = test::element_of(test::variants[3]);
    auto e = test::reference_coordinates(green);
    e.segment<3>(6) *= 1.2;             // r_y at the first node
    e.segment<3>(21) << 0.0, 0.1, 0.9;  // r_z at the second
    CHECK(green.transverse_strains(e, 0.25)(0) == Approx(0.75 * 0.22));
    CHECK(stretch.transverse_strains(e, 0.25)(0) == Approx(0.75 * 0.2));
    CHECK(green.transverse_strains(e, 0.25)(1) == Approx(0.25 * (0.82 - 1.0) / 2.0));
    CHECK(stretch.transverse_strains(e, 0.25)(1) == Approx(0.25 * (std::sqrt(0.82) - 1.0)));
    CHECK(green.transverse_strains(e, 0.25)(2) == Approx(0.25 * 0.1));
}

TEST_CASE("CrossSectionBeam: strains at the stations integrate to the energy",
          "[element][cross-section][results]") {
    const auto variant = GENERATE(from_range(std::begin(test::variants), std::end(test::variants)));
    INFO(variant.name);
    if (std::string(variant.rule) == "mixed") return;  // one weight per station needed
    const auto element = test::element_of(variant);
    const auto section =
        section_stiffness(test::sample_material(), test::section_of(variant), variant.model);
    test::Random random(9);
    const auto e = test::random_state(element, random);
    double energy = 0.0;
    for (const RuleStation& station : element.options().rule.stations()) {
        const Vector<double, 12> s = element.strains(e, station.xi);
        energy += station.weights[0] * 0.35 *
                  (s.head<6>().dot(section.axial * s.head<6>()) +
                   s.segment<3>(6).dot(section.shear_y * s.segment<3>(6)) +
                   s.tail<3>().dot(section.shear_z * s.tail<3>()));
    }
    for (const QuadraturePoint& point : gauss_quadrature(2)) {
        const Vector<double, 3> s = element.transverse_strains(e, point.xi);
        energy += point.weight * 0.35 *
                  (section.transverse_yy * s(0) * s(0) + section.transverse_zz * s(1) * s(1) +
                   section.transverse_yz * s(2) * s(2));
    }
    CHECK(element.energy(e) == Approx(energy).epsilon(1e-13));
}

TEST_CASE("CrossSectionBeam: a stretched bar pulls with its stretch times E A times Green's strain",
          "[element][cross-section][results]") {
    const auto element = test::element_of(test::variants[0]);
    const double stretch = 1.3, area = 0.02, young = test::sample_material().young;
    auto e = test::reference_coordinates(element);
    e(12) *= stretch, e(3) *= stretch, e(15) *= stretch;
    const auto turn = test::rotation(Vector<double, 3>(0.3, -0.8, 0.5));
    e = test::moved<Paper>(e, turn, Vector<double, 3>(1.0, 2.0, 3.0));
    const SectionForces forces = element.section_forces(e, 0.4);
    const double expected = young * area * (stretch * stretch - 1.0) / 2.0 * stretch;
    CHECK(forces.axial == Approx(expected).epsilon(1e-13));
    for (const double other :
         {forces.shear_y, forces.shear_z, forces.torque, forces.moment_y, forces.moment_z}) {
        CHECK(std::abs(other) <= 1e-13 * expected);
    }
    // the nodes agree
    CHECK((turn.transpose() * element.force(e).segment<3>(12))(0) ==
          Approx(expected).epsilon(1e-13));
    CHECK(element.stress(e, 0.4, 0.05, 0.02)(0) ==
          Approx(expected / area / stretch).epsilon(1e-13));
}

/// Largest deviation of the section forces from those of a load at the tip, over the middles of the
/// elements.
struct Imbalance {
    double force = 0.0;   ///< relative to the load
    double moment = 0.0;  ///< relative to the load times the length
};

Imbalance imbalance(int elements, double scale, const Section& section) {
    const Paper element(Material::from_moduli(2.0e7, 8.0e6, 1.0), section, 1.0 / elements);
    test::DenseChain<Paper> chain(element, elements);
    const Vector<double, 3> load = scale * Vector<double, 3>(0.3, 1.0, -0.7);
    REQUIRE(chain.solve(load, 1e-8) > 0);
    Imbalance worst;
    for (int k = 0; k < elements; ++k) {
        const auto e = chain.element_state(k);
        const SectionForces f = element.section_forces(e, 0.5);
        constexpr double h = 1e-6;
        const Vector<double, 3> r = element.position(e, 0.5);
        const Vector<double, 3> t =
            (element.position(e, 0.5 + h) - element.position(e, 0.5 - h)).normalized();
        // the frame (t, n, c) as near to both directors as can be
        const auto d = element.directors(e, 0.5);
        const auto across = [&t](const Vector<double, 3>& v) -> Vector<double, 3> {
            return (v - t.dot(v) * t).normalized();
        };
        const Vector<double, 3> n = (across(d.col(0)) + across(d.col(1)).cross(t)).normalized();
        const Vector<double, 3> c = t.cross(n);
        const Vector<double, 3> force = f.axial * t + f.shear_y * n + f.shear_z * c;
        const Vector<double, 3> moment = f.torque * t + f.moment_y * n + f.moment_z * c;
        worst.force = std::max(worst.force, (force - load).norm() / load.norm());
        worst.moment =
            std::max(worst.moment, (moment - (chain.tip() - r).cross(load)).norm() / load.norm());
    }
    return worst;
}

TEST_CASE("CrossSectionBeam: section forces balance the load at the tip",
          "[element][cross-section][results]") {
    // Strains of a displacement element: the limits are about three times what was measured.
    const Section slender = rectangle(0.05, 0.1);
    const Imbalance coarse = imbalance(4, 1.0, slender), fine = imbalance(16, 1.0, slender);
    CHECK(coarse.force <= 1e-2);
    CHECK(coarse.moment <= 1e-3);
    CHECK(fine.force <= 1e-3);
    CHECK(fine.moment <= 1e-4);
    CHECK(coarse.force / fine.force >= 8.0);
    CHECK(coarse.moment / fine.moment >= 8.0);
    const Imbalance bent = imbalance(16, 20.0, slender);  // tip moved by a fifth of the length
    CHECK(bent.force <= 1e-2);
    CHECK(bent.moment <= 1e-3);
}

}  // namespace cross_section_results_test
