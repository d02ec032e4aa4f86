// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Scalars at the nodes that depend on one slope and the tangent beside it: shears and spins.
///
/// Stations see them as variables of their own; here their derivatives are turned into those of the
/// vectors. Scalars come in groups of four: of the y slopes at both nodes, then of the z slopes.

#pragma once

#include <ancf/element/cross_section/nodal.hpp>
#include <ancf/element/cross_section/nodal_tangent.hpp>
#include <ancf/element/vec3.hpp>
#include <ancf/types.hpp>

namespace ancf::detail {

/// The differential da.(d slope) + dg.(d tangent) of a scalar at a node.
template <class S>
struct NodalForm {
    Vec3<S> da, dg;
};

/// The slope that scalar m depends on, and the tangent.
constexpr int slope_of(int m) noexcept { return n_a1 + m % 4; }
constexpr int tangent_of(int m) noexcept { return n_g1 + m % 2; }

/// Adds what the gradient with respect to the scalars means for the vectors.
template <class S, int Scalars, int Line>
inline void add_forms(const NodalForm<S>* const (&forms)[Scalars],
                      NodalGradient<S, Scalars, Line>& n) noexcept {
    for (int m = 0; m < Scalars; ++m) {
        add(n.vector[slope_of(m)], n.scalar[m], forms[m]->da);
        add(n.vector[tangent_of(m)], n.scalar[m], forms[m]->dg);
    }
}

/// Writes the columns Z = coupling + L^T scalar/2, L the gradients of the scalars: their part of
/// the tangent is Z L + (Z L)^T.
template <class P, class S, int Vectors, int Scalars, int Dofs>
inline void form_columns(const NodalForm<S>* const (&forms)[Scalars],
                         const NodalHessian<P, Vectors, Scalars>& h,
                         Vector<S, Dofs> (&Z)[Scalars]) noexcept {
    for (int m = 0; m < Scalars; ++m) {
        S* const z = Z[m].data();
        for (int i = 0; i < 3; ++i) z[i] = S(0.0);  // r_i has no part in a scalar
        if constexpr (Vectors != nodal_count) {     // nor have slopes but by forms
            for (int x = n_a1; x <= n_b2; ++x) {
                for (int i = 0; i < 3; ++i) z[coordinate_start<Dofs>(x) + i] = S(0.0);
            }
        }
        for (int x = 0; x < Vectors; ++x) {
            const int place = coordinate_start<Dofs>(Vectors == nodal_count ? x : line_vector(x));
            for (int i = 0; i < 3; ++i) z[place + i] = collapsed<S>(h.coupling[x][m][i]);
        }
        for (int k = 0; k < Scalars; ++k) {
            const S share = 0.5 * collapsed<S>(h.scalar[k][m]);
            S* const a = z + coordinate_start<Dofs>(slope_of(k));
            S* const g = z + coordinate_start<Dofs>(tangent_of(k));
            for (int i = 0; i < 3; ++i) {
                a[i] += share * forms[k]->da[i];
                g[i] += share * forms[k]->dg[i];
            }
        }
    }
}

/// Sets F to Z L.
template <class S, int Scalars, int Dofs>
inline void assign_columns(const NodalForm<S>* const (&forms)[Scalars],
                           const Vector<S, Dofs> (&Z)[Scalars],
                           const HalfTangent<S, Dofs>& half) noexcept {
    half.clear(n_D, n_g1);
    if constexpr (Dofs != dofs_with<3>) half.clear(n_k1, n_k2 + 1);
    for (int j = 0; j < 3; ++j) {
        for (int node = 0; node < 2; ++node) {
            auto column = half.column(n_g1 + node, j);
            column = forms[node]->dg[j] * Z[node] + forms[node + 2]->dg[j] * Z[node + 2];
            for (int m = 4 + node; m < Scalars; m += 2) column += forms[m]->dg[j] * Z[m];
        }
        for (int slope = 0; slope < 4; ++slope) {
            auto column = half.column(n_a1 + slope, j);
            column = forms[slope]->da[j] * Z[slope];
            for (int m = 4 + slope; m < Scalars; m += 4) column += forms[m]->da[j] * Z[m];
        }
    }
}

}  // namespace ancf::detail
