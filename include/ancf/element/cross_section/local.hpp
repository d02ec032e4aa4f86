// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What the energy of a station depends on: six local vectors; and where its derivatives go.

#pragma once

#include <ancf/element/invariants.hpp>
#include <ancf/element/vec3.hpp>

namespace ancf::detail {

/// Places of the local vectors: p = r0', a = r_y, b = r_z, and their derivatives along x.
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
    Vec3<S> coupling[local_count][shear_count];  ///< of a local vector and a shear variable
    S shear[shear_count][shear_count];           ///< symmetric, filled

    Block<S>& operator()(int i, int j) noexcept { return block[block_index(i, j)]; }
    const Block<S>& operator()(int i, int j) const noexcept { return block[block_index(i, j)]; }
};

}  // namespace ancf::detail
