// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Corners of frames against linear frame analysis and, bent, against Reissner's beam.

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
#include <support/dense.hpp>
#include <support/frame_theory.hpp>

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
            int steps = 1, double joint_stiffness = 100.0) {
    using Beam = CrossSectionBeam<Dimension>;
    std::vector<Member> members = of.members;
    for (Member& member : members) member.elements = elements;
    std::vector<Vector<double, Dimension>> points;
    for (const P3& point : of.points) points.push_back(part<Dimension>(point));
    FrameOptions<Dimension> frame_options;
    frame_options.joint_stiffness = joint_stiffness;
    BasicModel<Dimension> model;
    const auto built = frame<Beam>(model, {{steel, section}}, points, members, frame_options,
                                   CrossSectionOptions::best());
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
        const VectorX stretches = test::singular_values(slopes);
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
    double moved;    // the loaded joint
};

/// How frames are bent.
struct Bending {
    double side = 0.02;        // of the square section, m; loads go with its fourth power
    double load = 1.0;         // times (0, 50, 80) N in space, (-30, 80) N in the plane
    double stiffness = 100.0;  // of joints
    int steps = 2;
};

template <int Dimension>
Bent bend(const FrameCase& of, const Bending& how) {
    const Section section = rectangle(how.side, how.side);
    const double factor = how.load * std::pow(how.side / 0.02, 4);
    const P3 force = factor * (Dimension == 3 ? P3(0.0, 50.0, 80.0) : P3(-30.0, 80.0, 0.0));
    const P3 exact = test::ExactFrame(of, steel, section).displacement(force);
    const Found coarse = solve<Dimension>(of, section, 16, force, how.steps, how.stiffness),
                fine = solve<Dimension>(of, section, 32, force, how.steps, how.stiffness);
    CHECK(exact.norm() > 0.01);
    CHECK(fine.turn > 0.01);
    const double theory = test::lowest_of_linear_frame(of, steel, section, Dimension == 2);
    CHECK(fine.lowest == Approx(theory).epsilon(2e-3));  // half of that is the lumped mass's
    return {(fine.moved - coarse.moved).norm(), (fine.moved - exact).norm(), fine.stretch,
            exact.norm()};
}

TEST_CASE("frames: corners are those of linear frame analysis, at every mesh", "[verification]") {
    const Section section = rectangle(0.02, 0.03);
    const P3 force(0.003, -0.007, 0.01);
    double worst = 0.0;
    int checked = 0;
    for (const FrameCase& of : frame_cases()) {
        const P3 expected = test::linear_frame(of, steel, section, force);
        const double lowest = test::lowest_of_linear_frame(of, steel, section, false);
        for (const int elements : {1, 2, 8, 32}) {
            INFO(of.name << ", " << elements << " elements");
            const Found found = solve(of, section, elements, force);
            const double error = (found.moved - expected).norm() / expected.norm();
            worst = std::max(worst, error);
            CHECK(error <= 4e-5);  // found 2.4e-5; a hinge or a corner that softens gives 1e-2
            CHECK(found.lowest == Approx(lowest).epsilon(elements > 1 ? 2e-3 : 2e-2));
            ++checked;
        }
    }
    CHECK(checked == 36);
    INFO("worst " << worst);
    CHECK(worst > 0.0);
}

