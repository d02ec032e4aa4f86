// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Engineering strains of a section as functions of the ten invariants: Reissner's beam.
///
/// Components of F_x = r0' + y D_y' + z D_z' in the section's own directions, D_y and D_z the unit
/// slopes and D_y x D_z, instead of products of F_x with itself. The element then converges to the
/// geometrically exact beam. Curvatures are those of the rectangle that the slopes are nearest to:
/// bending does not shear the section. Derivation: docs/theory-measures.md.

#pragma once

#include <ancf/element/cross_section/sparse_jacobian.hpp>
#include <ancf/element/invariants.hpp>

#include <cmath>
#include <complex>

namespace ancf {

/// Strains linear in the deformation of the section, in linear relation to Biot's stress.
struct EngineeringMeasure {
    static constexpr bool engineering =
        true;  ///< directors of unit length; no second order strains

    /// Which strains depend on each invariant, one bit per strain.
    static constexpr unsigned pattern[detail::invariant_count] = {0b0010'0100'0001,   // lam
                                                                  0b0101'0000'0110,   // kap
                                                                  0b0101'0000'0110,   // chi
                                                                  0b0100'0000'0110,   // om
                                                                  0b0001'0000'0110,   // om2
                                                                  0b0101'0000'0111,   // phi
                                                                  0b0101'0100'0111,   // s
                                                                  0b0100'0000'0110,   // s1
                                                                  0b0111'0000'0111,   // q
                                                                  0b0001'0000'0110};  // q1

    /// A function of (phi, s, q) with its derivatives.
    template <class S>
    struct Factor {
        S value;  ///< the function
        S p;      ///< derivative by phi
        S s;      ///< derivative by s
        S q;      ///< derivative by q
        S pp;     ///< derivative by phi, twice
        S ps;     ///< derivative by phi and s
        S pq;     ///< derivative by phi and q
        S ss;     ///< derivative by s, twice
        S sq;     ///< derivative by s and q
        S qq;     ///< derivative by q, twice
    };

    /// Cosines of the shears, the rates of both directors, and their factors in the strains:
    ///
    ///     e2 = a sig - b Y,  e11 = b sig + a Y,  e3 = a2 tau - b2 Z,  e9 = -b2 tau - a2 Z.
    template <class S>
    struct Rates {
        S cy;   ///< cosine of the shear of r_y
        S cz;   ///< cosine of the shear of r_z
        S icy;  ///< 1/cy
        S icz;  ///< 1/cz
        S sig;  ///< s'/cy - kap
        S Y;    ///< s chi + cy om
        S tau;  ///< q'/cz - kap2
        S Z;    ///< q chi2 + cz om2
        S a;    ///< cz S
        S b;    ///< q cy - s cz C
        S a2;   ///< cy S
        S b2;   ///< q cy C - s cz

        /// Evaluates them at a station.
        explicit Rates(const detail::Invariants<S>& w) noexcept {
            using std::sqrt;
            cy = sqrt(S(1.0 - w.s * w.s));
            cz = sqrt(S(1.0 - w.q * w.q));
            icy = 1.0 / cy;
            icz = 1.0 / cz;
            sig = w.s1 * icy - w.kap;
            Y = w.s * w.chi + cy * w.om;
            tau = w.q1 * icz - w.kap2;
            Z = w.q * w.chi2 + cz * w.om2;
            a = cz * w.S_;
            b = w.q * cy - w.s * cz * w.C;
            a2 = cy * w.S_;
            b2 = w.q * cy * w.C - w.s * cz;
        }
    };

    /// Writes the strains e(w).
    template <class S>
    static void strains(const detail::Invariants<S>& w, const Rates<S>& r,
                        S (&e)[detail::strain_count]) noexcept {
        e[0] = w.lam * r.cy * r.cz * w.S_ - 1.0;
        const S half = half_cosine(w, r), y = curvature_y(r), z = curvature_z(r);
        e[1] = y - half * z;
        e[2] = z - half * y;
        e[3] = e[4] = e[5] = S(0.0);
        e[6] = w.lam * w.s;
        e[7] = S(0.0);
        e[8] = -(r.b2 * r.tau + r.a2 * r.Z);
        e[9] = w.lam * w.q;
        e[10] = r.b * r.sig + r.a * r.Y;
        e[11] = S(0.0);
    }

