// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Runs of Radau IIA and the scene that its tests of order share.

#pragma once

#include <ancf/dynamics/radau.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/solver/eigen_solver.hpp>

#include <dynamics/scenes.hpp>

#include <cstddef>
#include <vector>

namespace radau_test {

using namespace ancf;
using namespace ancf::test;
using ancf::test::Chain;

inline RadauOptions fixed(int stages, double step) {
    RadauOptions options;
    options.stages = stages;
    options.step = step;
    options.tolerance = 0.0;
    return options;
}

inline RadauOptions adaptive(int stages, double tolerance) {
    RadauOptions options;
    options.stages = stages;
    options.tolerance = tolerance;
    return options;
}

inline DynamicsReport run(Scene& model, const RadauOptions& options, const Schedule& schedule,
                          const Memory& memory = {}) {
    DynamicProblem problem(model);
    EigenLu solver;
    return RadauIIA(options).integrate(problem, solver, schedule, memory);
}

/// Two soft bars on a massless link, thrown out of the plane of gravity; vibrations of up to 35
/// rad/s.
inline Chain soft_swing(bool link) {
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
inline const std::vector<State>& exact_soft_swing(bool link) {
    const auto limit = [](bool on_link) {
        return exact_states([=] { return soft_swing(on_link); }, swing_end, 2500, swing_outputs);
    };
    static const std::vector<State> free = limit(false), linked = limit(true);
    return link ? linked : free;
}

}  // namespace radau_test
