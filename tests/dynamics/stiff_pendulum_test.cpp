// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Pendulums so stiff that a step turns them by far more than it strains them.

#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/dynamics/turning_frames.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads/springs.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <vector>

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

/// A bar of four planar elements that spins about its pinned end, or freely about its middle.
struct SpunBar {
    PlanarModel model;
    Beam<CrossSectionBeam<2>> beam;

    SpunBar(const Material& material, double length, double thickness, double spin, bool pinned)
        : beam(straight_beam<CrossSectionBeam<2>>(
              model, material, rectangle(thickness, thickness), {pinned ? 0.0 : -0.5 * length, 0.0},
              {pinned ? length : 0.5 * length, 0.0}, 4, mixed())) {
        if (pinned) model.pin(beam.first());
        model.set_rigid_rates({0.0, 0.0}, spin);
    }

    [[nodiscard]] double angle() const {
        const Vector<double, 2> along = model.position(beam.last()) - model.position(beam.first());
        return std::atan2(along[1], along[0]);
    }

    [[nodiscard]] static CrossSectionOptions mixed() {
        CrossSectionOptions options;
        options.rule = Rule::mixed();
        return options;
    }
};

/// Moves a scene from its start to a time, s.
template <int Dimension, class Integrator>
DynamicsReport move_until(double end, BasicModel<Dimension>& model, const Integrator& integrator) {
    DynamicProblem problem(model);
    EigenLu solver;
    Schedule schedule;
    schedule.end = end;
    return integrator.integrate(problem, solver, schedule);
}

TEST_CASE("generalized-alpha turns a slow steel link by second order in short steps too",
          "[dynamics]") {
    // 5 rad at 1 rad/s: a link of 0.1 m hardly bends in it, and kept matrices shrink corrections
    // by less than the first two of a step tell.
    const bool pinned = GENERATE(false, true);
    double behind[3];  // rad, over the square of the step
    for (const int k : {0, 1, 2}) {
        SpunBar bar(Material::isotropic(2e11, 0.3, 7800.0), 0.1, 0.01, 1.0, pinned);
        GeneralizedAlphaOptions options;
        options.step = std::vector{1e-2, 1e-3, 3e-4}[k];
        REQUIRE(move_until(5.0, bar.model, GeneralizedAlpha(options)).status == Status::converged);
        behind[k] = std::remainder(5.0 - bar.angle(), 2.0 * pi) / (options.step * options.step);
    }
    CAPTURE(pinned, behind[0], behind[1], behind[2]);
    // judged by the first ratio of a step: 1.8, -92 and -346, pinned 1.8, -22 and -240
    CHECK(std::abs(behind[1] - behind[0]) <= 0.1 * behind[0]);
    CHECK(std::abs(behind[2] - behind[0]) <= 1.5 * behind[0]);
}

/// A steel link of 0.1 m at 1 rad/s: pinned under gravity, on a joint, driven by one, or at 10
/// rad/s on a spring as stiff as it.
SpunBar turned_link(int kind) {
    SpunBar link(Material::isotropic(2e11, 0.3, 7800.0), 0.1, 0.01, 1.0, kind == 0);
    if (kind == 0) link.model.set_gravity({0.0, -1e-3});
    if (kind == 1) link.model.add(Pin<2>(link.beam.node(2), {0.0, 0.0}));
    if (kind == 2) {
        link.model.set_rigid_rates({0.0, 0.0}, 1.0, link.model.position(link.beam.first()));
        link.model.add(PlanarWeld(link.model, link.beam.first(),
                                  Motion{[](double t) { return -t; }, [](double) { return -1.0; },
                                         [](double) { return 0.0; }}));
    }
    if (kind == 3) {
        link.model.set_rigid_rates({0.0, 0.0}, 10.0, {-0.1, 0.0});
        link.model.add(Spring<2>(link.beam.first(), {-0.1, 0.0}, 1e9, 0.05));
    }
    return link;
}

