// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Second derivatives of a station's energy with respect to the local vectors, for projected
/// directors.
///
/// Components along the y director's frame (t, n, c) are used for p and a, those along the z
/// director's (t, m, d) for b; blocks that are not sparse are filled there and turned to the global
/// axes once, the others are sums of a few outer products. Every variation of a vector enters
/// divided by lam (p, p1) or by its own nu (a, b).

#pragma once

#include <ancf/element/cross_section/projected.hpp>

namespace ancf::detail {

/// Rows of T = D L for the frame components of the variations that invariants depend on.
template <class S>
struct ProjectedRows {
    S u[3][invariant_count];  ///< dp along t, n, c
    S v[2][invariant_count];  ///< dp1 along n, c
    S A[invariant_count];     ///< da along c, the part through th; the part through om is w_a D[om]
    S L_u[3][geometric_count];
    S v_n2, v_c2;      ///< of om2 along the components n, c of dp1
    S w_a[3], w_b[3];  ///< of om along da, of om2 along db
};

template <class S>
inline void projected_rows(const ProjectedFrames<S>& f, const Invariants<S>& w,
                           const InvariantHessian<S>& D, ProjectedRows<S>& r) noexcept {
    const DirectorFrame<S>&y = f.y, &z = f.z;
    const S om2_m = z.al * z.om - z.chi;
    S(&t)[geometric_count] = r.L_u[0];
    t[w_lam] = y.lam, t[w_kap] = -y.kap, t[w_chi] = -y.chi, t[w_om] = y.al * y.chi,
    t[w_om2] = z.al * z.chi;
    S(&n)[geometric_count] = r.L_u[1];
    n[w_kap] = -y.eta, n[w_om] = y.al * y.om - y.chi;
    n[w_om2] = w.C * om2_m - w.S_ * z.zeta, n[w_phi] = z.al * w.S_;
    S(&c)[geometric_count] = r.L_u[2];
    c[w_kap] = -y.al * y.chi, c[w_chi] = y.al * y.kap - y.eta, c[w_om] = y.zeta;
    c[w_om2] = w.S_ * om2_m + w.C * z.zeta, c[w_phi] = y.al - z.al * w.C;
    r.v_n2 = z.al * w.S_;
    r.v_c2 = -z.al * w.C;
    r.w_a[0] = -y.chi, r.w_a[1] = -y.om, r.w_a[2] = -y.mu;
    r.w_b[0] = -z.chi, r.w_b[1] = -z.om, r.w_b[2] = -z.mu;
    for (int k = 0; k < invariant_count; ++k) {
        const S &kap = D[w_kap][k], &chi = D[w_chi][k], &om = D[w_om][k], &om2 = D[w_om2][k],
                &phi = D[w_phi][k];
        r.u[0][k] = t[w_lam] * D[w_lam][k] + t[w_kap] * kap + t[w_chi] * chi + t[w_om] * om +
                    t[w_om2] * om2;
        r.u[1][k] = n[w_kap] * kap + n[w_om] * om + n[w_om2] * om2 + n[w_phi] * phi;
        r.u[2][k] =
            c[w_kap] * kap + c[w_chi] * chi + c[w_om] * om + c[w_om2] * om2 + c[w_phi] * phi;
        r.v[0][k] = kap + r.v_n2 * om2;
        r.v[1][k] = chi - y.al * om + r.v_c2 * om2;
        r.A[k] = y.chi * kap - y.kap * chi - phi;
    }
}

/// Writes M turned to global axes: sum_ij left_i M_ij right_j^T, left and right scaled frames.
template <class S>
inline void turn(const Vec3<S> (&left)[3], const S (&M)[3][3], const Vec3<S> (&right)[3],
                 Block<S>& out) noexcept {
    for (int k = 0; k < 3; ++k) {
        const S t = M[0][0] * right[0][k] + M[0][1] * right[1][k] + M[0][2] * right[2][k];
        const S n = M[1][0] * right[0][k] + M[1][1] * right[1][k] + M[1][2] * right[2][k];
        const S c = M[2][0] * right[0][k] + M[2][1] * right[1][k] + M[2][2] * right[2][k];
        for (int i = 0; i < 3; ++i) out(i, k) = left[0][i] * t + left[1][i] * n + left[2][i] * c;
    }
}

/// The scaled frames and the global vectors that the sparse blocks are made of.
template <class S>
struct ProjectedVectors {
    Vec3<S> P[3];    ///< (t, n, c)/lam
    Vec3<S> A[3];    ///< (t, n, c)/nu of the y director
    Vec3<S> B[3];    ///< (t, m, d)/nu of the z director
    Vec3<S> d;       ///< d/lam
    Vec3<S> wa, wb;  ///< derivatives of om with respect to a, of om2 with respect to b
};

template <class S>
inline void projected_vectors(const ProjectedFrames<S>& f, const ProjectedRows<S>& r,
                              ProjectedVectors<S>& g) noexcept {
    for (int k = 0; k < 3; ++k) {
        const S t = f.y.t[k], n = f.y.n[k], c = f.y.c[k];
        g.P[0][k] = f.y.inv_lam * t, g.P[1][k] = f.y.inv_lam * n, g.P[2][k] = f.y.inv_lam * c;
        g.A[0][k] = f.y.inv_nu * t, g.A[1][k] = f.y.inv_nu * n, g.A[2][k] = f.y.inv_nu * c;
        g.B[0][k] = f.z.inv_nu * t, g.B[1][k] = f.z.inv_nu * f.z.n[k],
        g.B[2][k] = f.z.inv_nu * f.z.c[k];
        g.d[k] = f.y.inv_lam * f.z.c[k];
        g.wa[k] = r.w_a[0] * g.A[0][k] + r.w_a[1] * g.A[1][k] + r.w_a[2] * g.A[2][k];
        g.wb[k] = r.w_b[0] * g.B[0][k] + r.w_b[1] * g.B[1][k] + r.w_b[2] * g.B[2][k];
    }
}

/// Writes the blocks that are full in their frames: (p, p), (p, p1), (p, a), (p, b), (a, a), (b,
/// b).
template <class S>
inline void projected_full_blocks(const Invariants<S>& w, const S& U_lam,
                                  const InvariantHessian<S>& D, const ProjectedRows<S>& r,
                                  const ProjectedVectors<S>& g, const DirectorFrame<S>& y,
                                  const DirectorHessian<S>& hy, const DirectorHessian<S>& hz,
                                  LocalHessian<S>& h) noexcept {
    const S &C = w.C, &Z = w.S_;
    S M[3][3];
    // (p, p): the z director's part is turned about t
    const S tn = hz.uu[0][1], tc = hz.uu[0][2], nn = hz.uu[1][1], nc = hz.uu[1][2],
            cc = hz.uu[2][2];
    const S CC = C * C, CZ = C * Z, ZZ = Z * Z;
    const S stretch = U_lam * y.lam;
    const S extra[3][3] = {
        {hy.uu[0][0] + hz.uu[0][0], hy.uu[0][1] + C * tn - Z * tc, hy.uu[0][2] + Z * tn + C * tc},
        {S(0.0), hy.uu[1][1] + stretch + CC * nn - 2.0 * CZ * nc + ZZ * cc,
         hy.uu[1][2] + CZ * (nn - cc) + (CC - ZZ) * nc},
        {S(0.0), S(0.0), hy.uu[2][2] + stretch + ZZ * nn + 2.0 * CZ * nc + CC * cc}};
    const S(&t)[geometric_count] = r.L_u[0];
    const S(&n)[geometric_count] = r.L_u[1];
    const S(&c)[geometric_count] = r.L_u[2];
    for (int i = 0; i < 3; ++i) {
        const S(&T)[invariant_count] = r.u[i];
        if (i == 0) {
            M[0][0] = extra[0][0] + t[w_lam] * T[w_lam] + t[w_kap] * T[w_kap] +
                      t[w_chi] * T[w_chi] + t[w_om] * T[w_om] + t[w_om2] * T[w_om2];
        }
        if (i <= 1) {
            M[i][1] = extra[i][1] + n[w_kap] * T[w_kap] + n[w_om] * T[w_om] + n[w_om2] * T[w_om2] +
                      n[w_phi] * T[w_phi];
        }
        M[i][2] = extra[i][2] + c[w_kap] * T[w_kap] + c[w_chi] * T[w_chi] + c[w_om] * T[w_om] +
                  c[w_om2] * T[w_om2] + c[w_phi] * T[w_phi];
    }
    M[1][0] = M[0][1], M[2][0] = M[0][2], M[2][1] = M[1][2];
    turn(g.P, M, g.P, h(l_p, l_p));

    // (p, p1): in the z director's frame (d, v_t) = (t, v_d) = w2, (d, v_m) = lower, (m, v_d) =
    // upper
    const S w2 = hz.B_al;
    const S lower = hz.vu[1][2], upper = hz.vu[2][1];
    for (int i = 0; i < 3; ++i) {
        const S(&T)[invariant_count] = r.u[i];
        M[i][0] = hy.vu[0][i];
        M[i][1] = hy.vu[1][i] + T[w_kap] + r.v_n2 * T[w_om2];
        M[i][2] = hy.vu[2][i] + T[w_chi] - y.al * T[w_om] + r.v_c2 * T[w_om2];
    }
    M[1][0] -= Z * w2, M[2][0] += C * w2, M[0][1] -= Z * w2, M[0][2] += C * w2;
    M[1][1] -= CZ * (lower + upper), M[1][2] += CC * upper - ZZ * lower;
    M[2][1] += CC * lower - ZZ * upper, M[2][2] += CZ * (lower + upper);
    turn(g.P, M, g.P, h(l_p, l_p1));

    // (p, a)
    for (int i = 0; i < 3; ++i) {
        const S(&T)[invariant_count] = r.u[i];
        for (int j = 0; j < 3; ++j) M[i][j] = hy.Au[j][i] + T[w_om] * r.w_a[j];
        M[i][2] += y.chi * T[w_kap] - y.kap * T[w_chi] - T[w_phi];
    }
    turn(g.P, M, g.A, h(l_p, l_a));

    // (p, b)
    for (int j = 0; j < 3; ++j) {
        M[0][j] = hz.Au[j][0] + r.u[0][w_om2] * r.w_b[j];
        M[1][j] = C * hz.Au[j][1] - Z * hz.Au[j][2] + r.u[1][w_om2] * r.w_b[j];
        M[2][j] = Z * hz.Au[j][1] + C * hz.Au[j][2] + r.u[2][w_om2] * r.w_b[j];
    }
    for (int i = 0; i < 3; ++i) M[i][2] += r.u[i][w_phi];
    turn(g.P, M, g.B, h(l_p, l_b));

    // (a, a), (b, b)
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) M[i][j] = hy.AA[i][j] + D[w_om][w_om] * r.w_a[i] * r.w_a[j];
        M[i][2] += r.A[w_om] * r.w_a[i];
    }
    for (int j = 0; j < 3; ++j) M[2][j] += r.A[w_om] * r.w_a[j];
    M[2][2] += y.chi * r.A[w_kap] - y.kap * r.A[w_chi] - r.A[w_phi];
    turn(g.A, M, g.A, h(l_a, l_a));
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) M[i][j] = hz.AA[i][j] + D[w_om2][w_om2] * r.w_b[i] * r.w_b[j];
        M[i][2] += D[w_om2][w_phi] * r.w_b[i];
    }
    for (int j = 0; j < 3; ++j) M[2][j] += D[w_om2][w_phi] * r.w_b[j];
    M[2][2] += D[w_phi][w_phi];
    turn(g.B, M, g.B, h(l_b, l_b));
}

