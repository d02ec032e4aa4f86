// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Supports: coordinates that are held or driven, and so are no unknowns.

#pragma once

#include <ancf/model/node.hpp>
#include <ancf/model/state.hpp>

namespace ancf {

/// One held or driven component of a nodal vector.
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
    full,       ///< position and slopes; with r_x as well as r_y held the shear strain is zero
                ///< there, see docs/theory.md, "Section forces". Nothing of the curvature r_xx
    free_slope  ///< the same but r_x: the clamp of the paper's cantilevers. Of TorsionBeam, whose
                ///< frame turns with r_x, it is a hinge
};

}  // namespace ancf
