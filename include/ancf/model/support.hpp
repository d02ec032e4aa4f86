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
    full,       ///< position and slopes; a clamp says nothing of the curvature r_xx
    free_slope  ///< the same but r_x: the clamp of the paper's cantilevers
};

/// Returns the word for a field that messages use.
[[nodiscard]] constexpr const char* to_string(Field field) noexcept {
    switch (field) {
        case Field::r: return "r";
        case Field::r_x: return "r_x";
        case Field::r_y: return "r_y";
        case Field::r_z: return "r_z";
        case Field::r_xx: return "r_xx";
    }
    return "unknown";
}

}  // namespace ancf
