// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Kelvin and Voigt's damping of the cable in the plane: axial strain and curvature.

#include <ancf/element/cable/cable.hpp>
#include <ancf/model/loads/damping.hpp>

#include <model/kelvin_voigt_checks.hpp>
#include <support/catch.hpp>

#include <limits>

extern template class ancf::KelvinVoigt<ancf::Cable<2>>;
extern template class ancf::KelvinVoigt<ancf::Cable<2, ancf::EngineeringAxial>>;

namespace kelvin_voigt_cable_test {

using namespace ancf;

TEMPLATE_TEST_CASE("KelvinVoigt: derivatives equal the complex step of the force",
                   "[model][damping]", Cable<2>, (Cable<2, EngineeringAxial>)) {
    test::kelvin_voigt::check_derivatives<TestType>();
}

TEMPLATE_TEST_CASE("KelvinVoigt: rigid motions of a deformed element meet no force",
                   "[model][damping]", Cable<2>, (Cable<2, EngineeringAxial>)) {
    test::kelvin_voigt::check_rigid_motions<TestType>();
}

TEMPLATE_TEST_CASE("KelvinVoigt: free of stress the force is that of eta K v, however turned",
                   "[model][damping]", Cable<2>, (Cable<2, EngineeringAxial>)) {
    test::kelvin_voigt::check_force_at_rest<TestType>();
}

TEMPLATE_TEST_CASE("KelvinVoigt: a bar being stretched dissipates eta E A l (strain rate)^2",
                   "[model][damping]", Cable<2>) {
    test::kelvin_voigt::check_stretching<TestType>();
}

TEST_CASE("KelvinVoigt: values that cannot be meant are refused", "[model][damping][bad-input]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double value : {-1.0, nan, std::numeric_limits<double>::infinity()})
        CHECK_THROWS_AS(
            KelvinVoigt<Cable<2>>(test::kelvin_voigt::damped_element<Cable<2>>(), {}, value),
            InvalidArgument);
}

}  // namespace kelvin_voigt_cable_test
