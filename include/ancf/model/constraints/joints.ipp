// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/constraints/frames.hpp>
#include <ancf/model/constraints/joints.hpp>
#include <ancf/model/triad.hpp>

#include <cmath>
#include <complex>
#include <cstddef>

namespace ancf {

ANCF_INLINE FrameAt::FrameAt(NodeId at, Field along, Field across)
    : node(at), of_section(false), first(along), second(across) {
    detail::require_slope("FrameAt", along, 3);
    detail::require_slope("FrameAt", across, 3);
    detail::require(along != across, "FrameAt: a frame needs two different slopes, got ",
                    to_string(along), " twice");
}

namespace detail {

/// Returns the frame of two slopes of a side.
template <class Scalar>
[[nodiscard]] Triad<Scalar> triad_of(const JointSide& side, const Vec3<Scalar>& p,
                                     const Vec3<Scalar>& a) {
    return side.kind == SideKind::section ? Triad<Scalar>::of_section(p, a, side.share)
                                          : Triad<Scalar>::of_slopes(p, a);
}

/// Returns the frame of a side at its slopes, which start at q[first].
template <class Scalar>
[[nodiscard]] Triad<Scalar> triad_of(const JointSide& side, const DynamicVector<Scalar>& q,
                                     int first) {
    if (side.kind == SideKind::space) return Triad<Scalar>::at_rest(side.axes);
    const auto p = vec3<Scalar>(q, first);
    if (side.kind == SideKind::tangent) return Triad<Scalar>::of_tangent(p);
    return triad_of(side, p, vec3<Scalar>(q, first + 3));
}

/// Whether every component of a frame is a number.
ANCF_INLINE bool all_finite(const std::array<Vec3<double>, 3>& axes) {
    return std::isfinite(dot(axes[0], axes[0]) + dot(axes[1], axes[1]) + dot(axes[2], axes[2]));
}

ANCF_INLINE JointSide JointSide::frame(const BasicModel<3>& model, const FrameAt& at) {
    JointSide side{SideKind::frame, at};
    if (at.of_section && model.layout().index({at.node, Field::r_z}) >= 0) {
        side.kind = SideKind::section;
        side.at.first = Field::r_y;
        side.at.second = Field::r_z;
        side.share = model.layout().torsion_share(at.node);
    }
    side.axes = triad_of(side, vec3<double>(model.value(at.node, side.at.first)),
                         vec3<double>(model.value(at.node, side.at.second)))
                    .axes;
    require(all_finite(side.axes), "a joint needs a frame: the slopes of node ", at.node.index,
            " are parallel or of no length");
    return side;
}

ANCF_INLINE JointSide JointSide::tangent(const BasicModel<3>& model, NodeId node) {
    JointSide side{SideKind::tangent, node};
    side.axes = Triad<double>::of_tangent(vec3<double>(model.value(node, Field::r_x))).axes;
    require(all_finite(side.axes), "a joint needs a tangent: r_x of node ", node.index,
            " has no length");
    return side;
}

ANCF_INLINE Vec3<double> unit_axis(const char* joint, const Vector<double, 3>& axis) {
    const auto v = vec3<double>(axis);
    const double size = length(v);
    require(std::isfinite(size) && size > 0.0, joint, ": the axis must have a length, got ",
            detail::components(axis));
    return v / size;
}

/// Returns R^T v: the components of v in a frame.
ANCF_INLINE Vec3<double> turned_back(const std::array<Vec3<double>, 3>& axes,
                                     const Vec3<double>& v) {
    return {{dot(axes[0], v), dot(axes[1], v), dot(axes[2], v)}};
}

/// Returns u v^T.
ANCF_INLINE Block<double> outer(const Vec3<double>& u, const Vec3<double>& v) {
    Block<double> out;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) out(i, j) = u[i] * v[j];
    return out;
}

/// The sines and the cosine stand here less their constants.
template <class Scalar>
struct FrameJoint::At {
    Forms<Scalar> forms;
    Triad<Scalar> a, b;
    List<FrameForm<Scalar>> sines;
    FrameForm<Scalar> cosine;
    TurnFactor<Scalar> factor = {};

