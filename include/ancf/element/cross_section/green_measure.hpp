// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The twelve generalised Green strains of a section as functions of the ten invariants.
///
/// Source: [Dufva2006, Eqs. 22, 23] with F_x = r0' + y d_y' + z d_z' sorted by powers of y and z:
///
///     e_xx   = e1 + y e2 + z e3 + y^2 e4 + y z e5 + z^2 e6
///     2 e_xy = e7 + y e8 + z e9            2 e_xz = e10 + y e11 + z e12
///
/// In the frame of the y director d = (s, 1, 0), d' = (s' - kap, s kap, om + s chi), and h, h' of
/// the z director likewise in its own. Derivation: docs/theory.md, "Strains of a section".

#pragma once

#include <ancf/element/cross_section/sparse_jacobian.hpp>
#include <ancf/element/invariants.hpp>

namespace ancf {

/// The strain measure of [Dufva2006]: Green's, in linear relation to the second Piola-Kirchhoff
/// stress.
struct GreenMeasure {
    static constexpr bool engineering = false;  ///< strains are products of F_x with itself

    /// Which strains depend on each invariant, one bit per strain.
    static constexpr unsigned pattern[detail::invariant_count] = {0b0010'0100'0111,   // lam
                                                                  0b0101'0011'1110,   // kap
                                                                  0b0101'0011'1100,   // chi
                                                                  0b0100'0001'1000,   // om
                                                                  0b0001'0011'0000,   // om2
                                                                  0b0101'0011'0100,   // phi
                                                                  0b0101'1101'1000,   // s
                                                                  0b0100'1001'1010,   // s1
                                                                  0b1111'0011'0000,   // q
                                                                  0b1001'0011'0100};  // q1

    /// Components of the directors' rates d', h' that strains and their derivatives share.
    template <class S>
    struct Rates {
        S d1;  ///< d' of the y director, along t of its frame
        S d2;  ///< along n
        S d3;  ///< along c
        S b1;  ///< h' of the z director, along t of its frame
        S b2;  ///< along n
        S b3;  ///< along c
        S hn;  ///< h' along n of the y director; along t it is b1
        S hc;  ///< h' along c of the y director

        /// The rates at given invariants.
        explicit Rates(const detail::Invariants<S>& w) noexcept
            : d1(w.s1 - w.kap),
              d2(w.s * w.kap),
              d3(w.om + w.s * w.chi),
              b1(w.q1 - w.kap2),
              b2(w.q * w.kap2),
              b3(w.om2 + w.q * w.chi2),
              hn(w.q * w.kap - w.S_ * w.om2),
              hc(w.q * w.chi + w.C * w.om2) {}
    };

    /// Writes the strains e(w).
    template <class S>
    static void strains(const detail::Invariants<S>& w, const Rates<S>& r,
                        S (&e)[detail::strain_count]) noexcept {
        e[0] = 0.5 * (w.lam - 1.0) * (w.lam + 1.0);
        e[1] = w.lam * r.d1;
        e[2] = w.lam * r.b1;
        e[3] = 0.5 * (r.d1 * r.d1 + r.d2 * r.d2 + r.d3 * r.d3);
        e[4] = r.d1 * r.b1 + r.d2 * r.hn + r.d3 * r.hc;
        e[5] = 0.5 * (r.b1 * r.b1 + r.b2 * r.b2 + r.b3 * r.b3);
        e[6] = w.lam * w.s;
        e[7] = w.s * w.s1;
        e[8] = w.s * r.b1 + r.hn;
        e[9] = w.lam * w.q;
        e[10] = w.q * r.d1 + w.s * w.kap2 + w.S_ * w.om;
        e[11] = w.q * w.q1;
    }

