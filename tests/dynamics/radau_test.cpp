// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/algebra.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/dynamics/radau_system.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/loads/damping.hpp>
#include <ancf/output/state_file.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/automatic.hpp>
#include <ancf/solver/eigen_solver.hpp>

#include <dynamics/random_scenes.hpp>
#include <dynamics/scenes.hpp>
#include <support/bar.hpp>
#include <support/catch.hpp>
#include <support/dense.hpp>
#include <support/driven_arm.hpp>
#include <support/random_state.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <vector>

namespace radau_test {

using namespace ancf;
using namespace ancf::test;
using ancf::test::Chain;

RadauOptions fixed(int stages, double step) {
    RadauOptions options;
    options.stages = stages;
    options.step = step;
    options.tolerance = 0.0;
    return options;
}

RadauOptions adaptive(int stages, double tolerance) {
    RadauOptions options;
    options.stages = stages;
    options.tolerance = tolerance;
    return options;
}

DynamicsReport run(Scene& model, const RadauOptions& options, const Schedule& schedule,
                   const Memory& memory = {}) {
    DynamicProblem problem(model);
    EigenLu solver;
    return RadauIIA(options).integrate(problem, solver, schedule, memory);
}

/// Two soft bars on a massless link, thrown out of the plane of gravity; vibrations of up to 35
/// rad/s.
Chain soft_swing(bool link) {
    Chain scene = chain(2, {0.0, -0.5, 0.0}, {1.2, -0.5, 0.0}, 20.0);
    if (link)
        scene.model.add(Distance<3>(scene.first(), Vector3(0.0, 0.0, 0.0), 0.5));
    else
        scene.model.pin(scene.first());
    scene.model.set_gravity({0.0, -2.0, 0.0});
    for (const NodeId node : scene.nodes)
        if (link || node.index != scene.first().index)
            scene.model.set_rate(node, Field::r, {0.0, 0.0, 0.7});
    return scene;
}

/// Returns the limit of two runs of by_runge_kutta.
template <class Make>
std::vector<State> exact_states(const Make& make, double end, int steps, int outputs) {
    auto scene = make();
    auto again = make();
    const std::vector<State> coarse = by_runge_kutta(scene.model, end, steps, outputs);
    std::vector<State> fine = by_runge_kutta(again.model, end, 2 * steps, outputs);
    for (std::size_t k = 0; k < fine.size(); ++k) {
        fine[k].q += (fine[k].q - coarse[k].q) / 15.0;
        fine[k].v += (fine[k].v - coarse[k].v) / 15.0;
        fine[k].multipliers += (fine[k].multipliers - coarse[k].multipliers) / 15.0;
    }
    return fine;
}

constexpr double swing_end = 0.5;  // s
constexpr int swing_outputs = 50;

/// Returns the soft swing at fifty times within half a second, exact to 1e-13.
const std::vector<State>& exact_soft_swing(bool link) {
    const auto limit = [](bool on_link) {
        return exact_states([=] { return soft_swing(on_link); }, swing_end, 2500, swing_outputs);
    };
    static const std::vector<State> free = limit(false), linked = limit(true);
    return link ? linked : free;
}

TEST_CASE("Radau IIA: the tables fulfil the conditions of order", "[dynamics][radau]") {
    const int s = GENERATE(1, 3, 5, 7);
    CAPTURE(s);
    const detail::RadauTableau table = detail::radau_tableau(s);
    REQUIRE(table.stages() == s);
    const MatrixX A = test::inverted(table.inverse);
    const auto c = [&](int i, int power) {
        return std::pow(table.nodes[static_cast<std::size_t>(i)], power);
    };
    // 2e-15 measured with seven stages
    constexpr double round_off = 1e-14;
    CHECK(table.nodes.back() == 1.0);
    for (int k = 1; k <= 2 * s - 1; ++k) {  // B(2s - 1): the last row of A is the quadrature
        double sum = 0.0;
        for (int j = 0; j < s; ++j) sum += A(s - 1, j) * c(j, k - 1);
        CHECK(std::abs(k * sum - 1.0) <= round_off);
    }
    for (int k = 1; k <= s; ++k)  // C(s)
        for (int i = 0; i < s; ++i) {
            double sum = 0.0;
            for (int j = 0; j < s; ++j) sum += A(i, j) * c(j, k - 1);
            CHECK(std::abs(k * sum - c(i, k)) <= round_off);
        }
    for (int k = 1; k <= s - 1; ++k)  // D(s - 1)
        for (int j = 0; j < s; ++j) {
            double sum = 0.0;
            for (int i = 0; i < s; ++i) sum += A(s - 1, i) * c(i, k - 1) * A(i, j);
            CHECK(std::abs(k * sum - A(s - 1, j) * (1.0 - c(j, k))) <= round_off);
        }
    CHECK((A * A - table.double_integral).cwiseAbs().maxCoeff() <= round_off);
    CHECK((table.inverse * table.inverse - table.square).cwiseAbs().maxCoeff() <=
          round_off * table.square.cwiseAbs().maxCoeff());
}

TEST_CASE("Radau IIA: the modes diagonalise the tables", "[dynamics][radau]") {
    const int s = GENERATE(1, 3, 5, 7);
    CAPTURE(s);
    const detail::RadauTableau table = detail::radau_tableau(s);
    REQUIRE(table.modes.size() == static_cast<std::size_t>(s + 1) / 2);
    CHECK(table.modes.front().eigenvalue.imag() == 0.0);
    // sum over modes of mu column row, pairs twice their real part, is W
    MatrixX sum = MatrixX::Zero(s, s);
    for (const detail::RadauMode& mode : table.modes) {
        const bool real = mode.eigenvalue.imag() == 0.0;
        for (int i = 0; i < s; ++i)
            for (int j = 0; j < s; ++j)
                sum(i, j) += (real ? 1.0 : 2.0) *
                             (mode.eigenvalue * mode.column[static_cast<std::size_t>(i)] *
                              mode.row[static_cast<std::size_t>(j)])
                                 .real();
    }
    // 6e-14 of 29 measured with seven stages
    CHECK((sum - table.inverse).cwiseAbs().maxCoeff() <=
          2e-14 * table.inverse.cwiseAbs().maxCoeff());
}

TEST_CASE("Radau IIA: a smooth motion is followed with orders 5 and 9", "[dynamics][radau]") {
    // one bar along x whose end is made to move as r(t) by a force
    const double stiffness = 0.5, amplitude = 0.1, end = 4.0;
    const auto r = [=](double t) { return 1.0 + amplitude * std::sin(t); };
    const int stages = GENERATE(3, 5);
    double before = 0.0, steps_before = 0.0;
    int checked = 0;
    for (const int steps : {5, 6, 7, 8}) {
        Chain scene = chain(1, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, stiffness, 1.0);
        scene.model.pin(scene.first());
        scene.model.set_rate(scene.last(), Field::r, {amplitude, 0.0, 0.0});
        scene.model.add(Force<3>(scene.last(), {1.0, 0.0, 0.0}), [=](double t) {
            return -amplitude * std::sin(t) / 3.0 + stiffness * 0.5 * (r(t) * r(t) - 1.0) * r(t);
        });
        RadauOptions options = fixed(stages, end / steps);
        options.newton_tolerance = 1e-15;
        Schedule schedule = until(end);
        for (int k = 1; k <= steps; ++k) schedule.times.push_back(k * end / steps);
        double error = 0.0;
        schedule.observe = [&](const Snapshot& at) {
            error = std::max(error, std::abs(at.state.q[3] - r(at.state.time)));
        };
        REQUIRE(run(scene.model, options, schedule).status == Status::converged);
        CAPTURE(stages, steps, error);
        if (before > 0.0) {  // 4.93 to 4.97 and 8.97 to 8.99 measured
            CHECK(std::log(before / error) / std::log(steps / steps_before) ==
                  Approx(2.0 * stages - 1.0).margin(0.1));
            ++checked;
        }
        before = error;
        steps_before = steps;
    }
    CHECK(checked == 3);
}

/// Errors of a run of the soft swing.
struct Errors {
    double q = 0.0, multipliers = 0.0;  // at the end
    double acceleration = 0.0;          // at the end, as the last stage has it
    double rate = 0.0;                  // largest |G v| of a step
    double steps = 0.0, between = 0.0;  // largest of q at the ends of steps, and between them
    double rates_between = 0.0, multipliers_between = 0.0;  // largest of v and lambda between them
};

/// Returns the accelerations of a state, no coordinate of which is held.
VectorX accelerations(Scene& model, const State& state) {
    DynamicProblem problem(model);
    REQUIRE(problem.size() == state.q.size());
    VectorX result, multipliers;
    REQUIRE(problem.accelerations(state.time, state.q, state.v, result, multipliers) ==
            Status::converged);
    return result;
}

/// Runs the soft swing in steps of which five or ten fill a tenth of the time.
Errors swing_errors(int stages, bool link, int steps) {
    Chain scene = soft_swing(link);
    RadauOptions options = fixed(stages, swing_end / steps);
    options.newton_tolerance = 1e-15;
    const std::vector<State>& exact = exact_soft_swing(link);
    Schedule schedule = equal_intervals(0.0, swing_end, swing_end / swing_outputs);
    Errors errors;
    std::size_t at = 0;
    schedule.observe = [&](const Snapshot& seen) {
        if (at > 0) {
            const double error = distance(seen.state.q, exact[at - 1].q);
            const double place = seen.state.time * steps / swing_end;
            const bool at_step = std::abs(place - std::round(place)) < 1e-9;
            double& largest = at_step ? errors.steps : errors.between;
            largest = std::max(largest, error);
            if (!at_step) {
                errors.rates_between =
                    std::max(errors.rates_between, distance(seen.state.v, exact[at - 1].v));
                if (link)
                    errors.multipliers_between =
                        std::max(errors.multipliers_between,
                                 distance(seen.state.multipliers, exact[at - 1].multipliers));
            }
        }
        ++at;
    };
    const DynamicsReport report = run(scene.model, options, schedule);
    REQUIRE(report.status == Status::converged);
    errors.q = distance(scene.model.state().q, exact.back().q);
    if (link) {
        errors.multipliers = distance(scene.model.state().multipliers, exact.back().multipliers);
        errors.acceleration = distance(report.memory.get("acceleration", exact.back().q.size()),
                                       accelerations(scene.model, exact.back()));
    }
    errors.rate = report.violation_rate;
    return errors;
}

TEST_CASE("Radau IIA: three stages are of order 5, 3 and 2 in q, |G v| and lambda",
          "[dynamics][radau]") {
    const bool link = GENERATE(false, true);
    const Errors coarse = swing_errors(3, link, 40), fine = swing_errors(3, link, 80);
    CAPTURE(link, coarse.q, fine.q);
    CHECK(std::log2(coarse.q / fine.q) == Approx(5.0).margin(0.1));  // 4.92, 4.99 measured
    if (!link) return;
    CHECK(std::log2(coarse.rate / fine.rate) == Approx(3.0).margin(0.1));
    CHECK(std::log2(coarse.multipliers / fine.multipliers) == Approx(2.0).margin(0.1));
    CHECK(std::log2(coarse.acceleration / fine.acceleration) == Approx(2.0).margin(0.1));
}

TEST_CASE("Radau IIA: five stages are of order 9, 5 and 4 in q, |G v| and lambda",
          "[dynamics][radau]") {
    const bool link = GENERATE(false, true);
    const Errors coarse = swing_errors(5, link, 8), fine = swing_errors(5, link, 12);
    CAPTURE(link, coarse.q, fine.q);
    // 8.5 and 8.7 measured, rising to where round-off begins
    CHECK(std::log(coarse.q / fine.q) / std::log(1.5) == Approx(9.0).margin(0.6));
    if (!link) return;
    const Errors short_steps = swing_errors(5, link, 40), shorter = swing_errors(5, link, 80);
    CHECK(std::log2(short_steps.multipliers / shorter.multipliers) == Approx(4.0).margin(0.1));
    CHECK(std::log2(short_steps.acceleration / shorter.acceleration) == Approx(4.0).margin(0.1));
}

TEST_CASE("Radau IIA: |G v| is of the order of the stages' number", "[dynamics][radau]") {
    const int stages = GENERATE(3, 5);
    // within a second it grows to where round-off, 2e-12, is no limit
    double rates[2];
    for (const int fine : {0, 1}) {
        Chain scene = soft_swing(true);
        RadauOptions options = fixed(stages, fine == 1 ? 1.0 / 160.0 : 1.0 / 80.0);
        options.newton_tolerance = 1e-15;
        const DynamicsReport report = run(scene.model, options, until(1.0));
        REQUIRE(report.status == Status::converged);
        rates[fine] = report.violation_rate;
    }
    CAPTURE(stages, rates[0], rates[1]);
    // 2.99, 4.99 measured
    CHECK(std::log2(rates[0] / rates[1]) == Approx(stages).margin(0.1));
}

TEST_CASE("Radau IIA: rates and accelerations along the constraints are of the order of q",
          "[dynamics][radau]") {
    constexpr double end = 0.7;
    static const State exact = exact_states([] { return soft_swing(true); }, end, 3500, 1).back();
    const int stages = GENERATE(3, 5);
    const int coarse = stages == 3 ? 40 : 16, fine = stages == 3 ? 80 : 25;
    enum { q, rates, output, accelerations_along, accelerations_of_output, count };
    double errors[2][count];
    for (const int which : {0, 1}) {
        Chain scene = soft_swing(true);
        DynamicProblem problem(scene.model);
        EigenLu solver;
        RadauOptions options = fixed(stages, end / (which == 0 ? coarse : fine));
        options.newton_tolerance = 1e-15;
        State seen;
        Schedule schedule = until(end);
        schedule.times = {end};
        schedule.observe = [&](const Snapshot& at) { seen = at.state; };
        const Memory memory = RadauIIA(options).integrate(problem, solver, schedule).memory;
        const VectorX exact_acceleration = accelerations(scene.model, exact);
        VectorX v = memory.get("v", problem.size());
        VectorX acceleration = memory.get("acceleration", problem.size());
        REQUIRE(problem.project_rates(end, exact.q, v));
        REQUIRE(problem.project_accelerations(end, exact.q, exact.v, acceleration));
        errors[which][q] = distance(memory.get("q", problem.size()), exact.q);
        errors[which][rates] = distance(v, exact.v);
        errors[which][output] = distance(seen.v, exact.v);
        errors[which][accelerations_along] = distance(acceleration, exact_acceleration);
        errors[which][accelerations_of_output] =
            distance(accelerations(scene.model, seen), exact_acceleration);
    }
    const double finer = std::log(static_cast<double>(fine) / coarse);
    for (int k = 0; k < count; ++k) {
        CAPTURE(stages, k, errors[0][k], errors[1][k]);
        // 4.97 to 5.00, 8.76 to 9.19 measured
        CHECK(std::log(errors[0][k] / errors[1][k]) / finer ==
              Approx(2.0 * stages - 1.0).margin(stages == 3 ? 0.1 : 0.4));
    }
}

TEST_CASE("Radau IIA: output between steps is of the order of the steps", "[dynamics][radau]") {
    const bool link = GENERATE(false, true);
    CAPTURE(link);
    const Errors coarse = swing_errors(3, link, 10), fine = swing_errors(3, link, 25);
    // 4.97, 5.03 measured
    CHECK(std::log(coarse.between / fine.between) / std::log(2.5) == Approx(5.0).margin(0.1));
    CHECK(fine.between <= 1.1 * fine.steps);
    const Errors forty = swing_errors(3, link, 40), eighty = swing_errors(3, link, 80);
    // 5.08, 4.99 measured
    CHECK(std::log2(forty.rates_between / eighty.rates_between) == Approx(5.0).margin(0.1));
    const Errors five = swing_errors(5, link, 5), ten = swing_errors(5, link, 10);
    // 8.8, 8.6 measured, and 0.9 to 1.7 times the largest error at the ends of steps
    CHECK(std::log2(five.between / ten.between) >= 8.5);
    // 8.8, 8.1 measured: a polynomial's derivative is of one order less
    CHECK(std::log2(five.rates_between / ten.rates_between) >= 7.9);
    CHECK(five.between / five.steps <= 2.0);
    CHECK(ten.between / ten.steps <= 2.0);
    if (!link) return;
    // 1.96, 4.05 measured, at equal places within the steps
    CHECK(std::log2(forty.multipliers_between / eighty.multipliers_between) ==
          Approx(2.0).margin(0.1));
    CHECK(std::log2(ten.multipliers_between / swing_errors(5, link, 40).multipliers_between) ==
          Approx(8.0).margin(0.2));
}

TEST_CASE("Radau IIA: the estimate of the error is of order s + 1", "[dynamics][radau]") {
    const int stages = GENERATE(3, 5);
    const bool link = GENERATE(false, true);
    double steps[2];
    for (const int which : {0, 1}) {
        Chain scene = soft_swing(link);
        const RadauOptions options = adaptive(stages, which == 0 ? 1e-8 : 1e-10);
        const DynamicsReport report = run(scene.model, options, until(5.0));
        REQUIRE(report.status == Status::converged);
        steps[which] = static_cast<double>(report.steps);
    }
    CAPTURE(stages, link, steps[0], steps[1]);
    // 4.01 and 4.05, 6.12 and 6.15 measured
    CHECK(std::log(100.0) / std::log(steps[1] / steps[0]) == Approx(stages + 1.0).margin(0.2));
}

TEST_CASE("Radau IIA: the error of adaptive runs follows the tolerance, at all times",
          "[dynamics][radau]") {
    const int stages = GENERATE(3, 5);
    const bool link = GENERATE(false, true);
    const std::vector<State>& exact = exact_soft_swing(link);
    double before = std::numeric_limits<double>::infinity();
    int checked = 0;
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
        Chain scene = soft_swing(link);
        const double size = DynamicProblem(scene.model).length_scale();
        Schedule schedule = equal_intervals(0.0, swing_end, swing_end / swing_outputs);
        double error = 0.0;
        std::size_t at = 0;
        schedule.observe = [&](const Snapshot& seen) {
            if (at > 0) error = std::max(error, distance(seen.state.q, exact[at - 1].q) / size);
            ++at;
        };
        const DynamicsReport report = run(scene.model, adaptive(stages, tolerance), schedule);
        REQUIRE(report.status == Status::converged);
        CAPTURE(stages, link, tolerance, error, report.steps);
        CHECK(error <= 3.0 * tolerance);
        CHECK(error < before);
        before = error;
        ++checked;
    }
    CHECK(checked == 6);
}

