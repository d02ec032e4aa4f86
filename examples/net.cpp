// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A hammock: a net of ropes between two bars, under its weight and a load in its middle.
///
///     |o--o--o--o--o--o--o|
///     |o--o--o--o--o--o--o|   bars at x = 0 and x = length, knots between them
///     |o--o--o--o--o--o--o|
///
/// The knots join the ropes by pins, without multipliers. The ropes are drawn a little short: a net
/// without stress has no stiffness across. The default run checks that the bars
/// carry weight and load, and that equal ropes across the middle hold alike.

#include <ancf/element/cable/cable.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/output/surface.hpp>
#include <ancf/output/vtk.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/solver/statics.hpp>

#include <support/command_line.hpp>
#include <support/files.hpp>
#include <support/report.hpp>
#include <support/solver.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

using Rope = ancf::Cable<3>;
using Point = ancf::Vector<double, 3>;

constexpr double length = 2.0, width = 1.0, sag = 0.4, side = 0.006;  // m
constexpr double density = 1100.0, young = 5e8, gravity = 9.81;
constexpr double strain = 1e-3;     // of the ropes as they are drawn
constexpr double tolerance = 1e-6;  // of the load carried

struct Net {
    int along = 9, across = 5, elements = 2;
    double load = 800.0;  // N
    bool csv = false;
    std::string vtk;
    examples::SolverOptions solver;

    void parse(int argc, char** argv);
    [[nodiscard]] int place(int i, int j) const { return i + along * j; }
};

void Net::parse(int argc, char** argv) {
    examples::CommandLine line("A hammock of ropes under its weight and a load in its middle.");
    line.set_group("Net");
    line.add_count("--along", along, 3, 1000, "knots from bar to bar");
    line.add_count("--across", across, 2, 1000, "knots along a bar");
    line.add_count("--elements", elements, 1, 1000, "of each rope between two knots");
    line.add_number("--load", load, examples::Range::finite, "over the middle knots, N");
    solver.statics.steps = 10;
    solver.statics.adaptive = true;
    solver.add_to(line);
    line.set_group("Output");
    line.add_flag("--csv", csv, "comma-separated values on stdout instead of a table");
    line.add_file("--vtk", vtk, "the loaded net for ParaView: .vtp, .vtu or .vtk");
    line.parse(argc, argv);
    if (!vtk.empty()) {
        static_cast<void>(ancf::vtk_format(vtk));
        examples::require_writable(vtk);
    }
}

bool study(const Net& net) {
    std::vector<Point> points;
    std::vector<ancf::Member> members;
    for (int j = 0; j < net.across; ++j)
        for (int i = 0; i < net.along; ++i) {
            const double x = static_cast<double>(i) / (net.along - 1);
            const double y = static_cast<double>(j) / (net.across - 1) - 0.5;
            points.emplace_back(length * x, width * y, -4.0 * sag * x * (1.0 - x));
            if (i > 0) members.push_back({net.place(i - 1, j), net.place(i, j), 0, net.elements});
            if (j > 0 && i > 0 && i + 1 < net.along)
                members.push_back({net.place(i, j - 1), net.place(i, j), 0, net.elements});
        }
    const auto section = ancf::rectangle(side, side);
    ancf::Model model;
    ancf::NetOptions taut;
    taut.strain = strain;
    const auto web = ancf::net<Rope>(
        model, {{ancf::Material::isotropic(young, 0.3, density), section}}, points, members, taut);
    model.set_gravity({0, 0, -gravity});
    const int middle = (net.along - 1) / 2;
    for (int j = 0; j < net.across; ++j) {
        for (const int i : {0, net.along - 1})
            model.pin(web.joints[static_cast<std::size_t>(net.place(i, j))]);
        model.add(ancf::Force<3>(web.joints[static_cast<std::size_t>(net.place(middle, j))],
                                 Point(0, 0, -net.load / net.across)));
    }
    const ancf::StaticsReport report = examples::solve(model, net.solver);

    double carried = 0.0, lowest = 0.0, uneven = 0.0;
    for (int j = 0; j < net.across; ++j)
        for (const int i : {0, net.along - 1}) {
            const ancf::NodeId knot = web.joints[static_cast<std::size_t>(net.place(i, j))];
            carried += model.value(knot, ancf::Field::r, report.reactions)[2];
        }
    for (const ancf::NodeId knot : web.joints) lowest = std::min(lowest, model.position(knot)[2]);
    for (int i = 0; i < net.along; ++i) {
        const auto height = [&](int j) {
            return model.position(web.joints[static_cast<std::size_t>(net.place(i, j))])[2];
        };
        uneven = std::max(uneven, std::abs(height(0) - height(net.across - 1)));
    }
    double rope = 0.0;  // m
    for (const ancf::Member& member : members)
        rope += (points[static_cast<std::size_t>(member.second)] -
                 points[static_cast<std::size_t>(member.first)])
                    .norm();
    const double expected = net.load + rope / (1.0 + strain) * side * side * density * gravity;
    const double deviation = carried / expected - 1.0;

    const std::string status(to_string(report.status));
    examples::Verdict verdict;
    verdict.add(net.elements, report);
    examples::Sheet sheet(net.csv,
                          {"knots", "ropes", "unknowns", "steps", "iterations", "status", "lowest",
                           "carried", "expected"},
                          {"knots", "ropes", "unknowns", "steps", "iterations", "status",
                           "lowest (m)", "carried (N)", "deviation"});
    const int unknowns = examples::free_coordinates(model);
    const int steps = examples::steps(net.solver, report);
    sheet.add_csv(points.size(), members.size(), unknowns, steps, report.iterations(), status,
                  lowest, carried, expected);
    sheet.add_table({std::to_string(points.size()), std::to_string(members.size()),
                     std::to_string(unknowns), std::to_string(steps),
                     std::to_string(report.iterations()), status, examples::fixed(lowest, 4),
                     examples::fixed(carried, 2), examples::scientific(deviation)});
    sheet.finish("Hammock of ropes");
    if (!net.vtk.empty()) {
        ancf::Surface surface;
        for (const auto& part : web.members) surface.add(model, part, section, 5);
        ancf::write_vtk(net.vtk, surface);
    }
    return verdict.good() && std::abs(deviation) <= tolerance && uneven <= 1e-6;
}

}  // namespace

int main(int argc, char** argv) {
    return examples::run([&] {
        Net net;
        net.parse(argc, argv);
        return study(net) ? examples::exit_done : examples::exit_missed;
    });
}
