// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Loads and drives that act for a while after a rest.

#pragma once

#include <ancf/constants.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>

#include <support/catch.hpp>

#include <cmath>
#include <limits>

namespace ancf::test {

/// When something begins to act, and the end of the run, s.
constexpr double pulse_from = 0.5, pulse_end = 0.7;

/// What acts.
enum class Acts { load, gravity, support, joint };

/// A beam at rest on which something acts for a while.
struct Pulse {
    Pulse(Acts what, double duration) {
        beam = straight_beam<CrossSectionBeam<2>>(model, Material::isotropic(2e9, 0.3, 8000.0),
                                                  rectangle(0.02, 0.02), {0, 0}, {1, 0}, 2);
        const auto part = [=](double t) { return (t - pulse_from) / duration; };
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

/// Runs with free steps, and with steps of 1 ms that no pulse falls between.
/// @param run  integrates to a time behind the pulse, such as pulse_end, from a scene and a longest
///             step, s; returns its report.
template <class Run>
void check_pulses(const Run& run) {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    int checked = 0;
    for (const Acts what : {Acts::load, Acts::gravity, Acts::support, Acts::joint})
        for (const double duration : {0.05, 0.003}) {
            CAPTURE(static_cast<int>(what), duration);
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

}  // namespace ancf::test
