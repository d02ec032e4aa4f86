// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The last steps to a tangent: from scalars at the nodes to nodal vectors, and from blocks of
/// these to 24 x 24 coordinates, or 30 x 30.
///
/// What the nodes themselves contribute is written to a matrix F, half of its part of the tangent:
/// the block of two vectors stands on one side, the block of a vector with itself counts half. So
/// the products Z L + (Z L)^T of the nodal shears are plain columns Z L. At the end K = F + F^T +
/// the stations' blocks, symmetric bit by bit.

#pragma once

#include <ancf/element/cross_section/nodal.hpp>
#include <ancf/element/vec3.hpp>
#include <ancf/types.hpp>

namespace ancf::detail {

/// The half F, addressed by nodal vectors, in the storage of the tangent.
template <class S, int Dofs = dofs_with<3>>
class HalfTangent {
public:
    static constexpr int stride = Dofs;  ///< from a column to the next

    explicit HalfTangent(Matrix<S, Dofs>& storage) noexcept : f_(storage.data()) {}

    /// Returns the first entry of the block of vectors x and y; columns are `stride` apart.
    [[nodiscard]] S* block(int x, int y) const noexcept {
        return f_ + start(x) + stride * start(y);
    }

    /// Returns the rows of column j of vector y.
    [[nodiscard]] Eigen::Map<Vector<S, Dofs>> column(int y, int j) const noexcept {
        return Eigen::Map<Vector<S, Dofs>>(f_ + stride * (start(y) + j));
    }

    /// Clears the columns of the vectors in [first, last).
    void clear(int first, int last) const noexcept {
        for (int y = first; y < last; ++y) {
            for (int j = 0; j < 3; ++j) column(y, j).setZero();
        }
    }

    /// Turns F and the blocks of the stations into the tangent.
    template <class P, int Vectors, int Scalars>
    void finish(const NodalHessian<P, Vectors, Scalars>& stations) const noexcept {
        for (int b = 0; b < Vectors; ++b) {
            const int y = place<Vectors>(b);
            for (int a = 0; a < b; ++a) {
                const int x = place<Vectors>(a);
                add_block(stations(a, b), block(x, y), block(y, x));
            }
            add_diagonal(stations(b, b), block(y, y));
        }
        if constexpr (Vectors != nodal_count) {
            for (int y = n_a1; y <= n_b2; ++y) {
                for (int x = 0; x <= y; ++x) mirror(block(x, y), block(y, x));
                for (int x = n_k1; x < vectors; ++x) mirror(block(x, y), block(y, x));
            }
        }
        // r_i stands for -D
        for (int j = 0; j < 3; ++j) {
            S* const out = f_ + stride * j;
            const S* const end = f_ + stride * (Dofs / 2 + j);
            for (int i = 0; i < Dofs; ++i) out[i] = -end[i];
        }
        for (int j = 0; j < Dofs; ++j) {
            S* const out = f_ + stride * j;
            for (int i = 0; i < 3; ++i) out[i] = -out[Dofs / 2 + i];
        }
    }

private:
    static constexpr int vectors = Dofs / 3 - 1;

    static constexpr int start(int x) noexcept { return coordinate_start<Dofs>(x); }

    /// The nodal vector that stands at a place of the stations' blocks.
    template <int Vectors>
    static constexpr int place(int x) noexcept {
        return Vectors == nodal_count ? x : line_vector(x);
    }

    static void mirror(S* xy, S* yx) noexcept {
        for (int j = 0; j < 3; ++j) {
            for (int i = xy == yx ? j : 0; i < 3; ++i) {
                xy[i + stride * j] = yx[j + stride * i] = xy[i + stride * j] + yx[j + stride * i];
            }
        }
    }

    template <class P>
    static void add_block(const Block<P>& block, S* xy, S* yx) noexcept {
        const P* v = block.v;
        for (int j = 0; j < 3; ++j, v += 3, xy += stride, ++yx) {
            xy[0] = yx[0] = xy[0] + yx[0] + collapsed<S>(v[0]);
            xy[1] = yx[stride] = xy[1] + yx[stride] + collapsed<S>(v[1]);
            xy[2] = yx[2 * stride] = xy[2] + yx[2 * stride] + collapsed<S>(v[2]);
        }
    }

    template <class P>
    static void add_diagonal(const Block<P>& block, S* xx) noexcept {
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i <= j; ++i) {
                xx[i + stride * j] = xx[j + stride * i] =
                    xx[i + stride * j] + xx[j + stride * i] + collapsed<S>(block(i, j));
            }
        }
    }

    S* f_;
};

/// The differential da.(d slope) + dg.(d tangent) of a scalar at a node that depends on one slope
/// and the tangent beside it: a shear or a spin.
///
/// Stations see such scalars as variables of their own. They come in groups of four: of the y
/// slopes at both nodes, then of the z slopes.
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
            for (int i = 0; i < 3; ++i) z[place + i] = collapsed<S>(h.coupling[m][x][i]);
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
