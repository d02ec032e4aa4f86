// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Chains of cables against closed forms and the elastica.

#include <ancf/element/cable/cable.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>

#include <element/cable_scenes.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cable_statics_test {

using namespace ancf;
using test::cantilever;
using test::order;
using test::pi;
using test::SlenderCable;
using Plane = Vector<double, 2>;
using Space = Vector<double, 3>;

/// Brings a scene to equilibrium, in equal load steps.
void settle(Scene& model, int steps = 1) {
    EigenLu solver;
    StaticsOptions options;
    options.steps = steps;
    const StaticsReport report = solve_statics(model, solver, options);
    REQUIRE(report.status == Status::converged);
}

/// The tip of a cantilever under a dead tip load along Y.
template <class Element>
typename BasicModel<Element::dimension>::Point loaded_tip(const SlenderCable& cable, int elements,
                                                          double load,
                                                          const CableOptions& options = {},
                                                          int steps = 1) {
    using Point = typename BasicModel<Element::dimension>::Point;
    BasicModel<Element::dimension> model;
    const auto beam = cantilever<Element>(model, cable, elements, options);
    model.add(Force<Element::dimension>(beam.last(), Point(load * Point::Unit(1))));
    settle(model, steps);
    return model.position(beam.last());
}

/// Uniform bending by the moment M: n = E A eps meets the bending term in N = n lam - M kappa = 0,
/// M = E I kappa/lam.
Plane bent_tip(const SlenderCable& cable, double moment) {
    const double stretch =
        std::sqrt(1.0 + 2.0 * moment * moment / cable.axial_stiffness());  // Green's strain
    const double curvature = moment * stretch, angle = curvature * stretch;
    return {std::sin(angle) / curvature, (1.0 - std::cos(angle)) / curvature};
}

template <class Element, class Load>
typename BasicModel<Element::dimension>::Point bent(const SlenderCable& cable, int elements,
                                                    const Load& load, int steps) {
    BasicModel<Element::dimension> model;
    const auto beam = cantilever<Element>(model, cable, elements);
    model.add(load(beam.last()));
    settle(model, steps);
    return model.position(beam.last());
}

TEMPLATE_TEST_CASE("Cable: a small tip load deflects by P L^3/(3 E I), with one element",
                   "[element][cable][statics]", Cable<2>, Cable<3>, (Cable<2, EngineeringAxial>)) {
    const double load = 1e-6;
    const auto tip = loaded_tip<TestType>({1e-2}, GENERATE(1, 3), load);
    CHECK(tip[1] ==
          Approx(load / 3.0).epsilon(1e-10));  // a cubic; nonlinear terms are load^2 of it
    CHECK(tip[0] == Approx(1.0).epsilon(1e-11));
}

TEST_CASE("Cable: converges to the elastica with fourth order",
          "[element][cable][statics][elastica]") {
    struct Case {
        double load;
        Plane tip;
        double error;  // with 16 elements, measured times two
    };
    const Case all[] = {{1.0, {0.943566763717, 0.301720773800}, 4e-6},
                        {2.0, {0.839358279175, 0.493457480397}, 2e-5},
                        {5.0, {0.612371639276, 0.713791523612}, 1e-4},
                        {10.0, {0.445004402246, 0.810609024880}, 4e-4}};
    const auto& [load, tip, bound] = all[GENERATE(range(0, 4))];
    INFO("P L^2/E I = " << load);
    const SlenderCable cable{1e-4};
    const auto error = [&, load = load, tip = tip](int elements) {
        return (loaded_tip<Cable<2, EngineeringAxial>>(cable, elements, load, {}, 4) - tip).norm();
    };
    const double coarse = error(16), fine = error(32);
    CHECK(coarse <= bound);
    CHECK(order(coarse, fine) >= 3.8);
    CHECK(fine > 1e-9);  // above what strain and digits of the reference leave
}

TEST_CASE("Cable: of the rules, the default has the least error and locks at no slenderness",
          "[element][cable][statics][elastica]") {
    const Plane tip(0.943566763717, 0.301720773800);
    const SlenderCable cable{GENERATE(1e-3, 1e-4)};
    const auto error = [&](const Rule& rule) {
        return (loaded_tip<Cable<2>>(cable, 8, 1.0, {rule, 1.0}, 2) - tip).norm();
    };
    const double own = error(cable_rule());
    CHECK(own <= 2e-5);
    CHECK(error(Rule::mixed()) >= 2.0 * own);
    CHECK(error(Rule::gauss(3)) >= 10.0 * own);
    CHECK(error(Rule::gauss(5)) >= 10.0 * own);
}

