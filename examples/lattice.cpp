// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A cubic lattice of beams that are joined rigidly, clamped at its foot and loaded at its head.
///
///        o---o---o   <- loads at the joints of the top: compression, shear or twist
///        |   |   |
///        o---o---o      joints 0.25 m apart, steel members of 0.01 m x 0.01 m
///        |   |   |
///     ///o///o///o///
///
/// In compression every column carries its own load: it shortens by P H/(E A), which the default
/// run checks. In shear and twist a lattice of the default size is checked against linear frame
/// analysis of Timoshenko's beams. docs/theory-frames.md says how the joints work.

#include <ancf/element/cross_section/beam.hpp>
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

#if ANCF_WITH_PETSC
#include <ancf/petsc/distributed_scene.hpp>
#endif

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace {

using Beam = ancf::CrossSectionBeam<3>;
using Point = ancf::Vector<double, 3>;

constexpr double spacing = 0.25, side = 0.01;  // m
constexpr double young = 2e11, poisson = 0.3, density = 7800.0;
constexpr double tolerance = 1e-3;  // of the shortening
// linear frame analysis of 3 x 3 x 5 joints: how far the last joint moves under 1 N at each joint
// of the top, m/N: along X in shear; in twist along Y, and as far against X
constexpr double sheared = 7.1029e-5, twisted = 4.9922e-5;
constexpr double bent_tolerance = 2e-3;  // of both: 200 N turn the top by 0.04 rad

struct Lattice {
    std::array<double, 3> joints = {3, 3, 5};
    int elements = 1;
    std::string load = "compression";
    double force = 200.0;  // N at each joint of the top
    bool csv = false;
    bool petsc = false;
    std::string vtk, lines;
    examples::SolverOptions solver;

    void parse(int argc, char** argv);
    [[nodiscard]] int count(int axis) const {
        return static_cast<int>(joints[static_cast<std::size_t>(axis)]);
    }
    [[nodiscard]] int place(int i, int j, int k) const { return i + count(0) * (j + count(1) * k); }
    [[nodiscard]] std::vector<Point> points() const;
    [[nodiscard]] std::vector<ancf::Member> members() const;
    /// Returns the force on a joint of the top.
    [[nodiscard]] Point force_at(const Point& point) const;
};

void Lattice::parse(int argc, char** argv) {
    examples::CommandLine line("A cubic lattice of rigidly joined beams under a load at its top.");
    line.set_group("Lattice");
    line.add_triple("--joints", joints.data(), "numbers of joints along X, Y and Z");
    line.add_count("--elements", elements, 1, 1000, "of each member");
    line.add_choice("--load", load, {"compression", "shear", "twist"}, "what acts on the top");
    line.add_number("--force", force, examples::Range::finite, "at each joint of the top, N");
    solver.add_to(line);
#if ANCF_WITH_PETSC
    line.add_flag("--petsc", petsc,
                  "by conjugate gradients and multigrid of PETSc, and by all processes of mpirun; "
                  "the variable PETSC_OPTIONS has options, such as -lattice_ksp_monitor");
#endif
    line.set_group("Output");
    line.add_flag("--csv", csv, "comma-separated values on stdout instead of a table");
    line.add_file("--vtk", vtk, "the deformed lattice for ParaView: .vtp, .vtu or .vtk");
    line.add_file("--lines", lines,
                  "the members' centre lines: x, y, z; two empty lines after each");
    line.parse(argc, argv);
    for (const double number : joints)
        ancf::detail::require(number >= 1.0 && number <= 1000.0 && number == std::floor(number),
                              "--joints takes whole numbers from 1 to 1000, got ", number);
    ancf::detail::require(joints[2] >= 2.0, "--joints needs at least 2 along Z, got ", joints[2]);
    examples::require_apart("--vtk", vtk, "--lines", lines);
    if (!vtk.empty()) {
        static_cast<void>(ancf::vtk_format(vtk));
        examples::require_writable(vtk);
    }
    if (!lines.empty()) examples::require_writable(lines);
}

std::vector<Point> Lattice::points() const {
    std::vector<Point> all;
    for (int k = 0; k < count(2); ++k)
        for (int j = 0; j < count(1); ++j)
            for (int i = 0; i < count(0); ++i)
                all.emplace_back(spacing * i, spacing * j, spacing * k);
    return all;
}

std::vector<ancf::Member> Lattice::members() const {
    std::vector<ancf::Member> all;
    for (int k = 0; k < count(2); ++k)
        for (int j = 0; j < count(1); ++j)
            for (int i = 0; i < count(0); ++i) {
                const int here = place(i, j, k);
                if (k > 0) all.push_back({place(i, j, k - 1), here, 0, elements});
                if (k == 0) continue;  // the foot is clamped
                if (i > 0) all.push_back({place(i - 1, j, k), here, 0, elements});
                if (j > 0) all.push_back({place(i, j - 1, k), here, 0, elements});
            }
    return all;
}

Point Lattice::force_at(const Point& point) const {
    if (load == "compression") return {0.0, 0.0, -force};
    if (load == "shear") return {force, 0.0, 0.0};
    const double x = point[0] - 0.5 * spacing * (count(0) - 1);
    const double y = point[1] - 0.5 * spacing * (count(1) - 1);
    const double radius = std::hypot(x, y);
    if (radius == 0.0) return Point::Zero();
    return {-force * y / radius, force * x / radius, 0.0};
}

/// Writes five points of each element, member by member.
void write_lines(const std::string& file, const ancf::Model& model,
                 const ancf::Frame<Beam>& frame) {
    constexpr int stations = 5;
    std::ofstream out(file);
    out.precision(9);
    for (const auto& member : frame.members) {
        for (const int index : member.elements) {
            const Beam& element = model.group<Beam>().element(index);
            const auto e = model.element_coordinates<Beam>(index);
            for (int k = 0; k < stations; ++k) {
                const Point at = element.position(e, static_cast<double>(k) / (stations - 1));
                out << at[0] << ',' << at[1] << ',' << at[2] << '\n';
            }
        }
        out << "\n\n";
    }
    out.close();
    ancf::detail::require(!out.fail(), "cannot write ", file);
}

/// Solves by one process, or by all of them.
ancf::StaticsReport solve(ancf::Model& model, const Lattice& lattice) {
#if ANCF_WITH_PETSC
    if (lattice.petsc) {
        ancf::petsc::DistributedScene scene(model, PETSC_COMM_WORLD,
                                            ancf::petsc::SolverOptions::iterative("lattice_"));
        ancf::StaticsReport report = scene.solve(lattice.solver.statics);
        scene.gather();
        return report;
    }
#endif
    return examples::solve(model, lattice.solver);
}

bool study(const Lattice& lattice) {
    const auto steel = ancf::Material::isotropic(young, poisson, density);
    const auto section = ancf::rectangle(side, side);
    const std::vector<Point> points = lattice.points();
    ancf::Model model;
    const auto frame = ancf::frame<Beam>(model, {{steel, section}}, points, lattice.members(), {},
                                         ancf::CrossSectionOptions::best());
    const int layer = lattice.count(0) * lattice.count(1);
    const int top = static_cast<int>(points.size()) - layer;
    for (int k = 0; k < layer; ++k) {
        model.clamp(frame.joints[static_cast<std::size_t>(k)]);
        const auto at = static_cast<std::size_t>(top + k);
        model.add(ancf::Force<3>(frame.joints[at], lattice.force_at(points[at])));
    }
    const ancf::StaticsReport report = solve(model, lattice);
    Point moved = Point::Zero(), corner = Point::Zero();  // mean of the top, and its last joint
    for (int k = 0; k < layer; ++k) {
        const auto at = static_cast<std::size_t>(top + k);
        corner = model.position(frame.joints[at]) - points[at];
        moved += corner / layer;
    }
    const std::string status(to_string(report.status));
    const int members = static_cast<int>(frame.members.size());
    examples::Verdict verdict;
    verdict.add(lattice.elements, report);
    examples::Sheet sheet(lattice.csv,
                          {"load", "joints", "members", "elements", "unknowns", "iterations",
                           "status", "ux", "uy", "uz", "corner_ux", "corner_uy", "corner_uz"},
                          {"members", "unknowns", "iterations", "status", "mean ux", "mean uy",
                           "mean uz", "deviation"});
    const int unknowns = examples::free_coordinates(model);
    sheet.add_csv(lattice.load, points.size(), members, lattice.elements, unknowns,
                  report.iterations(), status, moved[0], moved[1], moved[2], corner[0], corner[1],
                  corner[2]);
    std::vector<std::string> row = {std::to_string(members), std::to_string(unknowns),
                                    std::to_string(report.iterations()), status};
    for (int k = 0; k < 3; ++k) row.push_back(examples::scientific(moved[k]));
    bool good = verdict.good();
    const double force = lattice.force;
    if (lattice.load == "compression") {
        const double height = spacing * (lattice.count(2) - 1);
        const double deviation = -moved[2] / (force * height / (young * side * side)) - 1.0;
        row.push_back(examples::scientific(deviation));
        // columns under more than a tenth of what buckles them bend as well
        const double buckling = 9.87 * young * std::pow(side, 4) / 12.0 / (spacing * spacing);
        if (std::abs(force) < 0.1 * buckling) good = good && std::abs(deviation) < tolerance;
    } else if (lattice.joints == Lattice().joints && force != 0.0) {
        const bool shear = lattice.load == "shear";
        const double found = shear ? corner[0] : 0.5 * (corner[1] - corner[0]);
        const double deviation = found / (force * (shear ? sheared : twisted)) - 1.0;
        row.push_back(examples::scientific(deviation));
        if (std::abs(force) <= Lattice().force) good = good && std::abs(deviation) < bent_tolerance;
    }
    sheet.add_table(std::move(row));
    sheet.finish("Lattice of " + std::to_string(points.size()) + " joints, " + lattice.load);
    if (!lattice.vtk.empty()) {
        ancf::Surface surface;
        for (const auto& member : frame.members) surface.add(model, member, section, 5);
        ancf::write_vtk(lattice.vtk, surface);
    }
    if (!lattice.lines.empty()) write_lines(lattice.lines, model, frame);
    return good;
}

}  // namespace

int main(int argc, char** argv) {
    return examples::run([&] {
        Lattice lattice;
        lattice.parse(argc, argv);
#if ANCF_WITH_PETSC
        std::unique_ptr<ancf::petsc::Session> session;
        if (lattice.petsc) {
            session = std::make_unique<ancf::petsc::Session>();
            if (ancf::petsc::Session::rank() > 0) {  // the first one writes
                lattice.vtk.clear();
                lattice.lines.clear();
                if (std::freopen("/dev/null", "w", stdout) == nullptr) return examples::exit_missed;
            }
        }
#endif
        return study(lattice) ? examples::exit_done : examples::exit_missed;
    });
}
