// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Attached nodes: their system against the transformed system of the same scene without
/// attachments, rigid arms, hinges, loads and constraints on attached nodes, and what is refused.

#include <ancf/assembly/assembly.hpp>
#include <ancf/constants.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/element/joint/affine_joint.hpp>
#include <ancf/element/planar/beam.hpp>
#include <ancf/element/torsion/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/output/state_file.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/path.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>
#include <support/dense.hpp>
#include <support/random_state.hpp>

#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace attachment_test {

using namespace ancf;
using Spatial = CrossSectionBeam<3>;
using Planar = CrossSectionBeam<2>;
using P2 = Vector<double, 2>;
using P3 = Vector<double, 3>;

Material steel() { return Material::isotropic(2e11, 0.3, 7800.0); }
Section square() { return rectangle(0.02, 0.02); }

/// Three beams of different elements between joints, a rigid arm, a chain of attachments, loads and
/// a constraint on attached nodes.
struct Scene3 {
    Model model;
    NodeId joint, arm, top;
    Beam<Spatial> leg, branch;
    Beam<TorsionBeam> strut;

    explicit Scene3(bool attached) {
        leg = straight_beam<Spatial>(model, steel(), square(), {0, 0, 0}, {1, 0, 0}, 2);
        branch = straight_beam<Spatial>(model, steel(), square(), {1.05, 0.02, 0.01},
                                        {1.6, 0.7, 0.3}, 2);
        strut = straight_beam<TorsionBeam>(model, steel(), square(), {1, 0, 0.1}, {1, 0, 0.9}, 1);
        joint = model.add_node({1, 0, 0}, test::rotation(P3(0.3, -0.2, 0.5)));
        arm = model.add_node({1, 0, 0.1});
        const int body = model.add_prototype(AffineJoint<3>(steel(), 8e-4, 0.02));
        model.connect<AffineJoint<3>>(body, joint, joint);
        model.connect<AffineJoint<3>>(body, arm, arm);
        model.add_mass(branch.first(), 0.3);
        model.set_gravity({0, 0, -9.81});
        model.add(Moment(branch.first(), {3.0, 1.0, 2.0}));
        model.add(FollowerForce(branch.first(), {0.0, 40.0, 0.0}));
        model.add(Force<3>(strut.first(), {5.0, 0.0, 0.0}));
        model.add(Distance<3>(branch.first(), P3(1.0, 1.0, 1.0), 1.5));
        model.clamp(leg.first());
        if (!attached) return;
        model.attach(leg.last(), joint);
        model.attach(branch.first(), joint);
        model.attach(strut.first(), arm);
        model.attach(arm, joint, Field::r | Field::r_x | Field::r_y | Fields(Field::r_z));
    }
};

/// d(all coordinates)/d(unknowns) of a scene with attachments.
MatrixX transfer_of(const Assembly& assembly) {
    const Numbering& numbering = assembly.numbering();
    MatrixX transfer = MatrixX::Zero(numbering.coordinates(), numbering.free_coordinates());
    for (int k = 0; k < numbering.free_coordinates(); ++k) {
        VectorX unit = VectorX::Unit(numbering.free_coordinates(), k);
        VectorX moved = VectorX::Zero(numbering.coordinates());
        numbering.add_free(unit, 1.0, moved);
        transfer.col(k) = moved;
    }
    return transfer;
}

/// A state near the reference that keeps the attachments.
VectorX near(const Model& model, test::Random& random) {
    VectorX q = model.state().q;
    for (double& entry : q) entry += 1e-2 * random.uniform(-1.0, 1.0);
    model.dependence().complete(q);
    return q;
}

