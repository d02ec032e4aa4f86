// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Newton's method of mixed integration points: same solutions, fewer iterations.

#include <ancf/constants.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>
#include <ancf/solver/turning.hpp>

#include <support/catch.hpp>
#include <support/unmixed.hpp>

#include <cmath>
#include <tuple>
#include <type_traits>
#include <utility>

namespace newton_test {

using ancf::NewtonKind;
using ancf::Status;
using Element = ancf::CrossSectionBeam<3>;
using Scene = ancf::Model;

using ancf::pi;

struct Cantilever {
    Scene scene;
    ancf::Beam<Element> beam;
    double bending;  ///< E I, N m^2

    Cantilever(int elements, double length, double height, ancf::Rule rule)
        : beam(make(elements, length, height, std::move(rule))),
          bending(2.07e11 * std::pow(height, 4) / 12.0) {
        scene.clamp(beam.first(), ancf::Clamp::free_slope);
    }

    [[nodiscard]] ancf::StaticsReport solve(NewtonKind newton, int steps = 1) {
        ancf::StaticsOptions options;
        options.newton = newton;
        options.steps = steps;
        ancf::EigenLu solver;
        return ancf::solve_statics(scene, solver, options);
    }

private:
    ancf::Beam<Element> make(int elements, double length, double height, ancf::Rule rule) {
        ancf::CrossSectionOptions options;
        options.rule = std::move(rule);
        const auto material = ancf::Material::from_moduli(2.07e11, 7.9615e10, 7850.0);
        return ancf::straight_beam<Element>(scene, material, ancf::rectangle(height, height),
                                            {0, 0, 0}, {length, 0, 0}, elements, options);
    }
};

/// Model II of the paper under A E I/L^2.
Cantilever loaded(double factor, int elements = 8, double slenderness = 200.0,
                  const ancf::Rule& rule = ancf::Rule::paper()) {
    Cantilever result(elements, 2.0, 2.0 / slenderness, rule);
    result.scene.add(ancf::Force<3>(result.beam.last(), {0, factor * result.bending / 4.0, 0}));
    return result;
}

Cantilever rolled(double angle, int elements, double slenderness = 30.0) {
    Cantilever result(elements, 1.0, 1.0 / slenderness, ancf::Rule::mixed());
    result.scene.add(ancf::Moment(result.beam.last(), {0, 0, angle * result.bending}));
    return result;
}

TEST_CASE("statics: mixed and plain Newton end in the same state", "[statics][newton]") {
    auto plain = loaded(1.5), mixed = loaded(1.5), automatic = loaded(1.5);
    const auto reference = plain.solve(NewtonKind::plain);
    REQUIRE(reference.status == Status::converged);
    for (auto* other : {&mixed, &automatic}) {
        const auto report =
            other->solve(other == &mixed ? NewtonKind::mixed : NewtonKind::automatic);
        REQUIRE(report.status == Status::converged);
        CHECK(report.steps.size() == 1);
        CHECK(2 * report.iterations() <= reference.iterations());  // measured 6 and 5 of 12
        // what the residual tolerance leaves; measured 3e-11
        CHECK((other->scene.state().q - plain.scene.state().q).norm() <= 1e-9);
    }
}

/// Returns the mixed iterations of one load step, after a check that plain Newton ends there too.
int mixed_iterations(Cantilever beam, int plain_steps = 1) {
    Cantilever other = beam;
    const auto report = beam.solve(NewtonKind::mixed);
    REQUIRE(report.status == Status::converged);
    CHECK(report.steps.size() == 1);
    CHECK(report.stability == ancf::Stability::stable);
    REQUIRE(other.solve(NewtonKind::plain, plain_steps).status == Status::converged);
    CHECK((beam.scene.state().q - other.scene.state().q).lpNorm<Eigen::Infinity>() <=
          1e-8);  // what the tolerances of both leave
    return report.iterations();
}

TEST_CASE("statics: one load step of Model II takes at most six mixed iterations",
          "[statics][newton]") {
    for (const int elements : {1, 2, 4, 8, 16}) {
        INFO(elements);
        CHECK(mixed_iterations(loaded(1.5, elements, 200.0, ancf::Rule::mixed())) <=
              6);                                             // as measured
        if (elements < 4) continue;                           // where the paper's rule locks, 7
        CHECK(mixed_iterations(loaded(1.5, elements)) <= 6);  // as measured
    }
}

TEST_CASE("statics: mixed iterations hardly grow with the load", "[statics][newton]") {
    const double tip[] = {0.713791523612, 0.810609024880};  // of the elastica
    int k = 0;
    for (const double load : {5.0, 10.0}) {
        auto beam = loaded(load, 16, 1000.0, ancf::Rule::mixed());
        const auto report = beam.solve(NewtonKind::mixed);
        REQUIRE(report.status == Status::converged);
        CHECK(report.steps.size() == 1);
        CHECK(report.iterations() <= 10);  // measured 7 and 9; plain takes 19 and 21
        // the mesh's own error, measured 1e-4
        CHECK(beam.scene.position(beam.beam.last())[1] / 2.0 == Approx(tip[k++]).epsilon(3e-4));
    }
    CHECK(mixed_iterations(loaded(50.0, 16), 10) <= 12);  // measured 12
}

TEST_CASE("statics: slenderness hardly matters to mixed iterations", "[statics][newton]") {
    for (const double slenderness : {1e1, 1e2, 1e3, 1e4}) {
        INFO(slenderness);
        auto beam = loaded(1.5, 8, slenderness, ancf::Rule::mixed());
        const auto report = beam.solve(NewtonKind::mixed);
        CHECK(report.status == Status::converged);
        CHECK(report.iterations() <= 6);  // measured 5, 6, 6, 6; plain takes 8, 11, 26, 23
        CHECK(report.stability == ancf::Stability::stable);
        // of the elastica; the thickest has a limit of its own
        CHECK(beam.scene.position(beam.beam.last())[1] / 2.0 ==
              Approx(0.5 * 0.821956422496).epsilon(slenderness < 20.0 ? 2e-2 : 3e-4));
    }
}

/// Returns a planar cantilever under A E I/L^2, and its bending stiffness of 1.
template <class Beam>
ancf::StaticsReport solve_planar(double load, double slenderness, NewtonKind newton,
                                 ancf::BasicModel<Beam::dimension>& scene,
                                 const ancf::Rule& rule = ancf::Rule::mixed()) {
    typename Beam::Options options;
    options.rule = rule;
    const double height = 1.0 / slenderness, stiffness = 12.0 / std::pow(height, 4);
    const auto beam =
        ancf::straight_beam<Beam>(scene, ancf::Material::isotropic(stiffness, 0.3, 1.0),
                                  ancf::rectangle(height, height), {0, 0}, {1, 0}, 16, options);
    scene.clamp(beam.first(), ancf::Clamp::full);
    scene.add(ancf::Force<2>(beam.last(), {0, load}));
    ancf::StaticsOptions how;
    how.newton = newton;
    ancf::EigenLu solver;
    return ancf::solve_statics(scene, solver, how);
}

TEST_CASE("statics: planar beams take as few mixed iterations as spatial ones, at any slenderness",
          "[statics][newton]") {
    using Planar = ancf::CrossSectionBeam<2>;
    // measured 5, 6, 6, 6; 9, 9, 9, 9; 12, 12, 12 (the thickest beam leaves its strain range there)
    for (const auto& [load, most, thickest] :
         {std::tuple(1.5, 6, 1e1), {10.0, 9, 1e1}, {50.0, 12, 1e2}})
        for (const double slenderness : {1e1, 1e2, 1e3, 1e4}) {
            if (slenderness < thickest) continue;
            INFO("load " << load << ", slenderness " << slenderness);
            ancf::PlanarModel mixed, plain;
            const auto report = solve_planar<Planar>(load, slenderness, NewtonKind::mixed, mixed);
            REQUIRE(report.status == Status::converged);
            CHECK(report.steps.size() == 1);
            CHECK(report.iterations() <= most);
            CHECK(report.stability == ancf::Stability::stable);
            REQUIRE(solve_planar<Planar>(load, slenderness, NewtonKind::plain, plain).status ==
                    Status::converged);
            CHECK((mixed.state().q - plain.state().q).lpNorm<Eigen::Infinity>() <= 1e-6);
        }
}

TEST_CASE("statics: elements without mixed iterations are iterated plainly", "[statics][newton]") {
    using Unmixed = ancf::test::Unmixed<ancf::ContinuumBeam<2>>;
    const auto solve = [](NewtonKind newton) {
        ancf::PlanarModel scene;
        return solve_planar<Unmixed>(1.5, 100.0, newton, scene, ancf::Rule::paper());
    };
    const auto report = solve(NewtonKind::mixed);
    REQUIRE(report.status == Status::converged);
    CHECK(report.steps.front().newton == NewtonKind::plain);
    CHECK(report.iterations() == solve(NewtonKind::plain).iterations());
    // corrections can turn its sections nonetheless
    const auto turning = solve(NewtonKind::automatic);
    REQUIRE(turning.status == Status::converged);
    CHECK(turning.steps.front().newton == NewtonKind::automatic);
    CHECK(turning.iterations() <= 8);
}

TEST_CASE("statics: an end moment rolls a cantilever up in few iterations", "[statics][newton]") {
    SECTION("to a semicircle in one step") {
        for (const int elements : {4, 8, 20}) {
            auto beam = rolled(pi, elements);
            const auto report = beam.solve(NewtonKind::automatic);
            REQUIRE(report.status == Status::converged);
            CHECK(report.steps.size() == 1);
            CHECK(report.iterations() <= 8);  // measured 4 to 5; plain takes 30
            // the thick section's own limit is 5e-3 off the semicircle
            CHECK(beam.scene.position(beam.beam.last())[1] == Approx(2.0 / pi).margin(0.01));
        }
    }
    SECTION("to two and four circles in one step") {
        for (const int circles : {2, 4}) {
            auto beam = rolled(2.0 * pi * circles, 10 * circles, 200.0);
            const auto report = beam.solve(NewtonKind::automatic);
            REQUIRE(report.status == Status::converged);
            CHECK(report.steps.size() == 1);
            CHECK(report.iterations() <= 8);  // measured 6
            CHECK(beam.scene.position(beam.beam.last()).norm() <= 0.01);
            double turned = 0.0;  // from node to node: whole turns count
            for (int k = 0; k < 10 * circles; ++k) {
                const auto a = beam.scene.value(beam.beam.nodes[k], ancf::Field::r_x);
                const auto b = beam.scene.value(beam.beam.nodes[k + 1], ancf::Field::r_x);
                turned += std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b));
            }
            CHECK(turned / (2.0 * pi) == Approx(circles).margin(0.03));
        }
    }
}

