// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Joints between node frames: revolute, driven revolute, weld, universal, aligned tangents.
///
/// Each holds the nodes' positions together and some angles between their frames
/// (constraints_frames.hpp) by bilinear forms of the frames' axes. Axes are given in global
/// components as they stand when the joint is made; the joint keeps them fixed in the frames.
/// Equations in m come first, with multipliers in N, then those of angles (sines and cosines), with
/// multipliers in N m. Sines grow beyond pi/3 until pi (turn.hpp): no joint holds half a turn off.

#pragma once

#include <ancf/error.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/model/constraints_frames.hpp>
#include <ancf/model/constraints_motion.hpp>
#include <ancf/model/constraints_points.hpp>
#include <ancf/model/node.hpp>
#include <ancf/model/turn.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ancf {

namespace detail {

/// One side of a joint as it stands when the joint is made.
struct JointSide {
    SideKind kind;
    FrameAt at = NodeId{};
    Matrix<double, 3> axes = Matrix<double, 3>::Identity();  ///< at the start; for space always
    Vector<double, 3> place = Vector<double, 3>::Zero();     ///< at the start
    double share = 0.5;                                      ///< of r_y in a section's torque

    [[nodiscard]] int vectors() const noexcept {
        return kind == SideKind::space ? 0 : kind == SideKind::tangent ? 1 : 2;
    }

    [[nodiscard]] std::string name() const {
        return kind == SideKind::space ? "space" : "node " + std::to_string(at.node.index);
    }

    template <class Scene>
    static JointSide frame(const Scene& model, const FrameAt& at) {
        static_assert(Scene::dimension == 3, "joints of frames are of three dimensions");
        JointSide side{SideKind::frame, at};
        if (at.of_section && model.layout().index({at.node, Field::r_z}) >= 0) {
            side.kind = SideKind::section;
            side.at.first = Field::r_y;
            side.at.second = Field::r_z;
            side.share = model.layout().torsion_share(at.node);
        }
        const Vector<double, 3> p = model.value(at.node, side.at.first);
        const Vector<double, 3> a = model.value(at.node, side.at.second);
        side.axes = side.triad_of<double>(p, a).axes;
        side.place = model.position(at.node);
        require(side.axes.allFinite(), "a joint needs a frame: the slopes of node ", at.node.index,
                " are parallel or of no length");
        return side;
    }

    template <class Scene>
    static JointSide tangent(const Scene& model, NodeId node) {
        static_assert(Scene::dimension == 3, "joints of frames are of three dimensions");
        JointSide side{SideKind::tangent, node};
        side.axes = Triad<double>::of_tangent(model.value(node, Field::r_x)).axes;
        require(side.axes.allFinite(), "a joint needs a tangent: r_x of node ", node.index,
                " has no length");
        return side;
    }

    /// Space, at the place of a node.
    template <class Scene>
    static JointSide space(const Scene& model, NodeId at) {
        JointSide side{SideKind::space, NodeId{}};
        side.place = model.position(at);
        return side;
    }

    /// Evaluates the side at its slopes, which start at q[first].
    template <class Scalar>
    [[nodiscard]] Triad<Scalar> triad(const DynamicVector<Scalar>& q, int first) const {
        if (kind == SideKind::space) return Triad<Scalar>::at_rest(axes);
        const Vector<Scalar, 3> p = q.template segment<3>(first);
        if (kind == SideKind::tangent) return Triad<Scalar>::of_tangent(p);
        return triad_of<Scalar>(p, q.template segment<3>(first + 3));
    }

