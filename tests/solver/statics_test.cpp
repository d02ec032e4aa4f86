// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/solver/statics.hpp>

#include <ancf/constants.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/builders/rigid_body.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/loads/springs.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/path.hpp>
#include <ancf/solver/solver_named.hpp>

#include <support/bar.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace statics_test {

using ancf::Field;
using ancf::Status;
using Bar = ancf::test::Bar<3>;
using Chain = ancf::Model;
using Scene = ancf::Model;

constexpr double axial_stiffness = 100.0;

/// Pulls to the origin; not a number below y = 0.5 m.
struct NaNBelow {
    static constexpr int dimension = 2;
    ancf::NodeId node;
    double told = 1.0;  // stiffness; the larger, the smaller a correction
    [[nodiscard]] ancf::Coupling coupling() const { return {{node, Field::r}}; }
    void evaluate(const ancf::LoadState& at, ancf::LoadResult& out) const {
        out.force = -at.q;
        if (at.q[1] < 0.5) out.force[1] = std::numeric_limits<double>::quiet_NaN();
        out.stiffness(0, 0) = out.stiffness(1, 1) = -told;
    }
};

/// Two bars in a row along X, held sideways; the far end is node 2.
Chain make_chain() {
    Chain chain;
    const int prototype = chain.add_prototype(Bar(axial_stiffness, 1.0, 1.0));
    for (int k = 0; k < 3; ++k) {
        const auto node = chain.add_node({1.0 * k, 0.0, 0.0});
        chain.fix(node, Field::r, 1);
        chain.fix(node, Field::r, 2);
        if (k > 0) chain.connect<Bar>(prototype, {k - 1}, node);
    }
    chain.pin({0});
    return chain;
}

/// A soft, thick cantilever of continuum elements along a skew line.
Scene make_cantilever(int elements = 2) {
    Scene scene;
    const auto material = ancf::Material::from_moduli(1e6, 4e5, 1000.0);
    const auto beam = ancf::straight_beam<ancf::ContinuumBeam<3>>(
        scene, material, ancf::rectangle(0.1, 0.2), {0, 0, 0}, {1, 1, 0.5}, elements);
    scene.clamp(beam.first(), ancf::Clamp::free_slope);
    return scene;
}

ancf::NodeId last(const Scene& scene) { return {scene.nodes() - 1}; }

template <class Model>
ancf::StaticsReport solve(Model& model, const ancf::StaticsOptions& options = {}) {
    ancf::EigenLu solver;
    return ancf::solve_statics(model, solver, options);
}

TEST_CASE("statics: a bar in tension finds the stretch of its Green strain", "[statics]") {
    Chain chain = make_chain();
    // force at stretch s: EA s (s^2 - 1)/2
    const double stretch = 1.2;
    chain.add(
        ancf::Force({2}, {axial_stiffness * stretch * (stretch * stretch - 1.0) / 2.0, 0, 0}));
    const auto report = solve(chain);
    REQUIRE(report.status == Status::converged);
    CHECK(chain.position({2})[0] == Approx(2.0 * stretch).epsilon(1e-12));
    CHECK(report.factor == 1.0);
    CHECK(report.reactions[0] == Approx(-axial_stiffness * stretch * 0.22).epsilon(1e-12));
    CHECK(report.imbalance.force.norm() <= 1e-12 * axial_stiffness);
    CHECK(report.strain_energy == Approx(0.5 * axial_stiffness * 2.0 * 0.22 * 0.22).epsilon(1e-12));
}

TEST_CASE("statics: Newton converges quadratically", "[statics]") {
    Scene scene = make_cantilever();
    scene.add(ancf::Force(last(scene), {0.0, 20.0, -10.0}));
    const auto report = solve(scene);
    REQUIRE(report.status == Status::converged);
    const auto& corrections = report.steps.front().corrections;
    REQUIRE(corrections.size() >= 4);
    std::size_t last = corrections.size() - 1;
    while (corrections[last] < 1e-13) --last;  // round-off
    REQUIRE(last >= 2);
    const double order = std::log(corrections[last] / corrections[last - 1]) /
                         std::log(corrections[last - 1] / corrections[last - 2]);
    CHECK(order >= 1.8);
}

TEST_CASE("statics: a load below the round-off of the stresses is still solved for", "[statics]") {
    Scene scene = make_cantilever();
    const ancf::Vector<double, 3> before = scene.position(last(scene));
    const ancf::Vector<double, 3> force(1e-12, 2e-12, 0.0);
    scene.add(ancf::Force(last(scene), force));
    const auto report = solve(scene);
    REQUIRE(report.status == Status::converged);
    CHECK(report.iterations() >= 1);
    Scene scaled = make_cantilever();
    scaled.add(ancf::Force<3>(last(scaled), 1e6 * force));
    REQUIRE(solve(scaled).status == Status::converged);
    const auto expected = (1e-6 * (scaled.position(last(scaled)) - before)).eval();
    // positions of order 1 hold a deflection of 2e-13 to a thousandth
    CHECK((scene.position(last(scene)) - before - expected).norm() <= 1e-2 * expected.norm());
}

TEST_CASE("statics: loads beyond the range of numbers are never converged", "[statics]") {
    for (const double size : {1e155, 1e200, 1e305}) {
        Scene scene = make_cantilever();
        scene.add(ancf::Force(last(scene), {0.0, size, 0.0}));
        CHECK(solve(scene).status != Status::converged);
    }
}

TEST_CASE("statics: load steps end at the same equilibrium as one step", "[statics]") {
    Scene one = make_cantilever();
    Scene many = make_cantilever();
    const ancf::Force load(last(one), {0.0, 20.0, -10.0});
    one.add(load);
    many.add(load);
    REQUIRE(solve(one).status == Status::converged);
    ancf::StaticsOptions options;
    options.steps = 5;
    int seen = 0;
    options.progress = [&](double factor, const ancf::State&) {
        ++seen;
        CHECK(factor == Approx(0.2 * seen));
        return true;
    };
    const auto report = solve(many, options);
    REQUIRE(report.status == Status::converged);
    CHECK(report.steps.size() == 5);
    CHECK(seen == 5);
    CHECK((one.state().q - many.state().q).norm() <= 1e-10 * one.state().q.norm());
}

TEST_CASE("statics: a callback stops a run, and an exception leaves the last converged step",
          "[statics]") {
    ancf::StaticsOptions options;
    options.steps = 4;
    Scene stopped = make_cantilever(2);
    stopped.add(ancf::Force<3>(last(stopped), {0.0, 20.0, 0.0}));
    options.progress = [](double factor, const ancf::State&) { return factor < 0.4; };
    const auto report = solve(stopped, options);
    CHECK(report.status == Status::stopped);
    CHECK(report.factor == 0.5);

    Scene broken = make_cantilever(2);
    ancf::VectorX converged;
    options.progress = [&](double, const ancf::State& state) {
        converged = state.q;
        return true;
    };
    broken.add(ancf::Force<3>(last(broken), {0.0, 20.0, 0.0}), [](double factor) {
        if (factor > 0.6) throw 7;
        return factor;
    });
    CHECK_THROWS_AS(solve(broken, options), int);
    CHECK(broken.state().q == converged);
    CHECK(broken.state().time == 0.5);
}

