// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Results of frames: modes against those of a welded frame, section forces at attached ends, the
/// deformed shape; and the last of what is refused.

#include <ancf/assembly/assembly.hpp>
#include <ancf/element/cable/cable.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/output/shape.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/eigen_solver.hpp>
#include <ancf/solver/modal.hpp>
#include <ancf/solver/statics.hpp>

#include <support/catch.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace attached_results_test {

using namespace ancf;
using Element = CrossSectionBeam<3>;
using P3 = Vector<double, 3>;

const Material steel = Material::isotropic(2e11, 0.3, 7800.0);

Section bar() { return rectangle(0.02, 0.03); }

Frame<Element> corner(Model& model, int elements) {
    return frame<Element>(model, {{steel, bar()}}, {{0, 0, 0}, {1, 0, 0}, {1, 0.8, 0}},
                          {{0, 1, 0, elements}, {1, 2, 0, elements}}, {},
                          CrossSectionOptions::best());
}

TEST_CASE("attachments: modes are those of a welded frame, and attached ends take part",
          "[model][attachment][modal]") {
    ModalOptions six;
    six.count = 6;
    Model attached, welded;
    const auto built = corner(attached, 8);
    attached.clamp(built.joints[0]);
    EigenLdlt definite;
    const ModalReport ours = natural_modes(attached, definite, six);
    const auto best = CrossSectionOptions::best();
    const auto first = straight_beam<Element>(welded, steel, bar(), {0, 0, 0}, {1, 0, 0}, 8, best);
    const auto second =
        straight_beam<Element>(welded, steel, bar(), {1, 0, 0}, {1, 0.8, 0}, 8, best);
    welded.add(Weld(welded, first.last(), second.first()));
    welded.clamp(first.first(), Clamp::free_slope);
    EigenLu general;
    const ModalReport theirs = natural_modes(welded, general, six);
    REQUIRE(ours.status == Status::converged);
    REQUIRE(theirs.status == Status::converged);
    REQUIRE(ours.modes.size() == 6);
    for (std::size_t k = 0; k < 6; ++k) {
        INFO("mode " << k);  // 1.9e-4 apart: the joint has a mass and a compliance
        CHECK(ours.modes[k].frequency() == Approx(theirs.modes[k].frequency()).epsilon(3e-4));
        const VectorX& shape = ours.modes[k].shape;
        VectorX whole = shape;
        attached.dependence().complete(whole);
        CHECK(whole == shape);
        CHECK(shape.segment<3>(attached.coordinate(built.members[1].last(), Field::r)).norm() >
              1e-3 * shape.norm());
    }
}

TEST_CASE("attachments: section forces at an attached end are what passes through the joint",
          "[model][attachment][statics]") {
    Model model;
    const auto built = corner(model, 8);
    model.clamp(built.joints[0]);
    const P3 force(0.003, -0.007, 0.01), arm(0.0, 0.8, 0.0);
    model.add(Force<3>(built.joints[2], force));
    EigenLdlt solver;
    REQUIRE(solve_statics(model, solver).status == Status::converged);
    const auto at = [&](int member, bool end) {
        const auto& elements = built.members[static_cast<std::size_t>(member)].elements;
        const int element = end ? elements.back() : elements.front();
        return model.group<Element>().element(element).section_forces(
            model.element_coordinates<Element>(element), end ? 1.0 : 0.0);
    };
    const P3 moment = cross(arm, force);
    const SectionForces before = at(0, true), after = at(1, false);
    for (const SectionForces& one : {before, after}) {
        const P3 found(one.axial, one.shear_y, one.shear_z);
        const P3 turning(one.torque, one.moment_y, one.moment_z);
        CHECK(found.norm() == Approx(force.norm()).epsilon(1e-3));
        CHECK(turning.norm() == Approx(moment.norm()).epsilon(1e-3));
    }
    CHECK(before.axial == Approx(force[0]).epsilon(1e-3));
    CHECK(after.axial == Approx(force[1]).epsilon(1e-3));
    // bending of the one is torsion of the other
    CHECK(std::abs(before.torque) == Approx(std::abs(moment[0])).epsilon(1e-3));
    CHECK(std::abs(after.torque) <= 1e-3 * moment.norm());
}

TEST_CASE("attachments: the deformed shape of members meets at the joint",
          "[model][attachment][output]") {
    Model model;
    const auto built = corner(model, 2);
    const P3 knee(1.1, 0.2, -0.3);
    model.set_value(built.joints[1], Field::r, knee);
    const auto first = deformed_shape(model, built.members[0], bar(), 3);
    const auto second = deformed_shape(model, built.members[1], bar(), 3);
    CHECK((first.back().centre - knee).norm() <= 1e-14);
    CHECK((second.front().centre - knee).norm() <= 1e-14);
}

TEST_CASE("attachments: options, parts and numbers of vectors that cannot be meant are refused",
          "[model][attachment][bad-input]") {
    constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Profile> profiles = {{steel, rectangle(0.02, 0.02)}};
    const std::vector<P3> points = {{0, 0, 0}, {1, 0, 0}};
    Model model;
    FrameOptions<3> options;
    options.y_axis = {0.0, no_number, 0.0};
    CHECK_THROWS_WITH(frame<Element>(model, profiles, points, {{0, 1}}, options),
                      ContainsSubstring("y_axis must be finite"));
    for (const double strain : {-1.0, no_number})
        CHECK_THROWS_WITH(net<Cable<3>>(model, profiles, points, {{0, 1}}, NetOptions{strain}),
                          ContainsSubstring("strain must be finite and above -1"));
    CHECK(model.nodes() == 0);

    const auto built = frame<Element>(model, profiles, points, {{0, 1}});
    ScenePart part;
    for (const auto& group : model.groups()) part.elements.emplace_back(group->size() > 1 ? 0 : 1);
    part.nodes.assign(static_cast<std::size_t>(model.nodes()), 1);
    part.nodes[static_cast<std::size_t>(built.joints[1].index)] = 0;
    CHECK_THROWS_WITH(model.part(part, nullptr), ContainsSubstring("which is no part"));

    // an end follows one node, but each node on the way may leave its slopes free: 13 are followed
    Model tied;
    const auto beam =
        straight_beam<Element>(tied, steel, rectangle(0.02, 0.02), {0, 0, 0}, {1, 0, 0}, 1);
    const Matrix<double, 3> askew =
        (Matrix<double, 3>() << 0.8, 0.1, 0.2, -0.3, 0.9, 0.1, 0.2, -0.2, 1.1).finished();
    for (const NodeId end : {beam.first(), beam.last()}) {
        NodeId from = tied.add_node({0.3, 0.2, 0.1}, askew);
        tied.attach(end, from);
        CHECK_THROWS_WITH(tied.attach(end, tied.add_node({0, 0, 1}, askew), Fields(Field::r_x)),
                          ContainsSubstring("follows node"));
        for (const P3& point : {P3(0.1, -0.2, 0.3), P3(0.5, 0.4, -0.1), P3(-0.3, 0.2, 0.6)}) {
            const NodeId next = tied.add_node(point, askew);
            tied.attach(from, next, Fields(Field::r));
            from = next;
        }
    }
    CHECK_THROWS_WITH(Assembly(tied, Storage::full), ContainsSubstring("expected at most 16"));
}

}  // namespace attached_results_test
