// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The body of a joint by itself.

#include <ancf/element/joint/affine_joint.hpp>

#include <element/mixed_checks.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

namespace affine_joint_test {

using namespace ancf;

TEMPLATE_TEST_CASE("AffineJoint: the mixed tangent has the stresses of linearised strains",
                   "[element][joint][tangent]", AffineJoint<2>, AffineJoint<3>) {
    constexpr int d = TestType::dimension;
    const TestType joint(Material::isotropic(2e7, 0.3, 7800.0), 2e-3, 0.1);
    test::check_mixed_tangent(joint, [](test::Random& random) {
        Vector<double, 2 * d* d> e = 0.2 * random.vector(2 * d * d);
        for (int k = 0; k < d; ++k) e[(d + 1) * k] += 1.0;
        return e;
    });
}

}  // namespace affine_joint_test
