// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Generalised forces of loads as the theory writes them, for complex steps; docs/theory-statics.md
/// and docs/theory-damping.md.

#pragma once

#include <ancf/element/vec3.hpp>
#include <ancf/types.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace ancf::test {

/// m (n x a_p)/|a_p|^2, a_p = a - (a.n) n.
template <class S>
[[nodiscard]] Vector<S, 3> slope_moment(const Vector<double, 3>& n, double m,
                                        const Vector<S, 3>& slope) {
    const auto axis = detail::vec3<S>(n), a = detail::vec3<S>(slope);
    const auto ap = a - dot(a, axis) * axis;
    return detail::to_vector(m * cross(axis, ap) / dot(ap, ap));
}

/// m (-a_y, a_x)/|a|^2.
template <class S>
[[nodiscard]] Vector<S, 2> planar_slope_moment(double m, const Vector<S, 2>& a) {
    const S square = a[0] * a[0] + a[1] * a[1];
    return {-m * a[1] / square, m * a[0] / square};
}

/// (m x t)/|r_x|, t = r_x/|r_x|.
template <class S>
[[nodiscard]] Vector<S, 3> tangent_moment(const Vector<double, 3>& m, const Vector<S, 3>& r_x) {
    const auto a = detail::vec3<S>(r_x);
    const S size = length(a);
    return detail::to_vector(cross(detail::vec3<S>(m), a / size) / size);
}

/// t along p, n in the plane of p and a, c = t x n.
template <class S>
[[nodiscard]] std::array<detail::Vec3<S>, 3> frame_of_slopes(const Vector<S, 6>& slopes) {
    const auto p = detail::vec3<S>(slopes), a = detail::vec3<S>(slopes, 3), t = p / length(p);
    const auto normal = a - dot(a, t) * t, n = normal / length(normal);
    return {t, n, cross(t, n)};
}

/// t normal to both slopes, n and c as far from them on either side.
template <class S>
[[nodiscard]] std::array<detail::Vec3<S>, 3> frame_of_section(const Vector<S, 6>& slopes) {
    const auto y = detail::vec3<S>(slopes), z = detail::vec3<S>(slopes, 3);
    const auto u = y / length(y), w = z / length(z), normal = cross(u, w);
    const auto t = normal / length(normal), between = u - cross(t, w);
    const auto n = between / length(between);
    return {t, n, cross(t, n)};
}

/// R m.
template <class S>
[[nodiscard]] detail::Vec3<S> in_space(const std::array<detail::Vec3<S>, 3>& frame,
                                       const Vector<double, 3>& m) {
    return m[0] * frame[0] + m[1] * frame[1] + m[2] * frame[2];
}

/// Q_rx = (m_c n - (m_n + al m_t) c)/|r_x|, Q_ry = m_t c/nu; nu the part of r_y normal to t, al nu
/// that along t. The moment is in the frame or in space.
template <class S>
[[nodiscard]] Vector<S, 6> moment_on_tangent(const Vector<double, 3>& given, bool in_frame,
                                             const Vector<S, 6>& slopes) {
    const auto frame = frame_of_slopes(slopes);
    const auto& [t, n, c] = frame;
    const auto p = detail::vec3<S>(slopes), a = detail::vec3<S>(slopes, 3);
    const auto m = in_frame ? in_space(frame, given) : detail::vec3<S>(given);
    const S nu = dot(a, n), al = dot(a, t) / nu, twist = dot(m, t);
    const auto on_p = (dot(m, c) * n - (dot(m, n) + al * twist) * c) / length(p);
    const auto on_a = twist / nu * c;
    return {on_p[0], on_p[1], on_p[2], on_a[0], on_a[1], on_a[2]};
}

/// Q_ry = (m_t/2 t x u - m.w/s t)/|r_y|, Q_rz = (m_t/2 t x w + m.u/s t)/|r_z|; u and w the unit
/// vectors of r_y and r_z, s = |u x w|.
template <class S>
[[nodiscard]] Vector<S, 6> moment_on_section(const Vector<double, 3>& given, bool in_frame,
                                             const Vector<S, 6>& slopes) {
    const auto frame = frame_of_section(slopes);
    const auto& t = frame[0];
    const auto y = detail::vec3<S>(slopes), z = detail::vec3<S>(slopes, 3);
    const auto m = in_frame ? in_space(frame, given) : detail::vec3<S>(given);
    const S lam = length(y), nu = length(z), half = 0.5 * dot(m, t);
    const auto u = y / lam, w = z / nu;
    const S s = length(cross(u, w));
    const auto on_y = (half * cross(t, u) - dot(m, w) / s * t) / lam;
    const auto on_z = (half * cross(t, w) + dot(m, u) / s * t) / nu;
    return {on_y[0], on_y[1], on_y[2], on_z[0], on_z[1], on_z[2]};
}

/// R f on r, in the frame of slopes.
template <class S>
[[nodiscard]] Vector<S, 3> follower_force(const Vector<double, 3>& f, const Vector<S, 6>& slopes) {
    return detail::to_vector(in_space(frame_of_slopes(slopes), f));
}

/// Two points, or a point and the origin, of weighted vectors: d = W q.
template <int Dimension>
struct WeightedPoints {
    std::vector<double> weights;  ///< of the vectors of q, those of the second point negative

    template <class S>
    [[nodiscard]] Vector<S, Dimension> difference(const DynamicVector<S>& q) const {
        Vector<S, Dimension> d = Vector<S, Dimension>::Zero();
        for (int k = 0; k < q.size(); ++k) d[k % Dimension] += weights[k / Dimension] * q[k];
        return d;
    }

    /// W^T f.
    template <class S>
    [[nodiscard]] DynamicVector<S> spread(const Vector<S, Dimension>& f) const {
        DynamicVector<S> out(Dimension * static_cast<int>(weights.size()));
        for (int k = 0; k < out.size(); ++k) out[k] = weights[k / Dimension] * f[k % Dimension];
        return out;
    }

    /// -k (1 - l0/l) d, l = |d|; -k d where l0 = 0.
    template <class S>
    [[nodiscard]] DynamicVector<S> spring(double stiffness, double rest,
                                          const DynamicVector<S>& q) const {
        using std::sqrt;
        const Vector<S, Dimension> d = difference(q);
        const S distance = sqrt(detail::product(d, d));
        return spread<S>(-stiffness * (1.0 - rest / distance) * d);
    }

    /// -c (n.w) n, n = d/l, w = W v.
    template <class S>
    [[nodiscard]] DynamicVector<S> damper(double damping, const DynamicVector<S>& q,
                                          const DynamicVector<S>& v) const {
        const Vector<S, Dimension> d = difference(q), w = difference(v);
        return spread<S>(-damping * detail::product(d, w) / detail::product(d, d) * d);
    }
};

}  // namespace ancf::test
