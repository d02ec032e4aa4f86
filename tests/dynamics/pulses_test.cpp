// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Loads and drives that act for a while after a rest, under integrators whose steps have grown in
/// it.

#include <ancf/dynamics/generalized_alpha.hpp>
#include <ancf/dynamics/radau.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <support/pulses.hpp>

namespace pulses_test {

using namespace ancf;
using namespace ancf::test;

TEST_CASE("pulses: adaptive steps see what acts for longer than the first step after a rest",
          "[dynamics]") {
    const int method = GENERATE(0, 3, 5);  // generalized-alpha, stages of Radau
    const bool goes_on = GENERATE(false, true);
    CAPTURE(method, goes_on);
    check_pulses([&](Pulse& scene, double max_step) {
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
        schedule.end = pulse_end;
        const auto report = integrate(memory);
        REQUIRE(report.status == Status::converged);
        return report;
    });
}

TEST_CASE("pulses: round-off of a rest hides none", "[dynamics]") {
    Model model;
    const auto beam =
        straight_beam<CrossSectionBeam<3>>(model, Material::isotropic(2.1e11, 0.3, 7800.0),
                                           rectangle(0.01, 0.01), {0, 0, 0}, {1, 0, 0}, 4);
    model.pin(beam.first());
    model.add(Force<3>(beam.last(), {0, 2, 0.6}),
              [](double t) { return t > 0.13 && t < 0.18 ? 1.0 : 0.0; });
    DynamicProblem problem(model);
    EigenLu solver;
    GeneralizedAlphaOptions options;
    options.tolerance = 1e-6;
    Schedule schedule;
    schedule.end = 0.5;
    REQUIRE(GeneralizedAlpha(options).integrate(problem, solver, schedule).status ==
            Status::converged);
    // nine steps passed over the pulse
    CHECK(model.position(beam.last()).y() > 0.05);
}

}  // namespace pulses_test
