// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Who has what of a divided scene.

#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/division.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>

#include <support/catch.hpp>

#include <utility>
#include <vector>

namespace division_test {

using namespace ancf;
using Beam = CrossSectionBeam<3>;
using Point = Vector<double, 3>;
using Edges = std::vector<std::pair<int, int>>;

/// A ladder of frame members with a load, a constraint and a mass.
Model ladder() {
    std::vector<Point> points;
    std::vector<Member> members;
    for (int k = 0; k < 6; ++k) {
        points.emplace_back(k, 0, 0);
        points.emplace_back(k, 1, 0);
        members.push_back({2 * k, 2 * k + 1, 0, 2});
        if (k > 0)
            for (const int side : {0, 1}) members.push_back({2 * k - 2 + side, 2 * k + side, 0, 1});
    }
    Model model;
    const auto steel = Material::isotropic(2e11, 0.3, 7800.0);
    const auto frame = ancf::frame<Beam>(model, {{steel, rectangle(0.01, 0.01)}}, points, members);
    model.clamp(frame.joints.front());
    model.add(Force<3>(frame.joints[5], Point(0, 30, 0)));
    model.add(Distance<3>({frame.joints[0]}, {frame.joints[9]}, 4.0));
    model.add_mass(frame.joints[11], 2.0);
    return model;
}

/// Three parts of consecutive vertices.
std::vector<int> thirds(int vertices, const Edges&) {
    std::vector<int> parts;
    for (int k = 0; k < vertices; ++k) parts.push_back(3 * k / vertices);
    return parts;
}

TEST_CASE("Division: everything is of one part, which has the nodes that it touches", "[model]") {
    const Model scene = ladder();
    const detail::Division division(scene, thirds);
    const std::size_t groups = scene.groups().size();  // members, and joints with a stiffness
    std::vector<std::vector<int>> elements;
    for (const auto& group : scene.groups())
        elements.emplace_back(static_cast<std::size_t>(group->size()), 0);
    std::vector<int> owned(static_cast<std::size_t>(scene.nodes()), 0);
    std::size_t loads = 0, constraints = 0, masses = 0;
    for (int part = 0; part < 3; ++part) {
        const ScenePart held = division.held(scene, part);
        REQUIRE(held.elements.size() == groups);
        for (std::size_t g = 0; g < groups; ++g)
            for (const int k : held.elements[g]) {
                ++elements[g][static_cast<std::size_t>(k)];
                const Connection& c = scene.groups()[g]->connections[static_cast<std::size_t>(k)];
                CHECK(division.owner(c) == part);
                for (const NodeId node : {c.first, c.second}) {
                    CHECK(held.nodes[static_cast<std::size_t>(node.index)] == 1);
                    CHECK(held.nodes[static_cast<std::size_t>(division.leader(node))] == 1);
                }
            }
        for (int k = 0; k < scene.nodes(); ++k)
            if (division.part[static_cast<std::size_t>(k)] == part) {
                ++owned[static_cast<std::size_t>(k)];
                CHECK(held.nodes[static_cast<std::size_t>(k)] == 1);
            }
        loads += held.loads.size();
        constraints += held.constraints.size();
        masses += held.masses.size();
    }
    for (const auto& group : elements)
        for (const int count : group) CHECK(count == 1);
    for (int k = 0; k < scene.nodes(); ++k)
        CHECK(owned[static_cast<std::size_t>(k)] == (scene.layout().size(k) > 0 ? 1 : 0));
    CHECK(loads == scene.loads().size());
    CHECK(constraints == 1);
    CHECK(masses == 1);
}

TEST_CASE("Division: member ends are merged in the graph, and eliminated where nobody else looks",
          "[model]") {
    const Model scene = ladder();
    Edges edges;
    int vertices = 0;
    const detail::Division division(scene, [&](int count, const Edges& all) {
        vertices = count;
        edges = all;
        return std::vector<int>(static_cast<std::size_t>(count), 0);
    });
    CHECK(vertices == 12 + 6);  // joints, and a node in the middle of each rung
    int elements = 0;
    for (const auto& group : scene.groups()) elements += group->size();
    CHECK(edges.size() == static_cast<std::size_t>(elements));
    for (const auto& [a, b] : edges) CHECK((a >= 0 && a < vertices && b >= 0 && b < vertices));
    int eliminated = 0;
    for (int k = 0; k < scene.nodes(); ++k)
        if (division.eliminated[static_cast<std::size_t>(k)] != 0) {
            ++eliminated;
            CHECK(division.leader({k}) != k);
        }
    CHECK(eliminated == 2 * 6 + 2 * 10);  // an end of each member
}

}  // namespace division_test
