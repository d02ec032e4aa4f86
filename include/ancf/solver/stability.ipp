// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Stability: definitions.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/assembly/assembly.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/solver/conditioning.hpp>
#include <ancf/solver/sparse_ldlt.hpp>
#include <ancf/solver/stability.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace ancf {

namespace detail {

/// Appends the lower half of the stiffness of constraints as springs, each far stiffer than what
/// it holds.
/// @param tangent   of full storage: its last columns hold the constraints' gradients
/// @param diagonal  of the tangent; grows with the springs
/// @return false where one of them holds nothing of positive stiffness.
ANCF_INLINE bool add_springs(const SparseMatrix& tangent, VectorX& diagonal,
                             Records<MatrixEntry>& entries) {
    constexpr double stiffness = 1e4;  // of a spring, to that of what it holds
    const VectorX held = diagonal;
    const int* const row = tangent.innerIndexPtr();
    const double* const g = tangent.valuePtr();
    const auto counts = [&](int k) { return row[k] < held.size() && g[k] != 0.0; };
    for (auto column = static_cast<int>(held.size()); column < tangent.cols(); ++column) {
        const int first = tangent.outerIndexPtr()[column];
        const int last = tangent.outerIndexPtr()[column + 1];
        double flexibility = 0.0;
        for (int k = first; k < last; ++k)
            if (counts(k) && held[row[k]] > 0.0) flexibility += g[k] * g[k] / held[row[k]];
        if (!(flexibility > 0.0)) return false;
        const double spring = stiffness / flexibility;
        for (int a = first; a < last; ++a)
            for (int b = first; counts(a) && b <= a; ++b) {
                if (!counts(b)) continue;
                const double value = spring * g[a] * g[b];
                entries.push_back({row[a], row[b], value});
                if (a == b) diagonal[row[a]] += value;
            }
    }
    return true;
}

/// Tells whether the energy of the softest displacement, of either sign, is more than round-off.
/// @param lower  half of the stiffness, with its diagonal and its factors
ANCF_INLINE bool resists(const SparseMatrix& lower, const VectorX& diagonal,
                         const SparseLdlt& factor) {
    constexpr int inverse_iterations = 3;
    const auto size = static_cast<int>(diagonal.size());
    VectorX x = unit_scales(lower);
    for (int k = 0; k < size; ++k) x[k] *= probe_weight(k);
    for (int sweep = 0; sweep < inverse_iterations; ++sweep) {
        for (int k = 0; k < size; ++k) x[k] *= std::abs(diagonal[k]);
        factor.solve(x);
        double square = 0.0;
        for (int k = 0; k < size; ++k) square += x[k] * x[k] * std::abs(diagonal[k]);
        for (int k = 0; k < size; ++k) x[k] /= std::sqrt(square);
    }
    double energy = 0.0, terms = 0.0;
    for (int j = 0; j < size; ++j)
        for (int k = lower.outerIndexPtr()[j]; k < lower.outerIndexPtr()[j + 1]; ++k) {
            const int i = lower.innerIndexPtr()[k];
            const double term = (i == j ? 1.0 : 2.0) * x[i] * lower.valuePtr()[k] * x[j];
            energy += term;
            terms += std::abs(term);
        }
    return std::abs(energy) > 16.0 * std::numeric_limits<double>::epsilon() * terms;
}

/// Returns the node of every free coordinate.
[[nodiscard]] ANCF_INLINE std::vector<int> free_blocks(const Numbering& numbering) {
    std::vector<int> blocks(static_cast<std::size_t>(numbering.free_coordinates()));
    for (int k = 0; k < numbering.coordinates(); ++k)
        if (const int equation = numbering.equation(k); equation >= 0)
            blocks[static_cast<std::size_t>(equation)] = numbering.block(k);
    return blocks;
}

/// Factorises the symmetric part of an assembly's tangent as L D L^T, constraints as springs.
[[nodiscard]] ANCF_INLINE Stability stability_of_tangent(const Assembly& assembly, bool symmetric) {
    constexpr double round_off = 1e-14;  // of a pivot, to the diagonal it comes from
    const SparseMatrix& tangent = assembly.tangent();
    const int free = assembly.numbering().free_coordinates();
    VectorX diagonal = zeros(free);
    Records<MatrixEntry> entries;
    entries.reserve(static_cast<std::size_t>(detail::entries(tangent)));
    for (int column = 0; column < free; ++column)
        for (int k = tangent.outerIndexPtr()[column]; k < tangent.outerIndexPtr()[column + 1];
             ++k) {
            const int row = tangent.innerIndexPtr()[k];
            const double own = tangent.valuePtr()[k];
            if (!std::isfinite(own)) return Stability::unknown;
            if (row < column || row >= free) continue;
            const double value = symmetric ? own : 0.5 * (own + tangent.coeff(column, row));
            entries.push_back({row, column, value});
            if (row == column) diagonal[column] = value;
        }
    if (free == 0) return Stability::stable;
    if (!add_springs(tangent, diagonal, entries)) return Stability::unknown;
    const SparseMatrix lower = compressed(free, entries);
    SparseLdlt factor;
    if (!factor.factorize(lower, free_blocks(assembly.numbering()))) return Stability::unknown;
    bool positive = true;
    for (int k = 0; k < free; ++k) {
        if (!(std::abs(factor.pivot(k)) > round_off * std::abs(diagonal[k])))
            return Stability::unknown;
        positive = positive && factor.pivot(k) > 0.0;
    }
    if (!resists(lower, diagonal, factor)) return Stability::unknown;
    if (positive) return Stability::stable;
    return symmetric ? Stability::unstable : Stability::unknown;
}

}  // namespace detail

ANCF_INLINE Stability stability(const Assembly& assembly, const FactorReport& counted) {
    constexpr double well_conditioned = 1e-10;
    const auto& loads = assembly.model().loads();
    const bool symmetric = std::all_of(
        loads.begin(), loads.end(), [](const ScaledLoad& load) { return load.load.symmetric(); });
    if (!symmetric || counted.negative_pivots < 0 || !(counted.rcond > well_conditioned))
        return detail::stability_of_tangent(assembly, symmetric);
    return counted.negative_pivots > assembly.numbering().multipliers() ? Stability::unstable
                                                                        : Stability::stable;
}

}  // namespace ancf
