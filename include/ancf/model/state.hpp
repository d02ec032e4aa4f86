// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Where a scene is: coordinates, velocities, multipliers and time. What of it is held or driven.

#pragma once

#include <ancf/model/layout.hpp>
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
