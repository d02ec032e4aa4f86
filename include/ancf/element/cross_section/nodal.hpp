// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The local vectors that a station's energy depends on, the nodal vectors that an element's does,
/// and the way between them.
///
/// Seven, or nine where the centre line is quintic: `Line` is the number of those in it, 3 or 5.
/// By translation invariance only D = r_j - r_i of the positions enters; it is formed first, so
/// that an element far from the origin loses no digits. The shears stand beside the vectors.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/element/invariants.hpp>
#include <ancf/element/pack.hpp>
#include <ancf/element/station_data.hpp>
#include <ancf/element/vec3.hpp>
#include <ancf/types.hpp>

namespace ancf::detail {

/// Places of the local vectors of a station: p = r0', a = r_y, b = r_z, and their derivatives along
/// x.
enum LocalIndex : int { l_p, l_p1, l_a, l_a1, l_b, l_b1, local_count };

/// Number of shear variables of a station: (s, s', q, q'), or of an element: the nodal (s_i, s_j,
/// q_i, q_j).
inline constexpr int shear_count = 4;

/// Returns the place of block (i, j), i <= j, in the upper triangle of n x n blocks, column by
/// column.
constexpr int block_index(int i, int j) noexcept { return j * (j + 1) / 2 + i; }

template <class S>
using LocalVectors = Vec3<S>[local_count];

/// First derivatives of a station's energy.
template <class S>
struct LocalGradient {
    Vec3<S> vector[local_count];
    S shear[shear_count];
};

/// Second derivatives of a station's energy. Diagonal blocks are filled; symmetric to round-off.
template <class S>
struct LocalHessian {
    Block<S> block[block_index(0, local_count)];
    Vec3<S> coupling[shear_count][local_count];  ///< of a shear variable and a local vector
    S shear[shear_count][shear_count];           ///< symmetric, filled

    Block<S>& operator()(int i, int j) noexcept { return block[block_index(i, j)]; }
    const Block<S>& operator()(int i, int j) const noexcept { return block[block_index(i, j)]; }
};

/// Places of the nodal vectors: D, g = r_x, a = r_y, b = r_z at the first and second node; after
/// them, of a quintic centre line, k = r_xx.
enum NodalIndex : int {
    n_D,
    n_g1,
    n_g2,
    n_a1,
    n_a2,
    n_b1,
    n_b2,
    nodal_count,
    n_k1 = nodal_count,
    n_k2
};

/// Number of nodal vectors, and of nodal coordinates, with Line of them in the centre line.
template <int Line>
inline constexpr int vectors_with = Line + 4;
template <int Line>
inline constexpr int dofs_with = 3 * (Line + 5);

/// Returns the place of vector i of the centre line (D, g1, g2, k1, k2).
constexpr int line_vector(int i) noexcept { return i < 3 ? n_D + i : n_k1 + i - 3; }

template <class S, int Line = 3>
using NodalVectors = Vec3<S>[vectors_with<Line>];

/// First derivatives of an element's energy: by the vectors, and by scalars at the nodes that are
/// functions of these vectors in turn (the shears first).
template <class S, int Scalars = shear_count, int Line = 3>
struct NodalGradient {
    Vec3<S> vector[vectors_with<Line>];
    S scalar[Scalars];
};

/// Second derivatives of an element's energy by nodal vectors, the upper triangle of blocks, and by
/// the scalars: by all seven vectors, or by the Vectors = Line of the centre line in their order.
template <class S, int Vectors = nodal_count, int Scalars = shear_count>
struct NodalHessian {
    static constexpr int vectors = Vectors;
    static constexpr int line = Vectors == nodal_count ? 3 : Vectors;  ///< of the centre line

    Block<S> block[block_index(0, Vectors)];
    Vec3<S> coupling[Scalars][Vectors];
    S scalar[Scalars][Scalars];

