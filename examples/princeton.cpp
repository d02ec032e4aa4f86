// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The Princeton beam experiment: a slender cantilever under a tip load at an angle to its section.
///
///     Y (chord)
///     |   12.377 mm high, 3.2024 mm wide, 508 mm long, aluminium: E 71.7 GPa, nu 0.31
///     ||  the load P turns from Y (theta = 0) towards Z (theta = 90 degrees)
///     +---Z (flap)
///
/// Experiment: Dowell and Traybar, USAAMRDL TR 75-61A (1975). Compared here with a geometrically
/// exact beam of Saint-Venant's torsional stiffness (G J 3.103338 N m^2), solved to round-off:
/// within 0.5 % of each displacement.

#include <ancf/constants.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/output/csv.hpp>
#include <ancf/solver/statics.hpp>
#include <ancf/types.hpp>

#include <support/beam.hpp>
#include <support/command_line.hpp>
#include <support/files.hpp>
#include <support/named_beam.hpp>
#include <support/report.hpp>
#include <support/solver.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace {

using Point = ancf::Vector<double, 3>;

/// Aluminium of Poisson's ratio 0.31.
constexpr examples::Geometry geometry = {0.508,  3.2024e-3,           12.377e-3,
                                         71.7e9, 71.7e9 / (2 * 1.31), 5.0 / 6.0};
constexpr double tolerance = 5e-3;  // of each displacement

/// A load, N, and its angle, degrees.
struct Load {
    double force, angle;
};

/// Where the tip of the exact beam goes, m.
struct Reference {
    Load load;
    double chordwise, flapwise;
};
constexpr Reference references[] = {{{4.448, 30.0}, 0.00475107, 0.03994940},
                                    {{8.896, 0.0}, 0.01071541, 0.0},
                                    {{8.896, 45.0}, 0.00888886, 0.10904157},
                                    {{8.896, 90.0}, 0.0, 0.14625998},
                                    {{13.345, 60.0}, 0.01171642, 0.18192119}};

/// Returns the reference of a load, or nullptr.
const Reference* find(const Load& load) {
    const auto* const at =
        std::find_if(std::begin(references), std::end(references), [&](const Reference& entry) {
            return entry.load.force == load.force && entry.load.angle == load.angle;
        });
    return at == std::end(references) ? nullptr : at;
}

struct Princeton {
    int elements = 16;
    double load = 0.0;  // N, at ten angles; 0: those of the references
    examples::BeamOptions beam;
    examples::SolverOptions solver;
    examples::OutputOptions output;

    void parse(int argc, char** argv);
    [[nodiscard]] std::vector<Load> loads() const;
};

void Princeton::parse(int argc, char** argv) {
    examples::CommandLine line("The Princeton beam: a tip load at an angle to the section.");
    solver.statics.steps = 4;
    beam.geometry = geometry;
    beam.clamp = "full";
    beam.rule = "mixed";
    beam.transverse = "stretch";
    beam.section_model = "saint-venant";
    beam.add_element_to(line, examples::cross_section_beams);
    line.add_count("--elements", elements, 1, 10'000, "number of elements");
    solver.add_to(line);
    line.set_group("Load");
    line.add_number("--load", load, examples::Range::finite,
                    "N, at every tenth degree from the chord; 0: those of the references");
    output.add_to(line);
    line.parse(argc, argv);
    beam.settle(line);
    examples::check(beam);
    output.check();
}

std::vector<Load> Princeton::loads() const {
    std::vector<Load> all;
    if (load == 0.0)
        for (const Reference& reference : references) all.push_back(reference.load);
    else
        for (int degrees = 0; degrees <= 90; degrees += 10)
            all.push_back({load, static_cast<double>(degrees)});
    return all;
}

struct Result {
    ancf::StaticsReport report;
    double chordwise, flapwise;  // m
};

Result solve(const Princeton& problem, const Load& load) {
    ancf::Model model;
    const auto beam = examples::straight_beam(model, problem.beam, problem.elements);
    model.clamp(beam.first(), problem.beam.clamped());
    const double angle = load.angle * ancf::pi / 180.0;
    const Point force(0.0, load.force * std::cos(angle), load.force * std::sin(angle));
    model.add(ancf::Force<3>(beam.last(), force));
    auto report = examples::solve(model, problem.solver);
    problem.output.write(model, beam, problem.beam.section());  // the last load's stay
    const Point tip = model.position(beam.last());
    return {std::move(report), tip[1], tip[2]};
}

/// Returns how far the tip is off: of each displacement or, where that is zero, of the other one.
double deviation(const Result& result, const Reference& reference) {
    const auto relative = [](double value, double expected, double other) {
        return std::abs(value - expected) / (expected != 0.0 ? expected : other);
    };
    return std::max(relative(result.chordwise, reference.chordwise, reference.flapwise),
                    relative(result.flapwise, reference.flapwise, reference.chordwise));
}

/// Solves every load; returns whether all is as expected.
bool study(const Princeton& problem) {
    using ancf::number_text;
    using examples::fixed;
    examples::Verdict verdict;
    bool close = true;
    examples::Sheet sheet(problem.output.csv,
                          {"load", "angle", "elements", "iterations", "status", "chordwise",
                           "flapwise", "reference_chordwise", "reference_flapwise", "deviation"},
                          {"P, N", "angle", "iterations", "status", "chordwise, mm", "flapwise, mm",
                           "reference", "reference", "deviation, %"});
    for (const Load& load : problem.loads()) {
        const Result result = solve(problem, load);
        verdict.add(problem.elements, result.report);
        const std::string status(to_string(result.report.status));
        std::vector<std::string> row = {fixed(load.force, 3),
                                        fixed(load.angle, 0),
                                        std::to_string(result.report.iterations()),
                                        status,
                                        fixed(1e3 * result.chordwise, 4),
                                        fixed(1e3 * result.flapwise, 4)};
        std::array<std::string, 3> compared;  // empty where there is no reference
        if (const Reference* reference = find(load)) {
            const double off = deviation(result, *reference);
            compared = {number_text(reference->chordwise), number_text(reference->flapwise),
                        number_text(off)};
            row.insert(row.end(), {fixed(1e3 * reference->chordwise, 4),
                                   fixed(1e3 * reference->flapwise, 4), fixed(100.0 * off, 4)});
            if (!(off <= tolerance)) {
                close = false;
                std::cerr << load.force << " N at " << load.angle << " degrees: missed by "
                          << fixed(100.0 * off, 3) << " %, tolerance "
                          << fixed(100.0 * tolerance, 1) << " %\n";
            }
        }
        sheet.add_csv(load.force, load.angle, problem.elements, result.report.iterations(), status,
                      result.chordwise, result.flapwise, compared[0], compared[1], compared[2]);
        sheet.add_table(std::move(row));
    }
    sheet.finish("Princeton beam, " + std::to_string(problem.elements) +
                 (problem.elements == 1 ? " element, " : " elements, ") +
                 problem.beam.description());
    return verdict.good() && close;
}

}  // namespace

int main(int argc, char** argv) {
    return examples::run([&] {
        Princeton problem;
        problem.parse(argc, argv);
        return study(problem) ? examples::exit_done : examples::exit_missed;
    });
}
