// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

// Also built for the machine's own registers, where elements are evaluated side by side.

#include <ancf/assembly/assembly.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/section/profiles.hpp>

#include <assembly/element_groups.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

namespace chain_test {

using namespace ancf;

TEMPLATE_TEST_CASE("Assembly: a chain is the sum of its elements, each evaluated alone",
                   "[assembly][pack]", CrossSectionBeam<3>, (CrossSectionBeam<3, Geodesic>),
                   CrossSectionBeam<2>, ContinuumBeam<3>, TorsionBeam, Cable<3>) {
    using Scene = BasicModel<TestType::dimension>;
    using Point = typename Scene::Point;
    constexpr int dofs = TestType::dofs, elements = 21;  // packs and some left over
    Scene scene;
    straight_beam<TestType>(scene, Material::isotropic(2e9, 0.3, 1200.0), rectangle(0.2, 0.2),
                            Point(Point::Zero()), Point(Point::Unit(0) * 4.2), elements);
    test::Random random(3);
    VectorX q = scene.state().q;
    for (double& value : q) value += random.uniform(-0.01, 0.01);
    const VectorX rest = VectorX::Zero(q.size());

    VectorX force = rest;
    MatrixX tangent = MatrixX::Zero(q.size(), q.size());
    double energy = 0.0;
    for (int k = 0; k < elements; ++k) {
        const int first = k * dofs / 2;  // nodes are numbered along the chain
        const Vector<double, dofs> e = q.segment<dofs>(first);
        const auto evaluation = scene.template group<TestType>().element(k).evaluate(e);
        energy += evaluation.energy;
        force.segment<dofs>(first) += evaluation.force;
        tangent.block<dofs, dofs>(first, first) += evaluation.tangent;
    }

    Assembly assembly(scene, Storage::full);
    REQUIRE_FALSE(assembly.evaluate({q, rest, VectorX(), {}}, Request::tangent));
    CHECK(std::abs(assembly.strain_energy() - energy) <= 1e-13 * energy);
    CHECK((assembly.internal_force() - force).norm() <= 1e-13 * force.norm());
    CHECK((MatrixX(assembly.tangent()) - tangent).norm() <= 1e-13 * tangent.norm());

    REQUIRE_FALSE(assembly.evaluate({q, rest, VectorX(), {}}, Request::force));
    CHECK((assembly.internal_force() - force).norm() <= 1e-13 * force.norm());
    CHECK(std::abs(assembly.strain_energy() - energy) <= 1e-13 * energy);
}

TEST_CASE("Assembly: the energy after a force is that of its own coordinates", "[assembly]") {
    using Scene = PlanarModel;
    Scene scene;
    straight_beam<CrossSectionBeam<2>>(scene, Material::isotropic(2e9, 0.3, 1200.0),
                                       rectangle(0.1, 0.2), {0, 0}, {4, 0}, 4);
    const VectorX rest = VectorX::Zero(scene.state().q.size());
    VectorX q = scene.state().q;
    Assembly assembly(scene, Storage::full);
    REQUIRE_FALSE(assembly.evaluate({q, rest, VectorX(), {}}, Request::tangent));
    CHECK(assembly.strain_energy() <= 1e-20);  // J, round-off: E A is 4e7 N
    q[2] += 0.1;
    REQUIRE_FALSE(assembly.evaluate({q, rest, VectorX(), {}}, Request::force));
    q[2] -= 0.1;
    CHECK(assembly.strain_energy() > 1.0);
    REQUIRE_FALSE(assembly.evaluate({q, rest, VectorX(), {}}, Request::force));
    CHECK(assembly.strain_energy() <= 1e-20);
}

}  // namespace chain_test