    template <class Scalar>
    [[nodiscard]] Triad<Scalar> triad_of(const Vector<Scalar, 3>& p,
                                         const Vector<Scalar, 3>& a) const {
        return kind == SideKind::section ? Triad<Scalar>::of_section(p, a, share)
                                         : Triad<Scalar>::of_slopes(p, a);
    }
};

/// Returns two unit vectors normal to a unit vector and to each other.
[[nodiscard]] inline std::array<Vector<double, 3>, 2> normals_of(const Vector<double, 3>& axis) {
    int smallest = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(axis[k]) < std::abs(axis[smallest])) smallest = k;
    Vector<double, 3> other = Vector<double, 3>::Zero();
    other[smallest] = 1.0;
    const Vector<double, 3> normal = cross(axis, other), u = normal / normal.norm();
    return {u, cross(axis, u)};
}

[[nodiscard]] inline Vector<double, 3> unit_axis(const char* joint, const Vector<double, 3>& axis) {
    const double length = axis.norm();
    require(std::isfinite(length) && length > 0.0, joint, ": the axis must have a length, got ",
            detail::components(axis));
    return axis / length;
}

/// Returns R^T v: the components of v in a frame.
[[nodiscard]] inline Vector<double, 3> turned_back(const Matrix<double, 3>& axes,
                                                   const Vector<double, 3>& v) {
    Vector<double, 3> out;
    for (int k = 0; k < 3; ++k) out[k] = axes(0, k) * v[0] + axes(1, k) * v[1] + axes(2, k) * v[2];
    return out;
}

/// Returns u v^T.
[[nodiscard]] inline Matrix<double, 3> outer(const Vector<double, 3>& u,
                                             const Vector<double, 3>& v) {
    Matrix<double, 3> out;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) out(i, j) = u[i] * v[j];
    return out;
}

/// Coefficients of the bilinear forms of a joint.
template <class Scalar>
struct Forms {
    std::vector<Matrix<Scalar, 3>> sines;
    Matrix<Scalar, 3> cosine = Matrix<Scalar, 3>::Zero();
};

/// Returns the forms whose values are the axis times the sine of the turn of R_A^T R_B against Q,
/// and its cosine + 1/2.
template <class Scalar>
[[nodiscard]] Forms<Scalar> turn_forms(const Matrix<Scalar, 3>& relative) {
    Forms<Scalar> forms;
    forms.sines.assign(3, Matrix<Scalar, 3>::Zero());
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 2) % 3;
        const int j = (k + 1) % 3;
        Matrix<Scalar, 3>& sine = forms.sines[static_cast<std::size_t>(k)];
        for (int l = 0; l < 3; ++l) {
            sine(i, l) = Scalar(0.5) * relative(j, l);
            sine(j, l) = Scalar(-0.5) * relative(i, l);
            forms.cosine(k, l) = Scalar(0.5) * relative(k, l);
        }
    }
    return forms;
}

/// Derivatives of a bilinear form: by the slopes, and by time without what accelerations make.
struct FormCourse {
    Vector<double, 12> gradient;
    Matrix<double, 12> hessian;
    double speed = 0.0, bend = 0.0;  ///< first and second

    /// Of coefficients at rest, with the slopes' rates v.
    FormCourse(const Matrix<double, 3>& coefficients, const Triad<double>& a,
               const Triad<double>& b, const Vector<double, 12>& v)
        : gradient(FrameForm<double>(coefficients, a, b).gradient(a, b)),
          hessian(frame_form_hessian(coefficients, a, b)) {
        for (int j = 0; j < 12; ++j) {
            speed += gradient[j] * v[j];
            for (int i = 0; i < 12; ++i) bend += v[i] * hessian(i, j) * v[j];
        }
    }

    /// Adds what moving coefficients make: g_t, and 2 (g_t)_q v + g_tt.
    void move(const Matrix<double, 3>& rate, const Matrix<double, 3>& acceleration,
              const Triad<double>& a, const Triad<double>& b, const Vector<double, 12>& v) {
        const FrameForm<double> form(rate, a, b);
        const Vector<double, 12> by_slopes = form.gradient(a, b);
        speed += form.value;
        for (int i = 0; i < 12; ++i) bend += 2.0 * by_slopes[i] * v[i];
        bend += FrameForm<double>(acceleration, a, b).value;
    }
};

