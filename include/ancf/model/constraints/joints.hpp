// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Joints between node frames: revolute, driven revolute, weld, fixed orientation, universal,
/// aligned tangents; sections that keep their shape, as Reissner's beam has them, and rigid nodes.
///
/// The joints, but for FixedOrientation and AlignedTangent, hold the nodes' positions together, and
/// some angles between their frames by bilinear forms of the frames' axes. Axes are given in global
/// components as they stand when the joint is made; the joint keeps them fixed in the frames.
/// Equations in m come first, with multipliers in N, then those of angles (sines and cosines),
/// with multipliers in N m. Sines grow beyond pi/3 until pi (frames.hpp): no joint holds half a
/// turn off.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/element/vec3.hpp>
#include <ancf/list.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/model/constraints/motion.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/model.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace ancf {

/// A frame at a node.
///
/// By default that of its section: between r_y and r_z, so that a torque divides as the torsion of
/// the node's elements does (Layout::torsion_share), or, where a node has no r_z, t along r_x and n
/// the part of r_y normal to it. What a joint transmits then enters through the section.
/// Two slopes make the frame t along the first, n the part of the second normal to t: with r_x and
/// r_y the joint turns the tangent, and the shear of one element, of length l, passes the moment
/// M, N m, on. It is too soft by 3 M/(k G A l) rad: the more, the finer the mesh.
struct FrameAt {
    NodeId node;                ///< where
    bool of_section = true;     ///< the default; the slopes do not count then
    Field first = Field::r_x;   ///< along the axis t
    Field second = Field::r_y;  ///< in the plane of t and n

    /// The frame of a node's section.
    FrameAt(NodeId at) : node(at) {}  // NOLINT: a node has a frame

    /// @throws InvalidArgument unless both are of r_x, r_y, r_z and differ.
    FrameAt(NodeId at, Field along, Field across);
};

/// Returns the axes of a frame, t, n and t x n, as columns.
/// @param q  coordinates of the model, such as State::q; the axes are not finite where its slopes
///           are parallel.
/// @throws InvalidArgument for a node without a frame.
[[nodiscard]] Matrix<double, 3> frame_axes(const BasicModel<3>& model, const FrameAt& at,
                                           const VectorX& q);

namespace detail {

/// What a joint holds on one side.
enum class SideKind {
    space,    ///< a frame that rests
    frame,    ///< two slopes of a node
    section,  ///< r_y and r_z of a node
    tangent   ///< one slope of a node
};

/// One side of a joint as it stands when the joint is made.
struct JointSide {
    SideKind kind;
    FrameAt at = NodeId{};
    std::array<Vec3<double>, 3> axes = {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};  ///< at the start
    Vec3<double> place = {};  ///< of a frame that rests
    double share = 0.5;       ///< of r_y in a section's torque

    [[nodiscard]] int vectors() const noexcept {
        return kind == SideKind::space ? 0 : kind == SideKind::tangent ? 1 : 2;
    }
    [[nodiscard]] std::string name() const {
        return kind == SideKind::space ? "space" : "node " + std::to_string(at.node.index);
    }

    static JointSide frame(const BasicModel<3>& model, const FrameAt& at);
    static JointSide tangent(const BasicModel<3>& model, NodeId node);
    /// Space, at the place of a node.
    static JointSide space(const BasicModel<3>& model, NodeId at) {
        JointSide side{SideKind::space, NodeId{}};
        side.place = vec3<double>(model.position(at));
        return side;
    }
};

template <class Scalar>
struct Forms;

/// Positions held together (where asked) and angles of two frames held at zero.
///
/// The equations are F s_k with bilinear forms s_k. F is that of frames.hpp at a form c, the cosine
/// of the angle whose sine is |s|, or 1 where there is no such form.
class FrameJoint {
public:
    static constexpr int dimension = 3;  ///< of the model it belongs to

