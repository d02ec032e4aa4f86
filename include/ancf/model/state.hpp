// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Where a scene is: coordinates, velocities, multipliers and time.

#pragma once

#include <ancf/types.hpp>

#include <functional>

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

/// The moment at which loads and prescribed values are evaluated.
struct Instant {
    double time = 0.0;  ///< argument of every Amplitude: s; in statics the load factor
    double ramp = 1.0;  ///< scale of the loads without an Amplitude: 1; in statics the load factor
};

}  // namespace ancf
