// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Shear sines evaluated at the stations: the variant of [Dufva2006, Table 1, footnote a].
///
/// s = a.p/(|a| |p|) and its derivative along x are functions of seven dot products of p, p1, a,
/// a1; first and second derivatives follow by the chain rule. Written for clarity: this element is
/// a reference.

#pragma once

#include <ancf/element/cross_section/nodal.hpp>
#include <ancf/element/station_data.hpp>
#include <ancf/element/vec3.hpp>

#include <cmath>
#include <complex>

namespace ancf {

namespace detail {

/// The dot products p.p, p.p1, a.a, a.a1, a.p, a1.p, a.p1.
enum DotIndex : int { z_pp, z_pv, z_aa, z_ab, z_ap, z_bp, z_av, dot_count };

/// Shear s = s(z) and rate s' = s'(z) of one director with first derivatives, and what seconds
/// need.
template <class S>
struct StationSine {
    S s, s1;
    S z[dot_count];
    S ds[dot_count], ds1[dot_count];
    S inv_p, inv_a, norm, rho;  ///< 1/p.p, 1/a.a, 1/(|a| |p|), a.a1/a.a + p.p1/p.p
    Vec3<S> x[4];               ///< p, p1, a, a1
};

template <class S>
inline void station_sine(const Vec3<S>& p, const Vec3<S>& p1, const Vec3<S>& a, const Vec3<S>& a1,
                         StationSine<S>& f) noexcept {
    using std::sqrt;
    f.x[0] = p, f.x[1] = p1, f.x[2] = a, f.x[3] = a1;
    f.z[z_pp] = dot(p, p), f.z[z_pv] = dot(p, p1), f.z[z_aa] = dot(a, a), f.z[z_ab] = dot(a, a1);
    f.z[z_ap] = dot(a, p), f.z[z_bp] = dot(a1, p), f.z[z_av] = dot(a, p1);
    f.inv_p = 1.0 / f.z[z_pp];
    f.inv_a = 1.0 / f.z[z_aa];
    f.norm = 1.0 / sqrt(f.z[z_pp] * f.z[z_aa]);
    f.rho = f.z[z_ab] * f.inv_a + f.z[z_pv] * f.inv_p;
    f.s = f.z[z_ap] * f.norm;
    f.s1 = (f.z[z_bp] + f.z[z_av]) * f.norm - f.s * f.rho;
    for (int k = 0; k < dot_count; ++k) f.ds[k] = f.ds1[k] = S(0.0);
    f.ds[z_ap] = f.norm;
    f.ds[z_pp] = -0.5 * f.s * f.inv_p;
    f.ds[z_aa] = -0.5 * f.s * f.inv_a;
    f.ds1[z_bp] = f.ds1[z_av] = f.norm;
    f.ds1[z_ap] = -f.norm * f.rho;
    f.ds1[z_ab] = -f.s * f.inv_a;
    f.ds1[z_pv] = -f.s * f.inv_p;
    f.ds1[z_pp] = (f.s * f.z[z_pv] * f.inv_p - 0.5 * f.s1) * f.inv_p;
    f.ds1[z_aa] = (f.s * f.z[z_ab] * f.inv_a - 0.5 * f.s1) * f.inv_a;
}

/// Writes the second derivatives of f_s s + f_s1 s' with respect to the dot products.
template <class S>
inline void station_sine_second(const StationSine<S>& f, const S& f_s, const S& f_s1,
                                S (&H)[dot_count][dot_count]) noexcept {
    for (auto& row : H) {
        for (S& entry : row) entry = S(0.0);
    }
    const S ip = f.inv_p, ia = f.inv_a, k = f.z[z_pv], m = f.z[z_ab], N = f.norm, s = f.s;
    H[z_pp][z_pp] = 0.75 * f_s * s * ip * ip + f_s1 * ip * ip * (0.75 * f.s1 - 3.0 * s * k * ip);
    H[z_aa][z_aa] = 0.75 * f_s * s * ia * ia + f_s1 * ia * ia * (0.75 * f.s1 - 3.0 * s * m * ia);
    H[z_pp][z_aa] = 0.25 * f_s * s * ip * ia + f_s1 * ip * ia * (0.25 * f.s1 - 0.5 * s * f.rho);
    H[z_pp][z_ap] = -0.5 * f_s * N * ip + f_s1 * N * ip * (0.5 * f.rho + k * ip);
    H[z_aa][z_ap] = -0.5 * f_s * N * ia + f_s1 * N * ia * (0.5 * f.rho + m * ia);
    H[z_pp][z_bp] = H[z_pp][z_av] = -0.5 * f_s1 * N * ip;
    H[z_aa][z_bp] = H[z_aa][z_av] = -0.5 * f_s1 * N * ia;
    H[z_ab][z_ap] = -f_s1 * N * ia;
    H[z_pv][z_ap] = -f_s1 * N * ip;
    H[z_pp][z_ab] = H[z_pv][z_aa] = 0.5 * f_s1 * s * ip * ia;
    H[z_aa][z_ab] = 1.5 * f_s1 * s * ia * ia;
    H[z_pp][z_pv] = 1.5 * f_s1 * s * ip * ip;
    for (int i = 0; i < dot_count; ++i) {
        for (int j = 0; j < i; ++j) H[i][j] = H[j][i] = H[i][j] + H[j][i];
    }
}

/// Writes the gradients of the dot products with respect to (p, p1, a, a1).
template <class S>
inline void dot_gradients(const StationSine<S>& f, Vec3<S> (&J)[dot_count][4]) noexcept {
    const Vec3<S> zero{{S(0.0), S(0.0), S(0.0)}};
    for (auto& row : J) {
        for (auto& entry : row) entry = zero;
    }
    const Vec3<S>&p = f.x[0], &p1 = f.x[1], &a = f.x[2], &a1 = f.x[3];
    J[z_pp][0] = 2.0 * p;
    J[z_pv][0] = p1, J[z_pv][1] = p;
    J[z_aa][2] = 2.0 * a;
    J[z_ab][2] = a1, J[z_ab][3] = a;
    J[z_ap][0] = a, J[z_ap][2] = p;
    J[z_bp][0] = a1, J[z_bp][3] = p;
    J[z_av][1] = a, J[z_av][2] = p1;
}

/// Writes the gradient of a function of the dot products given by its derivatives f.
template <class S>
inline void chain(const Vec3<S> (&J)[dot_count][4], const S (&f)[dot_count],
                  Vec3<S> (&g)[4]) noexcept {
    for (int x = 0; x < 4; ++x) {
        g[x] = f[0] * J[0][x];
        for (int k = 1; k < dot_count; ++k) add(g[x], f[k], J[k][x]);
    }
}

}  // namespace detail

/// Shear sines evaluated at each station from r_y(x), r_z(x) and t(x).
///
/// Does not take sections with a shear centre: the constant twist of an element would hold changes
/// of its shears. LinearShear has a remedy, docs/theory-references.md, "The shear centre".
struct PointwiseShear {
    static constexpr bool nodal = false;  ///< shears are not interpolated from nodes

