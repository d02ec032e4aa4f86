// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Beams that are twisted or curved in their stress-free state against the flexibility of
/// Timoshenko's beam: the twisted cantilever of MacNeal and Harder, and a deep quarter circle.
/// docs/theory-references.md, "Twist" and "Curvature". Thin rings of continuum beams, which lock.

#include <ancf/constants.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>

#include <cmath>
#include <vector>

namespace curved_references_test {

using namespace ancf;
using Green = CrossSectionBeam<3, Geodesic>;
using Engineering = CrossSectionBeam<3, Geodesic, LinearShear, EngineeringMeasure>;

constexpr double length = 12.0, width = 1.1, thickness = 0.32, young = 29e6, shear = young / 2.44;
constexpr double twist = 0.5 * pi / length;  // rad/m

/// Clamps a beam and returns the displacement of its tip along a force there, for a unit of it.
template <class Element>
double displacement(Model& model, const Beam<Element>& beam, const Vector<double, 3>& force) {
    model.clamp(beam.first(), Clamp::free_slope);
    model.add(Force<3>(beam.last(), force));
    const Vector<double, 3> start = model.position(beam.last());
    BlockTridiagonal solver;
    REQUIRE(solve_statics(model, solver).status == Status::converged);
    return (model.position(beam.last()) - start).dot(force) / force.squaredNorm();
}

/// Returns the displacement of the tip by a unit force along the width of the root, or across it.
template <class Element>
double flexibility(bool across, int elements) {
    std::vector<CurvePoint<3>> points;
    for (int k = 0; k <= elements; ++k) {
        const double x = length * k / elements, c = std::cos(twist * x), s = std::sin(twist * x);
        CurvePoint<3> point{{x, 0.0, 0.0}, Matrix<double, 3>::Identity()};
        point.slopes.col(1) << 0.0, c, s;
        point.slopes.col(2) << 0.0, -s, c;
        points.push_back(point);
    }
    Model model;
    const auto beam = beam_through<Element>(model, Material::from_moduli(young, shear, 1.0),
                                            rectangle(thickness, width), points,
                                            {length / elements}, CrossSectionOptions::best());
    return displacement(model, beam, 1e-3 * Vector<double, 3>::Unit(across ? 2 : 1));
}

/// The integral of (L - x)^2 (cos^2/EI_1 + sin^2/EI_2) + 1/kGA along the beam.
double theory(bool across) {
    const double along = young * thickness * std::pow(width, 3) / 12.0;
    const double other = young * width * std::pow(thickness, 3) / 12.0;
    const double root = across ? other : along, turned = across ? along : other;
    const double cube = std::pow(length, 3) / 6.0;
    // of (L - x)^2 cos(2 twist x), whose angle ends at pi
    const double oscillating = length / (2.0 * twist * twist);
    return (cube + 0.5 * oscillating) / root + (cube - 0.5 * oscillating) / turned +
           length / (5.0 / 6.0 * shear * width * thickness);
}

TEST_CASE("twisted reference: engineering strains come to Timoshenko's beam", "[verification]") {
    const bool across = GENERATE(false, true);
    CAPTURE(across);
    const double coarse = flexibility<Engineering>(across, 12) / theory(across) - 1.0;
    const double fine = flexibility<Engineering>(across, 24) / theory(across) - 1.0;
    CHECK(std::abs(fine) <= 4e-6);
    CHECK(std::log2(coarse / fine) >= 3.5);  // fourth order
}

TEST_CASE("twisted reference: Green's stresses along twisted fibres carry shear forces",
          "[verification]") {
    const bool across = GENERATE(false, true);
    CAPTURE(across);
    const double fibres =
        twist * twist * std::pow(length, 3) / (3.0 * 5.0 / 6.0 * shear * width * thickness);
    CHECK(flexibility<Green>(across, 24) == Approx(theory(across) + fibres).epsilon(5e-7));
    CHECK(fibres / theory(across) == Approx(across ? 5.2e-4 : 1.62e-3).epsilon(0.01));
}

/// Returns the displacement of the tip of a quarter circle of radius 1 and depth 0.15 by a unit
/// force in its plane, in its own direction: along the tangent of the root or across it.
template <class Element>
double arc_flexibility(bool across, int elements) {
    Model model;
    const auto beam =
        arc<Element>(model, Material::from_moduli(2e11, 8e10, 1.0), rectangle(0.1, 0.15), {0, 0, 0},
                     {1, 0, 0}, {0, 1, 0}, 1.0, 0.5 * pi, elements, CrossSectionOptions::best());
    return displacement(model, beam, 0.3 * Vector<double, 3>::Unit(across ? 1 : 0));
}

/// With M = F cos a or F (1 - sin a), and axial and shear forces F cos a and F sin a or in turn.
double arc_theory(bool across) {
    const double area = 0.1 * 0.15, bending = 2e11 * 0.1 * std::pow(0.15, 3) / 12.0;
    const double quarter = 0.25 * pi;
    return (across ? 3.0 * quarter - 2.0 : quarter) / bending + quarter / (2e11 * area) +
           quarter / (5.0 / 6.0 * 8e10 * area);
}

TEST_CASE("curved reference: engineering strains come to the theory of thin arcs",
          "[verification]") {
    const bool across = GENERATE(false, true);
    CAPTURE(across);
    const double coarse = arc_flexibility<Engineering>(across, 8) / arc_theory(across) - 1.0;
    const double fine = arc_flexibility<Engineering>(across, 16) / arc_theory(across) - 1.0;
    CHECK(std::abs(fine) <= 3e-6);
    CHECK(std::log2(coarse / fine) >= 3.5);  // fourth order
    // Green's strain neglects the depth over the radius: 1.2e-2 and -3.7e-4
    const double green = arc_flexibility<Green>(across, 16) / arc_theory(across) - 1.0;
    CHECK(green == Approx(across ? -3.7e-4 : 1.16e-2).epsilon(0.05));
}

/// Returns by which part of its angle a quarter circle of radius 1 turns too far under a moment at
/// its end, where its axis lies aside of the centroids; a positive distance is inwards.
template <class Element>
double turn_too_far(double aside) {
    const Section centred = rectangle(0.01, 0.01);
    Model model;
    const auto beam = arc<Element>(model, Material::from_moduli(2e11, 8e10, 1.0),
                                   offset(centred, aside, 0.0), {0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                   1.0, 0.5 * pi, 16, CrossSectionOptions::best());
    model.clamp(beam.first(), Clamp::free_slope);
    const double curvature = 1e-6;
    model.add(
        SlopeMoment(beam.last(), Field::r_y, {0, 0, 1}, curvature * 2e11 * centred.moments().yy));
    const Vector<double, 3> start = model.value(beam.last(), Field::r_y);
    BlockTridiagonal solver;
    REQUIRE(solve_statics(model, solver).status == Status::converged);
    const Vector<double, 3> end = model.value(beam.last(), Field::r_y);
    const double turn = start[0] * end[1] - start[1] * end[0];
    return turn / (curvature * 0.5 * pi * (1.0 - aside)) - 1.0;
}

TEST_CASE("curved reference: an axis beside the centroids errs by its distance over the radius",
          "[verification]") {
    const double aside = GENERATE(-0.01, 0.01);  // docs/limits.md
    CAPTURE(aside);
    CHECK(turn_too_far<Engineering>(aside) == Approx(aside).epsilon(0.02));
    CHECK(turn_too_far<Green>(aside) == Approx(3.0 * aside).epsilon(0.03));
}

/// Returns the deflection of a quarter of a ring of continuum beams, radius 1, under a small force
/// along the ring at its end, relative to that of a thin beam.
double of_thin_ring(double depth, int elements) {
    const Section square = rectangle(depth, depth);
    PlanarModel model;
    const auto beam = arc<ContinuumBeam<2>>(model, Material::isotropic(2e11, 0.3, 1.0), square,
                                            {0, 0}, {1, 0}, 1.0, 0.5 * pi, elements);
    model.clamp(beam.first());
    const double deflection = 1e-6;  // m
    const double force = deflection * 2e11 * square.moments().yy / (0.75 * pi - 2.0);
    model.add(Force<2>(beam.last(), {0.0, force}));
    const double start = model.position(beam.last())[1];
    BlockTridiagonal solver;
    REQUIRE(solve_statics(model, solver).status == Status::converged);
    return (model.position(beam.last())[1] - start) / deflection;
}

TEST_CASE("curved reference: thin rings of continuum beams lock by a known part",
          "[verification]") {
    // docs/theory-continuum.md, "Accuracy", to the digits that stand there
    CHECK(of_thin_ring(1.0 / 30.0, 8) == Approx(0.87).epsilon(0.005));
    CHECK(of_thin_ring(1.0 / 100.0, 4) == Approx(0.032).epsilon(0.015));
    CHECK(of_thin_ring(1.0 / 100.0, 16) == Approx(0.922).epsilon(0.0005));
    CHECK(of_thin_ring(1.0 / 300.0, 16) == Approx(0.589).epsilon(0.001));
}

}  // namespace curved_references_test
