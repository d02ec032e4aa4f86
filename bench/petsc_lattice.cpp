// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A cubic lattice by conjugate gradients and multigrid of PETSc: iterations, memory, time; the
/// time of an assembly; and what a direct factorisation would take.
///
///     petsc_lattice 16                     16^3 joints; the solution in one step
///     mpirun -n 2 petsc_lattice 16         by two processes
///     mpirun -n 2 petsc_lattice 16 motion  ten steps of generalized-alpha, by GAMG
///     mpirun -n 2 petsc_lattice 24 assembly  15 assemblies with the sums of PETSc, in turn by all
///                                            processes and by the first one alone, which also
///                                            takes two threads where it is compiled with OpenMP
///     petsc_lattice 24 fill                entries of the factor by CHOLMOD's analysis
///
/// The variable PETSC_OPTIONS changes the solver: -lattice_pc_type hypre.

#include <ancf/assembly/assembly.hpp>
#include <ancf/element/cross_section/beam.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/loads.hpp>
#include <ancf/model/model.hpp>
#include <ancf/petsc/distributed_scene.hpp>

#include "lattices/lattice.hpp"

#include <sys/resource.h>

#if ANCF_BENCH_CHOLMOD
#include <cholmod.h>
#endif
#if defined(_OPENMP)
#include <omp.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <thread>
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

/// Waits for the other processes without taking a processor from them.
void wait_quietly() {
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibarrier(PETSC_COMM_WORLD, &request);
    for (int done = 0; MPI_Test(&request, &done, MPI_STATUS_IGNORE), done == 0;)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// A scene, or the part of one, that is assembled and handed to PETSc.
class AssemblyTask {
public:
    explicit AssemblyTask(ancf::Scene& scene)
        : scene_(scene),
          solver_(scene, {"-ksp_type cg -pc_type none", ""}),
          assembly_(scene, ancf::Storage::full),
          rest_(ancf::VectorX::Zero(scene.state().q.size())) {
        solver_.analyze(assembly_.tangent());
    }

    /// Evaluates the elements alone.
    [[nodiscard]] bool evaluate() {
        const ancf::State& state = scene_.state();
        return !assembly_.evaluate({state.q, rest_, state.multipliers, {1.0, 1.0}},
                                   ancf::Request::tangent);
    }

    [[nodiscard]] bool run() {
        return evaluate() &&
               solver_.factorize(assembly_.tangent()).status == ancf::Status::converged;
    }

private:
    ancf::Scene& scene_;
    ancf::petsc::Solver solver_;
    ancf::Assembly assembly_;
    ancf::VectorX rest_;
};

struct Times {
    std::vector<double> wall;

    void add(const std::function<bool()>& task, bool counts) {
        const double begin = now();
        if (!task()) std::exit(1);
        if (counts) wall.push_back(now() - begin);
    }
    [[nodiscard]] double median() {
        if (wall.empty()) return 0.0;
        std::sort(wall.begin(), wall.end());
        return wall[wall.size() / 2];
    }
};

/// Compares an assembly by all processes with one by the first alone, in turn.
void assemble(ancf::Model& model, ancf::petsc::DistributedScene& scene, int pairs) {
    const bool first = ancf::petsc::Session::rank() == 0;
    AssemblyTask together(scene.part());
    const std::unique_ptr<AssemblyTask> alone =
        first ? std::make_unique<AssemblyTask>(model) : nullptr;
    Times by_all, by_one, elements, in_threads;
    for (int k = 0; k <= pairs; ++k) {
        wait_quietly();
        by_all.add(
            [&] {
                const bool good = together.run();
                MPI_Barrier(PETSC_COMM_WORLD);
                return good;
            },
            k > 0);
        if (first) {
            by_one.add([&] { return alone->run(); }, k > 0);
            elements.add([&] { return alone->evaluate(); }, k > 0);
#if defined(_OPENMP)
            omp_set_num_threads(2);
            in_threads.add([&] { return alone->evaluate(); }, k > 0);
            omp_set_num_threads(1);
#endif
        }
        wait_quietly();
    }
    if (!first) return;
    const double one = by_one.median(), all = by_all.median();
    std::printf(
        "%d members, assembly, medians of %d pairs: %.3f s by one process, %.3f s by %d, ratio "
        "%.2f; elements alone %.3f s, by two threads %.3f s\n",
        model.group<Beam>().size(), pairs, one, all, ancf::petsc::Session::ranks(), one / all,
        elements.median(), in_threads.median());
}

/// Lets the lattice go in ten steps.
void move(ancf::Model& model) {
    ancf::petsc::DistributedScene scene(model, PETSC_COMM_WORLD,
                                        ancf::petsc::SolverOptions::iterative("lattice_"));
    ancf::GeneralizedAlphaOptions options;
    options.step = 1e-3;
    ancf::Schedule schedule;
    schedule.end = 1e-2;
    const ancf::DynamicsReport report = scene.integrate(schedule, options);
    if (ancf::petsc::Session::rank() == 0)
        std::printf(
            "%d processes, %d members, motion: %s, %ld steps, %ld linear systems, at most %d "
            "iterations each, %.1f s, %.2f GB in process 0 %s\n",
            ancf::petsc::Session::ranks(), model.group<Beam>().size(),
            std::string(to_string(report.status)).c_str(), report.steps, report.iterations,
            scene.solver().most_iterations(), report.seconds, memory(), report.message.c_str());
}

/// Prints how many entries the factor L of the tangent has, in CHOLMOD's best order.
void count_fill(const ancf::Model& model, int n) {
#if ANCF_BENCH_CHOLMOD
    const ancf::Assembly assembly(model, ancf::Storage::lower);
    const ancf::SparseMatrix& lower = assembly.tangent();
    cholmod_common common;
    cholmod_start(&common);
    cholmod_sparse view = {};
    view.nrow = view.ncol = static_cast<std::size_t>(lower.rows());
    view.nzmax = static_cast<std::size_t>(lower.nonZeros());
    view.p = const_cast<int*>(lower.outerIndexPtr());
    view.i = const_cast<int*>(lower.innerIndexPtr());
    view.stype = -1;
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_PATTERN;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = view.packed = 1;
    cholmod_factor* factor = cholmod_analyze(&view, &common);
    std::printf("%d^3 joints, %d unknowns: lnz %.4g, %.1f GB, status %d, order %d, %.2f GB here\n",
                n, static_cast<int>(lower.rows()), common.lnz, common.lnz * 8e-9, common.status,
                common.method[common.selected].ordering, memory());
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
#else
    std::printf("%d^3 joints, %d members: compiled without SuiteSparse\n", n,
                model.group<Beam>().size());
#endif
}

}  // namespace