    At(const FrameJoint& joint, const DynamicVector<Scalar>& q, const Scalar& time)
        : forms(joint.forms(time)),
          a(triad_of(joint.a_, q, joint.first_slope())),
          b(triad_of(joint.b_, q, joint.first_slope() + 3 * joint.a_.vectors())),
          cosine(forms.cosine, a, b) {
        cosine.value -= Scalar(joint.cosine_constant_);
        double square = 0.0;
        for (std::size_t k = 0; k < forms.sines.size(); ++k) {
            sines.emplace_back(forms.sines[k], a, b);
            sines[k].value -= Scalar(joint.constants_[k]);
            square += std::real(sines[k].value) * std::real(sines[k].value);
        }
        if (joint.angular_) factor = turn_factor(std::sqrt(square), cosine.value);
    }

    /// Returns the derivatives of the sines and, where the factor varies, of the cosine after them.
    [[nodiscard]] List<FormCourse> courses(const FrameJoint& joint,
                                           const ConstraintState& at) const {
        std::array<double, 12> v = {};
        for (int k = 0; k < a.width + b.width; ++k) v[k] = at.v[joint.first_slope() + k];
        List<FormCourse> out;
        for (const Block<double>& form : forms.sines) out.emplace_back(form, a, b, v);
        if (factor.varies) out.emplace_back(forms.cosine, a, b, v);
        if (!joint.angle_) return out;
        const Forms<double> rates = joint.form_rates(at.time),
                            accelerations = joint.form_accelerations(at.time);
        for (std::size_t k = 0; k < forms.sines.size(); ++k)
            out[k].move(rates.sines[k], accelerations.sines[k], a, b, v);
        if (factor.varies) out.back().move(rates.cosine, accelerations.cosine, a, b, v);
        return out;
    }
};

ANCF_INLINE FrameJoint::FrameJoint(std::string what, JointSide a, JointSide b, bool positions)
    : what_(std::move(what)), a_(std::move(a)), b_(std::move(b)), pinned_(positions) {
    require(a_.kind == SideKind::space || b_.kind == SideKind::space || a_.at.node != b_.at.node,
            "a ", what_, " joins two nodes, got node ", a_.at.node.index, " twice");
}

ANCF_INLINE void FrameJoint::hold_turn(const Vec3<double>& axis_in_a, std::optional<Motion> angle) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) relative_(i, j) = dot(a_.axes[i], b_.axes[j]);
    turn_ = cross_block(axis_in_a);
    angle_ = std::move(angle);
    const Forms<double> held = turn_forms<double>(relative_);
    for (const Block<double>& form : held.sines) add_form(form);
    hold_angle(held.cosine);
    cosine_constant_ = 0.5;
}