TEST_CASE("generalized-alpha turns a steel link in many runs as in one", "[dynamics]") {
    // Runs of 6 and 54 ms end by a step far shorter than those of 1 ms, in which the vibrations
    // left by long steps become accelerations many times as large.
    const int kind = GENERATE(0, 1, 2, 3);
    SpunBar one = turned_link(kind);
    REQUIRE(move_until(2.0, one.model, GeneralizedAlpha()).status == Status::converged);
    for (const int runs : {37, 333}) {
        SpunBar link = turned_link(kind);
        DynamicProblem problem(link.model);
        EigenLu solver;
        Schedule schedule;
        DynamicsReport report;
        for (int k = 1; k <= runs; ++k) {
            schedule.end = 2.0 * k / runs;
            report = GeneralizedAlpha().integrate(problem, solver, schedule, report.memory);
            CAPTURE(kind, runs, k, report.message);
            REQUIRE(report.status == Status::converged);
            REQUIRE(report.convergence_failures == 0);
        }
        const VectorX apart = link.model.state().v - one.model.state().v;
        const double speed = one.model.state().v.cwiseAbs().maxCoeff();
        CAPTURE(kind, runs, apart.cwiseAbs().maxCoeff() / speed, link.angle() - one.angle());
        CHECK(std::abs(std::remainder(link.angle() - one.angle(), 2.0 * pi)) <= 1e-3);
        CHECK(apart.cwiseAbs().maxCoeff() <= 1e-3 * speed);
    }
}

TEST_CASE("generalized-alpha swings a stiff pendulum by few matrices", "[dynamics]") {
    Pendulum<CrossSectionBeam<3>> pendulum(0.0);
    // supports may make a hinge, or keep all of it in a plane
    const std::string hold = GENERATE("pin", "hinge", "plane");
    CAPTURE(hold);
    if (hold == "hinge") pendulum.model.fix(pendulum.beam.first(), Field::r_y, 2);
    if (hold == "plane")
        for (const NodeId node : pendulum.beam.nodes)
            for (const Field field : {Field::r, Field::r_x, Field::r_y})
                pendulum.model.fix(node, field, 2);
    DynamicProblem problem(pendulum.model);
    EigenLu solver;
    Schedule schedule;
    schedule.end = 0.5;
    const DynamicsReport report = GeneralizedAlpha().integrate(problem, solver, schedule);
    REQUIRE(report.status == Status::converged);
    CHECK(report.steps == 500);
    CHECK(report.factorisations <= 20);  // 7 measured; some 500 where a matrix stays put
    CHECK(report.iterations <= 4 * report.steps);
}

TEST_CASE("generalized-alpha needs one matrix for a beam that stays at rest", "[dynamics]") {
    // its corrections are round-off, of which no contraction can be told
    PlanarModel model;
    const auto beam = straight_beam<CrossSectionBeam<2>>(
        model, Material::isotropic(2e11, 0.3, 7800.0), rectangle(0.01, 0.01), {0, 0}, {1, 0}, 8);
    model.clamp(beam.first());
    model.set_gravity({0.0, -9.81});
    EigenLu solver;
    REQUIRE(solve_statics(model, solver).status == Status::converged);
    model.state().time = 0.0;
    const auto report = move_until(1.0, model, GeneralizedAlpha());
    REQUIRE(report.status == Status::converged);
    CHECK(report.steps == 1000);
    CHECK(report.jacobians <= 3);
    CHECK(report.convergence_failures == 0);
    CHECK(report.iterations <= 5 * report.steps);
}

TEST_CASE("adaptive Radau IIA keeps the energy of a bar that is hardly strained by its spin",
          "[dynamics]") {
    // A hundred times as stiff as steel, 40 rad.
    SpunBar bar(Material::from_moduli(2.1e13, 8.1e12, 7850.0), 1.0, 0.02, 10.0, true);
    RadauOptions options;
    options.stages = GENERATE(3, 5);
    options.tolerance = GENERATE(1e-2, 1e-3, 1e-4);
    const auto report = move_until(4.0, bar.model, RadauIIA(options));
    const double behind = std::remainder(40.0 - bar.angle(), 2.0 * pi);
    CAPTURE(options.stages, options.tolerance, report.steps, behind);
    REQUIRE(report.status == Status::converged);
    // 1.1e-3, 1.1e-3, 3.9e-5 and 6.0e-5, 6.0e-5, 7.1e-6 measured
    const double most = options.stages == 5 ? 1e-4 : 3e-3;
    CHECK(report.energy_drift <= most * report.kinetic_largest);
    CHECK(std::abs(behind) <= 30.0 * options.tolerance);
    CHECK(report.steps <= 200);  // 70 to 184 measured; 3800 to 4500 by one tangent that stays put
}

TEST_CASE("adaptive Radau IIA keeps the energy of a slow steel link", "[dynamics]") {
    const bool pinned = GENERATE(false, true);
    SpunBar bar(Material::isotropic(2e11, 0.3, 7800.0), 0.1, 0.01, 1.0, pinned);
    RadauOptions options;
    options.stages = 5;
    const auto report = move_until(20.0, bar.model, RadauIIA(options));
    CAPTURE(pinned, report.steps);
    REQUIRE(report.status == Status::converged);
    CHECK(report.energy_drift <= 1e-4 * report.kinetic_largest);  // 3e-6 measured
    CHECK(report.steps <= 200);  // 77 measured; 5000 and 10 000 by one tangent that stays put
}