/// Checks that a scene ends where the Runge-Kutta method takes it.
/// @param steps   of the Runge-Kutta method
/// @param margin  largest difference of coordinates
template <class Make>
void check_end(const Make& make, double end, int steps, double step, double margin) {
    const State exact = exact_states(make, end, steps, 1).back();
    for (const int stages : {3, 5})
        for (const bool by_tolerance : {false, true}) {
            CAPTURE(stages, by_tolerance);
            auto scene = make();
            RadauOptions options = fixed(stages, step);
            if (by_tolerance) options.tolerance = 1e-8;
            const DynamicsReport report = run(scene.model, options, until(end));
            CAPTURE(report.message);
            REQUIRE(report.status == Status::converged);
            CHECK(distance(scene.model.state().q, exact.q) <= margin);
        }
}

TEST_CASE("Radau IIA: damped motions", "[dynamics][radau]") {
    const bool link = GENERATE(false, true);
    check_end(
        [=] {
            Chain scene = soft_swing(link);
            MatrixX damping = MatrixX::Zero(6, 6);
            damping.diagonal().setConstant(1.3);
            damping(0, 4) = 0.4;  // unsymmetric
            const Coupling ends = {{scene.nodes[1], Field::r}, {scene.nodes[2], Field::r}};
            scene.model.add(LinearDamping(ends, damping));
            return scene;
        },
        0.5, 1000, 0.01, 1e-8);
}

