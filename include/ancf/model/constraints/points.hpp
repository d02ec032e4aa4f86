// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Constraints on coordinates and points: fixed coordinates, pins, guides, distances.
///
/// terms is a template on the scalar so that the tests differentiate it by a complex step; evaluate
/// is what a model calls. docs/theory-dynamics.md derives each term.

#pragma once

#include <ancf/element/requirement.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/model/constraints/motion.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

#include <array>
#include <string>
#include <utility>

namespace ancf {

/// A material point: a weighted sum of nodal vectors.
struct MaterialPoint {
    Coupling vectors;      ///< nodal vectors that it combines
    List<double> weights;  ///< of each vector
    std::string name;      ///< for messages

    /// A node's position.
    MaterialPoint(NodeId node);  // NOLINT: a node is a point

    /// A weighted sum of vectors, with a name for messages.
    MaterialPoint(Coupling at, List<double> with, std::string called);
};

namespace detail {

/// Returns the point at xi of a line that is cubic or quintic in the given parameter length.
[[nodiscard]] MaterialPoint point_of_line(const Connection& at, int element, bool quintic,
                                          double length, double xi);

/// The difference d = P_a - P_b of two points, the second of the scene or on a given path.
template <int Dimension>
class PointPair {
public:
    PointPair(MaterialPoint a, MaterialPoint b);
    PointPair(MaterialPoint a, PointMotion<Dimension> path);
    /// @param user  for the message where the place is not finite
    PointPair(MaterialPoint a, const Vector<double, Dimension>& place, const char* user);

    [[nodiscard]] Coupling coupling() const;
    [[nodiscard]] std::string names() const;

    template <class Scalar>
    [[nodiscard]] Vector<Scalar, Dimension> difference(const DynamicVector<Scalar>& q,
                                                       const Scalar& time) const;

    /// The part of d's rate that time alone makes.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, Dimension> drift(const Scalar& time) const {
        if (!path_.value) return Vector<Scalar, Dimension>::Zero();
        return -continued(path_.rate, path_.acceleration, time);
    }
    [[nodiscard]] Vector<double, Dimension> drift_rate(double time) const {
        if (!path_.value) return Vector<double, Dimension>::Zero();
        return -path_.acceleration(time);
    }

    /// The sum of weighted vectors: W q.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, Dimension> moved(const DynamicVector<Scalar>& q) const;

    /// Returns the generalised force of a force on P_a, and its opposite on P_b: W^T f.
    [[nodiscard]] VectorX generalised_force(const Vector<double, Dimension>& force) const;
    /// Adds W^T B W.
    void add_block(const Matrix<double, Dimension>& block, MatrixX& to) const;

    /// Returns the weights of the coupling's vectors, those of b with their sign turned.
    [[nodiscard]] const List<double>& weights() const noexcept { return weights_; }

private:
    static void check(const MaterialPoint& point);

    MaterialPoint a_;
    MaterialPoint b_;              // of no vectors where a path is given
    PointMotion<Dimension> path_;  // empty where b is given
    List<double> weights_;
};

}  // namespace detail

/// Returns the point of an element's centre line at xi in [0, 1] by Hermite interpolation, of fifth
/// degree where nodes have r_xx.
/// @param element  index in the model's group of that type.
/// @throws InvalidArgument for an element that does not exist or xi outside [0, 1].
template <class Element>
[[nodiscard]] MaterialPoint point_along(const Scene& model, int element, double xi) {
    static_assert(Element::fields.contains(Field::r | Field::r_x),
                  "a point along an element needs r and r_x at its nodes");
    const auto& group = model.group<Element>();
    constexpr bool quintic = Element::fields.contains(Field::r_xx);
    return detail::point_of_line(group.connection(element), element, quintic,
                                 detail::parameter_length(group.element(element)), xi);
}

/// One coordinate held by a multiplier or driven: g = e - f(t), m or 1.
///
/// Its multiplier is the support's reaction. Model::fix removes the coordinate instead and is
/// cheaper.
template <int Dimension = 3>
class FixedCoordinate {
public:
    static constexpr int dimension = Dimension;  ///< of the model it belongs to

    /// @throws InvalidArgument for a component that does not exist or a value that is not finite.
    FixedCoordinate(NodeId node, Field field, int component, double value);

    /// Drives a component.
    FixedCoordinate(NodeId node, Field field, int component, Motion motion);

