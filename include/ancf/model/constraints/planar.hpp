// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Joints of the plane: welds at any angle and driven hinges. A hinge of the plane is a Pin<2>.
///
/// The angle th of a slope p has dth = (p x dp)/|p|^2. The joint holds F sin psi = 0 with
/// psi = th_b - th_a - phi(t) and the factor of frames.hpp, without which psi = pi were a root too.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/model/constraints/motion.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/model.hpp>
#include <ancf/types.hpp>

#include <optional>
#include <string>
#include <utility>

namespace ancf {

/// Returns the angle of a node's section, rad, from -pi to pi: that of r_y less a right angle, or,
/// where the node has no r_y, of r_x.
/// @param q  coordinates of the model, such as State::q.
/// @throws InvalidArgument for a node without these vectors.
[[nodiscard]] double section_angle(const BasicModel<2>& model, NodeId node, const VectorX& q);

/// Positions and the angle between two slopes held, or that angle driven; 3 equations.
class PlanarWeld {
public:
    static constexpr int dimension = 2;  ///< of the model it belongs to

    /// @param slope  whose direction counts on both sides; without it r_y, the section's, where a
    ///               node carries it, and r_x elsewhere.
    /// @throws InvalidArgument for equal nodes, the field r, a slope of no length or a motion that
    ///         is not complete.
    PlanarWeld(const BasicModel<2>& model, NodeId a, NodeId b, std::optional<Field> slope = {})
        : PlanarWeld(model, a, b, detail::resting_at(0.0), slope) {}

    /// As above, the angle driven.
    /// @param angle  counterclockwise from the direction of a to that of b, rad; added to the
    ///               angle of the start.
    PlanarWeld(const BasicModel<2>& model, NodeId a, NodeId b, Motion angle,
               std::optional<Field> slope = {})
        : PlanarWeld(model, a, &b, std::move(angle), slope) {}

    /// A weld to space, at the node's place.
    explicit PlanarWeld(const BasicModel<2>& model, NodeId a, std::optional<Field> slope = {})
        : PlanarWeld(model, a, detail::resting_at(0.0), slope) {}

    /// A driven hinge to space: the node turns by -angle(t).
    PlanarWeld(const BasicModel<2>& model, NodeId a, Motion angle, std::optional<Field> slope = {})
        : PlanarWeld(model, a, nullptr, std::move(angle), slope) {}

    /// @{
    /// As of every constraint, see AnyConstraint.
    [[nodiscard]] Coupling coupling() const {
        if (to_space_) return {{a_, Field::r}, {a_, slope_a_}};
        return {{a_, Field::r}, {b_, Field::r}, {a_, slope_a_}, {b_, slope_b_}};
    }
    [[nodiscard]] int equations() const { return 3; }
    [[nodiscard]] std::string name() const {
        return "planar weld of node " + std::to_string(a_.index) + " and " +
               (to_space_ ? std::string("space") : "node " + std::to_string(b_.index));
    }

    /// Returns the angle that it is driven to, rad.
    [[nodiscard]] double driven_angle(double time) const { return angle_.value(time); }
    template <class Scalar>
    void terms(const DynamicVector<Scalar>& q, const Scalar& time,
               ConstraintTerms<Scalar>& out) const;
    void evaluate(const ConstraintState& at, ConstraintResult& out) const;
    /// @}

private:
    // Without b it holds a to space.
    PlanarWeld(const BasicModel<2>& model, NodeId a, const NodeId* b, Motion angle,
               std::optional<Field> slope);

    // F sin psi and its derivatives with respect to psi = th_b - th_a - start - phi; of complex
    // numbers the second is not continued.
    template <class Scalar>
    struct Held {
        Scalar value, first, second;
    };

    template <class Scalar>
    [[nodiscard]] Held<Scalar> held(const DynamicVector<Scalar>& q, const Scalar& time) const;

    [[nodiscard]] int first_slope() const noexcept { return to_space_ ? 2 : 4; }

    NodeId a_, b_;
    bool to_space_;
    Field slope_a_, slope_b_;
    Motion angle_;
    double start_ = 0.0;  // th_b - th_a at the start, rad
    Vector<double, 2> place_ = Vector<double, 2>::Zero();
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/constraints/planar.ipp>  // IWYU pragma: export
#endif
