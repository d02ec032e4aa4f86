// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What turning makes of the tangent, and the iterations that the default takes with it.

#include <ancf/assembly/assembly.hpp>
#include <ancf/constants.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/solver/eigen_lu.hpp>
#include <ancf/solver/statics.hpp>
#include <ancf/solver/turning.hpp>

#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace turning_scenes_test {

using namespace ancf;
using test::Random;

using Green = CrossSectionBeam<3, Geodesic>;
using Engineering = CrossSectionBeam<3, Geodesic, LinearShear, EngineeringMeasure>;
using Continuum = ContinuumBeam<3>;
using Point = Vector<double, 3>;

template <class Element>
typename Element::Options options() {
    if constexpr (std::is_same_v<Element, Continuum> || std::is_same_v<Element, Cable<3>>)
        return {};
    else
        return Element::Options::best();
}

/// Nodes whose frames and positions are drawn, in a chain or a loop; the first may be clamped.
void connect(Model& scene, Random& random, int nodes, bool loop, bool clamped) {
    const int prototype = scene.add_prototype(Green(
        Material::isotropic(1e3, 0.3, 1.0), rectangle(0.1, 0.2), 1.0, Green::Options::best()));
    std::vector<NodeId> all;
    for (int k = 0; k < nodes; ++k) {
        const double angle = 2.0 * pi * k / nodes;
        const Point at = Point(std::cos(angle), std::sin(angle), 0.0) + 0.3 * random.vector<3>();
        Matrix<double, 3> slopes = test::rotation(Point(2.0 * random.vector<3>()));
        for (int j = 0; j < 3; ++j) slopes.col(j) += 0.2 * random.vector<3>();
        all.push_back(scene.add_node(at, slopes));
    }
    for (int k = 0; k + 1 < nodes; ++k) scene.connect<Green>(prototype, all[k], all[k + 1]);
    if (loop) scene.connect<Green>(prototype, all.back(), all.front());
    if (clamped) scene.clamp(all.front());
}

/// Second differences of residual . q(x), where q(x) is a correction that turns.
class Work {
public:
    Work(const Model& scene, const Numbering& numbering, const VectorX& residual, TurnBy by)
        : before_(scene.state().q),
          numbering_(numbering),
          residual_(residual),
          turning_(scene, numbering),
          by_(by) {}

    /// Returns x . d2/dx2 . y by central differences of fourth order.
    double second(const VectorX& x, const VectorX& y, double h) {
        return (4.0 * coarse(x, y, h) - coarse(x, y, 2.0 * h)) / 3.0;
    }

private:
    double coarse(const VectorX& x, const VectorX& y, double h) {
        const VectorX p = h * (x + y), m = h * (x - y);
        return (along(p) - along(m) - along(-m) + along(-p)) / (4.0 * h * h);
    }

    double along(const VectorX& x) {
        VectorX q = before_;
        numbering_.add_free(x, 1.0, q);
        const VectorX change = q - before_;
        turning_.turn(before_, change, q, by_);
        double sum = 0.0;
        for (int k = 0; k < q.size(); ++k)
            if (const int equation = numbering_.equation(k); equation >= 0)
                sum += residual_[equation] * (q[k] - before_[k]);
        return sum;
    }

    VectorX before_;
    const Numbering& numbering_;
    VectorX residual_;
    Turning turning_;
    TurnBy by_;
};

TEST_CASE("Turning: the curvature of chains and loops equals differences", "[statics][turning]") {
    int compared = 0;
    for (const bool loop : {false, true})
        for (const bool clamped : {false, true})
            for (std::uint64_t seed = 0; seed < 4; ++seed) {
                INFO("loop " << loop << ", clamped " << clamped << ", seed " << seed);
                Random random(seed);
                Model scene;
                connect(scene, random, 5, loop, clamped);
                Assembly assembly(scene, Storage::full);
                const Numbering& numbering = assembly.numbering();
                const int size = numbering.unknowns();
                const VectorX residual = random.vector(size), x = random.vector(size),
                              y = random.vector(size);
                SparseMatrix curvature = assembly.tangent();
                std::fill_n(curvature.valuePtr(), curvature.nonZeros(), 0.0);
                Turning turning(scene, numbering);
                turning.add_curvature(scene.state().q, residual, assembly.tangent(),
                                      curvature.valuePtr());
                const double scale = curvature.norm() * x.norm() * y.norm();
                REQUIRE(scale > 1.0);
                CHECK((curvature * x - curvature.transpose() * x).norm() <=
                      1e-14 * curvature.norm() * x.norm());
                // both ways of turning agree to second order
                for (const TurnBy by : {TurnBy::angle, TurnBy::tangent}) {
                    Work work(scene, numbering, residual, by);
                    CHECK(x.dot(curvature * y) ==
                          Approx(work.second(x, y, 2e-3)).margin(1e-7 * scale));
                    CHECK(x.dot(curvature * x) ==
                          Approx(work.second(x, x, 2e-3)).margin(1e-7 * scale));
                    ++compared;
                }
            }
    CHECK(compared == 32);
}

