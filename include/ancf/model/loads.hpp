// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Nodal loads with their exact stiffness: dead and following forces and moments.
///
/// A moment acts on slopes, so its generalised force depends on them. docs/theory-statics.md
/// derives each; the frame (t, n, c) of a node is t along r_x, n the part of r_y normal to t, c = t
/// x n.

#pragma once

#include <ancf/error.hpp>
#include <ancf/model/load.hpp>
#include <ancf/model/node.hpp>
#include <ancf/types.hpp>

#include <cmath>
#include <utility>

namespace ancf {

/// A dead force at a node, N.
template <int Dimension = 3>
class Force {
public:
    static constexpr int dimension = Dimension;   ///< of the model it belongs to
    static constexpr bool constant_force = true;  ///< it has no derivatives

    /// @throws InvalidArgument unless the force is finite.
    Force(NodeId node, const Vector<double, Dimension>& force);

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, Field::r}}; }
    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    NodeId node_;
    Vector<double, Dimension> force_;
};

/// A constant generalised force on the coordinates of a coupling, such as a dead force per length.
///
/// `add_line_load` makes one per element.
class GeneralisedForce {
public:
    static constexpr bool constant_force = true;  ///< it has no derivatives

    /// @param force  in the order of the coupling; N and N m. A model refuses one of another size.
    /// @throws InvalidArgument unless the force is finite.
    GeneralisedForce(Coupling coupling, VectorX force)
        : coupling_(std::move(coupling)), force_(std::move(force)) {
        detail::require(force_.allFinite(), "GeneralisedForce: components must be finite, got ",
                        force_.transpose());
    }

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return coupling_; }
    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const {
        detail::require(force_.size() == state.q.size(), "GeneralisedForce: ", state.q.size(),
                        " coordinates are coupled, got ", force_.size(), " force components");
        out.force = force_;
        out.potential = -force_.dot(state.q);
    }

private:
    Coupling coupling_;
    VectorX force_;
};

/// A moment m about a fixed unit axis n that works through the angle of one slope a, N m.
///
///     Q_a = m (n x a_p)/|a_p|^2,    a_p = a - (a.n) n
///
/// It is a moment about n while the slope stays normal to n: in planar bending and in pure twist.
class SlopeMoment {
public:
    static constexpr int dimension = 3;                ///< of the model it belongs to
    static constexpr bool symmetric_stiffness = true;  ///< its stiffness is symmetric

    /// @throws InvalidArgument for the field r, an axis of no length, or a value that is not
    ///         finite.
    SlopeMoment(NodeId node, Field slope, const Vector<double, 3>& axis, double moment);

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, slope_}}; }

    /// Returns the generalised force on the slope, 3 x 1, N m.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, 3> force(const Vector<Scalar, 3>& slope) const;

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    NodeId node_;
    Field slope_;
    Vector<double, 3> axis_;
    double moment_;
};

/// The moment of SlopeMoment in the plane: counterclockwise positive, N m.
class PlanarSlopeMoment {
public:
    static constexpr int dimension = 2;                ///< of the model it belongs to
    static constexpr bool symmetric_stiffness = true;  ///< its stiffness is symmetric

    /// @throws InvalidArgument for the field r or a moment that is not finite.
    PlanarSlopeMoment(NodeId node, Field slope, double moment);

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, slope_}}; }

    /// Returns the generalised force on the slope, 2 x 1, N m.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, 2> force(const Vector<Scalar, 2>& slope) const;

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    NodeId node_;
    Field slope_;
    double moment_;
};

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

/// A moment vector fixed in space on a node that has no slope but r_x, N m.
///
/// Only the part of m normal to the tangent does work: Q_rx = (m x t)/|r_x|.
class TangentMoment {
public:
    static constexpr int dimension = 3;  ///< of the model it belongs to

    /// @throws InvalidArgument unless the moment is finite.
    TangentMoment(NodeId node, const Vector<double, 3>& moment);

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, Field::r_x}}; }

    /// Returns the generalised force on r_x, 3 x 1, N m.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, 3> force(const Vector<Scalar, 3>& slope) const;

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    NodeId node_;
    Vector<double, 3> moment_;
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

