// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A torsion beam that a motion twists by more than its one element can tell.

#pragma once

#include <ancf/dynamics/report.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/model.hpp>

#include <support/catch.hpp>
#include <support/driven_arm.hpp>

#include <string>

namespace ancf::test {

/// One element of 0.5 m, clamped, whose other end turns about its axis within a second.
[[nodiscard]] inline Model twisted_beam(double angle) {
    Model model;
    const auto beam = straight_beam<TorsionBeam>(model, Material::isotropic(1e8, 0.3, 1000.0),
                                                 rectangle(0.05, 0.05), {0, 0, 0}, {0.5, 0, 0}, 1);
    model.clamp(beam.first());
    model.add(DrivenRevolute(model, beam.last(), {1, 0, 0}, smooth_turn(angle)));
    return model;
}

/// Checks that a motion by 5 rad, which reads as -1.28 rad at its end, told of the element between
/// 0.51 s, where it passes 2.6 rad, and a time.
/// @param ended  whether the motion ended there
inline void check_left_range(const DynamicsReport& report, bool ended, double latest) {
    CHECK(report.status == (ended ? Status::degenerate : Status::converged));
    CHECK(report.fault.has_value() == ended);
    CHECK(report.message == report.left_range);
    REQUIRE_THAT(report.left_range,
                 ContainsSubstring("element 0 of the type TorsionBeam is degenerate at "));
    const double seen = std::stod(report.left_range.substr(report.left_range.rfind(" at ") + 4));
    CHECK(seen > 0.5);
    CHECK(seen < latest);
    CHECK(report.time == (ended ? Approx(seen).epsilon(1e-5) : Approx(1.0)));
}

}  // namespace ancf::test