TEST_CASE("Turning: half a pattern gets the lower half; without chords, slopes alone",
          "[statics][turning]") {
    Random random(7);
    Model scene;
    connect(scene, random, 5, true, true);
    Assembly whole(scene, Storage::full), half(scene, Storage::lower);
    const VectorX residual = random.vector(whole.numbering().unknowns());
    const auto added = [&](const Assembly& to, bool chords) {
        SparseMatrix sum = to.tangent();
        std::fill_n(sum.valuePtr(), sum.nonZeros(), 0.0);
        Turning turning(scene, to.numbering());
        turning.add_curvature(scene.state().q, residual, to.tangent(), sum.valuePtr(), chords);
        return MatrixX(sum);
    };
    const MatrixX all = added(whole, true), slopes = added(whole, false);
    CHECK(added(half, true) == MatrixX(all.triangularView<Eigen::Lower>()));
    CHECK((all - slopes).norm() > 1e-2 * all.norm());
    const Numbering& numbering = whole.numbering();
    int positions = 0;
    for (int k = 0; k < numbering.coordinates(); ++k) {
        const int equation = numbering.equation(k);
        if (equation < 0 || k % 12 >= 3) continue;  // 12 coordinates a node, its position first
        ++positions;
        CHECK(slopes.row(equation).norm() == 0.0);
        CHECK(all.row(equation).norm() > 0.0);
    }
    CHECK(positions == 12);  // of four nodes that move
}

TEST_CASE("Assembly: without a correction the predicted residual is the residual",
          "[statics][turning]") {
    Random random(3);
    Model scene;
    connect(scene, random, 4, false, true);
    Assembly assembly(scene, Storage::full);
    const VectorX q = scene.state().q, rest = VectorX::Zero(q.size());
    const auto predicted = [&](const Correction& last) {
        VectorX own, foreseen;
        REQUIRE_FALSE(
            assembly.evaluate({q, rest, VectorX(), {1.0, 1.0}}, Request::tangent, nullptr, &last));
        assembly.residual(own);
        assembly.predicted_residual(foreseen);
        return (foreseen - own).norm() / own.norm();
    };
    Correction none;
    none.before = q;
    none.change = rest;
    CHECK(predicted(none) <= 1e-13);
    Correction some = none;
    some.before = q + 0.1 * random.vector(static_cast<int>(q.size()));
    some.change = q - some.before;
    CHECK(predicted(some) >= 1e-4);
}

/// Returns a cantilever of 32 elements, length 1, E I = 1.
template <class Element>
NodeId cantilever(Model& scene, double height) {
    const auto beam = straight_beam<Element>(
        scene, Material::isotropic(12.0 / std::pow(height, 4), 0.3, 1.0), rectangle(height, height),
        {0, 0, 0}, {1, 0, 0}, 32, options<Element>());
    const bool shears = !std::is_same_v<Element, TorsionBeam> && !std::is_same_v<Element, Cable<3>>;
    scene.clamp(beam.first(), shears ? Clamp::free_slope : Clamp::full);
    return beam.last();
}

TEMPLATE_TEST_CASE("statics: one default step off the axes closes a thick circle in few iterations",
                   "[statics][turning]", Green, Engineering, TorsionBeam, Continuum) {
    Model scene;
    const NodeId end = cantilever<TestType>(scene, 1.0 / 28.0);
    scene.add(Moment(end, 2.0 * pi * Point(0.0, -std::sin(0.7), std::cos(0.7))));
    EigenLu solver;
    const auto report = solve_statics(scene, solver);
    REQUIRE(report.status == Status::converged);
    CHECK(report.steps.size() == 1);
    CHECK(report.iterations() <=
          8);  // measured 5, 4, 4 and 5; without the turn's tangent it is cut
}

