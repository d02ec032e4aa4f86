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
#include <ancf/element/vec3.hpp>
#include <ancf/error.hpp>

#include <array>
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
    using Vec = Vec3<Scalar>;

    std::array<Vec, 3> axes = {};  ///< t, n, c; n and c zero for a tangent
    std::array<Vec, 6> spin = {};  ///< w = sum_k spin_k d(p, a)_k, of the first `width` components
    int width = 0;                 ///< 0 of space, 3 of a tangent, 6 of two slopes
    bool across = false;           ///< the two slopes are a section's
    double share = 0.5;            ///< of a section: what p takes of a moment about t
    Scalar lam{}, nu{}, al{};      ///< of a section |p|, |a| and s
    Vec u = {}, w = {};            ///< of a section

    /// The frame of two slopes.
    static Triad of_slopes(const Vec& p, const Vec& a) {
        Triad f = of_tangent(p);
        const Vec& t = f.axes[0];
        const Scalar along = dot(a, t);
        const Vec normal = a - along * t;
        f.nu = length(normal);
        f.axes[1] = normal / f.nu;
        f.axes[2] = cross(t, f.axes[1]);
        f.al = along / f.nu;
        f.width = 6;
        for (int k = 0; k < 3; ++k) {
            const Scalar c = f.axes[2][k];
            f.spin[k] = f.spin[k] - f.al * c / f.lam * t;
            f.spin[3 + k] = c / f.nu * t;
        }
        return f;
    }

    /// The frame of a section with slopes p and a across, r_y and r_z.
    /// @param share  of p in a moment about t, 0 to 1
    static Triad of_section(const Vec& p, const Vec& a, double share) {
        using std::cos;
        using std::sin;
        Triad f;
        f.width = 6;
        f.across = true;
        f.share = share;
        f.lam = length(p);
        f.nu = length(a);
        f.u = p / f.lam;
        f.w = a / f.nu;
        const Vec normal = cross(f.u, f.w);
        f.al = length(normal);
        const Vec t = normal / f.al, tu = cross(t, f.u), tw = cross(t, f.w);
        const Scalar lack = arctan(Scalar(dot(f.u, f.w) / f.al));
        const Scalar cosine = cos((1.0 - share) * lack), sine = sin((1.0 - share) * lack);
        f.axes = {t, cosine * f.u - sine * tu, cosine * tu + sine * f.u};
        for (int k = 0; k < 3; ++k) {
            f.spin[k] = (share * tu[k] * t - t[k] / f.al * f.w) / f.lam;
            f.spin[3 + k] = ((1.0 - share) * tw[k] * t + t[k] / f.al * f.u) / f.nu;
        }
        return f;
    }

    /// The direction of one slope.
    static Triad of_tangent(const Vec& p) {
        Triad f;
        f.lam = length(p);
        f.width = 3;
        const Vec t = f.axes[0] = p / f.lam;
        f.spin[0] = Vec{{Scalar(0), t[2], -t[1]}} / f.lam;
        f.spin[1] = Vec{{-t[2], Scalar(0), t[0]}} / f.lam;
        f.spin[2] = Vec{{t[1], -t[0], Scalar(0)}} / f.lam;
        return f;
    }

    /// A frame that rests.
    static Triad at_rest(const std::array<Vec3<double>, 3>& axes) {
        Triad f;
        for (int k = 0; k < 3; ++k) f.axes[k] = vec3<Scalar>(axes[k]);
        return f;
    }

    /// Returns R v: global components of a vector given in the frame.
    [[nodiscard]] Vec in_space(const Vec3<double>& v) const {
        return v[0] * axes[0] + v[1] * axes[1] + v[2] * axes[2];
    }
};

/// Returns d(spin^T m)/d(p, a) of a section's frame.
///
///     spin^T m = ((f m_t t x u - m.w/s t)/|p|,  ((1 - f) m_t t x w + m.u/s t)/|a|),
///     ds = (u.w) dth,  dth = (t x w).dw - (t x u).du
[[nodiscard]] inline Block<double, 6> section_spin_derivative(const Triad<double>& f,
                                                              const Vec3<double>& m) {
    using Vec = Vec3<double>;
    const Vec &t = f.axes[0], tu = cross(t, f.u), tw = cross(t, f.w);
    const double share_p = f.share, share_a = 1.0 - f.share, s = f.al;
    const double twist_p = share_p * dot(m, t), twist_a = share_a * dot(m, t);
    const double by_u = dot(m, f.u) / s, by_w = dot(m, f.w) / s, cosine = dot(f.u, f.w);
    const Vec on_p = (twist_p * tu - by_w * t) / f.lam, on_a = (twist_a * tw + by_u * t) / f.nu;
    Block<double, 6> out;
    for (int k = 0; k < 6; ++k) {  // by p_k, then by a_k
        const bool first = k < 3;
        const double d_p = first ? f.u[k] : 0.0, d_a = first ? 0.0 : f.w[k - 3];
        Vec du = {}, dw = {};
        (first ? du : dw)[k % 3] = 1.0;
        du = (du - d_p * f.u) / f.lam;
        dw = (dw - d_a * f.w) / f.nu;
        const Vec dt = cross(f.spin[k], t);
        const double growth = cosine * (dot(tw, dw) - dot(tu, du)) / s;  // ds/s
        const double d_twist = dot(m, dt);
        const Vec by_p = share_p * d_twist * tu + twist_p * (cross(dt, f.u) + cross(t, du)) -
                         (dot(m, dw) / s - by_w * growth) * t - by_w * dt;
        const Vec by_a = share_a * d_twist * tw + twist_a * (cross(dt, f.w) + cross(t, dw)) +
                         (dot(m, du) / s - by_u * growth) * t + by_u * dt;
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
[[nodiscard]] inline Block<double, 6> spin_derivative(const Triad<double>& f,
                                                      const Vec3<double>& m) {
    using Vec = Vec3<double>;
    if (f.across) return section_spin_derivative(f, m);
    Block<double, 6> out = {};
    if (f.width == 0) return out;
    const auto& [t, n, c] = f.axes;
    const Vec mt = cross(m, t);
    const double twist = dot(m, t), bent = f.al * twist / f.lam;
    for (int k = 0; k < f.width; ++k) {  // by p_k, then by a_k
        const Vec dt = cross(f.spin[k], t);
        const double d_lam = k < 3 ? t[k] : 0.0;
        Vec by_p = (cross(m, dt) - d_lam / f.lam * mt) / f.lam;
        if (f.width == 6) {
            const Vec dc = cross(f.spin[k], c);
            const double d_twist = dot(m, dt), u_n = dot(n, dt);
            // d(a.t) with a = al nu t + nu n
            const double d_along = (k < 3 ? 0.0 : t[k - 3]) + f.nu * u_n;
            const double d_nu = (k < 3 ? 0.0 : n[k - 3]) - f.al * f.nu * u_n;
            const double d_al = (d_along - f.al * d_nu) / f.nu;
            const double d_bent = (f.al * d_twist + twist * d_al - bent * d_lam) / f.lam;
            const double d_turn = (d_twist - twist / f.nu * d_nu) / f.nu;
            by_p = by_p - d_bent * c - bent * dc;
            for (int i = 0; i < 3; ++i) out(3 + i, k) = d_turn * c[i] + twist / f.nu * dc[i];
        }
        for (int i = 0; i < 3; ++i) out(i, k) = by_p[i];
    }
    return out;
}

}  // namespace ancf::detail
