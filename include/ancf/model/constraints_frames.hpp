// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Frames of nodes and bilinear forms of two frames: what joints are made of.
///
/// A frame R = [t n c] of two slopes p, a turns by the spin w = O (dp, da):
///
///     t = p/|p|,  n = unit(a - (a.t) t),  c = t x n,
///     O = [ [t]x/lam - (al/lam) t c^T,  t c^T/nu ],
///
/// lam = |p|, nu = |a - (a.t) t|, al = a.t/nu. Only directions count, never the slopes' lengths.
/// A cable's node has p alone: R = [t 0 0], O = [t]x/lam. docs/theory-dynamics.md derives the rest.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/error.hpp>
#include <ancf/model/node.hpp>
#include <ancf/model/support.hpp>
#include <ancf/types.hpp>

#include <cmath>
#include <string>

namespace ancf {

/// A frame at a node: t along the first slope, n the part of the second normal to it, c = t x n.
///
/// The default is the frame of the tangent. {node, Field::r_y, Field::r_z} is that of the section,
/// which a shear deformation at the joint leaves free to turn against the tangent.
struct FrameAt {
    NodeId node;                ///< where
    Field first = Field::r_x;   ///< along the axis t
    Field second = Field::r_y;  ///< in the plane of t and n

    /// The frame of the given slopes of a node.
    FrameAt(NodeId at) : node(at) {}  // NOLINT: a node has a frame

    /// @throws InvalidArgument unless both are slopes and differ.
    FrameAt(NodeId at, Field along, Field across) : node(at), first(along), second(across) {
        detail::require(along != Field::r && across != Field::r && along != across,
                        "FrameAt: a frame needs two different slopes, got ", to_string(along),
                        " and ", to_string(across));
    }
};

namespace detail {

/// What a joint holds on one side.
enum class SideKind {
    space,   ///< a frame that rests
    frame,   ///< two slopes of a node
    tangent  ///< one slope of a node
};

/// The spin map of a side: 3 x (0, 6 or 3).
template <class Scalar>
using SpinMap = Eigen::Matrix<Scalar, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 6>;

/// A frame with its spin map at given slopes.
template <class Scalar>
struct Triad {
    Matrix<Scalar, 3> axes;  ///< columns t, n, c; n and c zero for a tangent
    SpinMap<Scalar> spin;    ///< w = spin (dp, da)
    Scalar lam{}, nu{}, al{};

    /// The frame of two slopes.
    static Triad of_slopes(const Vector<Scalar, 3>& p, const Vector<Scalar, 3>& a) {
        using std::sqrt;
        Triad f;
        f.lam = sqrt(Scalar(p.transpose() * p));
        const Vector<Scalar, 3> t = p / f.lam;
        const Scalar along = a.transpose() * t;
        const Vector<Scalar, 3> normal = a - along * t;
        f.nu = sqrt(Scalar(normal.transpose() * normal));
        const Vector<Scalar, 3> n = normal / f.nu;
        const Vector<Scalar, 3> c = cross(t, n);
        f.al = along / f.nu;
        f.axes << t, n, c;
        f.spin.resize(3, 6);
        f.spin.template leftCols<3>() = (cross_matrix(t) - f.al * t * c.transpose()) / f.lam;
        f.spin.template rightCols<3>() = t * c.transpose() / f.nu;
        return f;
    }

    /// The direction of one slope.
    static Triad of_tangent(const Vector<Scalar, 3>& p) {
        using std::sqrt;
        Triad f;
        f.lam = sqrt(Scalar(p.transpose() * p));
        f.axes.setZero();
        f.axes.col(0) = p / f.lam;
        f.spin = cross_matrix(Vector<Scalar, 3>(f.axes.col(0))) / f.lam;
        return f;
    }