TEST_CASE("statics: a torque and a force bend a thick beam in as few iterations on any mesh",
          "[statics][turning]") {
    for (const int elements : {4, 32, 256}) {
        CAPTURE(elements);
        Model scene;
        const auto beam = straight_beam<Engineering>(
            scene, Material::isotropic(12.0 / std::pow(0.2, 4), 0.3, 1.0), rectangle(0.2, 0.2),
            {0, 0, 0}, {1, 0, 0}, elements, options<Engineering>());
        scene.clamp(beam.first(), Clamp::free_slope);
        scene.add(Moment(beam.last(), {0.7, 0.0, 0.0}));
        scene.add(Force<3>(beam.last(), {0.0, 1.0, 0.7}));
        EigenLu solver;
        const auto report = solve_statics(scene, solver);
        REQUIRE(report.status == Status::converged);
        CHECK(report.iterations() <= 7);  // 5, 5 and 6; where all slopes turn alike 22 at last
    }
}

TEMPLATE_TEST_CASE("statics: one default step bends a beam off its axes by a hundred E I/L^2",
                   "[statics][turning]", Engineering, TorsionBeam, Cable<3>) {
    for (const double height : {1e-2, 1e-3}) {
        INFO(height);
        Model scene;
        const NodeId end = cantilever<TestType>(scene, height);
        scene.add(Force<3>(end, 100.0 * Point(0.0, std::cos(0.6), std::sin(0.6))));
        EigenLu solver;
        const auto report = solve_statics(scene, solver);
        REQUIRE(report.status == Status::converged);
        CHECK(report.steps.size() == 1);
        CHECK(report.iterations() <= 10);  // measured 6, 6 and 7
        CHECK(report.stability == Stability::stable);
    }
}

TEST_CASE("statics: one default step bends a quintic beam however slender", "[statics][turning]") {
    for (const double height : {1e-3, 1e-4, 1e-5, 1e-6})
        for (const int elements : {4, 16, 64}) {
            CAPTURE(height, elements);
            Model scene;
            const auto beam = straight_beam<QuinticBeam<>>(
                scene, Material::isotropic(12.0 / std::pow(height, 4), 0.25, 1.0),
                rectangle(height, height), {0, 0, 0}, {1, 0, 0}, elements);
            scene.clamp(beam.first(), Clamp::free_slope);
            scene.add(Force<3>(beam.last(), {0.0, 10.0, 0.0}));
            EigenLu solver;
            const auto report = solve_statics(scene, solver);
            REQUIRE(report.status == Status::converged);
            CHECK(report.steps.size() == 1);
            CHECK(report.iterations() <= 15);  // measured 6 to 14; 70 with rates that do not turn
        }
}

/// Solves a random cantilever, straight or an arc, E I = 1, and returns the report.
template <class Element>
StaticsReport solve_random(Random& random) {
    Model scene;
    const double height = std::pow(10.0, random.uniform(-3.0, -1.0)),
                 width = height * random.uniform(1.0, 3.0);
    const auto material = Material::isotropic(12.0 / (width * std::pow(height, 3)), 0.3, 1.0);
    const auto section = rectangle(width, height);
    const int elements = 8 + 4 * static_cast<int>(random.uniform(0.0, 3.0));
    const auto best = options<Element>();
    const double angle = random.uniform(0.2, 1.5);
    const auto beam = random.uniform(0.0, 1.0) < 0.4
                          ? arc<Element>(scene, material, section, {0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                         1.0 / angle, angle, elements, best)
                          : straight_beam<Element>(scene, material, section, {0, 0, 0}, {1, 0, 0},
                                                   elements, best);
    scene.clamp(beam.first(), Clamp::free_slope);
    const double force = std::pow(10.0, random.uniform(-0.3, 1.5)),
                 moment = random.uniform(0.3, 4.0), loads = random.uniform(0.0, 4.0);
    if (loads < 3.0) scene.add(Force<3>(beam.last(), force * Point(random.direction<3>())));
    if (loads >= 2.0) scene.add(Moment(beam.last(), moment * Point(random.direction<3>())));
    EigenLu solver;
    return solve_statics(scene, solver);
}

/// Solves forty random cantilevers, one call each; returns the iterations in ascending order.
template <class Even, class Odd>
std::vector<int> solve_forty(int& one_step) {
    std::vector<int> iterations;
    one_step = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        INFO("seed " << seed);
        Random random(seed);
        const auto report = seed % 2 == 0 ? solve_random<Even>(random) : solve_random<Odd>(random);
        CHECK(report.status == Status::converged);
        iterations.push_back(report.iterations());
        if (report.steps.size() == 1) ++one_step;
    }
    std::sort(iterations.begin(), iterations.end());
    return iterations;
}

