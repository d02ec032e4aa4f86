// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Constraints on coordinates and points: fixed coordinates, pins, distances.
///
/// violation, jacobian and rate are templates on the scalar so that the tests differentiate them by
/// a complex step; evaluate is what a model calls. docs/theory-dynamics.md derives each term.

#pragma once

#include <ancf/element/hermite.hpp>
#include <ancf/element/requirement.hpp>
#include <ancf/error.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/model/constraints_motion.hpp>
#include <ancf/model/model.hpp>
#include <ancf/model/node.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ancf {

/// A material point: a weighted sum of nodal vectors.
struct MaterialPoint {
    Coupling vectors;             ///< nodal vectors that it combines
    std::vector<double> weights;  ///< of each vector
    std::string name;             ///< for messages

    /// A node's position.
    MaterialPoint(NodeId node)  // NOLINT: a node is a point
        : vectors{{node, Field::r}}, weights{1.0}, name(detail::joined({"node ", node.index})) {}

    /// A weighted sum of vectors, with a name for messages.
    MaterialPoint(Coupling at, std::vector<double> with, std::string called)
        : vectors(std::move(at)), weights(std::move(with)), name(std::move(called)) {}
};

/// Returns the point of an element's centre line at xi in [0, 1] by Hermite interpolation.
/// @param element  index in the model's group of that type.
/// @throws InvalidArgument for an element that does not exist or xi outside [0, 1].
template <class Element, class Scene>
[[nodiscard]] MaterialPoint point_along(const Scene& model, int element, double xi) {
    static_assert(Element::fields.contains(Field::r | Field::r_x),
                  "a point along an element needs r and r_x at its nodes");
    const auto& group = model.template group<Element>();
    const int count = static_cast<int>(group.connections.size());
    detail::require(element >= 0 && element < count, "point_along: there are ", count,
                    " elements of this type, got index ", element);
    detail::require(xi >= 0.0 && xi <= 1.0, "point_along: xi must lie in [0, 1], got ", xi);
    const Connection& at = group.connections[static_cast<std::size_t>(element)];
    const auto shape = hermite(xi, detail::parameter_length(group.element(element)));
    return {{{at.first, Field::r},
             {at.first, Field::r_x},
             {at.second, Field::r},
             {at.second, Field::r_x}},
            {shape[0], shape[1], shape[2], shape[3]},
            detail::joined({"the point at ", xi, " of element ", element}, 6)};
}

namespace detail {

/// The difference d = P_a - P_b of two points, the second of the scene or on a given path.
template <int Dimension>
class PointPair {
public:
    PointPair(MaterialPoint a, MaterialPoint b) : a_(std::move(a)), b_(std::move(b)) {
        check(a_);
        check(*b_);
        require(a_.vectors.size() != 1 || b_->vectors.size() != 1 ||
                    a_.vectors[0].node != b_->vectors[0].node,
                "a constraint joins two points, got ", a_.name, " twice");
    }

    PointPair(MaterialPoint a, PointMotion<Dimension> path)
        : a_(std::move(a)), path_(std::move(path)) {
        check(a_);
        path_->check("a point on a path");
    }

    [[nodiscard]] Coupling coupling() const {
        Coupling all = a_.vectors;
        if (b_) all.insert(all.end(), b_->vectors.begin(), b_->vectors.end());
        return all;
    }

    [[nodiscard]] std::string names() const {
        return b_ ? a_.name + " and " + b_->name : a_.name + " and a point of space";
    }

    template <class Scalar>
    [[nodiscard]] Vector<Scalar, Dimension> difference(const DynamicVector<Scalar>& q,
                                                       const Scalar& time) const {
        Vector<Scalar, Dimension> d = moved(q);
        if (path_) d -= continued(path_->value, path_->rate, time);
        return d;
    }

    /// The part of d's rate that time alone makes.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, Dimension> drift(const Scalar& time) const {
        if (!path_) return Vector<Scalar, Dimension>::Zero();
        return -continued(path_->rate, path_->acceleration, time);
    }

    [[nodiscard]] Vector<double, Dimension> drift_rate(double time) const {
        if (!path_) return Vector<double, Dimension>::Zero();
        return -path_->acceleration(time);
    }

