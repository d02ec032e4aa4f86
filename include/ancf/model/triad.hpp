// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The frame of a node and how it turns with the slopes.
///
/// A frame R = [t n c] of two slopes p, a turns by the spin w = O (dp, da):
///
///     t = p/|p|,  n = unit(a - (a.t) t),  c = t x n,
///     O = [ [t]x/lam - (al/lam) t c^T,  t c^T/nu ],
///
/// lam = |p|, nu = |a - (a.t) t|, al = a.t/nu. Only directions count, never the slopes' lengths.
/// A section's frame stands between its two slopes p, a across: with their unit vectors u, w, the
/// lack g = asin(u.w) of the right angle between them, and the share f of p,
///
///     t = unit(u x w),  n = u cos((1 - f) g) - t x u sin((1 - f) g),  c = t x n,
///     O = [ (f t (t x u)^T - w t^T/s)/|p|,  ((1 - f) t (t x w)^T + u t^T/s)/|a| ],
///
/// s = |u x w|: a moment about t acts on p by f and on a by 1 - f. A cable's node has p alone:
/// R = [t 0 0], O = [t]x/lam. docs/theory-dynamics.md derives the rest.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/error.hpp>
#include <ancf/types.hpp>

#include <cmath>

namespace ancf::detail {

/// @throws InvalidArgument unless the field is a slope: r_x, r_y or, in space, r_z.
inline void require_slope(const char* user, Field field, int dimension) {
    require(field == Field::r_x || field == Field::r_y || (dimension == 3 && field == Field::r_z),
            user,
            dimension == 3 ? ": expected a slope r_x, r_y or r_z, got "
                           : ": expected a slope r_x or r_y, got ",
            to_string(field));
}

/// A frame with its spin map at given slopes.
template <class Scalar>
struct Triad {
    Matrix<Scalar, 3> axes;     ///< columns t, n, c; n and c zero for a tangent
    Matrix<Scalar, 3, 6> spin;  ///< w = spin (dp, da); only the first `width` columns are there
    int width = 0;              ///< 0 of space, 3 of a tangent, 6 of two slopes
    bool across = false;        ///< the two slopes are a section's
    double share = 0.5;         ///< of a section: what p takes of a moment about t
    Scalar lam{}, nu{}, al{};   ///< of a section |p|, |a| and s
    Vector<Scalar, 3> u, w;     ///< of a section

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
        f.width = 6;
        const Matrix<Scalar, 3> turn = cross_matrix(t);
        for (int i = 0; i < 3; ++i) {
            f.axes(i, 0) = t[i];
            f.axes(i, 1) = n[i];
            f.axes(i, 2) = c[i];
            for (int k = 0; k < 3; ++k) {
                f.spin(i, k) = (turn(i, k) - f.al * t[i] * c[k]) / f.lam;
                f.spin(i, 3 + k) = t[i] * c[k] / f.nu;
            }
        }
        return f;
    }

    /// The frame of (p, a).
    static Triad of_slopes(const Vector<Scalar, 6>& slopes) {
        return of_slopes({slopes[0], slopes[1], slopes[2]}, {slopes[3], slopes[4], slopes[5]});
    }

    /// The frame of a section with slopes p and a across, r_y and r_z.
    /// @param share  of p in a moment about t, 0 to 1
    static Triad of_section(const Vector<Scalar, 3>& p, const Vector<Scalar, 3>& a, double share) {
        using std::atan;
        using std::cos;
        using std::sin;
        using std::sqrt;
        Triad f;
        f.width = 6;
        f.across = true;
        f.share = share;
        f.lam = sqrt(Scalar(p.transpose() * p));
        f.nu = sqrt(Scalar(a.transpose() * a));
        f.u = p / f.lam;
        f.w = a / f.nu;
        const Vector<Scalar, 3> normal = cross(f.u, f.w);
        f.al = sqrt(Scalar(normal.transpose() * normal));
        const Vector<Scalar, 3> t = normal / f.al;
        const Scalar lack = atan(Scalar(f.u.transpose() * f.w) / f.al);
        const Scalar cosine = cos((1.0 - share) * lack), sine = sin((1.0 - share) * lack);
        const Vector<Scalar, 3> tu = cross(t, f.u), tw = cross(t, f.w);
        for (int i = 0; i < 3; ++i) {
            f.axes(i, 0) = t[i];
            f.axes(i, 1) = cosine * f.u[i] - sine * tu[i];
            f.axes(i, 2) = cosine * tu[i] + sine * f.u[i];
            for (int k = 0; k < 3; ++k) {
                f.spin(i, k) = (share * t[i] * tu[k] - f.w[i] * t[k] / f.al) / f.lam;
                f.spin(i, 3 + k) = ((1.0 - share) * t[i] * tw[k] + f.u[i] * t[k] / f.al) / f.nu;
            }
        }
        return f;
    }

    /// The direction of one slope.
    static Triad of_tangent(const Vector<Scalar, 3>& p) {
        using std::sqrt;
        Triad f;
        f.lam = sqrt(Scalar(p.transpose() * p));
        const Vector<Scalar, 3> t = p / f.lam;
        f.width = 3;
        f.axes.setZero();
        const Matrix<Scalar, 3> turn = cross_matrix(t);
        for (int i = 0; i < 3; ++i) {
            f.axes(i, 0) = t[i];
            for (int k = 0; k < 3; ++k) f.spin(i, k) = turn(i, k) / f.lam;
        }
        return f;
    }