TEST_CASE("statics: one call solves forty random cantilevers, most of them in few iterations",
          "[statics][turning]") {
    int one_step = 0;
    const std::vector<int> iterations = solve_forty<Green, Engineering>(one_step);
    CAPTURE(iterations);
    CHECK(iterations[20] <= 8);      // measured 6
    CHECK(iterations[36] <= 30);     // measured 18
    CHECK(iterations.back() <= 60);  // measured 23
    CHECK(one_step >= 24);           // measured 32
}

TEST_CASE("statics: one call solves forty random cantilevers of continuum beams",
          "[statics][turning]") {
    int one_step = 0;
    const std::vector<int> iterations = solve_forty<Continuum, Continuum>(one_step);
    CAPTURE(iterations);
    CHECK(iterations[20] <= 9);      // measured 7; plain takes some twenty
    CHECK(iterations[36] <= 30);     // measured 13
    CHECK(iterations.back() <= 60);  // measured 28
    CHECK(one_step >= 32);           // measured 38
}

TEST_CASE("statics: a straight rope between pins takes one call", "[statics][turning]") {
    std::vector<int> iterations;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        INFO("seed " << seed);
        Random random(seed);
        Model scene;
        const double height = std::pow(10.0, random.uniform(-3.0, -1.0));
        const auto rope = straight_beam<Cable<3>>(
            scene, Material::isotropic(12.0 / std::pow(height, 4), 0.3, 1.0),
            rectangle(height, height), {0, 0, 0}, {1, 0, 0}, 16);
        scene.pin(rope.first());
        scene.pin(rope.last());
        const Point force =
            std::pow(10.0, random.uniform(-0.3, 1.5)) * Point(random.direction<3>());
        if (seed % 2 == 0)
            scene.add(Force<3>(rope.node(5), force));
        else
            add_line_load(scene, rope, force);
        EigenLu solver;
        const auto report = solve_statics(scene, solver);
        CHECK(report.status == Status::converged);
        iterations.push_back(report.iterations());
    }
    std::sort(iterations.begin(), iterations.end());
    CAPTURE(iterations);
    CHECK(iterations[20] <= 9);      // measured 7
    CHECK(iterations.back() <= 25);  // measured 18
}

TEST_CASE("statics: a line that hangs loose is iterated plainly", "[statics][turning]") {
    // an unstretched arc under its weight, E A = 1e6 and E I = 1e-6 weights
    Moments moments;
    moments.area = 1.0;
    moments.yy = moments.zz = 1e-12;
    const double radius = 0.6, half = std::asin(0.5 / radius);
    PlanarModel scene;
    const auto chain =
        arc<Cable<2>>(scene, Material::isotropic(1e6, 0.3, 1.0), Section::from_moments(moments),
                      {0, 0}, {std::cos(half), -std::sin(half)}, radius, 2.0 * half, 16);
    scene.pin(chain.first());
    scene.pin(chain.last());
    scene.set_gravity(Vector<double, 2>(0.0, -1.0));
    EigenLu solver;
    const auto report = solve_statics(scene, solver);
    REQUIRE(report.status == Status::converged);
    REQUIRE(report.steps.size() == 2);
    CHECK(report.steps[0].iterations == 1);
    CHECK(report.steps[1].newton == NewtonKind::plain);
}