TEST_CASE("statics: reactions balance loads of every kind, moments included", "[statics]") {
    Scene scene = make_cantilever(3);
    scene.set_gravity({0.3, -1.0, 0.2});
    scene.add(ancf::Moment(last(scene), {0.5, -0.3, 0.2}));
    scene.add(ancf::FollowerForce({1}, {0.0, 2.0, 1.0}));
    const auto report = solve(scene);
    REQUIRE(report.status == Status::converged);
    const double scale = report.reactions.norm();
    REQUIRE(scale > 1.0);
    CHECK(report.imbalance.force.norm() <= 1e-9 * scale);
    CHECK(report.imbalance.moment.norm() <= 1e-9 * scale);
}

TEST_CASE("statics: a driven support moves the chain and reports its reaction", "[statics]") {
    Chain chain = make_chain();
    chain.prescribe({2}, Field::r, 0, [](double factor) { return 2.0 + 0.4 * factor; });
    const auto report = solve(chain);
    REQUIRE(report.status == Status::converged);
    CHECK(chain.position({1})[0] == Approx(1.2).epsilon(1e-12));
    CHECK(report.reactions[chain.coordinate({2}, Field::r)] ==
          Approx(axial_stiffness * 1.2 * 0.22).epsilon(1e-10));
}

TEST_CASE("statics: an amplitude overrides the load factor", "[statics]") {
    Chain chain = make_chain();
    chain.add(ancf::Force({2}, {1.0, 0.0, 0.0}), [](double) { return 22.0 * 1.2 / 2.0 * 2.0; });
    REQUIRE(solve(chain).status == Status::converged);
    const double stretch = 0.5 * chain.position({2})[0];
    CHECK(axial_stiffness * stretch * (stretch * stretch - 1.0) / 2.0 ==
          Approx(26.4).epsilon(1e-10));
}

TEST_CASE("statics: beams off their axis bend far on coarse meshes", "[statics]") {
    // the axis lies a depth of the section aside; 64 elements are off by 1e-5 of the length
    const auto steel = ancf::Material::isotropic(2.07e11, 0.3, 7850.0);
    const auto section = ancf::offset(ancf::rectangle(0.02, 0.03), 0.03, 0.0);
    const auto tip = [&](int elements, int& iterations) {
        Scene scene;
        const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<3, ancf::Geodesic>>(
            scene, steel, section, {0, 0, 0}, {4, 0, 0}, elements,
            ancf::CrossSectionOptions::best());
        scene.clamp(beam.first(), ancf::Clamp::free_slope);
        const double unit = steel.young * 0.02 * std::pow(0.03, 3) / 12.0 / 16.0;  // E I/L^2
        scene.add(ancf::Force<3>(beam.last(), {0.0, 3.0 * unit, 0.0}));
        const auto report = solve(scene);
        CHECK(report.status == Status::converged);
        iterations = report.iterations();
        return scene.position(beam.last());
    };
    int iterations = 0;
    const auto fine = tip(64, iterations);
    for (const int elements : {4, 8}) {
        INFO(elements << " elements");
        const auto coarse = tip(elements, iterations);
        CHECK((coarse - fine).norm() <= 4.0 * 1e-3);  // measured 3e-4 of the length
        CHECK(iterations <= 8);                       // measured 5
    }
}

TEST_CASE("statics: a bar beyond its limit load ends inverted", "[statics]") {
    // Green strain gives way at the stretch 1/sqrt(3), at 0.19245 EA
    Chain chain = make_chain();
    ancf::StaticsOptions options;
    options.adaptive = true;
    SECTION("just below") {
        chain.add(ancf::Force({2}, {-0.19 * axial_stiffness, 0, 0}));
        const auto report = solve(chain, options);
        CHECK(report.status == Status::converged);
        CHECK(chain.position({2})[0] > 2.0 * 0.577350);
    }
    SECTION("well above") {
        chain.add(ancf::Force({2}, {-0.30 * axial_stiffness, 0, 0}));
        const auto report = solve(chain, options);
        CHECK(report.status == Status::converged);  // bars may turn inside out: Newton jumps there
        CHECK(chain.position({2})[0] < 0.0);
    }
}

/// A straight column of 1 m under a dead force along it, a multiple of Euler's pi^2 E I/(4 L^2).
Scene make_column(double load) {
    Scene scene;
    const auto material = ancf::Material::from_moduli(1e9, 4e8, 1000.0);
    const auto beam = ancf::straight_beam<ancf::ContinuumBeam<3>>(
        scene, material, ancf::rectangle(0.02, 0.02), {0, 0, 0}, {1, 0, 0}, 8);
    scene.add(ancf::Force(beam.last(), {-load * 32.9, 0, 0}));
    return scene;
}

TEST_CASE("statics: a straight column is stable below Euler's load and unstable above",
          "[statics][stability]") {
    for (const double load : {0.9, 1.1, 5.0}) {
        INFO("load " << load);
        const auto expected = load < 1.0 ? ancf::Stability::stable : ancf::Stability::unstable;
        Scene held = make_column(load);
        held.clamp({0}, ancf::Clamp::full);
        const auto report = solve(held);
        REQUIRE(report.status == Status::converged);
        CHECK(report.factorisation.negative_pivots == -1);
        CHECK(report.stability == expected);

        Scene counted = make_column(load);
        counted.clamp({0}, ancf::Clamp::full);
        ancf::EigenLdlt solver;
        CHECK(ancf::solve_statics(counted, solver).stability == expected);

        // held by multipliers alone: without them the tangent is singular
        Scene welded = make_column(load);
        for (const Field field : {Field::r, Field::r_x, Field::r_y, Field::r_z})
            for (int k = 0; k < 3; ++k)
                welded.add(ancf::FixedCoordinate({0}, field, k, welded.value({0}, field)[k]));
        CHECK(solve(welded).stability == expected);
    }
}

/// A clamped column in the plane, a thousandth of its length deep, with a small force aside.
std::pair<ancf::PlanarModel, ancf::NodeId> make_imperfect_column(double aside) {
    ancf::PlanarModel scene;
    const auto column = ancf::straight_beam<ancf::CrossSectionBeam<2>>(
        scene, ancf::Material::isotropic(12e9, 0.3, 1000.0), ancf::rectangle(1.0, 1e-3), {0, 0},
        {1, 0}, 16, ancf::CrossSectionOptions{ancf::Rule::mixed()});  // E I = 1 N m^2
    scene.clamp(column.first());
    scene.add(ancf::Force<2>(column.last(), {0.0, aside}));
    return {std::move(scene), column.last()};
}

TEST_CASE("statics: an imperfect column ends bent beyond its buckling load", "[statics]") {
    // the elastica whose tip has turned by 120 degrees
    const double load = 1.884841 * ancf::pi * ancf::pi / 4.0;
    const double aside = GENERATE(1e-3, -1e-3, 1e-5, -1e-5);
    const int steps = GENERATE(1, 3, 10, 100);
    const auto* const name = GENERATE("eigen-ldlt", "eigen-lu");
    CAPTURE(aside, steps, name);
    auto [scene, tip] = make_imperfect_column(aside);
    scene.add(ancf::Force<2>(tip, {-load, 0.0}));
    ancf::StaticsOptions options;
    options.steps = steps;
    const auto report = ancf::solve_statics(scene, *ancf::solver_named(name), options);
    REQUIRE(report.status == Status::converged);
    CHECK(report.stability == ancf::Stability::stable);
    CHECK(scene.position(tip)[0] == Approx(0.123160).margin(1e-3));
    CHECK(scene.position(tip)[1] == Approx(std::copysign(0.803171, aside)).margin(1e-3));
}