    /// What is kept of a station.
    template <class S>
    struct Station {
        detail::StationSine<S> y;  ///< of r_y
        detail::StationSine<S> z;  ///< of r_z
    };

    /// Evaluates the shears of a station.
    template <class T, class S>
    static void shears(const StationShape<T>&, const S (&)[detail::shear_count],
                       const detail::LocalVectors<S>& x, Station<S>& f,
                       detail::Invariants<S>& w) noexcept {
        using namespace detail;
        station_sine(x[l_p], x[l_p1], x[l_a], x[l_a1], f.y);
        station_sine(x[l_p], x[l_p1], x[l_b], x[l_b1], f.z);
        w.s = f.y.s, w.s1 = f.y.s1, w.q = f.z.s, w.q1 = f.z.s1;
    }

    /// Carries dU/d(shears) to what they depend on.
    template <class T, class S>
    static void gradient(const StationShape<T>&, const Station<S>& f,
                         const S (&U)[detail::invariant_count],
                         detail::LocalGradient<S>& g) noexcept {
        using namespace detail;
        for (int director = 0; director < 2; ++director) {
            const StationSine<S>& sine = director == 0 ? f.y : f.z;
            Vec3<S> J[dot_count][4], sum[4];
            dot_gradients(sine, J);
            S weight[dot_count];
            for (int k = 0; k < dot_count; ++k) {
                weight[k] =
                    U[w_s + 2 * director] * sine.ds[k] + U[w_s1 + 2 * director] * sine.ds1[k];
            }
            chain(J, weight, sum);
            for (int x = 0; x < 4; ++x)
                g.vector[family(director, x)] = g.vector[family(director, x)] + sum[x];
        }
        for (S& shear : g.shear) shear = S(0.0);
    }