    /// The sum of weighted vectors: W q.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, Dimension> moved(const DynamicVector<Scalar>& q) const {
        Vector<Scalar, Dimension> d = Vector<Scalar, Dimension>::Zero();
        for_each_weight([&](int k, double weight) {
            for (int i = 0; i < Dimension; ++i) d[i] += weight * q[Dimension * k + i];
        });
        return d;
    }

    /// Calls visit(k, weight) for each vector of the coupling.
    template <class Visitor>
    void for_each_weight(Visitor&& visit) const {
        int k = 0;
        for (const double weight : a_.weights) visit(k++, weight);
        if (!b_) return;
        for (const double weight : b_->weights) visit(k++, -weight);
    }

private:
    static void check(const MaterialPoint& point) {
        require(!point.vectors.empty() && point.vectors.size() == point.weights.size(),
                "a material point needs one weight per vector, got ", point.vectors.size(),
                " vectors and ", point.weights.size(), " weights");
        for (const double weight : point.weights) require_finite("MaterialPoint: weight", weight);
    }

    MaterialPoint a_;
    std::optional<MaterialPoint> b_;
    std::optional<PointMotion<Dimension>> path_;
};

}  // namespace detail

/// One coordinate held by a multiplier or driven: g = e - f(t), m or 1.
///
/// Its multiplier is the support's reaction. Model::fix removes the coordinate instead and is
/// cheaper.
template <int Dimension = 3>
class FixedCoordinate {
public:
    static constexpr int dimension = Dimension;  ///< of the model it belongs to

    /// @throws InvalidArgument for a component that does not exist or a value that is not finite.
    FixedCoordinate(NodeId node, Field field, int component, double value)
        : FixedCoordinate(node, field, component,
                          Motion{[value](double) { return value; }, [](double) { return 0.0; },
                                 [](double) { return 0.0; }}) {
        detail::require_finite("FixedCoordinate: value", value);
    }

    /// Drives a component.
    FixedCoordinate(NodeId node, Field field, int component, Motion motion)
        : at_{node, field}, component_(component), motion_(std::move(motion)) {
        detail::require(component >= 0 && component < Dimension, "FixedCoordinate: a vector has ",
                        Dimension, " components, got component ", component);
        motion_.check("FixedCoordinate");
    }

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {at_}; }
    /// Returns the number of equations.
    [[nodiscard]] int equations() const { return 1; }
    /// Returns the word that messages use.
    [[nodiscard]] std::string name() const {
        return detail::joined({"fixed ", to_string(at_.field), ", component ", component_,
                               ", of node ", at_.node.index});
    }

    /// Returns g.
    template <class Scalar>
    [[nodiscard]] DynamicVector<Scalar> violation(const DynamicVector<Scalar>& q,
                                                  const Scalar& time) const {
        return DynamicVector<Scalar>::Constant(
            1, q[component_] - detail::continued(motion_.value, motion_.rate, time));
    }

    /// Returns G = dg/dq.
    template <class Scalar>
    [[nodiscard]] DynamicMatrix<Scalar> jacobian(const DynamicVector<Scalar>&,
                                                 const Scalar&) const {
        DynamicMatrix<Scalar> g = DynamicMatrix<Scalar>::Zero(1, Dimension);
        g(0, component_) = Scalar(1.0);
        return g;
    }

    /// Returns g_t.
    template <class Scalar>
    [[nodiscard]] DynamicVector<Scalar> rate(const DynamicVector<Scalar>&,
                                             const Scalar& time) const {
        return DynamicVector<Scalar>::Constant(
            1, -detail::continued(motion_.rate, motion_.acceleration, time));
    }

    /// Evaluates it where it stands.
    void evaluate(const ConstraintState& at, ConstraintResult& out) const {
        out.violation = violation(at.q, at.time);
        out.jacobian = jacobian(at.q, at.time);
        out.rate = rate(at.q, at.time);
        out.convection[0] = -motion_.acceleration(at.time);
    }

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
        : points_(std::move(a), PointMotion<Dimension>::at_rest(place)) {
        detail::require(place.allFinite(), "Pin: the place must be finite, got ",
                        detail::components(place));
    }

    /// @throws InvalidArgument if both are the same node.
    Pin(MaterialPoint a, MaterialPoint b) : points_(std::move(a), std::move(b)) {}

    /// @throws InvalidArgument unless value, rate and acceleration are given.
    Pin(MaterialPoint a, PointMotion<Dimension> path) : points_(std::move(a), std::move(path)) {}

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return points_.coupling(); }
    /// Returns the number of equations.
    [[nodiscard]] int equations() const { return Dimension; }
    /// Returns the word that messages use.
    [[nodiscard]] std::string name() const { return "pin of " + points_.names(); }

    /// Returns g.
    template <class Scalar>
    [[nodiscard]] DynamicVector<Scalar> violation(const DynamicVector<Scalar>& q,
                                                  const Scalar& time) const {
        return points_.difference(q, time);
    }

    /// Returns G = dg/dq.
    template <class Scalar>
    [[nodiscard]] DynamicMatrix<Scalar> jacobian(const DynamicVector<Scalar>& q,
                                                 const Scalar&) const {
        DynamicMatrix<Scalar> g = DynamicMatrix<Scalar>::Zero(Dimension, q.size());
        points_.for_each_weight([&](int k, double weight) {
            for (int i = 0; i < Dimension; ++i) g(i, Dimension * k + i) = Scalar(weight);
        });
        return g;
    }

    /// Returns g_t.
    template <class Scalar>
    [[nodiscard]] DynamicVector<Scalar> rate(const DynamicVector<Scalar>&,
                                             const Scalar& time) const {
        return points_.drift(time);
    }

    /// Evaluates it where it stands.
    void evaluate(const ConstraintState& at, ConstraintResult& out) const {
        out.violation = violation(at.q, at.time);
        out.jacobian = jacobian(at.q, at.time);
        out.rate = rate(at.q, at.time);
        out.convection = points_.drift_rate(at.time);
    }