TEST_CASE("Cable: one element's shorter rest length tightens the whole chain",
          "[element][cable][statics]") {
    // n = E A (lam^2 - 1)/2 lam is the same in all elements, so lam is too: span over rest lengths
    const auto material = Material::from_moduli(1e6, 4e5, 1000.0);
    const auto section = rectangle(0.1, 0.1);
    constexpr double rest = 0.5, shorter = 0.44, span = 4.0 * rest;
    PlanarModel model;
    const auto beam =
        straight_beam<Cable<2>>(model, material, section, Plane(0, 0), Plane(span, 0), 4);
    model.pin(beam.first());
    model.pin(beam.last());
    model.prototype<Cable<2>>(model.make_own_prototype<Cable<2>>(beam.elements[1])) = {
        material, section, shorter};
    settle(model);
    const double stretch = span / (3.0 * rest + shorter);
    // at first neither loads nor reactions are there to measure the residual by
    CHECK(model.position(beam.node(1))[0] == Approx(stretch * rest).epsilon(1e-11));
    CHECK(model.position(beam.node(2))[0] == Approx(stretch * (rest + shorter)).epsilon(1e-11));
    const double tension = 1e6 * 0.01 * 0.5 * (stretch * stretch - 1.0);  // E A eps
    for (int k = 0; k < 4; ++k) {
        CHECK(model.value(beam.node(k), Field::r_x)[0] == Approx(stretch).epsilon(1e-11));
        const auto& element = model.group<Cable<2>>().element(k);
        CHECK(element.section_forces(model.element_coordinates<Cable<2>>(k), 0.5).axial ==
              Approx(stretch * tension).epsilon(1e-10));
    }
}

TEST_CASE("Cable: space turns the plane's solution", "[element][cable][statics]") {
    const SlenderCable cable{1e-2};
    const auto flat = loaded_tip<Cable<2>>(cable, 6, 3.0);
    const auto solid = loaded_tip<Cable<3>>(cable, 6, 3.0);
    CHECK((solid - Space(flat[0], flat[1], 0.0)).norm() <= 1e-9);
}

TEST_CASE("Cable: an end moment bends a cantilever to a semicircle",
          "[element][cable][statics][moment]") {
    const SlenderCable cable{0.035};
    const auto planar = [&](int elements) {
        return bent<Cable<2>>(
            cable, elements, [](NodeId tip) { return PlanarSlopeMoment(tip, Field::r_x, pi); }, 4);
    };
    const Plane exact = bent_tip(cable, pi);
    const double coarse = (planar(8) - exact).norm(), fine = (planar(16) - exact).norm();
    CHECK(fine <= 5e-5);  // measured 2.2e-5
    CHECK(order(coarse, fine) >= 3.7);

    // in space, the moment vector on the tangent and the moment on the slope are the same load
    const auto vector = [&](NodeId tip) { return TangentMoment(tip, {0.0, 0.0, pi}); };
    const auto slope = [&](NodeId tip) { return SlopeMoment(tip, Field::r_x, Space::UnitZ(), pi); };
    const Plane flat = planar(8);
    CHECK((bent<Cable<3>>(cable, 8, vector, 4) - Space(flat[0], flat[1], 0.0)).norm() <= 1e-9);
    CHECK((bent<Cable<3>>(cable, 8, slope, 4) - Space(flat[0], flat[1], 0.0)).norm() <= 1e-9);
    // about another axis it bends to another plane
    const auto upward = [&](NodeId tip) { return TangentMoment(tip, {0.0, -0.6 * pi, 0.8 * pi}); };
    CHECK((bent<Cable<3>>(cable, 8, upward, 4) - Space(flat[0], 0.8 * flat[1], 0.6 * flat[1]))
              .norm() <= 1e-9);
}

TEST_CASE("Cable: a line load on a curved chain is its weight",
          "[element][cable][statics][curved]") {
    const SlenderCable cable{1e-2};
    const auto tip = [&](bool as_gravity) {
        PlanarModel model;
        const auto beam = test::curved_cantilever<Cable<2>>(model, cable, 1.0, 3);
        const double line_density = 1e-4;  // density 1 on the section of height 1e-2
        const Plane g(0.3, -2.0);
        if (as_gravity)
            model.set_gravity(g / line_density);
        else
            add_line_load(model, beam, g);
        settle(model, 2);
        return Plane(model.position(beam.last()));
    };
    CHECK((tip(true) - tip(false)).norm() <= 1e-10);
    CHECK((tip(true) - Plane(std::sin(1.0), 1.0 - std::cos(1.0))).norm() > 0.01);
}

