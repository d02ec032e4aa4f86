// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Moments and forces on the frame of a node, with their exact stiffness; docs/theory-statics.md
/// derives each.
///
/// The frame (t, n, c) is t along r_x, n the part of r_y normal to t, c = t x n.

#pragma once

#include <ancf/error.hpp>
#include <ancf/model/load.hpp>
#include <ancf/model/node.hpp>
#include <ancf/types.hpp>

#include <cmath>

namespace ancf {

/// Whether a load keeps its direction in space or its components in the node's frame.
enum class Attachment { space, frame };

/// A moment vector on the frame (t, n, c) of a node, N m.
///
///     Q_rx = (m_c n - (m_n + alpha m_t) c)/|r_x|,   Q_ry = m_t c/|r_y normal to t|
///
/// with alpha the slope of r_y against the normal plane; r_x x Q_rx + r_y x Q_ry = m.
class Moment {
public:
    static constexpr int dimension = 3;  ///< of the model it belongs to

    /// @param moment  in global axes (space) or in (t, n, c) (frame), N m.
    /// @throws InvalidArgument unless the moment is finite.
    Moment(NodeId node, const Vector<double, 3>& moment, Attachment attachment = Attachment::space);

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, Field::r_x}, {node_, Field::r_y}}; }

    /// Returns the generalised force on (r_x, r_y), 6 x 1, N m.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, 6> force(const Vector<Scalar, 6>& slopes) const;

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    NodeId node_;
    Vector<double, 3> moment_;
    Attachment attachment_;
};

/// A force that keeps its components in the frame (t, n, c) of its node, N.
class FollowerForce {
public:
    static constexpr int dimension = 3;  ///< of the model it belongs to

    /// @throws InvalidArgument unless the force is finite.
    FollowerForce(NodeId node, const Vector<double, 3>& force);

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const {
        return {{node_, Field::r}, {node_, Field::r_x}, {node_, Field::r_y}};
    }

    /// Returns the force in global axes at slopes (r_x, r_y), 3 x 1, N.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, 3> force(const Vector<Scalar, 6>& slopes) const;

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    NodeId node_;
    Vector<double, 3> force_;
};

namespace detail {

/// The frame (t, n, c) of a node from its slopes (r_x, r_y).
template <class Scalar>
struct NodeFrame {
    explicit NodeFrame(const Vector<Scalar, 6>& slopes) {
        using std::sqrt;
        const Vector<Scalar, 3> p = slopes.template head<3>();
        const Vector<Scalar, 3> a = slopes.template tail<3>();
        lam = sqrt(Scalar(p.transpose() * p));
        t = p / lam;
        const Scalar along = a.transpose() * t;
        const Vector<Scalar, 3> normal = a - along * t;
        nu = sqrt(Scalar(normal.transpose() * normal));
        n = normal / nu;
        c = ancf::cross(t, n);
        al = along / nu;
    }

    Scalar lam;  ///< |r_x|
    Scalar nu;   ///< length of r_y normal to t
    Scalar al;   ///< r_y along t, relative to nu
    Vector<Scalar, 3> t, n, c;
};

/// The differential of a node's frame; each row stands against (dr_x, dr_y).
///
/// With u = R^T dr_x/lam and A = R^T dr_y/nu the frame turns by (th, -u_c, u_n) in (t, n, c),
/// where th = A_c - al u_c.
struct NodeFrameDifferential {
    using Row = Matrix<double, 1, 6>;

    explicit NodeFrameDifferential(const NodeFrame<double>& frame) {
        const Row u_t = row(frame.t, 0) / frame.lam;
        const Row a_n = row(frame.n, 3) / frame.nu;
        u_n = row(frame.n, 0) / frame.lam;
        u_c = row(frame.c, 0) / frame.lam;
        th = row(frame.c, 3) / frame.nu - frame.al * u_c;
        lam = frame.lam * u_t;
        nu = frame.nu * (a_n - frame.al * u_n);
        al = row(frame.t, 3) / frame.nu + u_n - frame.al * (a_n - frame.al * u_n);
        t = frame.n * u_n + frame.c * u_c;
        n = frame.c * th - frame.t * u_n;
        c = -frame.n * th - frame.t * u_c;
    }

