// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Angles along a beam, counted beyond half a turn.

#pragma once

#include <ancf/model/scene.hpp>

#include <support/named_beam.hpp>

namespace examples {

/// Returns the angle by which r_x of the last node stands to the X axis in the XY plane, degrees;
/// whole turns are counted along the centre line.
[[nodiscard]] double bending_angle(const ancf::Scene& scene, const NamedBeam& beam,
                                   const ancf::Section& section);

/// Returns the angle by which r_y of the last node has turned about X, degrees; whole turns are
/// counted from node to node.
[[nodiscard]] double twist_angle(const ancf::Scene& scene, const ancf::Chain& beam);

}  // namespace examples