    [[nodiscard]] Coupling coupling() const;
    [[nodiscard]] int equations() const {
        return positions() + static_cast<int>(constants_.size());
    }
    [[nodiscard]] std::string name() const {
        return what_ + " of " + a_.name() + " and " + b_.name();
    }

    template <class Scalar>
    void terms(const DynamicVector<Scalar>& q, const Scalar& time,
               ConstraintTerms<Scalar>& out) const;
    void evaluate(const ConstraintState& at, ConstraintResult& out) const;

    [[nodiscard]] double driven_angle(double time) const {
        return angle_ ? angle_->value(time) : 0.0;
    }

protected:
    FrameJoint(std::string what, JointSide a, JointSide b, bool positions);
    /// Holds the positions and the frames of two nodes or, without b, of a node and space.
    FrameJoint(std::string what, const BasicModel<3>& model, const FrameAt& a, const FrameAt* b)
        : FrameJoint(std::move(what), JointSide::frame(model, a),
                     b == nullptr ? JointSide::space(model, a.node) : JointSide::frame(model, *b),
                     true) {}

    /// Adds the equation sum C_ij A_i.B_j = constant.
    void add_form(const Block<double>& coefficients, double constant = 0.0) {
        sines_.push_back(coefficients);
        constants_.push_back(constant);
    }

    /// Tells the cosine of the angle that the equations are the sine of.
    void hold_angle(const Block<double>& cosine) {
        cosine_ = cosine;
        angular_ = true;
    }

    /// Holds the frames' relative turn at that of the start, further turned about an axis of A.
    void hold_turn(const Vec3<double>& axis_in_a, std::optional<Motion> angle);

    [[nodiscard]] const JointSide& a() const noexcept { return a_; }
    [[nodiscard]] const JointSide& b() const noexcept { return b_; }

private:
    // The frames and the equations' forms at one place.
    template <class Scalar>
    struct At;

    [[nodiscard]] int positions() const noexcept { return pinned_ ? 3 : 0; }
    [[nodiscard]] int first_slope() const noexcept {
        return !pinned_ ? 0 : b_.kind == SideKind::space ? 3 : 6;
    }

    // The forms' coefficients at a time and, only where an angle is driven, their derivatives.
    template <class Scalar>
    [[nodiscard]] Forms<Scalar> forms(const Scalar& time) const;
    template <class Scalar>
    [[nodiscard]] Forms<Scalar> form_rates(const Scalar& time) const;
    [[nodiscard]] Forms<double> form_accelerations(double time) const;

    std::string what_;
    JointSide a_, b_;
    bool pinned_;
    List<Block<double>> sines_;  // forms at the start
    Block<double> cosine_ = {};  // form at the start
    List<double> constants_;     // of the sines
    double cosine_constant_ = 0.0;
    bool angular_ = false;         // the sines are of an angle that has the cosine
    Block<double> relative_ = {};  // R_A^T R_B at the start
    Block<double> turn_ = {};      // [axis]x in A
    std::optional<Motion> angle_;
};

}  // namespace detail

/// A hinge: positions held together, and an axis fixed in both frames; 5 equations.
///
/// With w the axis in A and u, v normal to it in B: F w.u = 0, F w.v = 0.
class Revolute : public detail::FrameJoint {
public:
    /// @param axis  in global components, as the model stands.
    /// @throws InvalidArgument for an axis of no length, equal nodes or a node without a frame.
    Revolute(const BasicModel<3>& model, const FrameAt& a, const FrameAt& b,
             const VectorArgument<3>& axis)
        : Revolute(model, a, &b, axis) {}

    /// A hinge to space, at the place where the node stands.
    /// @param axis  in global components, as the model stands.
    /// @throws InvalidArgument for an axis of no length or a node without a frame.
    Revolute(const BasicModel<3>& model, const FrameAt& a, const VectorArgument<3>& axis)
        : Revolute(model, a, nullptr, axis) {}

private:
    Revolute(const BasicModel<3>& model, const FrameAt& a, const FrameAt* b,
             const Vector<double, 3>& axis);
};

