// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Strains of the section in its own plane: e_yy, e_zz, 2e_yz at the nodes, linear between them.
///
/// Source: [Dufva2006, Eqs. 24 to 28]. The energy of a strain with nodal values e1, e2 is
/// W (e1^2 + e1 e2 + e2^2)/6, W its stiffness times the length.

#pragma once

#include <ancf/element/cross_section/nodal.hpp>
#include <ancf/element/cross_section/nodal_tangent.hpp>
#include <ancf/element/cross_section_options.hpp>
#include <ancf/element/rate.hpp>
#include <ancf/element/vec3.hpp>

#include <cmath>
#include <complex>

namespace ancf {

/// Constant data of the transverse strains of an element.
template <class T>
struct TransverseData {
    T stiffness[3];     ///< of e_yy, e_zz, 2e_yz times the length, N m
    T reference[3][2];  ///< nodal strains of the stress-free state, subtracted
};

namespace detail {

template <int Lanes>
inline void put_lane(TransverseData<Pack<Lanes>>& to, int lane,
                     const TransverseData<double>& from) noexcept {
    put_lane(to.stiffness, lane, from.stiffness);
    put_lane(to.reference, lane, from.reference);
}

/// One nodal strain of a pair of slopes: value and gradients.
template <class S>
struct StretchStrain {
    S value;
    Vec3<S> gradient;
    S inverse;  ///< 1/|a| for the stretch measure
};

template <class S>
inline StretchStrain<S> stretch_strain(TransverseStrain measure, const Vec3<S>& a) noexcept {
    using std::sqrt;
    const S square = dot(a, a);
    if (measure == TransverseStrain::green) return {0.5 * (square - 1.0), a, S(1.0)};
    const S length = sqrt(square);
    const S inverse = 1.0 / length;
    return {length - 1.0, inverse * a, inverse};
}

/// The transverse strains of both nodes with gradients, their stresses and energy.
template <class S>
struct TransverseState {
    StretchStrain<S> yy[2], zz[2];
    S stress[3][2];  ///< dU/de at the nodes
    S energy;
};

/// Writes strains, stresses and energy.
template <class T, class S, int Vectors>
inline void transverse_state(const TransverseData<T>& data, TransverseStrain measure,
                             const Vec3<S> (&n)[Vectors], TransverseState<S>& state) noexcept {
    S e[3][2];
    for (int node = 0; node < 2; ++node) {
        state.yy[node] = stretch_strain(measure, n[n_a1 + node]);
        state.zz[node] = stretch_strain(measure, n[n_b1 + node]);
        e[0][node] = deformation(state.yy[node].value, data.reference[0][node]);
        e[1][node] = deformation(state.zz[node].value, data.reference[1][node]);
        e[2][node] = deformation(S(dot(n[n_a1 + node], n[n_b1 + node])), data.reference[2][node]);
    }
    state.energy = S(0.0);
    for (int k = 0; k < 3; ++k) {
        const S W = data.stiffness[k] * S(1.0 / 6.0);
        state.stress[k][0] = W * (2.0 * e[k][0] + e[k][1]);
        state.stress[k][1] = W * (e[k][0] + 2.0 * e[k][1]);
        state.energy += 0.5 * (state.stress[k][0] * e[k][0] + state.stress[k][1] * e[k][1]);
    }
}

/// Replaces the stresses by those of a state linearised along a direction.
template <class S>
inline void predict(const TransverseState<Dual<S>>& before, TransverseState<S>& state) noexcept {
    for (int k = 0; k < 3; ++k) {
        for (int node = 0; node < 2; ++node)
            state.stress[k][node] = arrived(before.stress[k][node]);
    }
}

/// Adds the gradient.
template <class S, int Vectors, int Scalars, int Line>
inline void add_transverse(const TransverseState<S>& state, const Vec3<S> (&n)[Vectors],
                           NodalGradient<S, Scalars, Line>& g) noexcept {
    for (int node = 0; node < 2; ++node) {
        add(g.vector[n_a1 + node], state.stress[0][node], state.yy[node].gradient);
        add(g.vector[n_a1 + node], state.stress[2][node], n[n_b1 + node]);
        add(g.vector[n_b1 + node], state.stress[1][node], state.zz[node].gradient);
        add(g.vector[n_b1 + node], state.stress[2][node], n[n_a1 + node]);
    }
}

/// Adds half of f times the second derivatives of a nodal stretch strain to a diagonal block.
template <int stride, class S>
inline void add_stretch_second(TransverseStrain measure, const StretchStrain<S>& strain, const S& f,
                               S* block) noexcept {
    const S share = 0.5 * f * strain.inverse;
    for (int j = 0; j < 3; ++j) block[j + stride * j] += share;
    if (measure == TransverseStrain::green) return;
    for (int j = 0; j < 3; ++j) {
        const S column = share * strain.gradient[j];
        for (int i = 0; i < 3; ++i) block[i + stride * j] -= column * strain.gradient[i];
    }
}

/// Adds half of the second derivatives.
template <class T, class S, int Vectors, int Dofs>
ANCF_NOINLINE void add_transverse(const TransverseData<T>& data, TransverseStrain measure,
                                  const TransverseState<S>& state, const Vec3<S> (&n)[Vectors],
                                  const HalfTangent<S, Dofs>& half) noexcept {
    constexpr int stride = Dofs;
    for (int node = 0; node < 2; ++node) {
        add_stretch_second<stride>(measure, state.yy[node], state.stress[0][node],
                                   half.block(n_a1 + node, n_a1 + node));
        add_stretch_second<stride>(measure, state.zz[node], state.stress[1][node],
                                   half.block(n_b1 + node, n_b1 + node));
        S* const block = half.block(n_a1 + node, n_b1 + node);
        for (int k = 0; k < 3; ++k) block[k + stride * k] += state.stress[2][node];
    }
    // The weights are W/3 of equal nodes, halved on the diagonal, and W/6 of different ones.
    const S W_yy = S(data.stiffness[0] * (1.0 / 6.0)), W_zz = S(data.stiffness[1] * (1.0 / 6.0));
    const S W_yz = S(data.stiffness[2] * (1.0 / 6.0));
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 2; ++x) {
            const Vec3<S>&ax = n[n_a1 + x], &bx = n[n_b1 + x], &ay = n[n_a1 + y], &by = n[n_b1 + y];
            const S W_ab = x == y ? S(2.0 * W_yz) : W_yz;
            S* ab = half.block(n_a1 + x, n_b1 + y);
            for (int j = 0; j < 3; ++j, ab += stride) {
                const S a = W_ab * ay[j];
                for (int i = 0; i < 3; ++i) ab[i] += bx[i] * a;
            }
            if (x > y) continue;
            const Vec3<S>&ux = state.yy[x].gradient, &uy = state.yy[y].gradient;
            const Vec3<S>&vx = state.zz[x].gradient, &vy = state.zz[y].gradient;
            S* aa = half.block(n_a1 + x, n_a1 + y);
            S* bb = half.block(n_b1 + x, n_b1 + y);
            for (int j = 0; j < 3; ++j, aa += stride, bb += stride) {
                const S u = W_yy * uy[j], v = W_zz * vy[j], a = W_yz * ay[j], b = W_yz * by[j];
                for (int i = 0; i < 3; ++i) {
                    aa[i] += ux[i] * u + bx[i] * b;
                    bb[i] += vx[i] * v + ax[i] * a;
                }
            }
        }
    }
}

}  // namespace detail
}  // namespace ancf