    Block<S>& operator()(int i, int j) noexcept { return block[block_index(i, j)]; }
    const Block<S>& operator()(int i, int j) const noexcept { return block[block_index(i, j)]; }
};

/// Writes the local vectors of a station.
template <class T, class S>
inline void interpolate(const StationShape<T>& shape, const NodalVectors<S>& n,
                        LocalVectors<S>& local) noexcept {
    for (int k = 0; k < 3; ++k) {
        local[l_p][k] = shape.p[0] * n[n_D][k] + shape.p[1] * n[n_g1][k] + shape.p[2] * n[n_g2][k];
        local[l_p1][k] =
            shape.p1[0] * n[n_D][k] + shape.p1[1] * n[n_g1][k] + shape.p1[2] * n[n_g2][k];
        const S a = n[n_a2][k] - n[n_a1][k], b = n[n_b2][k] - n[n_b1][k];
        local[l_a][k] = n[n_a1][k] + shape.n2 * a;
        local[l_a1][k] = shape.n2_x * a;
        local[l_b][k] = n[n_b1][k] + shape.n2 * b;
        local[l_b1][k] = shape.n2_x * b;
    }
}

/// Returns a derivative of the centre line by its weights.
template <class T, class S, int Line, int Vectors>
inline Vec3<S> line_derivative(const T (&weights)[Line], const Vec3<S> (&n)[Vectors]) noexcept {
    static_assert(Vectors == vectors_with<Line>);
    Vec3<S> sum;
    for (int k = 0; k < 3; ++k) {
        sum[k] = weights[0] * n[n_D][k] + weights[1] * n[n_g1][k] + weights[2] * n[n_g2][k];
        for (int i = 3; i < Line; ++i) sum[k] += weights[i] * n[line_vector(i)][k];
    }
    return sum;
}

/// Adds derivatives by a station's vectors to those by the nodal ones.
template <class T, class S>
inline void vectors_to_nodes(const StationShape<T>& shape, const LocalVectors<S>& local,
                             NodalVectors<S>& n) noexcept {
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i)
            n[n_D + i][k] += shape.p[i] * local[l_p][k] + shape.p1[i] * local[l_p1][k];
        const S a2 = shape.n2 * local[l_a][k] + shape.n2_x * local[l_a1][k];
        const S b2 = shape.n2 * local[l_b][k] + shape.n2_x * local[l_b1][k];
        n[n_a1][k] += local[l_a][k] - a2;
        n[n_a2][k] += a2;
        n[n_b1][k] += local[l_b][k] - b2;
        n[n_b2][k] += b2;
    }
}

/// Adds a station's gradient to the nodes.
template <class T, class S>
inline void add_to_nodes(const StationShape<T>& shape, const LocalGradient<S>& local,
                         NodalGradient<S>& n) noexcept {
    vectors_to_nodes(shape, local.vector, n.vector);
    for (int m = 0; m < shear_count; ++m) n.scalar[m] += local.shear[m];
}

/// Adds the blocks of the centre line alone, from those of p and v = p1.
template <class Shape, class S, int Vectors, int Scalars>
inline void add_line_blocks(const Shape& shape, const Block<S>& p_p, const Block<S>& p_v,
                            const Block<S>& v_v, NodalHessian<S, Vectors, Scalars>& n) noexcept {
    constexpr int line = NodalHessian<S, Vectors, Scalars>::line;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) {
            const S pp = p_p(i, j), pv = p_v(i, j), vp = p_v(j, i), vv = v_v(i, j);
            for (int b = 0; b < line; ++b) {
                const S p = shape.p[b] * pp + shape.p1[b] * pv;
                const S v = shape.p[b] * vp + shape.p1[b] * vv;
                for (int a = 0; a <= b; ++a) n(a, b)(i, j) += shape.p[a] * p + shape.p1[a] * v;
            }
        }
    }
}

/// Adds the blocks of the centre line and a slope of the nodes (first, first + 1).
template <class T, class S>
inline void add_line_slope_blocks(const StationShape<T>& shape, const Block<S>& pa,
                                  const Block<S>& pa1, const Block<S>& va, const Block<S>& va1,
                                  int first, NodalHessian<S>& n) noexcept {
    for (int k = 0; k < 9; ++k) {
        const S p2 = shape.n2 * pa.v[k] + shape.n2_x * pa1.v[k], p1 = pa.v[k] - p2;
        const S v2 = shape.n2 * va.v[k] + shape.n2_x * va1.v[k], v1 = va.v[k] - v2;
        for (int a = 0; a < 3; ++a) {
            n(n_D + a, first).v[k] += shape.p[a] * p1 + shape.p1[a] * v1;
            n(n_D + a, first + 1).v[k] += shape.p[a] * p2 + shape.p1[a] * v2;
        }
    }
}

/// Adds the blocks of one slope with itself.
template <class T, class S>
inline void add_slope_blocks(const StationShape<T>& shape, const Block<S>& aa, const Block<S>& aa1,
                             const Block<S>& a1a1, int first, NodalHessian<S>& n) noexcept {
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 3; ++i) {
            const S a2 = shape.n2 * aa(i, j) + shape.n2_x * aa1(i, j);
            const S a1_2 = shape.n2 * aa1(j, i) + shape.n2_x * a1a1(i, j);
            const S second = shape.n2 * a2 + shape.n2_x * a1_2;
            n(first + 1, first + 1)(i, j) += second;
            n(first, first + 1)(i, j) += a2 - second;
            const S transposed = shape.n2 * aa(i, j) + shape.n2_x * aa1(j, i);
            n(first, first)(i, j) += aa(i, j) - a2 - transposed + second;
        }
    }
}