    /// Writes the derivatives J[i][k] = de_k/dw_i where `pattern` has a bit.
    template <class S>
    static void jacobian(const detail::Invariants<S>& w, const Rates<S>& r,
                         detail::StrainJacobian<S>& J) noexcept {
        using namespace detail;
        const S &C = w.C, &Z_ = w.S_, &s = w.s, &q = w.q;
        const S sy = s * r.icy, qz = q * r.icz;  // tangents of the shears
        curvature_jacobian(w, r, J);
        const S half = half_cosine(w, r);
        for (int i = 0; i < invariant_count; ++i) {
            const S y = J[i][1], z = J[i][2];
            J[i][1] = y - half * z;
            J[i][2] = z - half * y;
        }
        const S by_phi = -0.5 * r.cy * r.cz * Z_;
        const S by_s = 0.5 * (q - sy * r.cz * C), by_q = 0.5 * (s - r.cy * qz * C);
        const S y = curvature_y(r), z = curvature_z(r);
        J[w_phi][1] -= by_phi * z, J[w_phi][2] -= by_phi * y;
        J[w_s][1] -= by_s * z, J[w_s][2] -= by_s * y;
        J[w_q][1] -= by_q * z, J[w_q][2] -= by_q * y;

        J[w_lam][0] = r.cy * r.cz * Z_, J[w_lam][6] = s, J[w_lam][9] = q;
        J[w_kap][10] = -r.b, J[w_kap][8] = r.b2 * C + r.a2 * q * Z_;
        J[w_chi][10] = r.a * s, J[w_chi][8] = r.b2 * Z_ - r.a2 * q * C;
        J[w_om][10] = r.a * r.cy;
        J[w_om2][8] = -r.a2 * r.cz;

        const S a_p = r.cz * C, b_p = s * r.cz * Z_, a2_p = r.cy * C, b2_p = -r.cy * q * Z_;
        const S tau_p = -w.chi2, Z_p = -q * w.kap2;
        J[w_phi][0] = w.lam * r.cy * r.cz * C;
        J[w_phi][10] = b_p * r.sig + a_p * r.Y;
        J[w_phi][8] = -(b2_p * r.tau + a2_p * r.Z + r.b2 * tau_p + r.a2 * Z_p);

        const S b_s = -(q * sy + r.cz * C), a2_s = -sy * Z_, b2_s = -(sy * q * C + r.cz);
        const S sig_s = w.s1 * sy * r.icy * r.icy, Y_s = w.chi - w.om * sy;
        J[w_s][0] = -w.lam * sy * r.cz * Z_;
        J[w_s][10] = r.b * sig_s + r.a * Y_s + b_s * r.sig;
        J[w_s][8] = -(b2_s * r.tau + a2_s * r.Z);
        J[w_s][6] = w.lam;
        J[w_s1][10] = r.b * r.icy;

        const S a_q = -qz * Z_, b_q = r.cy + s * qz * C, b2_q = r.cy * C + s * qz;
        const S tau_q = w.q1 * qz * r.icz * r.icz, Z_q = w.chi2 - w.om2 * qz;
        J[w_q][0] = -w.lam * r.cy * qz * Z_;
        J[w_q][10] = b_q * r.sig + a_q * r.Y;
        J[w_q][8] = -(r.b2 * tau_q + r.a2 * Z_q + b2_q * r.tau);
        J[w_q][9] = w.lam;
        J[w_q1][8] = -r.b2 * r.icz;
    }