/// A free bar a hundred times as stiff as steel that turns in space, about its own axis too.
struct TurningBar {
    Model model;

    TurningBar() {
        straight_beam<CrossSectionBeam<3>>(model, Material::isotropic(2.1e13, 0.3, 7800.0),
                                           rectangle(0.01, 0.01), {0, 0, 0}, {1, 0, 0}, 4);
        model.set_rigid_rates({0, 0, 0}, {3.0, 4.0, 20.0});
    }
};

TEST_CASE("adaptive Radau IIA turns a stiff bar about its own axis too", "[dynamics]") {
    const double tolerance = GENERATE(1e-4, 1e-6);
    TurningBar bar;
    RadauOptions options;
    options.tolerance = tolerance;
    const DynamicsReport report = move_until(2.0, bar.model, RadauIIA(options));
    CAPTURE(tolerance, report.iterations);
    REQUIRE(report.status == Status::converged);
    // 147 and 310; 1200 at both from predictions that strain the sections
    CHECK(report.steps <= (tolerance > 1e-5 ? 200 : 400));
    CHECK(report.energy_drift <= 20.0 * tolerance * report.kinetic_largest);
}

TEST_CASE("what is observed and followed does not change how frames turn", "[dynamics]") {
    const auto end = [](bool observes, bool follows) {
        TurningBar bar;
        DynamicProblem problem(bar.model);
        EigenLu solver;
        Schedule schedule;
        schedule.end = 0.5;
        if (observes) schedule = equal_intervals(0.0, 0.5, 1e-3);
        int seen = 0;
        schedule.observe = [&](const Snapshot&) { ++seen; };
        RadauOptions options;
        options.tolerance = 1e-4;
        options.follow_energy = follows;
        const auto report = RadauIIA(options).integrate(problem, solver, schedule);
        CHECK(report.status == Status::converged);
        CHECK(report.memory.get("frames", 8)[0] == 1.0);
        CHECK(seen == (observes ? 501 : 0));
        return VectorX(bar.model.state().q);
    };
    const VectorX plain = end(false, true);
    CHECK(end(true, true) == plain);
    CHECK(end(false, false) == plain);
    CHECK(end(true, false) == plain);
}

TEST_CASE("generalized-alpha turns a stiff bar about its own axis too by few matrices",
          "[dynamics]") {
    TurningBar bar;
    GeneralizedAlphaOptions options;
    options.step = 1e-3;
    const DynamicsReport report = move_until(2.0, bar.model, GeneralizedAlpha(options));
    REQUIRE(report.status == Status::converged);
    CHECK(report.steps == 2000);
    CHECK(report.factorisations <= 50);  // 16; 2816 from predictions that strain the sections
}

TEST_CASE("Radau IIA predicts a soft shaft that spins with its strains", "[dynamics]") {
    const double tolerance = GENERATE(0.0, 1e-7);
    CAPTURE(tolerance);
    using Point = Vector<double, 3>;
    Model model;
    const auto shaft = straight_beam<CrossSectionBeam<3>>(
        model, Material::isotropic(1e6, 0.3, 1000.0), rectangle(0.002, 0.003), Point(Point::Zero()),
        Point(0.15 * Point::UnitX()), 1);
    model.pin(shaft.first());
    model.pin(shaft.last());
    model.set_gravity(Point(0.0, 0.0, -9.81));
    model.set_rigid_rates(Point(Point::Zero()), Point(40.0, 0.0, 0.0));
    RadauOptions options;
    options.tolerance = tolerance;
    const DynamicsReport report = move_until(0.2, model, RadauIIA(options));
    REQUIRE(report.status == Status::converged);
    CHECK(report.memory.get("frames", 8)[0] == 1.0);
    // 3.9 a fixed step of a millisecond, 2.9 an adaptive one; without its strains 5.9 and 4.1
    CHECK(static_cast<double>(report.iterations) <
          (tolerance > 0.0 ? 3.3 : 4.4) * static_cast<double>(report.steps));
}

