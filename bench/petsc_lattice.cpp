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

#include "lattices/lattice.hpp"

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

/// A cube of n^3 joints on clamped feet, pushed aside and down.
ancf::Model lattice(int n) {
    const ancf::bench::Lattice cube{n, n, n};
    const std::vector<Point> points = cube.points();
    std::vector<ancf::Member> members = cube.members(1);
    // between clamped joints nothing moves
    members.erase(std::remove_if(members.begin(), members.end(),
                                 [n](const ancf::Member& m) { return m.second < n * n; }),
                  members.end());
    ancf::Model model;
    const auto frame = ancf::frame<Beam>(model, {ancf::bench::Lattice::bar()}, points, members, {},
                                         ancf::CrossSectionOptions::best());
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

void assemble(ancf::petsc::DistributedStatics& statics, int members) {
    ancf::petsc::Solver solver(statics.part(), {"-ksp_type cg -pc_type none", ""});
    ancf::Assembly assembly(statics.part(), ancf::Storage::full);
    const ancf::State& state = statics.part().state();
    const ancf::VectorX rest = ancf::VectorX::Zero(state.q.size());
    std::vector<double> wall, processor;
    for (int k = 0; k < 16; ++k) {
        MPI_Barrier(PETSC_COMM_WORLD);
        const double begin = now(), begin_processor = ancf::bench::seconds();
        const auto fault = assembly.evaluate({state.q, rest, state.multipliers, {1.0, 1.0}},
                                             ancf::Request::tangent);
        if (k == 0) solver.analyze(assembly.tangent());
        if (fault || solver.factorize(assembly.tangent()).status != ancf::Status::converged) return;
        if (k == 0) continue;
        processor.push_back(ancf::bench::seconds() - begin_processor);
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