/// Positions held together (where asked) and angles of two frames held at zero.
///
/// The equations are F s_k with bilinear forms s_k. F is that of turn.hpp at a form c, the cosine
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
    [[nodiscard]] DynamicVector<Scalar> violation(const DynamicVector<Scalar>& q,
                                                  const Scalar& time) const;
    template <class Scalar>
    [[nodiscard]] DynamicMatrix<Scalar> jacobian(const DynamicVector<Scalar>& q,
                                                 const Scalar& time) const;
    template <class Scalar>
    [[nodiscard]] DynamicVector<Scalar> rate(const DynamicVector<Scalar>& q,
                                             const Scalar& time) const;

    void evaluate(const ConstraintState& at, ConstraintResult& out) const;

    [[nodiscard]] double driven_angle(double time) const {
        return angle_ ? angle_->value(time) : 0.0;
    }

protected:
    FrameJoint(std::string what, JointSide a, JointSide b, bool positions)
        : what_(std::move(what)), a_(std::move(a)), b_(std::move(b)), pinned_(positions) {
        require(
            a_.kind == SideKind::space || b_.kind == SideKind::space || a_.at.node != b_.at.node,
            "a ", what_, " joins two nodes, got node ", a_.at.node.index, " twice");
    }

    /// Adds the equation sum C_ij A_i.B_j = constant.
    void add_form(const Matrix<double, 3>& coefficients, double constant = 0.0) {
        forms_.sines.push_back(coefficients);
        constants_.push_back(constant);
    }

    /// Tells the cosine of the angle that the equations are the sine of.
    void hold_angle(const Matrix<double, 3>& cosine) {
        forms_.cosine = cosine;
        angular_ = true;
    }

    /// Holds the frames' relative turn at that of the start, further turned about an axis of A.
    void hold_turn(const Vector<double, 3>& axis_in_a, std::optional<Motion> angle) {
        relative_ = a_.axes.transpose() * b_.axes;
        turn_ = cross_matrix(axis_in_a);
        angle_ = std::move(angle);
        const Forms<double> forms = turn_forms<double>(relative_);
        for (const Matrix<double, 3>& form : forms.sines) add_form(form);
        hold_angle(forms.cosine);
        cosine_constant_ = 0.5;
    }

    [[nodiscard]] const JointSide& a() const noexcept { return a_; }
    [[nodiscard]] const JointSide& b() const noexcept { return b_; }

