// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Builders of frames and nets: what their options do, by closed forms, and what they refuse.

#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/joint/affine_joint.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>

#include <algorithm>
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
const Material aluminium = Material::isotropic(7e10, 0.33, 2700.0);
constexpr double height = 0.04, width = 0.02;  // m

void solve(Model& model) {
    EigenLdlt solver;
    const StaticsReport report = solve_statics(model, solver);
    INFO(report.message);
    REQUIRE(report.status == Status::converged);
}

TEST_CASE("frame: a joint yields to a moment within its compliance, by the frame's direction",
          "[model][frame]") {
    constexpr double h = 0.1, kappa = 1e-4;  // a square of m, 1/m
    const double moment = kappa * steel.young * std::pow(h, 4) / 12.0;
    // the corner of an L turns by kappa 1 m and takes the tip with it
    const auto excess = [&](const P3& along, const P3& across) {
        FrameOptions<3> options;
        options.y_axis = across;
        Model model;
        const auto built = frame<Spatial>(
            model, {{steel, rectangle(h, h)}}, {P3::Zero(), along, P3(along + across)},
            {{0, 1, 0, 4}, {1, 2, 0, 1}}, options, CrossSectionOptions::best());
        model.clamp(built.joints[0]);
        model.add(Moment(built.joints[1], moment * cross(along, across)));
        EigenLu solver;
        REQUIRE(solve_statics(model, solver).status == Status::converged);
        const P3 moved = model.position(built.joints[2]) - along - across;
        return -moved.dot(along) / kappa - 1.0;
    };
    const double s = std::sqrt(0.5);
    const std::vector<double> found = {excess(P3::UnitX(), P3::UnitY()),
                                       excess(P3::UnitY(), P3::UnitZ()),
                                       excess({s, s, 0.0}, {-s, s, 0.0})};
    for (const double yield : found) CHECK(std::abs(yield) <= 0.0025 * h);
    CHECK(std::abs(found[0]) <= 0.0003 * h);  // through r_y, which the member holds
    CHECK(found[1] > 0.001 * h);              // half of it through r_y, and the block
}

TEST_CASE("frame: y_axis turns an oblong section, and so its stiffness", "[model][frame]") {
    constexpr double length = 2.0, force = 0.5;  // m, N
    const Section section = rectangle(width, height);
    const auto deflection = [&](const P3& direction, const P3& y_axis) {
        FrameOptions<3> options;
        options.y_axis = y_axis;
        Model model;
        const auto built =
            frame<Spatial>(model, {{steel, section}}, {P3::Zero(), length * direction},
                           {{0, 1, 0, 8}}, options, CrossSectionOptions::best());
        model.clamp(built.joints[0]);
        model.add(Force<3>(built.joints[1], {0, 0, force}));
        solve(model);
        return model.position(built.joints[1])[2] - length * direction[2];
    };
    // Timoshenko's cantilever, depth h along the force
    const auto expected = [&](double h, double b, double kappa) {
        const double area = h * b, inertia = b * h * h * h / 12.0;
        return force * length *
               (length * length / (3.0 * steel.young * inertia) +
                1.0 / (kappa * steel.shear * area));
    };
    const double flat = expected(width, height, section.shear_correction_z());
    const double upright = expected(height, width, section.shear_correction_y());
    int checked = 0;
    for (const P3& direction : {P3(1, 0, 0), P3(0, 1, 0), P3(0.6, -0.8, 0), P3(-0.8, 0.6, 0)}) {
        INFO(direction.transpose());
        const double across = deflection(direction, {-direction[1], direction[0], 0});
        const double along = deflection(direction, {0, 0, 1});
        CHECK(across == Approx(flat).epsilon(2e-4));  // the joints yield by 0.002 h/L = 4e-5
        CHECK(along == Approx(upright).epsilon(2e-4));
        // I_z/I_y = (h/b)^2 but for shear
        CHECK(across / along == Approx(4.0).epsilon(1e-3));
        // y_axis need not stand at a right angle to the member
        CHECK(deflection(direction, {direction[0], direction[1], 0.5}) ==
              Approx(along).epsilon(1e-12));
        ++checked;
    }
    CHECK(checked == 4);
    CHECK(deflection({1, 0, 0}, {0, 0, 0}) == Approx(flat).epsilon(2e-4));  // y along Y
}

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

