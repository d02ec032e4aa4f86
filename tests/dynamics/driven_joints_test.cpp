// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Driven joints in motion: the angle is reached with its turns, or the run ends with the reason.

#include <ancf/constants.hpp>
#include <ancf/dynamics/energy_momentum.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/rigid_body.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads/rotational_springs.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/section.hpp>
#include <ancf/solver/eigen_solver.hpp>

#include <support/catch.hpp>
#include <support/driven_arm.hpp>
#include <support/twisted_beam.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace driven_joints_motion_test {

using namespace ancf;

enum class Kind { fixed, adaptive, radau3, radau5, radau_adaptive };

/// How an arm fared that was driven by an angle within a second.
enum class Outcome { reached, refused };

/// Drives an arm and checks that it turns by the angle, with all turns and in every part of the
/// way, or ends before and with the reason.
template <class Arm>
Outcome drive(double angle, int steps, Kind kind) {
    const Motion motion = test::smooth_turn(angle);
    Arm arm(motion);
    DynamicProblem problem(arm.model);
    EigenLu solver;
    Schedule schedule = equal_intervals(0.0, 1.0, 1.0 / 64);
    test::TurnCounter counter(arm, motion);
    schedule.observe = [&](const Snapshot& seen) { counter.see(seen.state); };
    GeneralizedAlphaOptions alpha;
    alpha.step = 1.0 / steps;
    if (kind == Kind::adaptive) alpha.tolerance = 1e-4;
    RadauOptions radau;
    radau.step = 1.0 / steps;
    radau.stages = kind == Kind::radau5 ? 5 : 3;
    radau.tolerance = kind == Kind::radau_adaptive ? 1e-4 : 0.0;
    const bool by_radau = kind != Kind::fixed && kind != Kind::adaptive;
    const DynamicsReport report =
        by_radau ? RadauIIA(radau).integrate(problem, solver, schedule)
                 : GeneralizedAlpha(alpha).integrate(problem, solver, schedule);
    if (report.status != Status::converged) {
        CHECK_FALSE(report.message.empty());
        CHECK(report.time < 1.0);
        return Outcome::refused;
    }
    CHECK(std::abs(counter.turned() - angle) <= 1e-9);
    CHECK(counter.farthest() <= 1e-6);  // 2e-7 measured
    CHECK(arm.off(angle) <= 1e-9);
    CHECK(arm.wound() <= 0.5);
    return Outcome::reached;
}

TEMPLATE_TEST_CASE("arms driven in steps of any length turn by the angle", "[constraint][dynamics]",
                   test::DrivenArm, test::DrivenCrank) {
    int checked = 0;
    for (const double angle : {0.1, 1.0, 1.7, 2.5, pi, 4.0, 2.0 * pi, 10.0, 4.0 * pi, 20.0})
        for (const int steps : {1, 2, 4, 16}) {
            CAPTURE(angle, steps);
            for (const Kind kind :
                 {Kind::fixed, Kind::adaptive, Kind::radau3, Kind::radau5, Kind::radau_adaptive}) {
                CAPTURE(static_cast<int>(kind));
                CHECK(drive<TestType>(angle, steps, kind) == Outcome::reached);
            }
            ++checked;
        }
    CHECK(checked == 40);
}