TEST_CASE("Radau IIA: driven supports", "[dynamics][radau]") {
    check_end(
        [] {
            Chain scene = chain(2, {0.0, -0.5, 0.0}, {1.2, -0.5, 0.0}, 20.0);
            const Motion path = sine(0.2, 7.0);
            for (const int k : {0, 2}) scene.model.fix(scene.first(), Field::r, k);
            scene.model.prescribe(
                scene.first(), Field::r, 1, [=](double t) { return path.value(t) - 0.5; },
                path.rate, path.acceleration);
            scene.model.state().v[1] = path.rate(0.0);
            return scene;
        },
        0.5, 1000, 0.01, 2e-8);
}

TEST_CASE("Radau IIA: lengths that are driven", "[dynamics][radau]") {
    check_end(
        [] {
            Chain scene = chain(2, {0.0, -0.5, 0.0}, {1.2, -0.5, 0.0}, 20.0);
            const Motion change = sine(0.1, 5.0);
            scene.model.add(Distance<3>(scene.first(), Vector3(0.0, 0.0, 0.0),
                                        Motion{[=](double t) { return 0.5 + change.value(t); },
                                               change.rate, change.acceleration}));
            for (const NodeId node : scene.nodes)
                scene.model.set_rate(node, Field::r, {0.0, -change.rate(0.0), 0.0});
            scene.model.set_gravity({0.0, -2.0, 0.0});
            return scene;
        },
        0.5, 1000, 0.01, 1e-8);
}