TEST_CASE("frame: a joint yields as its stiffness says", "[model][frame]") {
    constexpr double edge = 0.03, force = 0.01;  // m, N
    const auto sway = [&](double stiffness) {
        FrameOptions<3> options;
        options.joint_stiffness = stiffness;
        Model model;
        const auto built =
            frame<Spatial>(model, {{steel, rectangle(edge, edge)}},
                           {{0, 0, 0}, {1, 0, 0}, {1, 0.8, 0}}, {{0, 1}, {1, 2}}, options);
        model.clamp(built.joints[0]);
        model.add(Force<3>(built.joints[2], {force, 0, 0}));
        solve(model);
        return model.position(built.joints[2])[0] - 1.0;
    };
    // the moment force * arm shears the corner by M/(k mu A h), and the tip moves by arm times that
    constexpr double arm = 0.8;
    const double compliance = force * arm * arm / (steel.shear * edge * edge * edge);
    const double soft = sway(1.0), firm = sway(100.0), firmer = sway(1e4);
    CHECK(soft - firm == Approx(compliance * (1.0 - 1e-2)).epsilon(1e-3));
    CHECK(firm - firmer == Approx(compliance * (1e-2 - 1e-4)).epsilon(1e-3));
    FrameOptions<3> usual;
    CHECK(usual.joint_stiffness == 100.0);
}

TEST_CASE("frame: a joint has the largest block and the stiffest material of its members",
          "[model][frame]") {
    const Profile slender{steel, rectangle(0.01, 0.01)};
    const Profile stout{aluminium, rectangle(height, width)};  // higher along z than along y
    const double volume = 100.0 * height * width * height;     // k A h, h the larger side
    const double size = std::cbrt(height * width * height);
    int checked = 0;
    for (const bool swapped : {false, true}) {
        Model model;
        std::vector<Profile> profiles = {slender, stout};
        if (swapped) std::swap(profiles[0], profiles[1]);
        const auto built = frame<Spatial>(model, profiles, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                                          {{0, 1, 0}, {1, 2, 1}});
        using Body = AffineJoint<3>;
        const auto& bodies = model.group<Body>();
        const auto body_of = [&](std::size_t joint) -> const Body& {
            for (int k = 0; k < bodies.size(); ++k)
                if (bodies.connection(k).first == built.joints[joint]) return bodies.element(k);
            throw InvalidArgument("no body");
        };
        const auto check = [&](const Body& body, const Material& of, double V, double edge) {
            Body::Coordinates rest;
            rest << 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1;
            const auto result = body.evaluate(rest);
            const double lame = 2.0 * of.shear * of.poisson() / (1.0 - 2.0 * of.poisson());
            CHECK(result.tangent(3, 3) == Approx(V * of.shear).epsilon(1e-13));
            CHECK(result.tangent(0, 0) == Approx(V * (lame + 2.0 * of.shear)).epsilon(1e-13));
            CHECK(body.mass()(0, 0) ==
                  Approx(of.density * std::pow(edge, 5) / 12.0).epsilon(1e-13));
            // sheared by g: E_12 = g/2, E_22 = g^2/2
            constexpr double g = 0.3;
            Body::Coordinates sheared = rest;
            sheared[3] = g;
            CHECK(body.energy(sheared) ==
                  Approx(V * (0.125 * lame * std::pow(g, 4) +
                              of.shear * (0.5 * g * g + 0.25 * std::pow(g, 4))))
                      .epsilon(1e-13));
            ++checked;
        };
        check(body_of(1), steel, volume, size);
        const std::size_t slim = swapped ? 2 : 0, other = 2 - slim;
        check(body_of(slim), steel, 100.0 * 1e-6, 0.01);
        check(body_of(other), aluminium, volume, size);
    }
    CHECK(checked == 6);
}

