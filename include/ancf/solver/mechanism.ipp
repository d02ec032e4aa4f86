// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// singular_cause: definitions.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/error.hpp>
#include <ancf/solver/mechanism.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ancf::detail {

/// A component of a nodal vector that is an unknown.
struct FreeComponent {
    int equation, node;
    Field field;
    int component;
};

[[nodiscard]] ANCF_INLINE Records<FreeComponent> free_components(const Layout& layout,
                                                                 const Numbering& numbering) {
    Records<FreeComponent> all;
    for (int node = 0; node < layout.nodes(); ++node)
        for (int k = 0; k < field_count; ++k) {
            const auto field = static_cast<Field>(k);
            const int first = layout.index({{node}, field});
            for (int i = 0; first >= 0 && i < layout.dimension(); ++i)
                if (const int equation = numbering.equation(first + i); equation >= 0)
                    all.push_back({equation, node, field, i});
        }
    return all;
}

ANCF_INLINE std::vector<int> diagonal_places(const SparseMatrix& matrix) {
    std::vector<int> places(static_cast<std::size_t>(matrix.cols()), -1);
    for (int j = 0; j < matrix.cols(); ++j)
        for (int k = matrix.outerIndexPtr()[j]; k < matrix.outerIndexPtr()[j + 1]; ++k)
            if (matrix.innerIndexPtr()[k] == j) places[j] = k;
    return places;
}

/// Adds springs to the diagonal, a part of the stiffest entry of the same unit; returns them.
[[nodiscard]] ANCF_INLINE VectorX free_springs(const Records<FreeComponent>& all, double part,
                                               SparseMatrix& matrix) {
    const std::vector<int> places = diagonal_places(matrix);
    const auto entry = [&](const FreeComponent& c) { return places[c.equation]; };
    double stiffest[3] = {0.0, 0.0, 0.0};
    const auto unit_of = [](const FreeComponent& c) { return length_power(c.field) + 1; };
    for (const FreeComponent& c : all) {
        double& most = stiffest[unit_of(c)];
        if (entry(c) >= 0) most = std::max(most, std::abs(matrix.valuePtr()[entry(c)]));
    }
    VectorX springs = VectorX::Zero(matrix.cols());
    for (const FreeComponent& c : all) {
        const double unit = stiffest[unit_of(c)];
        springs[c.equation] = unit > 0.0 ? part * unit : part;
        if (entry(c) >= 0) matrix.valuePtr()[entry(c)] += springs[c.equation];
    }
    return springs;
}

/// Finds the softest mode of a matrix with springs, factorised by the solver, by inverse iteration.
/// @param mode  the start, and the result of unit spring energy.
/// @return      the springs' part in the mode's energy: 1 where nothing else resists it.
[[nodiscard]] ANCF_INLINE double softest_mode(const LinearSolver& solver, const VectorX& springs,
                                              VectorX& mode) {
    double quotient = 0.0;
    VectorX image = mode, next;
    for (int sweep = 0; sweep < 5; ++sweep) {
        for (Eigen::Index k = 0; k < mode.size(); ++k) image[k] = springs[k] * mode[k];
        solver.solve(image, next);
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

ANCF_INLINE std::string singular_cause(const Layout& layout, const Numbering& numbering,
                                       const SparseMatrix& tangent, LinearSolver& solver) {
    if (!all_finite(tangent)) return "";
    const Records<FreeComponent> all = free_components(layout, numbering);
    for (const double part : {1e-12, 1e-9, 1e-6}) {
        SparseMatrix firm = copied(tangent);
        const VectorX springs = free_springs(all, part, firm);
        if (solver.factorize(firm).status != Status::converged) continue;
        VectorX mode = VectorX::Zero(numbering.unknowns());
        for (std::size_t k = 0; k < all.size(); ++k)  // a mixture that repeats bit for bit
            mode[all[k].equation] =
                std::cos(static_cast<double>(k * k)) / std::sqrt(springs[all[k].equation]);
        if (!(softest_mode(solver, springs, mode) > 0.5)) return "";
        const auto energy = [&](const FreeComponent& c) {
            return springs[c.equation] * mode[c.equation] * mode[c.equation];
        };
        const FreeComponent most = *std::max_element(
            all.begin(), all.end(),
            [&](const FreeComponent& a, const FreeComponent& b) { return energy(a) < energy(b); });
        const char* const axes[] = {"x", "y", "z"};
        return joined({"a motion without stiffness moves ", to_string(most.field), " of node ",
                       most.node, " most, along ", axes[most.component]});
    }
    return numbering.multipliers() > 0 ? "constraints repeat each other or a support" : "";
}

}  // namespace ancf::detail