TEST_CASE("statics: half a turn of twist takes few mixed iterations", "[statics][newton]") {
    for (const auto newton : {NewtonKind::mixed, NewtonKind::automatic}) {
        Cantilever beam(5, 0.25, 0.005, ancf::Rule::paper());
        const double polar = std::pow(0.005, 4) / 6.0;
        const double stiffness = 7.9615e10 * 5.0 / 6.0 * polar;
        beam.scene.add(ancf::Moment(beam.beam.last(), {pi * stiffness / 0.25, 0, 0}));
        const auto report = beam.solve(newton);
        REQUIRE(report.status == Status::converged);
        CHECK(report.iterations() <= 8);  // measured 5 and 4; plain takes 11
        const auto director = beam.scene.value(beam.beam.last(), ancf::Field::r_y);
        // measured 179.45 degrees with this section: a twisted section stiffens
        CHECK(std::abs(std::atan2(director[2], director[1])) == Approx(pi).margin(0.011));
    }
}

TEST_CASE("statics: a step that mixed iterations fail is repeated as plain", "[statics][newton]") {
    auto beam = rolled(pi, 6);
    ancf::StaticsOptions options;
    options.newton = NewtonKind::mixed;
    options.mixed_iterations = 3;
    ancf::EigenLu solver;
    const auto report = ancf::solve_statics(beam.scene, solver, options);
    REQUIRE(report.status == Status::converged);
    REQUIRE(report.steps.size() == 2);
    CHECK(report.steps[0].newton == NewtonKind::mixed);
    CHECK(report.steps[0].status == Status::max_iterations);
    CHECK(report.steps[1].newton == NewtonKind::plain);
    CHECK(report.iterations() == 3 + report.steps[1].iterations);
}

