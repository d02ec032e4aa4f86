// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Pendulums so stiff that a step turns them by far more than it strains them.

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_solver.hpp>

#include <support/catch.hpp>

#include <cmath>
#include <type_traits>

namespace stiff_pendulum_test {

using namespace ancf;

/// The paper's rubber pendulum, 1.2 m, of a material a hundred thousand times as stiff.
template <class Element>
struct Pendulum {
    static constexpr int dimension = Element::dimension;
    using Point = Vector<double, dimension>;

    BasicModel<dimension> model;
    Beam<Element> beam;

    explicit Pendulum(double link)
        : beam(straight_beam<Element>(model, Material::from_moduli(0.7e11, 2.6923e10, 5540.0),
                                      rectangle(0.05, 0.05), Point(Point::Zero()),
                                      Point(1.2 * Point::UnitX()), 4)) {
        if (link > 0.0)
            model.add(Distance<dimension>(beam.first(), Point(link * Point::Unit(1)), link));
        else
            model.pin(beam.first());
        model.set_gravity(Point(-9.81 * Point::Unit(1)));
    }

    [[nodiscard]] Point tip() const { return model.value(beam.last(), Field::r); }
};

/// Swings for half a second, by steps of a millisecond unless told otherwise.
template <class Scene>
DynamicsReport swing(Scene& model, double step = 1e-3) {
    DynamicProblem problem(model);
    EigenLu solver;
    Schedule schedule;
    schedule.end = 0.5;
    EnergyMomentumOptions options;
    options.step = step;
    return EnergyMomentum(options).integrate(problem, solver, schedule);
}

TEMPLATE_TEST_CASE("a stiff pendulum swings in whole steps, by one matrix a step", "[dynamics]",
                   CrossSectionBeam<3>, CrossSectionBeam<2>, Cable<3>) {
    for (const double link : {0.0, 0.4}) {
        CAPTURE(link);
        Pendulum<TestType> pendulum(link);
        const DynamicsReport report = swing(pendulum.model);
        REQUIRE(report.status == Status::converged);
        CHECK(report.convergence_failures == 0);
        CHECK(report.steps == 500);
        // the body turns, so that the matrix of a step is of little use in the next
        CHECK(report.factorisations <= 600);
        CHECK(report.iterations <= 8 * report.steps);  // 6.5 measured
        CHECK(report.energy_drift <= 1e-11 * report.kinetic_largest);
    }
}

TEST_CASE("a stiff pendulum's tip is where short steps of another method have it", "[dynamics]") {
    Pendulum<CrossSectionBeam<2>> exact(0.0), coarse(0.0);
    DynamicProblem problem(exact.model);
    EigenLu solver;
    Schedule schedule;
    schedule.end = 0.5;
    GeneralizedAlphaOptions options;
    options.step = 2e-5;
    options.rho = 1.0;
    REQUIRE(GeneralizedAlpha(options).integrate(problem, solver, schedule).status ==
            Status::converged);
    REQUIRE(swing(coarse.model).status == Status::converged);
    CHECK((coarse.tip() - exact.tip()).norm() <= 1e-4);
}

TEST_CASE("adaptive Radau IIA keeps the energy of a bar that is hardly strained by its spin",
          "[dynamics]") {
    // A hundred times as stiff as steel, 40 rad: Newton's method bounds the steps, not the
    // tolerance.
    constexpr double spin = 10.0;
    PlanarModel model;
    CrossSectionOptions mixed;
    mixed.rule = Rule::mixed();
    const auto bar =
        straight_beam<CrossSectionBeam<2>>(model, Material::from_moduli(2.1e13, 8.1e12, 7850.0),
                                           rectangle(0.02, 0.02), {0, 0}, {1, 0}, 4, mixed);
    model.pin(bar.first());
    for (const NodeId node : bar.nodes)
        for (const Field field : {Field::r, Field::r_x, Field::r_y}) {
            const Vector<double, 2> at = model.value(node, field);
            model.set_rate(node, field, Vector<double, 2>(-spin * at[1], spin * at[0]));
        }
    DynamicProblem problem(model);
    EigenLu solver;
    Schedule schedule;
    schedule.end = 4.0;
    RadauOptions options;
    options.stages = GENERATE(3, 5);
    options.tolerance = GENERATE(1e-2, 1e-3, 1e-4);
    const auto report = RadauIIA(options).integrate(problem, solver, schedule);
    CAPTURE(options.stages, options.tolerance, report.steps);
    REQUIRE(report.status == Status::converged);
    // Of eight rates of spin about this one 0.020 to 0.073, 3.4e-3 to 5.5e-3, 1.9e-3 to 4.7e-3
    // measured, and of five stages 1.2e-3, 3.2e-4 and 3.2e-4 at most. Where Newton's method may
    // leave its share of the tolerance in every step: 1.5, 0.87, 0.11 and 1.1, 0.40, 0.033.
    const double most = options.stages == 5 ? 0.01 : options.tolerance == 1e-2 ? 0.2 : 0.02;
    CHECK(report.energy_drift <= most * report.kinetic_largest);
    CHECK(report.steps <= 8000);  // 3800 to 4500 measured; 67 746 and 470 954 at the tolerance 1e-2
}

TEST_CASE("energy-momentum turns no section inside out where short steps do not", "[dynamics]") {
    using Bar =
        ancf::CrossSectionBeam<2, ancf::Projected, ancf::LinearShear, ancf::EngineeringMeasure>;
    CrossSectionOptions options;
    options.rule = Rule::mixed();
    for (const double along : {-300.0, -350.0}) {
        for (const int parts : {1, 200}) {
            CAPTURE(along, parts);
            PlanarModel model;
            const auto bar =
                straight_beam<Bar>(model, Material::from_moduli(0.7e6, 2.6923e5, 5540.0),
                                   rectangle(0.05, 0.05), {0, 0}, {0.15, 0}, 1, options);
            model.pin(bar.first());
            model.set_rate(bar.last(), Field::r_x, Vector<double, 2>(along, 0.0));
            DynamicProblem problem(model);
            EigenLu solver;
            Schedule schedule;
            schedule.end = 0.01;
            EnergyMomentumOptions steps;
            steps.step = schedule.end / parts;
            const auto report = EnergyMomentum(steps).integrate(problem, solver, schedule);
            REQUIRE(report.status == Status::converged);
            CHECK(report.energy_drift <= 1e-11 * report.kinetic_largest);
            const Vector<double, 2> x = model.value(bar.last(), Field::r_x);
            const Vector<double, 2> y = model.value(bar.last(), Field::r_y);
            CHECK(x[0] * y[1] - x[1] * y[0] > 0.5);
        }
    }
}

}  // namespace stiff_pendulum_test