/// Two rubber elements in the plane, pinned, pushed by a force or moment that follows.
struct Pushed {
    PlanarModel model;
    NodeId last;
};

TEST_CASE("Radau IIA: loads that follow", "[dynamics][radau]") {
    check_end(
        [] {
            Pushed scene;
            const auto beam = straight_beam<CrossSectionBeam<2>>(
                scene.model, Material::isotropic(1e5, 0.3, 1000.0), rectangle(0.1, 0.1), {0.0, 0.0},
                {1.0, 0.0}, 2, CrossSectionOptions::best());
            scene.last = beam.last();
            scene.model.pin(beam.first());
            scene.model.add(PlanarSlopeMoment(beam.last(), Field::r_y, 0.3));
            return scene;
        },
        0.2, 2000, 1e-3, 1e-7);
}

TEMPLATE_TEST_CASE("Radau IIA: driven joints turn by the angle in steps of any length",
                   "[dynamics][radau]", DrivenArm, DrivenCrank) {
    int checked = 0;
    for (const double angle : {0.1, 1.7, pi, 10.0})
        for (const int steps : {1, 4, 16})
            for (const bool by_tolerance : {false, true}) {
                CAPTURE(angle, steps, by_tolerance);
                TestType arm(smooth_turn(angle));
                RadauOptions options = fixed(3, 1.0 / steps);
                if (by_tolerance) options.tolerance = 1e-4;
                const DynamicsReport report = run(arm.model, options, until(1.0));
                CAPTURE(report.message);
                if (by_tolerance || angle < 7.0 || steps == 16)
                    CHECK(report.status == Status::converged);
                if (report.status == Status::converged) {
                    CHECK(arm.off(angle) <= 1e-9);
                    CHECK(arm.wound() <= 0.5);
                } else {
                    CHECK_FALSE(report.message.empty());
                }
                ++checked;
            }
    CHECK(checked == 24);
}

