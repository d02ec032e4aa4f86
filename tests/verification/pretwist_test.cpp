// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The cantilever of MacNeal and Harder, twisted by 90 degrees in its stress-free state, against
/// the flexibility of Timoshenko's beam. docs/theory-references.md, "Twist".

#include <ancf/constants.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>

#include <cmath>
#include <vector>

namespace pretwist_test {

using namespace ancf;
using Green = CrossSectionBeam<3, Geodesic>;
using Engineering = CrossSectionBeam<3, Geodesic, LinearShear, EngineeringMeasure>;

constexpr double length = 12.0, width = 1.1, thickness = 0.32, young = 29e6, shear = young / 2.44;
constexpr double twist = 0.5 * pi / length;  // rad/m

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
    model.clamp(beam.first(), Clamp::free_slope);
    const double force = 1e-3;
    model.add(Force<3>(beam.last(), {0.0, across ? 0.0 : force, across ? force : 0.0}));
    BlockTridiagonal solver;
    REQUIRE(solve_statics(model, solver).status == Status::converged);
    return model.position(beam.last())[across ? 2 : 1] / force;
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

TEST_CASE("pretwist: engineering strains come to Timoshenko's beam", "[verification]") {
    const bool across = GENERATE(false, true);
    CAPTURE(across);
    const double coarse = flexibility<Engineering>(across, 12) / theory(across) - 1.0;
    const double fine = flexibility<Engineering>(across, 24) / theory(across) - 1.0;
    CHECK(std::abs(fine) <= 4e-6);
    CHECK(std::log2(coarse / fine) >= 3.5);  // fourth order
}

TEST_CASE("pretwist: Green's stresses along twisted fibres carry shear forces", "[verification]") {
    const bool across = GENERATE(false, true);
    CAPTURE(across);
    const double fibres =
        twist * twist * std::pow(length, 3) / (3.0 * 5.0 / 6.0 * shear * width * thickness);
    CHECK(flexibility<Green>(across, 24) == Approx(theory(across) + fibres).epsilon(5e-7));
    CHECK(fibres / theory(across) == Approx(across ? 5.2e-4 : 1.62e-3).epsilon(0.01));
}

}  // namespace pretwist_test