TEST_CASE("attachments: the system is the transformed one of the scene without them",
          "[model][attachment]") {
    Scene3 bound(true), loose(false);
    // coordinates stand alike: attaching adds no vector that the joints do not carry
    loose.model.add(GeneralisedForce({{loose.joint, Field::r_x}}, VectorX::Zero(3)));
    Assembly small(bound.model, Storage::full);
    REQUIRE(small.numbering().free_coordinates() > 0);
    test::Random random(21);
    const VectorX q = near(bound.model, random);
    VectorX v = VectorX::Zero(q.size());
    for (double& entry : v) entry = random.uniform(-1.0, 1.0);
    for (const int held : small.numbering().held()) v[held] = 0.0;
    bound.model.dependence().complete(v);
    const VectorX lambda = VectorX::Constant(1, 25.0);

    // the loose scene's joints have no position of their own: give each vector its place by name
    const Layout &with = bound.model.layout(), &without = loose.model.layout();
    VectorX q_loose = VectorX::Zero(without.size());
    std::vector<int> place(static_cast<std::size_t>(without.size()));
    for (int k = 0; k < without.size(); ++k) {
        const int node = without.node_of(k);
        const int first = with.index({{node}, without.field_of(k)});
        REQUIRE(first >= 0);
        place[static_cast<std::size_t>(k)] =
            first + k - without.index({{node}, without.field_of(k)});
        q_loose[k] = q[place[static_cast<std::size_t>(k)]];
    }
    Assembly large(loose.model, Storage::full);
    const VectorX rest = VectorX::Zero(q_loose.size());
    REQUIRE_FALSE(
        small.evaluate({q, VectorX::Zero(q.size()), lambda, {1.0, 1.0}}, Request::tangent));
    REQUIRE_FALSE(large.evaluate({q_loose, rest, lambda, {1.0, 1.0}}, Request::tangent));
    CHECK(small.strain_energy() == Approx(large.strain_energy()).epsilon(1e-13));
    CHECK(small.load_potential() == Approx(large.load_potential()).epsilon(1e-12));

    const MatrixX T = transfer_of(small);
    const int free = small.numbering().free_coordinates(), all = without.size();
    MatrixX K = MatrixX::Zero(with.size(), with.size()), M = K;
    VectorX force = VectorX::Zero(with.size()), row = force;
    const SparseMatrix tangent = large.tangent(), mass = large.mass();
    const auto entry = [&](const SparseMatrix& matrix, int i, int j) {
        const int a = large.numbering().equation(i), b = large.numbering().equation(j);
        return a < 0 || b < 0 ? 0.0 : matrix.coeff(a, b);
    };
    for (int i = 0; i < all; ++i) {
        const int to = place[static_cast<std::size_t>(i)];
        force[to] =
            large.internal_force()[i] + large.constraint_force()[i] - large.external_force()[i];
        const int equation = large.numbering().equation(i);
        if (equation >= 0) row[to] = tangent.coeff(large.numbering().free_coordinates(), equation);
        for (int j = 0; j < all; ++j) {
            K(to, place[static_cast<std::size_t>(j)]) = entry(tangent, i, j);
            M(to, place[static_cast<std::size_t>(j)]) = entry(mass, i, j);
        }
    }
    const MatrixX T_t = T.transpose();
    const MatrixX K_bound = test::transformed(K, T), M_bound = test::transformed(M, T);
    const MatrixX dense = MatrixX(small.tangent()), dense_mass = MatrixX(small.mass());
    const double size = K_bound.cwiseAbs().maxCoeff(), heavy = M_bound.cwiseAbs().maxCoeff();
    CHECK((dense.topLeftCorner(free, free) - K_bound).cwiseAbs().maxCoeff() <= 1e-13 * size);
    CHECK((dense_mass.topLeftCorner(free, free) - M_bound).cwiseAbs().maxCoeff() <= 1e-13 * heavy);
    const VectorX g = test::product(T_t, row);
    CHECK((dense.row(free).head(free).transpose() - g).cwiseAbs().maxCoeff() <=
          1e-13 * g.cwiseAbs().maxCoeff());
    CHECK((dense.col(free).head(free) - g).cwiseAbs().maxCoeff() <=
          1e-13 * g.cwiseAbs().maxCoeff());
    VectorX residual;
    small.residual(residual);
    const VectorX carried = test::product(T_t, force);
    CHECK((residual.head(free) - carried).cwiseAbs().maxCoeff() <=
          1e-13 * force.cwiseAbs().maxCoeff());
    // M a of a motion that keeps the attachments
    VectorX unknown, motion;
    small.numbering().gather_free(small.mass_product(v), unknown);
    small.numbering().gather_free(v, motion);
    const VectorX expected = test::product(dense_mass.topLeftCorner(free, free), motion);
    CHECK((unknown - expected).cwiseAbs().maxCoeff() <= 1e-12 * heavy);

    SECTION("lower storage holds the lower half") {
        Model plain;  // without constraint and follower
        const auto built =
            frame<Spatial>(plain, {{steel(), square()}}, {{0, 0, 0}, {1, 0, 0}, {1.2, 0.9, 0.1}},
                           {{0, 1}, {1, 2, 0, 2}});
        plain.clamp(built.joints[0]);
        Assembly lower(plain, Storage::lower), full(plain, Storage::full);
        const VectorX at = near(plain, random), still = VectorX::Zero(at.size()), none;
        REQUIRE_FALSE(lower.evaluate({at, still, none, {}}, Request::tangent));
        REQUIRE_FALSE(full.evaluate({at, still, none, {}}, Request::tangent));
        const MatrixX a = MatrixX(lower.tangent()), b = MatrixX(full.tangent());
        CHECK((a - MatrixX(b.triangularView<Eigen::Lower>())).cwiseAbs().maxCoeff() == 0.0);
        CHECK((b - b.transpose()).cwiseAbs().maxCoeff() <= 1e-13 * b.cwiseAbs().maxCoeff());
    }
}

