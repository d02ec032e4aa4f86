// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// IDA on frames: the stiff joints do not hold its step down.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/sundials/ida.hpp>

#include <support/catch.hpp>

namespace ida_frames_test {

using namespace ancf;

/// A rubber corner that falls about its first joint.
ancf::sundials::IdaReport fall(ancf::sundials::Order order) {
    Model model;
    const auto built = frame<CrossSectionBeam<3>>(
        model, {{Material::from_moduli(0.7e6, 2.6923e5, 1100.0), rectangle(0.05, 0.05)}},
        {{0, 0, 0}, {0.6, 0, 0}, {0.6, 0.6, 0}, {0.6, 0, 0.4}}, {{0, 1}, {1, 2}, {1, 3}});
    model.pin(built.joints[0]);
    model.set_gravity({0.0, -9.81, 0.0});
    DynamicProblem problem(model);
    ancf::sundials::IdaOptions options;
    options.tolerance = 1e-6;
    options.order = order;
    return ancf::sundials::Ida(options).integrate(problem, equal_intervals(0.0, 0.2, 0.2));
}

TEST_CASE("ida: takes order two for a frame of stiff joints, in fewer steps", "[sundials][ida]") {
    const ancf::sundials::IdaReport chosen = fall(ancf::sundials::Order::automatic);
    const ancf::sundials::IdaReport other = fall(ancf::sundials::Order::five);
    REQUIRE(chosen.status == Status::converged);
    REQUIRE(other.status == Status::converged);
    CHECK(chosen.order == 2);
    CHECK(2 * chosen.steps < other.steps);
}

}  // namespace ida_frames_test
