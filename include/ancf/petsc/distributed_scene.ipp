// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/dynamics/problem.hpp>
#include <ancf/error.hpp>
#include <ancf/model/attachment.hpp>
#include <ancf/output/vtk.hpp>
#include <ancf/petsc/distributed_scene.hpp>

namespace ancf::petsc {

ANCF_INLINE DistributedScene::DistributedScene(Scene& model, MPI_Comm comm,
                                               const SolverOptions& options)
    : model_(model),
      prefix_(options.prefix),
      partition_(std::make_shared<const detail::Partition>(model, comm, prefix_)),
      part_(model.part(partition_->held(), partition_)),
      solver_(*part_, options) {
    // one part alone would refuse a vector that no element has, or none would hold it
    const auto require = [&](const Coupling& coupling, const char* what) {
        ancf::detail::LocalCoordinates(model.layout(), {}, coupling, what);
    };
    for (const Support& each : model.supports()) require({{each.node, each.field}}, "support");
    for (const ScaledLoad& each : model.loads()) require(each.load.coupling(), "load");
    for (const AnyConstraint& each : model.constraints()) require(each.coupling(), "constraint");
}

ANCF_INLINE StaticsReport DistributedScene::solve(const StaticsOptions& options) {
    options.check();
    StaticsOptions own = options;
    if (options.progress)
        own.progress = [&](double factor, const State& state) {
            return all_go_on([&] { return options.progress(factor, state); });
        };
    StaticsReport report = solve_statics(*part_, solver_, own);
    if (auto& softened = report.softened)
        softened->element = partition_->element(softened->group, softened->element);
    settle(report.fault, {&report.message});
    return report;
}

ANCF_INLINE DynamicsReport DistributedScene::integrate(const Schedule& schedule,
                                                       const GeneralizedAlphaOptions& options,
                                                       const Memory& memory) {
    ancf::detail::require(model_.constraints().empty(),
                          "petsc::DistributedScene::integrate: the scene has constraints; "
                          "GeneralizedAlpha with a petsc::Solver moves it in one process");
    // blocks of M are nearly alike: some thirty iterations at any size
    Solver mass_solver(*part_, {"-ksp_type bcgs -ksp_rtol 1e-13 -ksp_max_it 1000 -pc_type pbjacobi",
                                prefix_.empty() ? prefix_ : prefix_ + "mass_"});
    ProblemOptions how;
    how.mass_solver = &mass_solver;
    DynamicProblem problem(*part_, how);
    Schedule own = schedule;
    if (schedule.observe)
        own.observe = [&](const Snapshot& seen) {
            ancf::detail::together(partition_.get(), [&] { schedule.observe(seen); });
        };
    if (schedule.progress)
        own.progress = [&](double time, double end) {
            return all_go_on([&] { return schedule.progress(time, end); });
        };
    DynamicsReport report = GeneralizedAlpha(options).integrate(problem, solver_, own, memory);
    settle(report.fault, {&report.message, &report.left_range});
    return report;
}

ANCF_INLINE void DistributedScene::gather() {
    const State& own = part_->state();
    State& all = model_.state();
    all.q = partition_->gather(own.q);
    all.v = partition_->gather(own.v);
    all.multipliers = partition_->gather_multipliers(own.multipliers);
    all.time = own.time;
}

ANCF_INLINE void DistributedScene::write_vtk(const std::filesystem::path& file,
                                             const Surface& surface, double time) const {
    ancf::detail::require(file.extension() == ".pvtu",
                          "the file that lists the pieces of a surface ends in .pvtu, got ",
                          file.string());
    const auto piece = [&](std::size_t rank) {
        return file.stem().string() + '_' + std::to_string(rank) + ".vtu";
    };
    const std::size_t rank = Session::rank(partition_->comm());
    const bool shows = !surface.ends().empty();
    std::vector<double> all(Session::ranks(partition_->comm()), 0.0);
    all[rank] = shows ? 1.0 : 0.0;
    partition_->sum(all.data(), static_cast<int>(all.size()));
    ancf::detail::together(partition_.get(), [&] {
        if (shows) ancf::write_vtk(file.parent_path() / piece(rank), surface, time);
        if (rank != 0) return;
        std::vector<std::string> pieces;
        for (std::size_t k = 0; k < all.size(); ++k)
            if (all[k] > 0.0) pieces.push_back(piece(k));
        write_vtk_pieces(file, surface, pieces);
    });
}

// Calls a function that says whether to go on; one process that says no, or throws, ends all.
ANCF_INLINE bool DistributedScene::all_go_on(const std::function<bool()>& call) const {
    return ancf::detail::largest_of(*partition_, [&] { return call() ? 0.0 : 1.0; }) == 0.0;
}

// Gives a fault its element's number in the whole scene, and every process the texts of the first
// that has the fault, else of the first that has one.
ANCF_INLINE void DistributedScene::settle(std::optional<Fault>& fault,
                                          std::initializer_list<std::string*> texts) const {
    const bool knows = fault && fault->group > -2;
    if (fault && fault->element >= 0)
        fault->element = partition_->element(fault->group, fault->element);
    const MPI_Comm comm = partition_->comm();
    const int ranks = Session::ranks(comm);
    for (std::string* const text : texts) {
        int speaker = Session::rank(comm) + ranks * (text->empty() ? 2 : knows ? 0 : 1);
        MPI_Allreduce(MPI_IN_PLACE, &speaker, 1, MPI_INT, MPI_MIN, comm);
        int size = static_cast<int>(text->size());
        MPI_Bcast(&size, 1, MPI_INT, speaker % ranks, comm);
        text->resize(size);
        MPI_Bcast(text->data(), size, MPI_CHAR, speaker % ranks, comm);
    }
}

}  // namespace ancf::petsc