TEST_CASE("AffineJoint: force and tangent are the derivatives of its energy",
          "[element][attachment]") {
    test::Random random(4);
    const auto check = [&](const auto& joint) {
        using Joint = std::decay_t<decltype(joint)>;
        constexpr int n = Joint::dofs, d = Joint::dimension;
        typename Joint::Coordinates e;
        for (int k = 0; k < n; ++k) e[k] = random.uniform(-1.0, 1.0);
        const auto result = joint.evaluate(e);
        CHECK(result.energy == Approx(joint.energy(e)).epsilon(1e-14));
        // exact but for round-off: the energy is of fourth order in each coordinate
        const auto slope = [&](int k, const auto& of) -> decltype(of(e)) {
            const auto at = [&](double by) {
                auto moved = e;
                moved[k] += by;
                return of(moved);
            };
            return (8.0 * (at(0.5) - at(-0.5)) - (at(1.0) - at(-1.0))) / 6.0;
        };
        for (int k = 0; k < n; ++k) {
            CHECK(slope(k, [&](const auto& x) { return joint.energy(x); }) ==
                  Approx(result.force[k]).margin(1e-12 * result.force.norm()));
            const typename Joint::Coordinates column = slope(
                k, [&](const auto& x) { return typename Joint::Coordinates(joint.force(x)); });
            CHECK((column - result.tangent.col(k)).norm() <= 1e-12 * result.tangent.norm());
        }
        CHECK((result.tangent - result.tangent.transpose()).norm() <=
              1e-14 * result.tangent.norm());
        // turned as a whole it has no energy
        Matrix<double, d> turn = test::random_rotation<d>(random, 3.0);
        for (int k = 0; k < n; ++k) e[k] = turn(k % d, (k / d) % d);
        CHECK(joint.energy(e) <= 1e-28 * result.energy);
        CHECK(joint.force(e).norm() <= 1e-13 * result.force.norm());
        CHECK(joint.gravity(Vector<double, d>::Ones()).norm() == 0.0);
    };
    check(AffineJoint<2>(steel(), 1e-5, 0.02));
    check(AffineJoint<3>(steel(), 1e-5, 0.02));
    check(AffineJoint<3>(Material::isotropic(1e6, 0.5, 1000.0), 1e-5, 0.02));
}

