// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A section with equal principal moments bends alike in every plane: order and error of the
/// paper's slender cantilever, its load turned against the axes of the section.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/solver/eigen_ldlt.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace isotropy_test {

constexpr double degree = 3.14159265358979323846 / 180.0;

/// Sections of the paper's slender cantilever: its square, and the round one of equal bending.
enum class Profile { square, round };

/// Returns where the tip is in the plane of the load, m.
template <class Directors>
ancf::Vector<double, 2> tip(Profile profile, double angle, int elements) {
    using Element = ancf::CrossSectionBeam<3, Directors>;
    ancf::BasicModel<Element::dimension> scene;
    const double young = 2.07e11, inertia = 1e-8 / 12.0, length = 2.0;
    const auto section = profile == Profile::square
                             ? ancf::rectangle(0.01, 0.01)
                             : ancf::circle(std::pow(4.0 * inertia / (180.0 * degree), 0.25));
    ancf::CrossSectionOptions options;
    options.rule = ancf::Rule::mixed();
    const auto beam =
        ancf::straight_beam<Element>(scene, ancf::Material::from_moduli(young, 7.9615e10, 7850.0),
                                     section, {0, 0, 0}, {length, 0, 0}, elements, options);
    scene.clamp(beam.first(), ancf::Clamp::free_slope);
    const ancf::Vector<double, 3> across(0.0, std::cos(angle), std::sin(angle));
    scene.add(ancf::Force<3>(beam.last(), 1.5 * young * inertia / (length * length) * across));
    ancf::EigenLdlt solver;
    ancf::StaticsOptions how;
    how.newton = ancf::NewtonKind::mixed;
    REQUIRE(ancf::solve_statics(scene, solver, how).status == ancf::Status::converged);
    const ancf::Vector<double, 3> end = scene.position(beam.last());
    return {end[0], end.dot(across)};
}

/// Errors of 4, 8 and 16 elements relative to the length, against 64 of the geodesic element.
template <class Directors>
std::array<double, 3> errors(Profile profile, double angle) {
    const auto limit = tip<ancf::Geodesic>(profile, angle, 64);
    std::array<double, 3> result{};
    for (std::size_t k = 0; k < 3; ++k)
        result[k] = (tip<Directors>(profile, angle, 4 << k) - limit).norm() / 2.0;
    return result;
}

TEMPLATE_TEST_CASE("isotropy: carried directors bend with one order and error in every plane",
                   "[verification]", ancf::Geodesic, ancf::Transported) {
    const Profile profile = GENERATE(Profile::square, Profile::round);
    const auto straight = errors<TestType>(profile, 0.0);
    for (const double angle : {0.0, 15.0, 30.0, 45.0}) {
        const auto turned = errors<TestType>(profile, angle * degree);
        INFO("angle " << angle << ": " << turned[0] << ", " << turned[1] << ", " << turned[2]);
        for (std::size_t k = 1; k < 3; ++k)
            CHECK(std::log2(turned[k - 1] / turned[k]) >= 3.9);  // measured 3.99 to 4.18
        // measured within 0.3, 2 and 13 percent of 1.7e-4, 1.06e-5 and 6.6e-7
        for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(turned[k] / straight[k] - 1.0) <= 0.2);
    }
}

TEST_CASE("isotropy: interpolating angles or vectors is the same in bending", "[verification]") {
    const auto vectors = tip<ancf::Transported>(Profile::square, 30.0 * degree, 4);
    CHECK((vectors - tip<ancf::Geodesic>(Profile::square, 30.0 * degree, 4)).norm() <= 1e-9);
}

TEST_CASE("isotropy: projected directors fall from fourth to second order off the axes",
          "[verification]") {
    const Profile profile = GENERATE(Profile::square, Profile::round);
    const auto straight = errors<ancf::Projected>(profile, 0.0);
    CHECK(std::log2(straight[1] / straight[2]) >= 3.9);  // measured 4.01
    for (const double angle : {15.0, 30.0, 45.0}) {
        const auto turned = errors<ancf::Projected>(profile, angle * degree);
        INFO("angle " << angle << ": " << turned[0] << ", " << turned[1] << ", " << turned[2]);
        const double order = std::log2(turned[1] / turned[2]);
        CHECK(order >= 1.95);  // measured 2.01 to 2.05
        CHECK(order <= 2.2);
        CHECK(turned[2] <= 2.1e-4);  // measured 4.8e-5, 1.4e-4, 1.9e-4
    }
}

}  // namespace isotropy_test
