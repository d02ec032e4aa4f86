// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A cantilever under a large dead force, whatever its slenderness and its units: the elastica of
/// P L^2/E I = 10.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/richardson.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>

#include <cmath>

namespace slenderness_test {

using Point = ancf::Vector<double, 3>;

/// Returns the tip relative to the length.
/// @param slenderness  depth of the square section over the length
/// @param elements     of equal length, rule mixed
/// @param young        Pa
/// @param length       m
Point tip(double slenderness, int elements, double young = 1e9, double length = 1.0) {
    ancf::Model scene;
    const double height = slenderness * length;
    const auto material = ancf::Material::from_moduli(young, 0.4 * young, 1000.0);
    ancf::CrossSectionOptions options;
    options.rule = ancf::Rule::mixed();
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
        scene, material, ancf::rectangle(height, height), {0, 0, 0}, {length, 0, 0}, elements,
        options);
    scene.clamp(beam.first(), ancf::Clamp::free_slope);
    const double force = 10.0 * young * std::pow(height, 4) / (12.0 * length * length);
    scene.add(ancf::Force<3>(beam.last(), {0, force, 0}));
    ancf::EigenLdlt solver;
    ancf::StaticsOptions how;
    how.newton = ancf::NewtonKind::mixed;
    how.adaptive = true;  // a millionth of the length takes twelve steps
    const auto report = ancf::solve_statics(scene, solver, how);
    REQUIRE(report.status == ancf::Status::converged);
    // the softest displacement of a thread of 1e-6 has 1.7 eps of the energy of its terms
    CHECK(report.stability ==
          (slenderness > 5e-6 ? ancf::Stability::stable : ancf::Stability::unknown));
    return scene.position(beam.last()) / length;
}

TEST_CASE("slenderness: 64 elements are within 2e-6 of their limit", "[verification]") {
    const Point elastica(0.445004402246, 0.810609024880, 0.0);
    CHECK((tip(1e-3, 64) - elastica).norm() <= 2e-6);  // measured 1.6e-6, its extension and shear
    CHECK((tip(1e-4, 64) - elastica).norm() <= 2e-6);  // measured 1.0e-7

    // a section of a hundredth of the length has a limit of its own, 1.5e-4 from the elastica
    Point limit = Point::Zero();
    for (const int k : {0, 1}) {
        const auto value = ancf::richardson([k](int n) { return tip(1e-2, n)[k]; }, 32);
        REQUIRE(value.settles);
        CHECK(value.order == Approx(4.0).margin(0.2));
        limit[k] = value.estimate;
    }
    CHECK((tip(1e-2, 64) - limit).norm() <= 2e-6);  // measured 8.4e-8
    CHECK((limit - elastica).norm() <= 2e-4);       // measured 1.54e-4
}

TEST_CASE("slenderness: a thread of a millionth of its length keeps six digits", "[verification]") {
    // the residual is known to eps (L/h)^2 = 2e-4 of the load, and yet the tip is right: round-off
    // at the stations stretches them and hardly bends the beam; measured 8.4e-8 and 8.3e-8
    const Point elastica(0.445004402246, 0.810609024880, 0.0);
    CHECK((tip(1e-5, 64) - elastica).norm() <= 1e-6);
    CHECK((tip(1e-6, 64) - elastica).norm() <= 1e-6);
}

TEST_CASE("slenderness: units of length and force leave the digits as they are", "[verification]") {
    const Point metre = tip(5e-3, 16);
    for (const double length : {1e-6, 1e-3, 1e3})
        for (const double young : {1.0, 2.07e11, 1e12}) {
            INFO("length " << length << " m, E " << young << " Pa");
            // round-off of the residual, eps (L/h)^2, is 1e-11
            CHECK((tip(5e-3, 16, young, length) - metre).norm() <= 1e-9);
        }
}

}  // namespace slenderness_test
