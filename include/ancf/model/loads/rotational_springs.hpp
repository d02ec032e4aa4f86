// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A spring and a damper that act on the angle of a hinge, in the plane and in space.
///
/// Neither is a hinge: place them beside a Revolute or, in the plane, a Pin. docs/theory-damping.md
/// derives both.

#pragma once

#include <ancf/element/vec3.hpp>
#include <ancf/error.hpp>
#include <ancf/model/constraints/joints.hpp>
#include <ancf/model/constraints/planar.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/load.hpp>
#include <ancf/model/model.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

#include <utility>

namespace ancf {
namespace detail {

/// The angle phi by which B has turned against A about an axis since it was made, within half a
/// turn; B may be space. phi = atan2(n_A.p_B, p_A.p_B), with p and n normal to the axis and to each
/// other, fixed in both frames.
class HingeAngle {
public:
    static constexpr int dimension = 3;  ///< of the model

    /// @throws InvalidArgument for an axis of no length, equal nodes or a node without a frame.
    HingeAngle(const char* user, const BasicModel<3>& model, const FrameAt& a, const FrameAt* b,
               const Vector<double, 3>& axis);

    [[nodiscard]] Coupling coupling() const;
    /// Returns phi, rad, and writes its gradient.
    [[nodiscard]] double value(const VectorX& q, VectorX& gradient) const;
    [[nodiscard]] MatrixX hessian(const VectorX& q) const;

private:
    JointSide a_, b_;
    Block<double> sine_, cosine_;
};

/// The same in the plane, of the sections' r_y, or of r_x where a node has no r_y.
class PlanarHingeAngle {
public:
    static constexpr int dimension = 2;  ///< of the model

    /// @throws InvalidArgument for equal nodes or a slope of no length.
    PlanarHingeAngle(const char* user, const BasicModel<2>& model, NodeId a, const NodeId* b);

    [[nodiscard]] Coupling coupling() const { return slopes_; }
    /// Returns phi, rad, and writes its gradient.
    [[nodiscard]] double value(const VectorX& q, VectorX& gradient) const;
    [[nodiscard]] MatrixX hessian(const VectorX& q) const;

private:
    Coupling slopes_;     // of A and, unless it is space, of B
    double start_ = 0.0;  // of the angle between them, rad
};

/// A moment -k phi about a hinge.
template <class Angle>
class HingeSpring {
public:
    static constexpr int dimension = Angle::dimension;  ///< of the model it belongs to
    static constexpr bool symmetric_stiffness = true;   ///< its stiffness is symmetric
    static constexpr bool in_full = true;               ///< it does not grow with a load factor

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return angle_.coupling(); }

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

protected:
    HingeSpring(Angle angle, double stiffness) : angle_(std::move(angle)), stiffness_(stiffness) {
        require_not_negative("rotational spring: the stiffness", stiffness);
    }

private:
    Angle angle_;
    double stiffness_;
};

/// A moment -c dphi/dt about a hinge.
template <class Angle>
class HingeDamper {
public:
    static constexpr int dimension = Angle::dimension;  ///< of the model it belongs to
    static constexpr bool in_full = true;               ///< it does not grow with a load factor

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return angle_.coupling(); }

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

protected:
    HingeDamper(Angle angle, double damping) : angle_(std::move(angle)), damping_(damping) {
        require_not_negative("rotational damper: the damping", damping);
    }

private:
    Angle angle_;
    double damping_;
};

}  // namespace detail

/// A linear spring of a hinge: it turns B back against A by the moment k phi, N m, phi their angle
/// about the axis since the model's state when the spring was made.
///
/// phi counts no turns: beyond pi the moment changes its sign.
class RotationalSpring : public detail::HingeSpring<detail::HingeAngle> {
public:
    /// @param axis       of the hinge, in global components as the model stands.
    /// @param stiffness  k >= 0, N m/rad
    /// @throws InvalidArgument for an axis of no length, equal nodes, a node without a frame or a
    ///         value that is negative or not finite.
    RotationalSpring(const BasicModel<3>& model, const FrameAt& a, const FrameAt& b,
                     const VectorArgument<3>& axis, double stiffness)
        : HingeSpring({"RotationalSpring", model, a, &b, axis}, stiffness) {}

    /// Between a node and space.
    /// @throws InvalidArgument as above.
    RotationalSpring(const BasicModel<3>& model, const FrameAt& a, const VectorArgument<3>& axis,
                     double stiffness)
        : HingeSpring({"RotationalSpring", model, a, nullptr, axis}, stiffness) {}
};

/// A linear damper of a hinge: it resists the rate of the angle by the moment c dphi/dt, N m.
///
/// Its stiffness is not symmetric: a run with it needs a linear solver of full storage.
class RotationalDamper : public detail::HingeDamper<detail::HingeAngle> {
public:
    /// @param axis     of the hinge, in global components as the model stands.
    /// @param damping  c >= 0, N m s/rad
    /// @throws InvalidArgument as RotationalSpring.
    RotationalDamper(const BasicModel<3>& model, const FrameAt& a, const FrameAt& b,
                     const VectorArgument<3>& axis, double damping)
        : HingeDamper({"RotationalDamper", model, a, &b, axis}, damping) {}

    /// Between a node and space.
    /// @throws InvalidArgument as RotationalSpring.
    RotationalDamper(const BasicModel<3>& model, const FrameAt& a, const VectorArgument<3>& axis,
                     double damping)
        : HingeDamper({"RotationalDamper", model, a, nullptr, axis}, damping) {}
};

/// A RotationalSpring in the plane, between sections (r_y) or, where a node has none, tangents.
class PlanarRotationalSpring : public detail::HingeSpring<detail::PlanarHingeAngle> {
public:
    /// @param stiffness  k >= 0, N m/rad
    /// @throws InvalidArgument for equal nodes, a slope of no length or a value that is negative or
    ///         not finite.
    PlanarRotationalSpring(const BasicModel<2>& model, NodeId a, NodeId b, double stiffness)
        : HingeSpring({"PlanarRotationalSpring", model, a, &b}, stiffness) {}

    /// Between a node and space.
    /// @throws InvalidArgument as above.
    PlanarRotationalSpring(const BasicModel<2>& model, NodeId a, double stiffness)
        : HingeSpring({"PlanarRotationalSpring", model, a, nullptr}, stiffness) {}
};

/// A RotationalDamper in the plane.
class PlanarRotationalDamper : public detail::HingeDamper<detail::PlanarHingeAngle> {
public:
    /// @param damping  c >= 0, N m s/rad
    /// @throws InvalidArgument as PlanarRotationalSpring.
    PlanarRotationalDamper(const BasicModel<2>& model, NodeId a, NodeId b, double damping)
        : HingeDamper({"PlanarRotationalDamper", model, a, &b}, damping) {}

    /// Between a node and space.
    /// @throws InvalidArgument as PlanarRotationalSpring.
    PlanarRotationalDamper(const BasicModel<2>& model, NodeId a, double damping)
        : HingeDamper({"PlanarRotationalDamper", model, a, nullptr}, damping) {}
};

#if defined(ANCF_COMPILED)
extern template class detail::HingeSpring<detail::HingeAngle>;
extern template class detail::HingeSpring<detail::PlanarHingeAngle>;
extern template class detail::HingeDamper<detail::HingeAngle>;
extern template class detail::HingeDamper<detail::PlanarHingeAngle>;
#endif

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/loads/rotational_springs.ipp>  // IWYU pragma: export
#endif