    /// @{
    /// As of every constraint, see AnyConstraint.
    [[nodiscard]] Coupling coupling() const { return {at_}; }
    [[nodiscard]] int equations() const { return 1; }
    [[nodiscard]] std::string name() const;
    template <class Scalar>
    void terms(const DynamicVector<Scalar>& q, const Scalar& time,
               ConstraintTerms<Scalar>& out) const;
    void evaluate(const ConstraintState& at, ConstraintResult& out) const;
    /// @}

private:
    NodeField at_;
    int component_;
    Motion motion_;
};

/// A point held on another point of the scene, at a place, or on a path: g = P_a - P_b, m.
///
/// A spherical joint. Its multipliers are the force that a exerts.
template <int Dimension = 3>
class Pin {
public:
    static constexpr int dimension = Dimension;  ///< of the model it belongs to

    /// @throws InvalidArgument unless the place is finite.
    Pin(MaterialPoint a, const VectorArgument<Dimension>& place)
        : points_(std::move(a), place, "Pin") {}

    /// @throws InvalidArgument if both are the same node.
    Pin(MaterialPoint a, MaterialPoint b) : points_(std::move(a), std::move(b)) {}

    /// @throws InvalidArgument unless value, rate and acceleration are given.
    Pin(MaterialPoint a, PointMotion<Dimension> path) : points_(std::move(a), std::move(path)) {}

    /// @{
    /// As of every constraint, see AnyConstraint.
    [[nodiscard]] Coupling coupling() const { return points_.coupling(); }
    [[nodiscard]] int equations() const { return Dimension; }
    [[nodiscard]] std::string name() const { return "pin of " + points_.names(); }
    template <class Scalar>
    void terms(const DynamicVector<Scalar>& q, const Scalar& time,
               ConstraintTerms<Scalar>& out) const;
    void evaluate(const ConstraintState& at, ConstraintResult& out) const;
    /// @}

private:
    detail::PointPair<Dimension> points_;
};

/// A pin's dimension is that of its place.
template <int Dimension>
Pin(MaterialPoint, Vector<double, Dimension>) -> Pin<Dimension>;

/// A point held on a straight line of space, as a slider on its guide: g_k = n_k . (P - p), m, with
/// unit vectors n_k normal to the line. There is no friction.
///
/// In the plane n_1 is the direction turned by 90 degrees. In space, for a direction d of unit
/// length, n_1 is along d x e, e the axis of d's smallest component or the first of these, and
/// n_2 = d x n_1. The multipliers are the forces along n_k that the point exerts, N.
template <int Dimension = 3>
class PointOnLine {
public:
    static constexpr int dimension = Dimension;  ///< of the model it belongs to

    /// @param place      of the line, m.
    /// @param direction  of the line; its length does not count.
    /// @throws InvalidArgument unless the place is finite and the direction has a length.
    PointOnLine(MaterialPoint point, const VectorArgument<Dimension>& place,
                const VectorArgument<Dimension>& direction);

    /// @{
    /// As of every constraint, see AnyConstraint.
    [[nodiscard]] Coupling coupling() const { return points_.coupling(); }
    [[nodiscard]] int equations() const { return Dimension - 1; }
    [[nodiscard]] std::string name() const { return "line of " + points_.names(); }
    template <class Scalar>
    void terms(const DynamicVector<Scalar>& q, const Scalar& time,
               ConstraintTerms<Scalar>& out) const;
    void evaluate(const ConstraintState& at, ConstraintResult& out) const {
        terms(at.q, at.time, out);
    }
    /// @}

private:
    detail::PointPair<Dimension> points_;
    std::array<Vector<double, Dimension>, Dimension - 1> normals_;
};

/// A guide's dimension is that of its place.
template <int Dimension>
PointOnLine(MaterialPoint, Vector<double, Dimension>, Vector<double, Dimension>)
    -> PointOnLine<Dimension>;

/// A massless link between two points, or a point and a place or a path: g = |P_a - P_b| - L(t), m.
///
/// With n the unit vector from b to a, G = n^T W and its Hessian is W^T (I - n n^T) W/|P_a - P_b|.
/// The multiplier is the link's force, positive in tension.
template <int Dimension = 3>
class Distance {
public:
    static constexpr int dimension = Dimension;  ///< of the model it belongs to

    /// @throws InvalidArgument unless the length is positive and the place finite.
    Distance(MaterialPoint a, const VectorArgument<Dimension>& place, double length)
        : Distance(Points(std::move(a), place, "Distance"), length) {}

    /// @throws InvalidArgument unless the length is positive, or if both are the same node.
    Distance(MaterialPoint a, MaterialPoint b, double length)
        : Distance(Points(std::move(a), std::move(b)), length) {}

