// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Directors by projection of the linearly interpolated slopes: [Dufva2006, Eqs. 11 to 18].
///
/// Geometry of a station in three steps: frames of the two directors; the geometric invariants; and
/// the first and second derivatives of an energy given by its derivatives with respect to the
/// invariants. Derivation: docs/theory.md, "From invariants to local vectors".

#pragma once

#include <ancf/element/cross_section/director.hpp>
#include <ancf/element/cross_section/local.hpp>
#include <ancf/element/invariants.hpp>

namespace ancf {

/// Each director is the projection of its slope on the plane normal to the centre line.
struct Projected {
    /// The frames of both directors at a station.
    template <class S>
    struct Frames {
        detail::DirectorFrame<S> y;  ///< of r_y
        detail::DirectorFrame<S> z;  ///< of r_z
    };

    /// Evaluates both frames.
    template <class S>
    static void frames(const detail::LocalVectors<S>& local, Frames<S>& f) noexcept {
        using namespace detail;
        f.y = director_frame(local[l_p], local[l_p1], local[l_a], local[l_a1]);
        f.z = director_frame(local[l_p], local[l_p1], local[l_b], local[l_b1]);
    }

    /// Writes all invariants but the shears.
    template <class S>
    static void invariants(const Frames<S>& f, detail::Invariants<S>& w) noexcept {
        w.lam = f.y.lam;
        w.kap = f.y.kap;
        w.chi = f.y.chi;
        w.om = f.y.om;
        w.om2 = f.z.om;
        w.C = dot(f.y.n, f.z.n);
        w.S_ = dot(f.y.c, f.z.n);
        w.kap2 = f.z.kap;
        w.chi2 = f.z.chi;
    }

    /// Writes the gradient with respect to the local vectors, L^T U.
    template <class S>
    static void gradient(const Frames<S>& f, const S (&U)[detail::invariant_count],
                         detail::Vec3<S> (&g)[detail::local_count]) noexcept;

    /// Writes L^T D L + the second derivatives of the invariants weighted by U, and the couplings
    /// with the shears.
    template <class S>
    static void hessian(const Frames<S>& f, const detail::Invariants<S>& w,
                        const S (&U)[detail::invariant_count], const detail::InvariantHessian<S>& D,
                        detail::LocalHessian<S>& h) noexcept;
};

template <class S>
void Projected::gradient(const Frames<S>& f, const S (&U)[detail::invariant_count],
                         detail::Vec3<S> (&g)[detail::local_count]) noexcept {
    using namespace detail;
    const DirectorFrame<S>&y = f.y, &z = f.z;
    const S &U_k = U[w_kap], &U_c = U[w_chi], &U_o = U[w_om], &U_o2 = U[w_om2], &U_phi = U[w_phi];
    const S il = y.inv_lam;
    const S p_t =
        U[w_lam] + il * (y.al * y.chi * U_o + z.al * z.chi * U_o2 - y.kap * U_k - y.chi * U_c);
    const S p_n = il * ((y.al * y.om - y.chi) * U_o - y.eta * U_k);
    const S p_c =
        il * ((y.al * y.kap - y.eta) * U_c - y.al * y.chi * U_k + y.zeta * U_o + y.al * U_phi);
    const S p_m = il * (z.al * z.om - z.chi) * U_o2;
    const S p_d = il * (z.zeta * U_o2 - z.al * U_phi);
    const S v_n = il * U_k, v_c = il * (U_c - y.al * U_o), v_d = -il * z.al * U_o2;
    const S a_t = -y.inv_nu * y.chi * U_o, a_n = -y.inv_nu * y.om * U_o;
    const S a_c = y.inv_nu * (y.chi * U_k - y.kap * U_c - y.mu * U_o - U_phi),
            a1_c = y.inv_nu * U_o;
    const S b_t = -z.inv_nu * z.chi * U_o2, b_m = -z.inv_nu * z.om * U_o2;
    const S b_d = z.inv_nu * (U_phi - z.mu * U_o2), b1_d = z.inv_nu * U_o2;
    for (int k = 0; k < 3; ++k) {
        g[l_p][k] = p_t * y.t[k] + p_n * y.n[k] + p_c * y.c[k] + p_m * z.n[k] + p_d * z.c[k];
        g[l_p1][k] = v_n * y.n[k] + v_c * y.c[k] + v_d * z.c[k];
        g[l_a][k] = a_t * y.t[k] + a_n * y.n[k] + a_c * y.c[k];
        g[l_a1][k] = a1_c * y.c[k];
        g[l_b][k] = b_t * y.t[k] + b_m * z.n[k] + b_d * z.c[k];
        g[l_b1][k] = b1_d * z.c[k];
    }
}

}  // namespace ancf

#include <ancf/element/cross_section/projected_hessian.hpp>
