// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Directors carried along the tangent.
///
/// Each node's director n_i = unit(P a_i) is carried by the smallest rotation from the node's
/// tangent to the station's; between the two carried directors the angle takes its course:
///
///     n(xi) = cos(psi) N_i + sin(psi) t x N_i,    phi the angle from N_i to N_j about t.
///
/// The z director does the same with its own angle, phi and what the nodes' angles from the y to
/// the z director differ by. Derivation: docs/theory-directors.md, "The angle between carried
/// directors".

#pragma once

#include <ancf/element/invariants.hpp>
#include <ancf/element/transport.hpp>
#include <ancf/element/vec3.hpp>

#include <cmath>
#include <complex>

namespace ancf::detail {

/// The angle phi from one node's carried director to the other's is linear: at xi the director has
/// turned by psi = xi phi.
struct LinearAngle {
    static constexpr bool linear = true;  ///< whether psi is in proportion to phi
};

/// The angle is that of the vectors' linear interpolation: tan psi = xi sin phi/(1 - xi + xi cos
/// phi). Derivation: docs/theory-directors.md, "The course of the angle".
struct ChordAngle {
    static constexpr bool linear = false;  ///< whether psi is in proportion to phi
};

/// psi at a station with its derivatives.
template <class S>
struct AngleCourse {
    S value;    ///< psi
    S rate;     ///< psi_x at a fixed phi
    S share;    ///< psi_phi
    S share_x;  ///< psi_phi,x
    S bend;     ///< psi_phi,phi
    S bend_x;   ///< psi_phi,phi,x
    S change;   ///< psi_phi,phi,phi
};

/// Returns psi of ChordAngle with its derivatives.
/// @param part,part_x  xi and its derivative along x
/// @param turn         phi
template <class S>
inline AngleCourse<S> chord_course(const S& part, const S& part_x, const S& turn) noexcept {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const S cosine = cos(turn), sine = sin(turn), rest = 1.0 - part;
    const S along = rest + part * cosine, across = part * sine;
    const S square = along * along + across * across, inverse = 1.0 / square;
    const S skew = part * rest * inverse, k = skew * sine, slant = (2.0 * part - 1.0) * inverse;
    AngleCourse<S> psi;
    psi.value = 2.0 * arctan(S(across / (sqrt(square) + along)));
    psi.rate = part_x * inverse * sine;
    psi.share = part * inverse * (part + rest * cosine);
    psi.share_x = part_x * inverse * (cosine + 2.0 * k * sine);
    psi.bend = slant * k;
    psi.bend_x = part_x * inverse * ((8.0 * k * k - 1.0) * sine + 6.0 * k * cosine);
    psi.change = slant * skew * (cosine + 4.0 * k * sine);
    return psi;
}

/// A director at a node: n = unit(a - (a.t) t), c = t x n. Its spin about the tangent is the form
/// th = c.da/nu - al c.dg/|g|.
template <class S>
struct NodalDirector {
    Vec3<S> t, n, c;
    S inv_g;   ///< 1/|g|
    S inv_nu;  ///< 1/|a - (a.t) t|
    S al;      ///< (a.t)/nu
};

template <class S>
inline NodalDirector<S> nodal_director(const Vec3<S>& g, const Vec3<S>& a) noexcept {
    using std::sqrt;
    NodalDirector<S> f;
    f.inv_g = 1.0 / sqrt(dot(g, g));
    f.t = f.inv_g * g;
    const S along = dot(a, f.t);
    const Vec3<S> across = a - along * f.t;
    f.inv_nu = 1.0 / sqrt(dot(across, across));
    f.n = f.inv_nu * across;
    f.c = cross(f.t, f.n);
    f.al = along * f.inv_nu;
    return f;
}

/// Returns the angle about the axis of a turn with this cosine and sine, in (-pi, pi).
template <class S>
inline S turn_angle(const S& cosine, const S& sine) noexcept {
    return 2.0 * arctan(S(sine / (1.0 + cosine)));
}

/// Places of the scalars at the nodes whose variations a station sees besides the vectors p, p1,
/// g_i, g_j.
enum SpinIndex : int { spin_y1, spin_y2, angle_1, angle_2, spin_count };

/// Vectors of a station.
enum CarriedIndex : int { v_p, v_p1, v_g1, v_g2, carried_count };

/// Courses of the angles of the y and the z director; n2 and n2_x say all of linear ones.
template <class S, class Angle>
struct AngleCourses {
    AngleCourse<S> y, z;
    S further;  ///< twist rate that carrying adds, second node less first
};
template <class S>
struct AngleCourses<S, LinearAngle> {};

/// The geometry of a station.
template <class S, class Angle = LinearAngle>
struct CarriedFrame : AngleCourses<S, Angle> {
    Vec3<S> p, p1, g[2];
    Vec3<S> t, n, c;
    S lam, inv_lam, kap, chi, eta;
    S n2, n2_x;  ///< xi and its derivative along x
    Transport<S> from[2];
};

/// Returns a director of a node carried from its tangent to t.
template <class S>
inline Vec3<S> carried(const NodalDirector<S>& node, const Vec3<S>& t) noexcept {
    const S factor = dot(t, node.n) / (1.0 + dot(t, node.t));
    Vec3<S> result;
    for (int k = 0; k < 3; ++k) result[k] = node.n[k] - factor * (node.t[k] + t[k]);
    return result;
}

/// Writes frame and invariants but the shears of a station.
/// @param f       p, p1, g, n2 and n2_x are given
/// @param y       y directors of the nodes
/// @param angles  from the y to the z director at the nodes
template <class S, class Angle>
inline void carried_invariants(const NodalDirector<S> (&y)[2], const S (&angles)[2],
                               CarriedFrame<S, Angle>& f, Invariants<S>& w) noexcept {
    using std::cos;
    using std::sin;
    using std::sqrt;
    f.lam = sqrt(dot(f.p, f.p));
    f.inv_lam = 1.0 / f.lam;
    f.t = f.inv_lam * f.p;
    const Vec3<S> first = carried(y[0], f.t), second = carried(y[1], f.t),
                  binormal = cross(f.t, first);
    const S turn = turn_angle(S(dot(first, second)), S(dot(binormal, second)));
    const S difference = angles[1] - angles[0];
    S part = f.n2 * turn;
    if constexpr (!Angle::linear) {
        f.y = chord_course(f.n2, f.n2_x, turn);
        f.z = chord_course(f.n2, f.n2_x, S(turn + difference));
        part = f.y.value;
    }
    const S cosine = cos(part), sine = sin(part);
    for (int k = 0; k < 3; ++k) {
        f.n[k] = cosine * first[k] + sine * binormal[k];
        f.c[k] = cosine * binormal[k] - sine * first[k];
    }
    f.eta = f.inv_lam * dot(f.t, f.p1);
    f.kap = f.inv_lam * dot(f.n, f.p1);
    f.chi = f.inv_lam * dot(f.c, f.p1);
    for (int node = 0; node < 2; ++node) f.from[node] = transport(f.g[node], f.p, f.p1, f.lam, f.t);
    S phi = angles[0] + f.n2 * difference;
    const S first_F = f.from[0].F, further = f.from[1].F - f.from[0].F;
    if constexpr (Angle::linear) {
        w.om = first_F + f.n2 * further + f.n2_x * turn;
        w.om2 = w.om + f.n2_x * difference;
    } else {
        f.further = further;
        phi = angles[0] + f.z.value - f.y.value;
        w.om = first_F + f.y.share * further + f.y.rate;
        w.om2 = first_F + f.z.share * further + f.z.rate;
    }
    w.lam = f.lam;
    w.kap = f.kap;
    w.chi = f.chi;
    w.C = cos(phi);
    w.S_ = sin(phi);
    w.kap2 = w.C * f.kap + w.S_ * f.chi;
    w.chi2 = w.C * f.chi - w.S_ * f.kap;
}

/// The variations that the invariants are linear in: those of lam, of kap and chi at fixed spin,
/// the spins at both nodes, the twist rates that carrying adds, the two angles, and the four
/// shears. With a linear angle F1 is the mean (1 - xi) F_i + xi F_j of the rates and F2 does not
/// exist.
enum FormIndex : int {
    f_lam,
    f_kap,
    f_chi,
    f_th1,
    f_th2,
    f_F1,
    f_angle1,
    f_angle2,
    f_s,
    f_s1,
    f_q,
    f_q1,
    f_F2,
};

/// How many of them there are.
template <class Angle>
inline constexpr int form_count = Angle::linear ? int(f_F2) : f_F2 + 1;

/// What the difference of a form between the nodes counts for at a station.
template <class S>
struct Shares {
    S y, z;            ///< of the spin of each director
    S rate_y, rate_z;  ///< of its twist rate, 1/m
};

/// Returns them for a linear angle.
template <class S>
inline Shares<S> shares(const CarriedFrame<S, LinearAngle>& f) noexcept {
    return {f.n2, f.n2, f.n2_x, f.n2_x};
}

/// Returns them for the angle of interpolated vectors.
template <class S>
inline Shares<S> shares(const CarriedFrame<S, ChordAngle>& f) noexcept {
    return {f.y.share, f.z.share, f.y.share_x + f.y.bend * f.further,
            f.z.share_x + f.z.bend * f.further};
}

/// Turns weights of the invariants' variations into weights of the forms.
template <class S, class Angle>
inline void weigh_forms(const CarriedFrame<S, Angle>& f, const S (&X)[invariant_count],
                        S (&form)[form_count<Angle>]) noexcept {
    const Shares<S> share = shares(f);
    const S turning = f.chi * X[w_kap] - f.kap * X[w_chi];
    const S angle = share.z * X[w_phi] + share.rate_z * X[w_om2];
    const S spin = share.y * (turning - X[w_phi]) + share.rate_y * X[w_om] + angle;
    if constexpr (Angle::linear) {
        form[f_F1] = X[w_om] + X[w_om2];
    } else {
        form[f_F2] = share.y * X[w_om] + share.z * X[w_om2];
        form[f_F1] = X[w_om] + X[w_om2] - form[f_F2];
    }
    form[f_lam] = X[w_lam];
    form[f_kap] = X[w_kap];
    form[f_chi] = X[w_chi];
    form[f_th1] = turning - spin;
    form[f_th2] = spin;
    form[f_angle1] = X[w_phi] - angle;
    form[f_angle2] = angle;
    form[f_s] = X[w_s];
    form[f_s1] = X[w_s1];
    form[f_q] = X[w_q];
    form[f_q1] = X[w_q1];
}

/// Weights of the forms that the second variation needs: dW = sum spin[i] th_i + angle[i] d angle_i
/// + ...
template <class S>
struct SpinWeights {
    S spin[2], angle[2];
    S F[2];  ///< of the twist rates
};

template <class S, class Angle>
inline SpinWeights<S> spin_weights(const CarriedFrame<S, Angle>& f,
                                   const S (&U)[invariant_count]) noexcept {
    S form[form_count<Angle>];
    weigh_forms(f, U, form);
    SpinWeights<S> w;
    for (int i = 0; i < 2; ++i) {
        w.spin[i] = form[f_th1 + i];
        w.angle[i] = form[f_angle1 + i];
    }
    if constexpr (Angle::linear) {
        w.F[1] = f.n2 * form[f_F1];
        w.F[0] = form[f_F1] - w.F[1];
    } else {
        w.F[0] = form[f_F1];
        w.F[1] = form[f_F2];
    }
    return w;
}

/// Writes the gradient with respect to p, p1, g_i, g_j and the forms of SpinIndex.
template <class S, class Angle>
inline void carried_gradient(const CarriedFrame<S, Angle>& f, const S (&U)[invariant_count],
                             Vec3<S> (&vector)[carried_count], S (&spin)[spin_count]) noexcept {
    const SpinWeights<S> w = spin_weights(f, U);
    const S il = f.inv_lam;
    const S p_t = U[w_lam] - il * (f.kap * U[w_kap] + f.chi * U[w_chi]);
    const S p_n = -il * f.eta * U[w_kap], p_c = -il * f.eta * U[w_chi];
    const S v_n = il * U[w_kap], v_c = il * U[w_chi];
    for (int k = 0; k < 3; ++k) {
        vector[v_p][k] = p_t * f.t[k] + p_n * f.n[k] + p_c * f.c[k];
        vector[v_p1][k] = v_n * f.n[k] + v_c * f.c[k];
        for (int i = 0; i < 2; ++i) {
            vector[v_p][k] += w.F[i] * f.from[i].dF[t_p][k] + w.spin[i] * f.from[i].sp[k];
            vector[v_p1][k] += w.F[i] * f.from[i].dF[t_p1][k];
            vector[v_g1 + i][k] = w.F[i] * f.from[i].dF[t_g][k] + w.spin[i] * f.from[i].sg[k];
        }
    }
    for (int i = 0; i < 2; ++i) {
        spin[spin_y1 + i] = w.spin[i];
        spin[angle_1 + i] = w.angle[i];
    }
}

}  // namespace ancf::detail
