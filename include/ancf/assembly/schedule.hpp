// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The order in which elements are added, the same for any number of threads.
///
/// Elements are cut into runs of consecutive ones, and runs are coloured so that two of one colour
/// share no node, nor one that their nodes follow. Colours follow each other; the runs of one
/// colour may go side by side. So every sum has one order, and equal input gives equal bits.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/list.hpp>
#include <ancf/model/element_group.hpp>

#include <cstddef>
#include <exception>

namespace ancf {

/// Runs of one group, colour by colour.
class ElementSchedule {
public:
    static constexpr int run_length = 128;  ///< long enough to outweigh handing it to a thread

    ElementSchedule() = default;

    /// Nodes that each node follows by attachments; none: no node follows another one.
    using Followed = List<List<int>>;

    /// @param nodes  number of nodes of the model
    ElementSchedule(const List<Connection>& connections, int nodes, const Followed& followed = {});

    /// Calls visit(run, place) for every run, on several threads where the compiler has OpenMP;
    /// `place` counts the runs in the order in which they are added.
    /// @return the sum of what the calls return, added in a fixed order.
    /// @throws what the first of them threw; on threads once all of its colour have ended.
    template <class Visitor>
    double sum(const Visitor& visit) const;

    /// Returns the runs in the order in which they are added, colour by colour.
    [[nodiscard]] const List<ElementRun>& runs() const noexcept { return runs_; }
    /// Returns the number of runs up to the end of each colour.
    [[nodiscard]] const List<std::size_t>& colours() const noexcept { return colours_; }

    /// Calls visit(node) for both nodes of every element of a run, and for those they follow.
    template <class Visitor>
    static void visit_nodes(const List<Connection>& connections, const ElementRun& run,
                            const Followed& followed, const Visitor& visit) {
        for (int k = run.first; k < run.last; ++k) {
            const Connection& connection = connections[k];
            for (const NodeId id : {connection.first, connection.second}) {
                const auto node = static_cast<std::size_t>(id.index);
                visit(node);
                if (followed.empty()) continue;
                for (const int other : followed[node]) visit(static_cast<std::size_t>(other));
            }
        }
    }

private:
    List<ElementRun> runs_;
    List<std::size_t> colours_;
    bool sequential_ = false;
};

template <class Visitor>
double ElementSchedule::sum(const Visitor& visit) const {
    double total = 0.0;
    std::size_t first = 0;
    for (const std::size_t last : colours_) {
        if (sequential_ || last - first == 1) {  // even a team of one thread costs a system call
            for (; first < last; ++first) total += visit(runs_[first], first);
            continue;
        }
        List<double> parts(last - first, 0.0);
        std::exception_ptr thrown;  // none may leave a thread
        const auto size = static_cast<std::ptrdiff_t>(parts.size());
        std::ptrdiff_t thrower = size;
#if defined(_OPENMP)
#pragma omp parallel for schedule(static)
#endif
        for (std::ptrdiff_t run = 0; run < size; ++run) {
            const auto k = static_cast<std::size_t>(run);
            try {
                parts[k] = visit(runs_[first + k], first + k);
            } catch (...) {
#if defined(_OPENMP)
#pragma omp critical(ancf_schedule)
#endif
                if (run < thrower) {
                    thrower = run;
                    thrown = std::current_exception();
                }
            }
        }
        if (thrown) std::rethrow_exception(thrown);
        for (const double part : parts) total += part;
        first = last;
    }
    return total;
}

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/assembly/schedule.ipp>
#endif
