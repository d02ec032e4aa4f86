// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Whether an equilibrium is stable: docs/theory-statics.md, "Stability".

#pragma once

#include <ancf/assembly/assembly.hpp>
#include <ancf/model/model.hpp>
#include <ancf/types.hpp>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

namespace ancf {

/// What the second variation of the energy says of an equilibrium.
enum class Stability {
    unknown,  ///< loads without a potential decide, or too close to a critical point to tell
    stable,   ///< positive for all displacements that supports and constraints allow
    unstable  ///< negative for one: a bifurcation or limit point was passed, or the mesh has a
              ///< branch of its own
};

/// The word that tables print.
[[nodiscard]] constexpr std::string_view to_string(Stability stability) noexcept {
    switch (stability) {
        case Stability::stable: return "stable";
        case Stability::unstable: return "unstable";
        case Stability::unknown: break;
    }
    return "unknown";
}

namespace detail {

/// Factorises the symmetric part of an assembly's tangent as L D L^T, each zero diagonal of a
/// multiplier replaced by -delta: with that elastic constraint it has one negative pivot for each
/// multiplier, and one for each direction of instability.
template <class Scene>
[[nodiscard]] Stability stability_of_tangent(const Assembly<Scene>& assembly, bool symmetric) {
    constexpr double stiffness = 1e6;    // of an elastic constraint, to that of what it holds
    constexpr double round_off = 1e-14;  // of a pivot, to the diagonal it comes from
    const SparseMatrix& tangent = assembly.tangent();
    const int free = assembly.numbering().free_coordinates();
    const int multipliers = assembly.numbering().multipliers();
    VectorX diagonal = VectorX::Zero(tangent.cols());
    VectorX flexibility = VectorX::Zero(multipliers);  // of what each constraint holds
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(tangent.nonZeros()));
    for (int column = 0; column < free; ++column) {
        diagonal[column] = tangent.coeff(column, column);
        for (SparseMatrix::InnerIterator entry(tangent, column); entry; ++entry) {
            const auto row = static_cast<int>(entry.row());
            if (row < column) continue;
            if (!std::isfinite(entry.value())) return Stability::unknown;
            const double value = symmetric || row >= free
                                     ? entry.value()
                                     : 0.5 * (entry.value() + tangent.coeff(column, row));
            entries.emplace_back(row, column, value);
            if (row >= free && diagonal[column] > 0.0)
                flexibility[row - free] += entry.value() * entry.value() / diagonal[column];
        }
    }
    for (int k = 0; k < multipliers; ++k) {
        if (!(flexibility[k] > 0.0)) return Stability::unknown;
        diagonal[free + k] = -flexibility[k] / stiffness;
        entries.emplace_back(free + k, free + k, diagonal[free + k]);
    }
    SparseMatrix lower(tangent.rows(), tangent.cols());
    lower.setFromTriplets(entries.begin(), entries.end());
    if (lower.cols() == 0) return Stability::stable;
    const Eigen::SimplicialLDLT<SparseMatrix> factor(lower);
    if (factor.info() != Eigen::Success) return Stability::unknown;
    const VectorX pivots = factor.vectorD();
    int negative = 0;
    for (int k = 0; k < pivots.size(); ++k) {
        const double whole = diagonal[factor.permutationPinv().indices()[k]];
        if (!(std::abs(pivots[k]) > round_off * std::abs(whole))) return Stability::unknown;
        negative += pivots[k] < 0.0 ? 1 : 0;
    }
    if (negative <= multipliers) return Stability::stable;
    return symmetric ? Stability::unstable : Stability::unknown;
}

}  // namespace detail

/// Judges the state of an assembly's last evaluation, with its tangent, by the inertia of that
/// tangent.
///
/// Under loads without a potential the symmetric part decides one way: where it is positive, the
/// state is stable against any static disturbance.
/// @param negative_pivots  what a solver counted in it (FactorReport); -1: one more factorisation
template <class Scene>
[[nodiscard]] Stability stability(const Assembly<Scene>& assembly, int negative_pivots = -1) {
    const auto& loads = assembly.model().loads();
    const bool symmetric = std::all_of(
        loads.begin(), loads.end(), [](const ScaledLoad& load) { return load.load.symmetric(); });
    if (!symmetric || negative_pivots < 0) return detail::stability_of_tangent(assembly, symmetric);
    return negative_pivots > assembly.numbering().multipliers() ? Stability::unstable
                                                                : Stability::stable;
}

}  // namespace ancf
