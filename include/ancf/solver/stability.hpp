// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Whether an equilibrium is stable: docs/theory-statics.md, "Stability".

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/assembly/assembly.hpp>
#include <ancf/model/model.hpp>
#include <ancf/solver/conditioning.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

namespace ancf {

/// What the second variation of the energy says of an equilibrium.
enum class Stability {
    unknown,  ///< not judged; or loads without a potential decide, or the state is too close to a
              ///< critical point to tell
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

/// One entry of a constraint's gradient.
struct GradientEntry {
    int column;
    double value;
};

/// Appends the lower half of the stiffness of constraints as springs, each far stiffer than what
/// it holds.
/// @param diagonal  of the tangent; grows with the springs
/// @return false where one of them holds nothing of positive stiffness.
inline bool add_springs(const std::vector<std::vector<GradientEntry>>& gradients, VectorX& diagonal,
                        std::vector<Eigen::Triplet<double>>& entries) {
    constexpr double stiffness = 1e4;  // of a spring, to that of what it holds
    const VectorX held = diagonal;
    for (const auto& gradient : gradients) {
        double flexibility = 0.0;
        for (const GradientEntry& g : gradient)
            if (held[g.column] > 0.0) flexibility += g.value * g.value / held[g.column];
        if (!(flexibility > 0.0)) return false;
        const double spring = stiffness / flexibility;
        for (const GradientEntry& a : gradient)
            for (const GradientEntry& b : gradient) {
                if (b.column > a.column) continue;
                const double value = spring * a.value * b.value;
                entries.emplace_back(a.column, b.column, value);
                if (a.column == b.column) diagonal[a.column] += value;
            }
    }
    return true;
}

/// Tells whether the energy of the softest displacement, of either sign, is more than round-off.
/// @param lower  half of the stiffness, with its diagonal and its factors
inline bool resists(const SparseMatrix& lower, const VectorX& diagonal,
                    const Eigen::SimplicialLDLT<SparseMatrix>& factor) {
    constexpr int inverse_iterations = 3;
    VectorX x = unit_scales(lower);
    for (Eigen::Index k = 0; k < x.size(); ++k) x[k] *= probe_weight(k);
    for (int k = 0; k < inverse_iterations; ++k) {
        const VectorX next = factor.solve(diagonal.cwiseAbs().cwiseProduct(x));
        x = next / std::sqrt(next.cwiseAbs2().dot(diagonal.cwiseAbs()));
    }
    const VectorX magnitudes = x.cwiseAbs();
    const SparseMatrix stiffness = lower.cwiseAbs();
    const double energy = std::abs(x.dot(multiply(lower, Storage::lower, x)));
    const double terms = magnitudes.dot(multiply(stiffness, Storage::lower, magnitudes));
    return energy > 16.0 * std::numeric_limits<double>::epsilon() * terms;
}

/// Factorises the symmetric part of an assembly's tangent as L D L^T, constraints as springs.
template <class Scene>
[[nodiscard]] Stability stability_of_tangent(const Assembly<Scene>& assembly, bool symmetric) {
    constexpr double round_off = 1e-14;  // of a pivot, to the diagonal it comes from
    const SparseMatrix& tangent = assembly.tangent();
    const int free = assembly.numbering().free_coordinates();
    VectorX diagonal = VectorX::Zero(free);
    std::vector<std::vector<GradientEntry>> gradients(
        static_cast<std::size_t>(assembly.numbering().multipliers()));
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(tangent.nonZeros()));
    for (int column = 0; column < free; ++column)
        for (SparseMatrix::InnerIterator entry(tangent, column); entry; ++entry) {
            const auto row = static_cast<int>(entry.row());
            if (!std::isfinite(entry.value())) return Stability::unknown;
            if (row >= free && entry.value() != 0.0)
                gradients[static_cast<std::size_t>(row - free)].push_back({column, entry.value()});
            if (row < column || row >= free) continue;
            const double value =
                symmetric ? entry.value() : 0.5 * (entry.value() + tangent.coeff(column, row));
            entries.emplace_back(row, column, value);
            if (row == column) diagonal[column] = value;
        }
    if (free == 0) return Stability::stable;
    if (!add_springs(gradients, diagonal, entries)) return Stability::unknown;
    SparseMatrix lower(free, free);
    lower.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<SparseMatrix> factor(lower);
    if (factor.info() != Eigen::Success) return Stability::unknown;
    const VectorX pivots = factor.vectorD();
    for (int k = 0; k < free; ++k) {
        const double whole = diagonal[factor.permutationPinv().indices()[k]];
        if (!(std::abs(pivots[k]) > round_off * std::abs(whole))) return Stability::unknown;
    }
    if (!resists(lower, diagonal, factor)) return Stability::unknown;
    if ((pivots.array() > 0.0).all()) return Stability::stable;
    return symmetric ? Stability::unstable : Stability::unknown;
}

}  // namespace detail

/// Judges the state of an assembly's last evaluation, with its tangent, by the signs of its pivots.
///
/// Under loads without a potential the symmetric part decides one way: where it is positive, the
/// state is stable against any static disturbance.
/// @param counted  the factorisation of that tangent, of which a count of negative pivots serves
///                 where it is well conditioned; without it, one more factorisation
template <class Scene>
[[nodiscard]] Stability stability(const Assembly<Scene>& assembly,
                                  const FactorReport& counted = {}) {
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
