// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Builders: chains of elements between points, and loads along them.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/element/mass.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/loads/forces.hpp>
#include <ancf/model/model.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/moments.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace ancf {

/// A chain of elements, without their type.
struct Chain {
    List<NodeId> nodes;    ///< in order, one more than elements
    List<int> elements;    ///< indices in the model's group of this element type
    List<int> prototypes;  ///< indices of the prototypes added

    /// Returns the node at the start.
    /// @throws InvalidArgument for a beam that no builder made.
    [[nodiscard]] NodeId first() const { return node(0); }
    /// Returns the node at the end.
    /// @throws InvalidArgument for a beam that no builder made.
    [[nodiscard]] NodeId last() const { return node(static_cast<int>(nodes.size()) - 1); }

    /// Returns a node by its place along the chain, 0 at the start.
    /// @throws InvalidArgument for a place beyond the ends.
    [[nodiscard]] NodeId node(int place) const;
};

/// A chain of elements as a builder added it to a model.
template <class Element>
struct Beam : Chain {};

/// Returns orthonormal reference slopes (columns) of a beam along a direction.
///
/// Three dimensions: r_y is the part of `y_axis` normal to the direction.
/// @throws InvalidArgument where the direction has no length or `y_axis` is parallel to it.
[[nodiscard]] Matrix<double, 3> reference_slopes(const Vector<double, 3>& direction,
                                                 const Vector<double, 3>& y_axis);

/// Returns reference slopes without a chosen y axis: global X turned into the direction by the
/// smallest rotation carries global Y and Z with it.
///
/// Where the direction leans towards -X by more than 154 degrees r_y is instead the part of global
/// Y normal to it: there the section turns at once by up to half a turn. Give a y axis to avoid it.
/// @throws InvalidArgument where the direction has no length.
[[nodiscard]] Matrix<double, 3> reference_slopes(const Vector<double, 3>& direction);

/// Returns reference slopes in the plane: r_x along the direction, r_y turned by a right angle
/// counterclockwise.
/// @throws InvalidArgument where the direction has no length.
[[nodiscard]] Matrix<double, 2> reference_slopes(const Vector<double, 2>& direction);

namespace detail {

/// The element that a builder takes, which its caller names.
template <class Element, int Dimension>
struct NamedElement {
    static_assert(Element::dimension == Dimension,
                  "the element is of another dimension than the model");
    using type = Element;
};
template <int Dimension>
struct NamedElement<void, Dimension> {
    static_assert(Dimension == 0,
                  "a builder needs the element's type: write "
                  "straight_beam<ancf::CrossSectionBeam<3>>(model, ...)");
    using type = void;
};
template <class Element, int Dimension>
using named_element_t = typename NamedElement<Element, Dimension>::type;

/// Returns the element that a builder makes.
template <class Element, class... Arguments>
[[nodiscard]] Element made_element(const Arguments&... arguments) {
    constexpr bool takes = std::is_constructible_v<Element, const Arguments&...>;
    static_assert(takes,
                  "the last argument of a builder is the options of its element, of the type "
                  "Element::Options: CrossSectionOptions::best(), QuinticOptions(), "
                  "TorsionBeamOptions::best(), CableOptions()");
    if constexpr (takes) return Element(arguments...);
}

/// Returns to - from.
template <int Dimension>
[[nodiscard]] Vector<double, Dimension> between(const Vector<double, Dimension>& from,
                                                const Vector<double, Dimension>& to) {
    Vector<double, Dimension> difference;
    for (int i = 0; i < Dimension; ++i) difference[i] = to[i] - from[i];
    return difference;
}

/// Returns the distance of a beam's ends.
template <int Dimension>
[[nodiscard]] double distance_apart(const Vector<double, Dimension>& from,
                                    const Vector<double, Dimension>& to);

/// Checks that a straight element of these slopes is free of stress.
/// @param fields  that the element carries at a node
/// @param along   from one end of the beam to the other, m
/// @throws InvalidArgument unless those slopes are orthonormal and right-handed, r_x along it.
template <int Dimension>
void check_straight_slopes(Fields fields, const Vector<double, Dimension>& along,
                           const Matrix<double, Dimension>& slopes);

/// Adds nodes at equal distances.
/// @param elements  one less than nodes
template <int Dimension>
[[nodiscard]] List<NodeId> add_nodes_between(BasicModel<Dimension>& model,
                                             const Vector<double, Dimension>& from,
                                             const Vector<double, Dimension>& to,
                                             const Matrix<double, Dimension>& slopes, int elements);

/// Adds the beam's next element, of its last prototype.
template <class Element>
void connect_next(Scene& model, Beam<Element>& beam) {
    const std::size_t k = beam.elements.size();
    beam.elements.push_back(
        model.connect<Element>(beam.prototypes.back(), beam.nodes[k], beam.nodes[k + 1]));
}

template <class Element>
using LineLoad = decltype(some<Element>().line_load(some<Vector<double, Element::dimension>>()));

/// Returns the nodal force of a force per length; without line_load() that of a straight element.
template <class Element>
[[nodiscard]] VectorX line_load(const Element& element,
                                const Vector<double, Element::dimension>& force_per_length) {
    if constexpr (offers<LineLoad, Element>) {
        return element.line_load(force_per_length);
    } else {
        static_assert(Element::fields.count() >= 2,
                      "add_line_load needs of an element without slopes: "
                      "Coordinates line_load(const Vector<double, dimension>&) const;");
        Moments line;  // a section of unit area on the axis alone
        line.area = 1.0;
        return gravity_force<Element::dimension>(
            mass_weights<Element::fields.count()>(1.0, line, element.length()), force_per_length);
    }
}

}  // namespace detail

