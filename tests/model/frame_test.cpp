// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Builders of frames and nets: what their options do, by closed forms, and what they refuse.

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>

#include <support/catch.hpp>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace frame_test {

using namespace ancf;
using Spatial = CrossSectionBeam<3>;
using P3 = Vector<double, 3>;

const Material steel = Material::isotropic(2e11, 0.3, 7800.0);
constexpr double height = 0.04, width = 0.02;  // m

TEST_CASE("frame: a member parallel to y_axis stands as without one", "[model][frame]") {
    const std::vector<P3> points = {{0, 0, 0}, {0.1, 0.2, 3.0}, {0.1 + 4.0, 0.2, 3.0}, {4, 0, 3}};
    const std::vector<Member> members = {{0, 1}, {1, 2}, {3, 2}};
    const auto slopes = [&](const P3& y_axis) {
        FrameOptions<3> options;
        options.y_axis = y_axis;
        Model model;
        const auto built =
            frame<Spatial>(model, {{steel, rectangle(width, height)}}, points, members, options);
        std::vector<P3> found;
        for (const auto& member : built.members)
            found.push_back(model.value(member.first(), Field::r_y));
        return found;
    };
    const auto plain = slopes(P3::Zero());
    // the first member, with the round-off of its points
    const auto turned = slopes(2.0 * (points[1] - points[0]));
    const auto opposite = slopes(P3(-0.1, -0.2, -3.0));
    CHECK(turned[0] == plain[0]);
    CHECK(opposite[0] == plain[0]);
    for (std::size_t k = 1; k < 3; ++k) {
        CHECK(turned[k][2] > 0.9);
        CHECK(opposite[k][2] < -0.9);
        CHECK(std::abs(plain[k][2]) < 0.1);
    }
    // an angle of 1e-5 is none of those
    const P3 off = points[1] - points[0] + 1e-5 * 3.0 * P3(1, 0, 0);
    CHECK((slopes(off)[0] - plain[0]).norm() > 0.1);
}

TEST_CASE("frame, net: a member that cannot be meant is refused with its place and points",
          "[model][frame][bad-input]") {
    Model model;
    const std::vector<Profile> profiles = {{steel, rectangle(width, width)}};
    const std::vector<P3> points = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}};
    const auto says = [](const std::string& part, const std::function<void()>& call) {
        std::string text;
        try {
            call();
        } catch (const InvalidArgument& refused) {
            text = refused.what();
        }
        INFO(text);
        CHECK(text.find(part) != std::string::npos);
    };
    const auto build = [&](const std::vector<Member>& members) {
        return [&, members] { frame<Spatial>(model, profiles, points, members); };
    };
    says("frame: member 1, points 0 and 3: there are 3 points, got point 3",
         build({{0, 1}, {0, 3}}));
    says("frame: member 0, points -1 and 1: there are 3 points, got point -1", build({{-1, 1}}));
    says("frame: member 0, points 1 and 1: a member joins two points", build({{1, 1}}));
    says("frame: member 0, points 0 and 1: there are 1 profiles, got profile 1",
         build({{0, 1, 1}}));
    says("frame: member 0, points 0 and 1: at least one element", build({{0, 1, 0, 0}}));
    says("frame: member 1, points 1 and 2: the points must be apart, got a distance of 0",
         build({{0, 1}, {1, 2}}));
    says("frame: point 1 must be finite", [&] {
        frame<Spatial>(model, profiles, {{0, 0, 0}, {0, std::nan(""), 0}}, {});
    });
    says("net: member 0, points 1 and 2: the points must be apart", [&] {
        net<Cable<3>>(model, profiles, points, {{1, 2}});
    });
    says("joint_stiffness must be positive", [&] {
        FrameOptions<3> options;
        options.joint_stiffness = -1.0;
        frame<Spatial>(model, profiles, points, {{0, 1}}, options);
    });
    // what is refused leaves nothing behind
    CHECK(model.nodes() == 0);
    CHECK(model.groups().empty());
}

}  // namespace frame_test
