// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Directors carried along the tangent, their angle interpolated: uniform bending and twist are
/// exact.
///
/// Each node's director n_i = unit(P a_i) is carried by the smallest rotation from the node's
/// tangent to the station's; between the two carried directors the angle varies linearly:
///
///     n(xi) = cos(xi phi) N_i + sin(xi phi) t x N_i,    phi the angle from N_i to N_j about t.
///
/// The z director turns against the y director by an angle that is linear between the nodes as
/// well. Derivation: docs/theory-directors.md, "The angle between carried directors".

#pragma once

#include <ancf/element/compiler.hpp>
#include <ancf/element/invariants.hpp>
#include <ancf/element/transport.hpp>
#include <ancf/element/vec3.hpp>

#include <cmath>
#include <complex>

namespace ancf::detail {

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
    using std::atan;
    return 2.0 * atan(S(sine / (1.0 + cosine)));
}

/// Places of the scalars at the nodes whose variations a station sees besides the vectors p, p1,
/// g_i, g_j.
enum SpinIndex : int { spin_y1, spin_y2, angle_1, angle_2, spin_count };

/// Vectors of a geodesic station.
enum GeodesicIndex : int { v_p, v_p1, v_g1, v_g2, geodesic_count };

/// The geometry of a geodesic station.
template <class S>
struct GeodesicFrame {
    Vec3<S> p, p1, g[2];
    Vec3<S> t, n, c;
    S lam, inv_lam, kap, chi, eta;
    S n2, n2_x;  ///< xi and its derivative along x
    Transport<S> from[2];
};

/// Returns a director of a node carried from its tangent to t; turn = 1/(1 + t_i.t).
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
template <class S>
inline void geodesic_invariants(const NodalDirector<S> (&y)[2], const S (&angles)[2],
                                GeodesicFrame<S>& f, Invariants<S>& w) noexcept {
    using std::cos;
    using std::sin;
    using std::sqrt;
    f.lam = sqrt(dot(f.p, f.p));
    f.inv_lam = 1.0 / f.lam;
    f.t = f.inv_lam * f.p;
    const Vec3<S> first = carried(y[0], f.t), second = carried(y[1], f.t),
                  binormal = cross(f.t, first);
    const S turn = turn_angle(S(dot(first, second)), S(dot(binormal, second)));
    const S part = f.n2 * turn;
    const S cosine = cos(part), sine = sin(part);
    for (int k = 0; k < 3; ++k) {
        f.n[k] = cosine * first[k] + sine * binormal[k];
        f.c[k] = cosine * binormal[k] - sine * first[k];
    }
    f.eta = f.inv_lam * dot(f.t, f.p1);
    f.kap = f.inv_lam * dot(f.n, f.p1);
    f.chi = f.inv_lam * dot(f.c, f.p1);
    for (int node = 0; node < 2; ++node) f.from[node] = transport(f.g[node], f.p, f.p1, f.lam, f.t);
    const S difference = angles[1] - angles[0];
    const S phi = angles[0] + f.n2 * difference;
    w.lam = f.lam;
    w.kap = f.kap;
    w.chi = f.chi;
    w.om = f.from[0].F + f.n2 * (f.from[1].F - f.from[0].F) + f.n2_x * turn;
    w.om2 = w.om + f.n2_x * difference;
    w.C = cos(phi);
    w.S_ = sin(phi);
    w.kap2 = w.C * f.kap + w.S_ * f.chi;
    w.chi2 = w.C * f.chi - w.S_ * f.kap;
}

/// Weights of the forms that the second variation needs: dW = sum spin[i] th_i + angle[i] d angle_i
/// + ...
template <class S>
struct SpinWeights {
    S spin[2], angle[2];
    S F[2];  ///< of the twist rates
};

template <class S>
inline SpinWeights<S> spin_weights(const GeodesicFrame<S>& f,
                                   const S (&U)[invariant_count]) noexcept {
    const S turning = f.chi * U[w_kap] - f.kap * U[w_chi];
    const S twisting = U[w_om] + U[w_om2];
    const S rate = f.n2_x * twisting, rate2 = f.n2_x * U[w_om2];
    SpinWeights<S> w;
    w.spin[1] = f.n2 * turning;
    w.spin[0] = turning - w.spin[1] - rate;
    w.spin[1] += rate;
    w.angle[1] = f.n2 * U[w_phi];
    w.angle[0] = U[w_phi] - w.angle[1] - rate2;
    w.angle[1] += rate2;
    w.F[1] = f.n2 * twisting;
    w.F[0] = twisting - w.F[1];
    return w;
}

