// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A cubic lattice by conjugate gradients and multigrid of PETSc: iterations, memory, time; and the
/// time of an assembly.
///
///     petsc_lattice 16                     16^3 joints; the solution in one step
///     mpirun -n 2 petsc_lattice 16         by two processes
///     petsc_lattice 24 assembly            15 assemblies, each with the sums of PETSc
///
/// The variable PETSC_OPTIONS changes the solver: -lattice_pc_type hypre.

#include <ancf/assembly/assembly.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/petsc/statics.hpp>
#include <ancf/section/profiles.hpp>

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using Beam = ancf::CrossSectionBeam<3>;
using Point = ancf::Vector<double, 3>;

ancf::Model lattice(int n) {
    const auto place = [n](int i, int j, int k) { return i + n * (j + n * k); };
    std::vector<Point> points;
    std::vector<ancf::Member> members;
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                points.emplace_back(0.25 * i, 0.25 * j, 0.25 * k);
                const int here = place(i, j, k);
                if (k > 0) members.push_back({place(i, j, k - 1), here, 0, 1});
                if (k > 0 && i > 0) members.push_back({place(i - 1, j, k), here, 0, 1});
                if (k > 0 && j > 0) members.push_back({place(i, j - 1, k), here, 0, 1});
            }
    const auto steel = ancf::Material::isotropic(2e11, 0.3, 7800.0);
    ancf::Model model;
    const auto frame = ancf::frame<Beam>(model, {{steel, ancf::rectangle(0.01, 0.01)}}, points,
                                         members, {}, ancf::CrossSectionOptions::best());
    for (int k = 0; k < n * n; ++k) {
        model.clamp(frame.joints[static_cast<std::size_t>(k)]);
        model.add(ancf::Force<3>(frame.joints[points.size() - 1 - static_cast<std::size_t>(k)],
                                 Point(20, 0, -50)));
    }
    return model;
}

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Returns the most memory that this process had, GB.
double memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1e6;
}

double processor_time() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

void assemble(ancf::petsc::DistributedStatics& statics, int members) {
    ancf::petsc::Solver solver(statics.part(), {"-ksp_type cg -pc_type none", ""});
    ancf::Assembly assembly(statics.part(), ancf::Storage::full);
    const ancf::State& state = statics.part().state();
    const ancf::VectorX rest = ancf::VectorX::Zero(state.q.size());
    std::vector<double> wall, processor;
    for (int k = 0; k < 16; ++k) {
        MPI_Barrier(PETSC_COMM_WORLD);
        const double begin = now(), begin_processor = processor_time();
        const auto fault = assembly.evaluate({state.q, rest, state.multipliers, {1.0, 1.0}},
                                             ancf::Request::tangent);
        if (k == 0) solver.analyze(assembly.tangent());
        if (fault || solver.factorize(assembly.tangent()).status != ancf::Status::converged) return;
        if (k == 0) continue;
        processor.push_back(processor_time() - begin_processor);
        MPI_Barrier(PETSC_COMM_WORLD);
        wall.push_back(now() - begin);
    }
    std::sort(wall.begin(), wall.end());
    std::sort(processor.begin(), processor.end());
    if (ancf::petsc::Session::rank() == 0)
        std::printf("%d processes, %d members, assembly: %.3f s, processor time %.3f s (medians)\n",
                    ancf::petsc::Session::ranks(), members, wall[7], processor[7]);
}

}  // namespace

int main(int argc, char** argv) {
    const int n = argc > 1 ? std::atoi(argv[1]) : 8;
    const bool only_assembly = argc > 2 && std::string(argv[2]) == "assembly";
    const ancf::petsc::Session session;
    ancf::Model model = lattice(n);
    const int members = model.group<Beam>().size();
    ancf::petsc::DistributedStatics statics(model, PETSC_COMM_WORLD,
                                            ancf::petsc::SolverOptions::iterative("lattice_"));
    if (only_assembly) {
        assemble(statics, members);
        return 0;
    }
    const double begin = now();
    const ancf::StaticsReport report = statics.solve();
    if (ancf::petsc::Session::rank() == 0)
        std::printf(
            "%d processes, %d^3 joints, %d members, %ld rows: %s, %d linear systems, at most "
            "%d iterations each, %.1f s, %.2f GB in process 0\n",
            ancf::petsc::Session::ranks(), n, members, statics.solver().rows(),
            std::string(to_string(report.status)).c_str(), report.iterations(),
            statics.solver().most_iterations(), now() - begin, memory());
    return report.status == ancf::Status::converged ? 0 : 1;
}
