// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Beams whose axis does not run through the centroids of their sections.

#include <ancf/constants.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/modal.hpp>
#include <ancf/solver/statics.hpp>

#include <element/property_checks.hpp>
#include <support/catch.hpp>

#include <algorithm>
#include <cmath>

namespace off_axis_test {

using namespace ancf;
using Paper = CrossSectionBeam<3>;
using Carried = CrossSectionBeam<3, Geodesic>;
using Engineering = CrossSectionBeam<3, Geodesic, LinearShear, EngineeringMeasure>;
using Planar = CrossSectionBeam<2>;

/// Returns an element of length 1 whose ends are turned by an angle, one back and one forth, and
/// brought closer.
template <class Element>
typename Element::Coordinates arch(double angle, double chord, double stretch) {
    constexpr int d = Element::dimension;
    typename Element::Coordinates e;
    test::for_each_vector<Element>([&](int node, Field field, int at) {
        const double turn = node == 0 ? -angle : angle, c = std::cos(turn), s = std::sin(turn);
        Vector<double, 3> v(0.0, 0.0, 1.0);
        if (field == Field::r) v = {node * chord, 0.0, 0.0};
        if (field == Field::r_x) v = {stretch * c, stretch * s, 0.0};
        if (field == Field::r_y) v = {-s, c, 0.0};
        e.template segment<d>(at) = v.template head<d>();
    });
    return e;
}

TEMPLATE_TEST_CASE("off the axis: no state has negative energy", "[element]", Paper, Carried,
                   Engineering, Planar) {
    // with eps^2 at three points and its product with curvature at two the least is -0.37 J of 35 J
    const auto rubber = Material::isotropic(0.7e6, 0.3, 5540.0);
    int states = 0;
    for (const double offset_y : {0.01, 0.03}) {
        const TestType element(rubber, offset(rectangle(0.04, 0.05), offset_y, 0.0), 1.0,
                               CrossSectionOptions{Rule::mixed()});
        for (int turn = -20; turn <= 20; ++turn)
            for (int chord = 0; chord <= 20; ++chord)
                for (const double stretch : {0.9, 1.0, 1.1}) {
                    const auto e = arch<TestType>(0.05 * turn, 0.85 + 0.01 * chord, stretch);
                    if (!element.admissible(e)) continue;
                    ++states;
                    REQUIRE(element.energy(e) >= 0.0);
                }
    }
    CHECK(states == 2 * 41 * 21 * 3);
}

/// The tip of a cantilever of 1 m in the axes of its section: its displacement (m) and its twist.
struct Tip {
    Vector<double, 3> moved;
    double twist;
};

Tip bent(const Section& section, const Vector<double, 3>& force) {
    CrossSectionOptions options = CrossSectionOptions::best();
    Model model;
    const auto beam = straight_beam<Carried>(model, Material::from_moduli(2e11, 8e10, 7800.0),
                                             section, {0, 0, 0}, {1, 0, 0}, 8, options);
    model.clamp(beam.first(), Clamp::free_slope);
    model.add(Force<3>(beam.last(), force));
    BlockTridiagonal solver;
    REQUIRE(solve_statics(model, solver).status == Status::converged);
    return {model.position(beam.last()) - Vector<double, 3>(1.0, 0.0, 0.0),
            model.value(beam.last(), Field::r_y)[2]};
}

TEST_CASE("off the axis: the full clamp keeps a pulled bar from bending there", "[element]") {
    // docs/recipes.md: 20 mm square, 1 m, pulled along an axis 30 mm beside it
    const auto bends = [](Clamp clamp, int elements) {
        Model model;
        const auto beam = straight_beam<Paper>(model, Material::isotropic(2e11, 0.3, 7800.0),
                                               offset(rectangle(0.02, 0.02), 0.03, 0.0), {0, 0, 0},
                                               {1, 0, 0}, elements, CrossSectionOptions::best());
        model.clamp(beam.first(), clamp);
        model.add(Force<3>(beam.last(), {1.0, 0.0, 0.0}));
        BlockTridiagonal solver;
        REQUIRE(solve_statics(model, solver).status == Status::converged);
        const double bending = 2e11 * std::pow(0.02, 4) / 12.0;
        return std::abs(model.position(beam.last())[1]) / (0.5 * 0.03 / bending);
    };
    CHECK(bends(Clamp::full, 8) == Approx(0.930).margin(1e-3));
    CHECK(bends(Clamp::full, 32) == Approx(0.983).margin(1e-3));
    CHECK(bends(Clamp::free_slope, 1) == Approx(1.0).margin(3e-4));
}

TEST_CASE("off the axis: a force beside the shear centre twists by its moment about it",
          "[element]") {
    const double J = 1e-8, F = 1.0;
    const Section centred = rectangle(0.06, 0.1).with_torsion_constant(J);
    const Material material = Material::from_moduli(2e11, 8e10, 7800.0);
    const Section moved = offset(centred.with_shear_centre({0.0, 0.0}), 0.01, 0.02);
    CHECK_THROWS_WITH(Carried(material, moved, 1.0), ContainsSubstring("saint_venant"));
    using Pointwise = CrossSectionBeam<3, Projected, PointwiseShear>;
    CrossSectionOptions options = CrossSectionOptions::best();
    options.rule = Rule::gauss(3);
    CHECK_NOTHROW(Pointwise(material, centred, 1.0, options));
    CHECK_THROWS_WITH(Pointwise(material, moved, 1.0, options), ContainsSubstring("LinearShear"));
    CHECK_NOTHROW(Planar(material, moved, 1.0));
    const Tip plain = bent(centred, {0.0, F, F});
    CHECK(std::abs(plain.twist) < 1e-9);  // of second order
    // the moment of (F_y, F_z) at the axis about the shear centre (y_s, z_s): z_s F_y - y_s F_z
    const SectionPoint centre{-0.04, 0.03};
    const Section channel = centred.with_shear_centre(centre);
    const double flexibility = 1.0 / (8e10 * J);
    for (const Vector<double, 3>& force :
         {Vector<double, 3>(0.0, F, 0.0), Vector<double, 3>(0.0, 0.0, F),
          Vector<double, 3>(0.0, F, F)}) {
        const double twist = (centre.z * force[1] - centre.y * force[2]) * flexibility;
        const Tip tip = bent(channel, force), before = bent(centred, force);
        CHECK(tip.twist == Approx(twist).epsilon(1e-4));
        // the axis turns about the shear centre
        CHECK(tip.moved[1] - before.moved[1] == Approx(centre.z * twist).epsilon(1e-4));
        CHECK(tip.moved[2] - before.moved[2] == Approx(-centre.y * twist).epsilon(1e-4));
        // an axis through it does not
        CHECK(std::abs(bent(offset(channel, -centre.y, -centre.z), force).twist) <
              1e-3 * std::abs(twist));
    }
}

/// Returns a beam of 3 m between forks, which hold the axis and the twist of both ends.
template <class Element>
Beam<Element> forked(Model& model, const Section& section, int elements) {
    typename Element::Options options;
    options.rule = Element::fields.contains(Field::r_xx) ? Rule::quintic() : Rule::mixed();
    options.section_model = SectionModel::saint_venant;
    options.rotary_inertia = RotaryInertia::lumped;
    const auto beam = straight_beam<Element>(model, Material::from_moduli(2e11, 8e10, 7800.0),
                                             section, {0, 0, 0}, {3, 0, 0}, elements, options);
    for (const NodeId end : {beam.first(), beam.last()}) {
        model.fix(end, Field::r, 1);
        model.fix(end, Field::r, 2);
        model.fix(end, Field::r_y, 2);
        model.fix(end, Field::r_z, 1);
    }
    model.fix(beam.first(), Field::r, 0);
    return beam;
}

TEMPLATE_TEST_CASE("off the axis: a beam between forks twists about its shear centre", "[element]",
                   Paper, Carried, Engineering, QuinticBeam<>) {
    // where shears that are linear met twist that is constant along an element, 4 elements twisted
    // by 4e-3 of the angle and 64 by half of it
    const double J = 3.73e-10, length = 3.0;
    const Section centred = rectangle(0.03, 0.06).with_torsion_constant(J);
    int checked = 0;
    for (const SectionPoint centre :
         {SectionPoint{0.0, -0.01}, {0.0, -0.033}, {0.025, 0.0}, {-0.03, 0.02}})
        for (const int elements : {2, 4, 8})
            for (const Vector<double, 3>& force :
                 {Vector<double, 3>(0, 1e-3, 0), Vector<double, 3>(0, 0, 1e-3)}) {
                CAPTURE(centre.y, centre.z, elements, force);
                const double torque = centre.z * force[1] - centre.y * force[2];
                if (torque == 0.0) continue;
                const double angle = torque * length / (8.0 * 8e10 * J);
                Model even;
                const auto beam =
                    forked<TestType>(even, centred.with_shear_centre(centre), elements);
                Model middle = even;
                add_line_load(even, beam, {0.0, force[1] / length, force[2] / length});
                middle.add(Force<3>(beam.node(elements / 2), force));
                BlockTridiagonal solver;
                REQUIRE(solve_statics(even, solver).status == Status::converged);
                REQUIRE(solve_statics(middle, solver).status == Status::converged);
                const auto twist = [&](const Model& model) {
                    return model.value(beam.node(elements / 2), Field::r_y)[2];
                };
                CHECK(twist(even) == Approx(angle).epsilon(1e-4));
                // the shear forces of both sides meet in the elements beside the load
                if (!TestType::fields.contains(Field::r_xx))
                    CHECK(twist(middle) == Approx(2.0 * angle).epsilon(0.7 / elements));
                ++checked;
            }
    CHECK(checked == 15);
}

TEST_CASE("off the axis: bending and torsion of a beam between forks vibrate together",
          "[element]") {
    const double J = 3.73e-10, length = 3.0, e = 0.033, density = 7800.0;
    const Section section =
        rectangle(0.03, 0.06).with_torsion_constant(J).with_shear_centre({0.0, -e});
    const Moments& moments = section.moments();
    const double m = density * moments.area, polar = density * (moments.yy + moments.zz);
    const double k = pi / length, bending = 2e11 * moments.yy * std::pow(k, 4);
    const double torsion = 8e10 * J * k * k;
    // (bending - m w) (torsion - (polar + m e^2) w) = (m e w)^2 with w = omega^2
    const double b = bending * (polar + m * e * e) + torsion * m;
    const double exact =
        (b - std::sqrt(b * b - 4.0 * m * polar * bending * torsion)) / (2.0 * m * polar);
    // where the twist held changes of shear, 12 elements vibrated at 5.6 times the square
    for (const int elements : {4, 8, 16}) {
        Model model;
        (void)forked<Engineering>(model, section, elements);
        BlockTridiagonal solver;
        const auto report = natural_modes(model, solver);
        REQUIRE(report.status == Status::converged);
        const double error = std::abs(report.modes[0].value / exact - 1.0);
        CAPTURE(elements, report.modes[0].value, exact);
        CHECK(error < 2e-3);  // 1.1e-3, 2e-5, 1.2e-4
    }
}

TEMPLATE_TEST_CASE("off the axis: a column between forks buckles by twist and bending together",
                   "[element]", Paper, Carried, QuinticBeam<>) {
    // Green's strain has the stretch of fibres beside the shear centre, which engineering strains
    // and torsion beams lack
    const double J = 3.73e-10, length = 3.0;
    for (const double e : {0.0, 0.01, 0.03}) {
        const Section section =
            rectangle(0.03, 0.06).with_torsion_constant(J).with_shear_centre({0.0, -e});
        const Moments& moments = section.moments();
        const double polar = (moments.yy + moments.zz) / moments.area, r = polar + e * e;
        const double bending = std::pow(pi / length, 2) * 2e11 * moments.yy;
        const double torsion = 8e10 * J / r;
        // (bending - P) (torsion - P) r = (P e)^2
        const double b = (bending + torsion) * r;
        const double twisted =
            (b - std::sqrt(b * b - 4.0 * polar * bending * torsion * r)) / (2.0 * polar);
        const double exact =
            std::min(twisted, std::pow(pi / length, 2) * 2e11 * moments.zz);  // across
        Model model;
        const auto beam = forked<TestType>(model, section, 8);
        model.add(Force<3>(beam.last(), {-exact, 0.0, 0.0}));
        BlockTridiagonal solver;
        const auto report = buckling_modes(model, solver);
        REQUIRE(report.status == Status::converged);
        CAPTURE(e);
        CHECK(report.modes[0].value == Approx(1.0).epsilon(1e-2));  // 3e-4, 3e-4, 4.4e-3 at most
    }
}

}  // namespace off_axis_test
