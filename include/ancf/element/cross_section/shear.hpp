// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The shear of a director: sine of the angle between its slope and the normal plane of the centre
/// line.
///
/// s = a.g/(|a| |g|), [Dufva2006, Eq. 18], a function of a slope a and the tangent g. The paper's
/// element evaluates it at the nodes and interpolates linearly (Eq. 20); its variant evaluates it
/// at the stations.

#pragma once

#include <ancf/element/cross_section/nodal.hpp>
#include <ancf/element/cross_section/nodal_tangent.hpp>
#include <ancf/element/cross_section/pointwise_shear.hpp>

#include <cmath>
#include <complex>

namespace ancf {

namespace detail {

/// A shear sine at a node with its derivatives.
template <class S>
struct NodalSine : NodalForm<S> {
    S value;
    Vec3<S> u, t;    ///< unit slope, unit tangent
    S inv_a, inv_g;  ///< 1/|a|, 1/|g|
};

template <class S>
inline NodalSine<S> nodal_sine(const Vec3<S>& a, const Vec3<S>& g) noexcept {
    using std::sqrt;
    NodalSine<S> s;
    s.inv_a = 1.0 / sqrt(dot(a, a));
    s.inv_g = 1.0 / sqrt(dot(g, g));
    s.u = s.inv_a * a;
    s.t = s.inv_g * g;
    s.value = dot(s.u, s.t);
    for (int k = 0; k < 3; ++k) {
        s.da[k] = s.inv_a * (s.t[k] - s.value * s.u[k]);
        s.dg[k] = s.inv_g * (s.u[k] - s.value * s.t[k]);
    }
    return s;
}

/// The four shear sines of an element.
template <class S>
using NodalSines = NodalSine<S>[shear_count];

template <class S, int Vectors>
inline void nodal_sines(const Vec3<S> (&vectors)[Vectors], NodalSines<S>& sines) noexcept {
    for (int m = 0; m < shear_count; ++m)
        sines[m] = nodal_sine(vectors[slope_of(m)], vectors[tangent_of(m)]);
}

/// Adds half of what is left of f d2s once -f (u/|a|, t/|g|) has joined Z: f (I - s t u^T)/(|a|
/// |g|) between the tangent and the slope, and f s (u u^T - I)/|a|^2 of the slope with itself,
/// likewise of the tangent.
template <class S, int Dofs>
inline void add_second(const NodalSine<S>& sine, const S& f, int g, int a,
                       const HalfTangent<S, Dofs>& half) noexcept {
    constexpr int stride = Dofs;
    const S fs = f * sine.value, f_ga = f * sine.inv_a * sine.inv_g;
    const S aa = 0.5 * fs * sine.inv_a * sine.inv_a, gg = 0.5 * fs * sine.inv_g * sine.inv_g;
    const S ga = f_ga * sine.value;
    S* const block_aa = half.block(a, a);
    S* const block_gg = half.block(g, g);
    S* const block_ga = half.block(g, a);
    for (int j = 0; j < 3; ++j) {
        const S aa_j = aa * sine.u[j], gg_j = gg * sine.t[j], ga_j = ga * sine.u[j];
        for (int i = 0; i < 3; ++i) {
            block_aa[i + stride * j] += sine.u[i] * aa_j;
            block_gg[i + stride * j] += sine.t[i] * gg_j;
            block_ga[i + stride * j] -= sine.t[i] * ga_j;
        }
        block_aa[j + stride * j] -= aa;
        block_gg[j + stride * j] -= gg;
        block_ga[j + stride * j] += f_ga;
    }
}

/// Adds f times the second derivatives of the sines: a share to the columns Z of their forms
/// (before these are multiplied out), the rest to F (after).
template <class S, int Dofs>
inline void add_sine_shares(const NodalSine<S>& sine, const S& f, int m,
                            Vector<S, Dofs>& Z) noexcept {
    const S f_a = f * sine.inv_a, f_g = f * sine.inv_g;
    S* const a = Z.data() + coordinate_start<Dofs>(slope_of(m));
    S* const g = Z.data() + coordinate_start<Dofs>(tangent_of(m));
    for (int i = 0; i < 3; ++i) {
        a[i] -= f_a * sine.u[i];
        g[i] -= f_g * sine.t[i];
    }
}

/// Sets F to what the couplings with the nodal sines, and their own second derivatives, mean for
/// the vectors.
template <class P, class S>
ANCF_NOINLINE void assign_sines(const NodalSines<S>& sines, const NodalGradient<S>& n,
                                const NodalHessian<P>& h, const HalfTangent<S>& half) noexcept {
    const NodalForm<S>* const forms[] = {&sines[0], &sines[1], &sines[2], &sines[3]};
    Vector<S, 24> Z[shear_count];
    form_columns(forms, h, Z);
    for (int m = 0; m < shear_count; ++m) add_sine_shares(sines[m], n.scalar[m], m, Z[m]);
    assign_columns(forms, Z, half);
    for (int m = 0; m < shear_count; ++m)
        add_second(sines[m], n.scalar[m], tangent_of(m), slope_of(m), half);
}

/// Adds what the gradient with respect to the sines means for the vectors.
template <class S>
inline void add_sines(const NodalSines<S>& sines, NodalGradient<S>& n) noexcept {
    const NodalForm<S>* const forms[] = {&sines[0], &sines[1], &sines[2], &sines[3]};
    add_forms(forms, n);
}

/// Writes s, s', q, q' of a station from the nodal sines (s_i, s_j, q_i, q_j).
template <class Shape, class S>
inline void interpolate_shears(const Shape& shape, const S (&sines)[shear_count],
                               Invariants<S>& w) noexcept {
    const S ds = sines[1] - sines[0], dq = sines[3] - sines[2];
    w.s = sines[0] + shape.n2_s * ds;
    w.s1 = shape.n2_x * ds;
    w.q = sines[2] + shape.n2_s * dq;
    w.q1 = shape.n2_x * dq;
}

/// Turns derivatives with respect to (s, s', q, q') into those with respect to the nodal sines.
template <class Shape, class S>
inline void shears_to_nodes(const Shape& shape, S& s, S& s1, S& q, S& q1) noexcept {
    s1 = shape.n2_s * s + shape.n2_x * s1;
    s = s - s1;
    q1 = shape.n2_s * q + shape.n2_x * q1;
    q = q - q1;
}

}  // namespace detail

/// Shear sines at the nodes, linear in x between them: [Dufva2006, Eq. 20].
struct LinearShear {
    static constexpr bool nodal = true;  ///< shears are interpolated from nodes

    /// What a station keeps of its shears.
    template <class S>
    struct Station {};

    /// Evaluates the shears of a station.
    template <class T, class S>
    static void shears(const StationShape<T>& shape, const S (&sines)[detail::shear_count],
                       const detail::LocalVectors<S>&, Station<S>&,
                       detail::Invariants<S>& w) noexcept {
        detail::interpolate_shears(shape, sines, w);
    }

    /// Carries dU/d(shears) to what they depend on.
    template <class T, class S>
    static void gradient(const StationShape<T>& shape, const Station<S>&,
                         const S (&U)[detail::invariant_count],
                         detail::LocalGradient<S>& g) noexcept {
        for (int m = 0; m < detail::shear_count; ++m) g.shear[m] = U[detail::w_s + m];
        detail::shears_to_nodes(shape, g.shear[0], g.shear[1], g.shear[2], g.shear[3]);
    }
};

}  // namespace ancf
