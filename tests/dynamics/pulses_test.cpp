// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Loads and drives that act for a while after a rest, under integrators whose steps have grown in
/// it.

#include <ancf/constants.hpp>
#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <support/catch.hpp>

#include <cmath>
#include <limits>

namespace pulses_test {

using namespace ancf;

constexpr double from = 0.5, end = 0.7;  // s

enum class Acts { load, gravity, support, joint };

/// A beam at rest on which something acts for a while.
struct Pulse {
    Pulse(Acts what, double duration) {
        beam = straight_beam<CrossSectionBeam<2>>(model, Material::isotropic(2e9, 0.3, 8000.0),
                                                  rectangle(0.02, 0.02), {0, 0}, {1, 0}, 2);
        const auto part = [=](double t) { return (t - from) / duration; };
        const Amplitude block = [=](double t) { return part(t) > 0.0 && part(t) < 1.0; };
        const double k = pi / duration, height = 0.01;
        const auto wave = [=](const auto& f) -> Amplitude {
            return [=](double t) {
                const double x = pi * part(t);
                return block(t) * height * f(std::sin(x), std::cos(x));
            };
        };
        const Motion move{
            wave([](double s, double) { return std::pow(s, 4); }),
            wave([=](double s, double c) { return 4.0 * k * std::pow(s, 3) * c; }),
            wave([=](double s, double c) { return 4.0 * k * k * s * s * (3.0 * c * c - s * s); })};
        if (what == Acts::joint) {
            model.add(PlanarWeld(model, beam.first(), move));
            return;
        }
        model.clamp(beam.first());
        if (what == Acts::load) model.add(Force<2>(beam.last(), {0, 1}), block);
        if (what == Acts::gravity) model.set_gravity({0, -50}, block);
        if (what == Acts::support)
            model.prescribe(beam.first(), Field::r, 1, move.value, move.rate, move.acceleration);
    }

    PlanarModel model;
    Beam<CrossSectionBeam<2>> beam;
};

TEST_CASE("pulses: adaptive steps see what acts for longer than the first step after a rest",
          "[dynamics]") {
    const int method = GENERATE(0, 3, 5);  // generalized-alpha, stages of Radau
    const bool goes_on = GENERATE(false, true);
    const auto run = [&](Pulse& scene, double max_step) {
        DynamicProblem problem(scene.model);
        EigenLu solver;
        Schedule schedule;
        const auto integrate = [&](const Memory& memory) {
            if (method == 0) {
                GeneralizedAlphaOptions options;
                options.tolerance = 1e-7;
                options.max_step = max_step;
                return GeneralizedAlpha(options).integrate(problem, solver, schedule, memory);
            }
            RadauOptions options;
            options.stages = method;
            options.max_step = max_step;
            return RadauIIA(options).integrate(problem, solver, schedule, memory);
        };
        Memory memory;
        if (goes_on) {  // with the steps that have grown
            schedule.end = 0.4;
            memory = integrate(memory).memory;
        }
        schedule.end = end;
        const auto report = integrate(memory);
        REQUIRE(report.status == Status::converged);
        return report;
    };
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    int checked = 0;
    for (const Acts what : {Acts::load, Acts::gravity, Acts::support, Acts::joint})
        for (const double duration : {0.05, 0.003}) {
            CAPTURE(method, goes_on, static_cast<int>(what), duration);
            Pulse free(what, duration), bound(what, duration);
            const auto report = run(free, unlimited);
            run(bound, 1e-3);
            CHECK(report.largest_step > 0.02);  // in the rest
            const VectorX& v = bound.model.state().v;
            // without a look steps passed over it: the difference was all of v
            CHECK((free.model.state().v - v).norm() <= 0.1 * v.norm());
            ++checked;
        }
    CHECK(checked == 8);
}

}  // namespace pulses_test
