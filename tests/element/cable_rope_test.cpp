// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Cables that are softer in compression than in tension, down to ropes that only pull.

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <element/cable_samples.hpp>
#include <element/property_checks.hpp>
#include <support/catch.hpp>
#include <support/complex_step.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>

namespace cable_rope_test {

using namespace ancf;
using test::straight_cable;

TEMPLATE_TEST_CASE("Cable: a rope that only pulls has no axial energy in compression",
                   "[element][cable][rope]", Cable<2>, Cable<3>, (Cable<2, EngineeringAxial>),
                   (Cable<3, EngineeringAxial>)) {
    const auto rope = straight_cable<TestType>({cable_rule(), 0.0});
    const auto soft = straight_cable<TestType>({cable_rule(), 0.25});
    const auto bar = straight_cable<TestType>();
    const auto stretched = [&](double stretch) {
        return typename TestType::Coordinates(stretch * test::reference_coordinates(bar));
    };
    for (const double stretch : {1.0, 1.001, 1.3}) {
        const auto e = stretched(stretch);
        CHECK(rope.energy(e) == bar.energy(e));
        CHECK(rope.evaluate(e).tangent == bar.evaluate(e).tangent);
    }
    for (const double stretch : {0.9901, 0.999}) {
        const auto e = stretched(stretch);
        REQUIRE(bar.energy(e) > 0.0);
        CHECK(rope.energy(e) <= 1e-28 * bar.energy(e));  // what round-off bends
        CHECK(rope.force(e).norm() <= 1e-14 * bar.force(e).norm());
        CHECK(soft.energy(e) == Approx(0.25 * bar.energy(e)).epsilon(1e-14));
        CHECK(test::relative_error(soft.force(e), (0.25 * bar.force(e)).eval()) <= 1e-14);
    }
    // no jump of the force where the law changes
    const double step = 1e-9;
    const double jump =
        (rope.force(stretched(1.0 + step)) - rope.force(stretched(1.0 - step))).norm();
    CHECK(jump <= 2.0 * step * bar.evaluate(stretched(1.0)).tangent.norm() * stretched(1.0).norm());
    // at rest, in any orientation, the tangent is the taut one: round-off is no compression
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        test::Random random(seed);
        const auto e = test::rigid_state(bar, random, 1.0);
        CHECK(test::relative_error(rope.evaluate(e).tangent, bar.evaluate(e).tangent) <= 1e-12);
    }
}

/// Response of a rope of EA = 1 to a strain.
template <class Scalar>
detail::AxialResponse<Scalar> response(const Scalar& strain, double compression) {
    return detail::axial_response(Scalar(1.0), 1.0 - compression, strain);
}

TEST_CASE("Cable: a rope that is thrown together gets its stiffness back",
          "[element][cable][rope]") {
    using Complex = std::complex<double>;
    const double compression = GENERATE(0.0, 1e-4, 0.3);
    int count = 0;
    for (double strain = -0.5; strain <= 0.1; strain += 0.00073, ++count) {
        const auto at = response(strain, compression);
        const auto stepped = response(Complex(strain, test::complex_step), compression);
        // round-off of sums of cubes; measured 1e-16
        CHECK(std::abs(stepped.energy.imag() / test::complex_step - at.force) <= 1e-14);
        CHECK(std::abs(stepped.force.imag() / test::complex_step - at.stiffness) <= 1e-14);
        CHECK(at.stiffness >= compression - 1e-15);
        CHECK(at.stiffness <= 1.0 + 1e-14);
        if (strain < -0.05) CHECK(at.stiffness == Approx(1.0).epsilon(1e-14));
    }
    CHECK(count > 800);
    for (const double joint : {-0.01, -0.05}) {  // continuous to the second derivative
        const auto below = response(joint - 1e-10, compression),
                   above = response(joint + 1e-10, compression);
        CHECK(std::abs(above.energy - below.energy) <= 1e-9);
        CHECK(std::abs(above.force - below.force) <= 1e-9);
        CHECK(std::abs(above.stiffness - below.stiffness) <= 1e-8);
    }
    CHECK(response(-0.05, 0.0).force == Approx(-0.02).epsilon(1e-12));
}

