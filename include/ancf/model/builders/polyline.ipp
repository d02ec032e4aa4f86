// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Builder of frames: definitions.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/model/builders/polyline.hpp>
#include <ancf/model/constraints/joints.hpp>
#include <ancf/model/constraints/planar.hpp>

namespace ancf::detail {

ANCF_INLINE void weld(BasicModel<2>& model, NodeId a, NodeId b) {
    model.add(PlanarWeld(model, a, b));
}

ANCF_INLINE void weld(BasicModel<3>& model, NodeId a, NodeId b) { model.add(Weld(model, a, b)); }

}  // namespace ancf::detail
