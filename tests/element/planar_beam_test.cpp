// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The cross-section beam in the plane: the properties of every element, and equality with the
/// spatial element whose z slopes stand on the plane's normal.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>

#include <element/property_checks.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/random_state.hpp>

#include <iterator>

namespace planar_beam_test {

using namespace ancf;
using Planar = CrossSectionBeam<2>;
using Spatial = CrossSectionBeam<3>;

constexpr double density = 7800.0;
constexpr TransverseStrain all_measures[] = {TransverseStrain::green, TransverseStrain::stretch};

CrossSectionOptions options(TransverseStrain transverse, const char* rule) {
    CrossSectionOptions result = CrossSectionOptions::paper();
    result.rule = Rule::named(rule);
    result.transverse = transverse;
    return result;
}

Section odd_section() { return offset(rectangle(0.1, 0.2), 0.02, 0.0); }

template <class Element>
Element sample(TransverseStrain transverse, const char* rule, const Section& section) {
    return {Material::isotropic(2e7, 0.3, density), section, 0.7, options(transverse, rule)};
}

/// Where the planar coordinates stand among the spatial ones.
constexpr int place[12] = {0, 1, 3, 4, 6, 7, 12, 13, 15, 16, 18, 19};

Spatial::Coordinates lifted(const Planar::Coordinates& e) {
    Spatial::Coordinates result = Spatial::Coordinates::Zero();
    for (int k = 0; k < 12; ++k) result[place[k]] = e[k];
    result[11] = result[23] = 1.0;
    return result;
}

TEST_CASE("planar cross-section beam: it has the properties of every element",
          "[element][planar][properties]") {
    const auto transverse = GENERATE(from_range(std::begin(all_measures), std::end(all_measures)));
    for (const char* rule : {"paper", "mixed", "lobatto3"}) {
        INFO("rule " << rule);
        const auto element = sample<Planar>(transverse, rule, odd_section());
        test::check_zero_at_rest(element);
        test::check_rigid_invariance(element);
        test::check_derivatives(element);  // measured 6e-16
        test::check_zero_modes(element);
        test::check_turning(element);
        test::check_mass(element, density, odd_section().moments());
        test::check_gravity(element, density, odd_section().moments());
        test::check_softened(element, test::reference_coordinates(element), true);
    }
}

TEST_CASE("planar cross-section beam: energy, force and tangent are those of the spatial element",
          "[element][planar]") {
    const auto transverse = GENERATE(from_range(std::begin(all_measures), std::end(all_measures)));
    for (const char* rule : {"paper", "mixed"}) {
        const auto planar = sample<Planar>(transverse, rule, odd_section());
        const auto spatial = sample<Spatial>(transverse, rule, odd_section());
        for (unsigned seed = 0; seed < 50; ++seed) {
            INFO("rule " << rule << ", seed " << seed);
            test::Random random(seed);
            Planar::Coordinates e;
            e << 0, 0, 1, 0, 0, 1, 0.7, 0, 1, 0, 0, 1;
            for (double& value : e) value += random.uniform(-0.2, 0.2);
            const auto flat = planar.evaluate(e);
            const auto full = spatial.evaluate(lifted(e));
            CHECK(flat.energy == Approx(full.energy).epsilon(1e-13));
            Planar::Coordinates force;
            Matrix<double, 12> tangent;
            for (int i = 0; i < 12; ++i) {
                force[i] = full.force[place[i]];
                for (int j = 0; j < 12; ++j) tangent(i, j) = full.tangent(place[i], place[j]);
            }
            CHECK(test::relative_error(flat.force, force) <= 1e-13);      // measured 8e-16
            CHECK(test::relative_error(flat.tangent, tangent) <= 1e-13);  // measured 7e-16
        }
    }
}

TEST_CASE("planar cross-section beam: results at a place are those of the spatial element",
          "[element][planar][results]") {
    const auto planar = sample<Planar>(TransverseStrain::green, "paper", odd_section());
    const auto spatial = sample<Spatial>(TransverseStrain::green, "paper", odd_section());
    test::Random random(4);
    Planar::Coordinates e;
    e << 0, 0, 1, 0, 0, 1, 0.7, 0, 1, 0, 0, 1;
    for (double& value : e) value += random.uniform(-0.1, 0.1);
    const Spatial::Coordinates full = lifted(e);
    const double xi = 0.3, y = 0.04;

    CHECK((planar.position(e, xi, y) - spatial.position(full, xi, y).head<2>()).norm() <= 1e-14);
    CHECK((planar.directors(e, xi) - spatial.directors(full, xi).col(0).head<2>()).norm() <= 1e-14);
    Matrix<double, 2, 12> jacobian;
    for (int k = 0; k < 12; ++k)
        jacobian.col(k) = spatial.position_jacobian(full, xi, y).col(place[k]).head<2>();
    CHECK(test::relative_error(planar.position_jacobian(e, xi, y), jacobian) <= 1e-13);

    const Vector<double, 6> strain = spatial.green_strain(full, xi, y);
    const Vector<double, 3> flat = planar.green_strain(e, xi, y);
    CHECK(flat[0] == Approx(strain[0]).epsilon(1e-12));
    CHECK(flat[1] == Approx(strain[1]).epsilon(1e-12));
    CHECK(flat[2] == Approx(strain[5]).epsilon(1e-12));
    CHECK((planar.stress(e, xi, y) - Vector<double, 3>(spatial.stress(full, xi, y)[0],
                                                       spatial.stress(full, xi, y)[1],
                                                       spatial.stress(full, xi, y)[5]))
              .norm() <= 1e-6);

    const SectionForces a = planar.section_forces(e, xi), b = spatial.section_forces(full, xi);
    CHECK(a.axial == Approx(b.axial).epsilon(1e-11));
    CHECK(a.shear_y == Approx(b.shear_y).epsilon(1e-11));
    CHECK(a.moment_z == Approx(b.moment_z).epsilon(1e-11));
}

TEST_CASE("planar cross-section beam: states without directors are not admissible",
          "[element][planar][bad-input]") {
    const auto element = sample<Planar>(TransverseStrain::green, "paper", odd_section());
    Planar::Coordinates e;
    e << 0, 0, 1, 0, 0, 1, 0.7, 0, 1, 0, 0, 1;
    CHECK(element.admissible(e));
    Planar::Coordinates broken = e;
    broken.segment<2>(4).setZero();
    CHECK_FALSE(element.admissible(broken));
    broken = e;
    broken.segment<2>(4) << 0.5, 1e-8;  // along the tangent
    CHECK_FALSE(element.admissible(broken));
    broken = e;
    broken.segment<2>(10) << 0.0, -1.0;  // inverted
    CHECK_FALSE(element.admissible(broken));
    broken = e;
    broken[7] = std::nan("");
    CHECK_FALSE(element.admissible(broken));
    CHECK_THROWS_AS(Planar(Material::isotropic(2e7, 0.3, density), odd_section(), 0.0),
                    InvalidArgument);
    CHECK_THROWS_AS(Planar(Material::isotropic(2e7, 0.3, density), odd_section(), 1.0,
                           options(TransverseStrain::green, "gauss2")),
                    InvalidArgument);
}

}  // namespace planar_beam_test