TEST_CASE("Cable: section forces balance the tip load", "[element][cable][statics][results]") {
    const SlenderCable cable{1e-2};
    PlanarModel model;
    const int elements = 32;
    const auto beam = cantilever<Cable<2>>(model, cable, elements);
    const Plane load(0.5, 2.0);
    model.add(Force<2>(beam.last(), load));
    settle(model);
    const Plane tip = model.position(beam.last());
    for (const int place : {0, 10, 31}) {
        const auto& element = model.group<Cable<2>>().element(place);
        const auto e =
            model.element_coordinates<Cable<2>>(beam.elements[static_cast<std::size_t>(place)]);
        const double xi = 0.5;
        const Plane arm = tip - element.position(e, xi), t = element.tangent(e, xi);
        const SectionForces forces = element.section_forces(e, xi);
        CHECK(forces.moment_z ==
              Approx(arm[0] * load[1] - arm[1] * load[0]).epsilon(5e-3).margin(1e-4));
        // membrane forces of slender elements oscillate; the middle of an element shows them well
        CHECK(forces.axial == Approx(load.dot(t)).epsilon(0.02));
    }
}

TEST_CASE("Cable: a curved cantilever deflects as the curved bar of closed form, with fourth order",
          "[element][cable][statics][curved]") {
    // a quarter of a circle, clamped at its start; at the tip a small load along the tip's normal:
    // pi P R^3/(4 E I) along the load, P R^3/(2 E I) along the tangent
    const double radius = 2.0 / pi, load = 1e-5;
    const SlenderCable cable{1e-3};
    const auto error = [&](int elements) {
        PlanarModel model;
        const auto beam = test::curved_cantilever<Cable<2>>(model, cable, pi / 2.0, elements);
        const Plane start = model.position(beam.last());
        CHECK((start - Plane(radius, radius)).norm() <= 1e-14);
        model.add(Force<2>(beam.last(), Plane(-load, 0.0)));  // the normal there points to -X
        settle(model);
        const Plane moved =
            (model.position(beam.last()) - start) / (load * radius * radius * radius);
        CHECK(std::abs(moved[0]) > 0.1);
        return (moved - Plane(-pi / 4.0, 0.5)).norm();
    };
    const double coarse = error(2), middle = error(4), fine = error(8);
    CHECK(fine <= 1e-4);  // measured 3.3e-5
    CHECK(order(coarse, middle) >= 3.8);
    CHECK(order(middle, fine) >= 3.8);
}

TEST_CASE("Cable: an end moment takes as few iterations on any mesh",
          "[element][cable][statics][moment]") {
    const SlenderCable cable{0.2};
    for (const int elements : {4, 32, 256}) {
        CAPTURE(elements);
        const auto iterations = [&](auto model, const auto& load) {
            using Element = Cable<decltype(model)::dimension>;
            const auto beam = cantilever<Element>(model, cable, elements);
            model.add(load(beam.last()));
            EigenLu solver;
            const auto report = solve_statics(model, solver);
            CHECK(report.status == Status::converged);
            return report.iterations();
        };
        const auto on_slope = [](NodeId tip) { return PlanarSlopeMoment(tip, Field::r_x, 3.0); };
        const auto on_tangent = [](NodeId tip) { return TangentMoment(tip, {0.0, 1.8, 2.4}); };
        CHECK(iterations(PlanarModel(), on_slope) <= 6);  // 5; without the tangent of a turn to 196
        CHECK(iterations(Model(), on_tangent) <= 6);      // 5; likewise to 85
    }
}

TEST_CASE("Cable: the moment of its natural curvature straightens a curved cantilever",
          "[element][cable][statics][curved]") {
    const double curvature = pi / 2.0;
    const SlenderCable cable{1e-2};
    const auto error = [&](int elements) {
        PlanarModel model;
        const auto beam = test::curved_cantilever<Cable<2>>(model, cable, curvature, elements);
        model.add(PlanarSlopeMoment(beam.last(), Field::r_x, -curvature));
        settle(model, 4);
        return (model.position(beam.last()) - Plane(1.0, 0.0)).norm();
    };
    const double coarse = error(4), fine = error(8);
    CHECK(fine <= 2e-6);  // measured 6.6e-7
    CHECK(order(coarse, fine) >= 3.8);
}