/// Returns a slender cantilever of 32 elements, E I = 1, as best() has it.
template <class Beam>
ancf::NodeId straight(ancf::Model& scene, double height) {
    const auto beam = ancf::straight_beam<Beam>(
        scene, ancf::Material::isotropic(12.0 / std::pow(height, 4), 0.3, 1.0),
        ancf::rectangle(height, height), {0, 0, 0}, {1, 0, 0}, 32, Beam::Options::best());
    const bool shears = !std::is_same_v<Beam, ancf::TorsionBeam>;
    scene.clamp(beam.first(), shears ? ancf::Clamp::free_slope : ancf::Clamp::full);
    return beam.last();
}

using Green = ancf::CrossSectionBeam<3, ancf::Geodesic>;
using Engineering =
    ancf::CrossSectionBeam<3, ancf::Geodesic, ancf::LinearShear, ancf::EngineeringMeasure>;

TEMPLATE_TEST_CASE("statics: a force off the section's axes takes one load step by default",
                   "[statics][newton]", Green, Engineering, ancf::TorsionBeam) {
    for (const double height : {1e-1, 1e-2, 1e-3}) {
        INFO(height);
        ancf::Model scene;
        const auto end = straight<TestType>(scene, height);
        scene.add(ancf::Force<3>(end, {0, 10.0 * std::cos(0.6), 10.0 * std::sin(0.6)}));
        ancf::EigenLu solver;
        const auto report = ancf::solve_statics(scene, solver);
        REQUIRE(report.status == Status::converged);
        CHECK(report.steps.size() == 1);
        CHECK(report.steps.front().newton == NewtonKind::automatic);
        CHECK(report.iterations() <= 8);  // measured 5 and 6; mixed ones take ten or fail
        CHECK(report.stability == ancf::Stability::stable);
        if (height < 2e-2)  // of the elastica
            CHECK(scene.position(end)[0] == Approx(0.445004402246).margin(3e-4));
    }
}