/// Positions and frames held together at the angle of the start; 6 equations.
///
/// The last three are F sin(angle) times the axis of the frames' relative turn since the start, in
/// A.
class Weld : public detail::FrameJoint {
public:
    /// @throws InvalidArgument for equal nodes or a node without a frame.
    Weld(const BasicModel<3>& model, const FrameAt& a, const FrameAt& b) : Weld(model, a, &b) {}

    /// A weld to space, as the node stands.
    /// @throws InvalidArgument for a node without a frame.
    Weld(const BasicModel<3>& model, const FrameAt& a) : Weld(model, a, nullptr) {}

private:
    Weld(const BasicModel<3>& model, const FrameAt& a, const FrameAt* b)
        : FrameJoint("weld", model, a, b) {
        hold_turn({{1.0, 0.0, 0.0}}, std::nullopt);
    }
};

/// The frames of two nodes held at the turn of the start, while their positions are free; 3
/// equations, as the last three of Weld. With a Slider (slider.hpp) it makes a prismatic joint.
class FixedOrientation : public detail::FrameJoint {
public:
    /// @throws InvalidArgument for equal nodes or a node without a frame.
    FixedOrientation(const BasicModel<3>& model, const FrameAt& a, const FrameAt& b)
        : FrameJoint("fixed orientation", detail::JointSide::frame(model, a),
                     detail::JointSide::frame(model, b), false) {
        hold_turn({{1.0, 0.0, 0.0}}, std::nullopt);
    }
};

/// A hinge whose angle is prescribed: B turns about the axis against A by angle(t) since the start;
/// 6 equations. The last three multipliers are the moment on A, N m, along t, n and t x n of A's
/// frame. Its component along the axis is the motor's.
class DrivenRevolute : public detail::FrameJoint {
public:
    /// @param axis   in global components, as the model stands.
    /// @param angle  rad, of time in s.
    /// @throws InvalidArgument for an axis of no length, a motion that is not complete, equal nodes
    ///         or a node without a frame.
    DrivenRevolute(const BasicModel<3>& model, const FrameAt& a, const FrameAt& b,
                   const VectorArgument<3>& axis, Motion angle)
        : DrivenRevolute(model, a, &b, axis, std::move(angle)) {}

    /// A driven hinge to space: the node turns by -angle(t) against space.
    /// @param axis   in global components, as the model stands.
    /// @param angle  rad, of time in s.
    /// @throws InvalidArgument for an axis of no length, a motion that is not complete or a node
    ///         without a frame.
    DrivenRevolute(const BasicModel<3>& model, const FrameAt& a, const VectorArgument<3>& axis,
                   Motion angle)
        : DrivenRevolute(model, a, nullptr, axis, std::move(angle)) {}

private:
    DrivenRevolute(const BasicModel<3>& model, const FrameAt& a, const FrameAt* b,
                   const Vector<double, 3>& axis, Motion angle);
};

/// A universal (Cardan) joint: positions held together, and the angle between an axis of A and one
/// of B kept; 4 equations.
class Universal : public detail::FrameJoint {
public:
    /// @param axis_of_a, axis_of_b  in global components, as the model stands.
    /// @throws InvalidArgument for axes of no length or parallel, equal nodes or a node without a
    ///         frame.
    Universal(const BasicModel<3>& model, const FrameAt& a, const FrameAt& b,
              const VectorArgument<3>& axis_of_a, const VectorArgument<3>& axis_of_b)
        : Universal(model, a, &b, axis_of_a, axis_of_b) {}

