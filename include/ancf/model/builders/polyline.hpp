// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Builder of straight beams one after the other, joined rigidly at the corners.

#pragma once

#include <ancf/error.hpp>
#include <ancf/model/builders/frame.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>

#include <vector>

namespace ancf {

/// Adds straight beams through points, each of `elements` elements, joined rigidly at the corners
/// as frame() does.
///
/// The section's y axis of each piece follows reference_slopes() of its direction. The ends of the
/// line are attached to joints as well: hold and load `joints`.
/// @return the points' joints, and a member for each two neighbouring points, in order.
/// @throws InvalidArgument for fewer than two points, points that coincide or no elements.
template <class Element = void, int Dimension, class... Options>
auto polyline(BasicModel<Dimension>& model, const Material& material, const Section& section,
              const std::vector<typename BasicModel<Dimension>::Point>& through, int elements,
              const Options&... options) {
    detail::require(through.size() >= 2, "polyline: at least two points are needed, got ",
                    through.size());
    std::vector<Member> members;
    for (int k = 0; k + 1 < static_cast<int>(through.size()); ++k)
        members.push_back({k, k + 1, 0, elements});
    return frame<Element>(model, {{material, section}}, through, members, {}, options...);
}

}  // namespace ancf