/// Drives a body by a hinge about an axis beside its principal ones. Returns the largest error of
/// the hinge's force that the integrator's own multipliers have at four times, against that of a
/// rigid body, N.
template <class Integrator, class Options>
double hinge_force_error(const Options& options) {
    constexpr double mass = 2.0, pace = 3.0, reach = 7.0;  // kg, rad/s, rad/s
    const Vector<double, 3> centre(0.1, -0.05, 0.08), axis = Vector<double, 3>(3, -4, 12) / 13.0;
    Matrix<double, 3> inertia;
    inertia << 0.05, 0.004, -0.003, 0.004, 0.03, 0.002, -0.003, 0.002, 0.04;
    const auto angle = [=](double t) { return reach * (t - std::sin(pace * t) / pace); };
    const auto rate = [=](double t) { return reach * (1.0 - std::cos(pace * t)); };
    const auto second = [=](double t) { return reach * pace * std::sin(pace * t); };
    double worst = 0.0;
    for (const double end : {0.3, 0.6, 0.9, 1.2}) {
        Model model;
        const NodeId body = model.add_node({0, 0, 0});
        add_body(model, body, mass, inertia, centre);
        model.set_gravity({0, -9.81, 0});
        model.add(DrivenRevolute(
            model, body, axis,
            Motion{[=](double t) { return -angle(t); }, [=](double t) { return -rate(t); },
                   [=](double t) { return -second(t); }}));
        DynamicProblem problem(model);
        EigenLu solver;
        Schedule schedule;
        schedule.end = end;
        const auto report = Integrator(options).integrate(problem, solver, schedule);
        CHECK(report.status == Status::converged);
        // Rodrigues' turn of the centre; its acceleration
        const Vector<double, 3> across = cross<double>(axis, centre);
        const Vector<double, 3> along = axis * axis.dot(centre);
        const Vector<double, 3> turned =
            along + std::cos(angle(end)) * (centre - along) + std::sin(angle(end)) * across;
        const Vector<double, 3> acceleration = second(end) * cross<double>(axis, turned) -
                                               rate(end) * rate(end) * (turned - along) -
                                               model.gravity();
        // those before are of the body itself; the model has those of its state
        const VectorX& own = report.memory.get("lambda", problem.multipliers());
        const auto error = [&](const VectorX& multipliers) {
            return (-multipliers.segment<3>(6) - mass * acceleration).norm();
        };
        CHECK(error(model.state().multipliers) <= 1e-4);
        worst = std::max(worst, error(own));
    }
    return worst;
}

TEST_CASE("a driven body that turns far has the force of its hinge", "[constraint][dynamics]") {
    // up to 45 N. The hinge rests, so no coordinate shows its force: kept matrices in frames that
    // turn left 0.0045 N with rho 0.8, and 2.6e5 N with Radau, where nobody looked at multipliers.
    GeneralizedAlphaOptions alpha;
    alpha.rho = GENERATE(0.5, 0.8);
    CHECK(hinge_force_error<GeneralizedAlpha>(alpha) <= 0.003);  // 0.0014
    RadauOptions radau;
    radau.tolerance = 1e-8;
    CHECK(hinge_force_error<RadauIIA>(radau) <= 1.0);  // 0.44
}

TEST_CASE("a stiff body that turns far in a step has the force of its drive between steps too",
          "[constraint][dynamics]") {
    // A disc turns a steel bar by up to 0.8 rad in a step. Even a new matrix, that of the step's
    // start, leaves |R - 1| of each correction of the force: with five stages 0.26 of the largest
    // one at 1e-4, and 0.023 at 1e-5.
    constexpr double density = 7800.0, side = 0.03, speed = 40.0;  // kg/m^3, m, rad/s
    const Motion turn = test::smooth_turn(0.5 * speed);
    RadauOptions options;
    options.stages = GENERATE(3, 5);
    options.tolerance = GENERATE(1e-4, 1e-5);
    PlanarModel model;
    const NodeId hub = model.add_node({0, 0});
    add_body(model, hub, 1.0, 1.0);
    const auto bar = straight_beam<CrossSectionBeam<2>>(
        model, Material::isotropic(2e11, 0.3, density), rectangle(side, side), {0.1, 0}, {1, 0}, 2,
        CrossSectionOptions::best());
    model.attach(bar.first(), hub);
    model.add(PlanarWeld(model, hub, turn));
    const double moment = density * side * side * 0.99 / 2.0;  // mass times its distance, kg m
    DynamicProblem problem(model);
    EigenLu solver;
    auto schedule = equal_intervals(0.0, 1.0, 1e-3);
    double worst = 0.0, largest = 0.0;  // N
    schedule.observe = [&](const Snapshot& seen) {
        const double time = seen.state.time, angle = -turn.value(time);
        const double along = -moment * std::pow(turn.rate(time), 2);
        const double across = -moment * turn.acceleration(time);
        const Vector<double, 2> force(std::cos(angle) * along - std::sin(angle) * across,
                                      std::sin(angle) * along + std::cos(angle) * across);
        largest = std::max(largest, force.norm());
        worst = std::max(worst, (seen.state.multipliers.segment<2>(3) + force).norm());
    };
    const auto report = RadauIIA(options).integrate(problem, solver, schedule);
    CAPTURE(options.stages, options.tolerance, report.message, worst / largest);
    REQUIRE(report.status == Status::converged);
    CHECK(worst <= 0.02 * largest);  // 0.0085
}

