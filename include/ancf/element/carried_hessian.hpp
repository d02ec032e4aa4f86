// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Second derivatives of a station whose directors are carried: docs/theory-directors.md, "Second
/// variation".

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/carried.hpp>
#include <ancf/element/invariants.hpp>
#include <ancf/element/transport.hpp>
#include <ancf/element/vec3.hpp>

namespace ancf::detail {

/// Second derivatives at a station. Scalars: the forms of SpinIndex, then s, s', q, q'.
template <class S>
struct CarriedHessian {
    static constexpr int scalars = spin_count + 4;
    Block<S> block[10];  ///< upper triangle, column by column; diagonal blocks filled
    Vec3<S> coupling[carried_count][scalars];
    S scalar[scalars][scalars];  ///< symmetric, filled

    Block<S>& operator()(int i, int j) noexcept { return block[j * (j + 1) / 2 + i]; }
    const Block<S>& operator()(int i, int j) const noexcept { return block[j * (j + 1) / 2 + i]; }
};

/// Adds the products of forms that come of the courses' own second derivatives.
template <class S>
inline void add_course_curvature(const CarriedFrame<S, ChordAngle>& f,
                                 const S (&U)[invariant_count],
                                 S (&M)[form_count<ChordAngle>][form_count<ChordAngle>]) noexcept {
    // of differences between the nodes: their squares, or twice their products
    const auto add = [&M](int i1, int i2, int j1, int j2, const S& weight) {
        M[i1][j1] += weight, M[i2][j2] += weight;
        M[i1][j2] -= weight, M[i2][j1] -= weight;
    };
    const auto add_both = [&](int i1, int i2, int j1, int j2, const S& weight) {
        add(i1, i2, j1, j2, weight);
        add(j1, j2, i1, i2, weight);
    };
    const S turning = f.chi * U[w_kap] - f.kap * U[w_chi];
    const S of_z = U[w_phi] * f.z.bend + U[w_om2] * (f.z.change * f.further + f.z.bend_x);
    const S of_y =
        (turning - U[w_phi]) * f.y.bend + U[w_om] * (f.y.change * f.further + f.y.bend_x);
    const S rates_z = U[w_om2] * f.z.bend, rates_y = U[w_om] * f.y.bend;
    add(f_th1, f_th2, f_th1, f_th2, of_y + of_z);
    add(f_angle1, f_angle2, f_angle1, f_angle2, of_z);
    add_both(f_th1, f_th2, f_angle1, f_angle2, of_z);
    add_both(f_th1, f_th2, f_F1, f_F2, rates_y + rates_z);
    add_both(f_angle1, f_angle2, f_F1, f_F2, rates_z);
}

/// Writes M, the Hessian with respect to the forms: T^T D T with dw = T (forms), and the terms of
/// the second variation that are products of forms with the spin.
template <class S, class Angle>
inline void form_hessian(const CarriedFrame<S, Angle>& f, const S (&U)[invariant_count],
                         const InvariantHessian<S>& D,
                         S (&M)[form_count<Angle>][form_count<Angle>]) noexcept {
    constexpr int count = form_count<Angle>;
    S half[count][invariant_count];  // T^T D
    for (int j = 0; j < invariant_count; ++j) {
        S column[invariant_count], form[count];
        for (int i = 0; i < invariant_count; ++i) column[i] = D[i][j];
        weigh_forms(f, column, form);
        for (int i = 0; i < count; ++i) half[i][j] = form[i];
    }
    for (int i = 0; i < count; ++i) weigh_forms(f, half[i], M[i]);
    const S share = shares(f).y;
    const S spin[2] = {1.0 - share, share};
    const S twice = f.kap * U[w_kap] + f.chi * U[w_chi];
    for (int i = 0; i < 2; ++i) {
        M[f_th1 + i][f_chi] += spin[i] * U[w_kap];
        M[f_chi][f_th1 + i] += spin[i] * U[w_kap];
        M[f_th1 + i][f_kap] -= spin[i] * U[w_chi];
        M[f_kap][f_th1 + i] -= spin[i] * U[w_chi];
        for (int j = 0; j < 2; ++j) M[f_th1 + i][f_th1 + j] -= spin[i] * spin[j] * twice;
    }
    if constexpr (!Angle::linear) add_course_curvature(f, U, M);
}

/// Adds the second variation of lam, kap and chi at fixed spin to the blocks of p and p1.
template <class S, class Angle>
inline void add_line_curvature(const CarriedFrame<S, Angle>& f, const S (&U)[invariant_count],
                               CarriedHessian<S>& h) noexcept {
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
template <class S, class Angle>
ANCF_NOINLINE void carried_hessian(const CarriedFrame<S, Angle>& f, const S (&U)[invariant_count],
                                   const InvariantHessian<S>& D, CarriedHessian<S>& h) noexcept {
    constexpr int count = form_count<Angle>;
    S M[count][count];
    form_hessian(f, U, D, M);
    constexpr bool two_rates = !Angle::linear;
    constexpr int F_of[2] = {f_F1, two_rates ? f_F2 : f_F1};  // of each node
    // the forms that see p, and those that see p1
    constexpr int on_p[] = {f_lam, f_kap, f_chi, f_th1, f_th2, f_F1, F_of[1]};
    constexpr int on_p1[] = {f_kap, f_chi, f_F1, F_of[1]};
    constexpr int count_p = two_rates ? 7 : 6, count_p1 = two_rates ? 4 : 3;
    S F_share[2] = {1.0 - f.n2, f.n2};
    if constexpr (two_rates) F_share[0] = F_share[1] = S(1.0);
    Vec3<S> b[count];   // of each form on p
    Vec3<S> b1[count];  // on p1
    Vec3<S> F_g[2];
    for (int k = 0; k < 3; ++k) {
        b[f_lam][k] = f.t[k];
        b[f_kap][k] = -f.inv_lam * (f.kap * f.t[k] + f.eta * f.n[k]);
        b[f_chi][k] = -f.inv_lam * (f.chi * f.t[k] + f.eta * f.c[k]);
        b[f_th1][k] = f.from[0].sp[k];
        b[f_th2][k] = f.from[1].sp[k];
        b1[f_kap][k] = f.inv_lam * f.n[k];
        b1[f_chi][k] = f.inv_lam * f.c[k];
        b[F_of[1]][k] = F_share[1] * f.from[1].dF[t_p][k];
        b1[F_of[1]][k] = F_share[1] * f.from[1].dF[t_p1][k];
        const S first = F_share[0] * f.from[0].dF[t_p][k];
        const S first1 = F_share[0] * f.from[0].dF[t_p1][k];
        b[f_F1][k] = two_rates ? first : first + b[f_F1][k];
        b1[f_F1][k] = two_rates ? first1 : first1 + b1[f_F1][k];
        for (int m = 0; m < 2; ++m) F_g[m][k] = F_share[m] * f.from[m].dF[t_g][k];
    }
    // W[x][r] = sum_s M[r][s] b_s[x]: a form's row of M applied to the vector x
    Vec3<S> W[carried_count][count];
    for (int r = 0; r < count; ++r) {
        for (int k = 0; k < 3; ++k) {
            S sum = M[r][on_p[0]] * b[on_p[0]][k];
            for (int s = 1; s < count_p; ++s) sum += M[r][on_p[s]] * b[on_p[s]][k];
            W[v_p][r][k] = sum;
            sum = M[r][on_p1[0]] * b1[on_p1[0]][k];
            for (int s = 1; s < count_p1; ++s) sum += M[r][on_p1[s]] * b1[on_p1[s]][k];
            W[v_p1][r][k] = sum;
            for (int m = 0; m < 2; ++m)
                W[v_g1 + m][r][k] = M[r][f_th1 + m] * f.from[m].sg[k] + M[r][F_of[m]] * F_g[m][k];
        }
    }
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) {
            S sum = b[on_p[0]][i] * W[v_p][on_p[0]][j];
            for (int s = 1; s < count_p; ++s) sum += b[on_p[s]][i] * W[v_p][on_p[s]][j];
            h(v_p, v_p)(i, j) = sum;
            S mixed = W[v_p][on_p1[0]][i] * b1[on_p1[0]][j];
            sum = W[v_p1][on_p1[0]][i] * b1[on_p1[0]][j];
            for (int s = 1; s < count_p1; ++s) {
                mixed += W[v_p][on_p1[s]][i] * b1[on_p1[s]][j];
                sum += W[v_p1][on_p1[s]][i] * b1[on_p1[s]][j];
            }
            h(v_p, v_p1)(i, j) = mixed;
            h(v_p1, v_p1)(i, j) = sum;
            for (int m = 0; m < 2; ++m) {
                const int x = v_g1 + m, th = f_th1 + m, F = F_of[m];
                h(v_p, x)(i, j) = W[v_p][th][i] * f.from[m].sg[j] + W[v_p][F][i] * F_g[m][j];
                h(v_p1, x)(i, j) = W[v_p1][th][i] * f.from[m].sg[j] + W[v_p1][F][i] * F_g[m][j];
                h(x, x)(i, j) = W[x][th][i] * f.from[m].sg[j] + W[x][F][i] * F_g[m][j];
            }
            h(v_g1, v_g2)(i, j) =
                W[v_g1][f_th2][i] * f.from[1].sg[j] + W[v_g1][F_of[1]][i] * F_g[1][j];
        }
    }
    constexpr int form_of[CarriedHessian<S>::scalars] = {f_th1, f_th2, f_angle1, f_angle2,
                                                         f_s,   f_s1,  f_q,      f_q1};
    for (int m = 0; m < CarriedHessian<S>::scalars; ++m) {
        for (int x = 0; x < carried_count; ++x) h.coupling[x][m] = W[x][form_of[m]];
        for (int n = 0; n < CarriedHessian<S>::scalars; ++n)
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