    /// Adds the second derivatives sum_k sigma_k d2e_k/dw2 to the upper triangle of D.
    template <class S>
    static void add_curvature(const detail::Invariants<S>& w, const Rates<S>& r,
                              const S (&sigma)[detail::strain_count],
                              detail::InvariantHessian<S>& D) noexcept {
        using namespace detail;
        const S half = half_cosine(w, r);
        const S of_y = sigma[1] - half * sigma[2], of_z = sigma[2] - half * sigma[1];
        add_y(w, r, y_factor(w, r, of_y, sigma[10]), y_factor(w, r, sigma[10], S(-of_y)), D);
        add_z(w, r, z_factor(w, r, of_z, S(-sigma[8])), z_factor(w, r, S(-sigma[8]), S(-of_z)), D);
        add_half_cosine(w, r, sigma, D);
        const S sy = w.s * r.icy, qz = w.q * r.icz;
        const S f = sigma[0], F = sigma[0] * w.lam;
        D[w_lam][w_phi] += f * (r.cy * r.cz * w.C);
        D[w_lam][w_s] += sigma[6] - f * (sy * r.cz * w.S_);
        D[w_lam][w_q] += sigma[9] - f * (r.cy * qz * w.S_);
        D[w_phi][w_phi] -= F * (r.cy * r.cz * w.S_);
        D[w_phi][w_s] -= F * (sy * r.cz * w.C);
        D[w_phi][w_q] -= F * (r.cy * qz * w.C);
        D[w_s][w_s] -= F * (r.cz * w.S_ * r.icy * r.icy * r.icy);
        D[w_s][w_q] += F * (sy * qz * w.S_);
        D[w_q][w_q] -= F * (r.cy * w.S_ * r.icz * r.icz * r.icz);
    }

private:
    /// Returns the curvature e2 as r_y has it, D_x.D_y', and e3 as r_z has it.
    template <class S>
    static S curvature_y(const Rates<S>& r) noexcept {
        return r.a * r.sig - r.b * r.Y;
    }
    template <class S>
    static S curvature_z(const Rates<S>& r) noexcept {
        return r.a2 * r.tau - r.b2 * r.Z;
    }
    /// Returns half the cosine of the angle between the slopes, D_y.D_z/2.
    template <class S>
    static S half_cosine(const detail::Invariants<S>& w, const Rates<S>& r) noexcept {
        return 0.5 * (w.s * w.q + r.cy * r.cz * w.C);
    }
    /// Adds -(d half x d(sigma_2 z + sigma_3 y) + its transpose) - (sigma_2 z + sigma_3 y) d2 half.
    template <class S>
    static void add_half_cosine(const detail::Invariants<S>& w, const Rates<S>& r,
                                const S (&sigma)[detail::strain_count],
                                detail::InvariantHessian<S>& D) noexcept {
        using namespace detail;
        const S &C = w.C, &Z_ = w.S_, &s = w.s, &q = w.q;
        const S sy = s * r.icy, qz = q * r.icz;
        StrainJacobian<S> J;
        curvature_jacobian(w, r, J);
        const int places[] = {w_phi, w_s, w_q};
        const S first[] = {-0.5 * r.cy * r.cz * Z_, 0.5 * (q - sy * r.cz * C),
                           0.5 * (s - r.cy * qz * C)};
        for (int i = 0; i < invariant_count; ++i) {
            const S of_i = sigma[1] * J[i][2] + sigma[2] * J[i][1];
            for (int k = 0; k < 3; ++k) {
                const S change = first[k] * of_i;
                if (i <= places[k]) D[i][places[k]] -= change;
                if (i >= places[k]) D[places[k]][i] -= change;
            }
        }
        const S weight = 0.5 * (sigma[1] * curvature_z(r) + sigma[2] * curvature_y(r));
        D[w_phi][w_phi] += weight * (r.cy * r.cz * C);
        D[w_phi][w_s] -= weight * (sy * r.cz * Z_);
        D[w_phi][w_q] -= weight * (r.cy * qz * Z_);
        D[w_s][w_s] += weight * (r.cz * C * r.icy * r.icy * r.icy);
        D[w_s][w_q] -= weight * (1.0 + sy * qz * C);
        D[w_q][w_q] += weight * (r.cy * C * r.icz * r.icz * r.icz);
    }
    /// Writes the derivatives of both curvatures, J[i][1] and J[i][2].
    template <class S>
    static void curvature_jacobian(const detail::Invariants<S>& w, const Rates<S>& r,
                                   detail::StrainJacobian<S>& J) noexcept {
        using namespace detail;
        const S &C = w.C, &Z_ = w.S_, &s = w.s, &q = w.q;
        const S sy = s * r.icy, qz = q * r.icz;  // tangents of the shears
        J[w_lam][1] = J[w_lam][2] = S(0.0);
        J[w_kap][1] = -r.a;
        J[w_kap][2] = r.b2 * q * Z_ - r.a2 * C;
        J[w_chi][1] = -r.b * s;
        J[w_chi][2] = -(r.a2 * Z_ + r.b2 * q * C);
        J[w_om][1] = -r.b * r.cy;
        J[w_om2][2] = -r.b2 * r.cz;
        J[w_om][2] = J[w_om2][1] = S(0.0);
        const S a_p = r.cz * C, b_p = s * r.cz * Z_, a2_p = r.cy * C, b2_p = -r.cy * q * Z_;
        J[w_phi][1] = a_p * r.sig - b_p * r.Y;
        J[w_phi][2] = a2_p * r.tau - b2_p * r.Z - r.a2 * w.chi2 + r.b2 * q * w.kap2;
        const S b_s = -(q * sy + r.cz * C), a2_s = -sy * Z_, b2_s = -(sy * q * C + r.cz);
        J[w_s][1] = r.a * (w.s1 * sy * r.icy * r.icy) - r.b * (w.chi - w.om * sy) - b_s * r.Y;
        J[w_s][2] = a2_s * r.tau - b2_s * r.Z;
        J[w_s1][1] = r.a * r.icy;
        J[w_q1][2] = r.a2 * r.icz;
        J[w_s1][2] = J[w_q1][1] = S(0.0);
        const S a_q = -qz * Z_, b_q = r.cy + s * qz * C, b2_q = r.cy * C + s * qz;
        J[w_q][1] = a_q * r.sig - b_q * r.Y;
        J[w_q][2] = r.a2 * (w.q1 * qz * r.icz * r.icz) - r.b2 * (w.chi2 - w.om2 * qz) - b2_q * r.Z;
    }

