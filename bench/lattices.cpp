// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What a lattice of beams costs: members against seconds and memory of each stage.
///
///     lattices                             up to 5,000 members, and the same with multipliers
///     lattices --joints 50 50 20           one lattice
///     lattices --joints 7 7 7 --weld       the same with multipliers at its joints, by UMFPACK
///     lattices --swing                     a thousand members in motion, and their modes
///
/// Five Newton iterations in one load step each: assembly, factorisation and solution five times,
/// analysis once. One element a member unless --elements says otherwise. Seconds are processor time
/// of all threads, and OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 make that one. Memory is the most
/// that the program had so far.

#include "lattices/lattice.hpp"

#include <ancf/assembly/assembly.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/suitesparse/cholmod.hpp>
#include <ancf/suitesparse/umfpack.hpp>

#include <CLI/CLI.hpp>

#include <sys/resource.h>

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using Beam = ancf::CrossSectionBeam<3>;
using Point = ancf::Vector<double, 3>;
using ancf::bench::Lattice;
using ancf::bench::seconds;

/// A lattice, clamped at its foot, sheared at its head.
struct Tower {
    Lattice lattice;
    int elements;
    ancf::Model model;
    ancf::NodeId tip;

    /// Returns the number of members.
    int build(bool welds) {
        const ancf::Profile bar = Lattice::bar();
        const std::vector<ancf::Member> members = lattice.members(elements);
        const std::vector<Point> points = lattice.points();
        if (welds) {
            build_welded(bar, points, members);
            return static_cast<int>(members.size());
        }
        const auto frame = ancf::frame<Beam>(model, {bar}, points, members);
        tip = frame.joints.back();
        for (int k = 0; k < lattice.nx * lattice.ny; ++k) {
            model.clamp(frame.joints[static_cast<std::size_t>(k)]);
            model.add(ancf::Force<3>(frame.joints[points.size() - 1 - static_cast<std::size_t>(k)],
                                     Point(1.0, 0.5, 0.0)));
        }
        return static_cast<int>(members.size());
    }

    void build_welded(const ancf::Profile& bar, const std::vector<Point>& points,
                      const std::vector<ancf::Member>& members) {
        std::vector<ancf::NodeId> first(points.size());
        for (const ancf::Member& member : members) {
            const auto beam = ancf::straight_beam<Beam>(
                model, bar.material, bar.section, points[static_cast<std::size_t>(member.first)],
                points[static_cast<std::size_t>(member.second)], elements);
            const auto join = [&](int joint, ancf::NodeId end) {
                ancf::NodeId& other = first[static_cast<std::size_t>(joint)];
                if (other.index >= 0)
                    model.add(ancf::Weld(model, other, end));
                else
                    other = end;
            };
            join(member.first, beam.first());
            join(member.second, beam.last());
        }
        tip = first.back();
        for (int k = 0; k < lattice.nx * lattice.ny; ++k) {
            model.clamp(first[static_cast<std::size_t>(k)]);
            model.add(ancf::Force<3>(first[points.size() - 1 - static_cast<std::size_t>(k)],
                                     Point(1.0, 0.5, 0.0)));
        }
    }
};

struct Cost {
    bool good = false;     // five iterations came to rest
    double seconds = 0.0;  // of all stages
};

