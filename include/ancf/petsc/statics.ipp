// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of statics.hpp.

#pragma once

#include <ancf/error.hpp>
#include <ancf/petsc/statics.hpp>

#include <exception>
#include <stdexcept>
#include <string>

namespace ancf::petsc {

namespace detail {

/// Gives every process the text of the first that has one.
ANCF_INLINE void share_text(MPI_Comm comm, std::string& text) {
    int first = text.empty() ? Session::ranks(comm) : Session::rank(comm);
    MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, comm);
    if (first == Session::ranks(comm)) return;
    int size = static_cast<int>(text.size());
    MPI_Bcast(&size, 1, MPI_INT, first, comm);
    text.resize(static_cast<std::size_t>(size));
    MPI_Bcast(text.data(), size, MPI_CHAR, first, comm);
}

}  // namespace detail

ANCF_INLINE DistributedStatics::DistributedStatics(Scene& model, MPI_Comm comm,
                                                   const SolverOptions& options)
    : model_(model),
      partition_((detail::require_session(),
                  std::make_shared<const detail::Partition>(model, comm, options.prefix))),
      part_(model.part(partition_->held(), partition_)),
      solver_(*part_, options) {}

ANCF_INLINE StaticsReport DistributedStatics::solve(const StaticsOptions& options) {
    options.check();
    ancf::detail::require(options.newton != NewtonKind::turned,
                          "petsc::DistributedStatics: NewtonKind::turned ties all nodes of a "
                          "scene; take mixed or plain");
    StaticsOptions own = options;
    if (options.progress)
        own.progress = [&](double factor, const State& state) {
            double stop = 0.0;  // 1: asked for, 2: threw
            std::exception_ptr thrown;
            try {
                stop = options.progress(factor, state) ? 0.0 : 1.0;
            } catch (...) {
                thrown = std::current_exception();
                stop = 2.0;
            }
            stop = partition_->largest(stop);
            if (thrown) std::rethrow_exception(thrown);
            if (stop == 2.0) throw std::runtime_error("progress threw in another process");
            return stop == 0.0;
        };
    StaticsReport report = solve_statics(*part_, solver_, own);
    const auto whole = [&](int group, int& element) {
        if (group >= 0 && element >= 0)
            element =
                partition_->held()
                    .elements[static_cast<std::size_t>(group)][static_cast<std::size_t>(element)];
    };
    if (report.softened) whole(report.softened->group, report.softened->element);
    // the process whose element failed knows best
    const bool knows = report.fault && report.fault->element >= 0;
    if (knows) {
        whole(report.fault->group, report.fault->element);
        report.message = ancf::detail::joined(
            {"element ", report.fault->element, " of the type ",
             model_.groups()[static_cast<std::size_t>(report.fault->group)]->name(), " is ",
             to_string(report.fault->status)});
    }
    std::string known = knows ? report.message : std::string();
    detail::share_text(partition_->comm(), known);
    if (known.empty()) detail::share_text(partition_->comm(), report.message);
    if (!known.empty()) report.message = known;
    return report;
}

ANCF_INLINE void DistributedStatics::gather() {
    const State& own = part_->state();
    State& all = model_.state();
    all.q = partition_->gather(own.q);
    all.v = partition_->gather(own.v);
    all.multipliers = partition_->gather_multipliers(own.multipliers);
    all.time = own.time;
}

}  // namespace ancf::petsc