TEST_CASE("attachments: a rigid arm turns and does not stretch", "[model][attachment][statics]") {
    Model model;
    const auto beam =
        frame<Spatial>(model, {{steel(), square()}}, {{0, 0, 0}, {2, 0, 0}}, {{0, 1, 0, 8}});
    const auto tie =
        straight_beam<Spatial>(model, steel(), square(), {2.3, 0.4, 0.2}, {3.0, 0.4, 0.2}, 2);
    model.attach(tie.first(), beam.joints[1]);
    model.clamp(beam.joints[0]);
    model.add(Force<3>(tie.last(), {0, 200.0, -150.0}));
    const P3 arm(0.3, 0.4, 0.2);
    EigenLdlt solver;
    StaticsOptions options;
    options.steps = 4;
    REQUIRE(solve_statics(model, solver, options).status == Status::converged);
    const P3 reach = model.position(tie.first()) - model.position(beam.joints[1]);
    CHECK(reach.norm() == Approx(arm.norm()).epsilon(1e-6));
    CHECK((reach - arm).norm() > 0.05);  // it has turned
    Matrix<double, 3> frame;
    for (int k = 0; k < 3; ++k)
        frame.col(k) = model.value(beam.joints[1], static_cast<Field>(1 + k));
    CHECK((reach - frame * arm).norm() <= 1e-14);
}

TEST_CASE("attachments: beams with and without r_z bend as one by a weld or a joint, not by a node",
          "[model][attachment][statics]") {
    // docs/theory-frames.md: the tip's deflection over that of one beam, half of each element
    enum class By { node, attachment, weld, joint };
    constexpr int y = 1, z = 2;
    const auto deflection = [](By by, int elements, int along) {
        const Section section = rectangle(0.05, 0.05);
        const auto best = CrossSectionOptions::best();
        Model model;
        NodeId root, joint, tip;
        if (by == By::joint) {
            const auto built = frame<Spatial>(model, {{steel(), section}}, {{0, 0, 0}, {0.5, 0, 0}},
                                              {{0, 1, 0, elements}}, {}, best);
            root = built.joints[0];
            joint = built.joints[1];
        } else {
            const auto beam = straight_beam<Spatial>(model, steel(), section, {0, 0, 0},
                                                     {0.5, 0, 0}, elements, best);
            root = beam.first();
            joint = beam.last();
        }
        model.clamp(root);
        if (by == By::node) {
            const double length = 0.5 / elements;
            const int prototype = model.add_prototype(TorsionBeam(steel(), section, length));
            tip = joint;
            for (int k = 1; k <= elements; ++k) {
                const NodeId next = model.add_node({0.5 + k * length, 0, 0});
                model.connect<TorsionBeam>(prototype, tip, next);
                tip = next;
            }
        } else {
            const auto beam = straight_beam<TorsionBeam>(model, steel(), section, {0.5, 0, 0},
                                                         {1, 0, 0}, elements);
            tip = beam.last();
            if (by == By::weld)
                model.add(Weld(model, joint, beam.first()));
            else
                model.attach(beam.first(), joint);
        }
        model.add(Force<3>(tip, P3::Unit(along)));
        EigenLu solver;
        REQUIRE(solve_statics(model, solver).status == Status::converged);
        return model.position(tip)[along] * 3.0 * steel().young * section.moments().zz;
    };
    for (const By by : {By::node, By::attachment}) {
        CHECK(deflection(by, 4, z) == Approx(1.016).margin(1e-3));
        CHECK(deflection(by, 16, z) == Approx(1.057).margin(1e-3));
        CHECK(deflection(by, 64, z) == Approx(1.219).margin(1e-3));
        // both halves share r_y: a third of the excess, measured 0.33
        for (const int elements : {4, 16, 64})
            CHECK(deflection(by, elements, y) - 1.001 ==
                  Approx((deflection(by, elements, z) - 1.001) / 3.0).epsilon(0.05));
    }
    for (const By by : {By::weld, By::joint})
        for (const int elements : {4, 16, 64})
            CHECK(deflection(by, elements, z) == Approx(1.001).margin(1e-3));
}