private:
    detail::PointPair<Dimension> points_;
};

/// A pin's dimension is that of its place.
template <int Dimension>
Pin(MaterialPoint, Vector<double, Dimension>) -> Pin<Dimension>;

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
        : Distance(
              detail::PointPair<Dimension>(std::move(a), PointMotion<Dimension>::at_rest(place)),
              length) {
        require_place(place);
    }

    /// @throws InvalidArgument unless the length is positive, or if both are the same node.
    Distance(MaterialPoint a, MaterialPoint b, double length)
        : Distance(detail::PointPair<Dimension>(std::move(a), std::move(b)), length) {}

    /// @throws InvalidArgument unless the length is positive and the path complete.
    Distance(MaterialPoint a, PointMotion<Dimension> path, double length)
        : Distance(detail::PointPair<Dimension>(std::move(a), std::move(path)), length) {}

    /// A link whose length follows a motion, m.
    /// @throws InvalidArgument unless the motion is complete, or if both are the same node.
    Distance(MaterialPoint a, MaterialPoint b, Motion length)
        : points_(std::move(a), std::move(b)), length_(std::move(length)) {
        length_.check("Distance");
    }

    /// A link to a place whose length follows a motion, m.
    /// @throws InvalidArgument unless the place is finite and the motion complete.
    Distance(MaterialPoint a, const VectorArgument<Dimension>& place, Motion length)
        : points_(std::move(a), PointMotion<Dimension>::at_rest(place)),
          length_(std::move(length)) {
        require_place(place);
        length_.check("Distance");
    }

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return points_.coupling(); }
    /// Returns the number of equations.
    [[nodiscard]] int equations() const { return 1; }
    /// Returns the word that messages use.
    [[nodiscard]] std::string name() const { return "distance between " + points_.names(); }

    /// Returns g.
    template <class Scalar>
    [[nodiscard]] DynamicVector<Scalar> violation(const DynamicVector<Scalar>& q,
                                                  const Scalar& time) const {
        using std::sqrt;
        const Vector<Scalar, Dimension> d = points_.difference(q, time);
        const Scalar square = d.transpose() * d;
        return DynamicVector<Scalar>::Constant(
            1, sqrt(square) - detail::continued(length_.value, length_.rate, time));
    }

    /// Returns G = dg/dq.
    template <class Scalar>
    [[nodiscard]] DynamicMatrix<Scalar> jacobian(const DynamicVector<Scalar>& q,
                                                 const Scalar& time) const {
        const Vector<Scalar, Dimension> n = direction(q, time);
        DynamicMatrix<Scalar> g = DynamicMatrix<Scalar>::Zero(1, q.size());
        points_.for_each_weight([&](int k, double weight) {
            g.template middleCols<Dimension>(Dimension * k) = weight * n.transpose();
        });
        return g;
    }

    /// Returns g_t.
    template <class Scalar>
    [[nodiscard]] DynamicVector<Scalar> rate(const DynamicVector<Scalar>& q,
                                             const Scalar& time) const {
        const Scalar along = direction(q, time).transpose() * points_.drift(time);
        return DynamicVector<Scalar>::Constant(
            1, along - detail::continued(length_.rate, length_.acceleration, time));
    }

    /// Evaluates it where it stands.
    void evaluate(const ConstraintState& at, ConstraintResult& out) const;

