// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A cantilever bent to a semicircle by a moment at its tip: [Dufva2006, section 5.2.2, Fig. 8].
///
///        .------.
///       (        )              M = pi E I/l on the tip   Y
///       |        |                                        |
///     tip       ///  clamp at the origin                  +-- X, the beam before
///
/// In the thin limit the tip comes to (0, 2 l/pi). This section is thick (0.035 l), and the Green
/// strain of the element moves its own limit to (-0.003648, 0.633306); 32 elements reach it.

#include <ancf/constants.hpp>
#include <ancf/error.hpp>
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

using ancf::pi;
using examples::Published;
using Point = ancf::Vector<double, 3>;

constexpr double tolerance = 2e-5;  // m

/// Tip (x, y) with the moment on r_y: the digits that Fig. 8 is drawn from.
constexpr Published figure_8[] = {
    {"cross-section", 3, 0.00045, 0.63695},     {"cross-section", 6, -0.00335, 0.63357},
    {"cross-section", 32, -0.003648, 0.633307}, {"continuum", 3, 0.67914, 0.59826},
    {"continuum", 6, 0.19380, 0.70187},         {"continuum", 16, 0.00155, 0.63643}};

constexpr examples::Geometry paper = {1.0, 0.035, 0.035, 2e8, 1e8};

struct Semicircle {
    double moment_factor = 1.0;
    std::string slope = "r_y";
    std::vector<int> elements = {3, 6, 16, 32};
    examples::BeamOptions beam;
    examples::SolverOptions solver;
    examples::OutputOptions output;

    void parse(int argc, char** argv);
    [[nodiscard]] std::string title() const;

    /// Returns the moment at the tip, N m.
    [[nodiscard]] double moment() const {
        return moment_factor * pi * beam.geometry.bending_stiffness() / beam.geometry.length;
    }

    /// Returns the published tip for a mesh, nullptr where this is not the paper's problem.
    [[nodiscard]] const Published* published(int mesh) const;
};

void Semicircle::parse(int argc, char** argv) {
    examples::CommandLine line(
        "A cantilever bent to a semicircle by a moment at its tip (Fig. 8).");
    beam.geometry = paper;
    line.set_group("Beam");
    line.add_number("--moment-factor", moment_factor, examples::Range::finite,
                    "moment at the tip as a multiple of pi E I/l");
    line.add_choice("--on", slope, {"r_x", "r_y"}, "the slope on which the moment acts");
    beam.add_geometry_to(line);
    beam.add_clamp_to(line);
    beam.add_element_to(line, examples::all_elements);
    line.add_counts("--elements", elements, 1, examples::most_elements, "meshes");
    solver.add_to(line);
    output.add_to(line);
    line.parse(argc, argv);
    beam.settle(line);
    output.check();
    if (beam.is_cable()) {
        ancf::detail::require(!line.given("--on") || slope == "r_x", "--on ", slope,
                              " does not apply to --element ", beam.element,
                              ", which has r_x alone");
        slope = "r_x";
    }
    examples::check(beam);
}

std::string Semicircle::title() const {
    std::ostringstream text;
    text << "Semicircle, " << beam.description() << ", moment " << moment() << " N m on " << slope;
    return text.str();
}

const Published* Semicircle::published(int mesh) const {
    if (beam.geometry.values() != paper.values() || !beam.as_paper() || moment_factor != 1.0 ||
        slope != "r_y")
        return nullptr;
    return examples::find(figure_8, beam.element, mesh);
}

struct Result {
    ancf::StaticsReport report;
    Point tip;
    double angle;  // of r_x at the tip, degrees
};

template <int Dimension>
Result solve(const Semicircle& problem, int elements) {
    ancf::BasicModel<Dimension> model;
    const auto beam = examples::straight_beam(model, problem.beam, elements);
    model.clamp(beam.first(), problem.beam.clamped());
    const ancf::Field slope = problem.slope == "r_x" ? ancf::Field::r_x : ancf::Field::r_y;
    if constexpr (Dimension == 2)
        model.add(ancf::PlanarSlopeMoment(beam.last(), slope, problem.moment()));
    else
        model.add(ancf::SlopeMoment(beam.last(), slope, Point::UnitZ(), problem.moment()));
    auto report = examples::solve(model, problem.solver);
    if (elements == problem.elements.back())
        problem.output.write(model, beam, problem.beam.section());
    return {std::move(report), examples::in_space<Dimension>(model.position(beam.last())),
            examples::bending_angle(model, beam, problem.beam.section())};
}

/// Solves every mesh and prints a row for each; returns whether all is as published.
bool study(const Semicircle& problem) {
    using examples::fixed;
    const examples::BeamOptions& beam = problem.beam;
    examples::Verdict verdict;
    examples::Sheet sheet(
        problem.output.csv,
        {"element", "rule", "elements", "steps", "iterations", "status", "x", "y", "angle_deg"},
        {"elements", "iterations", "status", "x", "y", "angle (deg)", "published x", "published y",
         "deviation"});
    for (const int mesh : problem.elements) {
        const auto [report, tip, angle] =
            beam.is_planar() ? solve<2>(problem, mesh) : solve<3>(problem, mesh);
        verdict.add(mesh, report);
        const std::string status(to_string(report.status));
        sheet.add_csv(beam.element, beam.rule, mesh, steps(problem.solver, report),
                      report.iterations(), status, tip[0], tip[1], angle);
        std::vector<std::string> row = {std::to_string(mesh),
                                        std::to_string(report.iterations()),
                                        status,
                                        fixed(tip[0], 6),
                                        fixed(tip[1], 6),
                                        fixed(angle, 3)};
        if (const Published* published = problem.published(mesh)) {
            const double deviation = verdict.deviation(*published, tip[0], tip[1], tolerance);
            row.insert(row.end(), {fixed(published->first, 6), fixed(published->second, 6),
                                   examples::scientific(deviation)});
        }
        sheet.add_table(std::move(row));
    }
    sheet.finish(problem.title());
    return verdict.good();
}

}  // namespace

int main(int argc, char** argv) {
    return examples::run([&] {
        Semicircle problem;
        problem.parse(argc, argv);
        return study(problem) ? examples::exit_done : examples::exit_missed;
    });
}