TEST_CASE("attachments: a force on an arm is a force and a moment on its joint",
          "[model][attachment][statics]") {
    const auto deflected = [](bool by_arm) {
        Model model;
        const auto beam =
            frame<Spatial>(model, {{steel(), square()}}, {{0, 0, 0}, {1, 0, 0}}, {{0, 1, 0, 4}});
        model.clamp(beam.joints[0]);
        const P3 force(0.0, 0.0, 1e-3), arm(0.0, 0.5, 0.0);
        if (by_arm) {
            const auto stub =
                straight_beam<Spatial>(model, steel(), square(), {1, 0.5, 0}, {1, 0.6, 0}, 1);
            model.attach(stub.first(), beam.joints[1]);
            model.add(Force<3>(stub.first(), force));
        } else {
            model.add(Force<3>(beam.joints[1], force));
            model.add(Moment(beam.joints[1], cross(arm, force)));
        }
        EigenLu solver;
        REQUIRE(solve_statics(model, solver).status == Status::converged);
        return VectorX(model.value(beam.joints[1], Field::r_z));
    };
    const VectorX a = deflected(true), b = deflected(false);
    const VectorX turn = a - VectorX(P3(0, 0, 1));
    CHECK(turn.norm() > 1e-7);
    // the joint's own compliance, k = 100, sees the two unlike: 2.8e-5 of the turn
    CHECK((a - b).norm() <= 1e-4 * turn.norm());
}

TEST_CASE("attachments: reactions of a held joint balance the loads",
          "[model][attachment][statics]") {
    Model model;
    const auto built =
        frame<Spatial>(model, {{steel(), square()}}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                       {{0, 1, 0, 3}, {1, 2, 0, 3}});
    model.clamp(built.joints[0]);
    model.add(Force<3>(built.joints[2], {10.0, -20.0, 30.0}));
    EigenLdlt solver;
    const StaticsReport report = solve_statics(model, solver);
    REQUIRE(report.status == Status::converged);
    const int at = model.coordinate(built.joints[0], Field::r);
    CHECK((report.reactions.segment<3>(at) + P3(10.0, -20.0, 30.0)).norm() <= 1e-7);
    CHECK(report.imbalance.force.norm() <= 1e-7);
    CHECK(report.imbalance.moment.norm() <= 1e-7);
}

