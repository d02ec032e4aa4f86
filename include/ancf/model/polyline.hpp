// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Builder of frames: straight beams between points, joined rigidly at the corners.
///
/// A node has one tangent, so a corner is two nodes at one place with a weld between their frames.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/error.hpp>
#include <ancf/model/beam.hpp>
#include <ancf/model/constraints_joints.hpp>
#include <ancf/model/constraints_planar.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace ancf {

/// Adds straight beams through points, each of `elements` elements, welded at the corners.
///
/// The section's y axis of each piece follows reference_slopes() of its direction.
/// @return the pieces, in order: a Beam for each two neighbouring points.
/// @throws InvalidArgument for fewer than two points, points that coincide or no elements.
template <class Element = void, class... Elements, class... Options>
auto polyline(Model<Elements...>& model, const Material& material, const Section& section,
              const std::vector<typename Model<Elements...>::Point>& through, int elements,
              const Options&... options) {
    using Scene = Model<Elements...>;
    using Chosen =
        std::conditional_t<std::is_void_v<Element>, typename Scene::DefaultElement, Element>;
    static_assert(Chosen::fields.contains(Field::r_y),
                  "polyline welds sections at its corners: cables have none, join them by Pin");
    detail::require(through.size() >= 2, "polyline: at least two points are needed, got ",
                    through.size());
    std::vector<Beam<Chosen>> pieces;
    for (std::size_t k = 0; k + 1 < through.size(); ++k) {
        pieces.push_back(straight_beam<Chosen>(model, material, section, through[k], through[k + 1],
                                               elements, options...));
        if (k == 0) continue;
        const NodeId before = pieces[k - 1].last(), after = pieces[k].first();
        if constexpr (Scene::dimension == 3) {
            model.add(Weld(model, before, after));
        } else {
            model.add(PlanarWeld(model, before, after));
        }
    }
    return pieces;
}

}  // namespace ancf