TEST_CASE("statics: an imperfect square column bends along its push", "[statics]") {
    // shears of the section make the diagonal softer: bent along its y axis it is unstable too
    ancf::Model scene;
    const auto column = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
        scene, ancf::Material::isotropic(12e9, 0.3, 1000.0), ancf::rectangle(0.03, 0.03), {0, 0, 0},
        {1, 0, 0}, 8, ancf::CrossSectionOptions{ancf::Rule::mixed()});
    scene.clamp(column.first());
    const double load = 1.884841 * ancf::pi * ancf::pi / 4.0 * 12e9 * std::pow(0.03, 4) / 12.0;
    scene.add(ancf::Force<3>(column.last(), {-load, 1e-4 * load, 0.0}));
    ancf::StaticsOptions options;
    options.steps = GENERATE(1, 10);
    ancf::EigenLdlt solver;
    const auto report = ancf::solve_statics(scene, solver, options);
    REQUIRE(report.status == Status::converged);
    CHECK(report.stability == ancf::Stability::unstable);
    // the elastica, which is neither stretched nor sheared; the straight column is at (1, 0)
    CHECK(scene.position(column.last())[0] == Approx(0.123160).margin(0.01));  // 0.11904
    CHECK(scene.position(column.last())[1] == Approx(0.803171).margin(0.01));  // 0.80279
}

/// A clamped column in space, of steel and 1 m long, under a tip force in units of its E I.
std::pair<ancf::Model, ancf::NodeId> make_space_column(double width, double height, int elements,
                                                       const ancf::Vector<double, 3>& force) {
    ancf::Model scene;
    const auto column = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
        scene, ancf::Material::isotropic(2e11, 0.3, 7800.0), ancf::rectangle(width, height),
        {0, 0, 0}, {1, 0, 0}, elements, ancf::CrossSectionOptions{ancf::Rule::mixed()});
    scene.clamp(column.first());
    scene.add(ancf::Force<3>(column.last(), 2e11 * width * std::pow(height, 3) / 12.0 * force));
    return {std::move(scene), column.last()};
}

TEST_CASE("statics: a fall that begins with tiny corrections goes on", "[statics]") {
    // a load 2 % above that of buckling; the elastica whose tip has turned by 24 degrees
    const double turned = 24.0 * ancf::pi / 180.0;
    const double quarter = ancf::pi / 2.0 * 1.0110777;  // K(sin(turned / 2))
    const double load = quarter * quarter;
    auto [scene, tip] = make_space_column(8e-3, 1e-3, 12, {-load, 1e-8 * load, 0.0});
    ancf::StaticsOptions options;
    options.steps = GENERATE(1, 3, 10);
    const auto report = solve(scene, options);
    REQUIRE(report.status == Status::converged);
    CHECK(report.stability == ancf::Stability::stable);
    CHECK(scene.position(tip)[1] == Approx(2.0 * std::sin(turned / 2.0) / quarter).margin(1e-3));
}

TEST_CASE("statics: falls that fail leave parts of min_step at least", "[statics]") {
    // a square column falls too slowly beyond many bifurcations
    const double load = 5.0 * ancf::pi * ancf::pi / 4.0;
    auto [scene, tip] = make_space_column(0.01, 0.01, 12, {-load, 1e-8 * load, 0.0});
    ancf::StaticsOptions options;
    options.min_step = 0.6;
    const auto report = solve(scene, options);
    CHECK(report.status == Status::converged);
    CHECK(report.steps.size() == 3);  // the second is the fall
    for (const auto& step : report.steps) CHECK(step.factor == 1.0);
}

TEST_CASE("statics: loads without a potential take one fall that fails", "[statics]") {
    const double size = 0.02, bending = 2e11 * std::pow(size, 4) / 12.0;
    auto [scene, tip] = make_space_column(size, size, 16, {-20.0, 1.0, 2.0});
    scene.add(ancf::Moment(tip, {3.0 * bending, bending, bending}));
    const auto report = solve(scene);
    CHECK(report.status == Status::converged);
    // measured 278; with eight falls 1158, up to a factor of 0.58
    CHECK(report.iterations() <= 400);
}

TEST_CASE("statics: a moment that is gone does not hide that a column is unstable", "[statics]") {
    // bent by a moment in one step, let back in steps that turn little, then compressed
    ancf::PlanarModel scene;
    const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<2>>(
        scene, ancf::Material::isotropic(2e11, 0.3, 7800.0), ancf::rectangle(0.01, 0.01), {0, 0},
        {1, 0}, 16, ancf::CrossSectionOptions::best());
    const double bending = 2e11 * std::pow(0.01, 4) / 12.0;
    scene.clamp(beam.first());
    scene.add(ancf::PlanarSlopeMoment(beam.last(), Field::r_y, bending), [](double factor) {
        return factor < 0.01 ? 100.0 * factor : std::max(0.5 - factor, 0.0) / 0.49;
    });
    scene.add(ancf::Force<2>(beam.last(), {-4.0 * bending, 4e-5 * bending}),
              [](double factor) { return std::max(2.0 * factor - 1.0, 0.0); });
    ancf::StaticsOptions options;
    options.steps = 100;
    ancf::EigenLu solver;
    const auto report = ancf::solve_statics(scene, solver, options);
    REQUIRE(report.status == Status::converged);
    CHECK(report.stability == ancf::Stability::stable);
    CHECK(scene.position(beam.last())[1] > 0.8);  // it stayed straight, unstable
}

TEST_CASE("statics: a column that has fallen stays on the side where it is pushed", "[statics]") {
    const double degrees = GENERATE(88.0, 104.0, 120.0);  // a step ends 5 % above the buckling load
    const double turned = degrees * ancf::pi / 180.0;
    double a = 1.0, b = std::cos(turned / 2.0);  // to their arithmetic-geometric mean
    for (int k = 0; k < 6; ++k) b = std::sqrt(b * std::exchange(a, 0.5 * (a + b)));
    const double quarter = ancf::pi / (2.0 * a);  // K(sin(turned / 2))
    const double push = GENERATE(1e-4, 1e-6);
    CAPTURE(degrees, push);
    const double load = quarter * quarter;
    auto [scene, tip] = make_space_column(0.03, 0.01, 12, {-load, push * load, 0.0});
    ancf::StaticsOptions options;
    options.steps = 20;
    const auto report = solve(scene, options);
    REQUIRE(report.status == Status::converged);
    CHECK(report.stability == ancf::Stability::stable);
    CHECK(scene.position(tip)[1] == Approx(2.0 * std::sin(turned / 2.0) / quarter).margin(3e-3));
}