TEST_CASE("Radau IIA: a driven angle that jumps ends the motion and names the joint",
          "[dynamics][radau]") {
    const Motion jump{[](double t) { return t > 0.5 ? 4.0 : 0.0; }, [](double) { return 0.0; },
                      [](double) { return 0.0; }};
    for (const bool by_tolerance : {false, true}) {
        DrivenArm arm(jump);
        RadauOptions options = fixed(3, 0.3);
        if (by_tolerance) options.tolerance = 1e-4;
        const DynamicsReport report = run(arm.model, options, until(1.0));
        CHECK(report.status != Status::converged);
        CHECK_THAT(report.message, ContainsSubstring("planar weld of node 0 and space"));
        CHECK_THAT(report.message, ContainsSubstring("driven by 4 rad"));
        CHECK(report.time <= 0.5);
    }
}

TEST_CASE("Radau IIA: redundant rows change no motion", "[dynamics][radau]") {
    const int stages = GENERATE(3, 5);
    VectorX ends[2], forces[2];
    for (const bool twice : {false, true}) {
        Chain scene = soft_swing(true);
        if (twice) scene.model.add(Distance<3>(scene.first(), Vector3(0.0, 0.0, 0.0), 0.5));
        ProblemOptions options;
        options.redundancy = Redundancy::minimum_norm;
        DynamicProblem problem(scene.model, options);
        EigenLu solver;
        RadauOptions fine = fixed(stages, 5e-3);
        fine.newton_tolerance = 1e-15;
        const DynamicsReport report = RadauIIA(fine).integrate(problem, solver, until(0.5));
        REQUIRE(report.status == Status::converged);
        ends[twice] = scene.model.state().q;
        forces[twice] = scene.model.state().multipliers;
    }
    CHECK(distance(ends[0], ends[1]) <= 1e-12);
    CHECK(forces[1][0] == Approx(0.5 * forces[0][0]).epsilon(1e-7));
    CHECK(forces[1][1] == Approx(0.5 * forces[0][0]).epsilon(1e-7));
}

TEST_CASE("Radau IIA: a restarted run continues bit for bit", "[dynamics][radau]") {
    const int stages = GENERATE(3, 5);
    const bool by_tolerance = GENERATE(false, true);
    CAPTURE(stages, by_tolerance);
    const RadauOptions options = by_tolerance ? adaptive(stages, 1e-6) : fixed(stages, 5e-3);
    // cut where it steps anyway
    double middle = 0.0;
    Chain probe = swing();
    Schedule schedule = until(0.5);
    schedule.progress = [&](double time, double) {
        middle = time;
        return time < 0.2;
    };
    REQUIRE(run(probe.model, options, schedule).status == Status::stopped);
    Chain parts = swing(), whole = swing(), resumed = swing();
    schedule.progress = [&](double time, double) { return time < middle; };
    const DynamicsReport first = run(parts.model, options, schedule);
    REQUIRE(first.status == Status::stopped);
    std::stringstream file;
    write_state(file, {parts.model.state(), first.memory});
    const SavedState saved = read_state(file);
    resumed.model.state() = saved.state;

    VectorX seen[2];
    int which = 0;
    Schedule rest = until(0.5);
    rest.times = {middle + 2e-3};
    rest.observe = [&](const Snapshot& at) { seen[which] = at.state.q; };
    const DynamicsReport second = run(resumed.model, options, rest, saved.memory);
    REQUIRE(second.status == Status::converged);
    which = 1;
    const DynamicsReport all = run(whole.model, options, rest);
    REQUIRE(all.status == Status::converged);
    CHECK(all.steps == first.steps + second.steps);
    CHECK(resumed.model.state().q == whole.model.state().q);
    CHECK(resumed.model.state().v == whole.model.state().v);
    CHECK(resumed.model.state().multipliers == whole.model.state().multipliers);
    CHECK(seen[0] == seen[1]);
}