TEST_CASE("Radau IIA turns a stiff bar in whole fixed steps", "[dynamics]") {
    // 10 rad in steps of 0.2 rad, exact to round-off of the spin where it does not strain the bar
    SpunBar bar(Material::from_moduli(2.1e13, 8.1e12, 7850.0), 1.0, 0.02, 10.0, true);
    RadauOptions options;
    options.stages = GENERATE(3, 5);
    options.tolerance = 0.0;
    options.step = 0.02;
    const auto report = move_until(1.0, bar.model, RadauIIA(options));
    REQUIRE(report.status == Status::converged);
    CHECK(report.steps == 50);  // 2501 and 1316 by one tangent that stays put
    CHECK(report.convergence_failures == 0);
    const double error = options.stages == 5 ? 1e-6 : 1e-5;  // 3e-7, 4.5e-6 measured
    CHECK(std::abs(std::remainder(10.0 - bar.angle(), 2.0 * pi)) <= error);
}

TEST_CASE("Radau IIA turns stiff bodies on hinges and links in space", "[dynamics]") {
    // 1 s of fall; steps and corrections by one tangent that stays put: 1359 and 5910, 248 and 1312
    const bool hinged = GENERATE(false, true);
    CAPTURE(hinged);
    const auto fall = [hinged](double tolerance) {
        const Material steel = Material::isotropic(2e11, 0.3, 7800.0);
        Model model;
        const auto bar = straight_beam<CrossSectionBeam<3>>(model, steel, rectangle(0.02, 0.02),
                                                            {0, 0, 0}, {0.5, 0, 0}, 2);
        if (hinged) {
            const auto next = straight_beam<CrossSectionBeam<3>>(
                model, steel, rectangle(0.02, 0.02), {0.5, 0, 0}, {1.0, 0, 0}, 2);
            model.pin(bar.first());
            model.add(Revolute(model, bar.last(), next.first(), Vector<double, 3>(0, 1, 0.2)));
        } else {
            model.add(Distance<3>(bar.first(), Vector<double, 3>(0, 0, 0.4), 0.4));
        }
        model.set_gravity({0, 0, -9.81});
        DynamicProblem problem(model);
        EigenLu solver;
        Schedule schedule;
        schedule.end = 1.0;
        RadauOptions options;
        options.stages = 5;
        options.tolerance = tolerance;
        return RadauIIA(options).integrate(problem, solver, schedule);
    };
    const DynamicsReport report = fall(1e-3);
    REQUIRE(report.status == Status::converged);
    CAPTURE(report.iterations);
    CHECK(report.steps <= (hinged ? 500 : 120));  // 299 and 78 measured
    CHECK(report.energy_drift <= 2e-3 * report.kinetic_largest);
}

/// A steel pendulum of two bars in the plane.
struct DoublePendulum {
    PlanarModel model;

    DoublePendulum() {
        const Material steel = Material::isotropic(2e11, 0.3, 7800.0);
        const auto bar = [&](double x) {
            return straight_beam<CrossSectionBeam<2>>(model, steel, rectangle(0.02, 0.02), {x, 0.0},
                                                      {x + 0.5, 0.0}, 2);
        };
        const auto first = bar(0.0), second = bar(0.5);
        model.pin(first.first());
        model.add(Pin<2>(first.last(), second.first()));
        model.set_gravity({0.0, -9.81});
    }
};

TEMPLATE_TEST_CASE("a run in two parts turns its frames as one run does", "[dynamics]",
                   GeneralizedAlpha, RadauIIA) {
    const double step = 1e-3;
    const int steps = 60;
    const auto options = [&] {
        std::decay_t<decltype(TestType().options())> some;
        some.step = step;
        if constexpr (std::is_same_v<TestType, RadauIIA>) some.tolerance = 0.0;
        return some;
    }();
    const auto run = [&](DoublePendulum& pendulum, const std::vector<int>& ends) {
        DynamicProblem problem(pendulum.model);
        EigenLu solver;
        DynamicsReport report;
        for (const int end : ends) {
            Schedule schedule;
            schedule.end = end * step;
            report = TestType(options).integrate(problem, solver, schedule, report.memory);
            REQUIRE(report.status == Status::converged);
        }
        return report.memory;
    };
    DoublePendulum whole;
    const Memory one = run(whole, {steps});
    int alike = 0;
    for (int end = 1; end < steps; end += 3) {
        CAPTURE(end);
        DoublePendulum parts;
        const Memory two = run(parts, {end, steps});
        CHECK(two.get("frames", 8) == one.get("frames", 8));
        alike += parts.model.state().q == whole.model.state().q ? 1 : 0;
    }
    CHECK(alike == 20);
}

