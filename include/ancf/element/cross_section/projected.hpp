// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Directors by projection of the linearly interpolated slopes: [Dufva2006, Eqs. 11 to 18].
///
/// Geometry of a station in three steps: frames of the two directors; the geometric invariants; and
/// the first and second derivatives of an energy given by its derivatives with respect to the
/// invariants. Derivation: docs/theory.md, "From invariants to local vectors".

#pragma once

#include <ancf/element/cross_section/nodal.hpp>
#include <ancf/element/invariants.hpp>
#include <ancf/element/vec3.hpp>

#include <cmath>
#include <complex>

namespace ancf::detail {

/// Frame, rates and ratios of one director at a station: the direction of a slope a projected on
/// the plane normal to the tangent of the centre line.
///
/// With t = p/|p| and n = unit(a - (a.t) t) the frame is (t, n, c = t x n). A variation and the
/// derivative along x act on it by the same formula, so three rates (kap, chi, om) describe the
/// latter. Derivation: docs/theory.md, "The frame of a director".
template <class S>
struct DirectorFrame {
    Vec3<S> t, n, c;    ///< unit tangent, director, binormal
    S lam;              ///< |p|
    S inv_lam, inv_nu;  ///< 1/|p|, 1/|a - (a.t) t|
    S al;               ///< (a.t)/nu: tangent of the shear angle of the slope
    S eta, kap, chi;    ///< (t, n, c) . p1/lam: growth of |p|, curvatures, 1/m
    S a_t, mu, om;      ///< t.a1/nu, n.a1/nu - al kap, c.a1/nu - al chi: om is the twist rate, 1/m
    S zeta;             ///< al (eta + mu) - a_t
};

/// Returns the frame of the director (p, a), p1 and a1 their derivatives along x.
template <class S>
inline DirectorFrame<S> director_frame(const Vec3<S>& p, const Vec3<S>& p1, const Vec3<S>& a,
                                       const Vec3<S>& a1) noexcept {
    using std::sqrt;
    DirectorFrame<S> f;
    f.lam = sqrt(dot(p, p));
    f.inv_lam = 1.0 / f.lam;
    f.t = f.inv_lam * p;
    const S along = dot(a, f.t);
    const Vec3<S> across = a - along * f.t;
    f.inv_nu = 1.0 / sqrt(dot(across, across));
    f.n = f.inv_nu * across;
    f.c = cross(f.t, f.n);
    f.al = along * f.inv_nu;
    f.eta = dot(f.t, p1) * f.inv_lam;
    f.kap = dot(f.n, p1) * f.inv_lam;
    f.chi = dot(f.c, p1) * f.inv_lam;
    f.a_t = dot(f.t, a1) * f.inv_nu;
    f.mu = dot(f.n, a1) * f.inv_nu - f.al * f.kap;
    f.om = dot(f.c, a1) * f.inv_nu - f.al * f.chi;
    f.zeta = f.al * (f.eta + f.mu) - f.a_t;
    return f;
}

/// The second variation of U_k kap + U_c chi + U_o om plus U_th times that of the frame's spin th,
/// as a quadratic form of the scaled variations, components in (t, n, c):
///
///     u = R^T dp/lam, v = R^T dp1/lam, A = R^T da/nu, B = R^T da1/nu.
///
///
/// Symmetric parts only: the skew part of the spin's second variation cancels between two
/// directors.
template <class S>
struct DirectorHessian {
    S uu[3][3];  ///< symmetric, filled
    S vu[3][3];  ///< rows v, columns u
    S Au[3][3];  ///< rows A, columns u
    S AA[3][3];  ///< symmetric, filled
    S vA_nc;     ///< the entries of vA that are not zero
    S vA_ct, vA_cn, vA_cc;
    S B_o, B_al;  ///< U_o, al U_o. B_t u_c, B_n A_c, B_c A_n have -U_o; B_n u_c, B_c u_n al U_o
};

/// Returns the second variation for the given weights.
template <class S>
inline void director_hessian(const DirectorFrame<S>& f, const S& U_k, const S& U_c, const S& U_o,
                             const S& U_th, DirectorHessian<S>& h) noexcept {
    const S& al = f.al;
    const S& kap = f.kap;
    const S& chi = f.chi;
    const S& om = f.om;
    const S W = U_c - al * U_o;
    const S one_al = 1.0 + al * al;
    const S al_kap_eta = al * kap - f.eta;
    const S g_t = al * chi * U_o - kap * U_k - chi * U_c;
    const S om_n = al * om - chi;
    const S g_n = om_n * U_o - f.eta * U_k;
    const S G = chi * U_k - kap * U_c - f.mu * U_o + U_th;
    const S g_c = al_kap_eta * U_c + f.zeta * U_o - al * (chi * U_k + U_th);
    h.uu[0][0] = -2.0 * g_t;
    h.uu[0][1] = h.uu[1][0] = f.eta * U_k - g_n + chi * one_al * U_o;
    h.uu[0][2] = h.uu[2][0] = al * chi * U_k - g_c - W * al_kap_eta;
    h.uu[1][1] = g_t - kap * U_k + U_o * (one_al * om + al * om_n);
    h.uu[1][2] = h.uu[2][1] = al * g_c - chi * U_k + U_o * (al * f.zeta - al_kap_eta) - 0.5 * U_th;
    h.uu[2][2] = g_t - al * (g_n + al_kap_eta * U_k) - one_al * (chi * U_c + om * U_o);
    h.vu[0][0] = h.vu[1][1] = S(0.0);
    h.vu[0][1] = h.vu[1][0] = -U_k;
    h.vu[0][2] = h.vu[2][0] = -W;
    h.vu[1][2] = al * W;
    h.vu[2][1] = -one_al * U_o;
    h.vu[2][2] = -al * U_k;
    h.Au[0][0] = chi * U_o;
    h.Au[0][1] = (om - al * chi) * U_o;
    h.Au[0][2] = -G - al_kap_eta * U_o;
    h.Au[1][0] = -al * chi * U_o;
    h.Au[1][1] = -2.0 * al * om * U_o;
    h.Au[1][2] = al * G - f.zeta * U_o;
    h.Au[2][0] = kap * U_c - chi * U_k - al * kap * U_o;
    h.Au[2][1] = al * G - (f.zeta - kap) * U_o + f.eta * U_c;
    h.Au[2][2] = (al * om + om_n) * U_o + al_kap_eta * U_k + al * chi * U_c;
    h.AA[0][0] = S(0.0);
    h.AA[0][1] = h.AA[1][0] = chi * U_o;
    h.AA[0][2] = h.AA[2][0] = kap * U_o;
    h.AA[1][1] = 2.0 * om * U_o;
    h.AA[1][2] = h.AA[2][1] = f.mu * U_o - G;
    h.AA[2][2] = -2.0 * om * U_o - kap * U_k - chi * U_c;
    h.vA_nc = -W;
    h.vA_ct = -U_o;
    h.vA_cn = al * U_o;
    h.vA_cc = U_k;
    h.B_o = U_o;
    h.B_al = al * U_o;
}

/// The frames of both directors at a station.
template <class S>
struct ProjectedFrames {
    DirectorFrame<S> y;  ///< of r_y
    DirectorFrame<S> z;  ///< of r_z
};

/// Evaluates both frames.
template <class S>
inline void projected_frames(const LocalVectors<S>& local, ProjectedFrames<S>& f) noexcept {
    f.y = director_frame(local[l_p], local[l_p1], local[l_a], local[l_a1]);
    f.z = director_frame(local[l_p], local[l_p1], local[l_b], local[l_b1]);
}

/// Writes all invariants but the shears.
template <class S>
inline void projected_invariants(const ProjectedFrames<S>& f, Invariants<S>& w) noexcept {
    w.lam = f.y.lam;
    w.kap = f.y.kap;
    w.chi = f.y.chi;
    w.om = f.y.om;
    w.om2 = f.z.om;
    w.C = dot(f.y.n, f.z.n);
    w.S_ = dot(f.y.c, f.z.n);
    w.kap2 = f.z.kap;
    w.chi2 = f.z.chi;
}

/// Writes the gradient with respect to the local vectors, L^T U.
template <class S>
void projected_gradient(const ProjectedFrames<S>& f, const S (&U)[invariant_count],
                        Vec3<S> (&g)[local_count]) noexcept {
    const DirectorFrame<S>&y = f.y, &z = f.z;
    const S &U_k = U[w_kap], &U_c = U[w_chi], &U_o = U[w_om], &U_o2 = U[w_om2], &U_phi = U[w_phi];
    const S il = y.inv_lam;
    const S p_t =
        U[w_lam] + il * (y.al * y.chi * U_o + z.al * z.chi * U_o2 - y.kap * U_k - y.chi * U_c);
    const S p_n = il * ((y.al * y.om - y.chi) * U_o - y.eta * U_k);
    const S p_c =
        il * ((y.al * y.kap - y.eta) * U_c - y.al * y.chi * U_k + y.zeta * U_o + y.al * U_phi);
    const S p_m = il * (z.al * z.om - z.chi) * U_o2;
    const S p_d = il * (z.zeta * U_o2 - z.al * U_phi);
    const S v_n = il * U_k, v_c = il * (U_c - y.al * U_o), v_d = -il * z.al * U_o2;
    const S a_t = -y.inv_nu * y.chi * U_o, a_n = -y.inv_nu * y.om * U_o;
    const S a_c = y.inv_nu * (y.chi * U_k - y.kap * U_c - y.mu * U_o - U_phi),
            a1_c = y.inv_nu * U_o;
    const S b_t = -z.inv_nu * z.chi * U_o2, b_m = -z.inv_nu * z.om * U_o2;
    const S b_d = z.inv_nu * (U_phi - z.mu * U_o2), b1_d = z.inv_nu * U_o2;
    for (int k = 0; k < 3; ++k) {
        g[l_p][k] = p_t * y.t[k] + p_n * y.n[k] + p_c * y.c[k] + p_m * z.n[k] + p_d * z.c[k];
        g[l_p1][k] = v_n * y.n[k] + v_c * y.c[k] + v_d * z.c[k];
        g[l_a][k] = a_t * y.t[k] + a_n * y.n[k] + a_c * y.c[k];
        g[l_a1][k] = a1_c * y.c[k];
        g[l_b][k] = b_t * y.t[k] + b_m * z.n[k] + b_d * z.c[k];
        g[l_b1][k] = b1_d * z.c[k];
    }
}

}  // namespace ancf::detail

namespace ancf {

/// Each director is the projection of its slope on the plane normal to the centre line.
struct Projected {};

}  // namespace ancf