TEST_CASE("Radau IIA: times of output change no bit of a motion", "[dynamics][radau]") {
    const int stages = GENERATE(3, 5);
    Chain plain = swing(), observed = swing();
    REQUIRE(run(plain.model, adaptive(stages, 1e-5), until(0.3)).status == Status::converged);
    Schedule schedule = equal_intervals(0.0, 0.3, 7.1e-4);
    std::size_t seen = 0;
    double largest = 0.0;
    schedule.observe = [&](const Snapshot& at) {
        CHECK(at.state.time == Approx(schedule.times[seen]).margin(1e-12));
        largest = std::max({largest, at.violation, at.violation_rate});
        ++seen;
    };
    REQUIRE(run(observed.model, adaptive(stages, 1e-5), schedule).status == Status::converged);
    CHECK(seen == schedule.times.size());
    CHECK(largest <= 1e-14);  // on the constraints at every time
    CHECK(observed.model.state().q == plain.model.state().q);
    CHECK(observed.model.state().v == plain.model.state().v);
}

TEST_CASE("Radau IIA: solvers of lower and full storage take the same steps", "[dynamics][radau]") {
    const int stages = GENERATE(3, 5);
    VectorX ends[2];
    for (const bool lower : {false, true}) {
        Chain scene = soft_swing(false);
        ProblemOptions storage;
        storage.storage = lower ? Storage::lower : Storage::full;
        DynamicProblem problem(scene.model, storage);
        EigenLu lu;
        Automatic automatic;
        const RadauIIA method(adaptive(stages, 1e-6));
        const DynamicsReport report = lower ? method.integrate(problem, automatic, until(0.3))
                                            : method.integrate(problem, lu, until(0.3));
        REQUIRE(report.status == Status::converged);
        ends[lower] = scene.model.state().q;
        if (lower) CHECK_THROWS_AS(method.integrate(problem, lu, until(0.4)), InvalidArgument);
    }
    CHECK(distance(ends[0], ends[1]) <= 1e-12);
}

