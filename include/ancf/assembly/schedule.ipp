// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// ElementSchedule: definitions.

#pragma once

#include <ancf/assembly/schedule.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ancf {

ANCF_INLINE ElementSchedule::ElementSchedule(const std::vector<Connection>& connections, int nodes,
                                             const Followed& followed) {
    constexpr int most_colours = 63;
    std::vector<std::uint64_t> taken(static_cast<std::size_t>(nodes), 0);  // colours at a node
    const int count = static_cast<int>(connections.size());
    for (int first = 0; first < count; first += run_length) {
        const ElementRun run{first, std::min(first + run_length, count)};
        std::uint64_t met = 0;
        visit_nodes(connections, run, followed, [&](std::size_t node) { met |= taken[node]; });
        std::size_t colour = 0;
        while (colour < most_colours && (met >> colour & 1U) != 0) ++colour;
        if (colour == most_colours) {  // crowded nodes: one run after the other
            colours_.assign(1, {});
            sequential_ = true;
            for (int k = 0; k < count; k += run_length)
                colours_[0].push_back({k, std::min(k + run_length, count)});
            return;
        }
        visit_nodes(connections, run, followed,
                    [&](std::size_t node) { taken[node] |= std::uint64_t{1} << colour; });
        if (colour == colours_.size()) colours_.emplace_back();
        colours_[colour].push_back(run);
    }
}

}  // namespace ancf
