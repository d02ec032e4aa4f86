// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Sliding joints: points that slide along beams and cables, which bend, or along a body.
///
///     const auto rail = ancf::straight_beam<Bar>(model, steel, section, {0, 0, 0}, {4, 0, 0}, 8);
///     const auto trolley = model.add_node({0.5, 0, 0});
///     model.add_mass(trolley, 20.0);
///     model.add(ancf::Slider(trolley, ancf::guide_along(model, rail)));
///
/// There is no friction. docs/theory-dynamics.md, "Sliders", derives each term.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/element/requirement.hpp>
#include <ancf/list.hpp>
#include <ancf/model/builders/beam.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/model/constraints/points.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/model.hpp>
#include <ancf/types.hpp>

#include <array>
#include <string>
#include <utility>

namespace ancf {

namespace detail {

/// A piece of a guide: a polynomial r(xi) of nodal vectors, its weights by powers of xi.
struct GuidePiece {
    using Powers = std::array<double, 6>;

    List<int> vectors;    ///< places in Guide::vectors
    List<Powers> line;    ///< of each vector in r; m/m or, of slopes, m
    List<Powers> across;  ///< of each vector in a vector across the line, if there is one
    double first = 0.0, last = 1.0;  ///< the range of xi
    double start = 0.0;              ///< Slider::station at xi = 0
};

}  // namespace detail

/// A line that a point may slide along.
template <int Dimension>
struct Guide {
    Coupling vectors;                 ///< nodal vectors that it combines
    List<detail::GuidePiece> pieces;  ///< in order
    Vector<double, Dimension> across =
        Vector<double, Dimension>::Zero();  ///< where pieces have none; in space
    std::string name;                       ///< for messages
};

namespace detail {

/// Returns the guide along elements between nodes.
/// @param lengths  parameter lengths of the elements, m.
/// @param fields   of the elements' nodes.
template <int Dimension>
[[nodiscard]] Guide<Dimension> guide_of_lines(const List<Connection>& elements,
                                              const List<double>& lengths, Fields fields,
                                              const Vector<double, Dimension>& across);

}  // namespace detail

/// Returns the centre line of a beam as a guide. Beyond its ends it goes on straight, unless they
/// are one node.
/// @param beam    only its `elements` count, each from the last one's end on.
/// @param across  in space, for elements without r_y (cables): a direction that the line never
///                takes, such as the normal of the plane in which it hangs. Others ignore it.
/// @throws InvalidArgument for no elements, elements that do not exist or do not follow each
///         other, and an `across` of no length where it counts.
template <class Element>
[[nodiscard]] Guide<Element::dimension> guide_along(
    const BasicModel<Element::dimension>& model, const Beam<Element>& beam,
    const Vector<double, Element::dimension>& across = Vector<double, Element::dimension>::Zero()) {
    static_assert(Element::fields.contains(Field::r | Field::r_x),
                  "a guide along elements needs r and r_x at their nodes");
    List<Connection> elements;
    List<double> lengths;
    const auto& group = model.template group<Element>();
    for (const int element : beam.elements) {
        elements.push_back(group.connection(element));
        lengths.push_back(detail::parameter_length(group.element(element)));
    }
    return detail::guide_of_lines<Element::dimension>(elements, lengths, Element::fields, across);
}

/// Returns a straight line through a node that is fixed in its slopes, as a guide on a rigid body.
/// @param node       one with all slopes, such as a point_of_body.
/// @param direction  in global components, as the model stands; its length does not count.
/// @throws InvalidArgument for a node without a slope or with slopes of no volume and a direction
///         of no length.
template <int Dimension>
[[nodiscard]] Guide<Dimension> straight_guide(const BasicModel<Dimension>& model, NodeId node,
                                              const Vector<double, Dimension>& direction);

/// A sliding joint: a point held on a guide that moves; in the plane one equation, in space two.
///
/// With r the guide's place next to the point P: g_k = n_k . (P - r), m, n_k unit vectors normal to
/// the guide there. In the plane n_1 is the tangent t turned by 90 degrees. In space n_1 is along
/// the part of the section's r_y, or of `across`, that is normal to t, and n_2 = t x n_1. The
/// multipliers are the forces along n_k that the point exerts, N.
///
/// G has entries at all nodes of the guide, the stiffness at those of one element. Take no more
/// elements than the point may reach. Where several places are next to P it is the first.
template <int Dimension = 3>
class Slider {
public:
    static constexpr int dimension = Dimension;  ///< of the model it belongs to

    /// @throws InvalidArgument for a guide that no function made and a point of one of its nodes.
    Slider(MaterialPoint point, Guide<Dimension> guide);

    /// Returns where on the guide the point is: elements passed, 2.25 a quarter of the parameter
    /// along the third one; on a straight guide the length from its node in the reference, m. Below
    /// 0 or above the number of elements it has left them.
    /// @param q  coordinates of the model, such as State::q.
    [[nodiscard]] double station(const BasicModel<Dimension>& model, const VectorX& q) const;

    /// @{
    /// As of every constraint, see AnyConstraint.
    [[nodiscard]] Coupling coupling() const;
    [[nodiscard]] List<Coupling> stiffness_parts() const;
    [[nodiscard]] int equations() const { return Dimension - 1; }
    [[nodiscard]] std::string name() const {
        return "slider of " + point_.name + " on " + guide_.name;
    }
    template <class Scalar>
    void terms(const DynamicVector<Scalar>& q, const Scalar& time,
               ConstraintTerms<Scalar>& out) const;
    void evaluate(const ConstraintState& at, ConstraintResult& out) const;
    /// @}

private:
    // A place on the guide.
    struct Place {
        const detail::GuidePiece* piece;
        double xi;
    };

    // Where the guide's coordinates begin among those of the coupling.
    [[nodiscard]] int guide_start() const noexcept {
        return Dimension * static_cast<int>(point_.vectors.size());
    }
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, Dimension> position(const DynamicVector<Scalar>& q) const;
    // The place next to the point.
    [[nodiscard]] Place place(const VectorX& q) const;
    // Those of the coupling's coordinates that count there: the point's, then the piece's.
    [[nodiscard]] List<int> coordinates(const Place& at) const;
    // The terms at a place.
    template <class Scalar>
    void write(const Place& at, const DynamicVector<Scalar>& q, ConstraintTerms<Scalar>& out) const;
    // Those by these coordinates alone.
    template <class Scalar>
    [[nodiscard]] ConstraintTerms<Scalar> terms_at(const Place& at,
                                                   const DynamicVector<Scalar>& q) const;

    MaterialPoint point_;
    Guide<Dimension> guide_;
};

#if defined(ANCF_COMPILED)
extern template class Slider<2>;
extern template class Slider<3>;
#endif

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/constraints/slider.ipp>  // IWYU pragma: export
#endif
