// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Directors carried along the tangent.
///
/// Each node's director n_i = unit(P a_i) is carried by the smallest rotation from the node's
/// tangent to the station's; between the two carried directors the angle takes its course
/// (angle_course.hpp):
///
///     n(xi) = cos(psi) N_i + sin(psi) t x N_i,    phi the angle from N_i to N_j about t.
///
/// The z director does the same with its own angle, phi and what the nodes' angles from the y to
/// the z director differ by. Derivation: docs/theory-directors.md, "The angle between carried
/// directors".

#pragma once

#include <ancf/element/angle_course.hpp>
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

/// Vectors of a station.
enum CarriedIndex : int { v_p, v_p1, v_g1, v_g2, carried_count };

/// Courses of the angles of the y and the z director; n2 and n2_x say all of linear ones.
template <class S, class Angle>
struct AngleCourses {
    AngleCourse<S> y, z;
    S difference;  ///< of the twist rates that carrying adds, second node less first
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
        f.difference = further;
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
/// the spins at both nodes, the twist rates that carrying adds (with a linear angle their mean is
/// enough, and stands first), the two angles, and the four shears.
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

template <class S>
inline Shares<S> shares(const CarriedFrame<S, LinearAngle>& f) noexcept {
    return {f.n2, f.n2, f.n2_x, f.n2_x};
}

template <class S>
inline Shares<S> shares(const CarriedFrame<S, ChordAngle>& f) noexcept {
    return {f.y.share, f.z.share, f.y.share_x + f.y.bend * f.difference,
            f.z.share_x + f.z.bend * f.difference};
}

/// Turns weights of the invariants' variations into weights of the forms.
template <class S, class Angle>
inline void weigh_forms(const CarriedFrame<S, Angle>& f, const S (&X)[invariant_count],
                        S (&form)[form_count<Angle>]) noexcept {
    const Shares<S> share = shares(f);
    const S turning = f.chi * X[w_kap] - f.kap * X[w_chi];
    S difference, angle;  // of the spins, of the angles, second node less first
    if constexpr (Angle::linear) {
        const S twisting = X[w_om] + X[w_om2];
        difference = share.y * turning + share.rate_y * twisting;
        angle = share.y * X[w_phi] + share.rate_y * X[w_om2];
        form[f_F1] = twisting;
    } else {
        angle = share.z * X[w_phi] + share.rate_z * X[w_om2];
        difference = share.y * (turning - X[w_phi]) + share.rate_y * X[w_om] + angle;
        form[f_F2] = share.y * X[w_om] + share.z * X[w_om2];
        form[f_F1] = X[w_om] + X[w_om2] - form[f_F2];
    }
    form[f_lam] = X[w_lam];
    form[f_kap] = X[w_kap];
    form[f_chi] = X[w_chi];
    form[f_th1] = turning - difference;
    form[f_th2] = difference;
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
    const S of_z = U[w_phi] * f.z.bend + U[w_om2] * (f.z.change * f.difference + f.z.bend_x);
    const S of_y =
        (turning - U[w_phi]) * f.y.bend + U[w_om] * (f.y.change * f.difference + f.y.bend_x);
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
                         const S (&D)[invariant_count][invariant_count],
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
                                   const S (&D)[invariant_count][invariant_count],
                                   CarriedHessian<S>& h) noexcept {
    constexpr int count = form_count<Angle>;
    S M[count][count];
    form_hessian(f, U, D, M);
    constexpr int forms = f_F1 + 1;  // those that see vectors, but for F2
    constexpr bool two_rates = !Angle::linear;
    constexpr int F_of[2] = {f_F1, two_rates ? f_F2 : f_F1};  // of each node
    S F_share[2] = {1.0 - f.n2, f.n2};
    if constexpr (two_rates) F_share[0] = F_share[1] = S(1.0);
    Vec3<S> b[count];   // on p
    Vec3<S> b1[count];  // on p1: kap, chi, F
    Vec3<S> F_g[2];
    for (int k = 0; k < 3; ++k) {
        b[f_lam][k] = f.t[k];
        b[f_kap][k] = -f.inv_lam * (f.kap * f.t[k] + f.eta * f.n[k]);
        b[f_chi][k] = -f.inv_lam * (f.chi * f.t[k] + f.eta * f.c[k]);
        b[f_th1][k] = f.from[0].sp[k];
        b[f_th2][k] = f.from[1].sp[k];
        b[f_F1][k] = F_share[0] * f.from[0].dF[t_p][k];
        b1[f_F1][k] = F_share[0] * f.from[0].dF[t_p1][k];
        if constexpr (two_rates) {
            b[f_F2][k] = f.from[1].dF[t_p][k];
            b1[f_F2][k] = f.from[1].dF[t_p1][k];
        } else {
            b[f_F1][k] += F_share[1] * f.from[1].dF[t_p][k];
            b1[f_F1][k] += F_share[1] * f.from[1].dF[t_p1][k];
        }
        b1[f_kap][k] = f.inv_lam * f.n[k];
        b1[f_chi][k] = f.inv_lam * f.c[k];
        for (int m = 0; m < 2; ++m) F_g[m][k] = F_share[m] * f.from[m].dF[t_g][k];
    }
    // W[x][r] = sum_s M[r][s] b_s[x]: a form's row of M applied to the vector x
    Vec3<S> W[carried_count][count];
    for (int r = 0; r < count; ++r) {
        for (int k = 0; k < 3; ++k) {
            S sum = M[r][f_lam] * b[f_lam][k];
            for (int s = f_kap; s < forms; ++s) sum += M[r][s] * b[s][k];
            S sum1 =
                M[r][f_kap] * b1[f_kap][k] + M[r][f_chi] * b1[f_chi][k] + M[r][f_F1] * b1[f_F1][k];
            if constexpr (two_rates) {
                sum += M[r][f_F2] * b[f_F2][k];
                sum1 += M[r][f_F2] * b1[f_F2][k];
            }
            W[v_p][r][k] = sum;
            W[v_p1][r][k] = sum1;
            for (int m = 0; m < 2; ++m)
                W[v_g1 + m][r][k] = M[r][f_th1 + m] * f.from[m].sg[k] + M[r][F_of[m]] * F_g[m][k];
        }
    }
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) {
            S sum = b[f_lam][i] * W[v_p][f_lam][j];
            for (int r = f_kap; r < forms; ++r) sum += b[r][i] * W[v_p][r][j];
            S mixed = W[v_p][f_kap][i] * b1[f_kap][j] + W[v_p][f_chi][i] * b1[f_chi][j] +
                      W[v_p][f_F1][i] * b1[f_F1][j];
            S sum1 = W[v_p1][f_kap][i] * b1[f_kap][j] + W[v_p1][f_chi][i] * b1[f_chi][j] +
                     W[v_p1][f_F1][i] * b1[f_F1][j];
            if constexpr (two_rates) {
                sum += b[f_F2][i] * W[v_p][f_F2][j];
                mixed += W[v_p][f_F2][i] * b1[f_F2][j];
                sum1 += W[v_p1][f_F2][i] * b1[f_F2][j];
            }
            h(v_p, v_p)(i, j) = sum;
            h(v_p, v_p1)(i, j) = mixed;
            h(v_p1, v_p1)(i, j) = sum1;
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
