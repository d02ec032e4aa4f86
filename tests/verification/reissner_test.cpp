// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Engineering strains converge to the geometrically exact beam: planar cases with reference values
/// by independent solvers of Reissner's theory (shooting and spectral elements).

#include <ancf/constants.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraints/planar.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/path.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>

#include <cmath>
#include <string>

namespace reissner_test {

using ancf::Field;
using ancf::Status;
using Beam =
    ancf::CrossSectionBeam<2, ancf::Projected, ancf::LinearShear, ancf::EngineeringMeasure>;
using Scene = ancf::PlanarModel;
using Point = ancf::Vector<double, 2>;

ancf::CrossSectionOptions mixed() {
    ancf::CrossSectionOptions options;
    options.rule = ancf::Rule::mixed();
    return options;
}

/// Returns the tip of a cantilever of length 2 along X under a dead tip force along Y.
Point loaded_tip(const ancf::Section& section, double force, int elements) {
    Scene scene;
    const auto material = ancf::Material::from_moduli(2.07e11, 7.9615e10, 7850.0);
    const auto beam =
        ancf::straight_beam<Beam>(scene, material, section, {0, 0}, {2, 0}, elements, mixed());
    scene.clamp(beam.first(), ancf::Clamp::free_slope);
    scene.add(ancf::Force<2>(beam.last(), {0, force}));
    ancf::EigenLdlt solver;
    REQUIRE(ancf::solve_statics(scene, solver).status == Status::converged);
    return scene.position(beam.last());
}

TEST_CASE("Reissner: the slender cantilever comes to the value of the theory", "[verification]") {
    const double force = 1.5 * 2.07e11 * 1e-8 / 12.0 / 4.0;
    const Point theory(1.784113323480, 0.821971481194);
    const auto section = ancf::rectangle(0.01, 0.01);
    const double coarse = (loaded_tip(section, force, 8) - theory).norm() / 2.0;
    const double fine = (loaded_tip(section, force, 16) - theory).norm() / 2.0;
    CHECK(fine <= 1.5e-6);
    CHECK(std::log2(coarse / fine) >= 3.7);  // fourth order
    // the Green-strain limit is 2.5e-6 L away: that it is told apart
    const double finest = (loaded_tip(section, force, 64) - theory).norm() / 2.0;
    CHECK(finest <= 1e-8);
}

TEST_CASE("Reissner: the deep cantilever comes to the value of the theory", "[verification]") {
    const Point theory(1.999697522945, 0.032416944776);
    const Point tip = loaded_tip(ancf::rectangle(0.1, 0.5), 2.5e6, 32);
    CHECK((tip - theory).norm() / 2.0 <= 1e-8);
}

TEST_CASE("Reissner: an end moment bends to an exact semicircle", "[verification]") {
    using ancf::pi;
    const auto error = [&](int elements) {
        Scene scene;
        const auto material = ancf::Material::from_moduli(2e8, 1e8, 1.0);
        const auto beam = ancf::straight_beam<Beam>(scene, material, ancf::rectangle(0.035, 0.035),
                                                    {0, 0}, {1, 0}, elements, mixed());
        scene.clamp(beam.first(), ancf::Clamp::free_slope);
        const double bending = 2e8 * std::pow(0.035, 4) / 12.0;
        scene.add(ancf::PlanarSlopeMoment(beam.last(), Field::r_y, pi * bending));
        ancf::EigenLu solver;
        ancf::StaticsOptions options;
        options.steps = 4;
        REQUIRE(ancf::solve_statics(scene, solver, options).status == Status::converged);
        return (scene.position(beam.last()) - Point(0.0, 2.0 / pi)).norm();
    };
    const double coarse = error(8), fine = error(16);
    CHECK(fine <= 3e-5);
    CHECK(std::log2(coarse / fine) >= 3.5);
}

/// Returns the tip of a beam of length 1 under a force that stays across the tangent of its tip, in
/// the frame of its root: in the tip's frame the force is constant, so one integration from there
/// to the root is all.
/// @param axial,shear,bending  EA, k GA and EI.
Point follower_tip(double force, double axial, double shear, double bending) {
    double lag = 0.0;  // of the tangent behind the section's normal, at the tip
    for (int k = 0; k < 50; ++k)
        lag = std::atan(force * std::cos(lag) / shear / (1.0 - force * std::sin(lag) / axial));
    const Point pull(-force * std::sin(lag), force * std::cos(lag));  // in the tip's section
    using Line = ancf::Vector<double, 4>;  // place, angle and curvature, by the distance to the tip
    const auto rate = [&](const Line& at) {
        const double c = std::cos(at[2]), s = std::sin(at[2]);
        const double normal = c * pull[0] + s * pull[1], across = c * pull[1] - s * pull[0];
        const double stretch = 1.0 + normal / axial, slide = across / shear;
        return Line(-stretch * c + slide * s, -stretch * s - slide * c, -at[3],
                    (stretch * across - slide * normal) / bending);
    };
    Line at = Line::Zero();
    constexpr int steps = 2000;
    for (int k = 0; k < steps; ++k) {
        const Line first = rate(at) / steps, second = rate(at + first / 2.0) / steps;
        const Line third = rate(at + second / 2.0) / steps, fourth = rate(at + third) / steps;
        at += (first + 2.0 * second + 2.0 * third + fourth) / 6.0;
    }
    const double c = std::cos(at[2]), s = std::sin(at[2]);
    return {-c * at[0] - s * at[1], s * at[0] - c * at[1]};
}

TEST_CASE("Reissner: a force that stays across the beam rolls it up", "[verification]") {
    constexpr double depth = 0.02, force = 20.0;  // at E I = 1, k G A = 2.5e3, E A = 3e4
    const double area = depth * depth, young = 12.0 / (area * area), shear = young / 2.4;
    const auto error = [&](int elements) {
        Scene scene;
        const auto beam =
            ancf::straight_beam<Beam>(scene, ancf::Material::from_moduli(young, shear, 1.0),
                                      ancf::rectangle(depth, depth).with_shear_correction(1.0, 1.0),
                                      {0, 0}, {1, 0}, elements, mixed());
        scene.clamp(beam.first(), ancf::Clamp::free_slope);
        scene.add(ancf::PlanarFollowerForce(beam.last(), {0.0, force}));
        ancf::EigenLu solver;
        ancf::StaticsOptions options;
        options.steps = 4;
        REQUIRE(ancf::solve_statics(scene, solver, options).status == Status::converged);
        return (scene.position(beam.last()) - follower_tip(force, young * area, shear * area, 1.0))
            .norm();
    };
    const double coarse = error(10), fine = error(20);
    CAPTURE(coarse, fine);
    CHECK(fine <= 1e-4);
    CHECK(std::log2(coarse / fine) >= 3.5);
}

TEST_CASE("Reissner: a thick beam takes as few iterations on any mesh", "[verification]") {
    constexpr double depth = 0.25;  // elements as short as a 64th of it
    const auto material = ancf::Material::isotropic(12.0 / std::pow(depth, 4), 0.3, 1.0);
    for (const int elements : {4, 16, 64, 256})
        for (const std::string hold : {"clamp", "weld", "pins"}) {
            CAPTURE(elements, hold);
            const auto iterations = [&](double moment, double force) {
                Scene scene;
                const auto beam =
                    ancf::straight_beam<Beam>(scene, material, ancf::rectangle(depth, depth),
                                              {0, 0}, {1, 0}, elements, mixed());
                if (hold == "clamp") {
                    scene.clamp(beam.first(), ancf::Clamp::free_slope);
                } else if (hold == "weld") {
                    scene.add(ancf::PlanarWeld(scene, beam.first()));
                } else {
                    scene.pin(beam.first());
                    scene.fix(beam.last(), Field::r, 1);
                }
                scene.add(ancf::PlanarSlopeMoment(beam.last(), Field::r_y, moment));
                const int loaded = hold == "pins" ? elements / 2 : elements;
                scene.add(ancf::Force<2>(beam.node(loaded), {0, force}));
                ancf::EigenLu solver;
                const auto report = ancf::solve_statics(scene, solver);
                CHECK(report.status == Status::converged);
                CHECK(report.stability == ancf::Stability::stable);
                return report.iterations();
            };
            // up to 6; without the tangent of a turn up to 143 under the moment
            CHECK(iterations(2.3, 0.0) <= 6);
            CHECK(iterations(0.0, 4.0) <= 7);
        }
}

TEST_CASE("Reissner: Lee's frame snaps at the limit loads of the theory", "[verification]") {
    // two legs of 120, hinged at their ends, loaded on the beam at 24 from the corner; 20 elements
    Scene scene;
    ancf::Moments moments;
    moments.area = 6.0;
    moments.yy = moments.zz = 2.0;
    const auto section =
        ancf::Section::from_moments(moments).with_shear_correction(5.0 / 6.0, 5.0 / 6.0);
    const auto material = ancf::Material::isotropic(7.2e6, 0.3, 1.0);
    const auto column =
        ancf::straight_beam<Beam>(scene, material, section, {0, 0}, {0, 120}, 6, mixed());
    const auto corner =
        ancf::straight_beam<Beam>(scene, material, section, {0, 120}, {24, 120}, 2, mixed());
    ancf::NodeId end = corner.last();
    const int rest = scene.add_prototype(Beam(material, section, 8.0, mixed()));
    for (int k = 1; k <= 12; ++k) {
        const ancf::NodeId next = scene.add_node({24.0 + 8.0 * k, 120.0});
        scene.connect<Beam>(rest, end, next);
        end = next;
    }
    scene.pin(column.first());
    scene.pin(end);
    scene.add(ancf::PlanarWeld(scene, column.last(), corner.first(), Field::r_y));
    scene.add(ancf::Force<2>(corner.last(), {0, -18544.5}));
    ancf::EigenLu solver;
    ancf::PathOptions options;
    options.first_step = 0.05;
    options.largest_step = 3.0;
    options.max_points = 400;
    options.progress = [&](const ancf::PathPoint& point, const ancf::State&) {
        return point.factor < 1.2;
    };
    const auto report = ancf::follow_path(scene, solver, options);
    REQUIRE(report.status == Status::stopped);
    REQUIRE(report.critical.size() >= 2);
    CHECK(report.critical[0].factor * 18544.5 == Approx(18544.52709444).epsilon(5e-4));   // 4.2e-4
    CHECK(report.critical[1].factor * 18544.5 == Approx(-9392.489640346).epsilon(5e-4));  // 2.3e-4
}

}  // namespace reissner_test
