// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Beams whose axis does not run through the centroids of their sections.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>

#include <element/property_checks.hpp>
#include <support/catch.hpp>

#include <cmath>

namespace off_axis_test {

using namespace ancf;
using Paper = CrossSectionBeam<3>;
using Carried = CrossSectionBeam<3, Geodesic>;
using Engineering = CrossSectionBeam<3, Geodesic, LinearShear, EngineeringMeasure>;
using Planar = CrossSectionBeam<2>;

/// Returns an element of length 1 whose ends are turned by an angle, one back and one forth, and
/// brought closer.
template <class Element>
typename Element::Coordinates arch(double angle, double chord, double stretch) {
    constexpr int d = Element::dimension;
    typename Element::Coordinates e;
    test::for_each_vector<Element>([&](int node, Field field, int at) {
        const double turn = node == 0 ? -angle : angle, c = std::cos(turn), s = std::sin(turn);
        Vector<double, 3> v(0.0, 0.0, 1.0);
        if (field == Field::r) v = {node * chord, 0.0, 0.0};
        if (field == Field::r_x) v = {stretch * c, stretch * s, 0.0};
        if (field == Field::r_y) v = {-s, c, 0.0};
        e.template segment<d>(at) = v.template head<d>();
    });
    return e;
}

TEMPLATE_TEST_CASE("off the axis: no state has negative energy", "[element]", Paper, Carried,
                   Engineering, Planar) {
    // with eps^2 at three points and its product with curvature at two the least is -0.37 J of 35 J
    const auto rubber = Material::isotropic(0.7e6, 0.3, 5540.0);
    int states = 0;
    for (const double offset_y : {0.01, 0.03}) {
        const TestType element(rubber, offset(rectangle(0.04, 0.05), offset_y, 0.0), 1.0,
                               CrossSectionOptions{Rule::mixed()});
        for (int turn = -20; turn <= 20; ++turn)
            for (int chord = 0; chord <= 20; ++chord)
                for (const double stretch : {0.9, 1.0, 1.1}) {
                    const auto e = arch<TestType>(0.05 * turn, 0.85 + 0.01 * chord, stretch);
                    if (!element.admissible(e)) continue;
                    ++states;
                    REQUIRE(element.energy(e) >= 0.0);
                }
    }
    CHECK(states == 2 * 41 * 21 * 3);
}

}  // namespace off_axis_test
