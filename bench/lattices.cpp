// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What a lattice of beams costs: members against seconds and memory of each stage.
///
///     lattices                             cubes, plates and towers up to 5,000 members
///     lattices --joints 50 50 20           one lattice
///     lattices --joints 7 7 7 --weld       the same with multipliers at its joints, by UMFPACK
///
/// Five Newton iterations in one load step each: assembly, factorisation and solution five times,
/// analysis once. One element a member unless --elements says otherwise.

#include <ancf/assembly/assembly.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/constraints.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/profiles.hpp>
#include <ancf/suitesparse/cholmod.hpp>
#include <ancf/suitesparse/umfpack.hpp>

#include <CLI/CLI.hpp>

#include <sys/resource.h>

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using Beam = ancf::CrossSectionBeam<3>;
using Point = ancf::Vector<double, 3>;
using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A lattice of unit cells 0.25 m wide, clamped at its foot, sheared at its head.
struct Lattice {
    int nx, ny, nz, elements;
    ancf::Model model;

    [[nodiscard]] int place(int i, int j, int k) const { return i + nx * (j + ny * k); }

    [[nodiscard]] std::vector<Point> points() const {
        std::vector<Point> all;
        for (int k = 0; k < nz; ++k)
            for (int j = 0; j < ny; ++j)
                for (int i = 0; i < nx; ++i) all.emplace_back(0.25 * i, 0.25 * j, 0.25 * k);
        return all;
    }

    [[nodiscard]] std::vector<ancf::Member> members() const {
        std::vector<ancf::Member> all;
        for (int k = 0; k < nz; ++k)
            for (int j = 0; j < ny; ++j)
                for (int i = 0; i < nx; ++i) {
                    const int here = place(i, j, k);
                    if (k > 0) all.push_back({place(i, j, k - 1), here, 0, elements});
                    if (i > 0) all.push_back({place(i - 1, j, k), here, 0, elements});
                    if (j > 0) all.push_back({place(i, j - 1, k), here, 0, elements});
                }
        return all;
    }

    /// Returns the number of members.
    int build(bool welds) {
        const ancf::Profile bar{ancf::Material::isotropic(2e11, 0.3, 7800.0),
                                ancf::rectangle(0.01, 0.01)};
        const std::vector<ancf::Member> members = this->members();
        const std::vector<Point> points = this->points();
        if (welds) {
            build_welded(bar, points, members);
            return static_cast<int>(members.size());
        }
        const auto frame = ancf::frame<Beam>(model, {bar}, points, members);
        for (int k = 0; k < nx * ny; ++k) {
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
        for (int k = 0; k < nx * ny; ++k) {
            model.clamp(first[static_cast<std::size_t>(k)]);
            model.add(ancf::Force<3>(first[points.size() - 1 - static_cast<std::size_t>(k)],
                                     Point(1.0, 0.5, 0.0)));
        }
    }
};

/// Returns whether five iterations came to rest.
bool run(int nx, int ny, int nz, int elements, bool welds) {
    constexpr int iterations = 5;
    Lattice lattice{nx, ny, nz, elements, {}};
    auto start = Clock::now();
    const int members = lattice.build(welds);
    ancf::Assembly assembly(lattice.model, welds ? ancf::Storage::full : ancf::Storage::lower);
    const double built = since(start);
    ancf::suitesparse::CholmodOptions options;
    options.ordering = ancf::suitesparse::CholmodOrdering::automatic;
    ancf::suitesparse::Cholmod cholmod(options);
    ancf::suitesparse::Umfpack umfpack;
    ancf::LinearSolver& solver = welds ? static_cast<ancf::LinearSolver&>(umfpack) : cholmod;
    ancf::State& state = lattice.model.state();
    double assembled = 0.0, analysed = 0.0, factorised = 0.0, solved = 0.0, last = 0.0;
    ancf::VectorX residual, correction;
    for (int k = 0; k < iterations; ++k) {
        start = Clock::now();
        const auto fault = assembly.evaluate({state.q, state.v, state.multipliers, {1.0, 1.0}},
                                             ancf::Request::tangent);
        assembled += since(start);
        if (fault) {
            std::printf("an element failed in iteration %d\n", k + 1);
            return false;
        }
        if (k == 0) {
            start = Clock::now();
            solver.analyze(assembly.tangent());
            analysed = since(start);
        }
        start = Clock::now();
        const ancf::FactorReport report = solver.factorize(assembly.tangent());
        factorised += since(start);
        if (report.status != ancf::Status::converged) {
            std::printf("the factorisation of iteration %d is %s\n", k + 1,
                        std::string(to_string(report.status)).c_str());
            return false;
        }
        start = Clock::now();
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
    std::printf("%4d x %3d x %3d %8d %9d %7.2f %8.3f %8.3f %8.3f %8.3f %8.3f %8.1e %7.2f %s\n", nx,
                ny, nz, members, assembly.numbering().unknowns(),
                static_cast<double>(assembly.tangent().nonZeros()) / 1e6, built, analysed,
                assembled, factorised, solved, last,
                static_cast<double>(usage.ru_maxrss) / (1024.0 * 1024.0), welds ? "weld" : "");
    std::fflush(stdout);
    return last < 1e-10;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("What a lattice costs: seconds of each stage, five Newton iterations.");
    std::vector<int> joints;
    int elements = 1;
    bool welds = false;
    app.add_option("--joints", joints, "numbers of joints along X, Y and Z")->expected(3);
    app.add_option("--elements", elements, "of each member")->check(CLI::Range(1, 1000));
    app.add_flag("--weld", welds, "multipliers at the joints, solved by UMFPACK");
    CLI11_PARSE(app, argc, argv);
    std::printf("%17s %8s %9s %7s %8s %8s %8s %8s %8s %8s %7s\n", "joints", "members", "unknowns",
                "10^6 nz", "build", "analyse", "evaluate", "factor", "solve", "last", "max GB");
    if (!joints.empty()) {
        return run(joints[0], joints[1], joints[2], elements, welds) ? 0 : 1;
    }
    bool good = true;
    for (const int n : {3, 5, 7, 9}) good = run(n, n, n, elements, welds) && good;
    good = run(6, 6, 40, elements, welds) && good;
    good = run(30, 30, 2, elements, welds) && good;
    return good ? 0 : 1;
}