/// Writes the blocks that are sums of a few outer products, and the couplings with the shears.
template <class S>
inline void projected_sparse_blocks(const Invariants<S>& w, const InvariantHessian<S>& D,
                                    const ProjectedRows<S>& r, const ProjectedVectors<S>& g,
                                    const DirectorFrame<S>& y, const DirectorHessian<S>& hy,
                                    const DirectorHessian<S>& hz, LocalHessian<S>& h) noexcept {
    const S &C = w.C, &Z = w.S_;
    const S &D_oo = D[w_om][w_om], &D_o2 = D[w_om][w_om2], &D_op = D[w_om][w_phi];
    const S &D_22 = D[w_om2][w_om2], &D_2p = D[w_om2][w_phi];
    // rows n and c of (p1, p1), (p1, a) and (p1, b) in the frames of the columns
    const S vnn = r.v[0][w_kap] + r.v_n2 * r.v[0][w_om2];
    const S vnc = r.v[0][w_chi] - y.al * r.v[0][w_om] + r.v_c2 * r.v[0][w_om2];
    const S vcc = r.v[1][w_chi] - y.al * r.v[1][w_om] + r.v_c2 * r.v[1][w_om2];
    S va[2][3], vb[2][3];
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 3; ++j) {
            va[i][j] = r.v[i][w_om] * r.w_a[j];
            vb[i][j] = r.v[i][w_om2] * r.w_b[j];
        }
        va[i][2] += y.chi * r.v[i][w_kap] - y.kap * r.v[i][w_chi] - r.v[i][w_phi];
        vb[i][2] += r.v[i][w_phi];
    }
    va[0][2] += hy.vA_nc, va[1][0] += hy.vA_ct, va[1][1] += hy.vA_cn, va[1][2] += hy.vA_cc;
    vb[0][0] -= Z * hz.vA_ct, vb[0][1] -= Z * hz.vA_cn, vb[0][2] += C * hz.vA_nc;
    vb[1][0] += C * hz.vA_ct, vb[1][1] += C * hz.vA_cn, vb[1][2] += Z * hz.vA_nc;

    Vec3<S> p_a1, p_b1, y_skew, z_skew, vn, vc, van, vac, vbn, vbc, v_a1, v_b1, a_a1, a_b, a_b1,
        c_b, b_b1;
    for (int k = 0; k < 3; ++k) {
        const S Pt = g.P[0][k], Pn = g.P[1][k], Pc = g.P[2][k];
        const S At = g.A[0][k], An = g.A[1][k], Ac = g.A[2][k];
        const S Bt = g.B[0][k], Bn = g.B[1][k], Bc = g.B[2][k];
        // (p, a1) = p_a1 Ac^T + Pc y_skew^T, (p, b1) = p_b1 Bc^T + d z_skew^T
        p_a1[k] = r.u[0][w_om] * Pt + (r.u[1][w_om] + hy.B_al) * Pn + r.u[2][w_om] * Pc;
        p_b1[k] = r.u[0][w_om2] * Pt + (r.u[1][w_om2] + C * hz.B_al) * Pn +
                  (r.u[2][w_om2] + Z * hz.B_al) * Pc;
        y_skew[k] = hy.B_al * An - hy.B_o * At;
        z_skew[k] = hz.B_al * Bn - hz.B_o * Bt;
        vn[k] = vnn * Pn + vnc * Pc;
        vc[k] = vnc * Pn + vcc * Pc;
        van[k] = va[0][0] * At + va[0][1] * An + va[0][2] * Ac;
        vac[k] = va[1][0] * At + va[1][1] * An + va[1][2] * Ac;
        vbn[k] = vb[0][0] * Bt + vb[0][1] * Bn + vb[0][2] * Bc;
        vbc[k] = vb[1][0] * Bt + vb[1][1] * Bn + vb[1][2] * Bc;
        v_a1[k] = r.v[0][w_om] * Pn + r.v[1][w_om] * Pc;
        v_b1[k] = r.v[0][w_om2] * Pn + r.v[1][w_om2] * Pc;
        a_a1[k] = D_oo * g.wa[k] + r.A[w_om] * Ac - hy.B_o * An;
        a_b[k] = D_o2 * g.wb[k] + D_op * Bc;
        c_b[k] = r.A[w_om2] * g.wb[k] + r.A[w_phi] * Bc;
        a_b1[k] = D_o2 * g.wa[k] + r.A[w_om2] * Ac;
        b_b1[k] = D_22 * g.wb[k] + D_2p * Bc - hz.B_o * Bn;
        for (int m = 0; m < shear_count; ++m) {
            const int j = w_s + m;
            h.coupling[m][l_p][k] = r.u[0][j] * Pt + r.u[1][j] * Pn + r.u[2][j] * Pc;
            h.coupling[m][l_p1][k] = r.v[0][j] * Pn + r.v[1][j] * Pc;
            h.coupling[m][l_a][k] = D[w_om][j] * g.wa[k] + r.A[j] * Ac;
            h.coupling[m][l_a1][k] = D[w_om][j] * Ac;
            h.coupling[m][l_b][k] = D[w_om2][j] * g.wb[k] + D[w_phi][j] * Bc;
            h.coupling[m][l_b1][k] = D[w_om2][j] * Bc;
        }
    }
    for (int j = 0; j < 3; ++j) {
        const S Ac_j = g.A[2][j], Bc_j = g.B[2][j], An_j = hy.B_o * g.A[1][j],
                Bn_j = hz.B_o * g.B[1][j];
        for (int i = 0; i < 3; ++i) {
            const S Ac = g.A[2][i], Bc = g.B[2][i];
            h(l_p, l_a1)(i, j) = p_a1[i] * Ac_j + g.P[2][i] * y_skew[j];
            h(l_p, l_b1)(i, j) = p_b1[i] * Bc_j + g.d[i] * z_skew[j];
            h(l_p1, l_p1)(i, j) = g.P[1][i] * vn[j] + g.P[2][i] * vc[j];
            h(l_p1, l_a)(i, j) = g.P[1][i] * van[j] + g.P[2][i] * vac[j];
            h(l_p1, l_b)(i, j) = g.P[1][i] * vbn[j] + g.P[2][i] * vbc[j];
            h(l_p1, l_a1)(i, j) = v_a1[i] * Ac_j;
            h(l_p1, l_b1)(i, j) = v_b1[i] * Bc_j;
            h(l_a, l_a1)(i, j) = a_a1[i] * Ac_j - Ac * An_j;
            h(l_a, l_b)(i, j) = g.wa[i] * a_b[j] + Ac * c_b[j];
            h(l_a, l_b1)(i, j) = a_b1[i] * Bc_j;
            h(l_a1, l_a1)(i, j) = D_oo * Ac * Ac_j;
            h(l_a1, l_b)(i, j) = Ac * a_b[j];
            h(l_a1, l_b1)(i, j) = D_o2 * Ac * Bc_j;
            h(l_b, l_b1)(i, j) = b_b1[i] * Bc_j - Bc * Bn_j;
            h(l_b1, l_b1)(i, j) = D_22 * Bc * Bc_j;
        }
    }
    for (int i = 0; i < shear_count; ++i) {
        for (int j = 0; j < shear_count; ++j) h.shear[i][j] = D[w_s + i][w_s + j];
    }
}

/// Writes L^T D L + the second derivatives of the invariants weighted by U, and the couplings with
/// the shears.
template <class S>
void projected_hessian(const ProjectedFrames<S>& f, const Invariants<S>& w,
                       const S (&U)[invariant_count], const InvariantHessian<S>& D,
                       LocalHessian<S>& h) noexcept {
    DirectorHessian<S> hy, hz;
    director_hessian(f.y, U[w_kap], U[w_chi], U[w_om], S(-U[w_phi]), hy);
    director_hessian(f.z, S(0.0), S(0.0), U[w_om2], U[w_phi], hz);
    ProjectedRows<S> rows;
    projected_rows(f, w, D, rows);
    ProjectedVectors<S> vectors;
    projected_vectors(f, rows, vectors);
    projected_full_blocks(w, U[w_lam], D, rows, vectors, f.y, hy, hz, h);
    projected_sparse_blocks(w, D, rows, vectors, f.y, hy, hz, h);
}

}  // namespace ancf::detail
