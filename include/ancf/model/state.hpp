// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Where a scene is: coordinates, velocities, multipliers and time. What of it is held or driven.

#pragma once

#include <ancf/error.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace ancf {

/// The state of a model.
struct State {
    VectorX q;            ///< coordinates of all nodes, node by node, fields in order; m and 1
    VectorX v;            ///< their rates, m/s and 1/s
    VectorX multipliers;  ///< one per constraint equation; N for an equation in m
    double time = 0.0;    ///< s
};

/// A function of time (of the load factor in statics).
using Amplitude = std::function<double(double)>;

/// Returns lines between points, constant before the first and behind the last.
/// @param points  time, s, and value, by rising time.
/// @throws InvalidArgument unless there are points, finite and of rising times.
[[nodiscard]] inline Amplitude tabular(std::vector<std::pair<double, double>> points) {
    detail::require(!points.empty(), "tabular: at least one point is needed");
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto [time, value] = points[k];
        detail::require(std::isfinite(time) && std::isfinite(value), "tabular: point ", k,
                        " must be finite, got ", time, ", ", value);
        detail::require(k == 0 || time > points[k - 1].first, "tabular: times must rise, point ", k,
                        " is at ", time, " s, the one before at ", points[k - 1].first, " s");
    }
    return [points = std::move(points)](double time) {
        const auto next = std::upper_bound(
            points.begin(), points.end(), time,
            [](double now, const std::pair<double, double>& point) { return now < point.first; });
        if (next == points.begin()) return next->second;
        const auto last = next - 1;
        if (next == points.end()) return last->second;
        const double share = (time - last->first) / (next->first - last->first);
        return last->second + share * (next->second - last->second);
    };
}

/// The moment at which loads and prescribed values are evaluated.
struct Instant {
    double time = 0.0;  ///< argument of every Amplitude: s; in statics the load factor
    double ramp = 1.0;  ///< scale of the loads without an Amplitude: 1; in statics the load factor
};

/// One held or driven component of a nodal vector: it is no unknown.
struct Support {
    NodeId node;             ///< where
    Field field;             ///< which vector
    int component;           ///< from 0
    Amplitude value;         ///< the coordinate over time; empty: it stays where it stands
    Amplitude rate;          ///< first derivative; dynamics needs it where value is given
    Amplitude acceleration;  ///< second derivative; dynamics needs it where value is given
};

/// What a clamp holds of a node.
enum class Clamp {
    full,       ///< position and slopes: with r_x and r_y held the shear strain and the axis'
                ///< axial strain are zero at the node, docs/theory.md, "Section forces": a beam
                ///< with an eccentric axis takes free_slope. r_xx and r_xy stay free
    free_slope  ///< position and slopes but r_x: the clamp of the paper's cantilevers. Of a
                ///< TorsionBeam, whose frame turns with r_x, it is a hinge
};

}  // namespace ancf
