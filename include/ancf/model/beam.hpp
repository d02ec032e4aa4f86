// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Builders: chains of elements between points, and loads along them.

#pragma once

#include <ancf/element/mass.hpp>
#include <ancf/error.hpp>
#include <ancf/model/loads_forces.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/moments.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace ancf {

/// A chain of elements as a builder added it to a model.
template <class Element>
struct Beam {
    std::vector<NodeId> nodes;    ///< in order, one more than elements
    std::vector<int> elements;    ///< indices in the model's group of this element type
    std::vector<int> prototypes;  ///< indices of the prototypes added

    /// Returns the node at the start.
    /// @throws InvalidArgument for a beam that no builder made.
    [[nodiscard]] NodeId first() const { return node(0); }
    /// Returns the node at the end.
    /// @throws InvalidArgument for a beam that no builder made.
    [[nodiscard]] NodeId last() const { return node(static_cast<int>(nodes.size()) - 1); }

    /// Returns a node by its place along the chain, 0 at the start.
    /// @throws InvalidArgument for a place beyond the ends.
    [[nodiscard]] NodeId node(int place) const {
        detail::require(place >= 0 && place < static_cast<int>(nodes.size()), "Beam: there are ",
                        nodes.size(), " nodes, got place ", place);
        return nodes[static_cast<std::size_t>(place)];
    }
};

namespace detail {

/// Returns the length of a direction.
/// @throws InvalidArgument where it has none or is not finite.
template <int Dimension>
[[nodiscard]] double require_length(const char* name, const Vector<double, Dimension>& direction) {
    const double length = span(direction);
    require(std::isfinite(length) && length > 0.0, "reference_slopes: ", name,
            " must have a length, got ", components(direction));
    return length;
}

}  // namespace detail

/// Returns orthonormal reference slopes (columns) of a beam along a direction.
///
/// Three dimensions: r_y is the part of `y_axis` normal to the direction.
/// @throws InvalidArgument where the direction has no length or `y_axis` is parallel to it.
[[nodiscard]] inline Matrix<double, 3> reference_slopes(const Vector<double, 3>& direction,
                                                        const Vector<double, 3>& y_axis) {
    const double length = detail::require_length("the direction", direction);
    const double width = detail::require_length("the y axis", y_axis);
    // plain loops: expressions of Eigen here would be compiled by all who add a beam
    Matrix<double, 3> slopes;
    double share = 0.0, square = 0.0;
    for (int k = 0; k < 3; ++k) {
        slopes(k, 0) = direction[k] / length;
        share += y_axis[k] / width * slopes(k, 0);
    }
    for (int k = 0; k < 3; ++k) {
        slopes(k, 1) = y_axis[k] / width - share * slopes(k, 0);
        square += slopes(k, 1) * slopes(k, 1);
    }
    detail::require(std::sqrt(square) > 1e-8,
                    "reference_slopes: the y axis must not be parallel to the beam, got ",
                    detail::components(y_axis));
    for (int k = 0; k < 3; ++k) slopes(k, 1) /= std::sqrt(square);
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3, last = (k + 2) % 3;
        slopes(k, 2) = slopes(next, 0) * slopes(last, 1) - slopes(last, 0) * slopes(next, 1);
    }
    return slopes;
}

/// Returns reference slopes without a chosen y axis: global X turned into the direction by the
/// smallest rotation carries global Y and Z with it.
///
/// Where the direction leans towards -X by more than 154 degrees r_y is instead the part of global
/// Y normal to it: there the section turns at once by up to half a turn. Give a y axis to avoid it.
/// @throws InvalidArgument where the direction has no length.
[[nodiscard]] inline Matrix<double, 3> reference_slopes(const Vector<double, 3>& direction) {
    const double length = detail::require_length("the direction", direction);
    const double x = direction[0] / length, y = direction[1] / length, z = direction[2] / length;
    if (x < -0.9) return reference_slopes(direction, {0.0, 1.0, 0.0});
    return reference_slopes(direction, {-y, 1.0 - y * y / (1.0 + x), -y * z / (1.0 + x)});
}

/// Returns reference slopes in the plane: r_x along the direction, r_y turned by a right angle
/// counterclockwise.
/// @throws InvalidArgument where the direction has no length.
[[nodiscard]] inline Matrix<double, 2> reference_slopes(const Vector<double, 2>& direction) {
    const double length = detail::require_length("the direction", direction);
    Matrix<double, 2> slopes;
    slopes(0, 0) = slopes(1, 1) = direction[0] / length;
    slopes(1, 0) = direction[1] / length;
    slopes(0, 1) = -slopes(1, 0);
    return slopes;
}

namespace detail {

/// Returns the distance of a beam's ends.
template <int Dimension>
[[nodiscard]] double distance_apart(const Vector<double, Dimension>& from,
                                    const Vector<double, Dimension>& to) {
    const double length = span(Vector<double, Dimension>(to - from));
    require(std::isfinite(length) && length > 0.0,
            "straight_beam: the ends must be finite and apart, got a length of ", length);
    return length;
}

}  // namespace detail