    /// A frame that rests.
    static Triad at_rest(const Matrix<double, 3>& axes) {
        Triad f;
        f.axes = axes.template cast<Scalar>();
        f.spin.resize(3, 0);
        return f;
    }
};

/// Returns d(spin^T m)/d(p, a) at fixed m: what the load stiffness of a moment is.
///
///     spin^T m = ((m x t)/lam - (al m_t/lam) c,  (m_t/nu) c),    m_t = m.t
[[nodiscard]] inline MatrixX spin_derivative(const Triad<double>& f, const Vector<double, 3>& m) {
    const Eigen::Index width = f.spin.cols();
    MatrixX out = MatrixX::Zero(width, width);
    if (width == 0) return out;
    const Vector<double, 3> t = f.axes.col(0);
    const Vector<double, 3> mt = cross(m, t);
    // dt = spin x t and d lam = t.dp
    const MatrixX dt = -cross_matrix(t) * f.spin;
    Eigen::RowVectorXd d_lam = Eigen::RowVectorXd::Zero(width);
    d_lam.head<3>() = t.transpose();
    out.topRows<3>() = (cross_matrix(m) * dt - mt * d_lam / f.lam) / f.lam;
    if (width == 3) return out;

    const Vector<double, 3> n = f.axes.col(1);
    const Vector<double, 3> c = f.axes.col(2);
    const double twist = m.dot(t);
    const Eigen::RowVectorXd d_twist = m.transpose() * dt;
    const MatrixX dc = -cross_matrix(c) * f.spin;
    const Eigen::RowVectorXd u_n = n.transpose() * dt;
    Eigen::RowVectorXd d_nu = Eigen::RowVectorXd::Zero(width);  // A_n nu - al nu u_n
    d_nu.tail<3>() = n.transpose();
    d_nu -= f.al * f.nu * u_n;
    Eigen::RowVectorXd d_along = Eigen::RowVectorXd::Zero(width);  // d(a.t), a = al nu t + nu n
    d_along.tail<3>() = t.transpose();
    d_along += f.nu * u_n;
    const Eigen::RowVectorXd d_al = (d_along - f.al * d_nu) / f.nu;
    const double bent = f.al * twist / f.lam;
    const Eigen::RowVectorXd d_bent = (f.al * d_twist + twist * d_al - bent * d_lam) / f.lam;
    out.topRows<3>() -= c * d_bent + bent * dc;
    out.bottomRows<3>() = (c * (d_twist - twist / f.nu * d_nu) + twist * dc) / f.nu;
    return out;
}

/// The bilinear form g = sum_ij C_ij A_i.B_j of the axes of two frames.
///
/// With X = B C^T (columns x_i = sum_j C_ij B_j) and the moment m = sum_i A_i x x_i, dg = m.(w_A -
/// w_B).
template <class Scalar>
struct FrameForm {
    Scalar value;
    Vector<Scalar, 3> moment;

    FrameForm(const Matrix<Scalar, 3>& coefficients, const Triad<Scalar>& a,
              const Triad<Scalar>& b) {
        const Matrix<Scalar, 3> x = b.axes * coefficients.transpose();
        value = Scalar(0.0);
        moment.setZero();
        for (int i = 0; i < 3; ++i) {
            value += Scalar(a.axes.col(i).transpose() * x.col(i));
            moment += cross<Scalar>(a.axes.col(i), x.col(i));
        }
    }

    /// Returns dg/d(slopes of A, slopes of B).
    [[nodiscard]] Eigen::Matrix<Scalar, 1, Eigen::Dynamic> gradient(const Triad<Scalar>& a,
                                                                    const Triad<Scalar>& b) const {
        Eigen::Matrix<Scalar, 1, Eigen::Dynamic> row(a.spin.cols() + b.spin.cols());
        row << moment.transpose() * a.spin, -moment.transpose() * b.spin;
        return row;
    }
};

/// Returns the Hessian of a bilinear form.
///
///     H_AA = O_A^T S O_A + d(O_A^T m),  H_BB = O_B^T S^T O_B - d(O_B^T m),  H_AB = -O_A^T S^T O_B,
///     S = sum_i A_i x_i^T - (sum_i A_i.x_i) I
[[nodiscard]] inline MatrixX frame_form_hessian(const Matrix<double, 3>& coefficients,
                                                const Triad<double>& a, const Triad<double>& b) {
    const Matrix<double, 3> x = b.axes * coefficients.transpose();
    const FrameForm<double> form(coefficients, a, b);
    const Matrix<double, 3> s = a.axes * x.transpose() - form.value * Matrix<double, 3>::Identity();
    const Eigen::Index na = a.spin.cols();
    const Eigen::Index nb = b.spin.cols();
    MatrixX h(na + nb, na + nb);
    h.topLeftCorner(na, na) = a.spin.transpose() * s * a.spin + spin_derivative(a, form.moment);
    h.bottomRightCorner(nb, nb) =
        b.spin.transpose() * s.transpose() * b.spin + spin_derivative(b, -form.moment);
    h.topRightCorner(na, nb) = -a.spin.transpose() * s.transpose() * b.spin;
    h.bottomLeftCorner(nb, na) = h.topRightCorner(na, nb).transpose();
    return h;
}

/// Returns the rotation by an angle about the unit axis of k = [axis]x.
template <class Scalar>
[[nodiscard]] Matrix<Scalar, 3> rotation_about(const Matrix<double, 3>& k, const Scalar& angle) {
    using std::cos;
    using std::sin;
    return Matrix<Scalar, 3>::Identity() + sin(angle) * k.template cast<Scalar>() +
           (Scalar(1.0) - cos(angle)) * (k * k).template cast<Scalar>();
}

}  // namespace detail
}  // namespace ancf
