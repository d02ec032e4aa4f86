// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The ten invariants of rigid motion that the strain energy of a section depends on.

#pragma once

namespace ancf::detail {

/// Number of generalised strains: 6 of e_xx, 3 of 2e_xy, 3 of 2e_xz.
inline constexpr int strain_count = 12;

/// Places of the invariants in gradients and Hessians.
enum InvariantIndex : int {
    w_lam,
    w_kap,
    w_chi,
    w_om,
    w_om2,
    w_phi,
    w_s,
    w_s1,
    w_q,
    w_q1,
    invariant_count
};

/// Where the shears start: the invariants before are geometric.
inline constexpr int geometric_count = w_s;

/// Second derivatives by the invariants.
template <class S>
using InvariantHessian = S[invariant_count][invariant_count];

/// The invariants at a station. The frame is that of the y director; a trailing 2 marks the z
/// director.
template <class S>
struct Invariants {
    S lam;         ///< stretch of the centre line, 1
    S kap, chi;    ///< curvatures in the plane of the y director and across it, 1/m
    S om, om2;     ///< twist rates of the y and z director, 1/m
    S C, S_;       ///< cosine and sine of phi, the angle from the y to the z director
    S s, s1;       ///< shear of the y director and its derivative along x; 1, 1/m
    S q, q1;       ///< shear of the z director and its derivative along x; 1, 1/m
    S kap2, chi2;  ///< the curvatures seen from the z director: C kap + S chi, C chi - S kap
};

}  // namespace ancf::detail
