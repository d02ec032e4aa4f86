// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The order in which elements are added, the same for any number of threads.
///
/// Elements are cut into runs of consecutive ones, and runs are coloured so that two of one colour
/// share no node. Colours follow each other; the runs of one colour may go side by side. So every
/// sum has one order, and equal input gives equal bits.

#pragma once

#include <ancf/model/model.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <vector>

namespace ancf {

/// Consecutive elements [first, last) of a group.
struct ElementRun {
    int first;  ///< index of its first element
    int last;   ///< one past its last
};

/// Runs of one group, colour by colour.
class ElementSchedule {
public:
    static constexpr int run_length = 128;  ///< long enough to outweigh handing it to a thread

    ElementSchedule() = default;

    /// @param nodes  number of nodes of the model
    ElementSchedule(const std::vector<Connection>& connections, int nodes) {
        constexpr int most_colours = 63;
        std::vector<std::uint64_t> taken(static_cast<std::size_t>(nodes), 0);  // colours at a node
        const int count = static_cast<int>(connections.size());
        for (int first = 0; first < count; first += run_length) {
            const ElementRun run{first, std::min(first + run_length, count)};
            std::uint64_t met = 0;
            visit_nodes(connections, run, [&](std::size_t node) { met |= taken[node]; });
            std::size_t colour = 0;
            while (colour < most_colours && (met >> colour & 1U) != 0) ++colour;
            if (colour == most_colours) {  // crowded nodes: one run after the other
                colours_.assign(1, {});
                sequential_ = true;
                for (int k = 0; k < count; k += run_length)
                    colours_[0].push_back({k, std::min(k + run_length, count)});
                return;
            }
            visit_nodes(connections, run,
                        [&](std::size_t node) { taken[node] |= std::uint64_t{1} << colour; });
            if (colour == colours_.size()) colours_.emplace_back();
            colours_[colour].push_back(run);
        }
    }

    /// Calls visit(run, place) for every run, on several threads where the compiler has OpenMP;
    /// `place` counts the runs in the order in which they are added.
    /// @return the sum of what the calls return, added in a fixed order.
    /// @throws what the first of them threw, once all of its colour have ended.
    template <class Visitor>
    double sum(const Visitor& visit) const {
        double total = 0.0;
        std::size_t done = 0;
        for (const std::vector<ElementRun>& runs : colours_) {
            std::vector<double> parts(runs.size(), 0.0);
            std::vector<std::exception_ptr> thrown(runs.size());  // none may leave a thread
            const auto size = static_cast<std::ptrdiff_t>(runs.size());
#if defined(_OPENMP)
#pragma omp parallel for schedule(static) if (!sequential_ && size > 1)
#endif
            for (std::ptrdiff_t run = 0; run < size; ++run) {
                const auto k = static_cast<std::size_t>(run);
                try {
                    parts[k] = visit(runs[k], done + k);
                } catch (...) {
                    thrown[k] = std::current_exception();
                }
            }
            for (const std::exception_ptr& exception : thrown)
                if (exception) std::rethrow_exception(exception);
            for (const double part : parts) total += part;
            done += runs.size();
        }
        return total;
    }

    /// Calls visit(runs) with the runs of each colour, in the order in which they are added.
    template <class Visitor>
    void for_each_colour(const Visitor& visit) const {
        for (const std::vector<ElementRun>& runs : colours_) visit(runs);
    }

    /// Calls visit(node) for both nodes of every element of a run.
    template <class Visitor>
    static void visit_nodes(const std::vector<Connection>& connections, const ElementRun& run,
                            const Visitor& visit) {
        for (int k = run.first; k < run.last; ++k) {
            const Connection& connection = connections[static_cast<std::size_t>(k)];
            visit(static_cast<std::size_t>(connection.first.index));
            visit(static_cast<std::size_t>(connection.second.index));
        }
    }

    /// Returns the number of colours.
    [[nodiscard]] std::size_t colours() const noexcept { return colours_.size(); }

private:
    std::vector<std::vector<ElementRun>> colours_;
    bool sequential_ = false;
};

}  // namespace ancf