TEST_CASE("frame: members of one Young's modulus give a joint one material in any order",
          "[model][frame]") {
    const Material stiff = Material::from_moduli(2e11, 8e10, 7800.0);
    const Material soft = Material::from_moduli(2e11, 6.8e10, 9000.0);
    using Body = AffineJoint<3>;
    int checked = 0;
    for (const bool swapped : {false, true}) {
        Model model;
        const Section section = rectangle(width, height);
        std::vector<Profile> profiles = {{stiff, section}, {soft, section}};
        if (swapped) std::swap(profiles[0], profiles[1]);
        const auto built = frame<Spatial>(model, profiles, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                                          {{0, 1, 0}, {1, 2, 1}});
        const auto& bodies = model.group<Body>();
        for (int k = 0; k < bodies.size(); ++k) {
            if (!(bodies.connection(k).first == built.joints[1])) continue;
            Body::Coordinates rest;
            rest << 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1;
            const double volume = 100.0 * height * width * height;
            CHECK(bodies.element(k).evaluate(rest).tangent(3, 3) ==
                  Approx(volume * stiff.shear).epsilon(1e-13));
            ++checked;
        }
    }
    CHECK(checked == 2);
}

TEST_CASE("net: a flat one bears a load across its ropes, strained or not", "[model][frame][net]") {
    constexpr double load = 20.0, side = 0.004, young = 1e10;  // N, m, Pa
    const Profile rope{Material::isotropic(young, 0.3, 1000.0), rectangle(side, side)};
    const auto build = [&](Model& model, double strain) {
        NetOptions options;
        options.strain = strain;
        auto web =
            net<Cable<3>>(model, {rope}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                          {{0, 1}, {0, 2}, {0, 3}, {0, 4}}, options);
        for (std::size_t border = 1; border <= 4; ++border) model.pin(web.joints[border]);
        model.add(Force<3>(web.joints[0], {0, 0, -load}));
        return web;
    };
    EigenLdlt solver;
    SECTION("four straight ropes carry the load") {
        const double strain = GENERATE(0.0, 1e-4);  // without any, the first tangent is singular
        CAPTURE(strain);
        Model model;
        const auto web = build(model, strain);
        // drawn as they are stretched
        CHECK(model.value(web.members[2].last(), Field::r_x).norm() ==
              Approx(1.0 + strain).epsilon(1e-14));
        StaticsOptions options;
        options.steps = 4;
        const StaticsReport report = solve_statics(model, solver, options);
        INFO(report.message);
        REQUIRE(report.status == Status::converged);
        CHECK(report.stability == Stability::stable);
        // 4 N d/sqrt(1 + d^2) = load, N = E A (s^2 - 1)/2 s, s = (1 + strain) sqrt(1 + d^2)
        const auto carried = [&](double d) {
            const double s = (1.0 + strain) * std::hypot(1.0, d);
            return 4.0 * young * side * side * 0.5 * (s * s - 1.0) * s * d / std::hypot(1.0, d);
        };
        double low = 0.0, high = 1.0;
        for (int k = 0; k < 60; ++k)
            (carried(0.5 * (low + high)) < load ? low : high) = 0.5 * (low + high);
        CHECK(low > 0.01);
        CHECK(model.position(web.joints[0])[2] == Approx(-low).epsilon(1e-9));
        const P3 pull = report.reactions.segment<3>(model.coordinate(web.joints[1], Field::r));
        CHECK(pull[2] == Approx(0.25 * load).epsilon(1e-9));
        CHECK(pull[0] == Approx(0.25 * load / low).epsilon(1e-9));
    }
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
    says("frame: member 1, points 0 and 3: there are 3 points, counted from 0, got point 3",
         build({{0, 1}, {0, 3}}));
    says("frame: member 0, points -1 and 1: there are 3 points, counted from 0, got point -1",
         build({{-1, 1}}));
    says("frame: member 0, points 1 and 1: a member joins two points", build({{1, 1}}));
    says("frame: member 0, points 0 and 1: there are 1 profiles, counted from 0, got profile 1",
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