TEST_CASE("statics: an imperfect column bends where its end is pushed", "[statics]") {
    // the elastica whose tip has turned by 40 degrees: K(p) = 1.620026, E(p) = 1.523799
    const double x = 2.0 * 1.523799 / 1.620026 - 1.0, y = 2.0 * std::sin(ancf::pi / 9) / 1.620026;
    const double load = 1.620026 * 1.620026;
    const double aside = GENERATE(1e-3, -1e-5);
    const int steps = GENERATE(1, 3, 30, 100);
    CAPTURE(aside, steps);
    auto [scene, tip] = make_imperfect_column(aside);
    ancf::StaticsOptions options;
    options.steps = steps;
    const auto value = [x](double factor) { return 1.0 + factor * (x - 1.0); };
    double reaction = 0.0;
    SECTION("by a support") {
        scene.prescribe(tip, Field::r, 0, value);
        ancf::EigenLdlt solver;
        const auto report = ancf::solve_statics(scene, solver, options);
        REQUIRE(report.status == Status::converged);
        CHECK(report.stability == ancf::Stability::stable);
        reaction = report.reactions[scene.coordinate(tip, Field::r)];
    }
    SECTION("by a joint") {
        scene.add(ancf::FixedCoordinate<2>(
            tip, Field::r, 0,
            ancf::Motion{value, [x](double) { return x - 1.0; }, [](double) { return 0.0; }}));
        ancf::EigenLu solver;
        const auto report = ancf::solve_statics(scene, solver, options);
        REQUIRE(report.status == Status::converged);
        CHECK(report.stability == ancf::Stability::stable);
        reaction = -scene.state().multipliers[0];
    }
    CHECK(reaction == Approx(-load).epsilon(1e-3));
    CHECK(scene.position(tip)[1] == Approx(std::copysign(y, aside)).margin(1e-3));
}

TEST_CASE("statics: a column that a joint alone holds is judged like a clamped one",
          "[statics][stability]") {
    for (const double load : {0.9, 1.1}) {
        Scene welded = make_column(load);
        welded.add(ancf::Weld(welded, ancf::NodeId{0}));
        // the section's own stretch, which a weld leaves free, is stiff
        const auto report = solve(welded);
        REQUIRE(report.status == Status::converged);
        CHECK(report.stability ==
              (load < 1.0 ? ancf::Stability::stable : ancf::Stability::unstable));
        CHECK(to_string(report.stability) == (load < 1.0 ? "stable" : "unstable"));
        // said twice, the weld changes nothing
        welded.add(ancf::Weld(welded, ancf::NodeId{0}));
        ancf::Assembly assembly(welded, ancf::Storage::full);
        const ancf::State& at = welded.state();
        const ancf::VectorX rest = ancf::VectorX::Zero(at.q.size());
        REQUIRE_FALSE(
            assembly.evaluate({at.q, rest, at.multipliers, {1.0, 1.0}}, ancf::Request::tangent));
        CHECK(ancf::stability(assembly) == report.stability);
    }
}

TEST_CASE("statics: a joint that holds what pushes sideways is judged like a support",
          "[statics][stability]") {
    Chain chain = make_chain();  // of two bars that press on the node between them
    chain.release({1}, Field::r);
    for (const int sideways : {1, 2})
        chain.add(ancf::FixedCoordinate({1}, Field::r, sideways, 0.0));
    chain.add(ancf::Force({2}, {-5.0, 0.0, 0.0}));
    const auto report = solve(chain);
    REQUIRE(report.status == Status::converged);
    CHECK(report.stability == ancf::Stability::stable);
}

TEST_CASE("statics: stability stays open where nothing decides it", "[statics][stability]") {
    Scene floating = make_column(0.0);
    CHECK(solve(floating).stability == ancf::Stability::unknown);  // rigid motions cost nothing
    // nothing holds a pinned column from spinning about itself, whichever solver counts pivots
    Scene pinned = make_column(-1.0);
    pinned.pin({0});
    CHECK(solve(pinned).stability == ancf::Stability::unknown);
    ancf::EigenLdlt counts;
    CHECK(ancf::solve_statics(pinned, counts).stability == ancf::Stability::unknown);
    // a pressing follower: Beck's column never buckles, but its symmetric part does
    Scene light = make_column(0.0), heavy = make_column(0.0);
    for (auto [scene, load] : {std::pair(&light, 3.0), std::pair(&heavy, 300.0)}) {
        scene->clamp({0}, ancf::Clamp::full);
        scene->add(ancf::FollowerForce(last(*scene), {-load, 0.0, 0.0}));
    }
    CHECK(solve(light).stability == ancf::Stability::stable);
    CHECK(solve(heavy).stability == ancf::Stability::unknown);
    Scene broken = make_cantilever();
    broken.add(ancf::Force(last(broken), {0.0, 1e305, 0.0}));
    CHECK(solve(broken).stability == ancf::Stability::stable);  // the state kept: that at the start
}

TEST_CASE("statics: what a residual makes of a motion without stiffness is not called stable",
          "[statics][stability]") {
    // arcs between two points of the X axis, pulled along it, turn about it freely; of the 46 that
    // converge nine were stable and one unstable. The tangent of the last correction is not yet
    // that of the equilibrium: by its pivots, which two of these solvers count, 46 more were
    const std::string name = GENERATE("eigen-lu", "eigen-ldlt", "block-tridiagonal");
    const auto material = ancf::Material::isotropic(1e9, 0.3, 1000.0);
    constexpr double radius = 0.01;
    int converged = 0;
    for (int elements = 2; elements <= 9; ++elements)
        for (const double angle : {0.7, 1.3, 2.1})
            for (const double load : {3.0, 40.0}) {
                CAPTURE(name, elements, angle, load);
                const double cosine = std::cos(angle / 2.0), sine = std::sin(angle / 2.0);
                Scene scene;
                const auto arc = ancf::arc<ancf::TorsionBeam>(
                    scene, material, ancf::circle(radius), {0, 0, 0}, {cosine, -sine, 0},
                    {sine, cosine, 0}, 1.0 / angle, angle, elements);
                scene.pin(arc.first());
                scene.fix(arc.last(), Field::r, 1);
                scene.fix(arc.last(), Field::r, 2);
                const double bending = material.young * ancf::circle(radius).moments().yy;
                scene.add(ancf::Force<3>(arc.last(), {load * bending, 0, 0}));
                const auto solver = ancf::solver_named(name);
                const auto report = ancf::solve_statics(scene, *solver);
                if (report.status == Status::converged) ++converged;
                CHECK(report.stability == ancf::Stability::unknown);
            }
    CHECK(converged > 0);
}

TEST_CASE("statics: a scene at rest needs no iteration", "[statics]") {
    Scene scene = make_cantilever();
    const ancf::VectorX before = scene.state().q;
    const auto report = solve(scene);
    CHECK(report.status == Status::converged);
    CHECK(report.iterations() == 0);
    CHECK(scene.state().q == before);
}