TEST_CASE("the rates of a drive have the same derivative in every orientation", "[constraint]") {
    const auto size = [](double turn, double start) {
        Model model;
        Matrix<double, 3> slopes;
        slopes << std::cos(turn), -std::sin(turn), 0, std::sin(turn), std::cos(turn), 0, 0, 0, 1;
        const NodeId body = model.add_node({0, 0, 0}, slopes);
        add_body(model, body, 1.0, Vector<double, 3>(1, 2, 3).asDiagonal());
        model.add(DrivenRevolute(model, body, {0, 0, 1},
                                 Motion{[=](double t) { return 10.0 * (t - start); },
                                        [](double) { return 10.0; }, [](double) { return 0.0; }}));
        DynamicProblem problem(model);
        VectorX q, mu = VectorX::Zero(problem.multipliers());
        problem.numbering().gather_free(model.state().q, q);
        problem.evaluate_constraints(start, q, VectorX::Zero(q.size()));
        ancf::SparseMatrix out;
        problem.velocity_level(mu, out);
        return out.norm();
    };
    const double expected = size(0.7, 0.0);
    CHECK(expected > 1.0);
    // along the axes every product of coordinates is zero, or round-off
    for (const double turn : {0.0, 0.5 * ancf::pi, ancf::pi})
        for (const double start : {0.0, 1.0}) {
            INFO("turn " << turn << ", start " << start);
            CHECK(size(turn, start) == Approx(expected).epsilon(1e-4));  // 2e-5
        }
}

/// Drives an arm by the energy-momentum scheme and checks that its joint has turned by the angle,
/// with all turns and in every part of the way.
template <class Arm>
DynamicsReport turn(double angle, int steps) {
    const Motion motion = test::smooth_turn(angle);
    Arm arm(motion);
    DynamicProblem problem(arm.model);
    EigenLu solver;
    EnergyMomentumOptions options;
    options.step = 1.0 / steps;
    Schedule schedule = equal_intervals(0.0, 1.0, 1.0 / 128);
    test::TurnCounter counter(arm, motion);
    schedule.observe = [&](const Snapshot& seen) { counter.see(seen.state); };
    const DynamicsReport report = EnergyMomentum(options).integrate(problem, solver, schedule);
    CHECK(report.status == Status::converged);
    CHECK(std::abs(counter.turned() - angle) <= 1e-9);
    // half of what a step may turn; within a step the state lies between those of its ends
    CHECK(counter.farthest() <= pi / 24.0);
    CHECK(arm.off(angle) <= 1e-9);
    CHECK(arm.wound() <= 0.5);
    return report;
}

