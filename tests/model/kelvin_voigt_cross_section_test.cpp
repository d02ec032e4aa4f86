// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Kelvin and Voigt's damping of the beam with cross sections in space: measures, shear rules.

#include <ancf/element/cross_section/beam.hpp>

#include <model/kelvin_voigt_checks.hpp>
#include <support/catch.hpp>

extern template class ancf::KelvinVoigt<ancf::CrossSectionBeam<3>>;
extern template class ancf::KelvinVoigt<ancf::CrossSectionBeam<3, ancf::Geodesic>>;
extern template class ancf::KelvinVoigt<
    ancf::CrossSectionBeam<3, ancf::Projected, ancf::PointwiseShear>>;
extern template class ancf::KelvinVoigt<ancf::QuinticBeam<>>;

namespace kelvin_voigt_cross_section_test {

using namespace ancf;

TEMPLATE_TEST_CASE("KelvinVoigt: derivatives equal the complex step of the force",
                   "[model][damping]", CrossSectionBeam<3>, (CrossSectionBeam<3, Geodesic>),
                   (CrossSectionBeam<3, Projected, PointwiseShear>), QuinticBeam<>) {
    test::kelvin_voigt::check_derivatives<TestType>();
}

TEMPLATE_TEST_CASE("KelvinVoigt: rigid motions of a deformed element meet no force",
                   "[model][damping]", CrossSectionBeam<3>, (CrossSectionBeam<3, Geodesic>),
                   (CrossSectionBeam<3, Projected, PointwiseShear>), QuinticBeam<>) {
    test::kelvin_voigt::check_rigid_motions<TestType>();
}

TEMPLATE_TEST_CASE("KelvinVoigt: free of stress the force is that of eta K v, however turned",
                   "[model][damping]", CrossSectionBeam<3>, (CrossSectionBeam<3, Geodesic>),
                   (CrossSectionBeam<3, Projected, PointwiseShear>)) {
    test::kelvin_voigt::check_force_at_rest<TestType>();
}

TEMPLATE_TEST_CASE("KelvinVoigt: a bar being stretched dissipates eta E A l (strain rate)^2",
                   "[model][damping]", CrossSectionBeam<3>) {
    test::kelvin_voigt::check_stretching<TestType>();
}

}  // namespace kelvin_voigt_cross_section_test