private:
    [[nodiscard]] int positions() const noexcept { return pinned_ ? 3 : 0; }
    [[nodiscard]] int first_slope() const noexcept {
        return !pinned_ ? 0 : b_.kind == SideKind::space ? 3 : 6;
    }

    template <class Scalar>
    struct Frames {
        Triad<Scalar> a, b;
    };

    template <class Scalar>
    [[nodiscard]] Frames<Scalar> frames(const DynamicVector<Scalar>& q) const {
        return {a_.triad(q, first_slope()), b_.triad(q, first_slope() + 3 * a_.vectors())};
    }

    /// The equations' forms at one place; the sines and the cosine less their constants.
    template <class Scalar>
    struct Rows {
        std::vector<FrameForm<Scalar>> sines;
        FrameForm<Scalar> cosine;
        TurnFactor<Scalar> factor = {};
    };

    template <class Scalar>
    [[nodiscard]] Rows<Scalar> rows(const Frames<Scalar>& f, const Scalar& time) const {
        const Forms<Scalar> at = forms(time);
        Rows<Scalar> out{{}, FrameForm<Scalar>(at.cosine, f.a, f.b)};
        out.cosine.value -= Scalar(cosine_constant_);
        double square = 0.0;
        for (std::size_t k = 0; k < at.sines.size(); ++k) {
            out.sines.emplace_back(at.sines[k], f.a, f.b);
            out.sines[k].value -= Scalar(constants_[k]);
            square += std::real(out.sines[k].value) * std::real(out.sines[k].value);
        }
        if (angular_) out.factor = turn_factor(std::sqrt(square), out.cosine.value);
        return out;
    }

    /// Returns the coefficients at a time.
    template <class Scalar>
    [[nodiscard]] Forms<Scalar> forms(const Scalar& time) const {
        if (angle_) {
            const Scalar angle = continued(angle_->value, angle_->rate, time);
            return turn_forms<Scalar>(rotation_about(turn_, angle) *
                                      relative_.template cast<Scalar>());
        }
        Forms<Scalar> out;
        for (const Matrix<double, 3>& form : forms_.sines)
            out.sines.push_back(form.template cast<Scalar>());
        out.cosine = forms_.cosine.template cast<Scalar>();
        return out;
    }

    /// Returns the coefficients' rate of change; only where an angle is driven.
    template <class Scalar>
    [[nodiscard]] Forms<Scalar> form_rates(const Scalar& time) const {
        const Scalar angle = continued(angle_->value, angle_->rate, time);
        const Scalar speed = continued(angle_->rate, angle_->acceleration, time);
        return turn_forms<Scalar>(speed * turn_.template cast<Scalar>() *
                                  rotation_about(turn_, angle) * relative_.template cast<Scalar>());
    }

    /// Returns the coefficients' second derivative; only where an angle is driven.
    [[nodiscard]] Forms<double> form_accelerations(double time) const {
        const double speed = angle_->rate(time);
        const Matrix<double, 3> bend =
            angle_->acceleration(time) * turn_ + speed * speed * turn_ * turn_;
        const Matrix<double, 3> turned = rotation_about(turn_, angle_->value(time)) * relative_;
        return turn_forms<double>(bend * turned);
    }

    /// Returns the derivatives of the sines and, where the factor varies, of the cosine after them.
    [[nodiscard]] std::vector<FormCourse> courses(const ConstraintState& at,
                                                  const Frames<double>& f, bool varies) const;

    std::string what_;
    JointSide a_, b_;
    bool pinned_;
    Forms<double> forms_;  // at the start
    std::vector<double> constants_;
    double cosine_constant_ = 0.0;
    bool angular_ = false;  // the sines are of an angle that has the cosine
    Matrix<double, 3> relative_ = Matrix<double, 3>::Identity();  // R_A^T R_B at the start
    Matrix<double, 3> turn_ = Matrix<double, 3>::Zero();          // [axis]x in A
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
    template <class Scene>
    Revolute(const Scene& model, const FrameAt& a, const FrameAt& b, const VectorArgument<3>& axis)
        : FrameJoint("revolute joint", detail::JointSide::frame(model, a),
                     detail::JointSide::frame(model, b), true) {
        hold(axis);
    }

    /// A hinge to space, at the place where the node stands.
    /// @param axis  in global components, as the model stands.
    /// @throws InvalidArgument for an axis of no length or a node without a frame.
    template <class Scene>
    Revolute(const Scene& model, const FrameAt& a, const VectorArgument<3>& axis)
        : FrameJoint("revolute joint", detail::JointSide::frame(model, a),
                     detail::JointSide::space(model, a.node), true) {
        hold(axis);
    }

private:
    void hold(const Vector<double, 3>& axis) {
        const Vector<double, 3> unit = detail::unit_axis("Revolute", axis);
        const Vector<double, 3> w = detail::turned_back(a().axes, unit);
        for (const Vector<double, 3>& normal : detail::normals_of(unit))
            add_form(detail::outer(w, detail::turned_back(b().axes, normal)));
        hold_angle(detail::outer(w, detail::turned_back(b().axes, unit)));
    }
};