/// Adds a straight chain of equal elements with the given reference slopes.
///
/// @param from, to  the ends, m.
/// @param slopes    columns r_x, r_y and, in space, r_z of every node; 1. Those that the element
///                  carries are orthonormal and right-handed, r_x along the beam.
/// @param elements  how many, at least 1.
/// @param options   handed to the element's constructor after material, section and length.
/// @return          the chain's nodes, elements and prototype.
/// @throws InvalidArgument for ends that are not finite or not apart, fewer than one element,
///         slopes that are not so, and what the element's constructor refuses.
template <class Element = void, int Dimension, class... Options>
auto straight_beam_with_slopes(BasicModel<Dimension>& model, const Material& material,
                               const Section& section,
                               const typename BasicModel<Dimension>::Argument& from,
                               const typename BasicModel<Dimension>::Argument& to,
                               const typename BasicModel<Dimension>::Slopes& slopes, int elements,
                               Options&&... options) {
    using Chosen = detail::named_element_t<Element, Dimension>;
    detail::require(elements >= 1, "straight_beam: at least one element is needed, got ", elements);
    const double length = detail::distance_apart<Dimension>(from, to);
    detail::check_straight_slopes<Dimension>(Chosen::fields, detail::between<Dimension>(from, to),
                                             slopes);
    Beam<Chosen> beam;
    beam.prototypes.push_back(model.add_prototype(
        detail::made_element<Chosen>(material, section, length / elements, options...)));
    beam.nodes = detail::add_nodes_between<Dimension>(model, from, to, slopes, elements);
    for (int k = 0; k < elements; ++k) detail::connect_next(model, beam);
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
template <class Element = void, int Dimension, class... Options>
auto straight_beam(BasicModel<Dimension>& model, const Material& material, const Section& section,
                   const typename BasicModel<Dimension>::Argument& from,
                   const typename BasicModel<Dimension>::Argument& to, int elements,
                   Options&&... options) {
    static_cast<void>(detail::distance_apart<Dimension>(from, to));
    return straight_beam_with_slopes<Element>(
        model, material, section, from, to, reference_slopes(detail::between<Dimension>(from, to)),
        elements, std::forward<Options>(options)...);
}

/// Returns the list of both nodes' vectors that an element uses.
[[nodiscard]] Coupling coupling_of(const Connection& connection, Fields fields);

/// Returns the list of both nodes' vectors that an element uses.
template <class Element>
[[nodiscard]] Coupling coupling_of(const Connection& connection) {
    return coupling_of(connection, Element::fields);
}

/// Adds a dead force per reference length along a beam, N/m.
/// @throws InvalidArgument unless every component is finite.
template <class Element>
void add_line_load(BasicModel<Element::dimension>& model, const Beam<Element>& beam,
                   const VectorArgument<Element::dimension>& force_per_length,
                   const Amplitude& amplitude = {}) {
    detail::require_finite("add_line_load: components", detail::components(force_per_length));
    const auto& group = model.template group<Element>();
    for (const int index : beam.elements) {
        const VectorX force = detail::line_load(group.element(index), force_per_length);
        model.add(GeneralisedForce(coupling_of<Element>(group.connection(index)), force),
                  amplitude);
    }
}

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/builders/beam.ipp>  // IWYU pragma: export
#endif
