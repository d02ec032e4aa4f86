// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Scenes of bars for the tests of integrators: cheap to evaluate and to compile.

#pragma once

#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/report.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <support/bar.hpp>
#include <support/catch.hpp>

#include <cmath>
#include <vector>

namespace ancf::test {

using Vector3 = Vector<double, 3>;

/// Returns a schedule that ends at a time and reports nothing on the way.
[[nodiscard]] inline Schedule until(double end) {
    Schedule schedule;
    schedule.end = end;
    return schedule;
}

/// Bars in a row.
struct Chain {
    Model model;
    std::vector<NodeId> nodes;

    [[nodiscard]] NodeId first() const { return nodes.front(); }
    [[nodiscard]] NodeId last() const { return nodes.back(); }
};

/// Returns a chain of equal bars, EA in N, mass per length in kg/m.
[[nodiscard]] inline Chain chain(int bars, const Vector3& from, const Vector3& to,
                                 double stiffness = 500.0, double line_density = 1.0) {
    Chain result;
    const double length = (to - from).norm() / bars;
    const int prototype = result.model.add_prototype(Bar<3>(stiffness, line_density, length));
    for (int k = 0; k <= bars; ++k)
        result.nodes.push_back(result.model.add_node(from + (to - from) * k / bars));
    for (int k = 0; k < bars; ++k) {
        const auto at = static_cast<std::size_t>(k);
        result.model.connect<Bar<3>>(prototype, result.nodes[at], result.nodes[at + 1]);
    }
    return result;
}

/// Three bars on a massless link, thrown out of the plane of gravity.
[[nodiscard]] inline Chain swing() {
    Chain scene = chain(3, {0.0, -0.5, 0.0}, {1.2, -0.5, 0.0});
    scene.model.add(Distance<3>(scene.first(), Vector3(0.0, 0.0, 0.0), 0.5));
    scene.model.set_gravity({0.0, -9.81, 0.0});
    for (const NodeId node : scene.nodes) scene.model.set_rate(node, Field::r, {0.0, 0.0, 0.7});
    return scene;
}

/// Three bars that fall from beside their pin.
[[nodiscard]] inline Chain falling() {
    Chain scene = chain(3, {0.0, 0.0, 0.0}, {1.2, 0.0, 0.0});
    scene.model.pin(scene.first());
    scene.model.set_gravity({0.0, -9.81, 0.0});
    return scene;
}

/// Lets them fall for 0.3 s, with a solver of either storage.
template <class Method>
[[nodiscard]] DynamicsReport fall(Chain& scene, const Method& method, LinearSolver& solver) {
    ProblemOptions options;
    options.storage = solver.storage();
    DynamicProblem problem(scene.model, options);
    return method.integrate(problem, solver, until(0.3));
}

/// Returns states at equal times by the Runge-Kutta method of fourth order, every step projected on
/// the constraints.
/// @param outputs  how many, the start not among them
[[nodiscard]] inline std::vector<State> by_runge_kutta(Scene& model, double end, int steps,
                                                       int outputs) {
    DynamicProblem problem(model);
    const Start start = problem.start();
    REQUIRE(start.status == Status::converged);
    VectorX lambda;
    const auto acceleration = [&](double t, const VectorX& q, const VectorX& v) {
        VectorX a;
        REQUIRE(problem.accelerations(t, q, v, a, lambda) == Status::converged);
        return a;
    };
    const double h = end / steps;
    VectorX q = start.q, v = start.v;
    std::vector<State> states;
    for (int k = 1; k <= steps; ++k) {
        const double t = (k - 1) * h;
        const VectorX a1 = acceleration(t, q, v);
        const VectorX v2 = v + 0.5 * h * a1;
        const VectorX a2 = acceleration(t + 0.5 * h, q + 0.5 * h * v, v2);
        const VectorX v3 = v + 0.5 * h * a2;
        const VectorX a3 = acceleration(t + 0.5 * h, q + 0.5 * h * v2, v3);
        const VectorX v4 = v + h * a3;
        const VectorX a4 = acceleration(t + h, q + h * v3, v4);
        q += h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
        v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
        REQUIRE(problem.project(k * h, q, v));
        if (k % (steps / outputs) != 0) continue;
        static_cast<void>(acceleration(k * h, q, v));  // for its multipliers
        states.push_back(problem.state(k * h, q, v, lambda));
    }
    return states;
}

/// Returns the swing after half a second by that method: exact to 1e-7 (w h < 0.04).
[[nodiscard]] inline const State& exact_swing() {
    static const State state = [] {
        Chain scene = swing();
        return by_runge_kutta(scene.model, 0.5, 2500, 1).front();
    }();
    return state;
}

/// A motion A sin(w t) with its derivatives, smooth from t = 0 on.
[[nodiscard]] inline Motion sine(double amplitude, double frequency) {
    return {[=](double t) { return amplitude * std::sin(frequency * t); },
            [=](double t) { return amplitude * frequency * std::cos(frequency * t); },
            [=](double t) { return -amplitude * frequency * frequency * std::sin(frequency * t); }};
}

/// Returns the largest difference of two vectors.
[[nodiscard]] inline double distance(const VectorX& a, const VectorX& b) {
    return (a - b).cwiseAbs().maxCoeff();
}

}  // namespace ancf::test