    /// Returns f a + g b and f a2 + g b2 with all derivatives.
    template <class S>
    static Factor<S> y_factor(const detail::Invariants<S>& w, const Rates<S>& r, const S& f,
                              const S& g) noexcept {
        const S &C = w.C, &Z_ = w.S_, &s = w.s, &q = w.q;
        const S sy = s * r.icy, qz = q * r.icz;
        const S y3 = r.icy * r.icy * r.icy, z3 = r.icz * r.icz * r.icz;
        return {f * r.a + g * r.b,
                f * (r.cz * C) + g * (s * r.cz * Z_),
                -g * (q * sy + r.cz * C),
                g * (r.cy + s * qz * C) - f * (qz * Z_),
                g * (s * r.cz * C) - f * r.a,
                g * (r.cz * Z_),
                -(f * (qz * C) + g * (s * qz * Z_)),
                -g * (q * y3),
                g * (qz * C - sy),
                g * (s * C * z3) - f * (Z_ * z3)};
    }
    template <class S>
    static Factor<S> z_factor(const detail::Invariants<S>& w, const Rates<S>& r, const S& f,
                              const S& g) noexcept {
        const S &C = w.C, &Z_ = w.S_, &s = w.s, &q = w.q;
        const S sy = s * r.icy, qz = q * r.icz;
        const S y3 = r.icy * r.icy * r.icy, z3 = r.icz * r.icz * r.icz;
        return {f * r.a2 + g * r.b2,
                f * (r.cy * C) - g * (r.cy * q * Z_),
                -(f * (sy * Z_) + g * (sy * q * C + r.cz)),
                g * (r.cy * C + s * qz),
                -(f * r.a2 + g * (r.cy * q * C)),
                g * (sy * q * Z_) - f * (sy * C),
                -g * (r.cy * Z_),
                -(f * (Z_ * y3) + g * (q * C * y3)),
                g * (qz - sy * C),
                g * (s * z3)};
    }
    /// The y director: second derivatives of alpha sig + beta Y.
    template <class S>
    static void add_y(const detail::Invariants<S>& w, const Rates<S>& r, const Factor<S>& al,
                      const Factor<S>& be, detail::InvariantHessian<S>& D) noexcept {
        using namespace detail;
        const S &s = w.s, sy = s * r.icy, y2 = r.icy * r.icy;
        const S sig_s = w.s1 * sy * y2, sig_s1s = sy * y2;
        const S sig_ss = w.s1 * (1.0 + 2.0 * s * s) * y2 * y2 * r.icy;
        const S Y_s = w.chi - w.om * sy, Y_ss = -w.om * y2 * r.icy;
        D[w_kap][w_phi] -= al.p;
        D[w_kap][w_s] -= al.s;
        D[w_kap][w_q] -= al.q;
        D[w_chi][w_phi] += s * be.p;
        D[w_chi][w_s] += s * be.s + be.value;
        D[w_chi][w_q] += s * be.q;
        D[w_om][w_phi] += r.cy * be.p;
        D[w_om][w_s] += r.cy * be.s - sy * be.value;
        D[w_om][w_q] += r.cy * be.q;
        D[w_phi][w_phi] += r.sig * al.pp + r.Y * be.pp;
        D[w_phi][w_s] += r.sig * al.ps + r.Y * be.ps + al.p * sig_s + be.p * Y_s;
        D[w_phi][w_s1] += al.p * r.icy;
        D[w_phi][w_q] += r.sig * al.pq + r.Y * be.pq;
        D[w_s][w_s] += r.sig * al.ss + r.Y * be.ss + 2.0 * (al.s * sig_s + be.s * Y_s) +
                       al.value * sig_ss + be.value * Y_ss;
        D[w_s][w_s1] += al.s * r.icy + al.value * sig_s1s;
        D[w_s][w_q] += r.sig * al.sq + r.Y * be.sq + al.q * sig_s + be.q * Y_s;
        D[w_s1][w_q] += al.q * r.icy;
        D[w_q][w_q] += r.sig * al.qq + r.Y * be.qq;
    }
    /// The z director: second derivatives of alpha tau + beta Z.
    template <class S>
    static void add_z(const detail::Invariants<S>& w, const Rates<S>& r, const Factor<S>& al,
                      const Factor<S>& be, detail::InvariantHessian<S>& D) noexcept {
        using namespace detail;
        const S &C = w.C, &Z_ = w.S_, &q = w.q, qz = q * r.icz, z2 = r.icz * r.icz;
        const S tau_p = -w.chi2, Z_p = -q * w.kap2;
        const S tau_q = w.q1 * qz * z2, tau_qq = w.q1 * (1.0 + 2.0 * q * q) * z2 * z2 * r.icz;
        const S Z_q = w.chi2 - w.om2 * qz, Z_qq = -w.om2 * z2 * r.icz;
        const S qC = q * C, qS = q * Z_;
        D[w_kap][w_phi] += Z_ * al.value - C * al.p - qC * be.value - qS * be.p;
        D[w_chi][w_phi] += qC * be.p - C * al.value - Z_ * al.p - qS * be.value;
        D[w_kap][w_s] -= C * al.s + qS * be.s;
        D[w_chi][w_s] += qC * be.s - Z_ * al.s;
        D[w_kap][w_q] -= C * al.q + qS * be.q + Z_ * be.value;
        D[w_chi][w_q] += qC * be.q - Z_ * al.q + C * be.value;
        D[w_om2][w_phi] += r.cz * be.p;
        D[w_om2][w_s] += r.cz * be.s;
        D[w_om2][w_q] += r.cz * be.q - qz * be.value;
        D[w_phi][w_phi] += r.tau * al.pp + r.Z * be.pp + 2.0 * (al.p * tau_p + be.p * Z_p) +
                           al.value * w.kap2 - be.value * (q * w.chi2);
        D[w_phi][w_s] += r.tau * al.ps + r.Z * be.ps + al.s * tau_p + be.s * Z_p;
        D[w_phi][w_q] += r.tau * al.pq + r.Z * be.pq + al.p * tau_q + al.q * tau_p + be.p * Z_q +
                         be.q * Z_p - be.value * w.kap2;
        D[w_phi][w_q1] += al.p * r.icz;
        D[w_s][w_s] += r.tau * al.ss + r.Z * be.ss;
        D[w_s][w_q] += r.tau * al.sq + r.Z * be.sq + al.s * tau_q + be.s * Z_q;
        D[w_s][w_q1] += al.s * r.icz;
        D[w_q][w_q] += r.tau * al.qq + r.Z * be.qq + 2.0 * (al.q * tau_q + be.q * Z_q) +
                       al.value * tau_qq + be.value * Z_qq;
        D[w_q][w_q1] += al.q * r.icz + al.value * (qz * z2);
    }
};

}  // namespace ancf
