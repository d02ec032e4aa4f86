// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A cantilever under a dead force at its tip: [Dufva2006, section 5.2, Tables 1 and 3].
///
///      /|                                       ^ P
///      /|=======================================|         Y
///      /|                                       |         |
///      /|<------------------ L ---------------->|         +-- X
///
/// Model II, the default, is slender (L 2, 0.01 x 0.01) and bends far: P = 1.5 E I/L^2. With 16
/// cross-section elements the tip comes to (1.7841, 0.8220). Model I is deep (L 2, 0.1 wide, 0.5
/// high) and stiff: P = 2.5e6 N lifts the tip by 0.032417 m.

#include <ancf/error.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/statics.hpp>
#include <ancf/types.hpp>

#include <support/beam.hpp>
#include <support/command_line.hpp>
#include <support/files.hpp>
#include <support/named_beam.hpp>
#include <support/report.hpp>
#include <support/solver.hpp>
#include <support/table_1.hpp>

#include <cmath>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using examples::Published;
using Point = ancf::Vector<double, 3>;

/// Tip (x, y) of Table 3.
constexpr Published table_3[] = {{"cross-section", 1, 1.9996858, 0.0324155},
                                 {"cross-section", 4, 1.9996858, 0.0324172}};

/// One of the paper's two cantilevers.
struct Preset {
    const char* name;
    examples::Geometry geometry;
    double load_factor;  ///< of E I/L^2
    double force;        ///< N, used where load_factor is 0
    double tolerance;    ///< on the published values, m
    int decimals;        ///< of the published values
};

constexpr Preset model_1 = {"Model I", {2.0, 0.1, 0.5, 2.07e11, 7.9615e10}, 0.0, 2.5e6, 2e-7, 7};
constexpr Preset model_2 = {"Model II", {2.0, 0.01, 0.01, 2.07e11, 7.9615e10}, 1.5,
                            0.0,        examples::table_1_tolerance,           4};

struct Cantilever {
    int model = 2;
    double load_factor = model_2.load_factor;
    Point force = Point::Zero();
    std::vector<int> elements = {1, 2, 4, 8, 16};
    examples::BeamOptions beam;
    examples::SolverOptions solver;
    examples::OutputOptions output;

    [[nodiscard]] const Preset& preset() const { return model == 1 ? model_1 : model_2; }

    /// Returns a force A E I/L^2, N.
    [[nodiscard]] static double scaled_force(double factor, const examples::Geometry& of) {
        return factor * of.bending_stiffness() / (of.length * of.length);
    }

    void parse(int argc, char** argv);
    [[nodiscard]] std::string title() const;

    /// Returns the published tip for a mesh, nullptr where this is not the paper's problem.
    [[nodiscard]] const Published* published(int mesh) const;
};

void Cantilever::parse(int argc, char** argv) {
    examples::CommandLine line("A cantilever under a dead force at its tip (Tables 1 and 3).");
    beam.geometry = model_2.geometry;
    line.set_group("Beam");
    line.add_count("--model", model, 1, 2, "the paper's Model 1 (deep) or 2 (slender)");
    beam.add_geometry_to(line);
    beam.add_clamp_to(line);
    line.add_triple("--force", force.data(), "force at the tip, N");
    line.add_number("--load-factor", load_factor, examples::Range::finite,
                    "A of a force A E I/L^2 at the tip along Y (1.5 in Model 2)");
    line.exclude("--force", "--load-factor");
    beam.add_element_to(line, examples::all_elements);
    line.add_counts("--elements", elements, 1, examples::most_elements, "meshes");
    solver.add_to(line);
    output.add_to(line);
    line.parse(argc, argv);

    beam.settle(line);
    output.check();
    const examples::Geometry& usual = preset().geometry;
    line.settle("--length", beam.geometry.length, usual.length);
    line.settle("--width", beam.geometry.width, usual.width);
    line.settle("--height", beam.geometry.height, usual.height);
    line.settle("--young", beam.geometry.young, usual.young);
    line.settle("--shear", beam.geometry.shear, usual.shear);
    if (!line.given("--force")) {
        const bool own_force = preset().force != 0.0 && !line.given("--load-factor");
        line.settle("--load-factor", load_factor, preset().load_factor);
        force[1] = own_force ? preset().force : scaled_force(load_factor, beam.geometry);
    }
    ancf::detail::require(std::isfinite(force[1]), "--load-factor: ", load_factor,
                          " with these sizes and moduli gives no finite force");
    ancf::detail::require(!beam.is_planar() || force[2] == 0.0, "--force: --element ", beam.element,
                          " lives in the XY plane and takes no force along Z, got ", force[2]);
    examples::check(beam);
}