TEST_CASE("statics: a step under force and moment that ends on another branch is taken again",
          "[statics][turning]") {
    // a force that pushes the beam back, and a moment, which has no potential: the pivots of the
    // symmetric part tell nothing, the softest motions do
    const double across = 14.0 * std::sin(2.8), along = 14.0 * std::cos(2.8);
    int rejected = 0;
    for (const Point& moment : {Point(0, 2, 0), Point(0, 0, -2)}) {
        Model once, slowly;
        for (Model* scene : {&once, &slowly}) {
            const auto beam = straight_beam<Green>(
                *scene, Material::isotropic(12.0 / std::pow(0.02, 4), 0.3, 1.0),
                rectangle(0.02, 0.02), {0, 0, 0}, {1, 0, 0}, 16, Green::Options::best());
            scene->clamp(beam.first(), Clamp::free_slope);
            scene->add(Force<3>(beam.last(), {along, 0.8 * across, 0.6 * across}));
            scene->add(Moment(beam.last(), moment));
        }
        EigenLu solver;
        const auto report = solve_statics(once, solver);
        StaticsOptions steps;
        steps.newton = NewtonKind::plain;
        steps.steps = 60;
        steps.adaptive = true;
        REQUIRE(solve_statics(slowly, solver, steps).status == Status::converged);
        REQUIRE(report.status == Status::converged);
        for (const auto& step : report.steps) rejected += step.status == Status::diverged ? 1 : 0;
        // what the tolerances of both leave
        CHECK((once.state().q - slowly.state().q).lpNorm<Eigen::Infinity>() <= 1e-5);
    }
    CHECK(rejected > 0);
}

/// Clamped at both ends, of span 1; its path ends at a quarter to nine tenths of the loads below.
std::pair<Model, NodeId> make_shallow_arch(double load) {
    Model scene;
    const double half = 0.25, radius = 0.5 / std::sin(half);
    const auto beam = arc<Engineering>(
        scene, Material::isotropic(12.0 / std::pow(0.01, 4), 0.3, 1.0), rectangle(0.01, 0.01),
        {0, 0, 0}, {std::cos(half), std::sin(half), 0}, {std::sin(half), -std::cos(half), 0},
        radius, 2.0 * half, 16, Engineering::Options::best());
    scene.clamp(beam.first(), Clamp::free_slope);
    scene.clamp(beam.last(), Clamp::free_slope);
    const NodeId crown = beam.nodes[8];
    scene.add(Force<3>(crown, {0, -load, 0}));
    return {std::move(scene), crown};
}

TEST_CASE("statics: a shallow arch snaps through in one call", "[statics][turning]") {
    for (const double load : {20.0, 50.0}) {
        INFO("load " << load);
        auto [scene, crown] = make_shallow_arch(load);
        CHECK(scene.position(crown)[1] > 0.06);
        EigenLu solver;
        const auto report = solve_statics(scene, solver);
        CHECK(report.status == Status::converged);
        CHECK(report.stability == Stability::stable);
        CHECK(scene.position(crown)[1] < -0.04);  // measured -0.042 and -0.054
        REQUIRE_FALSE(report.steps.empty());
        CHECK(report.steps.back().damped);
        CHECK(report.iterations() <= 60);  // measured 30 and 40
    }
}

TEST_CASE("statics: a shallow arch snaps through in several steps", "[statics][turning]") {
    const double load = GENERATE(15.0, 20.0, 30.0, 50.0, 80.0);
    StaticsOptions options;
    options.steps = GENERATE(3, 10);
    CAPTURE(load, options.steps);
    auto [scene, crown] = make_shallow_arch(load);
    EigenLu solver;
    const auto report = solve_statics(scene, solver, options);
    CHECK(report.status == Status::converged);
    CHECK(report.stability == Stability::stable);
    CHECK(scene.position(crown)[1] < -0.038);
    CHECK(report.iterations() <= 200);  // 41 to 154 measured
}

