// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The last step to a tangent: from blocks of nodal vectors to 24 x 24 coordinates, or 30 x 30.
///
/// What the nodes themselves contribute is written to a matrix F, half of its part of the tangent:
/// the block of two vectors stands on one side, the block of a vector with itself counts half. So
/// the products Z L + (Z L)^T of the nodal shears are plain columns Z L. At the end K = F + F^T +
/// the stations' blocks, symmetric bit by bit.

#pragma once

#include <ancf/compiler.hpp>
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

}  // namespace ancf::detail
