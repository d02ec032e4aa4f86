// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Builders of beams whose stress-free state is a curve, twisted or not: arcs, helices, splines.
///
/// Each element is made from the nodal coordinates of that state, so it is free of force there.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace ancf {

/// A node of a reference curve: position, m, and slopes r_x, r_y (and r_z) as columns.
///
/// r_y (and r_z) are the section's axes: of unit length, normal to r_x and to each other. Others
/// are taken, as a section that is sheared or stretched so without stress.
template <int Dimension>
struct CurvePoint {
    Vector<double, Dimension> position;  ///< m
    Matrix<double, Dimension> slopes;    ///< columns r_x, r_y (and r_z) of the stress-free state
    /// r_xx of the stress-free state, 1/m: what a quintic centre line takes, and no other.
    Vector<double, Dimension> curvature = Vector<double, Dimension>::Zero();
};

namespace detail {

/// A reference curve by its nodes.
template <int Dimension>
struct Curve {
    std::vector<CurvePoint<Dimension>> points;
    std::vector<double> lengths;  ///< parameter range of each element, or of all
};

/// Returns the reference slopes of two directions that a builder was given.
/// @param names  of the builder and of them, for the message
/// @throws InvalidArgument where one has no length or they are parallel.
[[nodiscard]] Matrix<double, 3> slopes_of(const char* names, const Vector<double, 3>& direction,
                                          const Vector<double, 3>& y_axis);

/// The curves of the builders below. They throw what the builders document.
/// @param start  slopes of the first node; the arc turns from the first to the second of them
template <int Dimension>
[[nodiscard]] Curve<Dimension> arc_curve(const Vector<double, Dimension>& from,
                                         const Matrix<double, Dimension>& start, double radius,
                                         double angle, int elements);
ANCF_LAZY [[nodiscard]] Curve<3> helix_curve(const Vector<double, 3>& centre,
                                             const Vector<double, 3>& axis,
                                             const Vector<double, 3>& outward, double radius,
                                             double pitch, double turns, int elements);
ANCF_LAZY [[nodiscard]] Curve<3> spline_curve(const std::vector<Vector<double, 3>>& through,
                                              const Vector<double, 3>& y_axis);

/// Adds the nodes of a curve.
template <int Dimension>
[[nodiscard]] std::vector<NodeId> add_curve_nodes(BasicModel<Dimension>& model,
                                                  const std::vector<CurvePoint<Dimension>>& points,
                                                  const std::vector<double>& lengths);

/// Checks that elements which share a prototype are equal.
/// @param fields  that the elements carry at a node
/// @throws InvalidArgument where a single length is given and an element is not the first one but
///         for a rigid motion.
template <int Dimension>
void check_equal_elements(Fields fields, const std::vector<CurvePoint<Dimension>>& points,
                          const std::vector<double>& lengths);

/// Writes an element's coordinates from the curve points at its ends.
template <int Dimension>
void reference_coordinates(Fields fields, const CurvePoint<Dimension>& first,
                           const CurvePoint<Dimension>& second, double* e);

}  // namespace detail

/// Adds a beam through given points, one element between each two.
///
/// @param lengths  parameter range of each element, m: with unit slopes r_x the arc length. One
///                 entry: all elements are equal up to a rigid motion and share one prototype.
/// @throws InvalidArgument for fewer than two points, a number of lengths that does not fit, or one
///         length and elements that are not equal.
template <class Element = void, int Dimension, class... Options>
auto beam_through(BasicModel<Dimension>& model, const Material& material, const Section& section,
                  const std::vector<CurvePoint<Dimension>>& points,
                  const std::vector<double>& lengths, Options&&... options) {
    using Chosen = detail::named_element_t<Element, Dimension>;
    Beam<Chosen> beam;
    detail::check_equal_elements<Dimension>(Chosen::fields, points, lengths);
    beam.nodes = detail::add_curve_nodes<Dimension>(model, points, lengths);
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        if (k < lengths.size()) {
            typename Chosen::Coordinates e;
            detail::reference_coordinates(Chosen::fields, points[k], points[k + 1], e.data());
            beam.prototypes.push_back(model.add_prototype(
                detail::made_element<Chosen>(material, section, e, lengths[k], options...)));
        }
        detail::connect_next(model, beam);
    }
    return beam;
}