ANCF_INLINE Coupling FrameJoint::coupling() const {
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
Forms<Scalar> FrameJoint::forms(const Scalar& time) const {
    if (angle_) {
        const Scalar angle = continued(angle_->value, angle_->rate, time);
        return turn_forms<Scalar>(rotation_about(turn_, angle) * relative_);
    }
    Forms<Scalar> out;
    for (const Block<double>& form : sines_) out.sines.push_back(scaled(Scalar(1.0), form));
    out.cosine = scaled(Scalar(1.0), cosine_);
    return out;
}

template <class Scalar>
Forms<Scalar> FrameJoint::form_rates(const Scalar& time) const {
    const Scalar angle = continued(angle_->value, angle_->rate, time);
    const Scalar speed = continued(angle_->rate, angle_->acceleration, time);
    return turn_forms<Scalar>(scaled(speed, turn_) * rotation_about(turn_, angle) * relative_);
}

ANCF_INLINE Forms<double> FrameJoint::form_accelerations(double time) const {
    const double speed = angle_->rate(time);
    Block<double> bend = scaled(speed * speed, turn_ * turn_);
    for (int k = 0; k < 9; ++k) bend.v[k] += angle_->acceleration(time) * turn_.v[k];
    return turn_forms<double>(bend * rotation_about(turn_, angle_->value(time)) * relative_);
}

template <class Scalar>
void FrameJoint::terms(const DynamicVector<Scalar>& q, const Scalar& time,
                       ConstraintTerms<Scalar>& out) const {
    const bool to_space = b_.kind == SideKind::space;
    for (int k = 0; k < positions(); ++k) {
        out.violation[k] = q[k] - (to_space ? Scalar(b_.place[k]) : q[3 + k]);
        out.jacobian(k, k) = Scalar(1.0);
        if (!to_space) out.jacobian(k, 3 + k) = Scalar(-1.0);
    }
    const int width = 3 * (a_.vectors() + b_.vectors());
    const At<Scalar> at(*this, q, time);
    const std::array<Scalar, 12> of_cosine = at.cosine.gradient(at.a, at.b);
    int row = positions();
    for (const FrameForm<Scalar>& sine : at.sines) {
        const std::array<Scalar, 12> of_sine = sine.gradient(at.a, at.b);
        out.violation[row] = at.factor.value * sine.value;
        for (int k = 0; k < width; ++k)
            out.jacobian(row, first_slope() + k) =
                at.factor.value * of_sine[k] + sine.value * at.factor.first * of_cosine[k];
        ++row;
    }
    if (!angle_) return;
    const Forms<Scalar> rates = form_rates(time);
    const Scalar cosine_rate = FrameForm<Scalar>(rates.cosine, at.a, at.b).value;
    for (std::size_t k = 0; k < at.sines.size(); ++k)
        out.rate[positions() + static_cast<int>(k)] =
            at.factor.value * FrameForm<Scalar>(rates.sines[k], at.a, at.b).value +
            at.sines[k].value * at.factor.first * cosine_rate;
}

ANCF_INLINE void FrameJoint::evaluate(const ConstraintState& at, ConstraintResult& out) const {
    terms(at.q, at.time, out);
    const At<double> here(*this, at.q, at.time);
    const TurnFactor<double>& factor = here.factor;
    const List<FormCourse> forms = here.courses(*this, at);
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
        const std::array<double, 12>& by_q = forms[k].gradient;
        for (int j = 0; j < width; ++j)
            for (int i = 0; i < width; ++i)
                out.stiffness(first + i, first + j) +=
                    force * (factor.first * (by_q[i] * c.gradient[j] + c.gradient[i] * by_q[j] +
                                             s * c.hessian(i, j)) +
                             factor.second * s * c.gradient[i] * c.gradient[j]);
    }
}

#if defined(ANCF_SOURCE)
ANCF_CONSTRAINT_INSTANCES(FrameJoint)
#endif

}  // namespace detail

ANCF_INLINE Revolute::Revolute(const BasicModel<3>& model, const FrameAt& a, const FrameAt* b,
                               const Vector<double, 3>& axis)
    : FrameJoint("revolute joint", model, a, b) {
    const detail::Vec3<double> unit = detail::unit_axis("Revolute", axis);
    const detail::Vec3<double> w = detail::turned_back(this->a().axes, unit);
    for (const detail::Vec3<double>& normal : detail::normals_of(unit))
        add_form(detail::outer(w, detail::turned_back(this->b().axes, normal)));
    hold_angle(detail::outer(w, detail::turned_back(this->b().axes, unit)));
}

ANCF_INLINE DrivenRevolute::DrivenRevolute(const BasicModel<3>& model, const FrameAt& a,
                                           const FrameAt* b, const Vector<double, 3>& axis,
                                           Motion angle)
    : FrameJoint("driven revolute joint", model, a, b) {
    angle.check("DrivenRevolute");
    hold_turn(detail::turned_back(this->a().axes, detail::unit_axis("DrivenRevolute", axis)),
              std::move(angle));
}