/// Positions and frames held together at the angle of the start; 6 equations.
///
/// The last three are F sin(angle) times the axis of the frames' relative turn since the start, in
/// A.
class Weld : public detail::FrameJoint {
public:
    /// @throws InvalidArgument for equal nodes or a node without a frame.
    template <class Scene>
    Weld(const Scene& model, const FrameAt& a, const FrameAt& b)
        : FrameJoint("weld", detail::JointSide::frame(model, a), detail::JointSide::frame(model, b),
                     true) {
        hold_turn(Vector<double, 3>::UnitX(), std::nullopt);
    }

    /// A weld to space, as the node stands.
    /// @throws InvalidArgument for a node without a frame.
    template <class Scene>
    Weld(const Scene& model, const FrameAt& a)
        : FrameJoint("weld", detail::JointSide::frame(model, a),
                     detail::JointSide::space(model, a.node), true) {
        hold_turn(Vector<double, 3>::UnitX(), std::nullopt);
    }
};

/// A hinge whose angle is prescribed: B turns about the axis against A by angle(t) since the start;
/// 6 equations. The multiplier of the axis is the motor's moment.
class DrivenRevolute : public detail::FrameJoint {
public:
    /// @param axis   in global components, as the model stands.
    /// @param angle  rad, of time in s.
    /// @throws InvalidArgument for an axis of no length, a motion that is not complete, equal nodes
    ///         or a node without a frame.
    template <class Scene>
    DrivenRevolute(const Scene& model, const FrameAt& a, const FrameAt& b,
                   const VectorArgument<3>& axis, Motion angle)
        : FrameJoint("driven revolute joint", detail::JointSide::frame(model, a),
                     detail::JointSide::frame(model, b), true) {
        hold(axis, std::move(angle));
    }

    /// A driven hinge to space: the node turns by -angle(t) against space.
    /// @param axis   in global components, as the model stands.
    /// @param angle  rad, of time in s.
    /// @throws InvalidArgument for an axis of no length, a motion that is not complete or a node
    ///         without a frame.
    template <class Scene>
    DrivenRevolute(const Scene& model, const FrameAt& a, const VectorArgument<3>& axis,
                   Motion angle)
        : FrameJoint("driven revolute joint", detail::JointSide::frame(model, a),
                     detail::JointSide::space(model, a.node), true) {
        hold(axis, std::move(angle));
    }

private:
    void hold(const Vector<double, 3>& axis, Motion angle) {
        angle.check("DrivenRevolute");
        hold_turn(detail::turned_back(a().axes, detail::unit_axis("DrivenRevolute", axis)),
                  std::move(angle));
    }
};

/// A universal (Cardan) joint: positions held together, and the angle between an axis of A and one
/// of B kept; 4 equations.
class Universal : public detail::FrameJoint {
public:
    /// @param axis_of_a, axis_of_b  in global components, as the model stands.
    /// @throws InvalidArgument for axes of no length or parallel, equal nodes or a node without a
    ///         frame.
    template <class Scene>
    Universal(const Scene& model, const FrameAt& a, const FrameAt& b,
              const VectorArgument<3>& axis_of_a, const VectorArgument<3>& axis_of_b)
        : FrameJoint("universal joint", detail::JointSide::frame(model, a),
                     detail::JointSide::frame(model, b), true) {
        hold(axis_of_a, axis_of_b);
    }

    /// A universal joint to space.
    /// @throws InvalidArgument for axes of no length or parallel, or a node without a frame.
    template <class Scene>
    Universal(const Scene& model, const FrameAt& a, const VectorArgument<3>& axis_of_a,
              const VectorArgument<3>& axis_of_space)
        : FrameJoint("universal joint", detail::JointSide::frame(model, a),
                     detail::JointSide::space(model, a.node), true) {
        hold(axis_of_a, axis_of_space);
    }

private:
    void hold(const Vector<double, 3>& axis_of_a, const Vector<double, 3>& axis_of_b) {
        const Vector<double, 3> u = detail::unit_axis("Universal", axis_of_a);
        const Vector<double, 3> w = detail::unit_axis("Universal", axis_of_b);
        detail::require(cross(u, w).norm() > 1e-3, "Universal: the axes must not be parallel, got ",
                        detail::components(axis_of_a), " and ", detail::components(axis_of_b));
        add_form(detail::outer(detail::turned_back(a().axes, u), detail::turned_back(b().axes, w)),
                 u.dot(w));
    }
};

