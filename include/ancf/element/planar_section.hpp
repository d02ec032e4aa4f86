// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Invariants and strains of a section that stays in the plane.
///
/// The director is the normal of the centre line turned by the shear, so only stretch lam,
/// curvature kap, shear s and its rate s' are left of the ten invariants, and five generalised
/// strains of the twelve:
///
///     e_xx = e1 + y e2 + y^2 e3,    2 e_xy = e4 + y e5.

#pragma once

#include <ancf/section/stiffness.hpp>

#include <cmath>
#include <complex>

namespace ancf::detail {

/// Number of generalised strains in the plane.
inline constexpr int planar_strain_count = 5;

/// Places of the planar invariants.
enum PlanarInvariant : int { pw_lam, pw_kap, pw_s, pw_s1, planar_invariant_count };

template <class S>
struct PlanarInvariants {
    S lam, kap, s, s1;
};

/// Strains, their Jacobian J[i][k] = de_k/dw_i, and what their second derivatives need.
template <class S>
struct PlanarStrains {
    S e[planar_strain_count];
    S J[planar_invariant_count][planar_strain_count];
};

/// Green's strains of docs/theory.md with the z director and everything out of the plane left away.
struct PlanarGreen {
    template <class S>
    static void evaluate(const PlanarInvariants<S>& w, PlanarStrains<S>& out) noexcept {
        const S bend = w.s1 - w.kap;  // d' = (s' - kap, s kap)
        const S turn = w.s * w.kap;
        out.e[0] = 0.5 * (w.lam * w.lam - 1.0);
        out.e[1] = w.lam * bend;
        out.e[2] = 0.5 * (bend * bend + turn * turn);
        out.e[3] = w.lam * w.s;
        out.e[4] = w.s * w.s1;
        const S zero(0.0);
        const S J[planar_invariant_count][planar_strain_count] = {
            {w.lam, bend, zero, w.s, zero},
            {zero, -w.lam, w.s * turn - bend, zero, zero},
            {zero, zero, w.kap * turn, w.lam, w.s1},
            {zero, w.lam, bend, zero, w.s}};
        for (int i = 0; i < planar_invariant_count; ++i) {
            for (int k = 0; k < planar_strain_count; ++k) out.J[i][k] = J[i][k];
        }
    }

    /// Adds sum_k f_k d2e_k/dw2 to the upper triangle of D.
    template <class S>
    static void add_curvature(const PlanarInvariants<S>& w, const S (&f)[planar_strain_count],
                              S (&D)[planar_invariant_count][planar_invariant_count]) noexcept {
        D[pw_lam][pw_lam] += f[0];
        D[pw_lam][pw_kap] -= f[1];
        D[pw_lam][pw_s1] += f[1];
        D[pw_lam][pw_s] += f[3];
        D[pw_kap][pw_kap] += f[2] * (1.0 + w.s * w.s);
        D[pw_kap][pw_s] += 2.0 * f[2] * w.s * w.kap;
        D[pw_kap][pw_s1] -= f[2];
        D[pw_s][pw_s] += f[2] * w.kap * w.kap;
        D[pw_s][pw_s1] += f[4];
        D[pw_s1][pw_s1] += f[2];
    }
};

/// Engineering strains, see engineering_measure.hpp: the director is a unit vector, s = sin of the
/// shear angle.
struct PlanarEngineering {
    template <class S>
    static void evaluate(const PlanarInvariants<S>& w, PlanarStrains<S>& out) noexcept {
        using std::sqrt;
        const S cosine = sqrt(S(1.0 - w.s * w.s)), inverse = 1.0 / cosine;
        const S tangent = w.s * inverse;
        out.e[0] = w.lam * cosine - 1.0;
        out.e[1] = w.s1 * inverse - w.kap;
        out.e[3] = w.lam * w.s;
        out.e[2] = out.e[4] = S(0.0);
        const S zero(0.0);
        const S J[planar_invariant_count][planar_strain_count] = {
            {cosine, zero, zero, w.s, zero},
            {zero, S(-1.0), zero, zero, zero},
            {-w.lam * tangent, w.s1 * tangent * inverse * inverse, zero, w.lam, zero},
            {zero, inverse, zero, zero, zero}};
        for (int i = 0; i < planar_invariant_count; ++i) {
            for (int k = 0; k < planar_strain_count; ++k) out.J[i][k] = J[i][k];
        }
    }

    /// Adds sum_k f_k d2e_k/dw2 to the upper triangle of D.
    template <class S>
    static void add_curvature(const PlanarInvariants<S>& w, const S (&f)[planar_strain_count],
                              S (&D)[planar_invariant_count][planar_invariant_count]) noexcept {
        using std::sqrt;
        const S square = 1.0 / (1.0 - w.s * w.s), inverse = sqrt(square);
        D[pw_lam][pw_s] += f[3] - f[0] * w.s * inverse;
        D[pw_s][pw_s] +=
            inverse * square * (f[1] * w.s1 * (1.0 + 2.0 * w.s * w.s) * square - f[0] * w.lam);
        D[pw_s][pw_s1] += f[1] * w.s * inverse * square;
    }
};

/// The section matrix in the plane, times the station's weight and length.
template <class T>
struct PlanarStiffness {
    T axial[3][3];  ///< of (e1, e2, e3)
    T shear[2][2];  ///< of (e4, e5)
};

/// Writes f = C e.
template <class T, class S>
inline void planar_stress(const PlanarStiffness<T>& C, const S* e,
                          S (&f)[planar_strain_count]) noexcept {
    for (int i = 0; i < 3; ++i)
        f[i] = C.axial[i][0] * e[0] + C.axial[i][1] * e[1] + C.axial[i][2] * e[2];
    for (int i = 0; i < 2; ++i) f[3 + i] = C.shear[i][0] * e[3] + C.shear[i][1] * e[4];
}

}  // namespace ancf::detail