/// Checks that nodal vectors turn as a whole beam is turned.
template <int Dimension, class Element>
void check_turn(double angle) {
    using Point = Vector<double, Dimension>;
    BasicModel<Dimension> model;
    Point along = Point::Constant(0.3);
    along[0] = 1.0;
    straight_beam<Element>(model, Material::isotropic(2e11, 0.3, 7800.0), rectangle(0.1, 0.1),
                           Point(Point::Zero()), along, 2);
    DynamicProblem problem(model);
    VectorX q, turned;
    problem.numbering().gather_free(model.state().q, q);
    turned = q;
    const double c = std::cos(angle), s = std::sin(angle);
    for (Eigen::Index k = 0; k < q.size(); k += Dimension) {  // about the last axis
        turned[k] = c * q[k] - s * q[k + 1];
        turned[k + 1] = s * q[k] + c * q[k + 1];
    }
    const detail::TurningFrames frames(model, problem.numbering());
    VectorX x = q;
    frames.carry(q, turned, x.data());
    CHECK((x - turned).norm() <= 1e-14);
    frames.carry(turned, q, x.data());
    CHECK((x - q).norm() <= 1e-14);
}

TEST_CASE("the vectors of nodes turn with the nodes", "[dynamics]") {
    for (const double angle : {0.0, 0.3, -2.0}) {
        check_turn<2, CrossSectionBeam<2>>(angle);
        check_turn<3, CrossSectionBeam<3>>(angle);
        check_turn<2, Cable<2>>(angle);
    }
    check_turn<2, CrossSectionBeam<2>>(pi);
    check_turn<3, CrossSectionBeam<3>>(pi);
}

TEST_CASE("the slope of a cable turns by any angle, vectors keep their lengths", "[dynamics]") {
    for (const double angle : {0.3, 2.5, 2.7, 3.1, pi}) {
        CAPTURE(angle);
        Model model;
        straight_beam<Cable<3>>(model, Material::isotropic(2e11, 0.3, 7800.0), circle(0.1),
                                {0, 0, 0}, {1, 0, 0}, 1);
        DynamicProblem problem(model);
        VectorX q;
        problem.numbering().gather_free(model.state().q, q);
        VectorX turned = q;
        for (const int slope : {3, 9}) {
            turned[slope] = std::cos(angle);
            turned[slope + 2] = std::sin(angle);
        }
        VectorX x = VectorX::LinSpaced(q.size(), 1.0, 2.0);
        x.segment<3>(3) = q.segment<3>(3);
        const double length = x.norm();
        detail::TurningFrames(model, problem.numbering()).carry(q, turned, x.data());
        CHECK((x.segment<3>(3) - turned.segment<3>(3)).norm() <= 1e-14);
        CHECK(std::abs(x.norm() - length) <= 1e-14 * length);
    }
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

/// Spins a bar of steel of 1 m at 10 rad/s about its middle for 300 fixed steps.
void check_spin(int stages, double step, long factors) {
    constexpr double rate = 10.0;
    CAPTURE(stages, step);
    PlanarModel model;
    const auto bar =
        straight_beam<CrossSectionBeam<2>>(model, Material::isotropic(2.07e11, 0.3, 7850.0),
                                           rectangle(0.03, 0.03), {-0.5, 0.0}, {0.5, 0.0}, 2);
    for (const NodeId node : bar.nodes) {
        model.set_rate(node, Field::r, {0.0, rate * model.value(node, Field::r)[0]});
        model.set_rate(node, Field::r_x, {0.0, rate});
        model.set_rate(node, Field::r_y, {-rate, 0.0});
    }
    DynamicProblem problem(model);
    EigenLu solver;
    RadauOptions options;
    options.stages = stages;
    options.tolerance = 0.0;
    options.step = step;
    Schedule schedule;
    schedule.end = 300.0 * step;
    const auto report = RadauIIA(options).integrate(problem, solver, schedule);
    CHECK(report.status == Status::converged);
    CHECK(report.steps == 300);
    CHECK(report.factorisations <= factors);
    const double turn = rate * schedule.end;
    const Vector<double, 2> end = model.value(bar.last(), Field::r);
    // 1.2e-5 measured; the bar stretches by 6e-7
    CHECK(end[0] == Approx(0.5 * std::cos(turn)).margin(2e-5));
    CHECK(end[1] == Approx(0.5 * std::sin(turn)).margin(2e-5));
}

TEST_CASE("Radau IIA: matrices that new ones would not better are kept where a stiff bar turns",
          "[dynamics][radau]") {
    check_spin(3, 0.01, 16);     // 8 measured
    check_spin(5, 0.00316, 30);  // 15 measured
    check_spin(5, 0.01, 30);     // 15 measured
}

}  // namespace stiff_pendulum_test
