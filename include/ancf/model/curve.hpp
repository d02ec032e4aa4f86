// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Builders of beams whose stress-free state is a curve, twisted or not: arcs, helices, splines.
///
/// Each element is made from the nodal coordinates of that state, so it is free of force there.

#pragma once

#include <ancf/constants.hpp>
#include <ancf/error.hpp>
#include <ancf/model/beam.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace ancf {

/// A node of a reference curve: position, m, and slopes r_x, r_y (and r_z) as columns.
template <int Dimension>
struct CurvePoint {
    Vector<double, Dimension> position;  ///< m
    Matrix<double, Dimension> slopes;    ///< columns r_x, r_y (and r_z) of the stress-free state
    /// r_xx of the stress-free state, 1/m: what a quintic centre line takes, and no other.
    Vector<double, Dimension> curvature = Vector<double, Dimension>::Zero();
};

namespace detail {

/// Returns an element's coordinates from the curve points at its ends.
template <class Element>
[[nodiscard]] typename Element::Coordinates reference_coordinates(
    const CurvePoint<Element::dimension>& first, const CurvePoint<Element::dimension>& second) {
    constexpr int dimension = Element::dimension;
    typename Element::Coordinates e;
    int at = 0;
    for (const auto* point : {&first, &second})
        for (int k = 0; k < field_count; ++k) {
            if (!Element::fields.contains(static_cast<Field>(k))) continue;
            const auto field = static_cast<Field>(k);
            e.template segment<dimension>(at) = field == Field::r      ? point->position
                                                : field == Field::r_xx ? point->curvature
                                                                       : point->slopes.col(k - 1);
            at += dimension;
        }
    return e;
}

}  // namespace detail

/// Adds a beam through given points, one element between each two.
///
/// @param lengths  parameter range of each element, m: with unit slopes r_x the arc length. One
///                 entry: all elements are equal up to a rigid motion and share one prototype.
/// @throws InvalidArgument for fewer than two points or a number of lengths that does not fit.
template <class Element = void, class... Elements, class... Options>
auto beam_through(Model<Elements...>& model, const Material& material, const Section& section,
                  const std::vector<CurvePoint<Model<Elements...>::dimension>>& points,
                  const std::vector<double>& lengths, Options&&... options) {
    using Scene = Model<Elements...>;
    using Chosen =
        std::conditional_t<std::is_void_v<Element>, typename Scene::DefaultElement, Element>;
    detail::require(points.size() >= 2, "beam_through: at least two points are needed, got ",
                    points.size());
    detail::require(lengths.size() == 1 || lengths.size() + 1 == points.size(),
                    "beam_through: expected one length or ", points.size() - 1, ", got ",
                    lengths.size());
    Beam<Chosen> beam;
    for (const auto& point : points)
        beam.nodes.push_back(model.add_node(point.position, point.slopes, point.curvature));
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        if (k < lengths.size())
            beam.prototypes.push_back(model.add_prototype(Chosen(
                material, section, detail::reference_coordinates<Chosen>(points[k], points[k + 1]),
                lengths[k], options...)));
        beam.elements.push_back(model.template connect<Chosen>(beam.prototypes.back(),
                                                               beam.nodes[k], beam.nodes[k + 1]));
    }
    return beam;
}

/// Adds an arc of a circle in space.
///
/// It starts at `from` along `tangent` and turns towards `normal` (made normal to the tangent) by
/// `angle`, rad, on the given radius, m. The section's y axis points along the normal, to the
/// centre.
/// @throws InvalidArgument for a radius or an angle that is not positive, or parallel directions.
template <class Element = void, class... Elements, class... Options>
auto arc(Model<Elements...>& model, const Material& material, const Section& section,
         const VectorArgument<3>& from, const VectorArgument<3>& tangent,
         const VectorArgument<3>& normal, double radius, double angle, int elements,
         Options&&... options) {
    detail::require_positive("arc: radius", radius);
    detail::require_positive("arc: angle", angle);
    detail::require(elements >= 1, "arc: at least one element is needed, got ", elements);
    const Matrix<double, 3> start = reference_slopes(tangent, normal);
    std::vector<CurvePoint<3>> points;
    for (int k = 0; k <= elements; ++k) {
        const double turn = angle * k / elements;
        Matrix<double, 3> rotation;
        rotation << std::cos(turn), -std::sin(turn), 0.0, std::sin(turn), std::cos(turn), 0.0, 0.0,
            0.0, 1.0;
        points.push_back({from + start * Vector<double, 3>(radius * std::sin(turn),
                                                           radius * (1.0 - std::cos(turn)), 0.0),
                          start * rotation, start * rotation.col(1) / radius});
    }
    return beam_through<Element>(model, material, section, points, {radius * angle / elements},
                                 std::forward<Options>(options)...);
}