    /// A universal joint to space.
    /// @throws InvalidArgument for axes of no length or parallel, or a node without a frame.
    Universal(const BasicModel<3>& model, const FrameAt& a, const VectorArgument<3>& axis_of_a,
              const VectorArgument<3>& axis_of_space)
        : Universal(model, a, nullptr, axis_of_a, axis_of_space) {}

private:
    Universal(const BasicModel<3>& model, const FrameAt& a, const FrameAt* b,
              const Vector<double, 3>& axis_of_a, const Vector<double, 3>& axis_of_b);
};

/// The tangent r_x of a node kept in the direction that it has in another node's frame, or in
/// space; 2 equations. With a Pin it welds a cable, whose node has no frame, to a beam or to space.
class AlignedTangent : public detail::FrameJoint {
public:
    /// @throws InvalidArgument for equal nodes, a node without a frame or a tangent of no length.
    AlignedTangent(const BasicModel<3>& model, const FrameAt& frame, NodeId tangent)
        : AlignedTangent(model, detail::JointSide::frame(model, frame), tangent) {}

    /// The direction kept in space.
    /// @throws InvalidArgument for a tangent of no length.
    AlignedTangent(const BasicModel<3>& model, NodeId tangent)
        : AlignedTangent(model, detail::JointSide::space(model, tangent), tangent) {}

private:
    AlignedTangent(const BasicModel<3>& model, detail::JointSide frame, NodeId tangent);
};

namespace detail {

/// Slopes s of a node held orthonormal: g = (s_a.s_a - 1)/2 of each, then s_a.s_b of pairs.
template <int Dimension>
class HeldSlopes {
public:
    static constexpr int dimension = Dimension;  ///< of the model it belongs to

    [[nodiscard]] Coupling coupling() const { return slopes_; }
    [[nodiscard]] int equations() const { return count() * (count() + 1) / 2; }
    [[nodiscard]] std::string name() const {
        return what_ + " of node " + std::to_string(slopes_.front().node.index);
    }
    template <class Scalar>
    void terms(const DynamicVector<Scalar>& q, const Scalar& time,
               ConstraintTerms<Scalar>& out) const;
    void evaluate(const ConstraintState& at, ConstraintResult& out) const;

protected:
    HeldSlopes(std::string what, Coupling slopes)
        : what_(std::move(what)), slopes_(std::move(slopes)) {}

private:
    [[nodiscard]] int count() const { return static_cast<int>(slopes_.size()); }
    // Calls visit(row, a, b) for each equation, the product of slopes a and b.
    template <class Visit>
    void for_each_product(const Visit& visit) const;

    std::string what_;
    Coupling slopes_;
};

}  // namespace detail

/// The section of a node held in shape: r_y and r_z of unit length and normal to each other;
/// 3 equations, g = ((r_y.r_y - 1)/2, (r_z.r_z - 1)/2, r_y.r_z).
///
/// With Green's strain, bending about an axis other than the section's y and z shears the section
/// by E I kappa^2/(2 k G A), which counts at a radius of a few depths: docs/limits.md.
class RigidSection : public detail::HeldSlopes<3> {
public:
    /// Holds the section of a node that carries r_y and r_z.
    explicit RigidSection(NodeId node)
        : HeldSlopes("rigid section", {{node, Field::r_y}, {node, Field::r_z}}) {}
};

/// All slopes of a node held orthonormal, as the frame of a rigid body; 6 equations, in the plane
/// 3: (s.s - 1)/2 of r_x, r_y (and r_z), then r_x.r_y (r_x.r_z and r_y.r_z).
template <int Dimension>
class RigidNode : public detail::HeldSlopes<Dimension> {
public:
    /// Holds the slopes of a node that carries all of them.
    explicit RigidNode(NodeId node) : detail::HeldSlopes<Dimension>("rigid node", slopes(node)) {}

private:
    [[nodiscard]] static Coupling slopes(NodeId node) {
        Coupling all = {{node, Field::r_x}, {node, Field::r_y}};
        if constexpr (Dimension == 3) all.push_back({node, Field::r_z});
        return all;
    }
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/constraints/joints.ipp>  // IWYU pragma: export
#endif
