// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The smallest rotation that carries a node's tangent into the tangent of a station.
///
/// A director that is carried along turns about the tangent by less than the frame it came from:
/// the turn is the area of a triangle on the sphere of tangents. Two quantities tell all of it,
///
///     twist rate   F = -[g, p, p1]/B,                     B = |p| (|p| |g| + g.p),
///     added spin   sigma = -(g x p).(dg/|g| + dp/|p|)/E,  E = |p| |g| + g.p,
///
/// with g the node's tangent vector r_x, p = r0' and p1 = r0'' at the station. Both are singular
/// only where the tangent turns by 180 degrees between node and station. Derivation:
/// docs/theory-directors.md, "Carrying a director along".

#pragma once

#include <ancf/element/vec3.hpp>

#include <cmath>
#include <complex>

namespace ancf::detail {

/// Places of the vectors that a transport depends on.
enum TransportIndex : int { t_g, t_p, t_p1, transport_count };

/// Twist rate and added spin of one node at one station, with first derivatives.
template <class S>
struct Transport {
    S F;                          ///< twist rate of the carried director, 1/m
    Vec3<S> dF[transport_count];  ///< its gradient
    Vec3<S> sg, sp;               ///< sigma = sg.dg + sp.dp
    S inv_E, inv_B, mu, inv_mu;   ///< 1/E, 1/B, |g|, 1/|g|
    Vec3<S> B_g, B_p;             ///< gradient of B
    Vec3<S> E_g, E_p;             ///< gradient of E
    Vec3<S> across;               ///< g x p
};

/// Returns the transport from a node of tangent vector g to a station (p, p1).
/// @param lam,t  |p| and p/|p|
template <class S>
inline Transport<S> transport(const Vec3<S>& g, const Vec3<S>& p, const Vec3<S>& p1, const S& lam,
                              const Vec3<S>& t) noexcept {
    using std::sqrt;
    Transport<S> f;
    f.mu = sqrt(dot(g, g));
    f.inv_mu = 1.0 / f.mu;
    const S along = dot(g, p);
    f.inv_E = 1.0 / (lam * f.mu + along);
    f.inv_B = f.inv_E / lam;
    f.across = cross(g, p);
    f.F = -f.inv_B * dot(f.across, p1);
    const Vec3<S> p_p1 = cross(p, p1), p1_g = cross(p1, g);
    for (int k = 0; k < 3; ++k) {
        f.E_g[k] = lam * f.inv_mu * g[k] + p[k];
        f.E_p[k] = f.mu * t[k] + g[k];
        f.B_g[k] = lam * f.E_g[k];
        f.B_p[k] = 2.0 * f.mu * p[k] + lam * g[k] + along * t[k];
        f.dF[t_g][k] = -f.inv_B * (p_p1[k] + f.F * f.B_g[k]);
        f.dF[t_p][k] = -f.inv_B * (p1_g[k] + f.F * f.B_p[k]);
        f.dF[t_p1][k] = -f.inv_B * f.across[k];
        f.sg[k] = -f.inv_E * f.inv_mu * f.across[k];
        f.sp[k] = -f.inv_B * f.across[k];
    }
    return f;
}

/// Adds the symmetric part of U_F F'' + U_s sigma' to the blocks (g, g), (g, p), (g, p1), (p, p)
/// and (p, p1).
///
/// The skew part of sigma' is that of the frame's spin and cancels there.
template <class S>
inline void add_transport_hessian(const Transport<S>& f, const Vec3<S>& g, const Vec3<S>& p,
                                  const Vec3<S>& p1, const S& lam, const Vec3<S>& t, const S& U_F,
                                  const S& U_s, Block<S>& gg, Block<S>& gp, Block<S>& gp1,
                                  Block<S>& pp, Block<S>& pp1) noexcept {
    // F_ab = -(T_ab + F B_ab + F_a B_b + B_a F_b)/B with T = [g, p, p1]
    const S c = -U_F * f.inv_B, cF = c * f.F;
    const S inv_lam = 1.0 / lam, along = dot(g, p);
    // sigma' = d(-a/h)/dx with a = g x p, h_g = E |g|, h_p = E |p|
    const S sgg = U_s * f.inv_E * f.inv_E * f.inv_mu, spp = U_s * f.inv_E * f.inv_E * inv_lam;
    const S skew_g = 0.5 * U_s * f.inv_E * f.inv_mu, skew_p = 0.5 * U_s * f.inv_E * inv_lam;
    const S B_gg = cF * lam * lam * f.inv_mu;  // of I - tau tau^T
    const Vec3<S> tau = f.inv_mu * g;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) {
            const S delta(i == j ? 1.0 : 0.0);
            const S symmetric_g = f.across[i] * (f.E_g[j] + f.inv_mu / f.inv_E * tau[j]) +
                                  f.across[j] * (f.E_g[i] + f.inv_mu / f.inv_E * tau[i]);
            const S symmetric_p = f.across[i] * (f.E_p[j] + inv_lam / f.inv_E * t[j]) +
                                  f.across[j] * (f.E_p[i] + inv_lam / f.inv_E * t[i]);
            gg(i, j) += B_gg * (delta - tau[i] * tau[j]) +
                        c * (f.dF[t_g][i] * f.B_g[j] + f.B_g[i] * f.dF[t_g][j]) +
                        0.5 * sgg * symmetric_g;
            pp(i, j) += cF * ((2.0 * f.mu + along * inv_lam) * delta + t[i] * g[j] + g[i] * t[j] -
                              along * inv_lam * t[i] * t[j]) +
                        c * (f.dF[t_p][i] * f.B_p[j] + f.B_p[i] * f.dF[t_p][j]) +
                        0.5 * spp * symmetric_p;
            gp(i, j) += cF * (2.0 * tau[i] * p[j] + lam * delta + p[i] * t[j]) +
                        c * (f.dF[t_g][i] * f.B_p[j] + f.B_g[i] * f.dF[t_p][j]) +
                        0.5 * (sgg * f.across[i] * f.E_p[j] + spp * f.E_g[i] * f.across[j]);
            gp1(i, j) += c * f.B_g[i] * f.dF[t_p1][j];
            pp1(i, j) += c * f.B_p[i] * f.dF[t_p1][j];
        }
    }
    // T_gp = [-p1]x as a matrix of rows g: g.(p x p1) -> d/dg = p x p1, d2/dg dp = -[p1]x; and so
    // on
    const auto add_cross = [](Block<S>& block, const S& scale, const Vec3<S>& v) {
        block(0, 1) -= scale * v[2], block(1, 0) += scale * v[2];
        block(0, 2) += scale * v[1], block(2, 0) -= scale * v[1];
        block(1, 2) -= scale * v[0], block(2, 1) += scale * v[0];
    };
    add_cross(gp, -c, p1);
    add_cross(gp1, c, p);
    add_cross(pp1, -c, g);
    add_cross(gp, -skew_g, g);
    add_cross(gp, -skew_p, p);
}

}  // namespace ancf::detail
