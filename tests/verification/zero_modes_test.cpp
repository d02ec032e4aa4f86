// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Stress-free chains have six motions without energy and not one more, straight, bent or twisted.
///
/// As many eigenvalues of K x = w M x lie below a value as K - w M has negative pivots.

#include <ancf/assembly/assembly.hpp>
#include <ancf/constants.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/builders/curve.hpp>
#include <ancf/solver/eigen_ldlt.hpp>

#include <support/catch.hpp>

#include <cmath>
#include <type_traits>
#include <vector>

namespace zero_modes_test {

using ancf::Status;
using Paper = ancf::CrossSectionBeam<3>;
using Carried = ancf::CrossSectionBeam<3, ancf::Geodesic>;
using Transporting = ancf::CrossSectionBeam<3, ancf::Transported>;
using Quintic = ancf::QuinticBeam<>;

using ancf::pi;
constexpr double young = 2e9, density = 1000.0, height = 0.05;

enum class Shape { straight, semicircle, twisted };

template <class Element>
ancf::BasicModel<Element::dimension> chain(Shape shape, const char* rule, int elements) {
    ancf::BasicModel<Element::dimension> scene;
    typename Element::Options options;
    options.rule = ancf::Rule::named(rule);
    const auto material = ancf::Material::isotropic(young, 0.3, density);
    const auto section = ancf::rectangle(height, height);
    if (shape == Shape::straight) {
        ancf::straight_beam<Element>(scene, material, section, {0, 0, 0}, {1, 0, 0}, elements,
                                     options);
    } else if (shape == Shape::semicircle) {
        ancf::arc<Element>(scene, material, section, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1.0 / pi, pi,
                           elements, options);
    } else {
        std::vector<ancf::CurvePoint<3>> points;
        for (int k = 0; k <= elements; ++k) {
            const double x = static_cast<double>(k) / elements, angle = 0.5 * pi * x;
            ancf::Matrix<double, 3> slopes = ancf::Matrix<double, 3>::Identity();
            slopes.col(1) << 0.0, std::cos(angle), std::sin(angle);
            slopes.col(2) << 0.0, -std::sin(angle), std::cos(angle);
            points.push_back({{x, 0.0, 0.0}, slopes, {0.0, 0.0, 0.0}});
        }
        ancf::beam_through<Element>(scene, material, section, points,
                                    std::vector<double>{1.0 / elements}, options);
    }
    return scene;
}

/// Returns how many eigenvalues lie below `value` times the square of Euler's first frequency.
int below(const ancf::Scene& scene, double value) {
    ancf::Assembly assembly(scene, ancf::Storage::lower);
    const ancf::State& state = scene.state();
    const ancf::VectorX rest = ancf::VectorX::Zero(state.q.size());
    REQUIRE_FALSE(
        assembly.evaluate({state.q, rest, state.multipliers, {}}, ancf::Request::tangent));
    const double first = 22.37 * 22.37 * young * height * height / 12.0 / density;
    const ancf::SparseMatrix shifted = assembly.tangent() - value * first * assembly.mass();
    ancf::EigenLdlt solver;
    solver.analyze(shifted);
    return solver.factorize(shifted).negative_pivots;
}

TEMPLATE_TEST_CASE("chains without stress have exactly six motions without energy",
                   "[verification][zero-modes]", Paper, Carried, Transporting, Quintic) {
    const auto shape = GENERATE(Shape::straight, Shape::semicircle, Shape::twisted);
    int checked = 0;
    const std::vector<const char*> rules =
        std::is_same_v<TestType, Quintic>
            ? std::vector<const char*>{"quintic", "gauss5"}
            : std::vector<const char*>{"paper", "mixed", "gauss3", "lobatto3"};
    for (const char* rule : rules)
        for (const int elements : {1, 2, 3, 4, 5, 8, 16, 32, 64}) {
            if (elements == 1 && shape == Shape::semicircle) continue;  // turns by 180 degrees
            INFO(rule << ", " << elements << " elements, shape " << static_cast<int>(shape));
            const auto scene = chain<TestType>(shape, rule, elements);
            CHECK(below(scene, -1e-6) == 0);
            CHECK(below(scene, 1e-6) == 6);
            CHECK(below(scene, 1e-2) == 6);  // no weak mode either
            ++checked;
        }
    CHECK(checked >= 8 * static_cast<int>(rules.size()));
}

}  // namespace zero_modes_test