    /// Writes the derivatives J[i][k] = de_k/dw_i where `pattern` has a bit; leaves the others
    /// untouched.
    template <class S>
    static void jacobian(const detail::Invariants<S>& w, const Rates<S>& r,
                         detail::StrainJacobian<S>& J) noexcept {
        using namespace detail;
        const S radial = w.q * r.b2 - r.b1;  // de6/dkap2
        const S spin = w.q * r.b3;           // de6/dchi2
        S(&lam)[12] = J[w_lam];
        lam[0] = w.lam, lam[1] = r.d1, lam[2] = r.b1, lam[6] = w.s, lam[9] = w.q;
        S(&kap)[12] = J[w_kap];
        kap[1] = -w.lam;
        kap[2] = -w.lam * w.C;
        kap[3] = w.s * r.d2 - r.d1;
        kap[4] = w.s * r.hn + w.q * r.d2 - r.b1 - w.C * r.d1;
        kap[5] = w.C * radial - w.S_ * spin;
        kap[8] = w.q - w.s * w.C;
        kap[10] = w.s * w.C - w.q;
        S(&chi)[12] = J[w_chi];
        chi[2] = -w.lam * w.S_;
        chi[3] = w.s * r.d3;
        chi[4] = w.s * r.hc + w.q * r.d3 - w.S_ * r.d1;
        chi[5] = w.S_ * radial + w.C * spin;
        chi[10] = w.s * w.S_;
        chi[8] = -chi[10];
        J[w_om][3] = r.d3, J[w_om][4] = r.hc, J[w_om][10] = w.S_;
        const S turned = w.C * r.d2 + w.S_ * r.d3;
        J[w_om2][4] = w.C * r.d3 - w.S_ * r.d2, J[w_om2][5] = r.b3, J[w_om2][8] = -w.S_;
        S(&phi)[12] = J[w_phi];
        phi[2] = -w.lam * w.chi2;
        phi[4] = -(w.chi2 * r.d1 + w.om2 * turned);
        phi[5] = w.chi2 * radial - w.kap2 * spin;
        phi[8] = -(w.s * w.chi2 + w.C * w.om2);
        phi[10] = w.s * w.chi2 + w.C * w.om;
        S(&s)[12] = J[w_s];
        s[3] = w.kap * r.d2 + w.chi * r.d3;
        s[4] = w.kap * r.hn + w.chi * r.hc;
        s[6] = w.lam, s[7] = w.s1, s[8] = r.b1, s[10] = w.kap2;
        S(&s1)[12] = J[w_s1];
        s1[1] = w.lam, s1[3] = r.d1, s1[4] = r.b1, s1[7] = w.s, s1[10] = w.q;
        S(&q)[12] = J[w_q];
        q[4] = w.kap * r.d2 + w.chi * r.d3;
        q[5] = w.kap2 * r.b2 + w.chi2 * r.b3;
        q[8] = w.kap, q[9] = w.lam, q[10] = r.d1, q[11] = w.q1;
        S(&q1)[12] = J[w_q1];
        q1[2] = w.lam, q1[4] = r.d1, q1[5] = r.b1, q1[8] = w.s, q1[11] = w.q;
    }