TEMPLATE_TEST_CASE("Cable: a rope reports the force of its law", "[element][cable][rope]", Cable<2>,
                   Cable<3>, (Cable<2, EngineeringAxial>), (Cable<3, EngineeringAxial>)) {
    const auto rope = straight_cable<TestType>({cable_rule(), 0.0});
    const double young = test::cable_material().young;
    const double area = test::cable_section().moments().area;
    for (const double stretch : {0.8, 0.97, 0.995, 1.01}) {
        const typename TestType::Coordinates e = stretch * test::reference_coordinates(rope);
        const double force = response(rope.axial_strain(e, 0.3), 0.0).force;
        CHECK(rope.stress(e, 0.3)[0] == Approx(young * force).epsilon(1e-13).margin(1e-10));
        // the force of the end node is the tension: of Green's strain N times the stretch
        const double tension = rope.force(e)[2 * TestType::dimension];
        CHECK(rope.section_forces(e, 0.3).axial ==
              Approx(tension).epsilon(1e-12).margin(1e-13 * young * area));
    }
}

TEMPLATE_TEST_CASE("Cable: derivatives hold across taut and slack stations",
                   "[element][cable][rope]", Cable<2>, Cable<3>, (Cable<2, EngineeringAxial>),
                   (Cable<3, EngineeringAxial>)) {
    test::check_derivatives(straight_cable<TestType>({Rule::gauss(5), 0.0}));
}

/// A mass of 1 kg at the end of a rope that only pulls, 1 m long and a little off the vertical.
struct Throw {
    static constexpr int elements = 4;
    Model model;
    Beam<Cable<3>> rope;

    explicit Throw(double speed) {
        const double slant = 0.05;
        rope = straight_beam<Cable<3>>(model, Material::isotropic(1e9, 0.3, 1000.0), circle(0.005),
                                       Vector<double, 3>(0.0, 0.0, 0.0),
                                       Vector<double, 3>(std::sin(slant), 0.0, -std::cos(slant)),
                                       elements, CableOptions{cable_rule(), 0.0});
        model.pin(rope.first());
        model.add_mass(rope.last(), 1.0);
        model.set_gravity({0.0, 0.0, -9.81});
        model.set_rate(rope.last(), Field::r, {0.0, 0.0, speed});
    }
};

/// What is seen of a thrown mass.
struct Flight {
    DynamicsReport report;
    double gain = 0.0;      ///< most energy above that at the start, J
    double least = 0.0;     ///< strain at the elements' ends and middles
    double greatest = 0.0;  ///< likewise
};

/// Lets the mass fly for 1.5 s.
template <class Integrator>
Flight fly(double speed, const Integrator& integrator) {
    Throw scene(speed);
    DynamicProblem problem(scene.model);
    Flight flight;
    double start = 0.0;
    Schedule schedule = equal_intervals(0.0, 1.5, 0.001);
    schedule.observe = [&](const Snapshot& at) {
        if (at.state.time == 0.0) start = at.energies.total();
        flight.gain = std::max(flight.gain, at.energies.total() - start);
        const auto vector = [&](int node, Field field) -> Vector<double, 3> {
            return at.state.q.segment<3>(
                scene.model.layout().index({scene.rope.node(node), field}));
        };
        for (int k = 0; k < Throw::elements; ++k) {
            Vector<double, 12> e;
            e << vector(k, Field::r), vector(k, Field::r_x), vector(k + 1, Field::r),
                vector(k + 1, Field::r_x);
            const auto& element = scene.model.group<Cable<3>>().element(k);
            for (const double xi : {0.0, 0.5, 1.0}) {
                const double strain = element.axial_strain(e, xi);
                flight.least = std::min(flight.least, strain);
                flight.greatest = std::max(flight.greatest, strain);
            }
        }
    };
    EigenLu solver;
    flight.report = integrator.integrate(problem, solver, schedule);
    return flight;
}

TEST_CASE("Cable: a mass thrown up on a rope that only pulls comes down on it",
          "[element][cable][rope]") {
    const double speed = GENERATE(3.0, 0.5);
    GeneralizedAlphaOptions damped;
    damped.rho = 0.5;  // the rope's fastest vibrations are not resolved
    damped.step = 1e-4;
    EnergyMomentumOptions exact;
    exact.step = 2e-4;
    const Flight first = fly(speed, GeneralizedAlpha(damped));
    const Flight second = fly(speed, EnergyMomentum(exact));
    for (const Flight& flight : {first, second}) {
        INFO(speed << " m/s: " << flight.report.message << ", gain " << flight.gain << " J, drift "
                   << flight.report.energy_drift << " J, strains " << flight.least << " to "
                   << flight.greatest);
        CHECK(flight.report.status == Status::converged);
        CHECK(flight.least < -0.01);    // it was slack
        CHECK(flight.greatest > 1e-4);  // and taut: the weight alone stretches it by 1.25e-4
        CHECK(flight.least > -0.1);     // the line kept its length; measured -0.06
    }
    CHECK(first.gain <= 1e-2 * 0.5 * speed * speed);
    CHECK(second.report.energy_drift <= 1e-10);  // measured 2e-12 J of 4.5 J
}

}  // namespace cable_rope_test