TEMPLATE_TEST_CASE("energy-momentum turns arms by any angle in steps of any length",
                   "[constraint][dynamics]", test::DrivenArm, test::DrivenCrank, test::DrivenElbow,
                   test::DrivenElbowInSpace) {
    int checked = 0;
    for (const double angle : {0.1, 1.0, 1.7, 2.5, pi, 4.0, 2.0 * pi, 10.0, 20.0, -2.5})
        for (const int steps : {1, 2, 4, 16}) {
            CAPTURE(angle, steps);
            const DynamicsReport report = turn<TestType>(angle, steps);
            // at twice the mean rate pi/12 a part is the most; Newton's method asks for a few more
            const double parts = 2.0 * std::abs(angle) / (pi / 12.0);
            CHECK(static_cast<double>(report.steps) <= 16.0 + 8.0 * parts);
            ++checked;
        }
    CHECK(checked == 40);
}

TEMPLATE_TEST_CASE("energy-momentum cuts a step by the turn of its joints, and no other",
                   "[constraint][dynamics]", test::DrivenArm, test::DrivenElbow) {
    // 0.25 rad a step at the most: below pi/12
    CHECK(turn<TestType>(1.0, 8).steps < 20);
    const DynamicsReport slow = turn<TestType>(0.2, 64);
    CHECK(slow.steps == 64);
    CHECK(slow.convergence_failures == 0);
    // 2 pi rad/s at the most in 32 parts of pi/16
    CHECK(turn<TestType>(pi, 1).smallest_step <= 1.0 / 32.0);
}

TEMPLATE_TEST_CASE("a run that stops within or behind a divided step goes on with the same bits",
                   "[constraint][dynamics]", EnergyMomentum, GeneralizedAlpha, RadauIIA) {
    // 10 rad in steps of 1/8 s: parts of pi/12 at the most
    auto options = TestType().options();
    options.step = 0.125;
    if constexpr (std::is_same_v<TestType, RadauIIA>) options.tolerance = 0.0;
    const double stop = GENERATE(0.001, 0.5, 0.51);
    CAPTURE(stop);
    test::DrivenArm parts(test::smooth_turn(10.0)), whole(test::smooth_turn(10.0));
    const auto run = [&](test::DrivenArm& arm, double last, const Memory& memory = {}) {
        DynamicProblem problem(arm.model);
        EigenLu solver;
        Schedule schedule;
        schedule.end = 0.75;
        schedule.progress = [=](double time, double) { return time < last; };
        return TestType(options).integrate(problem, solver, schedule, memory);
    };
    for (test::DrivenArm* arm : {&parts, &whole})
        arm->model.add(
            PlanarRotationalDamper(arm->model, arm->beam.node(1), arm->beam.last(), 0.1));
    const DynamicsReport first = run(parts, stop);
    REQUIRE(first.status == Status::stopped);
    if (stop == 0.5) REQUIRE(first.time == 0.5);
    REQUIRE(first.time < 0.6);
    const DynamicsReport second = run(parts, 1.0, first.memory);
    const DynamicsReport all = run(whole, 1.0);
    CHECK(second.status == Status::converged);
    CHECK(all.status == Status::converged);
    CHECK(all.steps == first.steps + second.steps);
    CHECK(parts.model.state().q == whole.model.state().q);
    CHECK(parts.model.state().v == whole.model.state().v);
    CHECK(parts.model.state().multipliers == whole.model.state().multipliers);
}

TEMPLATE_TEST_CASE("a run that goes on begins with the forces that the one before ended with",
                   "[constraint][dynamics]", EnergyMomentum, GeneralizedAlpha, RadauIIA) {
    // any step resolves a rigid body. Multipliers of the integrators' own are off by 0.8 N with
    // energy-momentum, 0.03 N with generalized-alpha, 1.4 N with Radau
    auto options = TestType().options();
    options.step = 0.01;
    PlanarModel model;
    const NodeId body = model.add_node({0, 0});
    add_body(model, body, 2.0, 0.04, {0.2, 0.1});
    model.set_gravity({0, -9.81});
    model.add(PlanarWeld(model, body, test::smooth_turn(3.0)));
    DynamicProblem problem(model);
    EigenLu solver;
    const TestType integrator(options);
    Schedule schedule;
    schedule.end = 0.4;
    const DynamicsReport first = integrator.integrate(problem, solver, schedule);
    REQUIRE(first.status == Status::converged);
    const VectorX ended = model.state().multipliers;
    VectorX begins;
    schedule.end = 0.5;
    schedule.times = {0.4};
    schedule.observe = [&](const Snapshot& seen) { begins = seen.state.multipliers; };
    const DynamicsReport second = integrator.integrate(problem, solver, schedule, first.memory);
    REQUIRE(second.status == Status::converged);
    REQUIRE(begins.size() == ended.size());
    CHECK((begins - ended).norm() <= 1e-12 * ended.norm());
}