TEST_CASE("statics: a default step that fails is cut, within the user's own bound",
          "[statics][newton]") {
    const auto solve = [](int max_iterations) {
        ancf::Model scene;
        const auto end = straight<Green>(scene, 1e-2);
        scene.add(ancf::Force<3>(end, {0, 100.0 * std::cos(0.6), 100.0 * std::sin(0.6)}));
        ancf::StaticsOptions options;
        options.max_iterations = max_iterations;
        ancf::EigenLu solver;
        return ancf::solve_statics(scene, solver, options);
    };
    const auto cut = solve(100);
    CHECK(cut.status == Status::converged);
    CHECK(cut.steps.size() > 1);
    CHECK(cut.iterations() <= 40);  // measured 27
    const auto unbounded = solve(std::numeric_limits<int>::max());
    CHECK(unbounded.status == Status::converged);
    CHECK(unbounded.steps.size() == cut.steps.size());
    const auto bounded = solve(2);
    CHECK(bounded.status == Status::max_iterations);
    CHECK(bounded.steps.size() == 1);
    CHECK(bounded.iterations() == 2);
}

TEST_CASE("statics: an end moment off the axes closes a thick beam to a circle",
          "[statics][newton]") {
    ancf::Model scene;
    const auto end = straight<Engineering>(scene, 1.0 / 28.0);
    scene.add(ancf::Moment(end, {0, -2.0 * pi * std::sin(0.7), 2.0 * pi * std::cos(0.7)}));
    ancf::EigenLu solver;
    REQUIRE(ancf::solve_statics(scene, solver).status == Status::converged);
    // measured 5.9e-6; a section that bending shears ends 7e-3 away
    CHECK(scene.position(end).norm() <= 2e-5);
}

TEST_CASE("statics: a default step that ends on a branch of its own is taken again",
          "[statics][newton]") {
    // a force that pushes the beam back: one correction from the straight beam and those after it
    // end in an unstable state, with the force still pushing
    int rejected = 0;
    for (const double angle : {2.6, 2.7, 2.8, 2.9, 3.0}) {
        ancf::Model once, slowly;
        for (auto* scene : {&once, &slowly}) {
            const auto end = straight<Engineering>(*scene, 1e-2);
            scene->add(ancf::Force<3>(end, {8.0 * std::cos(angle), 8.0 * std::sin(angle) * 0.8,
                                            8.0 * std::sin(angle) * 0.6}));
        }
        ancf::EigenLu solver;
        const auto report = ancf::solve_statics(once, solver);
        ancf::StaticsOptions steps;
        steps.newton = NewtonKind::plain;
        steps.steps = 60;
        steps.adaptive = true;
        REQUIRE(ancf::solve_statics(slowly, solver, steps).status == Status::converged);
        REQUIRE(report.status == Status::converged);
        for (const auto& step : report.steps) rejected += step.status == Status::diverged ? 1 : 0;
        // what the tolerances of both leave
        CHECK((once.state().q - slowly.state().q).lpNorm<Eigen::Infinity>() <= 1e-5);
    }
    CHECK(rejected > 0);
}

