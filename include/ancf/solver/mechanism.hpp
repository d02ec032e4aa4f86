// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Why a tangent is singular: which vector of which node moves without stiffness.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/assembly/numbering.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/solver/redundancy.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace ancf::detail {

/// Returns the coordinate of each equation that is no constraint's.
[[nodiscard]] inline List<int> free_coordinates(const Numbering& numbering) {
    List<int> all;
    for (int k = 0; k < numbering.coordinates(); ++k)
        if (numbering.equation(k) >= 0) all.push_back(k);
    return all;
}

/// Returns the places of the diagonal entries among the values of a compressed matrix; -1: none.
[[nodiscard]] inline List<int> diagonal_places(const SparseMatrix& matrix) {
    List<int> places(static_cast<std::size_t>(matrix.cols()), -1);
    for (int j = 0; j < matrix.cols(); ++j)
        for (int k = matrix.outerIndexPtr()[j]; k < matrix.outerIndexPtr()[j + 1]; ++k)
            if (matrix.innerIndexPtr()[k] == j) places[j] = k;
    return places;
}

/// Adds springs to the diagonal, a part of the stiffest entry of the same unit; returns them.
[[nodiscard]] inline VectorX free_springs(const Layout& layout, const List<int>& all, double part,
                                          SparseMatrix& matrix) {
    const List<int> places = diagonal_places(matrix);
    double* const values = matrix.valuePtr();
    double stiffest[3] = {0.0, 0.0, 0.0};
    const auto unit_of = [&](std::size_t e) { return length_power(layout.field_of(all[e])) + 1; };
    for (std::size_t e = 0; e < all.size(); ++e) {
        double& most = stiffest[unit_of(e)];
        if (places[e] >= 0) most = std::max(most, std::abs(values[places[e]]));
    }
    VectorX springs = VectorX::Zero(matrix.cols());
    for (std::size_t e = 0; e < all.size(); ++e) {
        const double unit = stiffest[unit_of(e)];
        springs[e] = unit > 0.0 ? part * unit : part;
        if (places[e] >= 0) values[places[e]] += springs[e];
    }
    return springs;
}

/// Finds the softest mode of a matrix with springs, factorised by the solver, by inverse iteration.
/// @param mode  the start, and the result of unit spring energy.
/// @return      the springs' part in the mode's energy: 1 where nothing else resists it.
[[nodiscard]] inline double softest_mode(const LinearSolver& solver, const VectorX& springs,
                                         VectorX& mode) {
    double quotient = 0.0;
    VectorX image = mode, next;
    for (int sweep = 0; sweep < 5; ++sweep) {
        for (Eigen::Index k = 0; k < mode.size(); ++k) image[k] = springs[k] * mode[k];
        solve_with(solver, image, next);
        double before = 0.0, work = 0.0, after = 0.0;
        for (Eigen::Index k = 0; k < mode.size(); ++k) {
            before += mode[k] * image[k];
            work += image[k] * next[k];
            after += springs[k] * next[k] * next[k];
        }
        quotient = work / before;
        for (Eigen::Index k = 0; k < mode.size(); ++k) mode[k] = next[k] / std::sqrt(after);
    }
    return quotient;
}

/// Returns in words why a tangent cannot be factorised; empty where that does not show.
///
/// Weak springs at every coordinate make a tangent regular whose singular motions no constraint
/// holds; the softest one is then sought. Where constraints repeat each other springs do not help.
/// @param solver  analysed for the matrix; it is left with another factorisation.
[[nodiscard]] inline std::string singular_cause(const Scene& model, const Numbering& numbering,
                                                const SparseMatrix& tangent, LinearSolver& solver) {
    if (!all_finite(tangent)) return "";
    std::string repeated = repeated_constraints(model, numbering, tangent);
    if (!repeated.empty()) return repeated;
    const Layout& layout = model.layout();
    const List<int> all = free_coordinates(numbering);
    for (const double part : {1e-12, 1e-9, 1e-6}) {
        SparseMatrix firm = copied(tangent);
        const VectorX springs = free_springs(layout, all, part, firm);
        if (solver.factorize(firm).status != Status::converged) continue;
        VectorX mode = VectorX::Zero(numbering.unknowns());
        for (std::size_t e = 0; e < all.size(); ++e)  // a mixture that repeats bit for bit
            mode[e] = std::cos(static_cast<double>(e * e)) / std::sqrt(springs[e]);
        if (!(softest_mode(solver, springs, mode) > 0.5)) return "";
        const auto energy = [&](int k) {
            const int e = numbering.equation(k);
            return springs[e] * mode[e] * mode[e];
        };
        const int most = *std::max_element(all.begin(), all.end(),
                                           [&](int a, int b) { return energy(a) < energy(b); });
        const int node = layout.node_of(most);
        const char* const axes[] = {"x", "y", "z"};
        return joined({"a motion without stiffness moves ", to_string(layout.field_of(most)),
                       " of node ", node, " most, along ",
                       axes[(most - layout.first(node)) % layout.dimension()]});
    }
    return numbering.multipliers() > 0 ? "constraints repeat each other or a support" : "";
}

}  // namespace ancf::detail