ANCF_INLINE Universal::Universal(const BasicModel<3>& model, const FrameAt& a, const FrameAt* b,
                                 const Vector<double, 3>& axis_of_a,
                                 const Vector<double, 3>& axis_of_b)
    : FrameJoint("universal joint", model, a, b) {
    const detail::Vec3<double> u = detail::unit_axis("Universal", axis_of_a);
    const detail::Vec3<double> w = detail::unit_axis("Universal", axis_of_b);
    detail::require(length(cross(u, w)) > 1e-3, "Universal: the axes must not be parallel, got ",
                    detail::components(axis_of_a), " and ", detail::components(axis_of_b));
    add_form(detail::outer(detail::turned_back(this->a().axes, u),
                           detail::turned_back(this->b().axes, w)),
             dot(u, w));
}

ANCF_INLINE AlignedTangent::AlignedTangent(const BasicModel<3>& model, detail::JointSide frame,
                                           NodeId tangent)
    : FrameJoint("aligned tangent", std::move(frame), detail::JointSide::tangent(model, tangent),
                 false) {
    const detail::Vec3<double> t = b().axes[0];
    for (const detail::Vec3<double>& normal : detail::normals_of(t))
        add_form(detail::outer(detail::turned_back(a().axes, normal), {{1.0, 0.0, 0.0}}));
    hold_angle(detail::outer(detail::turned_back(a().axes, t), {{1.0, 0.0, 0.0}}));
}

ANCF_INLINE Matrix<double, 3> frame_axes(const BasicModel<3>& model, const FrameAt& at,
                                         const VectorX& q) {
    const auto side = detail::JointSide::frame(model, at);
    const auto axes =
        detail::triad_of(side, detail::vec3<double>(model.value(at.node, side.at.first, q)),
                         detail::vec3<double>(model.value(at.node, side.at.second, q)))
            .axes;
    Matrix<double, 3> columns;
    for (int k = 0; k < 3; ++k) columns.col(k) = detail::to_vector(axes[k]);
    return columns;
}

namespace detail {

template <int Dimension>
template <class Visit>
void HeldSlopes<Dimension>::for_each_product(const Visit& visit) const {
    int row = 0;
    for (int a = 0; a < count(); ++a) visit(row++, a, a);
    for (int a = 0; a < count(); ++a)
        for (int b = a + 1; b < count(); ++b) visit(row++, a, b);
}

template <int Dimension>
template <class Scalar>
void HeldSlopes<Dimension>::terms(const DynamicVector<Scalar>& q, const Scalar& /*time*/,
                                  ConstraintTerms<Scalar>& out) const {
    for_each_product([&](int row, int a, int b) {
        Scalar product(a == b ? -1.0 : 0.0);
        for (int i = Dimension * a, j = Dimension * b; i < Dimension * (a + 1); ++i, ++j) {
            product += q[i] * q[j];
            out.jacobian(row, i) = q[j];
            out.jacobian(row, j) = q[i];
        }
        out.violation[row] = (a == b ? 0.5 : 1.0) * product;
    });
}

template <int Dimension>
void HeldSlopes<Dimension>::evaluate(const ConstraintState& at, ConstraintResult& out) const {
    terms(at.q, at.time, out);
    for_each_product([&](int row, int a, int b) {
        for (int i = Dimension * a, j = Dimension * b; i < Dimension * (a + 1); ++i, ++j) {
            out.convection[row] += (a == b ? 1.0 : 2.0) * at.v[i] * at.v[j];
            out.stiffness(i, j) = out.stiffness(j, i) = at.multipliers[row];
        }
    });
}

#if defined(ANCF_SOURCE)
template class HeldSlopes<2>;
template class HeldSlopes<3>;
ANCF_CONSTRAINT_INSTANCES(HeldSlopes<2>)
ANCF_CONSTRAINT_INSTANCES(HeldSlopes<3>)
#endif

}  // namespace detail

}  // namespace ancf
