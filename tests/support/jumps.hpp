// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Loads and drives that jump within a run.

#pragma once

#include <ancf/constants.hpp>
#include <ancf/dynamics/problem.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <support/catch.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ancf::test {

/// What jumps.
enum class Jumps { load, load_twice, square_wave, gravity, support, joint };

/// A beam of two elements, 1 m long.
[[nodiscard]] inline Beam<CrossSectionBeam<2>> short_beam(PlanarModel& model) {
    return straight_beam<CrossSectionBeam<2>>(model, Material::isotropic(2e9, 0.3, 8000.0),
                                              rectangle(0.02, 0.02), {0, 0}, {1, 0}, 2);
}

/// A beam that swings about a pin, at first at rest.
struct JumpScene {
    static constexpr double first = 0.125, end = 0.4375;  // s

    explicit JumpScene(Jumps what) : beam(short_beam(model)) {
        const auto later = [](double t) { return t > first ? t - first : 0.0; };
        const Motion push{[=](double t) { return 0.5 * std::pow(later(t), 2); }, later,
                          [](double t) { return t > first ? 1.0 : 0.0; }};
        if (what == Jumps::joint) {
            model.add(PlanarWeld(model, beam.first(), push));
            return;
        }
        model.pin(beam.first());
        if (what == Jumps::gravity) model.set_gravity({0, -9.81}, push.acceleration);
        if (what == Jumps::support)
            model.prescribe(beam.last(), Field::r, 1, push.value, push.rate, push.acceleration);
        const Force<2> force(beam.last(), {0, 5});
        if (what == Jumps::load) model.add(force, push.acceleration);
        if (what == Jumps::load_twice)
            model.add(force, [](double t) { return t > first && !(t > 0.1875) ? 1.0 : 0.0; });
        if (what == Jumps::square_wave)
            model.add(force, [](double t) { return std::lround(std::ceil(t * 128.0)) % 2; });
    }

    PlanarModel model;
    Beam<CrossSectionBeam<2>> beam;
};

/// A pinned beam under a force that varies.
struct PushedBeam {
    explicit PushedBeam(Amplitude amplitude) : beam(short_beam(model)) {
        model.pin(beam.first());
        model.add(Force<2>(beam.last(), {0, 5}), std::move(amplitude));
    }

    PlanarModel model;
    Beam<CrossSectionBeam<2>> beam;
};

/// Acts from a time on, s.
[[nodiscard]] inline Amplitude acts_from(double time) {
    return [=](double t) { return t >= time ? 1.0 : 0.0; };
}

/// Another number at every instant.
[[nodiscard]] inline Amplitude noise() {
    return [](double t) {
        const double x = 1e9 * std::sin(1e9 * t);
        return x - std::floor(x);
    };
}

/// Runs to the end of a JumpScene by steps that end at every jump.
inline void run_exactly(PlanarModel& model) {
    DynamicProblem problem(model);
    EigenLu solver;
    RadauOptions options;
    options.stages = 5;
    options.tolerance = 0.0;
    options.step = 1.0 / 8192.0;
    Schedule schedule;
    schedule.end = JumpScene::end;
    REQUIRE(RadauIIA(options).integrate(problem, solver, schedule).status == Status::converged);
}

/// Returns the largest distance of a node from where it is in another scene, m.
template <class Scene>
[[nodiscard]] double apart(const Scene& a, const Scene& b) {
    double most = 0.0;
    for (int i = 0; i <= 2; ++i)
        most = std::max(
            most, (a.model.position(a.beam.nodes[i]) - b.model.position(b.beam.nodes[i])).norm());
    return most;
}

/// Compares where a run ends with steps that end at every jump.
/// @param run    integrates a model to a time, s.
/// @param error  m, of any node.
/// @param joint  whether constraints are taken.
template <class Run>
void check_jumps(const Run& run, double error, bool joint = true) {
    int checked = 0;
    for (const Jumps what : {Jumps::load, Jumps::load_twice, Jumps::square_wave, Jumps::gravity,
                             Jumps::support, Jumps::joint}) {
        if (what == Jumps::joint && !joint) continue;
        CAPTURE(static_cast<int>(what));
        JumpScene scene(what), exact(what);
        run(scene.model, JumpScene::end);
        run_exactly(exact.model);
        CHECK(apart(scene, exact) <= error);
        ++checked;
    }
    CHECK(checked == (joint ? 6 : 5));
}

}  // namespace ancf::test