TEST_CASE("attachments: hinges and pins leave free what they name",
          "[model][attachment][statics]") {
    SECTION("a hinge about r_z transmits no moment about it") {
        Model model;
        const auto post =
            frame<Spatial>(model, {{steel(), square()}}, {{0, 0, 0}, {1, 0, 0}}, {{0, 1, 0, 2}});
        const auto arm = straight_beam<Spatial>(model, steel(), square(), {1, 0, 0}, {2, 0, 0}, 2);
        model.attach(arm.first(), post.joints[1], Field::r | Field::r_z);
        model.clamp(post.joints[0]);
        model.prescribe(arm.last(), Field::r, 1, [](double factor) { return 0.5 * factor; });
        EigenLdlt solver;
        StaticsOptions options;
        options.steps = 4;
        const auto report = solve_statics(model, solver, options);
        REQUIRE(report.status == Status::converged);
        CHECK(report.strain_energy <= 1e-9);  // J; a rigid corner would take 200
        const P3 r_y = model.value(arm.first(), Field::r_y);
        CHECK(std::atan2(-r_y[0], r_y[1]) == Approx(std::asin(0.5)).epsilon(1e-9));
        CHECK(model.value(arm.first(), Field::r_z) == model.value(post.joints[1], Field::r_z));
    }
    SECTION("a net is symmetric and definite") {
        Model model;
        using Rope = Cable<3>;
        const Section round = rectangle(0.005, 0.005);
        const auto web = net<Rope>(model, {{Material::isotropic(1e9, 0.3, 1000.0), round}},
                                   {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -0.2}},
                                   {{0, 4, 0, 4}, {1, 4, 0, 4}, {2, 4, 0, 4}, {3, 4, 0, 4}});
        for (int k = 0; k < 4; ++k) model.pin(web.joints[static_cast<std::size_t>(k)]);
        model.add(Force<3>(web.joints[4], {0, 0, -100.0}));
        model.set_gravity({0, 0, -9.81});
        EigenLdlt solver;
        const auto report = solve_statics(model, solver);
        REQUIRE(report.status == Status::converged);
        CHECK(report.stability == Stability::stable);
        CHECK(model.layout().fields(web.joints[4].index) == Fields(Field::r));
        const double weight = 9.81 * 1000.0 * 0.005 * 0.005 * 4.0 * std::hypot(1.0, 0.2);  // N
        for (int k = 0; k < 4; ++k) {
            const NodeId border = web.joints[static_cast<std::size_t>(k)];
            const P3 held = report.reactions.segment<3>(model.coordinate(border, Field::r));
            CHECK(held[2] == Approx(0.25 * (100.0 + weight)).epsilon(1e-9));
            // along X or Y, towards the outside
            const P3 outside = model.position(border);
            CHECK(held.dot(outside) > 100.0);
            CHECK(cross(held, outside)[2] == Approx(0.0).margin(1e-9 * held.norm()));
        }
    }
    SECTION("a pin of cables with round-off between their ends is a pin") {
        Model model;
        double sum = 0.0;
        for (int k = 0; k < 110; ++k) sum += 0.1;
        REQUIRE(sum != 11.0);
        const auto left =
            straight_beam<Cable<3>>(model, steel(), square(), {0, 0, 0}, {11, 0, 0}, 1);
        const auto right =
            straight_beam<Cable<3>>(model, steel(), square(), {sum, 0, 0}, {22, 0, 0}, 1);
        const NodeId joint = model.add_node({11, 0, 0});
        model.attach(left.last(), joint);
        model.attach(right.first(), joint);
        CHECK(model.layout().fields(joint.index) == Fields(Field::r));
        CHECK(model.position(right.first())[0] == 11.0);
    }
}

TEST_CASE("attachments: what is set at a joint is set at all that follows it, and there alone",
          "[model][attachment]") {
    Model model;
    const auto built = frame<Spatial>(model, {{steel(), square()}},
                                      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1}, {1, 2}});
    const auto arm = straight_beam<Spatial>(model, steel(), square(), {1, 0, 0.5}, {1, 0, 2}, 1);
    model.attach(arm.first(), built.members[0].last());  // and so to the joint, with an offset
    const NodeId joint = built.joints[1];
    for (VectorX* const whole : {&model.state().q, &model.state().v}) {
        const VectorX before = *whole;
        for (const Field field : {Field::r, Field::r_z})
            if (whole == &model.state().q)
                model.set_value(joint, field, {0.1, 0.2, 0.8});
            else
                model.set_rate(joint, field, {0.1, 0.2, 0.8});
        VectorX expected = *whole;
        model.dependence().complete(expected);
        CHECK(*whole == expected);
        for (const NodeId moved : {built.members[0].last(), built.members[1].first(), arm.first()})
            CHECK(whole->segment<3>(model.coordinate(moved, Field::r)) !=
                  before.segment<3>(model.coordinate(moved, Field::r)));
        for (const NodeId kept : {built.members[0].first(), built.members[1].last(), arm.last()})
            CHECK(whole->segment<3>(model.coordinate(kept, Field::r)) ==
                  before.segment<3>(model.coordinate(kept, Field::r)));
    }
}