/// Adds an arc of a circle in the plane; a positive angle turns counterclockwise.
/// @throws InvalidArgument for a radius that is not positive or an angle of zero.
template <class Element = void, class... Elements, class... Options>
auto arc(Model<Elements...>& model, const Material& material, const Section& section,
         const VectorArgument<2>& from, const VectorArgument<2>& tangent, double radius,
         double angle, int elements, Options&&... options) {
    detail::require_positive("arc: radius", radius);
    detail::require(std::isfinite(angle) && angle != 0.0, "arc: the angle must not be zero, got ",
                    angle);
    detail::require(elements >= 1, "arc: at least one element is needed, got ", elements);
    const Matrix<double, 2> start = reference_slopes(tangent);
    const double side = angle > 0.0 ? 1.0 : -1.0;
    std::vector<CurvePoint<2>> points;
    for (int k = 0; k <= elements; ++k) {
        const double turn = angle * k / elements;
        Matrix<double, 2> rotation;
        rotation << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn);
        points.push_back({from + start * Vector<double, 2>(side * radius * std::sin(turn),
                                                           side * radius * (1.0 - std::cos(turn))),
                          start * rotation, side / radius * (start * rotation.col(1))});
    }
    return beam_through<Element>(model, material, section, points,
                                 {radius * std::abs(angle) / elements},
                                 std::forward<Options>(options)...);
}

/// Adds a helix about the axis through `centre`, starting at `centre` + radius `outward`.
///
/// The section's y axis points to the axis of the helix.
/// @param pitch  advance along the axis per turn, m, of either sign.  @param turns  > 0
/// @throws InvalidArgument for a radius or turns that are not positive, or parallel directions.
template <class Element = void, class... Elements, class... Options>
auto helix(Model<Elements...>& model, const Material& material, const Section& section,
           const VectorArgument<3>& centre, const VectorArgument<3>& axis,
           const VectorArgument<3>& outward, double radius, double pitch, double turns,
           int elements, Options&&... options) {
    detail::require_positive("helix: radius", radius);
    detail::require_finite("helix: pitch", pitch);
    detail::require_positive("helix: turns", turns);
    detail::require(elements >= 1, "helix: at least one element is needed, got ", elements);
    const Matrix<double, 3> frame = reference_slopes(axis, outward);  // axis, outward, across
    const double rise = pitch / (2.0 * pi);
    const double per_radian = std::sqrt(radius * radius + rise * rise);
    std::vector<CurvePoint<3>> points;
    for (int k = 0; k <= elements; ++k) {
        const double turn = 2.0 * pi * turns * k / elements;
        const Vector<double, 3> radial =
            std::cos(turn) * frame.col(1) + std::sin(turn) * frame.col(2);
        const Vector<double, 3> around =
            std::cos(turn) * frame.col(2) - std::sin(turn) * frame.col(1);
        const Vector<double, 3> tangent = (rise * frame.col(0) + radius * around) / per_radian;
        points.push_back({centre + radius * radial + rise * turn * frame.col(0),
                          reference_slopes(tangent, Vector<double, 3>(-radial)),
                          -radius / (per_radian * per_radian) * radial});
    }
    return beam_through<Element>(model, material, section, points,
                                 {2.0 * pi * turns * per_radian / elements},
                                 std::forward<Options>(options)...);
}

/// Adds a smooth beam through points, one element between each two.
///
/// Tangents are those of the parabola through each point and its neighbours over the chord lengths;
/// the section is carried from node to node by the smallest rotation of the tangent.
/// @param y_axis  section's y direction at the first point, made normal to the tangent there
/// @throws InvalidArgument for fewer than two points, points that coincide, or parallel directions.
template <class Element = void, class... Elements, class... Options>
auto spline(Model<Elements...>& model, const Material& material, const Section& section,
            const std::vector<Vector<double, 3>>& through, const VectorArgument<3>& y_axis,
            Options&&... options) {
    const std::size_t count = through.size();
    detail::require(count >= 2, "spline: at least two points are needed, got ", count);
    std::vector<double> chords;
    for (std::size_t k = 0; k + 1 < count; ++k) {
        chords.push_back((through[k + 1] - through[k]).norm());
        detail::require(std::isfinite(chords[k]) && chords[k] > 0.0, "spline: points ", k, " and ",
                        k + 1, " must be finite and apart");
    }
    const auto secant = [&](std::size_t k) -> Vector<double, 3> {
        return (through[k + 1] - through[k]) / chords[k];
    };
    std::vector<CurvePoint<3>> points;
    for (std::size_t k = 0; k < count; ++k) {
        Vector<double, 3> tangent, bend = Vector<double, 3>::Zero();
        if (count == 2) {
            tangent = secant(0);
        } else {
            const std::size_t middle = k == 0 ? 1 : k + 1 == count ? count - 2 : k;
            const double a = chords[middle - 1], b = chords[middle];
            tangent = (b * secant(middle - 1) + a * secant(middle)) / (a + b);
            bend = 2.0 / (a + b) * (secant(middle) - secant(middle - 1));
            if (k == 0) tangent = 2.0 * secant(0) - tangent;
            if (k + 1 == count) tangent = 2.0 * secant(count - 2) - tangent;
        }
        const double size = tangent.norm();
        detail::require(size > 1e-9, "spline: the line folds back on itself at point ", k);
        tangent /= size;
        bend = (bend - bend.dot(tangent) * tangent) / (size * size);
        Vector<double, 3> across = y_axis;
        if (k > 0) {
            const Vector<double, 3> before = points.back().slopes.col(0);
            const Vector<double, 3> carried = points.back().slopes.col(1);
            across =
                carried - carried.dot(tangent) / (1.0 + before.dot(tangent)) * (before + tangent);
        }
        points.push_back({through[k], reference_slopes(tangent, across), bend});
    }
    return beam_through<Element>(model, material, section, points, chords,
                                 std::forward<Options>(options)...);
}

}  // namespace ancf