Cost run(const Lattice& of, int elements, bool welds, bool csv) {
    constexpr int iterations = 5;
    Tower tower{of, elements, {}, {}};
    double start = seconds();
    const auto since = [](double from) { return seconds() - from; };
    const int members = tower.build(welds);
    ancf::Assembly assembly(tower.model, welds ? ancf::Storage::full : ancf::Storage::lower);
    const double built = since(start);
    ancf::suitesparse::CholmodOptions options;
    options.ordering = ancf::suitesparse::CholmodOrdering::automatic;
    ancf::suitesparse::Cholmod cholmod(options);
    ancf::suitesparse::Umfpack umfpack;
    ancf::LinearSolver& solver = welds ? static_cast<ancf::LinearSolver&>(umfpack) : cholmod;
    ancf::State& state = tower.model.state();
    double assembled = 0.0, analysed = 0.0, factorised = 0.0, solved = 0.0, last = 0.0;
    ancf::VectorX residual, correction;
    for (int k = 0; k < iterations; ++k) {
        start = seconds();
        const auto fault = assembly.evaluate({state.q, state.v, state.multipliers, {1.0, 1.0}},
                                             ancf::Request::tangent);
        assembled += since(start);
        if (fault) {
            std::printf("an element failed in iteration %d\n", k + 1);
            return {};
        }
        if (k == 0) {
            start = seconds();
            solver.analyze(assembly.tangent());
            analysed = since(start);
        }
        start = seconds();
        const ancf::FactorReport report = solver.factorize(assembly.tangent());
        factorised += since(start);
        if (report.status != ancf::Status::converged) {
            std::printf("the factorisation of iteration %d is %s\n", k + 1,
                        std::string(to_string(report.status)).c_str());
            return {};
        }
        start = seconds();
        assembly.residual(residual);
        solver.solve(residual, correction);
        const int free = assembly.numbering().free_coordinates();
        assembly.numbering().add_free(correction.head(free), -1.0, state.q);
        for (Eigen::Index m = 0; m < state.multipliers.size(); ++m)
            state.multipliers[m] -= correction[free + m];
        solved += since(start);
        last = correction.head(free).cwiseAbs().maxCoeff();
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const double total = built + analysed + assembled + factorised + solved;
    const double tip =
        state.q[tower.model.coordinate(tower.tip, ancf::Field::r)] - Lattice::cell * (of.nx - 1);
    const char* const format =
        csv ? "%d,%d,%d,%d,%d,%d,%s,%.3f,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%.2e,%.6e,%.3f\n"
            : "%4d %3d %3d %4d %8d %9d %6s %6.2f %8.3f %8.3f %8.3f %8.3f %8.3f %8.3f %8.1e %12.5e "
              "%6.2f\n";
    std::printf(format, of.nx, of.ny, of.nz, elements, members, assembly.numbering().unknowns(),
                welds ? "weld" : "frame", static_cast<double>(assembly.tangent().nonZeros()) / 1e6,
                built, analysed, assembled, factorised, solved, total, last, tip,
                static_cast<double>(usage.ru_maxrss) / (1024.0 * 1024.0));
    std::fflush(stdout);
    return {last < 1e-10, total};
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("What a lattice costs: seconds of each stage, five Newton iterations.");
    std::vector<int> joints;
    int elements = 1;
    bool welds = false, swing = false, csv = false;
    double duration = 1.0;
    app.add_option("--joints", joints, "numbers of joints along X, Y and Z")->expected(3);
    app.add_option("--elements", elements, "of each member")->check(CLI::Range(1, 1000));
    app.add_flag("--weld", welds, "multipliers at the joints, solved by UMFPACK");
    app.add_flag("--swing", swing, "a thousand members in motion");
    app.add_option("--duration", duration, "of the motion, s")->check(CLI::Range(1e-3, 1e3));
    app.add_flag("--csv", csv, "comma-separated values");
    CLI11_PARSE(app, argc, argv);
    if (swing) return ancf::bench::run_motion(duration, csv) ? 0 : 1;
    if (csv)
        std::printf(
            "nx,ny,nz,elements,members,unknowns,joints,mega_nz,build,analyse,evaluate,factorise,"
            "solve,total,last,tip,max_gb\n");
    else
        std::printf("%12s %4s %8s %9s %6s %6s %8s %8s %8s %8s %8s %8s %8s %12s %6s\n", "joints",
                    "per", "members", "unknowns", "by", "10^6nz", "build", "analyse", "evaluate",
                    "factor", "solve", "total", "last", "tip", "max GB");
    if (!joints.empty())
        return run({joints[0], joints[1], joints[2]}, elements, welds, csv).good ? 0 : 1;
    bool good = true;
    double cube = 0.0, ratio = 0.0;  // seconds of the largest of both joints
    for (const Lattice& of : {Lattice{3, 3, 3}, Lattice{5, 5, 5}, Lattice{7, 7, 7},
                              Lattice{9, 9, 9}, Lattice{30, 30, 2}, Lattice{6, 6, 40}}) {
        const Cost cost = run(of, elements, false, csv);
        good = cost.good && good;
        if (of.nz == 7) cube = cost.seconds;
    }
    for (const int n : {3, 5, 7}) {
        const Cost cost = run({n, n, n}, elements, true, csv);
        good = cost.good && good;
        ratio = cost.seconds / cube;
    }
    if (!csv) std::printf("with multipliers the last one takes %.0f times as long\n", ratio);
    return good ? 0 : 1;
}
