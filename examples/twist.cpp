// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A cantilever twisted by half a turn: [Dufva2006, section 5.3, Fig. 9].
///
///      /|                                   __
///      /|==================================|  | ) T = 20.605 N m about X, one load step
///      /|                                   --
///
/// L 0.254, width 0.00254 along Z, height 0.00635 along Y, five elements. Half of the torque acts
/// on r_y, half on r_z, at the tip; r_y turns by 179.9 degrees. The paper needs 33 Newton
/// iterations with the transverse strain of Eq. 24 (green) and 9 with that of Eq. 25 (stretch).

#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/statics.hpp>
#include <ancf/types.hpp>

#include <support/angle.hpp>
#include <support/beam.hpp>
#include <support/command_line.hpp>
#include <support/files.hpp>
#include <support/named_beam.hpp>
#include <support/report.hpp>
#include <support/solver.hpp>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using Point = ancf::Vector<double, 3>;

constexpr examples::Geometry paper = {0.254, 0.00254, 0.00635, 8.27371e10, 3.17159e10};
constexpr double paper_torque = 20.605;  // N m
constexpr examples::Published half_turn = {"cross-section", 5, 179.9, 179.9};
constexpr double tolerance = 0.1;  // degrees

struct Twist {
    double torque = paper_torque;
    std::vector<int> elements = {5};
    examples::BeamOptions beam;
    examples::SolverOptions solver;
    examples::OutputOptions output;

    void parse(int argc, char** argv);
    [[nodiscard]] std::string title() const;

    /// Returns whether this mesh is the paper's problem; Eqs. 24 and 25 give the same angle.
    [[nodiscard]] bool is_published(int mesh) const;
};

void Twist::parse(int argc, char** argv) {
    examples::CommandLine line("A cantilever twisted by half a turn (section 5.3, Fig. 9).");
    beam.geometry = paper;
    line.set_group("Beam");
    line.add_number("--torque", torque, examples::Range::finite, "torque at the tip about X, N m");
    beam.add_geometry_to(line);
    beam.add_clamp_to(line);
    beam.add_element_to(line, examples::spatial_beams);
    line.add_counts("--elements", elements, 1, examples::most_elements, "meshes");
    solver.add_to(line);
    output.add_to(line);
    line.parse(argc, argv);
    beam.settle(line);
    output.check();
    examples::check(beam);
}

std::string Twist::title() const {
    std::ostringstream text;
    text << "Twist, " << beam.description() << ", torque " << torque << " N m";
    return text.str();
}

bool Twist::is_published(int mesh) const {
    examples::BeamOptions either = beam;
    either.transverse = "green";
    return mesh == half_turn.elements && beam.element == half_turn.element && either.as_paper() &&
           beam.geometry.values() == paper.values() && torque == paper_torque;
}

struct Result {
    ancf::StaticsReport report;
    double angle;  // of r_y at the tip about X, degrees
    double x;      // of the tip, m
};

Result solve(const Twist& problem, int elements) {
    ancf::Model model;
    const auto beam = examples::straight_beam(model, problem.beam, elements);
    model.clamp(beam.first(), problem.beam.clamped());
    for (const ancf::Field slope : {ancf::Field::r_y, ancf::Field::r_z})
        model.add(ancf::SlopeMoment(beam.last(), slope, Point::UnitX(), problem.torque / 2.0));
    auto report = examples::solve(model, problem.solver);
    if (elements == problem.elements.back())
        problem.output.write(model, beam, problem.beam.section());
    return {std::move(report), examples::twist_angle(model, beam), model.position(beam.last())[0]};
}

/// Solves every mesh and prints a row for each; returns whether all is as published.
bool study(const Twist& problem) {
    using examples::fixed;
    const examples::BeamOptions& beam = problem.beam;
    examples::Verdict verdict;
    examples::Sheet sheet(
        problem.output.csv,
        {"element", "transverse", "elements", "steps", "iterations", "status", "angle_deg", "x"},
        {"elements", "iterations", "status", "angle (deg)", "x", "published angle", "deviation",
         "published iterations"});
    for (const int mesh : problem.elements) {
        const auto [report, angle, x] = solve(problem, mesh);
        verdict.add(mesh, report);
        const std::string status(to_string(report.status));
        sheet.add_csv(beam.element, beam.transverse, mesh, steps(problem.solver, report),
                      report.iterations(), status, angle, x);
        std::vector<std::string> row = {std::to_string(mesh), std::to_string(report.iterations()),
                                        status, fixed(angle, 4), fixed(x, 7)};
        if (problem.is_published(mesh)) {
            const double deviation = verdict.deviation(half_turn, angle, angle, tolerance);
            row.insert(row.end(), {fixed(half_turn.first, 1), examples::scientific(deviation),
                                   beam.transverse == "green" ? "33" : "9"});
        }
        sheet.add_table(std::move(row));
    }
    sheet.finish(problem.title());
    return verdict.good();
}

}  // namespace

int main(int argc, char** argv) {
    return examples::run([&] {
        Twist problem;
        problem.parse(argc, argv);
        return study(problem) ? examples::exit_done : examples::exit_missed;
    });
}