    Row u_n, u_c, th, lam, nu, al;
    Matrix<double, 3, 6> t, n, c;

private:
    static Row row(const Vector<double, 3>& direction, int first) {
        Row result = Row::Zero();
        result.segment<3>(first) = direction.transpose();
        return result;
    }
};

}  // namespace detail

inline Moment::Moment(NodeId node, const Vector<double, 3>& moment, Attachment attachment)
    : node_(node), moment_(moment), attachment_(attachment) {
    detail::require(moment.allFinite(), "Moment: components must be finite, got ",
                    moment.transpose());
}

template <class Scalar>
Vector<Scalar, 6> Moment::force(const Vector<Scalar, 6>& slopes) const {
    const detail::NodeFrame<Scalar> frame(slopes);
    Vector<Scalar, 3> m = moment_.cast<Scalar>();
    if (attachment_ == Attachment::space)
        m = Vector<Scalar, 3>(Scalar(frame.t.transpose() * m), Scalar(frame.n.transpose() * m),
                              Scalar(frame.c.transpose() * m));
    Vector<Scalar, 6> result;
    result << (m[2] * frame.n - (m[1] + frame.al * m[0]) * frame.c) / frame.lam,
        m[0] / frame.nu * frame.c;
    return result;
}

inline void Moment::evaluate(const LoadState& state, LoadResult& out) const {
    using Row = detail::NodeFrameDifferential::Row;
    const detail::NodeFrame<double> frame(state.q);
    const detail::NodeFrameDifferential d(frame);

    Vector<double, 3> m = moment_;
    Row d_mt = Row::Zero();
    Row d_mn = Row::Zero();
    Row d_mc = Row::Zero();
    if (attachment_ == Attachment::space) {
        m << moment_.dot(frame.t), moment_.dot(frame.n), moment_.dot(frame.c);
        d_mt = m[1] * d.u_n + m[2] * d.u_c;
        d_mn = m[2] * d.th - m[0] * d.u_n;
        d_mc = -m[1] * d.th - m[0] * d.u_c;
    }
    const double along_n = m[2] / frame.lam;
    const double along_c = -(m[1] + frame.al * m[0]) / frame.lam;
    const double twisting = m[0] / frame.nu;
    const Row d_along_n = (d_mc - along_n * d.lam) / frame.lam;
    const Row d_along_c = -(d_mn + frame.al * d_mt + m[0] * d.al + along_c * d.lam) / frame.lam;
    const Row d_twisting = (d_mt - twisting * d.nu) / frame.nu;

    out.force << along_n * frame.n + along_c * frame.c, twisting * frame.c;
    out.stiffness << frame.n * d_along_n + along_n * d.n + frame.c * d_along_c + along_c * d.c,
        frame.c * d_twisting + twisting * d.c;
}

inline FollowerForce::FollowerForce(NodeId node, const Vector<double, 3>& force)
    : node_(node), force_(force) {
    detail::require(force.allFinite(), "FollowerForce: components must be finite, got ",
                    force.transpose());
}

template <class Scalar>
Vector<Scalar, 3> FollowerForce::force(const Vector<Scalar, 6>& slopes) const {
    const detail::NodeFrame<Scalar> frame(slopes);
    return force_[0] * frame.t + force_[1] * frame.n + force_[2] * frame.c;
}

inline void FollowerForce::evaluate(const LoadState& state, LoadResult& out) const {
    const Vector<double, 6> slopes = state.q.tail<6>();
    const detail::NodeFrameDifferential d{detail::NodeFrame<double>(slopes)};
    out.force.head<3>() = force(slopes);
    out.stiffness.topRightCorner<3, 6>() = force_[0] * d.t + force_[1] * d.n + force_[2] * d.c;
}

}  // namespace ancf