/// Adds a straight chain of equal elements with the given reference slopes.
///
/// @param from, to  the ends, m.
/// @param slopes    columns r_x, r_y and, in space, r_z of every node; 1.
/// @param elements  how many, at least 1.
/// @param options   handed to the element's constructor after material, section and length.
/// @return          the chain's nodes, elements and prototype.
/// @throws InvalidArgument for ends that are not finite or not apart, fewer than one element,
///         slopes that are not finite, and what the element's constructor refuses.
template <class Element = void, class... Elements, class... Options>
auto straight_beam_with_slopes(Model<Elements...>& model, const Material& material,
                               const Section& section,
                               const typename Model<Elements...>::Argument& from,
                               const typename Model<Elements...>::Argument& to,
                               const typename Model<Elements...>::Slopes& slopes, int elements,
                               Options&&... options) {
    using Scene = Model<Elements...>;
    using Chosen =
        std::conditional_t<std::is_void_v<Element>, typename Scene::DefaultElement, Element>;
    detail::require(elements >= 1, "straight_beam: at least one element is needed, got ", elements);
    const double length = detail::distance_apart<Scene::dimension>(from, to);
    Beam<Chosen> beam;
    const int prototype = model.add_prototype(
        Chosen(material, section, length / elements, std::forward<Options>(options)...));
    beam.prototypes.push_back(prototype);
    for (int k = 0; k <= elements; ++k) {
        const double part = static_cast<double>(k) / elements;
        beam.nodes.push_back(model.add_node((1.0 - part) * from + part * to, slopes));
    }
    for (std::size_t k = 0; k + 1 < beam.nodes.size(); ++k)
        beam.elements.push_back(
            model.template connect<Chosen>(prototype, beam.nodes[k], beam.nodes[k + 1]));
    return beam;
}

/// Adds a straight chain of equal elements between two points.
///
/// The section's y axis follows `reference_slopes(to - from)`.
/// @param from, to  the ends, m.
/// @param elements  how many, at least 1.
/// @param options   handed to the element's constructor after material, section and length.
/// @return          the chain: its nodes from `from` to `to`, its elements and its prototype.
/// @throws InvalidArgument for ends that are not finite or not apart, fewer than one element, and
///         what the element's constructor refuses.
template <class Element = void, class... Elements, class... Options>
auto straight_beam(Model<Elements...>& model, const Material& material, const Section& section,
                   const typename Model<Elements...>::Argument& from,
                   const typename Model<Elements...>::Argument& to, int elements,
                   Options&&... options) {
    using Point = typename Model<Elements...>::Point;
    static_cast<void>(detail::distance_apart<Model<Elements...>::dimension>(from, to));
    return straight_beam_with_slopes<Element>(model, material, section, from, to,
                                              reference_slopes(Point(to - from)), elements,
                                              std::forward<Options>(options)...);
}

/// Returns the index list of both nodes' vectors that an element uses.
template <class Element>
[[nodiscard]] Coupling coupling_of(const Connection& connection) {
    Coupling coupling;
    for (const NodeId node : {connection.first, connection.second})
        for (int k = 0; k < field_count; ++k)
            if (Element::fields.contains(static_cast<Field>(k)))
                coupling.push_back({node, static_cast<Field>(k)});
    return coupling;
}

namespace detail {

template <class Element, class = void>
struct has_line_load : std::false_type {};
template <class Element>
struct has_line_load<Element, std::void_t<decltype(std::declval<const Element&>().line_load(
                                  std::declval<const Vector<double, Element::dimension>&>()))>>
    : std::true_type {};

/// Returns the nodal force of a force per length; elements without a say in it are straight.
template <class Element>
[[nodiscard]] VectorX line_load(const Element& element,
                                const Vector<double, Element::dimension>& force_per_length) {
    if constexpr (has_line_load<Element>::value) {
        return element.line_load(force_per_length);
    } else {
        Moments line;  // a section of unit area on the axis alone
        line.area = 1.0;
        return gravity_force<Element::dimension>(
            mass_weights<Element::fields.count()>(1.0, line, element.length()), force_per_length);
    }
}

}  // namespace detail

/// Adds a dead force per reference length along a beam, N/m.
template <class Element, class... Elements>
void add_line_load(Model<Elements...>& model, const Beam<Element>& beam,
                   const typename Model<Elements...>::Argument& force_per_length,
                   const Amplitude& amplitude = {}) {
    detail::require(force_per_length.allFinite(), "add_line_load: components must be finite, got ",
                    detail::components(force_per_length));
    const auto& group = model.template group<Element>();
    for (const int index : beam.elements) {
        const Connection& connection = group.connection(index);
        const VectorX force = detail::line_load(group.element(index), force_per_length);
        model.add(GeneralisedForce(coupling_of<Element>(connection), force), amplitude);
    }
}

}  // namespace ancf