TEST_CASE("a motion that twists an element by too much ends, or says which one and when",
          "[constraint][dynamics]") {
    const auto twisted = [](double angle, auto integrator, double end = 1.0, bool pass = false) {
        Model model = test::twisted_beam(angle);
        DynamicProblem problem(model);
        EigenLu solver;
        Schedule schedule = equal_intervals(0.0, end, end);
        schedule.pass_degenerate = pass;
        const DynamicsReport report = integrator.integrate(problem, solver, schedule);
        CHECK(model.state().time == report.time);
        return report;
    };
    const auto check = [&](auto integrator) {
        const DynamicsReport within = twisted(2.5, integrator);
        CHECK(within.status == Status::converged);
        CHECK(within.left_range.empty());
        CHECK(within.message.empty());
        for (const bool pass : {false, true})  // 12 steps later at the most
            test::check_left_range(twisted(5.0, integrator, 1.0, pass), !pass, 0.64);
        test::check_left_range(twisted(5.0, integrator, 0.52), true, 0.521);  // seen at its end
    };
    GeneralizedAlphaOptions alpha;
    alpha.step = 1e-2;
    check(GeneralizedAlpha(alpha));
    alpha.tolerance = 1e-4;
    check(GeneralizedAlpha(alpha));
    RadauOptions radau;
    radau.step = 1e-2;
    check(RadauIIA(radau));
    EnergyMomentumOptions momentum;
    momentum.step = 1e-2;
    check(EnergyMomentum(momentum));
}

TEST_CASE("a beam that its motion crushes ends the run with the reason", "[constraint][dynamics]") {
    // The driven beam pulls by 500 N at 0.5 m, the clamped one's E I/L is 100 N m.
    const bool energy_momentum = GENERATE(false, true), pass = GENERATE(false, true);
    CAPTURE(energy_momentum, pass);
    test::DrivenElbow arm(test::smooth_turn(20.0), 1e8);
    DynamicProblem problem(arm.model);
    EigenLu solver;
    Schedule schedule = equal_intervals(0.0, 1.0, 1.0);
    schedule.pass_degenerate = pass;
    EnergyMomentumOptions energy;
    energy.step = 1.0 / 16.0;
    GeneralizedAlphaOptions alpha;
    alpha.step = 1.0 / 16.0;
    const DynamicsReport report =
        energy_momentum ? EnergyMomentum(energy).integrate(problem, solver, schedule)
                        : GeneralizedAlpha(alpha).integrate(problem, solver, schedule);
    CHECK(report.status != Status::converged);
    CHECK((report.status == Status::degenerate) == !pass);
    CHECK_THAT(report.message,
               ContainsSubstring(pass ? "Newton's method failed in the step from"
                                      : "element 0 of the type CrossSectionBeam<2> is degenerate"));
    if (pass)
        CHECK_THAT(report.message,
                   ContainsSubstring(energy_momentum ? "; shorter steps may pass"
                                                     : "; shorter steps, a smaller rho"));
    CHECK(report.time > 0.5);
    CHECK(report.time < 1.0);
}