/// The tangent r_x of a node kept in the direction that it has in another node's frame, or in
/// space; 2 equations. With a Pin it welds a cable, whose node has no frame, to a beam or to space.
class AlignedTangent : public detail::FrameJoint {
public:
    /// @throws InvalidArgument for equal nodes, a node without a frame or a tangent of no length.
    template <class Scene>
    AlignedTangent(const Scene& model, const FrameAt& frame, NodeId tangent)
        : FrameJoint("aligned tangent", detail::JointSide::frame(model, frame),
                     detail::JointSide::tangent(model, tangent), false) {
        hold();
    }

    /// The direction kept in space.
    /// @throws InvalidArgument for a tangent of no length.
    template <class Scene>
    AlignedTangent(const Scene& model, NodeId tangent)
        : FrameJoint("aligned tangent", detail::JointSide::space(model, tangent),
                     detail::JointSide::tangent(model, tangent), false) {
        hold();
    }

private:
    void hold() {
        const Vector<double, 3> t = b().axes.col(0);
        for (const Vector<double, 3>& normal : detail::normals_of(t))
            add_form(detail::outer(detail::turned_back(a().axes, normal), {1.0, 0.0, 0.0}));
        hold_angle(detail::outer(detail::turned_back(a().axes, t), {1.0, 0.0, 0.0}));
    }
};

