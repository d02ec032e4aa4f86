// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Between the nodal coordinates (r, r_x)_i, (r, r_x)_j of a cable and the line vector of its
/// kernel.

#pragma once

#include <ancf/element/cable/kernel.hpp>
#include <ancf/types.hpp>

namespace ancf::detail {

/// Returns the nodal vectors r_j - r_i and both r_x.
template <int D, class S>
[[nodiscard]] inline LineVector<S, D> line_of(const Vector<S, 4 * D>& e) noexcept {
    LineVector<S, D> line;
    for (int k = 0; k < D; ++k) {
        line[k] = e[2 * D + k] - e[k];
        line[D + k] = e[D + k];
        line[2 * D + k] = e[3 * D + k];
    }
    return line;
}

/// Returns derivatives by the nodal vectors as a nodal force.
template <int D, class S>
[[nodiscard]] inline Vector<S, 4 * D> nodal_force(const LineVector<S, D>& line) noexcept {
    Vector<S, 4 * D> force;
    for (int k = 0; k < D; ++k) {
        force[k] = -line[k];
        force[D + k] = line[D + k];
        force[2 * D + k] = line[k];
        force[3 * D + k] = line[2 * D + k];
    }
    return force;
}

/// Writes second derivatives by the nodal vectors as a nodal tangent.
template <int D, class S>
inline void write_tangent(const LineHessian<S, D>& line, Matrix<S, 4 * D>& tangent) noexcept {
    constexpr int r_i = 0, g_i = D, r_j = 2 * D, g_j = 3 * D;
    const Matrix<S, D> rr = line.block(0, 0), ri = line.block(1, 0), ij = line.block(2, 1),
                       rj = line.block(2, 0);
    const Matrix<S, D> ii = line.block(1, 1), jj = line.block(2, 2);
    for (int j = 0; j < D; ++j) {
        for (int i = 0; i < D; ++i) {
            tangent(r_i + i, r_i + j) = tangent(r_j + i, r_j + j) = rr(i, j);
            tangent(r_i + i, r_j + j) = tangent(r_j + i, r_i + j) = -rr(i, j);
            tangent(g_i + i, r_i + j) = tangent(r_i + j, g_i + i) = -ri(i, j);
            tangent(g_i + i, r_j + j) = tangent(r_j + j, g_i + i) = ri(i, j);
            tangent(g_j + i, r_i + j) = tangent(r_i + j, g_j + i) = -rj(i, j);
            tangent(g_j + i, r_j + j) = tangent(r_j + j, g_j + i) = rj(i, j);
            tangent(g_i + i, g_i + j) = ii(i, j);
            tangent(g_j + i, g_i + j) = tangent(g_i + j, g_j + i) = ij(i, j);
            tangent(g_j + i, g_j + j) = jj(i, j);
        }
    }
}

}  // namespace ancf::detail