TEST_CASE("statics: a free end at the origin is at rest without load, and under one on its support",
          "[statics]") {
    // the stresses' round-off there comes from the coordinates of the held end
    for (const double length : {0.5, 1.07, 1.3, 2.0})
        for (const double load : {0.0, 0.01}) {
            INFO("length " << length << ", load " << load);
            ancf::Model model;
            const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
                model, ancf::Material::isotropic(2.07e11, 0.3, 7850.0), ancf::circle(0.02),
                {-length, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1);
            model.clamp(beam.first());
            model.add(ancf::Force<3>(beam.first(), {load, 2.0 * load, 3.0 * load}));
            ancf::EigenLdlt solver;
            const auto report = ancf::solve_statics(model, solver);
            INFO(report.message);
            REQUIRE(report.status == Status::converged);
            CHECK(report.stability == ancf::Stability::stable);
            CHECK(model.position(beam.last()).norm() <= 1e-14);
            const auto foot =
                ancf::nodal_resultant(model, model.state().q, report.reactions, beam.first());
            CHECK(foot.force.norm() == Approx(std::sqrt(14.0) * load).margin(1e-6));
        }
}

TEST_CASE("statics: a cable of which a slope alone is free is at rest in every direction",
          "[statics]") {
    int checked = 0;
    for (double angle = 0.0; angle < 6.28; angle += 0.05) {
        INFO("angle " << angle);
        ancf::PlanarModel model;
        const ancf::Vector<double, 2> end(std::cos(angle), std::sin(angle));
        const auto cable = ancf::straight_beam<ancf::Cable<2>>(
            model, ancf::Material::isotropic(2.07e11, 0.3, 7850.0), ancf::rectangle(0.03, 0.04),
            {0.0, 0.0}, end, 1);
        model.pin(cable.first());
        model.clamp(cable.last());
        model.add(ancf::Force<2>(cable.last(), {0.0, 0.3}));
        ancf::EigenLdlt solver;
        const auto report = ancf::solve_statics(model, solver);
        INFO(report.message);
        CHECK(report.status == Status::converged);
        ++checked;
    }
    CHECK(checked == 126);
}