inline void require_slope(const char* load, Field slope) {
    require(slope != Field::r, load, " acts on a slope r_x, r_y or r_z, got the position r");
}

}  // namespace detail

template <int Dimension>
Force<Dimension>::Force(NodeId node, const Vector<double, Dimension>& force)
    : node_(node), force_(force) {
    detail::require(force.allFinite(), "Force: components must be finite, got ", force.transpose());
}

template <int Dimension>
void Force<Dimension>::evaluate(const LoadState& state, LoadResult& out) const {
    out.force = force_;
    out.potential = -force_.dot(state.q);
}

inline SlopeMoment::SlopeMoment(NodeId node, Field slope, const Vector<double, 3>& axis,
                                double moment)
    : node_(node), slope_(slope), axis_(axis.normalized()), moment_(moment) {
    detail::require_slope("SlopeMoment", slope);
    detail::require(axis.allFinite() && axis.norm() > 0.0,
                    "SlopeMoment: the axis must have a length, got ", axis.transpose());
    detail::require_finite("SlopeMoment: moment", moment);
}

template <class Scalar>
Vector<Scalar, 3> SlopeMoment::force(const Vector<Scalar, 3>& slope) const {
    const Vector<Scalar, 3> n = axis_.cast<Scalar>();
    const Vector<Scalar, 3> ap = slope - Scalar(n.transpose() * slope) * n;
    return moment_ / Scalar(ap.transpose() * ap) * cross(n, ap);
}

inline void SlopeMoment::evaluate(const LoadState& state, LoadResult& out) const {
    const Matrix<double, 3> projector = Matrix<double, 3>::Identity() - axis_ * axis_.transpose();
    const Vector<double, 3> ap = projector * state.q;
    const double square = ap.squaredNorm();
    const Vector<double, 3> turned = cross(axis_, ap);
    out.force = moment_ / square * turned;
    out.stiffness = moment_ / square *
                    (cross_matrix(axis_) - 2.0 / square * turned * ap.transpose()) * projector;
}

inline PlanarSlopeMoment::PlanarSlopeMoment(NodeId node, Field slope, double moment)
    : node_(node), slope_(slope), moment_(moment) {
    detail::require_slope("PlanarSlopeMoment", slope);
    detail::require_finite("PlanarSlopeMoment: moment", moment);
}

template <class Scalar>
Vector<Scalar, 2> PlanarSlopeMoment::force(const Vector<Scalar, 2>& slope) const {
    return moment_ / Scalar(slope.transpose() * slope) * Vector<Scalar, 2>(-slope[1], slope[0]);
}

inline void PlanarSlopeMoment::evaluate(const LoadState& state, LoadResult& out) const {
    const Vector<double, 2> slope = state.q;
    const double x = slope[0];
    const double y = slope[1];
    const double scale = moment_ / (slope.squaredNorm() * slope.squaredNorm());
    out.force = force(slope);
    out.stiffness << 2.0 * scale * x * y, scale * (y * y - x * x), scale * (y * y - x * x),
        -2.0 * scale * x * y;
}

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

inline TangentMoment::TangentMoment(NodeId node, const Vector<double, 3>& moment)
    : node_(node), moment_(moment) {
    detail::require(moment.allFinite(), "TangentMoment: components must be finite, got ",
                    moment.transpose());
}

template <class Scalar>
Vector<Scalar, 3> TangentMoment::force(const Vector<Scalar, 3>& slope) const {
    return cross(Vector<Scalar, 3>(moment_.cast<Scalar>()), slope) /
           Scalar(slope.transpose() * slope);
}

inline void TangentMoment::evaluate(const LoadState& state, LoadResult& out) const {
    const Vector<double, 3> slope = state.q;
    const double square = slope.squaredNorm();
    const Vector<double, 3> turned = cross(moment_, slope);
    out.force = turned / square;
    out.stiffness = (cross_matrix(moment_) - 2.0 / square * turned * slope.transpose()) / square;
}

}  // namespace ancf