/// Adds the blocks of the y slope and the z slope.
template <class T, class S>
inline void add_mixed_slope_blocks(const StationShape<T>& shape, const LocalHessian<S>& local,
                                   NodalHessian<S>& n) noexcept {
    for (int k = 0; k < 9; ++k) {
        const S ab = local(l_a, l_b).v[k], a1b = local(l_a1, l_b).v[k];
        const S row = shape.n2 * ab + shape.n2_x * a1b;  // (a2, b)
        const S row1 = shape.n2 * local(l_a, l_b1).v[k] + shape.n2_x * local(l_a1, l_b1).v[k];
        const S column = shape.n2 * ab + shape.n2_x * local(l_a, l_b1).v[k];  // (a, b2)
        const S second = shape.n2 * row + shape.n2_x * row1;
        n(n_a2, n_b2).v[k] += second;
        n(n_a1, n_b2).v[k] += column - second;
        n(n_a2, n_b1).v[k] += row - second;
        n(n_a1, n_b1).v[k] += ab - row - column + second;
    }
}

/// Adds the couplings with the shears.
template <class T, class S>
inline void add_couplings(const StationShape<T>& shape, const LocalHessian<S>& local,
                          NodalHessian<S>& n) noexcept {
    for (int m = 0; m < shear_count; ++m) {
        vectors_to_nodes(shape, local.coupling[m], n.coupling[m]);
        for (int j = 0; j < shear_count; ++j) n.scalar[m][j] += local.shear[m][j];
    }
}

/// Adds a station's Hessian to the nodes. Without nodal shears there are no couplings to add.
template <bool NodalShear, class T, class S>
ANCF_NOINLINE void add_to_nodes(const StationShape<T>& shape, const LocalHessian<S>& local,
                                NodalHessian<S>& n) noexcept {
    add_line_blocks(shape, local(l_p, l_p), local(l_p, l_p1), local(l_p1, l_p1), n);
    add_line_slope_blocks(shape, local(l_p, l_a), local(l_p, l_a1), local(l_p1, l_a),
                          local(l_p1, l_a1), n_a1, n);
    add_line_slope_blocks(shape, local(l_p, l_b), local(l_p, l_b1), local(l_p1, l_b),
                          local(l_p1, l_b1), n_b1, n);
    add_slope_blocks(shape, local(l_a, l_a), local(l_a, l_a1), local(l_a1, l_a1), n_a1, n);
    add_slope_blocks(shape, local(l_b, l_b), local(l_b, l_b1), local(l_b1, l_b1), n_b1, n);
    add_mixed_slope_blocks(shape, local, n);
    if constexpr (NodalShear) add_couplings(shape, local, n);
}

/// Returns where the coordinates of nodal vector x start in [r r_x r_y r_z (r_xx)] per node. Those
/// of D are those of r_j; r_i has their negatives.
template <int Dofs>
constexpr int coordinate_start(int x) noexcept {
    constexpr int second = Dofs / 2;
    constexpr int start[] = {second, 3, second + 3, 6, second + 6, 9, second + 9, 12, second + 12};
    return start[x];
}

/// Writes the nodal vectors of coordinates.
template <class S, int Dofs, int Vectors>
inline void nodal_vectors(const Vector<S, Dofs>& e, Vec3<S> (&n)[Vectors]) noexcept {
    for (int k = 0; k < 3; ++k) {
        n[n_D][k] = e[Dofs / 2 + k] - e[k];
        for (int x = n_g1; x < Vectors; ++x) n[x][k] = e[coordinate_start<Dofs>(x) + k];
    }
}

/// Writes the gradient with respect to the coordinates.
template <class S, int Scalars, int Line>
inline void expand(const NodalGradient<S, Scalars, Line>& n,
                   Vector<S, dofs_with<Line>>& force) noexcept {
    for (int k = 0; k < 3; ++k) {
        force[k] = -n.vector[n_D][k];
        for (int x = 0; x < vectors_with<Line>; ++x)
            force[coordinate_start<dofs_with<Line>>(x) + k] = n.vector[x][k];
    }
}

/// Writes the sums over the lanes.
template <class P, class S, int Scalars, int Line>
inline void sum_lanes(const NodalGradient<P, Scalars, Line>& from,
                      NodalGradient<S, Scalars, Line>& to) noexcept {
    for (int x = 0; x < vectors_with<Line>; ++x) {
        for (int k = 0; k < 3; ++k) to.vector[x][k] = collapsed<S>(from.vector[x][k]);
    }
    for (int m = 0; m < Scalars; ++m) to.scalar[m] = collapsed<S>(from.scalar[m]);
}

}  // namespace ancf::detail