TEST_CASE("statics: what a load alone can hold is found where the load holds it", "[statics]") {
    using Rod = ancf::CrossSectionBeam<2>;
    const auto steel = ancf::Material::isotropic(2e11, 0.3, 7800.0);
    const auto section = ancf::rectangle(0.02, 0.02);
    ancf::EigenLu solver;
    SECTION("a pendulum hangs, from wherever it starts but upright") {
        const double angle = GENERATE(0.0, 0.1, 1.5, 3.0, ancf::pi);  // from the vertical
        CAPTURE(angle);
        ancf::PlanarModel model;
        const auto rod = ancf::straight_beam<Rod>(model, steel, section, {0, 0},
                                                  {std::sin(angle), -std::cos(angle)}, 4);
        model.pin(rod.first());
        model.set_gravity({0.0, -9.81});
        const auto report = solve_statics(model, solver);
        INFO(report.message);
        if (angle == ancf::pi) {
            CHECK(report.status == Status::singular);
            CHECK_THAT(report.message, ContainsSubstring("without stiffness moves r of node 4"));
            return;
        }
        REQUIRE(report.status == Status::converged);
        CHECK(report.steps.back().damped);
        CHECK(report.stability == ancf::Stability::stable);
        CHECK(report.held_by_loads);
        CHECK(std::abs(model.position(rod.last())[0]) < 1e-8);
        CHECK(model.position(rod.last())[1] == Approx(-1.0).epsilon(1e-6));
        CHECK(report.reactions[1] == Approx(7800.0 * 4e-4 * 9.81));
    }
    SECTION("a pendulum that hangs from the start is told beside a beam that supports hold") {
        ancf::PlanarModel model;
        const auto rod = ancf::straight_beam<Rod>(model, steel, section, {0, 0}, {0, -1}, 4);
        const auto beam = ancf::straight_beam<Rod>(model, steel, section, {1, 0}, {2, 0}, 4);
        model.pin(rod.first());
        model.pin(beam.first());
        model.fix(beam.last(), Field::r, 1);
        model.set_gravity({0.0, -9.81});
        const auto report = solve_statics(model, solver);
        INFO(report.message);
        REQUIRE(report.status == Status::converged);
        CHECK(report.stability == ancf::Stability::stable);
        CHECK(report.held_by_loads);
        model.fix(rod.last(), Field::r, 0);
        const auto held = solve_statics(model, solver);
        REQUIRE(held.status == Status::converged);
        CHECK_FALSE(held.held_by_loads);
    }
    SECTION("a double pendulum hangs") {
        ancf::PlanarModel model;
        const auto upper = ancf::straight_beam<Rod>(model, steel, section, {0, 0}, {1, 0}, 4);
        const auto lower = ancf::straight_beam<Rod>(model, steel, section, {1, 0}, {1.3, 0.4}, 2);
        model.pin(upper.first());
        model.add(ancf::Pin<2>(lower.first(), upper.last()));
        model.set_gravity({0.0, -9.81});
        const auto report = solve_statics(model, solver);
        INFO(report.message);
        REQUIRE(report.status == Status::converged);
        CHECK(report.stability == ancf::Stability::stable);
        CHECK(model.position(lower.last())[1] == Approx(-1.5).epsilon(1e-6));
    }
    SECTION("pendulums hang in space, from wherever they start") {
        const ancf::Vector<double, 3> start =
            GENERATE(ancf::Vector<double, 3>(0.28, 0.95, 0.13), ancf::Vector<double, 3>(1, 0, 0),
                     ancf::Vector<double, 3>(0.8, -0.6, 0), ancf::Vector<double, 3>(-0.5, 0.8, 0.9),
                     ancf::Vector<double, 3>(0.5, 0.2, -0.7));
        const int elements = GENERATE(1, 4), parts = GENERATE(1, 2);
        CAPTURE(start, elements, parts);
        const ancf::Vector<double, 3> end = start.normalized();
        const ancf::Vector<double, 3> lower = ancf::Vector<double, 3>(0, 0.7, 0) - 0.4 * end;
        const ancf::Vector<double, 3> axis = {-end[2], 0.0, end[0]};  // horizontal, across the rod
        ancf::Model model;
        const auto rod =
            ancf::straight_beam<ancf::TorsionBeam>(model, steel, section, {0, 0, 0}, end, elements);
        auto tip = rod.last();
        if (parts == 1) {
            model.pin(rod.first());
            model.fix(rod.first(), Field::r_y, 2);  // else it spins
        } else {
            const auto next = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
                model, steel, section, end, end + lower, elements);
            model.add(ancf::Revolute(model, rod.first(), axis));
            model.add(ancf::Revolute(model, tip, next.first(), axis));
            tip = next.last();
        }
        model.set_gravity({0.0, -9.81, 0.0});
        const auto report = solve_statics(model, solver);
        INFO(report.message);
        REQUIRE(report.status == Status::converged);
        CHECK(report.stability == ancf::Stability::stable);
        CHECK(report.held_by_loads);
        CHECK(std::abs(model.position(tip)[0]) < 1e-6);
        CHECK(model.position(tip)[1] ==
              Approx(-1.0 - (parts == 2 ? lower.norm() : 0.0)).epsilon(1e-5));
    }
    SECTION("thin pendulums hang, however little they lean") {
        const double lean = GENERATE(-0.016, 0.01, 0.02, 0.03, 0.05, 1e-4, 3e-7);  // of a radian
        const double radius = GENERATE(1e-4, 1e-3, 3e-3, 0.01);
        CAPTURE(lean, radius);
        ancf::Model model;
        const auto rod = ancf::straight_beam<ancf::TorsionBeam>(
            model, steel, ancf::circle(radius), {0, 0, 0}, {std::cos(lean), 0, -std::sin(lean)}, 1);
        model.add(ancf::Revolute(model, rod.first(), {0, 1, 0}));
        model.set_gravity({0.0, 0.0, -9.81});
        const auto report = solve_statics(model, solver);
        INFO(report.message);
        REQUIRE(report.status == Status::converged);
        CHECK(report.stability == ancf::Stability::stable);
        CHECK(report.held_by_loads);
        CHECK(report.iterations() < 60);
        CHECK(model.position(rod.last())[2] == Approx(-1.0).epsilon(1e-6));
    }
    SECTION("springs that a load draws hold aside") {
        ancf::PlanarModel model;
        const auto rod = ancf::straight_beam<Rod>(model, steel, section, {0, 0}, {1, 0}, 4);
        for (const int end : {0, 4})
            model.add(ancf::Spring<2>(rod.nodes[end], {end / 4.0, 0.5}, 2e4, 0.5));
        model.set_gravity({0.0, -9.81});
        const auto report = solve_statics(model, solver);
        INFO(report.message);
        REQUIRE(report.status == Status::converged);
        CHECK(report.stability == ancf::Stability::stable);
        CHECK(model.position(rod.first())[1] == Approx(-7800.0 * 4e-4 * 9.81 / 4e4));
    }
    SECTION("a mass hangs on a spring that has no stiffness across") {
        // one stiffness is 1e-11 of the rod's
        const double stiffness = GENERATE(0.5, 2000.0), size = stiffness < 1.0 ? 0.5 : 0.02;
        ancf::PlanarModel model;
        const auto rod =
            ancf::straight_beam<Rod>(model, steel, ancf::rectangle(size, size), {0, 0}, {1, 0}, 4);
        model.clamp(rod.first());
        const auto mass = model.add_node({1.0, -0.5});
        model.add_mass(mass, stiffness / 200.0);
        model.add(ancf::Spring<2>(mass, rod.last(), stiffness, 0.5));
        model.set_gravity({0.0, -9.81});
        const auto report = solve_statics(model, solver);
        INFO(report.message);
        REQUIRE(report.status == Status::converged);
        CHECK(report.held_by_loads);
        const double length = model.position(rod.last())[1] - model.position(mass)[1];
        CHECK(length == Approx(0.5 + 9.81 / 200.0).epsilon(1e-9));
    }
    SECTION("masses alone hang on a spring, on links, below and beside them") {
        // unit of length, m: whatever it is
        const double unit = GENERATE(1.0, 1e-9, 1e9),
                     angle = GENERATE(0.0, 0.1, 1.5, 0.5 * ancf::pi);
        const bool links = GENERATE(false, true);
        CAPTURE(unit, angle, links);
        const double weight = 3.0 * 9.81 * unit, stiffness = links ? 0.0 : 1000.0;
        const double x = std::sin(angle) * unit, y = -std::cos(angle) * unit;
        ancf::PlanarModel model;
        const auto mass = model.add_node({x, y});
        model.add_mass(mass, 3.0);
        if (links) {
            const auto second = model.add_node({2.0 * x, 2.0 * y});
            model.add_mass(second, 1.0);
            model.add(ancf::Distance<2>(mass, {0.0, 0.0}, unit));
            model.add(ancf::Distance<2>(second, mass, unit));
        } else {
            const auto hook = model.add_node({0.0, 0.0});
            model.add_mass(hook, 1.0);
            model.pin(hook);
            model.add(ancf::Spring<2>(mass, hook, stiffness, unit));
        }
        model.set_gravity({0.0, -9.81 * unit});
        const auto report = solve_statics(model, solver);
        INFO(report.message);
        REQUIRE(report.status == Status::converged);
        if (links) CHECK(report.held_by_loads);  // a spring may hold by round-off
        CHECK(report.stability == ancf::Stability::stable);
        const double length = unit + (links ? 0.0 : weight / stiffness);
        CHECK(model.position(mass)[1] == Approx(-length).epsilon(1e-9));
        CHECK(std::abs(model.position(mass)[0]) < 1e-6 * unit);
    }
    SECTION("a swing of three bodies hangs, whatever the unit of length") {
        const double unit = GENERATE(1.0, 1e-6, 1e6);
        const int steps = GENERATE(1, 4);
        CAPTURE(unit, steps);
        using Point = ancf::Vector<double, 3>;
        const double lean = 1.2;  // rad
        const Point arm = unit * Point(std::sin(lean), -std::cos(lean), 0.0);
        const Point across(0.7 * unit, 0.0, 0.0), axis(0.0, 0.0, 1.0);
        const Point corners[] = {Point(0.0, 0.0, 0.0), arm, arm + across, across};
        ancf::Model model;
        ancf::NodeId first[3], last[3];
        for (int k = 0; k < 3; ++k) {
            const Point middle = 0.5 * (corners[k] + corners[k + 1]);
            const auto body = model.add_node(middle);
            const double inertia = 0.1 * unit * unit;
            add_body(model, body, 1.0 + k, Point(inertia, inertia, inertia).asDiagonal());
            first[k] = point_of_body(model, body, corners[k]);
            last[k] = point_of_body(model, body, corners[k + 1]);
        }
        model.add(ancf::Revolute(model, first[0], axis));
        model.add(ancf::Universal(model, last[0], first[1], axis, {0, 1, 0}));
        model.add(ancf::Universal(model, last[1], first[2], axis, {1, 0, 0}));
        model.add(ancf::Pin<3>(last[2], corners[3]));
        model.set_gravity({0.0, -9.81 * unit, 0.0});
        ancf::StaticsOptions options;
        options.steps = steps;
        const auto report = solve_statics(model, solver, options);
        INFO(report.message);
        REQUIRE(report.status == Status::converged);
        CHECK(report.stability == ancf::Stability::stable);
        CHECK(report.held_by_loads);
        CHECK(std::abs(model.position(last[0])[0]) < 1e-5 * unit);
        CHECK(model.position(last[0])[1] == Approx(-unit).epsilon(1e-9));
    }
    SECTION("two bodies in a row fall between a support and a rod that at first rests") {
        using Point = ancf::Vector<double, 2>;
        const double lean = GENERATE(0.0, 0.3, 0.36, 0.4);  // of all, rad
        CAPTURE(lean);
        const auto at = [&](double x, double y) {
            return Point(x * std::cos(lean) + y * std::sin(lean),
                         y * std::cos(lean) - x * std::sin(lean));
        };
        ancf::PlanarModel model;
        ancf::NodeId first[2], last[2];
        for (int k = 0; k < 2; ++k) {
            const auto body = model.add_node(at(k + 0.5, 0.0));
            add_body(model, body, 1.0, 0.1);
            first[k] = point_of_body(model, body, at(k, 0.0));
            last[k] = point_of_body(model, body, at(k + 1.0, 0.0));
        }
        const auto rod = ancf::straight_beam<Rod>(model, ancf::Material::isotropic(2e11, 0.3, 1e-6),
                                                  section, at(2.0, 0.0), at(2.0, 1.0), 2);
        model.add(ancf::Pin<2>(first[0], at(0.0, 0.0)));
        model.add(ancf::Pin<2>(first[1], last[0]));
        model.add(ancf::Pin<2>(rod.first(), last[1]));
        model.add(ancf::Pin<2>(rod.last(), at(2.0, 1.0)));
        model.set_gravity({0.0, -9.81});
        const auto report = solve_statics(model, solver);
        INFO(report.message);
        REQUIRE(report.status == Status::converged);
        CHECK(report.stability == ancf::Stability::stable);
        CHECK(report.held_by_loads);
        CHECK(report.iterations() < 30);
        // links of length 1: heights of both bodies by the angle of the first, none where they part
        const auto height = [&](double angle) {
            const Point knee(std::cos(angle), std::sin(angle)), apart = at(2.0, 1.0) - knee;
            const double half = 0.5 * apart.norm(), off = std::sqrt(1.0 - half * half);
            const Point below(apart[1] / apart.norm() * off, -apart[0] / apart.norm() * off);
            return knee[1] + 0.5 * (knee + 0.5 * apart + below)[1];
        };
        double low = -1.5, high = -lean;
        for (int k = 0; k < 100; ++k) {
            const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
            if (height(a) < height(b))
                high = b;
            else
                low = a;
        }
        CHECK(model.position(last[0])[1] == Approx(std::sin(low)).epsilon(1e-5));
    }
    SECTION("what no load holds stays singular") {
        ancf::PlanarModel model;
        const auto rod = ancf::straight_beam<Rod>(model, steel, section, {0, 0}, {1, 0}, 4);
        for (const int end : {0, 4}) model.fix(rod.nodes[end], Field::r, 1);
        model.set_gravity({0.0, -9.81});
        const auto report = solve_statics(model, solver);
        CHECK(report.status == Status::singular);
        CHECK_THAT(report.message, ContainsSubstring("along x"));
    }
}