    /// A frame that rests.
    static Triad at_rest(const Matrix<double, 3>& axes) {
        Triad f;
        f.axes = axes.template cast<Scalar>();
        return f;
    }

    /// Returns spin^T m: what a moment (global components) is on (dp, da), zero beyond `width`.
    [[nodiscard]] Vector<Scalar, 6> on_slopes(const Vector<Scalar, 3>& moment) const {
        Vector<Scalar, 6> out = Vector<Scalar, 6>::Zero();
        for (int k = 0; k < width; ++k)
            out[k] = spin(0, k) * moment[0] + spin(1, k) * moment[1] + spin(2, k) * moment[2];
        return out;
    }

    /// Returns R v: global components of a vector given in the frame.
    [[nodiscard]] Vector<Scalar, 3> in_space(const Vector<double, 3>& v) const {
        Vector<Scalar, 3> out;
        for (int k = 0; k < 3; ++k)
            out[k] = axes(k, 0) * v[0] + axes(k, 1) * v[1] + axes(k, 2) * v[2];
        return out;
    }
};

/// Returns d(spin^T m)/d(p, a) of a section's frame.
///
///     spin^T m = ((f m_t t x u - m.w/s t)/|p|,  ((1 - f) m_t t x w + m.u/s t)/|a|),
///     ds = (u.w) dth,  dth = (t x w).dw - (t x u).du
[[nodiscard]] inline Matrix<double, 6> section_spin_derivative(const Triad<double>& f,
                                                               const Vector<double, 3>& m) {
    using Vec = Vector<double, 3>;
    const Vec t = f.axes.col(0), tu = cross(t, f.u), tw = cross(t, f.w);
    const double share_p = f.share, share_a = 1.0 - f.share, s = f.al;
    const double twist_p = share_p * m.dot(t), twist_a = share_a * m.dot(t);
    const double by_u = m.dot(f.u) / s, by_w = m.dot(f.w) / s, cosine = f.u.dot(f.w);
    const Vec on_p = (twist_p * tu - by_w * t) / f.lam, on_a = (twist_a * tw + by_u * t) / f.nu;
    Matrix<double, 6> out;
    for (int k = 0; k < 6; ++k) {  // by p_k, then by a_k
        const bool first = k < 3;
        const Vec unit = Vec::Unit(k % 3), zero = Vec::Zero();
        const double d_p = first ? f.u[k] : 0.0, d_a = first ? 0.0 : f.w[k - 3];
        const Vec du = first ? Vec((unit - d_p * f.u) / f.lam) : zero;
        const Vec dw = first ? zero : Vec((unit - d_a * f.w) / f.nu);
        const Vec dt = cross(Vec(f.spin.col(k)), t);
        const double growth = cosine * (tw.dot(dw) - tu.dot(du)) / s;  // ds/s
        const double d_twist = m.dot(dt);
        const Vec by_p = share_p * d_twist * tu + twist_p * (cross(dt, f.u) + cross(t, du)) -
                         (m.dot(dw) / s - by_w * growth) * t - by_w * dt;
        const Vec by_a = share_a * d_twist * tw + twist_a * (cross(dt, f.w) + cross(t, dw)) +
                         (m.dot(du) / s - by_u * growth) * t + by_u * dt;
        for (int i = 0; i < 3; ++i) {
            out(i, k) = (by_p[i] - d_p * on_p[i]) / f.lam;
            out(3 + i, k) = (by_a[i] - d_a * on_a[i]) / f.nu;
        }
    }
    return out;
}

/// Returns d(spin^T m)/d(p, a) at fixed m: what the load stiffness of a moment is. Only the first
/// `width` rows and columns are there.
///
///     spin^T m = ((m x t)/lam - (al m_t/lam) c,  (m_t/nu) c),    m_t = m.t
[[nodiscard]] inline Matrix<double, 6> spin_derivative(const Triad<double>& f,
                                                       const Vector<double, 3>& m) {
    using Vec = Vector<double, 3>;
    if (f.across) return section_spin_derivative(f, m);
    Matrix<double, 6> out = Matrix<double, 6>::Zero();
    if (f.width == 0) return out;
    const Vec t = f.axes.col(0), n = f.axes.col(1), c = f.axes.col(2);
    const Vec mt = cross(m, t);
    const double twist = m.dot(t), bent = f.al * twist / f.lam;
    for (int k = 0; k < f.width; ++k) {  // by p_k, then by a_k
        const Vec spin = f.spin.col(k), dt = cross(spin, t);
        const double d_lam = k < 3 ? t[k] : 0.0;
        Vec by_p = (cross(m, dt) - d_lam / f.lam * mt) / f.lam;
        if (f.width == 6) {
            const Vec dc = cross(spin, c);
            const double d_twist = m.dot(dt), u_n = n.dot(dt);
            // d(a.t) with a = al nu t + nu n
            const double d_along = (k < 3 ? 0.0 : t[k - 3]) + f.nu * u_n;
            const double d_nu = (k < 3 ? 0.0 : n[k - 3]) - f.al * f.nu * u_n;
            const double d_al = (d_along - f.al * d_nu) / f.nu;
            const double d_bent = (f.al * d_twist + twist * d_al - bent * d_lam) / f.lam;
            const double d_turn = (d_twist - twist / f.nu * d_nu) / f.nu;
            by_p -= d_bent * c + bent * dc;
            for (int i = 0; i < 3; ++i) out(3 + i, k) = d_turn * c[i] + twist / f.nu * dc[i];
        }
        for (int i = 0; i < 3; ++i) out(i, k) = by_p[i];
    }
    return out;
}

}  // namespace ancf::detail
