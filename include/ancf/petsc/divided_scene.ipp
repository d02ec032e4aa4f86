// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of divided_scene.hpp.

#pragma once

#include <ancf/error.hpp>
#include <ancf/output/vtk.hpp>
#include <ancf/petsc/divided_scene.hpp>

#include <cstddef>

namespace ancf::petsc::detail {

ANCF_INLINE DividedScene::DividedScene(Scene& model, MPI_Comm comm, const SolverOptions& options)
    : model_(model),
      partition_(std::make_shared<const Partition>(model, comm, options.prefix)),
      part_(model.part(partition_->held(), partition_)),
      solver_(*part_, options) {}

ANCF_INLINE void DividedScene::gather() {
    const State& own = part_->state();
    State& all = model_.state();
    all.q = partition_->gather(own.q);
    all.v = partition_->gather(own.v);
    all.multipliers = partition_->gather_multipliers(own.multipliers);
    all.time = own.time;
}

ANCF_INLINE bool DividedScene::all_go_on(const std::function<bool()>& call) const {
    bool goes_on = true;
    ancf::detail::together(partition_.get(), [&] { goes_on = call(); });
    return partition_->largest(goes_on ? 0.0 : 1.0) == 0.0;
}

ANCF_INLINE void DividedScene::settle(std::optional<Fault>& fault, std::string& message) const {
    const bool knows = fault && fault->element >= 0;
    if (knows) fault->element = partition_->element(fault->group, fault->element);
    // by the first that knows the element, else the first that has a text
    const MPI_Comm comm = partition_->comm();
    const int ranks = Session::ranks(comm);
    int speaker = Session::rank(comm) + ranks * (message.empty() ? 2 : knows ? 0 : 1);
    MPI_Allreduce(MPI_IN_PLACE, &speaker, 1, MPI_INT, MPI_MIN, comm);
    int size = static_cast<int>(message.size());
    MPI_Bcast(&size, 1, MPI_INT, speaker % ranks, comm);
    message.resize(static_cast<std::size_t>(size));
    MPI_Bcast(message.data(), size, MPI_CHAR, speaker % ranks, comm);
}

ANCF_INLINE void DividedScene::write_vtk(const std::filesystem::path& file, const Surface& surface,
                                         double time) const {
    ancf::detail::require(file.extension() == ".pvtu",
                          "the file that lists the pieces of a surface ends in .pvtu, got ",
                          file.string());
    const auto piece = [&](int rank) {
        return file.stem().string() + '_' + std::to_string(rank) + ".vtu";
    };
    const int rank = Session::rank(partition_->comm());
    std::vector<double> shows(static_cast<std::size_t>(Session::ranks(partition_->comm())), 0.0);
    shows[static_cast<std::size_t>(rank)] = surface.ends().empty() ? 0.0 : 1.0;
    partition_->sum(shows.data(), static_cast<int>(shows.size()));
    ancf::detail::together(partition_.get(), [&] {
        if (!surface.ends().empty())
            ancf::write_vtk(file.parent_path() / piece(rank), surface, time);
        if (rank != 0) return;
        std::vector<std::string> pieces;
        for (std::size_t k = 0; k < shows.size(); ++k)
            if (shows[k] > 0.0) pieces.push_back(piece(static_cast<int>(k)));
        write_vtk_pieces(file, surface, pieces);
    });
}

}  // namespace ancf::petsc::detail