/// One that tells nothing of the condition, as the smallest of linear_solver.hpp.
class Blunt final : public ancf::LinearSolver {
public:
    [[nodiscard]] ancf::Storage storage() const noexcept override { return lu_.storage(); }
    void analyze(const ancf::SparseMatrix& matrix) override { lu_.analyze(matrix); }
    [[nodiscard]] ancf::FactorReport factorize(const ancf::SparseMatrix& matrix) override {
        return {lu_.factorize(matrix).status};
    }
    void solve(const ancf::VectorX& b, ancf::VectorX& x) const override { lu_.solve(b, x); }
    [[nodiscard]] std::string_view name() const noexcept override { return "blunt"; }

private:
    ancf::EigenLu lu_;
};

TEST_CASE("statics: with a solver that estimates no condition supports hold as well", "[statics]") {
    auto [scene, tip] = make_imperfect_column(10.0);
    Blunt solver;
    const auto report = ancf::solve_statics(scene, solver);
    REQUIRE(report.status == Status::converged);
    CHECK_FALSE(report.held_by_loads);
    CHECK(report.steps.size() == 1);
    CHECK(scene.position(tip)[1] == Approx(0.8106).margin(1e-3));  // the elastica
}

TEST_CASE("statics: no load holds a clamped beam, however slender", "[statics]") {
    const ancf::Vector<double, 3> along(0.6, -0.8, 0.0), across(0.8, 0.6, 0.0);
    const double radius = GENERATE(1e-3, 1e-5, 2e-6), load = GENERATE(10.0, 100.0);
    const auto section = ancf::circle(radius);
    CAPTURE(radius, load);
    ancf::EigenLu solver;
    ancf::Model model;
    const auto beam = ancf::straight_beam<ancf::TorsionBeam>(
        model, ancf::Material::isotropic(2e11, 0.3, 7800.0), section, {0, 0, 0}, along, 32);
    model.clamp(beam.first());
    const double force = load * 2e11 * section.moments().yy;  // N: 10 and 100 E I/L^2
    model.add(ancf::Force<3>(beam.last(), force * across));
    const auto report = solve_statics(model, solver);
    INFO(report.message);
    REQUIRE(report.status == Status::converged);
    CHECK_FALSE(report.held_by_loads);
    CHECK(report.iterations() < 15);  // 5 to 7
    // the elastica
    const double sideways = model.position(beam.last()).dot(across);
    CHECK(sideways == Approx(load < 50.0 ? 0.8106 : 0.9414).epsilon(1e-3));
}

TEST_CASE("statics: an empty model and a wholly held one are solved", "[statics]") {
    Chain empty;
    CHECK(solve(empty).status == Status::converged);
    Chain held = make_chain();
    for (int k = 0; k < 3; ++k) held.pin({k});
    held.add(ancf::Force({2}, {5.0, 0.0, 0.0}));
    const auto report = solve(held);
    CHECK(report.status == Status::converged);
    CHECK(report.reactions[6] == Approx(-5.0));
}