TEST_CASE("statics: a beam that is crushed at its clamp says so", "[statics][newton]") {
    struct Run {
        NewtonKind newton;
        int steps;
    };
    for (const Run run :
         {Run{NewtonKind::plain, 1}, Run{NewtonKind::plain, 10}, Run{NewtonKind::automatic, 1}}) {
        Cantilever beam(4, 1.0, 0.1, ancf::Rule::gauss(3));
        beam.scene.add(ancf::Force<3>(beam.beam.last(), {0.0, 30.0 * beam.bending, 0.0}));
        const auto report = beam.solve(run.newton, run.steps);
        REQUIRE(report.status == Status::converged);
        CHECK(report.stability == ancf::Stability::stable);
        const double tip = beam.scene.position(beam.beam.last())[0];
        if (run.newton == NewtonKind::plain && run.steps == 1) {
            CHECK(tip < 0.0);  // another equilibrium of the mesh; measured -0.007
            REQUIRE(report.softened);
            CHECK(report.softened->element == 0);
        } else {
            CHECK(tip == Approx(0.242).margin(2e-3));  // finer meshes have 0.239
            CHECK_FALSE(report.softened);
        }
    }
}

TEST_CASE("statics: Green's measure bears no bending moment above (2/3) E I/sqrt(6 I/A)",
          "[statics][newton]") {
    // of a section given to second order; bending by k a unit length compresses the axis by
    // k^2 I/A, so that M = E I k (1 - 2 k^2 I/A)
    using Quintic = ancf::QuinticBeam<>;
    const double inertia = 0.01;  // A = 1, E = 1e4
    const double largest = 2.0 / 3.0 * 1e4 * inertia / std::sqrt(6.0 * inertia);
    const auto solve = [&](double part) {
        ancf::Moments moments;
        moments.area = 1.0;
        moments.yy = moments.zz = inertia;
        const auto section = ancf::Section::from_moments(moments)
                                 .with_shear_correction(1.0, 1.0)
                                 .with_torsion_constant(inertia);
        ancf::Model scene;
        const auto beam =
            ancf::straight_beam<Quintic>(scene, ancf::Material::from_moduli(1e4, 1e4, 1.0), section,
                                         {0, 0, 0}, {10, 0, 0}, 50, Quintic::Options::best());
        scene.clamp(beam.first(), ancf::Clamp::free_slope);
        scene.add(ancf::Moment(beam.last(), {0, 0, part * largest}));
        ancf::StaticsOptions options;
        options.steps = 20;
        options.adaptive = true;
        ancf::EigenLu solver;
        auto report = ancf::solve_statics(scene, solver, options);
        const auto e = scene.element_coordinates<Quintic>(25);
        const double axial = scene.group<Quintic>().element(25).strains(e, 0.5)[0];
        return std::make_pair(report, axial);
    };
    const auto [below, strain] = solve(0.99);
    REQUIRE(below.status == Status::converged);
    // k^2 I/A of the smaller root; 1/6 at the largest moment
    double bent = 0.0;
    for (int k = 0; k < 200; ++k)
        bent = std::sqrt(inertia) * 0.99 * largest / (1e4 * inertia) / (1.0 - 2.0 * bent * bent);
    CHECK(strain == Approx(-bent * bent).epsilon(1e-3));
    const auto above = solve(1.01).first;
    CHECK(above.status != Status::converged);
    CHECK(1.01 * above.factor == Approx(1.0).margin(0.01));
}

