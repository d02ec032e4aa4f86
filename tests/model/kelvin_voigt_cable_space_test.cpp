// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Kelvin and Voigt's damping of the cable in space: axial strain, changes of |kappa|, spins about
/// its line.

#include <ancf/element/cable/cable.hpp>
#include <ancf/model/loads/damping.hpp>

#include <model/kelvin_voigt_checks.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <complex>

extern template class ancf::KelvinVoigt<ancf::Cable<2>>;
extern template class ancf::KelvinVoigt<ancf::Cable<3>>;

namespace kelvin_voigt_cable_space_test {

using namespace ancf;
using test::kelvin_voigt::damped_element;
using test::kelvin_voigt::damper;

TEMPLATE_TEST_CASE("KelvinVoigt: derivatives equal the complex step of the force",
                   "[model][damping]", Cable<3>) {
    test::kelvin_voigt::check_derivatives<TestType>();
}

TEMPLATE_TEST_CASE("KelvinVoigt: rigid motions of a deformed element meet no force",
                   "[model][damping]", Cable<3>) {
    test::kelvin_voigt::check_rigid_motions<TestType>();
}

TEMPLATE_TEST_CASE("KelvinVoigt: free of stress the force is that of eta K v, however turned",
                   "[model][damping]", Cable<3>) {
    test::kelvin_voigt::check_force_at_rest<TestType>();
}

TEMPLATE_TEST_CASE("KelvinVoigt: a bar being stretched dissipates eta E A l (strain rate)^2",
                   "[model][damping]", Cable<3>) {
    test::kelvin_voigt::check_stretching<TestType>();
}

TEST_CASE("KelvinVoigt: in a plane the cable of space is damped like that of the plane",
          "[model][damping]") {
    test::Random random(65);
    int count = 0;
    for (; count < test::kelvin_voigt::states; ++count) {
        const Vector<double, 8> e = test::random_state(*damped_element<Cable<2>>(), random);
        const Vector<double, 8> v = random.vector<8>();
        const Matrix<double, 3> turn = test::random_rotation<3>(random);
        Vector<double, 12> lifted_e, lifted_v;
        for (int a = 0; a < 4; ++a) {
            lifted_e.segment<3>(3 * a) = turn.leftCols<2>() * e.segment<2>(2 * a);
            lifted_v.segment<3>(3 * a) = turn.leftCols<2>() * v.segment<2>(2 * a);
        }
        const Vector<double, 8> flat = damper<Cable<2>>().force(e, v);
        Vector<double, 12> expected;
        for (int a = 0; a < 4; ++a)
            expected.segment<3>(3 * a) = turn.leftCols<2>() * flat.segment<2>(2 * a);
        // round-off of about 1e-15
        CHECK(test::relative_error(damper<Cable<3>>().force(lifted_e, lifted_v), expected) <=
              1e-12);
    }
    CHECK(count == test::kelvin_voigt::states);
}

/// Returns eta times the integral of EA (eps')^2 + EI (|kappa|')^2 by the rule of a cable.
double defined_power(const Cable<3>& element, const Vector<double, 12>& e,
                     const Vector<double, 12>& v) {
    using Complex = std::complex<double>;
    using test::kelvin_voigt::side, test::kelvin_voigt::span;
    const double bending = std::pow(side, 4) / 12.0, area = side * side;
    double sum = 0.0;
    for (const RuleStation& station : element.options().rule.stations()) {
        const auto first = hermite_first(station.xi, span),
                   second = hermite_second(station.xi, span);
        Vector<Complex, 3> p = Vector<Complex, 3>::Zero(), w = p;
        for (int a = 0; a < 4; ++a) {
            Vector<Complex, 3> part;
            for (int k = 0; k < 3; ++k)
                part[k] = Complex(e[3 * a + k], test::complex_step * v[3 * a + k]);
            p += first[static_cast<std::size_t>(a)] * part;
            w += second[static_cast<std::size_t>(a)] * part;
        }
        const Complex pp = p.cwiseProduct(p).sum(), pw = p.cwiseProduct(w).sum(),
                      ww = w.cwiseProduct(w).sum();
        const Complex kappa = std::sqrt((pp * ww - pw * pw) / (pp * pp * pp));
        const double strain_rate = 0.5 * pp.imag() / test::complex_step;
        const double curvature_rate = kappa.imag() / test::complex_step;
        sum += span *
               (station.weight(StrainGroup::axial) * area * strain_rate * strain_rate +
                station.weight(StrainGroup::bending) * bending * curvature_rate * curvature_rate);
    }
    return test::kelvin_voigt::eta * test::kelvin_voigt::young * sum;
}

TEST_CASE("KelvinVoigt: a curved cable of space dissipates by the rates of |kappa| and its strain",
          "[model][damping]") {
    const auto element = damped_element<Cable<3>>();
    test::Random random(66);
    double worst = 0.0;
    for (int k = 0; k < test::kelvin_voigt::states; ++k) {
        const Vector<double, 12> e = test::random_state(*element, random);
        const Vector<double, 12> v = random.vector<12>();
        const double power = -damper<Cable<3>>().force(e, v).dot(v);
        worst = std::max(worst, std::abs(power / defined_power(*element, e, v) - 1.0));
    }
    INFO("worst " << worst);
    CHECK(worst <= 1e-11);  // what the small resistance to spin adds; measured 1.3e-14
}

TEST_CASE("KelvinVoigt: the force on a cable of space turns with it and ignores a common motion",
          "[model][damping]") {
    using test::moved;
    const auto element = damped_element<Cable<3>>();
    const auto damping = damper<Cable<3>>();
    test::Random random(67);
    double turned = 0.0, carried = 0.0;
    for (int k = 0; k < test::kelvin_voigt::states; ++k) {
        const Vector<double, 12> e = test::random_state(*element, random);
        const Vector<double, 12> v = random.vector<12>();
        const Vector<double, 12> force = damping.force(e, v);
        const Matrix<double, 3> turn = test::random_rotation<3>(random);
        const Vector<double, 3> none = Vector<double, 3>::Zero();
        const Vector<double, 12> expected = moved<Cable<3>>(force, turn, none);
        turned = std::max(
            turned, test::relative_error(damping.force(moved<Cable<3>>(e, turn, random.vector<3>()),
                                                       moved<Cable<3>>(v, turn, none)),
                                         expected));
        const Vector<double, 12> common = test::kelvin_voigt::rigid_rates<Cable<3>>(e, random);
        carried = std::max(
            carried, test::relative_error(damping.force(e, Vector<double, 12>(v + common)), force));
    }
    INFO("turned " << turned << ", carried " << carried);
    CHECK(turned <= 1e-12);   // round-off; measured 3e-15
    CHECK(carried <= 1e-12);  // measured 9e-16
}

TEST_CASE("KelvinVoigt: a nearly straight cable that spins about itself meets next to no force",
          "[model][damping]") {
    const auto element = damped_element<Cable<3>>();
    const double span = test::kelvin_voigt::span, side = test::kelvin_voigt::side;
    const Vector<double, 3> axis(1.0, 0.0, 0.0);
    for (const double bow : {0.0, 1e-9, 1e-7, 1e-5, 1e-3}) {
        Vector<double, 12> e = test::reference_coordinates(*element), v;
        e[5] = bow;
        e[11] = -bow;
        for (int a = 0; a < 4; ++a)
            v.segment<3>(3 * a) = cross(axis, Vector<double, 3>(e.segment<3>(3 * a)));
        const double moment = test::kelvin_voigt::eta * test::kelvin_voigt::young *
                              std::pow(side, 4) / 12.0 / span;  // of a change of angle of 1/s
        CHECK(damper<Cable<3>>().force(e, v).norm() <= 2e-7 * moment);  // measured 6e-8
    }
}

}  // namespace kelvin_voigt_cable_space_test
