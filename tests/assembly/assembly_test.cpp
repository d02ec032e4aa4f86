// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ancf/assembly/assembly.hpp>
#include <ancf/assembly/resultant.hpp>
#include <ancf/element/continuum/beam.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/loads.hpp>

#include <assembly/element_groups.hpp>
#include <support/bar.hpp>
#include <support/catch.hpp>
#include <support/random_state.hpp>

#include <limits>

namespace assembly_test {

using ancf::Field;
using ancf::MatrixX;
using ancf::Storage;
using ancf::VectorX;
using Bar = ancf::test::Bar<3>;
using Beam = ancf::ContinuumBeam<3>;
using Scene = ancf::Model;

/// |r - p|^2 = 1, a constraint with a curvature.
struct Sphere {
    ancf::NodeId node;
    [[nodiscard]] ancf::Coupling coupling() const { return {{node, Field::r}}; }
    [[nodiscard]] int equations() const { return 1; }
    [[nodiscard]] std::string name() const { return "sphere"; }
    void evaluate(const ancf::ConstraintState& at, ancf::ConstraintResult& out) const {
        out.violation[0] = at.q.squaredNorm() - 1.0;
        out.jacobian = 2.0 * at.q.transpose();
        out.stiffness = 2.0 * at.multipliers[0] * MatrixX::Identity(3, 3);
    }
};

/// A bent beam of two elements, a bar hung between its end and a node of its own, and loads.
Scene make_scene() {
    Scene scene;
    const auto material = ancf::Material::from_moduli(100.0, 40.0, 2.0);
    const auto beam = ancf::straight_beam<Beam>(scene, material, ancf::rectangle(0.2, 0.3),
                                                {0, 0, 0}, {1, 0.5, 0.2}, 2);
    const auto anchor = scene.add_node({1, 2, 0});
    scene.connect<Bar>(scene.add_prototype(Bar(7.0, 0.5, 1.3)), anchor, beam.last());
    scene.clamp(beam.first(), ancf::Clamp::free_slope);
    scene.fix(anchor, Field::r, 1);
    scene.set_gravity({0.0, -9.81, 0.0});
    scene.add_mass(beam.last(), 0.7);
    scene.add(ancf::SlopeMoment(beam.last(), Field::r_y, {0, 0, 1}, 0.4));
    return scene;
}

VectorX disturbed(const Scene& scene, unsigned seed) {
    ancf::test::Random random(seed);
    VectorX q = scene.state().q;
    for (double& value : q) value += random.uniform(-0.05, 0.05);
    return q;
}

struct Evaluated {
    VectorX residual;
    MatrixX tangent;
};

Evaluated evaluate(const Scene& scene, const VectorX& q, const VectorX& multipliers,
                   Storage storage = Storage::full) {
    ancf::Assembly assembly(scene, storage);
    const VectorX v = VectorX::Zero(q.size());
    const auto fault = assembly.evaluate({q, v, multipliers, {}}, ancf::Request::tangent);
    REQUIRE_FALSE(fault);
    Evaluated out;
    assembly.residual(out.residual);
    out.tangent = MatrixX(assembly.tangent());
    return out;
}

TEST_CASE("Assembly: a node carries the vectors that its elements need, no more", "[assembly]") {
    const Scene scene = make_scene();
    CHECK(scene.layout().size() == 3 * 12 + 3);
    CHECK(scene.layout().fields(3) == ancf::Fields(Field::r));
    const ancf::Assembly assembly(scene, Storage::full);
    CHECK(assembly.numbering().free_coordinates() == 39 - 9 - 1);
}

TEST_CASE("Assembly: the tangent is the derivative of the residual", "[assembly]") {
    const auto seed = GENERATE(range(0U, 10U));
    INFO("seed " << seed);
    Scene scene = make_scene();
    scene.add(Sphere{{1}});
    const VectorX q = disturbed(scene, seed);
    const VectorX multipliers = VectorX::Constant(1, 3.0);
    const ancf::Numbering numbering(scene);
    const MatrixX tangent = evaluate(scene, q, multipliers).tangent;
    MatrixX expected(numbering.unknowns(), numbering.unknowns());
    constexpr double step = 1e-6;
    for (int j = 0; j < numbering.unknowns(); ++j) {
        VectorX unknown = VectorX::Zero(numbering.unknowns());
        unknown[j] = step;
        VectorX change = VectorX::Zero(q.size());
        numbering.add_free(unknown, 1.0, change);
        const VectorX dual = unknown.tail(1);
        expected.col(j) = (evaluate(scene, q + change, multipliers + dual).residual -
                           evaluate(scene, q - change, multipliers - dual).residual) /
                          (2.0 * step);
    }
    REQUIRE(expected.norm() > 1.0);
    // truncation and cancellation of the central difference; measured 2e-10
    CHECK((tangent - expected).norm() <= 2e-9 * expected.norm());
}

TEST_CASE("Assembly: lower storage holds the lower half of the full tangent", "[assembly]") {
    const Scene scene = make_scene();
    const VectorX q = disturbed(scene, 7);
    const MatrixX full = evaluate(scene, q, VectorX()).tangent;
    const MatrixX lower = evaluate(scene, q, VectorX(), Storage::lower).tangent;
    const MatrixX half = full.triangularView<Eigen::Lower>();
    CHECK((lower - half).norm() <= 1e-14 * full.norm());
    CHECK((full - full.transpose()).norm() <= 1e-14 * full.norm());
}

TEST_CASE("Assembly: repeated evaluations give equal bits", "[assembly]") {
    const Scene scene = make_scene();
    const VectorX q = disturbed(scene, 3);
    const auto first = evaluate(scene, q, VectorX());
    const auto second = evaluate(scene, q, VectorX());
    CHECK(first.residual == second.residual);
    CHECK(first.tangent == second.tangent);
}

TEST_CASE("Assembly: mass as matrix and as product agree, gravity has the weight", "[assembly]") {
    const Scene scene = make_scene();
    ancf::Assembly assembly(scene, Storage::full);
    const auto& numbering = assembly.numbering();
    VectorX free = VectorX::LinSpaced(numbering.unknowns(), -1.0, 2.0);
    VectorX a = VectorX::Zero(scene.layout().size());
    numbering.add_free(free, 1.0, a);
    VectorX product;
    numbering.gather_free(assembly.mass_product(a), product);
    const VectorX expected = assembly.mass() * free;
    CHECK((product - expected).norm() <= 1e-14 * expected.norm());

    const VectorX& q = scene.state().q;
    const VectorX v = VectorX::Zero(q.size());
    REQUIRE_FALSE(assembly.evaluate({q, v, VectorX(), {}}, ancf::Request::force));
    const double length = std::sqrt(1.0 + 0.25 + 0.04);
    const double mass = 2.0 * 0.2 * 0.3 * length + 0.5 * 1.3 + 0.7;
    const auto sum = ancf::resultant(scene, q, assembly.external_force());
    CHECK(sum.force[1] == Approx(-9.81 * mass).epsilon(1e-13));
    CHECK(std::abs(sum.force[0]) + std::abs(sum.force[2]) <= 1e-13 * mass);
    for (int k = 0; k < 6; ++k) {  // the work in a rigid motion
        const double part = k < 3 ? sum.force[k] : sum.moment[k - 3];
        CHECK(ancf::rigid_motion(scene, q, k).dot(assembly.external_force()) ==
              Approx(part).margin(1e-13 * mass));
    }
}

TEST_CASE("Assembly: loads grow with the load factor at the same rate however large it is",
          "[assembly]") {
    Scene scene = make_scene();
    const ancf::NodeId end{scene.nodes() - 1};
    scene.add(ancf::Force<3>(end, {0, 0, 1}), [](double factor) { return 3.0 * factor * factor; });
    const ancf::Assembly assembly(scene, Storage::full);
    const VectorX& q = scene.state().q;
    const int height = scene.coordinate(end, Field::r) + 2;
    const VectorX unit = assembly.load_rate(q, 0.0);
    CHECK(unit.norm() > 1.0);  // gravity and the moment
    for (const double factor : {-1e12, -1.0, 1e-6, 5.0, 1e6, 1e15}) {
        INFO("factor " << factor);
        VectorX rate = assembly.load_rate(q, factor);
        CHECK(rate[height] - unit[height] == Approx(6.0 * factor).epsilon(1e-9).margin(1e-9));
        rate[height] = unit[height];
        CHECK((rate - unit).norm() <= 1e-10 * unit.norm());
    }
}

TEST_CASE("Assembly: internal forces of any state have no resultant", "[assembly]") {
    const Scene scene = make_scene();
    const VectorX q = disturbed(scene, 11);
    ancf::Assembly assembly(scene, Storage::full);
    REQUIRE_FALSE(
        assembly.evaluate({q, VectorX::Zero(q.size()), VectorX(), {}}, ancf::Request::force));
    const auto sum = ancf::resultant(scene, q, assembly.internal_force());
    const double scale = assembly.internal_force().norm();
    REQUIRE(scale > 0.1);
    CHECK(sum.force.norm() <= 1e-14 * scale);
    CHECK(sum.moment.norm() <= 1e-14 * scale);
}

TEST_CASE("Assembly: the first element that fails is named", "[assembly][bad-input]") {
    const Scene scene = make_scene();
    ancf::Assembly assembly(scene, Storage::full);
    const VectorX v = VectorX::Zero(scene.state().q.size());
    SECTION("not finite") {
        VectorX q = scene.state().q;
        q[scene.coordinate({2}, Field::r)] = std::numeric_limits<double>::quiet_NaN();
        const auto fault = assembly.evaluate({q, v, VectorX(), {}}, ancf::Request::tangent);
        REQUIRE(fault);
        CHECK(fault->status == ancf::Status::not_finite);
        CHECK(fault->group == 0);
        CHECK(fault->element == 1);
    }
    SECTION("degenerate") {
        VectorX q = scene.state().q;
        q.segment<3>(scene.coordinate({0}, Field::r_y)).setZero();
        const auto fault = assembly.inspect(q);
        REQUIRE(fault);
        CHECK(fault->status == ancf::Status::degenerate);
        CHECK(fault->element == 0);
    }
}

TEST_CASE("Assembly: the largest turn of an element is the angle between its slopes",
          "[assembly]") {
    const Scene scene = make_scene();
    const ancf::Assembly assembly(scene, Storage::full);
    VectorX q = scene.state().q;
    for (const double angle : {0.3, 2.0}) {
        for (int node = 0; node < 3; ++node)  // the fourth has no slope
            q.segment<3>(scene.coordinate({node}, Field::r_x)) << 1.0, 0.0, 0.0;
        CHECK(assembly.largest_turn(q) <= 1e-8);
        q.segment<3>(scene.coordinate({0}, Field::r_x)) << 3.0 * std::cos(angle),
            3.0 * std::sin(angle), 0.0;
        CHECK(assembly.largest_turn(q) == Approx(angle));
    }
    q.segment<3>(scene.coordinate({0}, Field::r_x)).setZero();
    CHECK(assembly.largest_turn(q) <= 1e-8);  // of no length, no angle

    Scene braced = make_scene();  // a bar has no slopes, whatever its nodes carry
    braced.connect<Bar>(0, {0}, {2});
    const ancf::Assembly of_braced(braced, Storage::full);
    for (int node = 0; node < 3; ++node)
        q.segment<3>(braced.coordinate({node}, Field::r_x)) << std::cos(0.7 * node),
            std::sin(0.7 * node), 0.0;
    CHECK(of_braced.largest_turn(q) == Approx(0.7));
    CHECK_THROWS_AS(assembly.largest_turn(VectorX::Zero(3)), ancf::InvalidArgument);
    CHECK_THROWS_AS(assembly.softened(VectorX::Zero(3)), ancf::InvalidArgument);
}

TEST_CASE("Assembly: scenes that cannot be assembled are refused", "[assembly][bad-input]") {
    Scene scene = make_scene();
    const VectorX q = scene.state().q;
    const VectorX v = VectorX::Zero(q.size());
    SECTION("a load on a vector that the node does not carry") {
        scene.add(ancf::FollowerForce({3}, {1, 0, 0}));
        CHECK_THROWS_AS(ancf::Assembly(scene, Storage::full), ancf::InvalidArgument);
    }
    SECTION("a support on a vector that the node does not carry") {
        scene.fix({3}, Field::r_x);
        CHECK_THROWS_AS(ancf::Assembly(scene, Storage::full), ancf::InvalidArgument);
    }
    SECTION("an unsymmetric load in lower storage") {
        scene.add(ancf::Moment({1}, {1, 0, 0}));
        CHECK_THROWS_AS(ancf::Assembly(scene, Storage::lower), ancf::InvalidArgument);
        CHECK_NOTHROW(ancf::Assembly(scene, Storage::full));
    }
    SECTION("a constraint in lower storage") {
        scene.add(Sphere{{1}});
        CHECK_THROWS_AS(ancf::Assembly(scene, Storage::lower), ancf::InvalidArgument);
    }
    SECTION("vectors of a wrong size") {
        ancf::Assembly assembly(scene, Storage::full);
        const VectorX wrong = VectorX::Zero(q.size() + 1);
        CHECK_THROWS_AS(assembly.evaluate({wrong, v, VectorX(), {}}, ancf::Request::force),
                        ancf::InvalidArgument);
        CHECK_THROWS_AS(assembly.evaluate({q, v, v, {}}, ancf::Request::force),
                        ancf::InvalidArgument);
        CHECK_THROWS_AS(assembly.mass_product(wrong), ancf::InvalidArgument);
        CHECK_THROWS_AS(ancf::resultant(scene, q, wrong), ancf::InvalidArgument);
    }
}

TEST_CASE("Assembly: an empty model has an empty system", "[assembly]") {
    const Scene scene;
    ancf::Assembly assembly(scene, Storage::lower);
    CHECK(assembly.numbering().unknowns() == 0);
    const VectorX none;
    CHECK_FALSE(assembly.evaluate({none, none, none, {}}, ancf::Request::tangent));
    CHECK(assembly.strain_energy() == 0.0);
}

}  // namespace assembly_test