/// Adds an arc of a circle in space.
///
/// It starts at `from` along `tangent` and turns towards `normal` (made normal to the tangent) by
/// `angle`, rad, on the given radius, m. The section's y axis points along the normal, to the
/// centre.
/// @throws InvalidArgument for a radius, an angle or elements not positive, or parallel directions.
template <class Element = void, int Dimension, class... Options>
auto arc(BasicModel<Dimension>& model, const Material& material, const Section& section,
         const VectorArgument<3>& from, const VectorArgument<3>& tangent,
         const VectorArgument<3>& normal, double radius, double angle, int elements,
         Options&&... options) {
    static_assert(Dimension == 3,
                  "an arc takes a normal in space alone: leave it out in the plane");
    detail::require_positive("arc: angle", angle);
    const auto curve =
        detail::arc_curve<3>(from, detail::slopes_of("arc: tangent and normal", tangent, normal),
                             radius, angle, elements);
    return beam_through<Element>(model, material, section, curve.points, curve.lengths,
                                 std::forward<Options>(options)...);
}

/// Adds an arc of a circle in the plane, m and rad; a positive angle turns counterclockwise.
/// @throws InvalidArgument for a radius or elements that are not positive, or an angle of zero.
template <class Element = void, int Dimension, class... Options>
auto arc(BasicModel<Dimension>& model, const Material& material, const Section& section,
         const VectorArgument<2>& from, const VectorArgument<2>& tangent, double radius,
         double angle, int elements, Options&&... options) {
    static_assert(Dimension == 2,
                  "an arc in space takes: from, tangent, normal, radius, angle, elements");
    const auto curve =
        detail::arc_curve<2>(from, reference_slopes(tangent), radius, angle, elements);
    return beam_through<Element>(model, material, section, curve.points, curve.lengths,
                                 std::forward<Options>(options)...);
}

/// Adds a helix about the axis through `centre`, starting at `centre` + radius `outward`.
///
/// The section's y axis points to the axis of the helix.
/// @param pitch  advance along the axis per turn, m, of either sign.  @param turns  > 0
/// @throws InvalidArgument for radius, turns or elements not positive, or parallel directions.
template <class Element = void, int Dimension, class... Options>
auto helix(BasicModel<Dimension>& model, const Material& material, const Section& section,
           const VectorArgument<3>& centre, const VectorArgument<3>& axis,
           const VectorArgument<3>& outward, double radius, double pitch, double turns,
           int elements, Options&&... options) {
    static_assert(Dimension == 3, "a helix needs a model in space");
    const auto curve = detail::helix_curve(centre, axis, outward, radius, pitch, turns, elements);
    return beam_through<Element>(model, material, section, curve.points, curve.lengths,
                                 std::forward<Options>(options)...);
}

/// Adds a smooth beam through points, one element between each two.
///
/// Tangents are those of the parabola through each point and its neighbours over the chord lengths.
/// From node to node the section turns by the smallest rotation of the tangent. Points are in m.
/// @param y_axis  section's y direction at the first point, made normal to the tangent there
/// @throws InvalidArgument for fewer than two points, points that coincide, or parallel directions.
template <class Element = void, int Dimension, class... Options>
auto spline(BasicModel<Dimension>& model, const Material& material, const Section& section,
            const std::vector<Vector<double, 3>>& through, const VectorArgument<3>& y_axis,
            Options&&... options) {
    static_assert(Dimension == 3, "a spline needs a model in space: in the plane, beam_through");
    const auto curve = detail::spline_curve(through, y_axis);
    return beam_through<Element>(model, material, section, curve.points, curve.lengths,
                                 std::forward<Options>(options)...);
}

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/builders/curve.ipp>  // IWYU pragma: export
#endif
