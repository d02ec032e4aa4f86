// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Beams of the element that a program's options name: the library's builders, compiled here once
/// for every element.

#pragma once

#include <ancf/model/builders/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/output/shape.hpp>
#include <ancf/output/surface.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

#include <support/beam.hpp>

#include <functional>
#include <vector>

namespace examples {

/// A chain of elements, and what is drawn of it as its scene stands now.
struct NamedBeam : ancf::Chain {
    static constexpr int stations = 17;  ///< per element, of what is drawn

    /// Adds its surface, with the outline of a section.
    std::function<void(const ancf::Scene&, const ancf::Section&, ancf::Surface&)> draw;

    /// Returns its shape at so many stations per element.
    std::function<std::vector<ancf::ShapeStation>(const ancf::Scene&, const ancf::Section&, int)>
        shape;
};

/// Adds a straight beam between two points.
/// @throws InvalidArgument for an element of another dimension, and as ancf::straight_beam.
template <int Dimension>
[[nodiscard]] NamedBeam straight_beam(ancf::BasicModel<Dimension>& model,
                                      const BeamOptions& options, const ancf::Material& material,
                                      const ancf::Section& section,
                                      const ancf::Vector<double, Dimension>& from,
                                      const ancf::Vector<double, Dimension>& to, int elements);

/// Adds the beam of the options from the origin along X.
template <int Dimension>
[[nodiscard]] NamedBeam straight_beam(ancf::BasicModel<Dimension>& model,
                                      const BeamOptions& options, int elements);

/// Adds an arc of a circle from the origin along X that turns towards Y; only its section and its
/// material are those of the options.
/// @throws InvalidArgument for an element that cannot be made on a curve, and as ancf::arc.
[[nodiscard]] NamedBeam arc(ancf::Model& model, const BeamOptions& options, double radius,
                            double angle, int elements);

/// Refuses values that the element does not take, before any work is done.
/// @throws InvalidArgument naming the value.
template <int Dimension>
void check(const BeamOptions& options);

/// The same in the dimension of the element.
inline void check(const BeamOptions& options) {
    options.is_planar() ? check<2>(options) : check<3>(options);
}

/// Returns a point of the plane or of space in space.
template <int Dimension>
[[nodiscard]] ancf::Vector<double, 3> in_space(const ancf::Vector<double, Dimension>& point) {
    ancf::Vector<double, 3> result = ancf::Vector<double, 3>::Zero();
    result.template head<Dimension>() = point;
    return result;
}

}  // namespace examples