TEST_CASE("a driven angle that jumps ends the motion and names the joint",
          "[constraint][dynamics]") {
    const Motion jump{[](double t) { return t > 0.5 ? 4.0 : 0.0; }, [](double) { return 0.0; },
                      [](double) { return 0.0; }};
    for (const int kind : {0, 1, 2}) {
        CAPTURE(kind);
        test::DrivenArm arm(jump);
        DynamicProblem problem(arm.model);
        EigenLu solver;
        const Schedule schedule = equal_intervals(0.0, 1.0, 1.0);
        DynamicsReport report;
        if (kind == 2) {
            EnergyMomentumOptions options;
            options.step = 0.3;
            report = EnergyMomentum(options).integrate(problem, solver, schedule);
        } else {
            GeneralizedAlphaOptions options;
            options.step = 0.3;
            if (kind == 1) options.tolerance = 1e-4;
            report = GeneralizedAlpha(options).integrate(problem, solver, schedule);
        }
        CHECK(report.status != Status::converged);
        CHECK_THAT(report.message, ContainsSubstring("planar weld of node 0 and space"));
        CHECK_THAT(report.message, ContainsSubstring("driven by 4 rad"));
        CHECK(report.time <= 0.5);
    }
}

TEST_CASE("a slender beam spun up and then turning steadily is no trouble for energy-momentum",
          "[constraint][dynamics]") {
    // T. R. Kane, R. R. Ryan, A. K. Banerjee, J. Guidance 10 (1987) 139-151, with the beam of
    // J. C. Simo, L. Vu-Quoc, Int. J. Solids Structures 22 (1986) 1-20: 6 rad/s after 15 s. Turns
    // of 0.06 rad a step strain the beam by far less.
    const double whole = 15.0, rate = 6.0, w = 2.0 * pi / whole, depth = std::sqrt(6e-3);
    const Motion turn{
        [=](double t) {
            return t < whole ? -rate / whole * (0.5 * t * t + (std::cos(w * t) - 1.0) / (w * w))
                             : rate * (0.5 * whole - t);
        },
        [=](double t) { return t < whole ? -rate / whole * (t - std::sin(w * t) / w) : -rate; },
        [=](double t) { return t < whole ? -rate / whole * (1.0 - std::cos(w * t)) : 0.0; }};
    PlanarModel scene;
    const double area = depth * depth;
    const auto beam = straight_beam<CrossSectionBeam<2>>(
        scene, Material::isotropic(2.8e7 / area, 0.0, 1.2 / area), rectangle(depth, depth), {0, 0},
        {10, 0}, 8, CrossSectionOptions::best());
    scene.add(PlanarWeld(scene, beam.first(), turn));
    DynamicProblem problem(scene);
    EigenLu solver;
    Schedule schedule = equal_intervals(0.0, 20.0, 2.5);
    std::vector<double> lag;
    const int tip = scene.coordinate(beam.last(), Field::r);
    schedule.observe = [&](const Snapshot& seen) {
        const double angle = -turn.value(seen.state.time);
        lag.push_back(std::cos(angle) * seen.state.q[tip + 1] -
                      std::sin(angle) * seen.state.q[tip]);
    };
    EnergyMomentumOptions options;
    options.step = 1e-2;
    const auto report = EnergyMomentum(options).integrate(problem, solver, schedule);
    REQUIRE(report.status == Status::converged);
    CHECK(report.convergence_failures == 0);
    CHECK(report.factorisations <= 2500);  // 1896
    // of Radau IIA with a tolerance of 1e-6, and within 1e-3 of a linear rotating beam
    const double right[] = {0.0,      -0.15128, -0.46847, -0.55904, -0.36274,
                            -0.11266, 0.00129,  0.00363,  0.00075};
    REQUIRE(lag.size() == 9);
    for (std::size_t k = 0; k < 9; ++k) CHECK(std::abs(lag[k] - right[k]) <= 5e-4);
}

}  // namespace driven_joints_motion_test