/// Writes the gradient with respect to p, p1, g_i, g_j and the forms of SpinIndex.
template <class S>
inline void geodesic_gradient(const GeodesicFrame<S>& f, const S (&U)[invariant_count],
                              Vec3<S> (&vector)[geodesic_count], S (&spin)[spin_count]) noexcept {
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

/// Second derivatives at a geodesic station. Scalars: the forms of SpinIndex, then s, s', q, q'.
template <class S>
struct GeodesicHessian {
    static constexpr int scalars = spin_count + 4;
    Block<S> block[10];  ///< upper triangle, column by column; diagonal blocks filled
    Vec3<S> coupling[geodesic_count][scalars];
    S scalar[scalars][scalars];  ///< symmetric, filled

    Block<S>& operator()(int i, int j) noexcept { return block[j * (j + 1) / 2 + i]; }
    const Block<S>& operator()(int i, int j) const noexcept { return block[j * (j + 1) / 2 + i]; }
};

/// The variations that the invariants are linear in: those of lam, of kap and chi at fixed spin,
/// the spins at both nodes, the mean twist rate, the two angles, and the four shears.
enum FormIndex : int {
    f_lam,
    f_kap,
    f_chi,
    f_th1,
    f_th2,
    f_F,
    f_angle1,
    f_angle2,
    f_s,
    f_s1,
    f_q,
    f_q1,
    form_count
};

/// Writes M, the Hessian with respect to the forms: T^T D T with dw = T (forms), and the terms of
/// the second variation that are products of forms with the spin.
template <class S>
inline void form_hessian(const GeodesicFrame<S>& f, const S (&U)[invariant_count],
                         const S (&D)[invariant_count][invariant_count],
                         S (&M)[form_count][form_count]) noexcept {
    const S n1 = 1.0 - f.n2;
    S half[form_count][invariant_count];  // T^T D
    for (int j = 0; j < invariant_count; ++j) {
        const S th = f.chi * D[w_kap][j] - f.kap * D[w_chi][j];
        const S om = D[w_om][j] + D[w_om2][j];
        half[f_lam][j] = D[w_lam][j];
        half[f_kap][j] = D[w_kap][j];
        half[f_chi][j] = D[w_chi][j];
        half[f_th1][j] = n1 * th - f.n2_x * om;
        half[f_th2][j] = f.n2 * th + f.n2_x * om;
        half[f_F][j] = om;
        half[f_angle1][j] = n1 * D[w_phi][j] - f.n2_x * D[w_om2][j];
        half[f_angle2][j] = f.n2 * D[w_phi][j] + f.n2_x * D[w_om2][j];
        half[f_s][j] = D[w_s][j];
        half[f_s1][j] = D[w_s1][j];
        half[f_q][j] = D[w_q][j];
        half[f_q1][j] = D[w_q1][j];
    }
    for (int i = 0; i < form_count; ++i) {
        const S(&h)[invariant_count] = half[i];
        const S th = f.chi * h[w_kap] - f.kap * h[w_chi];
        const S om = h[w_om] + h[w_om2];
        M[i][f_lam] = h[w_lam];
        M[i][f_kap] = h[w_kap];
        M[i][f_chi] = h[w_chi];
        M[i][f_th1] = n1 * th - f.n2_x * om;
        M[i][f_th2] = f.n2 * th + f.n2_x * om;
        M[i][f_F] = om;
        M[i][f_angle1] = n1 * h[w_phi] - f.n2_x * h[w_om2];
        M[i][f_angle2] = f.n2 * h[w_phi] + f.n2_x * h[w_om2];
        M[i][f_s] = h[w_s];
        M[i][f_s1] = h[w_s1];
        M[i][f_q] = h[w_q];
        M[i][f_q1] = h[w_q1];
    }
    const S spin[2] = {n1, f.n2};
    const S twice = f.kap * U[w_kap] + f.chi * U[w_chi];
    for (int i = 0; i < 2; ++i) {
        M[f_th1 + i][f_chi] += spin[i] * U[w_kap];
        M[f_chi][f_th1 + i] += spin[i] * U[w_kap];
        M[f_th1 + i][f_kap] -= spin[i] * U[w_chi];
        M[f_kap][f_th1 + i] -= spin[i] * U[w_chi];
        for (int j = 0; j < 2; ++j) M[f_th1 + i][f_th1 + j] -= spin[i] * spin[j] * twice;
    }
}

/// Adds the second variation of lam, kap and chi at fixed spin to the blocks of p and p1.
template <class S>
inline void add_line_curvature(const GeodesicFrame<S>& f, const S (&U)[invariant_count],
                               GeodesicHessian<S>& h) noexcept {
    const S scale = f.inv_lam * f.inv_lam;
    const S k = scale * U[w_kap], c = scale * U[w_chi];
    const S tt = 2.0 * (f.kap * k + f.chi * c), tn = 2.0 * f.eta * k, tc = 2.0 * f.eta * c;
    const S lam = f.inv_lam * U[w_lam];
    const S nn = lam - 2.0 * f.kap * k - f.chi * c, cc = lam - f.kap * k - 2.0 * f.chi * c;
    const S nc = -0.5 * (f.chi * k + f.kap * c);
    for (int j = 0; j < 3; ++j) {
        const S t_j = tt * f.t[j] + tn * f.n[j] + tc * f.c[j];
        const S n_j = tn * f.t[j] + nn * f.n[j] + nc * f.c[j];
        const S c_j = tc * f.t[j] + nc * f.n[j] + cc * f.c[j];
        const S bend_j = k * f.n[j] + c * f.c[j];
        for (int i = 0; i < 3; ++i) {
            h(v_p, v_p)(i, j) += f.t[i] * t_j + f.n[i] * n_j + f.c[i] * c_j;
            h(v_p, v_p1)(i, j) -= f.t[i] * bend_j + (k * f.n[i] + c * f.c[i]) * f.t[j];
        }
    }
}

/// Writes the second derivatives.
template <class S>
ANCF_NOINLINE void geodesic_hessian(const GeodesicFrame<S>& f, const S (&U)[invariant_count],
                                    const S (&D)[invariant_count][invariant_count],
                                    GeodesicHessian<S>& h) noexcept {
    S M[form_count][form_count];
    form_hessian(f, U, D, M);
    constexpr int forms = f_F + 1;  // those that see vectors
    Vec3<S> b[forms];               // on p
    Vec3<S> b1[forms];              // on p1: kap, chi, F
    const S n1 = 1.0 - f.n2;
    Vec3<S> F_g[2];
    for (int k = 0; k < 3; ++k) {
        b[f_lam][k] = f.t[k];
        b[f_kap][k] = -f.inv_lam * (f.kap * f.t[k] + f.eta * f.n[k]);
        b[f_chi][k] = -f.inv_lam * (f.chi * f.t[k] + f.eta * f.c[k]);
        b[f_th1][k] = f.from[0].sp[k];
        b[f_th2][k] = f.from[1].sp[k];
        b[f_F][k] = n1 * f.from[0].dF[t_p][k] + f.n2 * f.from[1].dF[t_p][k];
        b1[f_kap][k] = f.inv_lam * f.n[k];
        b1[f_chi][k] = f.inv_lam * f.c[k];
        b1[f_F][k] = n1 * f.from[0].dF[t_p1][k] + f.n2 * f.from[1].dF[t_p1][k];
        F_g[0][k] = n1 * f.from[0].dF[t_g][k];
        F_g[1][k] = f.n2 * f.from[1].dF[t_g][k];
    }
    // W[x][r] = sum_s M[r][s] b_s[x]: a form's row of M applied to the vector x
    Vec3<S> W[geodesic_count][form_count];
    for (int r = 0; r < form_count; ++r) {
        for (int k = 0; k < 3; ++k) {
            S sum = M[r][f_lam] * b[f_lam][k];
            for (int s = f_kap; s < forms; ++s) sum += M[r][s] * b[s][k];
            W[v_p][r][k] = sum;
            W[v_p1][r][k] =
                M[r][f_kap] * b1[f_kap][k] + M[r][f_chi] * b1[f_chi][k] + M[r][f_F] * b1[f_F][k];
            W[v_g1][r][k] = M[r][f_th1] * f.from[0].sg[k] + M[r][f_F] * F_g[0][k];
            W[v_g2][r][k] = M[r][f_th2] * f.from[1].sg[k] + M[r][f_F] * F_g[1][k];
        }
    }
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) {
            S sum = b[f_lam][i] * W[v_p][f_lam][j];
            for (int r = f_kap; r < forms; ++r) sum += b[r][i] * W[v_p][r][j];
            h(v_p, v_p)(i, j) = sum;
            h(v_p, v_p1)(i, j) = W[v_p][f_kap][i] * b1[f_kap][j] + W[v_p][f_chi][i] * b1[f_chi][j] +
                                 W[v_p][f_F][i] * b1[f_F][j];
            h(v_p1, v_p1)(i, j) = W[v_p1][f_kap][i] * b1[f_kap][j] +
                                  W[v_p1][f_chi][i] * b1[f_chi][j] + W[v_p1][f_F][i] * b1[f_F][j];
            for (int m = 0; m < 2; ++m) {
                const int x = v_g1 + m, th = f_th1 + m;
                h(v_p, x)(i, j) = W[v_p][th][i] * f.from[m].sg[j] + W[v_p][f_F][i] * F_g[m][j];
                h(v_p1, x)(i, j) = W[v_p1][th][i] * f.from[m].sg[j] + W[v_p1][f_F][i] * F_g[m][j];
                h(x, x)(i, j) = W[x][th][i] * f.from[m].sg[j] + W[x][f_F][i] * F_g[m][j];
            }
            h(v_g1, v_g2)(i, j) = W[v_g1][f_th2][i] * f.from[1].sg[j] + W[v_g1][f_F][i] * F_g[1][j];
        }
    }
    constexpr int form_of[GeodesicHessian<S>::scalars] = {f_th1, f_th2, f_angle1, f_angle2,
                                                          f_s,   f_s1,  f_q,      f_q1};
    for (int m = 0; m < GeodesicHessian<S>::scalars; ++m) {
        for (int x = 0; x < geodesic_count; ++x) h.coupling[x][m] = W[x][form_of[m]];
        for (int n = 0; n < GeodesicHessian<S>::scalars; ++n)
            h.scalar[m][n] = M[form_of[m]][form_of[n]];
    }
    add_line_curvature(f, U, h);
    const SpinWeights<S> w = spin_weights(f, U);
    for (int m = 0; m < 2; ++m) {
        Block<S> gp{}, gp1{};
        const int x = v_g1 + m;
        add_transport_hessian(f.from[m], f.g[m], f.p, f.p1, f.lam, f.t, w.F[m], w.spin[m], h(x, x),
                              gp, gp1, h(v_p, v_p), h(v_p, v_p1));
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 3; ++i) {
                h(v_p, x)(j, i) += gp(i, j);
                h(v_p1, x)(j, i) += gp1(i, j);
            }
        }
    }
}

/// The symmetric second variation of a nodal spin th, per unit weight, as blocks of (g, g), (g, a),
/// (a, a).
template <class S>
inline void add_nodal_spin(const NodalDirector<S>& f, const S& weight, Block<S>& gg, Block<S>& ga,
                           Block<S>& aa) noexcept {
    const S g2 = weight * f.inv_g * f.inv_g, a2 = weight * f.inv_nu * f.inv_nu,
            ag = weight * f.inv_g * f.inv_nu;
    const S g_tc = g2 * f.al, g_nc = -g2 * (f.al * f.al + 0.5);
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) {
            const S tc = f.t[i] * f.c[j] + f.c[i] * f.t[j], nc = f.n[i] * f.c[j] + f.c[i] * f.n[j];
            gg(i, j) += g_tc * tc + g_nc * nc;
            aa(i, j) -= a2 * nc;
            // rows g, columns a: A_t u_c: -1; A_n u_c and A_c u_n: al
            ga(i, j) += ag * (f.al * nc - f.c[i] * f.t[j]);
        }
    }
}

}  // namespace ancf::detail