std::string Cantilever::title() const {
    std::ostringstream text;
    text << preset().name << ", " << beam.description() << ", tip force (" << force[0] << ", "
         << force[1] << ", " << force[2] << ") N";
    return text.str();
}

const Published* Cantilever::published(int mesh) const {
    const examples::Geometry& usual = preset().geometry;
    const double usual_force = preset().force + scaled_force(preset().load_factor, usual);
    if (beam.geometry.values() != usual.values() || !beam.as_paper() ||
        force != Point(0.0, usual_force, 0.0))
        return nullptr;
    return model == 1 ? examples::find(table_3, beam.element, mesh)
                      : examples::find(examples::table_1, beam.element, mesh);
}

struct Result {
    ancf::StaticsReport report;
    int unknowns;
    Point tip;
};

template <int Dimension>
Result solve(const Cantilever& problem, int elements) {
    ancf::BasicModel<Dimension> model;
    const auto beam = examples::straight_beam(model, problem.beam, elements);
    model.clamp(beam.first(), problem.beam.clamped());
    model.add(ancf::Force<Dimension>(beam.last(), problem.force.head<Dimension>()));
    auto report = examples::solve(model, problem.solver);
    if (elements == problem.elements.back())
        problem.output.write(model, beam, problem.beam.section());
    return {std::move(report), examples::free_coordinates(model),
            examples::in_space<Dimension>(model.position(beam.last()))};
}

/// Solves every mesh and prints a row for each; returns whether all is as published.
bool study(const Cantilever& problem) {
    using examples::fixed;
    const auto& [name, geometry, load_factor, force, tolerance, decimals] = problem.preset();
    const examples::BeamOptions& beam = problem.beam;
    examples::Verdict verdict;
    examples::Sheet sheet(
        problem.output.csv,
        {"element", "rule", "elements", "dofs", "steps", "iterations", "status", "x", "y", "z"},
        {"elements", "dofs", "iterations", "status", "x", "y", "z", "published x", "published y",
         "deviation"});
    for (const int mesh : problem.elements) {
        const auto [report, unknowns, tip] =
            beam.is_planar() ? solve<2>(problem, mesh) : solve<3>(problem, mesh);
        verdict.add(mesh, report);
        const std::string status(to_string(report.status));
        sheet.add_csv(beam.element, beam.rule, mesh, unknowns, steps(problem.solver, report),
                      report.iterations(), status, tip[0], tip[1], tip[2]);
        std::vector<std::string> row = {std::to_string(mesh),
                                        std::to_string(unknowns),
                                        std::to_string(report.iterations()),
                                        status,
                                        fixed(tip[0], 7),
                                        fixed(tip[1], 7),
                                        fixed(tip[2], 7)};
        if (const Published* published = problem.published(mesh)) {
            const double deviation = verdict.deviation(*published, tip[0], tip[1], tolerance);
            row.insert(row.end(),
                       {fixed(published->first, decimals), fixed(published->second, decimals),
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
        Cantilever problem;
        problem.parse(argc, argv);
        return study(problem) ? examples::exit_done : examples::exit_missed;
    });
}
