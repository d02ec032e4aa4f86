// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Products with the Jacobian of the strains, its zeros known at compile time.
///
/// A measure says by one bit pattern per invariant which strains depend on it; only those entries
/// are multiplied. The section matrix couples e1..e6, e7..e9 and e10..e12 among themselves.

#pragma once

#include <ancf/element/invariants.hpp>
#include <ancf/element/station_data.hpp>

namespace ancf::detail {

/// J[i][k] = de_k/dw_i; only the entries of the measure's pattern are ever read.
template <class S>
using StrainJacobian = S[invariant_count][strain_count];

/// The strains of the same block of the section matrix as strain k.
constexpr unsigned block_of(int k) noexcept { return k < 6 ? 0x03FU : k < 9 ? 0x1C0U : 0xE00U; }

/// The strains whose stress a strain increment of this pattern changes.
constexpr unsigned block_closure(unsigned pattern) noexcept {
    unsigned closure = 0;
    for (int k = 0; k < strain_count; ++k) {
        if ((pattern >> k & 1U) != 0) closure |= block_of(k);
    }
    return closure;
}

/// The lowest bit of a pattern that is not empty.
constexpr int lowest_bit(unsigned bits) noexcept {
    int k = 0;
    while ((bits >> k & 1U) == 0) ++k;
    return k;
}

/// Returns the sum of a[k] b[k] over the bits of a pattern that is not empty.
template <unsigned Pattern, class A, class B>
inline auto sparse_dot(const A* a, const B* b) noexcept {
    constexpr int k = lowest_bit(Pattern);
    if constexpr ((Pattern & (Pattern - 1U)) == 0) {
        return a[k] * b[k];
    } else {
        return a[k] * b[k] + sparse_dot<(Pattern & (Pattern - 1U))>(a, b);
    }
}

/// Returns row k of the section matrix, addressed by strain: entries outside its block are not
/// there.
template <int Row, class T>
inline const T* stiffness_row(const SectionMatrix<T>& C) noexcept {
    if constexpr (Row < 6) {
        return C.axial[Row];
    } else if constexpr (Row < 9) {
        return C.shear_y[Row - 6];
    } else {
        return C.shear_z[Row - 9];
    }
}

/// The first strain of the block of strain k.
constexpr int block_start(int k) noexcept { return lowest_bit(block_of(k)); }

/// Writes f = C e for the strains of a pattern.
template <unsigned Pattern, int Row = 0, class T, class S>
inline void stress(const SectionMatrix<T>& C, const S* e, S* f) noexcept {
    if constexpr (Row < strain_count) {
        constexpr unsigned row_pattern = Pattern & block_of(Row);
        if constexpr (row_pattern != 0) {
            constexpr int start = block_start(Row);
            f[Row] = sparse_dot<(row_pattern >> start)>(stiffness_row<Row>(C), e + start);
        }
        stress<Pattern, Row + 1>(C, e, f);
    }
}

/// Writes U_i = sum_k J[i][k] sigma[k], the gradient of the energy with respect to the invariants.
template <class Measure, int I = 0, class S>
inline void energy_gradient(const StrainJacobian<S>& J, const S* sigma, S* U) noexcept {
    if constexpr (I < invariant_count) {
        U[I] = sparse_dot<Measure::pattern[I]>(J[I], sigma);
        energy_gradient<Measure, I + 1>(J, sigma, U);
    }
}

/// Writes D[i][j] = J[i] . f for i <= j, where f = C J[j].
template <class Measure, int Column, int I = 0, class S>
inline void hessian_column(const StrainJacobian<S>& J, const S* f,
                           InvariantHessian<S>& D) noexcept {
    if constexpr (I <= Column) {
        constexpr unsigned pattern = Measure::pattern[I] & block_closure(Measure::pattern[Column]);
        if constexpr (pattern != 0) {
            D[I][Column] = sparse_dot<pattern>(J[I], f);
        } else {
            D[I][Column] = S(0.0);
        }
        hessian_column<Measure, Column, I + 1>(J, f, D);
    }
}

/// Writes the upper triangle of D = J C J^T, the material part of the Hessian with respect to the
/// invariants.
template <class Measure, int Column = 0, class T, class S>
inline void material_hessian(const StrainJacobian<S>& J, const SectionMatrix<T>& C,
                             InvariantHessian<S>& D) noexcept {
    if constexpr (Column < invariant_count) {
        S f[strain_count];
        stress<Measure::pattern[Column]>(C, J[Column], f);
        hessian_column<Measure, Column>(J, f, D);
        material_hessian<Measure, Column + 1>(J, C, D);
    }
}

}  // namespace ancf::detail