TEST_CASE("Radau IIA: wrong calls are refused", "[dynamics][radau]") {
    const auto refused = [](auto change, const char* word) {
        RadauOptions options;
        change(options);
        CHECK_THROWS_WITH(RadauIIA(options), ContainsSubstring(word));
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    refused([](RadauOptions& o) { o.stages = 4; }, "stages");
    refused([](RadauOptions& o) { o.tolerance = -1.0; }, "tolerance");
    refused([=](RadauOptions& o) { o.tolerance = nan; }, "tolerance");
    refused([](RadauOptions& o) { o.step = 0.0; }, "step");
    refused([](RadauOptions& o) { o.min_step = 0.0; }, "min_step");
    refused([](RadauOptions& o) { o.max_step = 1e-13; }, "max_step");
    refused([](RadauOptions& o) { o.newton_tolerance = -1.0; }, "newton_tolerance");
    refused([](RadauOptions& o) { o.max_iterations = 1; }, "max_iterations");

    Chain scene = swing();
    const DynamicsReport report = run(scene.model, adaptive(3, 1e-5), until(0.01));
    REQUIRE(report.status == Status::converged);
    CHECK_THROWS_WITH(run(scene.model, adaptive(5, 1e-5), until(0.02), report.memory),
                      ContainsSubstring("stages"));
    Memory other = report.memory;
    other.integrator = "energy_momentum";
    CHECK_THROWS_WITH(run(scene.model, adaptive(3, 1e-5), until(0.02), other),
                      ContainsSubstring("that of energy_momentum"));
    other = report.memory;
    other.values.erase(other.values.begin());
    CHECK_THROWS_WITH(run(scene.model, adaptive(3, 1e-5), until(0.02), other),
                      ContainsSubstring("values of q"));
    CHECK_THROWS_AS(run(scene.model, adaptive(3, 1e-5), until(0.005)), InvalidArgument);
    scene.model.state().v.conservativeResize(2);
    CHECK_THROWS_WITH(run(scene.model, adaptive(3, 1e-5), until(0.02)),
                      ContainsSubstring("2 rates"));
    Chain still = chain(2, {0.0, 0.0, 0.0}, {2.0, 0.0, 0.0});
    for (const NodeId node : still.nodes) still.model.pin(node);
    CHECK_THROWS_WITH(run(still.model, adaptive(3, 1e-5), until(0.1)),
                      ContainsSubstring("no free coordinate"));
}

TEST_CASE("Radau IIA: no step, a huge one, a load that is not finite", "[dynamics][radau]") {
    const bool by_tolerance = GENERATE(false, true);
    CAPTURE(by_tolerance);
    const RadauOptions options = by_tolerance ? adaptive(3, 1e-5) : fixed(3, 1e-3);
    Chain none = swing();
    const VectorX start = none.model.state().q;
    const DynamicsReport nothing = run(none.model, options, until(0.0));
    CHECK(nothing.status == Status::converged);
    CHECK(nothing.steps == 0);
    CHECK(none.model.state().q == start);

    Chain once = swing();
    RadauOptions huge = options;
    huge.step = 1e6;
    const DynamicsReport leap = run(once.model, huge, until(20.0));
    CHECK(once.model.state().q.allFinite());
    if (leap.status != Status::converged) CHECK_FALSE(leap.message.empty());

    for (const double from : {0.0, 0.05}) {
        CAPTURE(from);
        Chain broken = swing();
        broken.model.add(Force<3>(broken.last(), {1.0, 0.0, 0.0}), [=](double t) {
            return t >= from ? std::numeric_limits<double>::quiet_NaN() : 1.0;
        });
        const DynamicsReport report = run(broken.model, options, until(0.1));
        CHECK(report.status != Status::converged);
        CHECK_FALSE(report.message.empty());
        CHECK(report.time <= from);
        CHECK(broken.model.state().q.allFinite());
    }
}

/// Returns the correction that the last step of a run lacks, relative to the scene's size, by
/// Newton's method with the tangent of every stage.
/// @param start  of that step
double correction_left(DynamicProblem& problem, const Memory& memory, const State& start,
                       int stages) {
    const int n = problem.size(), m = problem.multipliers(), all = stages * (n + m);
    static const detail::RadauTableau three = detail::radau_tableau(3),
                                      five = detail::radau_tableau(5);
    const detail::RadauTableau& table = stages == 3 ? three : five;
    const double h = memory.get("scalars", 15)[4];
    const VectorX &q = start.q, &v = start.v;
    const VectorX accelerations = memory.get("stage_accelerations", n * stages);
    const VectorX lambdas = memory.get("stage_multipliers", m * stages);
    const MatrixX A = test::inverted(table.inverse);
    MatrixX matrix = MatrixX::Zero(all, all);
    VectorX rest(all);
    for (int i = 0; i < stages; ++i) {
        const double c = table.nodes[static_cast<std::size_t>(i)];
        VectorX Q = q + h * c * v, V = v;
        for (int j = 0; j < stages; ++j) {
            Q += h * h * table.double_integral(i, j) * accelerations.segment(j * n, n);
            V += h * A(i, j) * accelerations.segment(j * n, n);
        }
        const VectorX lambda = lambdas.segment(i * m, m);
        if (problem.evaluate(start.time + c * h, Q, V, lambda, Request::tangent_and_damping))
            return std::numeric_limits<double>::infinity();
        const int row = i * (n + m);
        rest.segment(row, n) =
            -(problem.force() + problem.compact_mass() * accelerations.segment(i * n, n));
        rest.segment(row + n, m) = -problem.constraint_residual() / (h * h);
        const MatrixX tangent = MatrixX(problem.tangent());
        for (int j = 0; j < stages; ++j) {  // unknowns: corrections of Y and of the multipliers
            auto block = matrix.block(row, j * (n + m), n + m, n + m);
            block.topLeftCorner(n, n) =
                table.square(i, j) * MatrixX(problem.compact_mass()) +
                h * table.inverse(i, j) * MatrixX(problem.damping()).topLeftCorner(n, n);
            if (i != j) continue;
            block.topLeftCorner(n, n) += h * h * tangent.topLeftCorner(n, n);
            block.topRightCorner(n, m) = tangent.topRightCorner(n, m);
            block.bottomLeftCorner(m, n) = tangent.bottomLeftCorner(m, n);
            block.bottomRightCorner(m, m) = tangent.bottomRightCorner(m, m);  // of those left out
        }
    }
    const VectorX correction = test::solved(matrix, rest);
    double largest = 0.0;
    for (int i = 0; i < stages; ++i)
        largest = std::max(
            largest,
            h * h * detail::largest_ratio(correction.segment(i * (n + m), n), problem.scales()));
    return correction.allFinite() ? largest : std::numeric_limits<double>::infinity();
}

/// Runs some steps of a random scene; returns the report and leaves the scene where they end.
template <class Scene>
DynamicsReport run_random_scene(Scene& scene, DynamicProblem& problem, double tolerance,
                                long steps) {
    EigenLu solver;
    RadauOptions options = fixed(scene.stages, scene.step);
    if (scene.by_tolerance) options.tolerance = tolerance;
    options.follow_energy = false;
    Schedule schedule = until(10.0 * scene.step);
    schedule.progress = [&](double, double) { return --steps > 0; };
    return RadauIIA(options).integrate(problem, solver, schedule);
}

/// Checks that a run's last step ends on the constraints to its tolerance, and the state to
/// round-off.
void check_constraints(DynamicProblem& problem, const DynamicsReport& report, double tolerance) {
    if (problem.multipliers() == 0 || report.status == Status::degenerate) return;
    const double size = std::max(1.0, problem.length_scale());
    problem.evaluate_constraints(report.time, report.memory.get("q", problem.size()),
                                 report.memory.get("v", problem.size()));
    CHECK(problem.constraint_violation() <= 10.0 * tolerance * size);
    VectorX q, v;
    problem.numbering().gather_free(problem.model().state().q, q);
    problem.numbering().gather_free(problem.model().state().v, v);
    problem.evaluate_constraints(report.time, q, v);
    CHECK(problem.constraint_violation() <= 1e-12 * size);
    CHECK(problem.violation_rate() <= 1e-9 * size * problem.largest_ratio(v));
}

/// Runs a few steps of a random scene and checks the last one; returns whether a step converged.
template <class Scene>
bool check_random_scene(std::uint64_t seed) {
    constexpr double tolerance = 1e-4;
    Random random(seed);
    Scene scene(random);
    ProblemOptions options;
    options.redundancy = Redundancy::minimum_norm;
    DynamicProblem problem(scene.model, options);
    const DynamicsReport report = run_random_scene(scene, problem, tolerance, 4);
    CAPTURE(seed, report.message, report.steps, scene.step, scene.stages, scene.by_tolerance);
    const State& state = scene.model.state();
    CHECK(state.q.allFinite());
    CHECK(state.v.allFinite());
    if (report.status != Status::converged) CHECK_FALSE(report.message.empty());
    if (report.steps == 0) CHECK(report.status != Status::converged);
    if (report.steps == 0) return false;
    CHECK(report.smallest_step >= 1e-6 * scene.step);
    // where the last step began: where a run of one step less ends
    Random again(seed);
    Scene before(again);
    DynamicProblem earlier(before.model, options);
    const Start first = earlier.start();
    State start;
    start.time = first.time;
    start.q = first.q;
    start.v = first.v;
    if (report.steps > 1) {
        const Memory memory = run_random_scene(before, earlier, tolerance, report.steps - 1).memory;
        start.time = memory.get("scalars", 15)[0];
        start.q = memory.get("q", problem.size());
        start.v = memory.get("v", problem.size());
    }
    // far below the error that is allowed; fixed steps iterate to round-off
    const double allowed = scene.by_tolerance ? tolerance : 1e-10;
    CHECK(correction_left(problem, report.memory, start, scene.stages) <= allowed);
    check_constraints(problem, report, allowed);
    return true;
}

/// Checks a scene of one of the elements.
template <template <class> class Scene>
bool check_random_scene_of_any(std::uint64_t seed) {
    switch (seed % 4) {
        case 0: return check_random_scene<Scene<CrossSectionBeam<2>>>(seed);
        case 1: return check_random_scene<Scene<CrossSectionBeam<3>>>(seed);
        case 2: return check_random_scene<Scene<Cable<2>>>(seed);
        default: return check_random_scene<Scene<Cable<3>>>(seed);
    }
}

/// Runs random scenes of every kind, each fifth with joints; returns in how many a step converged.
int check_random_scenes(std::uint64_t first, int count) {
    int converged = 0;
    for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count); ++seed) {
        const bool good = seed % 5 == 4 ? check_random_scene_of_any<JointedScene>(seed)
                                        : check_random_scene_of_any<RandomScene>(seed);
        converged += good ? 1 : 0;
    }
    return converged;
}