TEST_CASE("Cable: a wire that is pushed together sags and folds in no element",
          "[element][cable][statics]") {
    // by the stations alone 0.04 m would fold away in the last element
    PlanarModel model;
    const auto beam = straight_beam<Cable<2>>(model, Material::isotropic(2e11, 0.3, 7850.0),
                                              circle(1e-3), {0, 0}, {1, 0}, 8);
    model.pin(beam.first());
    model.fix(beam.last(), Field::r, 1);
    model.set_gravity({0, -9.81}, [](double factor) { return std::min(1.0, 2.0 * factor); });
    model.prescribe(beam.last(), Field::r, 0,
                    [](double factor) { return 1.0 - 0.3 * std::max(0.0, 2.0 * factor - 1.0); });
    settle(model, 4);
    const Plane middle = model.position(beam.node(4)), quarter = model.position(beam.node(2)),
                other = model.position(beam.node(6));
    CHECK(middle[0] == Approx(0.35).epsilon(1e-8));
    CHECK(middle[1] < -0.3);
    CHECK(std::abs(quarter[1] - other[1]) <= 1e-8);
}

TEST_CASE("Cable: in compression a rope gives by the ratio of its stiffnesses",
          "[element][cable][statics][rope]") {
    const double ratio = GENERATE(0.1, 1e-4);
    const SlenderCable cable{1e-2};
    for (const double strain : {1e-4, -1e-4}) {
        PlanarModel model;
        const auto beam =
            cantilever<Cable<2, EngineeringAxial>>(model, cable, 4, {cable_rule(), ratio});
        const double stiffness = cable.axial_stiffness() * (strain > 0.0 ? 1.0 : ratio);
        model.add(Force<2>(beam.last(), Plane(stiffness * strain, 0.0)));
        settle(model);
        CHECK(model.position(beam.last())[0] - 1.0 == Approx(strain).epsilon(1e-9));
    }
}

TEST_CASE("Cable: a rope that only pulls hangs under its weight, far from the origin too",
          "[element][cable][statics][rope]") {
    const double far = GENERATE(0.0, 1e3, 1e5);
    const int held = GENERATE(1, 2);
    const Space from(0.4 * far, -0.7 * far, 0.6 * far);
    const Space to = from + (held == 1 ? Space(0, 0, -3) : Space(1, 2, -2));
    const auto nylon = Material::isotropic(1e9, 0.3, 1500.0);
    const auto section = circle(0.002);
    Model model;
    const auto rope = straight_beam<Cable<3>>(model, nylon, section, from, to, 8,
                                              CableOptions{cable_rule(), 0.0});
    model.pin(rope.first());
    if (held == 2) model.pin(rope.last());
    model.set_gravity({0, 0, -9.81});
    EigenLu solver;
    const auto report = solve_statics(model, solver);
    REQUIRE(report.status == Status::converged);
    CHECK(report.stability == Stability::stable);
    double borne = 0.0;
    for (const int node : {0, 8})
        borne += report.reactions[model.coordinate(rope.node(node), Field::r) + 2];
    CHECK(borne == Approx(9.81 * 1500.0 * section.moments().area * 3.0).epsilon(1e-6));
}

TEST_CASE("Cable: Newton's method finds which part of a rope is slack",
          "[element][cable][statics][rope]") {
    const double ratio = GENERATE(1.0, 0.1, 1e-4);
    const SlenderCable cable{1e-2};
    const auto stretch_of = [&](int elements, int& iterations) {
        PlanarModel model;
        const auto beam = straight_beam<Cable<2, EngineeringAxial>>(
            model, cable.material(), cable.section(), Plane(0.0, 0.0), Plane(1.0, 0.0), elements,
            CableOptions{cable_rule(), ratio});
        model.pin(beam.first());
        model.pin(beam.last());
        const double load = 1e-4 * cable.axial_stiffness();
        model.add(Force<2>(beam.node(elements / 2), Plane(load, 0.0)));
        EigenLu solver;
        const StaticsReport report = solve_statics(model, solver);
        REQUIRE(report.status == Status::converged);
        iterations = report.iterations();
        return (model.position(beam.node(elements / 2))[0] - 0.5) / 1e-4;
    };
    const double expected = 0.5 / (1.0 + ratio);
    int coarse_iterations = 0, fine_iterations = 0;
    const double coarse = stretch_of(8, coarse_iterations), fine = stretch_of(32, fine_iterations);
    // the slope is continuous, the strain is not: an error of the size of an element beside the
    // load
    CHECK(std::abs(fine - expected) <= 0.015 * expected);
    CHECK(std::abs(coarse - expected) >= 3.0 * std::abs(fine - expected));
    CHECK(coarse_iterations <= 6);  // measured 3
    CHECK(fine_iterations <= 6);
}

}  // namespace cable_statics_test