    /// Adds the second derivatives sum_k sigma_k d2e_k/dw2 to the upper triangle of D.
    template <class S>
    static void add_curvature(const detail::Invariants<S>& w, const Rates<S>& r,
                              const S (&sigma)[detail::strain_count],
                              detail::InvariantHessian<S>& D) noexcept {
        using namespace detail;
        const S &f2 = sigma[1], &f3 = sigma[2], &f4 = sigma[3], &f5 = sigma[4], &f6 = sigma[5];
        const S &f9 = sigma[8], &f11 = sigma[10];
        const S &C = w.C, &Z = w.S_, &s = w.s, &q = w.q, &kap = w.kap, &chi = w.chi, &om2 = w.om2;
        const S &kap2 = w.kap2, &chi2 = w.chi2;
        const S cross = s * f9 - s * f11;  // of (kap, chi) seen from the z director
        const S radial = q * r.b2 - r.b1, spin = q * r.b3, qq = q * q;
        const S turned = C * r.d2 + Z * r.d3, one_qq = 1.0 + qq;

        D[w_lam][w_lam] += sigma[0];
        D[w_lam][w_kap] -= f2 + C * f3;
        D[w_lam][w_chi] -= Z * f3;
        D[w_lam][w_phi] -= chi2 * f3;
        D[w_lam][w_s] += sigma[6];
        D[w_lam][w_s1] += f2;
        D[w_lam][w_q] += sigma[9];
        D[w_lam][w_q1] += f3;

        const S qs2 = 2.0 * q * s;
        D[w_kap][w_kap] += f4 * (1.0 + s * s) + f6 * (C * C + qq) + f5 * (2.0 * C + qs2);
        D[w_kap][w_chi] += Z * (C * f6 + f5);
        D[w_chi][w_chi] += f4 * s * s + f6 * (Z * Z + qq) + f5 * qs2;
        D[w_kap][w_om2] -= Z * (q * f6 + s * f5);
        D[w_chi][w_om2] += C * (q * f6 + s * f5);
        D[w_chi][w_om] += s * f4 + q * f5;
        D[w_om][w_om] += f4;
        D[w_om][w_om2] += C * f5;
        D[w_om2][w_om2] += f6;
        // with phi: kap2_phi = chi2, chi2_phi = -kap2
        const S bend = w.lam * f3 + r.d1 * f5 + cross - radial * f6;  // of -d2 kap2
        const S tilt = spin * f6;                                     // of d2 chi2
        const S along = f6 * (one_qq * chi2);
        const S across = f6 * (qq * kap2);
        D[w_kap][w_phi] += C * along + Z * across + Z * bend - C * tilt + f5 * (chi2 - s * C * om2);
        D[w_chi][w_phi] += Z * along - C * across - C * bend - Z * tilt - f5 * s * Z * om2;
        D[w_phi][w_phi] += chi2 * along + kap2 * across + kap2 * bend - chi2 * tilt +
                           f5 * om2 * (Z * r.d2 - C * r.d3) + Z * (om2 * f9 - w.om * f11);
        D[w_om][w_phi] += C * f11 - f5 * Z * om2;
        D[w_om2][w_phi] -= f5 * turned + f6 * q * kap2 + C * f9;

        const S fs = f11 - f9;
        D[w_kap][w_s] += f4 * (r.d2 + s * kap) + f5 * (q * kap + r.hn) + C * fs;
        D[w_chi][w_s] += f4 * (s * chi + r.d3) + f5 * (q * chi + r.hc) + Z * fs;
        D[w_om][w_s] += f4 * chi;
        D[w_om2][w_s] += f5 * chi2;
        D[w_phi][w_s] += chi2 * fs - f5 * om2 * kap2;
        D[w_s][w_s] += f4 * (kap * kap + chi * chi);
        D[w_kap][w_s1] -= f4 + C * f5;
        D[w_chi][w_s1] -= Z * f5;
        D[w_phi][w_s1] -= chi2 * f5;
        D[w_s][w_s1] += sigma[7];
        D[w_s1][w_s1] += f4;

        const S mix = q * chi2 + r.b3;
        const S twice = 2.0 * q * kap2;
        D[w_kap][w_q] += f6 * (twice * C - mix * Z) + 2.0 * f5 * r.d2 - fs;
        D[w_chi][w_q] += f6 * (twice * Z + mix * C) + f5 * (s * chi + r.d3);
        D[w_om][w_q] += f5 * chi;
        D[w_om2][w_q] += f6 * chi2;
        D[w_phi][w_q] += f6 * (twice * chi2 - mix * kap2);
        const S square = kap * kap + chi * chi;
        D[w_s][w_q] += f5 * square;
        D[w_s1][w_q] += f11;
        D[w_q][w_q] += f6 * square;
        D[w_kap][w_q1] -= C * f6 + f5;
        D[w_chi][w_q1] -= Z * f6;
        D[w_phi][w_q1] -= chi2 * f6;
        D[w_s][w_q1] += f9;
        D[w_s1][w_q1] += f5;
        D[w_q][w_q1] += sigma[11];
        D[w_q1][w_q1] += f6;
    }
};

}  // namespace ancf