TEST_CASE("frame: members of equal length and profile share a prototype, others do not",
          "[model][attachment]") {
    Model model;
    const auto built =
        frame<Spatial>(model, {{steel(), square()}, {steel(), rectangle(0.01, 0.01)}},
                       {{0, 0, 0}, {1, 0, 0}, {1, 1 + 1e-14, 0}, {1, 1, 1.5}, {1, 2, 1.5}},
                       {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {0, 1, 1}, {0, 1, 0, 2}});
    std::vector<int> prototypes;
    for (const auto& member : built.members) prototypes.push_back(member.prototypes.front());
    CHECK(prototypes == std::vector<int>{0, 0, 1, 0, 2, 3});
}

TEST_CASE("attachments: scales, driven joints, copies and state files", "[model][attachment]") {
    const auto build = [](Model& model, double scale) {
        return frame<Spatial>(model, {{steel(), rectangle(0.02 * scale, 0.02 * scale)}},
                              {{0, 0, 0}, {scale, 0, 0}, {scale, scale, 0}},
                              {{0, 1, 0, 2}, {1, 2, 0, 2}});
    };
    SECTION("a scene of a millionth of the length takes the same iterations") {
        std::vector<int> counts;
        for (const double scale : {1.0, 1e-6}) {
            Model model;
            const auto built = build(model, scale);
            model.clamp(built.joints[0]);
            model.add(Force<3>(built.joints[2], P3(0, 300.0, 500.0) * scale * scale));
            EigenLdlt solver;
            const auto report = solve_statics(model, solver);
            REQUIRE(report.status == Status::converged);
            counts.push_back(report.steps.back().iterations);
        }
        CHECK(std::abs(counts[0] - counts[1]) <= 1);
    }
    SECTION("a driven joint takes its members along; copies and files keep the attachments") {
        Model model;
        const auto built = build(model, 1.0);
        model.clamp(built.joints[0]);
        model.prescribe(built.joints[2], Field::r, 2, [](double factor) { return 0.1 * factor; });
        EigenLdlt solver;
        REQUIRE(solve_statics(model, solver).status == Status::converged);
        CHECK(model.position(built.members[1].last())[2] == Approx(0.1).epsilon(1e-14));
        Model copy(model);
        CHECK(copy.attachments().size() == model.attachments().size());
        REQUIRE(solve_statics(copy, solver).status == Status::converged);
        CHECK((copy.state().q - model.state().q).norm() <= 1e-9);
        std::stringstream file;
        write_state(file, {model.state(), {}});
        Model other;
        build(other, 1.0);
        other.state() = read_state(file).state;
        CHECK(other.state().q == model.state().q);
        copy.set_value(built.joints[2], Field::r, {1, 1, 0.3});
        CHECK(copy.position(built.members[1].last())[2] == 0.3);
    }
}

TEST_CASE("attachments: a path counts a node that follows another one no second time",
          "[model][attachment][path]") {
    const auto path = [](int parts) {
        Model model;
        NodeId tip;
        for (int k = 0; k < parts; ++k) {
            const double from = static_cast<double>(k) / parts, to = from + 1.0 / parts;
            const auto beam = straight_beam<Spatial>(model, steel(), square(), {from, 0, 0},
                                                     {to, 0, 0}, 4 / parts);
            if (k == 0)
                model.clamp(beam.first());
            else  // with its r_x: the same unknowns as an undivided beam
                model.attach(beam.first(), tip,
                             Field::r | Field::r_x | Field::r_y | Fields(Field::r_z));
            tip = beam.last();
        }
        model.add(Force<3>(tip, {0, 2e4, 0}));
        EigenLdlt solver;
        PathOptions options;
        options.critical_points = false;
        options.last_factor = 1.0;
        return follow_path(model, solver, options);
    };
    const PathReport whole = path(1), divided = path(4);
    REQUIRE(whole.status == Status::converged);
    REQUIRE(divided.points.size() == whole.points.size());
    REQUIRE(whole.points.size() > 3);
    for (std::size_t k = 0; k < whole.points.size(); ++k)
        CHECK(divided.points[k].factor ==
              Approx(whole.points[k].factor).epsilon(1e-9).margin(1e-12));
}