TEST_CASE("frames: bent corners settle under refinement", "[verification]") {
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

TEST_CASE("frames: a lattice is that of linear frame analysis, twisted and sheared",
          "[verification]") {
    const Section section = rectangle(0.01, 0.01);
    constexpr double cell = 0.25, force = 0.02;  // m, N at each joint of the top
    std::vector<P3> points;
    std::vector<Member> members;
    for (int k = 0; k < 5; ++k)
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i) {
                const int here = static_cast<int>(points.size());
                points.emplace_back(cell * i, cell * j, cell * k);
                if (k > 0) members.push_back({here - 9, here});
                if (k > 0 && i > 0) members.push_back({here - 1, here});
                if (k > 0 && j > 0) members.push_back({here - 3, here});
            }
    for (const bool twist : {false, true}) {
        INFO("twist " << twist);
        Model model;
        const auto built = frame<CrossSectionBeam<3>>(model, {{steel, section}}, points, members,
                                                      {}, CrossSectionOptions::best());
        VectorX forces = VectorX::Zero(6 * 45);
        for (int k = 0; k < 9; ++k) {
            model.clamp(built.joints[static_cast<std::size_t>(k)]);
            const P3 arm = points[static_cast<std::size_t>(36 + k)] - P3(cell, cell, 1.0);
            P3 load = force * P3(1, 0, 0);
            if (twist)
                load = arm.norm() > 0.0 ? P3(force * P3(-arm[1], arm[0], 0.0) / arm.norm())
                                        : P3(P3::Zero());
            model.add(Force<3>(built.joints[static_cast<std::size_t>(36 + k)], load));
            forces.segment<3>(6 * (36 + k)) = load;
        }
        EigenLdlt solver;
        REQUIRE(solve_statics(model, solver).status == Status::converged);
        const VectorX expected =
            test::LinearFrame(points, members, steel, section).displaced(9, forces);
        const P3 corner = model.position(built.joints[44]) - points[44];
        const P3 theory = expected.segment<3>(6 * 44);
        CHECK((corner - theory).norm() <= 5e-4 * theory.norm());  // 3.2e-4, joints yield
    }
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

/// The frames that are statically determinate, bent.
struct AllBent {
    std::vector<Bent> spatial, planar;

    explicit AllBent(const Bending& how) {
        for (const FrameCase& of : frame_cases()) {
            if (of.name == std::string("cell")) continue;  // statically indeterminate
            spatial.push_back(bend<3>(of, how));
            const bool flat = std::all_of(of.points.begin(), of.points.end(),
                                          [](const P3& point) { return point[2] == 0.0; });
            if (flat) planar.push_back(bend<2>(of, how));
        }
        CHECK(spatial.size() == 8);
        CHECK(planar.size() == 5);
    }

    /// Returns the largest of each figure, and the least displacement.
    [[nodiscard]] static Bent worst(const std::vector<Bent>& all) {
        Bent found{0.0, 0.0, 0.0, 1e9};
        for (const Bent& bent : all)
            found = {std::max(found.change, bent.change), std::max(found.error, bent.error),
                     std::max(found.stretch, bent.stretch), std::min(found.moved, bent.moved)};
        return found;
    }
};

TEST_CASE("frames: bent corners are those of Reissner's beam, rigid arms keep their length",
          "[verification]") {
    const AllBent bent{Bending{}};
    for (const std::vector<Bent>* const all : {&bent.spatial, &bent.planar}) {
        const Bent worst = AllBent::worst(*all);
        CHECK(worst.change <= 1e-6);  // 1.0e-7 and 2.5e-9
        CHECK(worst.error <= 5e-6);   // 2.0e-6 and 7.2e-7
        CHECK(worst.stretch <= 1e-6);
        CHECK(worst.error > 0.0);
    }
}

TEST_CASE("frames: far bent corners leave Reissner's beam by the strain of sections squared",
          "[verification]") {
    Bending far;
    far.load = 10.0;
    far.steps = 8;
    const AllBent usual(far);
    const Bent spatial = AllBent::worst(usual.spatial), planar = AllBent::worst(usual.planar);
    CHECK(spatial.moved > 0.1);
    CHECK(planar.moved > 0.1);
    CHECK(spatial.error <= 5e-5);   // 3.9e-5
    CHECK(planar.error <= 3e-5);    // 2.8e-5
    CHECK(spatial.change <= 7e-5);  // 5.8e-5
    CHECK(planar.change <= 1e-7);   // 7.1e-8
    CHECK(spatial.stretch <= 1e-5);
    CHECK(planar.stretch <= 1e-5);
    // so half the section bent alike leaves it by a quarter, where joints do not yield
    far.stiffness = 1e4;
    Bending slim = far;
    slim.side *= 0.5;
    const AllBent thick(far), thin(slim);
    for (std::size_t k = 0; k < thick.planar.size(); ++k)
        CHECK(thick.planar[k].error / thin.planar[k].error == Approx(4.0).epsilon(0.03));
}

}  // namespace frames_test