    /// Carries the second derivatives by the shears likewise.
    template <class S>
    static void hessian(const Station<S>& f, const S (&U)[detail::invariant_count],
                        detail::LocalHessian<S>& h) noexcept {
        using namespace detail;
        // L: gradients of (s, s', q, q'); Z = coupling + L^T D/2, so that the sum of Z (x) L +
        // L (x) Z is what D adds.
        Vec3<S> L[shear_count][local_count];
        for (auto& row : L) {
            for (auto& entry : row) entry = {{S(0.0), S(0.0), S(0.0)}};
        }
        for (int director = 0; director < 2; ++director) {
            const StationSine<S>& sine = director == 0 ? f.y : f.z;
            Vec3<S> J[dot_count][4], g[4];
            dot_gradients(sine, J);
            chain(J, sine.ds, g);
            for (int x = 0; x < 4; ++x) L[2 * director][family(director, x)] = g[x];
            chain(J, sine.ds1, g);
            for (int x = 0; x < 4; ++x) L[2 * director + 1][family(director, x)] = g[x];

            const S f_s = U[w_s + 2 * director], f_s1 = U[w_s1 + 2 * director];
            S H[dot_count][dot_count], weight[dot_count];
            station_sine_second(sine, f_s, f_s1, H);
            for (int k = 0; k < dot_count; ++k) weight[k] = f_s * sine.ds[k] + f_s1 * sine.ds1[k];
            const S identity[4][4] = {
                {2.0 * weight[z_pp], weight[z_pv], weight[z_ap], weight[z_bp]},
                {S(0.0), S(0.0), weight[z_av], S(0.0)},
                {S(0.0), S(0.0), 2.0 * weight[z_aa], weight[z_ab]},
                {S(0.0), S(0.0), S(0.0), S(0.0)}};
            Vec3<S> HJ[dot_count][4];
            for (int k = 0; k < dot_count; ++k) chain(J, H[k], HJ[k]);
            for (int x = 0; x < 4; ++x) {
                for (int y = x; y < 4; ++y) {
                    Block<S>& block = h(family(director, x), family(director, y));
                    for (int i = 0; i < 3; ++i) {
                        for (int j = 0; j < 3; ++j) {
                            for (int k = 0; k < dot_count; ++k)
                                block(i, j) += J[k][x][i] * HJ[k][y][j];
                        }
                        block(i, i) += identity[x][y];
                    }
                }
            }
        }
        Vec3<S> Z[shear_count][local_count];
        for (int m = 0; m < shear_count; ++m) {
            for (int x = 0; x < local_count; ++x) {
                Z[m][x] = h.coupling[m][x];
                for (int k = 0; k < shear_count; ++k) add(Z[m][x], S(0.5 * h.shear[k][m]), L[k][x]);
            }
        }
        for (int x = 0; x < local_count; ++x) {
            for (int y = x; y < local_count; ++y) {
                for (int i = 0; i < 3; ++i) {
                    for (int j = 0; j < 3; ++j) {
                        for (int m = 0; m < shear_count; ++m) {
                            h(x, y)(i, j) += Z[m][x][i] * L[m][y][j] + L[m][x][i] * Z[m][y][j];
                        }
                    }
                }
            }
        }
    }

private:
    /// Returns the place of (p, p1, a, a1) of a director among the local vectors.
    static constexpr int family(int director, int x) noexcept {
        return x < 2 ? x : x + 2 * director;
    }
};

}  // namespace ancf