int main(int argc, char** argv) {
    const int n = argc > 1 ? std::atoi(argv[1]) : 8;
    const std::string what = argc > 2 ? argv[2] : "";
    if (n < 2 || !(what.empty() || what == "fill" || what == "motion" || what == "assembly")) {
        std::fprintf(stderr, "usage: petsc_lattice [JOINTS [motion | assembly [PAIRS] | fill]]\n");
        return 2;
    }
    const ancf::petsc::Session session;
    ancf::Model model = lattice(n);
    const int members = model.group<Beam>().size();
    if (what == "fill") {
        count_fill(model, n);
        return 0;
    }
    if (what == "motion") {
        move(model);
        return 0;
    }
    ancf::petsc::DistributedScene scene(model, PETSC_COMM_WORLD,
                                        ancf::petsc::SolverOptions::iterative("lattice_"));
    if (what == "assembly") {
        assemble(model, scene, argc > 3 ? std::atoi(argv[3]) : 15);
        return 0;
    }
    const double begin = now();
    const ancf::StaticsReport report = scene.solve();
    if (ancf::petsc::Session::rank() == 0)
        std::printf(
            "%d processes, %d^3 joints, %d members, %ld rows: %s, %d linear systems, at most "
            "%d iterations each, %.1f s, %.2f GB in process 0\n",
            ancf::petsc::Session::ranks(), n, members, scene.solver().rows(),
            std::string(to_string(report.status)).c_str(), report.iterations(),
            scene.solver().most_iterations(), now() - begin, memory());
    return report.status == ancf::Status::converged ? 0 : 1;
}