TEST_CASE("Radau IIA: fixed steps do not believe a first ratio that flatters",
          "[dynamics][radau]") {
    // 1.3e-10 of the scene's size was left, after an estimate of 4e-14
    CHECK(check_random_scene<RandomScene<Cable<3>>>(1026747));
}

TEST_CASE("Radau IIA: what converges has a small residual, in random scenes", "[dynamics][radau]") {
    CHECK(check_random_scenes(1, 100) >= 98);
}

// by dynamics.random_scenes, fifteen seconds
TEST_CASE("Radau IIA: what converges has a small residual, in ten thousand random scenes",
          "[.][radau-long]") {
    CHECK(check_random_scenes(1000, 10000) >= 9900);
}

TEST_CASE("RadauIIA: a scene whose load its constraints take whole stays at rest to the end",
          "[radau]") {
    // corrections are round-off of nothing, 1e-50, and do not shrink
    const int stages = GENERATE(3, 5);
    int checked = 0;
    for (double length = 0.5; length < 0.6; length += 0.001) {
        INFO("stages " << stages << ", length " << length);
        Model model;
        const auto cable =
            straight_beam<Cable<3>>(model, Material::isotropic(2e8, 0.3, 7850.0), circle(0.02),
                                    {0.0, 0.0, 0.0}, {0.0, 0.0, -length}, 1);
        model.add(Pin<3>(cable.first(), {0.0, 0.0, 0.0}));
        model.add(AlignedTangent(model, cable.first()));
        model.add(Force<3>(cable.first(), {0.0, 3.0, 0.0}));
        const VectorX before = model.state().q;
        DynamicProblem problem(model);
        EigenLu solver;
        Schedule schedule;
        schedule.end = 0.05;
        RadauOptions options;
        options.stages = stages;
        const auto report = RadauIIA(options).integrate(problem, solver, schedule);
        INFO(report.message);
        REQUIRE(report.status == Status::converged);
        CHECK(report.steps <= 1000);
        CHECK((model.state().q - before).norm() <= 1e-15);
        CHECK(model.state().multipliers[1] == Approx(3.0).epsilon(1e-12));
        ++checked;
    }
    CHECK(checked == 100);
}

}  // namespace radau_test
