// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/assembly/schedule.hpp>
#include <ancf/list.hpp>

#include <algorithm>
#include <cstdint>

namespace ancf {

ANCF_INLINE ElementSchedule::ElementSchedule(const List<Connection>& connections, int nodes,
                                             const Followed& followed) {
    constexpr int most_colours = 63;
    List<std::uint64_t> taken(static_cast<std::size_t>(nodes), 0);  // colours at a node
    List<std::size_t> colour_of;                                    // of each run
    std::size_t most = 0;
    const int count = static_cast<int>(connections.size());
    for (int first = 0; first < count; first += run_length) {
        const ElementRun run{first, std::min(first + run_length, count)};
        std::uint64_t met = 0;
        visit_nodes(connections, run, followed, [&](std::size_t node) { met |= taken[node]; });
        std::size_t colour = 0;
        while (colour < most_colours && (met >> colour & 1U) != 0) ++colour;
        sequential_ = colour == most_colours;  // crowded nodes: one run after the other
        if (sequential_) break;
        visit_nodes(connections, run, followed,
                    [&](std::size_t node) { taken[node] |= std::uint64_t{1} << colour; });
        colour_of.push_back(colour);
        most = std::max(most, colour + 1);
    }
    if (sequential_) {
        most = 1;
        const std::size_t length{run_length};
        colour_of.assign((connections.size() + length - 1) / length, 0);
    }
    for (std::size_t colour = 0; colour < most; ++colour) {
        int first = 0;
        for (const std::size_t own : colour_of) {
            if (own == colour) runs_.push_back({first, std::min(first + run_length, count)});
            first += run_length;
        }
        colours_.push_back(runs_.size());
    }
}

}  // namespace ancf