TEST_CASE("attachments: what cannot be meant is refused", "[model][attachment][bad-input]") {
    Model model;
    const auto a = straight_beam<Spatial>(model, steel(), square(), {0, 0, 0}, {1, 0, 0}, 1);
    const auto b = straight_beam<Spatial>(model, steel(), square(), {1, 0, 0}, {1, 1, 0}, 1);
    const auto rope = straight_beam<Cable<3>>(model, steel(), square(), {1, 0, 0}, {2, 0, 0}, 1);
    const NodeId joint = model.add_node({1, 0, 0}), bare = model.add_node({3, 0, 0});
    Matrix<double, 3> flat = Matrix<double, 3>::Identity();
    flat.col(2) = flat.col(1);
    const NodeId singular = model.add_node({1, 0, 0}, flat);
    model.fix(b.last(), Field::r, 1);
    const auto message = [](const std::function<void()>& call) -> std::string {
        try {
            call();
        } catch (const InvalidArgument& refused) {
            return refused.what();
        }
        return {};
    };
    const auto says = [&](const char* part, const std::function<void()>& call) {
        const std::string text = message(call);
        INFO(text);
        CHECK(text.find(part) != std::string::npos);
    };
    says("got node 99", [&] { model.attach(a.last(), {99}); });
    says("got node -1", [&] { model.attach({}, joint); });
    says("no vectors yet", [&] { model.attach(bare, joint); });
    says("carries no r_y", [&] { model.attach(rope.first(), joint, Field::r | Field::r_y); });
    says("name at least one vector of node 1 to attach to node 6, got none",
         [&] { model.attach(a.last(), joint, Fields()); });
    says("nodes 1 and 1 would follow each other in a circle",
         [&] { model.attach(a.last(), a.last()); });
    says("r of node 3 is held or driven; hold node 6 instead",
         [&] { model.attach(b.last(), joint); });
    says("the slopes of node 8 are not independent", [&] { model.attach(a.last(), singular); });
    model.attach(a.last(), joint);
    says("is attached to node 6", [&] { model.attach(a.last(), bare); });
    says("nodes 6 and 1 would follow each other in a circle",
         [&] { model.attach(joint, a.last(), Field::r); });
    {
        Model three;  // each follows the next
        const auto x = straight_beam<Spatial>(three, steel(), square(), {0, 0, 0}, {1, 0, 0}, 1);
        const auto y = straight_beam<Spatial>(three, steel(), square(), {1, 0, 0}, {2, 0, 0}, 1);
        three.attach(x.first(), x.last(), Field::r);
        three.attach(x.last(), y.first(), Field::r);
        says("nodes 2 and 0 would follow each other in a circle",
             [&] { three.attach(y.first(), x.first(), Field::r); });
    }
    says("is attached to node 6", [&] { model.fix(a.last(), Field::r_y); });
    says("is attached to node 6", [&] { model.prescribe(a.last(), Field::r, 0, {}); });
    says("is attached to node 6", [&] { model.set_value(a.last(), Field::r, {1, 0, 0}); });
    says("is attached to node 6", [&] { model.set_rate(a.last(), Field::r_z, {1, 0, 0}); });
    says("is attached to node 6", [&] { model.release(a.last(), Field::r); });
    says("attached to another node", [&] {
        EigenLdlt solver;
        PathOptions options;
        options.control = PathControl::displacement;
        options.at = {a.last(), Field::r};
        static_cast<void>(follow_path(model, solver, options));
    });
    says("expected r or slopes, got r_xx",
         [&] { model.attach(b.first(), joint, Fields(Field::r_xx)); });
    says("two nodes", [&] { model.connect<Spatial>(0, joint, joint); });
    const int body = model.add_prototype(AffineJoint<3>(steel(), 1e-4, 0.02));
    says("one node", [&] { model.connect<AffineJoint<3>>(body, joint, bare); });
    says("volume", [] { AffineJoint<3>(steel(), 0.0, 0.02); });
    says("size", [] { AffineJoint<3>(steel(), 1e-4, -1.0); });
}

}  // namespace attachment_test