TEST_CASE("statics: solid sections bear a fifth of sqrt(EA EI) by Green's measure",
          "[statics][newton]") {
    // with y^2 k^2/2 in the strain M = E I k (1 - c k^2), c = 9 I/(2 A) - int y^4 dA/(2 I)
    for (const ancf::Section& section : {ancf::rectangle(0.1, 0.1), ancf::circle(0.05)}) {
        const ancf::Moments of = section.moments();
        const double c = 4.5 * of.yy / of.area - 0.5 * of.yyyy / of.yy;
        const double largest = 2.0 / 3.0 * of.yy / std::sqrt(3.0 * c);  // over E
        CHECK(largest == Approx(0.2 * std::sqrt(of.area * of.yy)).epsilon(0.03));
        const auto solve = [&](double part) {
            ancf::PlanarModel scene;
            const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<2>>(
                scene, ancf::Material::from_moduli(1e9, 4e8, 1.0), section, {0, 0}, {1, 0}, 32,
                ancf::CrossSectionOptions::best());
            scene.clamp(beam.first(), ancf::Clamp::free_slope);
            scene.add(ancf::PlanarSlopeMoment(beam.last(), ancf::Field::r_y, part * 1e9 * largest));
            ancf::StaticsOptions options;
            options.steps = 10;
            options.adaptive = true;
            ancf::EigenLu solver;
            return ancf::solve_statics(scene, solver, options);
        };
        CHECK(solve(0.99).status == Status::converged);
        const auto above = solve(1.01);
        CHECK(above.status != Status::converged);
        CHECK(1.01 * above.factor == Approx(1.0).margin(0.002));  // measured 0.9990, 0.9994
    }
}

TEST_CASE("statics: a mesh too coarse for one equilibrium shows it by its turn",
          "[statics][newton]") {
    const auto solve = [](int elements, int steps, double& tip,
                          NewtonKind newton = NewtonKind::plain) {
        ancf::PlanarModel scene;
        const double height = 0.003055, bending = 2.07e11 * std::pow(height, 4) / 12.0;
        const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<2>>(
            scene, ancf::Material::from_moduli(2.07e11, 7.9615e10, 7850.0),
            ancf::rectangle(height, height).with_shear_correction(5.0 / 6.0, 5.0 / 6.0), {0, 0},
            {1, 0}, elements);
        scene.clamp(beam.first(), ancf::Clamp::free_slope);
        scene.add(ancf::Force<2>(beam.last(), {0.0, 92.1 * bending}));
        ancf::EigenLu solver;
        ancf::StaticsOptions options;
        options.steps = steps;
        options.newton = newton;
        const auto report = ancf::solve_statics(scene, solver, options);
        REQUIRE(report.status == Status::converged);
        CHECK(report.stability == ancf::Stability::stable);
        CHECK_FALSE(report.softened);
        tip = scene.position(beam.last())[0];
        return report.largest_turn;
    };
    double once = 0.0, slowly = 0.0, by_default = 0.0, fine = 0.0;
    CHECK(solve(2, 1, once) > 1.0);         // measured 1.86
    CHECK(solve(2, 3, slowly) > 1.0);       // 1.56
    CHECK(std::abs(slowly - once) > 0.02);  // 0.270 after three steps, 0.239 after one
    CHECK(solve(2, 1, by_default, NewtonKind::automatic) > 1.0);
    CHECK(by_default == Approx(slowly).margin(1e-6));
    CHECK(solve(16, 1, fine) < 1.0);
    CHECK(fine == Approx(0.1484).margin(1e-4));
}

TEST_CASE("statics: a small correction that turns is the correction itself", "[statics][newton]") {
    Cantilever beam(6, 1.0, 0.1, ancf::Rule::paper());
    const ancf::Numbering numbering(beam.scene);
    ancf::Turning turning(beam.scene, numbering);
    const ancf::VectorX before = beam.scene.state().q;
    ancf::VectorX change = ancf::VectorX::Zero(before.size());
    for (int k = 0; k < before.size(); ++k)
        if (numbering.equation(k) >= 0) change[k] = std::sin(1.0 + 1.7 * k);
    const auto difference = [&](double size) {
        const ancf::VectorX small = size * change;
        ancf::VectorX q = before + small;
        turning.turn(before, small, q);
        for (const int k : numbering.held()) CHECK(q[k] == before[k]);
        return (q - before - small).norm();
    };
    const double coarse = difference(1e-3), fine = difference(1e-4);
    CHECK(coarse >= 1e-9);
    CHECK(fine / coarse == Approx(0.01).epsilon(0.05));  // second order; measured 0.0100
}

}  // namespace newton_test