namespace detail {

inline Coupling FrameJoint::coupling() const {
    Coupling all;
    if (pinned_) all.push_back({a_.at.node, Field::r});
    if (pinned_ && b_.kind != SideKind::space) all.push_back({b_.at.node, Field::r});
    for (const JointSide* side : {&a_, &b_}) {
        if (side->vectors() >= 1) all.push_back({side->at.node, side->at.first});
        if (side->vectors() == 2) all.push_back({side->at.node, side->at.second});
    }
    return all;
}

template <class Scalar>
DynamicVector<Scalar> FrameJoint::violation(const DynamicVector<Scalar>& q,
                                            const Scalar& time) const {
    DynamicVector<Scalar> g(equations());
    if (pinned_) {
        for (int k = 0; k < 3; ++k)
            g[k] = q[k] - (b_.kind == SideKind::space ? Scalar(b_.place[k]) : q[3 + k]);
    }
    const Frames<Scalar> f = frames(q);
    const Rows<Scalar> at = rows(f, time);
    int row = positions();
    for (const FrameForm<Scalar>& sine : at.sines) g[row++] = at.factor.value * sine.value;
    return g;
}

template <class Scalar>
DynamicMatrix<Scalar> FrameJoint::jacobian(const DynamicVector<Scalar>& q,
                                           const Scalar& time) const {
    DynamicMatrix<Scalar> g = DynamicMatrix<Scalar>::Zero(equations(), q.size());
    if (pinned_) {
        for (int k = 0; k < 3; ++k) {
            g(k, k) = Scalar(1.0);
            if (b_.kind != SideKind::space) g(k, 3 + k) = Scalar(-1.0);
        }
    }
    const Frames<Scalar> f = frames(q);
    const int width = 3 * (a_.vectors() + b_.vectors());
    const Rows<Scalar> at = rows(f, time);
    const Vector<Scalar, 12> of_cosine = at.cosine.gradient(f.a, f.b);
    int row = positions();
    for (const FrameForm<Scalar>& sine : at.sines) {
        const Vector<Scalar, 12> of_sine = sine.gradient(f.a, f.b);
        for (int k = 0; k < width; ++k)
            g(row, first_slope() + k) =
                at.factor.value * of_sine[k] + sine.value * at.factor.first * of_cosine[k];
        ++row;
    }
    return g;
}

template <class Scalar>
DynamicVector<Scalar> FrameJoint::rate(const DynamicVector<Scalar>& q, const Scalar& time) const {
    DynamicVector<Scalar> g = DynamicVector<Scalar>::Zero(equations());
    if (!angle_) return g;
    const Frames<Scalar> f = frames(q);
    const Rows<Scalar> at = rows(f, time);
    const Forms<Scalar> rates = form_rates(time);
    const Scalar of_cosine = FrameForm<Scalar>(rates.cosine, f.a, f.b).value;
    for (std::size_t k = 0; k < at.sines.size(); ++k)
        g[positions() + static_cast<int>(k)] =
            at.factor.value * FrameForm<Scalar>(rates.sines[k], f.a, f.b).value +
            at.sines[k].value * at.factor.first * of_cosine;
    return g;
}

inline std::vector<FormCourse> FrameJoint::courses(const ConstraintState& at,
                                                   const Frames<double>& f, bool varies) const {
    Vector<double, 12> v = Vector<double, 12>::Zero();
    for (int k = 0; k < 3 * (a_.vectors() + b_.vectors()); ++k) v[k] = at.v[first_slope() + k];
    const Forms<double> now = forms(at.time);
    std::vector<FormCourse> out;
    for (const Matrix<double, 3>& form : now.sines) out.emplace_back(form, f.a, f.b, v);
    if (varies) out.emplace_back(now.cosine, f.a, f.b, v);
    if (!angle_) return out;
    const Forms<double> rates = form_rates(at.time), accelerations = form_accelerations(at.time);
    for (std::size_t k = 0; k < now.sines.size(); ++k)
        out[k].move(rates.sines[k], accelerations.sines[k], f.a, f.b, v);
    if (varies) out.back().move(rates.cosine, accelerations.cosine, f.a, f.b, v);
    return out;
}

inline void FrameJoint::evaluate(const ConstraintState& at, ConstraintResult& out) const {
    out.violation = violation(at.q, at.time);
    out.jacobian = jacobian(at.q, at.time);
    out.rate = rate(at.q, at.time);
    const Frames<double> f = frames(at.q);
    const Rows<double> here = rows(f, at.time);
    const TurnFactor<double>& factor = here.factor;
    const std::vector<FormCourse> forms = courses(at, f, factor.varies);
    const int first = first_slope();
    const int width = 3 * (a_.vectors() + b_.vectors());
    for (std::size_t k = 0; k < here.sines.size(); ++k) {
        const int row = positions() + static_cast<int>(k);
        out.convection[row] = factor.value * forms[k].bend;
        const double force = at.multipliers[row] * factor.value;
        for (int j = 0; j < width; ++j)
            for (int i = 0; i < width; ++i)
                out.stiffness(first + i, first + j) += force * forms[k].hessian(i, j);
    }
    if (!factor.varies) return;
    // (F s)_qq = F s_qq + F' (s_q c_q^T + c_q s_q^T + s c_qq) + F'' s c_q c_q^T
    const FormCourse& c = forms.back();
    for (std::size_t k = 0; k < here.sines.size(); ++k) {
        const int row = positions() + static_cast<int>(k);
        const double s = here.sines[k].value, force = at.multipliers[row];
        out.convection[row] += factor.first * (2.0 * c.speed * forms[k].speed + s * c.bend) +
                               factor.second * s * c.speed * c.speed;
        const Vector<double, 12>& by_q = forms[k].gradient;
        for (int j = 0; j < width; ++j)
            for (int i = 0; i < width; ++i)
                out.stiffness(first + i, first + j) +=
                    force * (factor.first * (by_q[i] * c.gradient[j] + c.gradient[i] * by_q[j] +
                                             s * c.hessian(i, j)) +
                             factor.second * s * c.gradient[i] * c.gradient[j]);
    }
}

}  // namespace detail
}  // namespace ancf