    /// @throws InvalidArgument unless the length is positive and the path complete.
    Distance(MaterialPoint a, PointMotion<Dimension> path, double length)
        : Distance(Points(std::move(a), std::move(path)), length) {}

    /// A link whose length follows a motion, m.
    /// @throws InvalidArgument unless the motion is complete, or if both are the same node.
    Distance(MaterialPoint a, MaterialPoint b, Motion length)
        : Distance(Points(std::move(a), std::move(b)), std::move(length)) {}

    /// A link to a place whose length follows a motion, m.
    /// @throws InvalidArgument unless the place is finite and the motion complete.
    Distance(MaterialPoint a, const VectorArgument<Dimension>& place, Motion length)
        : Distance(Points(std::move(a), place, "Distance"), std::move(length)) {}

    /// @{
    /// As of every constraint, see AnyConstraint.
    [[nodiscard]] Coupling coupling() const { return points_.coupling(); }
    [[nodiscard]] int equations() const { return 1; }
    [[nodiscard]] std::string name() const { return "distance between " + points_.names(); }
    template <class Scalar>
    void terms(const DynamicVector<Scalar>& q, const Scalar& time,
               ConstraintTerms<Scalar>& out) const;
    void evaluate(const ConstraintState& at, ConstraintResult& out) const;
    /// @}

private:
    using Points = detail::PointPair<Dimension>;

    Distance(Points points, double length);
    Distance(Points points, Motion length);

    Points points_;
    Motion length_;
};

/// A link's dimension is that of its place.
template <int Dimension, class Length>
Distance(MaterialPoint, Vector<double, Dimension>, Length) -> Distance<Dimension>;

/// Any constraint with its equations driven: g(q, t) - f(t).
///
///     model.add(ancf::Driven(ancf::Pin(tip, place), {{1, lift}}));   // lifts the second component
template <class Constraint>
class Driven {
public:
    /// Of the models it belongs to; 0: any.
    static constexpr int dimension = detail::dimension_of<Constraint>::value;

    /// @param motions  (equation, motion) pairs; m for an equation in m.
    /// @throws InvalidArgument for an equation that does not exist or a motion that is not
    ///         complete.
    Driven(Constraint constraint, List<std::pair<int, Motion>> motions)
        : constraint_(std::move(constraint)), motions_(std::move(motions)) {
        for (const auto& [equation, motion] : motions_) {
            detail::require(equation >= 0 && equation < constraint_.equations(),
                            "Driven: ", constraint_.name(), " has ", constraint_.equations(),
                            " equations, got equation ", equation);
            motion.check("Driven");
        }
    }

    /// @{
    /// As of every constraint, see AnyConstraint.
    [[nodiscard]] Coupling coupling() const { return constraint_.coupling(); }
    [[nodiscard]] int equations() const { return constraint_.equations(); }
    [[nodiscard]] std::string name() const { return "driven " + constraint_.name(); }
    /// Returns the angle that the constraint itself is driven to, rad.
    [[nodiscard]] double driven_angle(double time) const {
        return detail::driven_angle(constraint_, time);
    }
    template <class Scalar, class Held = Constraint>
    auto terms(const DynamicVector<Scalar>& q, const Scalar& time,
               ConstraintTerms<Scalar>& out) const
        -> decltype(std::declval<const Held&>().terms(q, time, out)) {
        constraint_.terms(q, time, out);
        drive(time, out);
    }
    void evaluate(const ConstraintState& at, ConstraintResult& out) const {
        constraint_.evaluate(at, out);
        drive(at.time, out);
        for (const auto& [equation, motion] : motions_)
            out.convection[equation] -= motion.acceleration(at.time);
    }
    /// @}

private:
    /// Takes f and its rate off g and g_t.
    template <class Scalar>
    void drive(const Scalar& time, ConstraintTerms<Scalar>& out) const {
        for (const auto& [equation, motion] : motions_) {
            out.violation[equation] -= detail::continued(motion.value, motion.rate, time);
            out.rate[equation] -= detail::continued(motion.rate, motion.acceleration, time);
        }
    }

    Constraint constraint_;
    List<std::pair<int, Motion>> motions_;
};

#if defined(ANCF_COMPILED)
extern template class detail::PointPair<2>;
extern template class detail::PointPair<3>;
extern template class FixedCoordinate<2>;
extern template class FixedCoordinate<3>;
extern template class Pin<2>;
extern template class Pin<3>;
extern template class PointOnLine<2>;
extern template class PointOnLine<3>;
extern template class Distance<2>;
extern template class Distance<3>;
#endif

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/constraints/points.ipp>  // IWYU pragma: export
#endif