TEST_CASE("statics: failures are values and leave the last equilibrium", "[statics][bad-input]") {
    SECTION("a scene without supports is singular") {
        Scene scene;
        const auto material = ancf::Material::from_moduli(1e6, 4e5, 1000.0);
        const auto beam = ancf::straight_beam<ancf::ContinuumBeam<3>>(
            scene, material, ancf::rectangle(0.1, 0.2), {0, 0, 0}, {1, 0, 0}, 1);
        scene.add(ancf::Force(beam.last(), {0, 1, 0}));
        const ancf::VectorX before = scene.state().q;
        const auto report = solve(scene);
        CHECK(report.status == Status::singular);
        CHECK_THAT(report.message, ContainsSubstring("without stiffness moves r of node"));
        CHECK(scene.state().q == before);
        CHECK(report.factor == 0.0);
    }
    SECTION("what moves without stiffness is named, and so is a joint that repeats a support") {
        Chain chain = make_chain();
        chain.add(ancf::Force(ancf::NodeId{1}, {0.0, 1.0, 0.0}));
        std::string expected;
        SECTION("a motion") {
            chain.release({1}, Field::r);
            chain.fix({1}, Field::r, 2);
            expected = "a motion without stiffness moves r of node 1 most, along y";
        }
        SECTION("a joint") {
            chain.add(ancf::Pin<3>(ancf::NodeId{0}, {0.0, 0.0, 0.0}));
            expected = "constraints repeat each other or a support: constraint 0 (pin of node 0";
        }
        const auto report = solve(chain);
        REQUIRE(report.status == Status::singular);
        CHECK_THAT(report.message, ContainsSubstring(expected));
    }
    SECTION("a load of masses alone that is not a number after the first correction") {
        ancf::PlanarModel model;
        const auto mass = model.add_node({0.0, 1.0});
        model.add_mass(mass, 1.0);
        model.add(NaNBelow{mass});
        ancf::EigenLu solver;
        const auto report = ancf::solve_statics(model, solver);
        CHECK(report.status == Status::not_finite);
        CHECK(report.message == "the force of load 0 is not finite");
    }
    SECTION("a load that is not a number where the bound on iterations ends the run") {
        ancf::PlanarModel model;
        const auto mass = model.add_node({0.0, 1.0});
        model.add_mass(mass, 1.0);
        model.add(NaNBelow{mass, 2.0});
        ancf::EigenLu solver;
        ancf::StaticsOptions options;
        options.max_iterations = 2;
        const auto report = ancf::solve_statics(model, solver, options);
        CHECK(report.status == Status::not_finite);
        CHECK(report.steps.size() == 1);
        CHECK(report.fault.has_value());
    }
    SECTION("a load that is not a number") {
        Chain chain = make_chain();
        chain.add(ancf::Force({2}, {1.0, 0.0, 0.0}),
                  [](double) { return std::numeric_limits<double>::quiet_NaN(); });
        const auto report = solve(chain);
        CHECK(report.status == Status::not_finite);
        CHECK(report.message == "the force of load 0 is not finite");
    }
    SECTION("a link between points that coincide") {
        Chain chain = make_chain();
        chain.add(ancf::Pin<3>(ancf::NodeId{1}, {1.0, 0.0, 0.0}));
        chain.add(ancf::Distance<3>(ancf::NodeId{2}, {2.0, 0.0, 0.0}, 0.5));
        const auto report = solve(chain);
        CHECK(report.status == Status::not_finite);
        CHECK(report.message ==
              "the direction of constraint 1 (distance between node 2 and a point of space) is not "
              "finite: do points or directions coincide?");
    }
    SECTION("a moment about the slope it acts on") {
        Scene scene;
        const auto material = ancf::Material::from_moduli(1e6, 4e5, 1000.0);
        const auto beam = ancf::straight_beam<ancf::ContinuumBeam<3>>(
            scene, material, ancf::rectangle(0.1, 0.2), {0, 0, 0}, {1, 0, 0}, 1);
        scene.clamp(beam.first());
        scene.add(ancf::SlopeMoment(beam.last(), Field::r_z, {0, 0, 2}, 1.0));
        const ancf::VectorX before = scene.state().q;
        const auto report = solve(scene);
        CHECK(report.status == Status::not_finite);
        CHECK(report.message == "the force of load 0 is not finite");
        CHECK(scene.state().q == before);
    }
    SECTION("a slope of no length") {
        Scene scene = make_cantilever();
        scene.set_value({1}, Field::r_y, {0, 0, 0});
        scene.fix({1}, Field::r_y);
        const auto report = solve(scene);
        CHECK(report.status == Status::degenerate);
        REQUIRE(report.fault);
        CHECK(report.fault->element == 0);
        CHECK(report.message == "element 0 of the type ContinuumBeam<3> is degenerate");
    }
    SECTION("too few iterations") {
        Scene scene = make_cantilever();
        scene.add(ancf::Force(last(scene), {0.0, 20.0, -10.0}));
        ancf::StaticsOptions options;
        options.max_iterations = 2;
        const auto report = solve(scene, options);
        CHECK(report.status == Status::max_iterations);
        CHECK(report.iterations() == 2);
        CHECK_THAT(report.message,
                   ContainsSubstring("the step to load factor 1 failed after 2 iterations, the "
                                     "last relative residual was "));
    }
}

TEST_CASE("statics: a load or a state of the wrong size is refused", "[statics][bad-input]") {
    struct Resizing {
        ancf::Coupling coupling() const { return {{{2}, Field::r}}; }
        void evaluate(const ancf::LoadState&, ancf::LoadResult& out) const { out.force.resize(2); }
    };
    Chain chain = make_chain();
    chain.add(Resizing{});
    CHECK_THROWS_WITH(solve(chain), ContainsSubstring("3 coordinates"));
    Chain short_state = make_chain();
    short_state.state().q.conservativeResize(4);
    CHECK_THROWS_WITH(solve(short_state), ContainsSubstring("4 coordinates"));
}

TEST_CASE("statics: options that cannot be meant are refused", "[statics][bad-input]") {
    Chain chain = make_chain();
    const auto refused = [&](auto change) {
        ancf::StaticsOptions options;
        change(options);
        ancf::EigenLu solver;
        CHECK_THROWS_AS(ancf::solve_statics(chain, solver, options), ancf::InvalidArgument);
    };
    refused([](auto& o) { o.steps = 0; });
    refused([](auto& o) { o.max_iterations = 0; });
    refused([](auto& o) { o.residual_tolerance = 0.0; });
    refused([](auto& o) { o.correction_tolerance = -1.0; });
    refused([](auto& o) { o.min_step = std::numeric_limits<double>::quiet_NaN(); });
    refused([](auto& o) { o.first_factor = std::numeric_limits<double>::infinity(); });
    refused([](auto& o) { o.last_factor = 0.0; });
    ancf::StaticsOptions nowhere;
    nowhere.last_factor = 0.0;
    CHECK_THROWS_WITH(solve(chain, nowhere), ContainsSubstring("set first_factor one lower"));
}

TEST_CASE("statics: a link more than a point needs is seen through round-off", "[statics]") {
    ancf::test::Random random(1);
    for (int trial = 0; trial < 200; ++trial) {
        CAPTURE(trial);
        ancf::Model model;
        const ancf::Vector<double, 3> place = random.vector<3>();
        const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
            model, ancf::Material::isotropic(2e9, 0.3, 8000.0), ancf::rectangle(0.02, 0.02),
            random.vector<3>(), place, 1 + trial % 3);
        model.clamp(beam.first());
        const int links = 3 + trial % 2;
        for (int k = 0; k < links; ++k) {
            const ancf::Vector<double, 3> far = random.vector<3>();
            model.add(ancf::Distance<3>(beam.last(), far, (place - far).norm()));
        }
        model.add(ancf::Force<3>(beam.last(), {0.1, -0.5, 0.3}));
        ancf::EigenLu solver;
        const auto report = ancf::solve_statics(model, solver);
        if (links == 3) {
            CHECK(report.status == Status::converged);
            continue;
        }
        CHECK(report.status == Status::singular);
        CHECK_THAT(report.message,
                   ContainsSubstring("constraints repeat each other or a support: constraint 3"));
        CHECK(ancf::follow_path(model, solver).status == Status::singular);
    }
}

TEST_CASE("statics: a joint to the ground holds far from the origin as beside it", "[statics]") {
    for (const bool link : {false, true})
        for (const double far : {0.0, 1e3, 1e4}) {
            CAPTURE(link, far);
            Scene scene;
            const auto beam = ancf::straight_beam<ancf::CrossSectionBeam<3>>(
                scene, ancf::Material::isotropic(2e11, 0.3, 7800.0), ancf::rectangle(0.02, 0.01),
                {far, 0, -far}, {far + 0.6, 0.5, -far - 0.4}, 3);
            scene.clamp(beam.first());
            const ancf::Vector<double, 3> end = scene.position(beam.last());
            if (link)
                scene.add(ancf::Distance<3>(beam.last(), {end[0], end[1] + 1.0, end[2]}, 1.0));
            else
                scene.add(
                    ancf::PointOnLine<3>(beam.last(), {end[0], end[1], end[2]}, {0.3, 0.4, 0.8}));
            scene.add(ancf::Force<3>(beam.node(2), {100, -50, 30}));
            const auto report = solve(scene);
            CHECK(report.status == Status::converged);
            CHECK(report.iterations() < 10);  // measured: at most 4
        }
}

}  // namespace statics_test