TEST_CASE("statics: slopes stand where supports hold or drive them", "[statics][turning]") {
    const auto steel = Material::isotropic(2e11, 0.3, 7800.0);
    for (const int steps : {1, 4}) {
        INFO(steps << " load steps");
        Model scene;
        const auto beam = straight_beam<Green>(scene, steel, rectangle(0.01, 0.01), {0, 0, 0},
                                               {1, 0, 0}, 8, options<Green>());
        scene.clamp(beam.first());
        const NodeId tip = beam.last();  // turned by one radian about Z
        scene.prescribe(tip, Field::r_y, 0, [](double factor) { return -std::sin(factor); });
        scene.prescribe(tip, Field::r_y, 1, [](double factor) { return std::cos(factor); });
        scene.fix(tip, Field::r_y, 2);
        scene.fix(tip, Field::r_z);
        StaticsOptions by_steps;
        by_steps.steps = steps;
        EigenLu solver;
        const auto report = solve_statics(scene, solver, by_steps);
        REQUIRE(report.status == Status::converged);
        CHECK(scene.value(tip, Field::r_y) == Point(-std::sin(1.0), std::cos(1.0), 0.0));
        // E I/2 of an arc of one radian; measured 1.5e-5 off, turned with the rest 540 times it
        CHECK(report.strain_energy == Approx(2e11 * 1e-8 / 24.0).epsilon(1e-4));
    }
    Model scene;
    const auto beam = straight_beam<Green>(scene, steel, rectangle(0.01, 0.01), {0, 0, 0},
                                           {1, 0, 0}, 8, options<Green>());
    scene.clamp(beam.first());
    scene.fix(beam.last(), Field::r_y, 1);  // of three components this one alone
    scene.add(Force<3>(beam.last(), {0, 500, 0}));
    EigenLu solver;
    CHECK(solve_statics(scene, solver).status == Status::converged);
    CHECK(scene.value(beam.last(), Field::r_y)[1] == 1.0);
}

TEST_CASE("statics: an arch whose ends alone are driven together bends and is not crushed",
          "[statics][turning]") {
    const bool joint = GENERATE(false, true);
    for (const int elements : {8, 16}) {
        INFO(elements << " elements, " << (joint ? "a joint" : "a support") << " drives them");
        PlanarModel scene;
        const double half = 0.04, radius = 0.5 / std::sin(half);  // of span 1
        const auto beam = arc<CrossSectionBeam<2>>(
            scene, Material::isotropic(2e11, 0.3, 7800.0), rectangle(0.02, 0.005), {0, 0},
            {std::cos(half), std::sin(half)}, radius, -2.0 * half, elements,
            CrossSectionOptions::best());
        scene.pin(beam.first());
        const auto inwards = [](double factor) { return -0.3 * factor; };
        if (joint) {
            const Motion motion{inwards, [](double) { return -0.3; }, [](double) { return 0.0; }};
            scene.add(Driven(Pin<2>(beam.last(), {1, 0}), {{0, motion}}));
        } else {
            scene.fix(beam.last(), Field::r, 1);
            scene.prescribe(beam.last(), Field::r, 0,
                            [&](double factor) { return 1.0 + inwards(factor); });
        }
        EigenLu solver;
        const auto report = solve_statics(scene, solver);
        REQUIRE(report.status == Status::converged);
        CHECK(report.stability == Stability::stable);
        CHECK(scene.position(beam.node(elements / 2))[1] == Approx(0.314).epsilon(1e-3));
    }
}

TEMPLATE_TEST_CASE("statics: few quintic elements roll up in few iterations", "[statics][turning]",
                   QuinticBeam<>, PlanarQuinticBeam<>) {
    constexpr int dimension = TestType::dimension;
    using Place = Vector<double, dimension>;
    const auto roll_up = [](int elements, double circles, int& iterations) {
        BasicModel<dimension> scene;
        const auto beam = straight_beam<TestType>(
            scene, Material::isotropic(2e11, 0.3, 7800.0), rectangle(0.01, 0.01),
            Place(Place::Zero()), Place(Place::Unit(0)), elements, TestType::Options::best());
        scene.clamp(beam.first(), Clamp::free_slope);
        const double moment = 2.0 * pi * circles * 2e11 * std::pow(0.01, 4) / 12.0;
        if constexpr (dimension == 2)
            scene.add(PlanarSlopeMoment(beam.last(), Field::r_y, moment));
        else
            scene.add(SlopeMoment(beam.last(), Field::r_y, {0, 0, 1}, moment));
        EigenLu solver;
        const auto report = solve_statics(scene, solver);
        REQUIRE(report.status == Status::converged);
        iterations = report.iterations();
        return Place(scene.position(beam.last()));
    };
    const std::vector<std::pair<int, double>> cases = {{2, 0.5}, {3, 0.5}, {4, 1.0}, {8, 2.0}};
    for (const auto& [elements, circles] : cases) {
        INFO(elements << " elements, " << circles << " circles");
        int iterations = 0, fine = 0;
        const Place tip = roll_up(elements, circles, iterations);
        CHECK(iterations <= 8);  // measured 6
        CHECK((tip - roll_up(8 * elements, circles, fine)).norm() <= 3e-4);
        CHECK(fine <= 8);  // measured 4 to 5
    }
}

}  // namespace turning_scenes_test
