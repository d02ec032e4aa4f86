// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Corners of frames against linear frame analysis and, far bent, against Reissner's beam.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/modal.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>
#include <support/frame_theory.hpp>

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace frames_test {

using namespace ancf;
using test::frame_cases;
using test::FrameCase;
using P2 = Vector<double, 2>;
using P3 = Vector<double, 3>;

const Material steel = Material::isotropic(2e11, 0.3, 7800.0);

struct Found {
    P3 moved;
    double lowest;         // natural frequency of the clamped frame, 1/s^2
    double stretch = 0.0;  // largest of a rigid arm at any joint, in any direction
    double turn = 0.0;     // largest of a joint, from its slopes
};

/// Returns the first components of a point.
template <int Dimension>
Vector<double, Dimension> part(const P3& point) {
    return point.head<Dimension>();
}

template <int Dimension = 3>
Found solve(const FrameCase& of, const Section& section, int elements, const P3& force,
            int steps = 1) {
    using Beam = CrossSectionBeam<Dimension>;
    std::vector<Member> members = of.members;
    for (Member& member : members) member.elements = elements;
    std::vector<Vector<double, Dimension>> points;
    for (const P3& point : of.points) points.push_back(part<Dimension>(point));
    BasicModel<Dimension> model;
    const auto built =
        frame<Beam>(model, {{steel, section}}, points, members, {}, CrossSectionOptions::best());
    model.clamp(built.joints[0]);
    EigenLdlt solver;
    ModalOptions one;
    one.count = 1;
    const ModalReport modes = natural_modes(model, solver, one);
    REQUIRE(modes.status == Status::converged);
    const auto at = static_cast<std::size_t>(of.loaded);
    model.add(Force<Dimension>(built.joints[at], part<Dimension>(force)));
    StaticsOptions options;
    options.steps = steps;
    REQUIRE(solve_statics(model, solver, options).status == Status::converged);
    Found found{P3::Zero(), modes.modes[0].value};
    found.moved.head<Dimension>() = model.position(built.joints[at]) - points[at];
    for (const NodeId joint : built.joints) {
        Matrix<double, Dimension> slopes;
        for (int k = 0; k < Dimension; ++k)
            slopes.col(k) = model.value(joint, static_cast<Field>(1 + k));
        const auto stretches = Eigen::JacobiSVD<Matrix<double, Dimension>>(slopes).singularValues();
        found.stretch =
            std::max({found.stretch, stretches.maxCoeff() - 1.0, 1.0 - stretches.minCoeff()});
        found.turn = std::max(
            found.turn, (slopes - Matrix<double, Dimension>::Identity()).cwiseAbs().maxCoeff());
    }
    return found;
}

/// What a refinement of a bent frame gave, with lengths in those of a member.
struct Bent {
    double change;   // from 16 to 32 elements a member
    double error;    // of 32 elements, against Reissner's beam
    double stretch;  // of rigid arms
};

template <int Dimension>
Bent bend(const FrameCase& of, const P3& force) {
    const Section section = rectangle(0.02, 0.02);
    const P3 exact = test::ExactFrame(of, steel, section).displacement(force);
    const Found coarse = solve<Dimension>(of, section, 16, force, 2),
                fine = solve<Dimension>(of, section, 32, force, 2);
    CHECK(exact.norm() > 0.01);
    CHECK(fine.turn > 0.01);
    return {(fine.moved - coarse.moved).norm(), (fine.moved - exact).norm(), fine.stretch};
}

TEST_CASE("frames: corners are those of linear frame analysis, at every mesh", "[verification]") {
    const Section section = rectangle(0.02, 0.03);
    const P3 force(0.003, -0.007, 0.01);
    double worst = 0.0;
    int checked = 0;
    for (const FrameCase& of : frame_cases()) {
        const P3 expected = test::linear_frame(of, steel, section, force);
        for (const int elements : {1, 2, 8, 32}) {
            INFO(of.name << ", " << elements << " elements");
            const Found found = solve(of, section, elements, force);
            const double error = (found.moved - expected).norm() / expected.norm();
            worst = std::max(worst, error);
            CHECK(error <= 4e-5);  // found 2.4e-5; a hinge or a corner that softens gives 1e-2
            CHECK(found.lowest > 100.0);  // a hinge has 0
            ++checked;
        }
    }
    CHECK(checked == 36);
    INFO("worst " << worst);
    CHECK(worst > 0.0);
}

TEST_CASE("frames: far bent corners settle under refinement", "[verification]") {
    const Section section = rectangle(0.02, 0.02);
    int checked = 0;
    for (const FrameCase& of : frame_cases()) {
        INFO(of.name);
        const P3 force(0.0, 50.0, 80.0);
        const Found coarse = solve(of, section, 16, force, 2),
                    fine = solve(of, section, 32, force, 2);
        CHECK(fine.moved.norm() > 0.01);
        CHECK((fine.moved - coarse.moved).norm() <= 1e-6);  // of a member's length
        ++checked;
    }
    CHECK(checked == 9);
}

TEST_CASE("frames: planar corners are those of space", "[verification]") {
    const Section section = rectangle(0.02, 0.02);
    const auto tip = [&](auto element, auto from, auto knee, auto end, auto force) {
        using Beam = decltype(element);
        BasicModel<Beam::dimension> model;
        const auto built =
            frame<Beam>(model, {{steel, section}}, {from, knee, end},
                        {{0, 1, 0, 16}, {1, 2, 0, 16}}, {}, CrossSectionOptions::best());
        model.clamp(built.joints[0]);
        model.add(Force<Beam::dimension>(built.joints[2], force));
        EigenLdlt solver;
        REQUIRE(solve_statics(model, solver).status == Status::converged);
        return P2(model.position(built.joints[2]).template head<2>());
    };
    struct {
        static CrossSectionBeam<2> planar() { return {steel, rectangle(0.02, 0.02), 1.0}; }
        static CrossSectionBeam<3> spatial() { return {steel, rectangle(0.02, 0.02), 1.0}; }
    } sample;
    const P2 flat = tip(sample.planar(), P2(0, 0), P2(1, 0), P2(1, 1), P2(100, 50));
    const P2 deep = tip(sample.spatial(), P3(0, 0, 0), P3(1, 0, 0), P3(1, 1, 0), P3(100, 50, 0));
    CHECK((flat - P2(1, 1)).norm() > 0.02);
    CHECK((flat - deep).norm() <= 1e-5);
}

TEST_CASE("frames: far bent corners are those of Reissner's beam, rigid arms keep their length",
          "[verification]") {
    Bent worst{0.0, 0.0, 0.0};
    int checked = 0;
    const auto take = [&](const FrameCase& of, const Bent& bent) {
        UNSCOPED_INFO(of.name << ": change " << bent.change << ", error " << bent.error
                              << ", stretch of arms " << bent.stretch);
        worst = {std::max(worst.change, bent.change), std::max(worst.error, bent.error),
                 std::max(worst.stretch, bent.stretch)};
        ++checked;
    };
    for (const FrameCase& of : frame_cases()) {
        if (of.name == std::string("cell")) continue;  // statically indeterminate
        take(of, bend<3>(of, {0.0, 50.0, 80.0}));
        const bool flat = std::all_of(of.points.begin(), of.points.end(),
                                      [](const P3& point) { return point[2] == 0.0; });
        if (flat) take(of, bend<2>(of, {-30.0, 80.0, 0.0}));
    }
    CHECK(checked == 13);
    CHECK(worst.change <= 1e-6);
    CHECK(worst.error <= 5e-6);
    CHECK(worst.stretch <= 1e-6);
    CHECK(worst.error > 0.0);
}

}  // namespace frames_test
