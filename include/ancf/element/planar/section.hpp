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

#include <ancf/compiler.hpp>
#include <ancf/element/cross_section_options.hpp>

#include <algorithm>
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

/// The measure in the plane that belongs to one in space.
template <class Measure>
struct PlanarMeasure;

/// Green's strains of docs/theory.md with the z director and everything out of the plane left away.
template <>
struct PlanarMeasure<GreenMeasure> {
    static constexpr bool engineering = false;

    /// Writes the strains.
    template <class S>
    static void strains(const PlanarInvariants<S>& w, S (&e)[planar_strain_count]) noexcept {
        const S bend = w.s1 - w.kap, turn = w.s * w.kap;  // d' = (bend, turn)
        e[0] = 0.5 * (w.lam * w.lam - 1.0);
        e[1] = w.lam * bend;
        e[2] = 0.5 * (bend * bend + turn * turn);
        e[3] = w.lam * w.s;
        e[4] = w.s * w.s1;
    }

    /// Writes sum_k f_k de_k/dw.
    template <class S>
    static void gradient(const PlanarInvariants<S>& w, const S (&f)[planar_strain_count],
                         S (&U)[planar_invariant_count]) noexcept {
        const S bend = w.s1 - w.kap, turn = w.s * w.kap;
        U[pw_lam] = w.lam * f[0] + bend * f[1] + w.s * f[3];
        U[pw_kap] = (w.s * turn - bend) * f[2] - w.lam * f[1];
        U[pw_s] = w.kap * turn * f[2] + w.lam * f[3] + w.s1 * f[4];
        U[pw_s1] = w.lam * f[1] + bend * f[2] + w.s * f[4];
    }

    /// Writes J[i][k] = de_k/dw_i.
    template <class S>
    static void jacobian(const PlanarInvariants<S>& w,
                         S (&J)[planar_invariant_count][planar_strain_count]) noexcept {
        const S bend = w.s1 - w.kap, turn = w.s * w.kap, zero(0.0);
        const S rows[planar_invariant_count][planar_strain_count] = {
            {w.lam, bend, zero, w.s, zero},
            {zero, -w.lam, w.s * turn - bend, zero, zero},
            {zero, zero, w.kap * turn, w.lam, w.s1},
            {zero, w.lam, bend, zero, w.s}};
        std::copy_n(&rows[0][0], planar_invariant_count * planar_strain_count, &J[0][0]);
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

/// Engineering strains, see cross_section/engineering_measure.hpp: the director is a unit vector,
/// s = sin of the shear angle.
template <>
struct PlanarMeasure<EngineeringMeasure> {
    static constexpr bool engineering = true;

    /// Writes the strains.
    template <class S>
    static void strains(const PlanarInvariants<S>& w, S (&e)[planar_strain_count]) noexcept {
        using std::sqrt;
        const S cosine = sqrt(S(1.0 - w.s * w.s));
        e[0] = w.lam * cosine - 1.0;
        e[1] = w.s1 / cosine - w.kap;
        e[3] = w.lam * w.s;
        e[2] = e[4] = S(0.0);
    }

    /// Writes sum_k f_k de_k/dw.
    template <class S>
    static void gradient(const PlanarInvariants<S>& w, const S (&f)[planar_strain_count],
                         S (&U)[planar_invariant_count]) noexcept {
        using std::sqrt;
        const S cosine = sqrt(S(1.0 - w.s * w.s)), inverse = 1.0 / cosine;
        const S tangent = w.s * inverse;
        U[pw_lam] = cosine * f[0] + w.s * f[3];
        U[pw_kap] = -f[1];
        U[pw_s] = w.s1 * tangent * inverse * inverse * f[1] + w.lam * (f[3] - tangent * f[0]);
        U[pw_s1] = inverse * f[1];
    }

    /// Writes J[i][k] = de_k/dw_i.
    template <class S>
    static void jacobian(const PlanarInvariants<S>& w,
                         S (&J)[planar_invariant_count][planar_strain_count]) noexcept {
        using std::sqrt;
        const S cosine = sqrt(S(1.0 - w.s * w.s)), inverse = 1.0 / cosine;
        const S tangent = w.s * inverse, zero(0.0);
        const S rows[planar_invariant_count][planar_strain_count] = {
            {cosine, zero, zero, w.s, zero},
            {zero, S(-1.0), zero, zero, zero},
            {-w.lam * tangent, w.s1 * tangent * inverse * inverse, zero, w.lam, zero},
            {zero, inverse, zero, zero, zero}};
        std::copy_n(&rows[0][0], planar_invariant_count * planar_strain_count, &J[0][0]);
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
struct PlanarStiffness {
    double axial[3][3];  ///< of (e1, e2, e3)
    double shear[2][2];  ///< of (e4, e5)
};

/// Writes f = C e.
template <class S>
inline void planar_stress(const PlanarStiffness& C, const S* e,
                          S (&f)[planar_strain_count]) noexcept {
    ANCF_UNROLL
    for (int i = 0; i < 3; ++i)
        f[i] = C.axial[i][0] * e[0] + C.axial[i][1] * e[1] + C.axial[i][2] * e[2];
    ANCF_UNROLL
    for (int i = 0; i < 2; ++i) f[3 + i] = C.shear[i][0] * e[3] + C.shear[i][1] * e[4];
}

}  // namespace ancf::detail
