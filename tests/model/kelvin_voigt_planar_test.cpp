// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Kelvin and Voigt's damping of beams in the plane.

#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/planar/beam.hpp>

#include <model/kelvin_voigt_checks.hpp>
#include <support/catch.hpp>

extern template class ancf::KelvinVoigt<ancf::CrossSectionBeam<2>>;
extern template class ancf::KelvinVoigt<ancf::ContinuumBeam<2>>;

namespace kelvin_voigt_planar_test {

using namespace ancf;

TEMPLATE_TEST_CASE("KelvinVoigt: derivatives equal the complex step of the force",
                   "[model][damping]", CrossSectionBeam<2>, ContinuumBeam<2>) {
    test::kelvin_voigt::check_derivatives<TestType>();
}

TEMPLATE_TEST_CASE("KelvinVoigt: rigid motions of a deformed element meet no force",
                   "[model][damping]", CrossSectionBeam<2>, ContinuumBeam<2>) {
    test::kelvin_voigt::check_rigid_motions<TestType>();
}

TEMPLATE_TEST_CASE("KelvinVoigt: free of stress the force is that of eta K v, however turned",
                   "[model][damping]", CrossSectionBeam<2>, ContinuumBeam<2>) {
    test::kelvin_voigt::check_force_at_rest<TestType>();
}

TEMPLATE_TEST_CASE("KelvinVoigt: a bar being stretched dissipates eta E A l (strain rate)^2",
                   "[model][damping]", CrossSectionBeam<2>, ContinuumBeam<2>) {
    test::kelvin_voigt::check_stretching<TestType>();
}

}  // namespace kelvin_voigt_planar_test
