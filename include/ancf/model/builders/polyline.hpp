// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Builder of frames: straight beams between points, joined rigidly at the corners.
///
/// A node has one tangent, so a corner is two nodes at one place with a weld between their frames.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/error.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/model/node.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

#include <cstddef>
#include <vector>

namespace ancf {

namespace detail {

/// Joins two nodes rigidly.
void weld(BasicModel<2>& model, NodeId a, NodeId b);
void weld(BasicModel<3>& model, NodeId a, NodeId b);

}  // namespace detail

/// Adds straight beams through points, each of `elements` elements, welded at the corners.
///
/// The section's y axis of each piece follows reference_slopes() of its direction.
/// @return the pieces, in order: a Beam for each two neighbouring points.
/// @throws InvalidArgument for fewer than two points, points that coincide or no elements.
template <class Element = void, int Dimension, class... Options>
auto polyline(BasicModel<Dimension>& model, const Material& material, const Section& section,
              const std::vector<typename BasicModel<Dimension>::Point>& through, int elements,
              const Options&... options) {
    using Chosen = detail::named_element_t<Element, Dimension>;
    static_assert(Chosen::fields.contains(Field::r_y),
                  "polyline welds sections at its corners: cables have none, join them by Pin");
    detail::require(through.size() >= 2, "polyline: at least two points are needed, got ",
                    through.size());
    std::vector<Beam<Chosen>> pieces;
    for (std::size_t k = 0; k + 1 < through.size(); ++k) {
        pieces.push_back(straight_beam<Chosen>(model, material, section, through[k], through[k + 1],
                                               elements, options...));
        if (k > 0) detail::weld(model, pieces[k - 1].last(), pieces[k].first());
    }
    return pieces;
}

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/builders/polyline.ipp>  // IWYU pragma: export
#endif