private:
    static void require_place(const Vector<double, Dimension>& place) {
        detail::require(place.allFinite(), "Distance: the place must be finite, got ",
                        detail::components(place));
    }

    Distance(detail::PointPair<Dimension> points, double length)
        : points_(std::move(points)),
          length_{[length](double) { return length; }, [](double) { return 0.0; },
                  [](double) { return 0.0; }} {
        detail::require_positive("Distance: length", length);
    }

    template <class Scalar>
    [[nodiscard]] Vector<Scalar, Dimension> direction(const DynamicVector<Scalar>& q,
                                                      const Scalar& time) const {
        using std::sqrt;
        const Vector<Scalar, Dimension> d = points_.difference(q, time);
        const Scalar square = d.transpose() * d;
        return d / sqrt(square);
    }

    detail::PointPair<Dimension> points_;
    Motion length_;
};

/// A link's dimension is that of its place.
template <int Dimension, class Length>
Distance(MaterialPoint, Vector<double, Dimension>, Length) -> Distance<Dimension>;

template <int Dimension>
void Distance<Dimension>::evaluate(const ConstraintState& at, ConstraintResult& out) const {
    out.violation = violation(at.q, at.time);
    out.jacobian = jacobian(at.q, at.time);
    out.rate = rate(at.q, at.time);
    const Vector<double, Dimension> d = points_.difference(at.q, at.time);
    const double distance = d.norm();
    const Vector<double, Dimension> n = d / distance;
    const Matrix<double, Dimension> curvature =
        (Matrix<double, Dimension>::Identity() - n * n.transpose()) / distance;
    points_.for_each_weight([&](int i, double wi) {
        points_.for_each_weight([&](int j, double wj) {
            out.stiffness.template block<Dimension, Dimension>(Dimension * i, Dimension * j) =
                at.multipliers[0] * wi * wj * curvature;
        });
    });
    const Vector<double, Dimension> speed = points_.moved(at.v) + points_.drift(at.time);
    out.convection[0] = speed.dot(curvature * speed) + n.dot(points_.drift_rate(at.time)) -
                        length_.acceleration(at.time);
}

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
    Driven(Constraint constraint, std::vector<std::pair<int, Motion>> motions)
        : constraint_(std::move(constraint)), motions_(std::move(motions)) {
        for (const auto& [equation, motion] : motions_) {
            detail::require(equation >= 0 && equation < constraint_.equations(),
                            "Driven: ", constraint_.name(), " has ", constraint_.equations(),
                            " equations, got equation ", equation);
            motion.check("Driven");
        }
    }

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return constraint_.coupling(); }
    /// Returns the number of equations.
    [[nodiscard]] int equations() const { return constraint_.equations(); }
    /// Returns the word that messages use.
    [[nodiscard]] std::string name() const { return "driven " + constraint_.name(); }
    /// Returns the angle that the constraint itself is driven to, rad.
    [[nodiscard]] double driven_angle(double time) const {
        return detail::driven_angle(constraint_, time);
    }

    /// Returns g.
    template <class Scalar>
    [[nodiscard]] DynamicVector<Scalar> violation(const DynamicVector<Scalar>& q,
                                                  const Scalar& time) const {
        DynamicVector<Scalar> g = constraint_.violation(q, time);
        for (const auto& [equation, motion] : motions_)
            g[equation] -= detail::continued(motion.value, motion.rate, time);
        return g;
    }

    /// Returns G = dg/dq.
    template <class Scalar>
    [[nodiscard]] DynamicMatrix<Scalar> jacobian(const DynamicVector<Scalar>& q,
                                                 const Scalar& time) const {
        return constraint_.jacobian(q, time);
    }

    /// Returns g_t.
    template <class Scalar>
    [[nodiscard]] DynamicVector<Scalar> rate(const DynamicVector<Scalar>& q,
                                             const Scalar& time) const {
        DynamicVector<Scalar> g = constraint_.rate(q, time);
        for (const auto& [equation, motion] : motions_)
            g[equation] -= detail::continued(motion.rate, motion.acceleration, time);
        return g;
    }

    /// Evaluates it where it stands.
    void evaluate(const ConstraintState& at, ConstraintResult& out) const {
        constraint_.evaluate(at, out);
        for (const auto& [equation, motion] : motions_) {
            out.violation[equation] -= motion.value(at.time);
            out.rate[equation] -= motion.rate(at.time);
            out.convection[equation] -= motion.acceleration(at.time);
        }
    }

private:
    Constraint constraint_;
    std::vector<std::pair<int, Motion>> motions_;
};

}  // namespace ancf
