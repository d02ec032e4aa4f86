// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Why a tangent is singular: which vector of which node moves without stiffness.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/assembly/numbering.hpp>
#include <ancf/element/fields.hpp>
#include <ancf/error.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace ancf::detail {

/// A component of a nodal vector that is an unknown.
struct FreeComponent {
    int equation, node;
    Field field;
    int component;
};

[[nodiscard]] inline std::vector<FreeComponent> free_components(const Layout& layout,
                                                                const Numbering& numbering,
                                                                int dimension) {
    std::vector<FreeComponent> all;
    for (int node = 0; node < layout.nodes(); ++node)
        for (int k = 0; k < field_count; ++k) {
            const auto field = static_cast<Field>(k);
            const int first = layout.index({{node}, field});
            for (int i = 0; first >= 0 && i < dimension; ++i)
                if (const int equation = numbering.equation(first + i); equation >= 0)
                    all.push_back({equation, node, field, i});
        }
    return all;
}

/// Returns the place of a diagonal entry among the values of a compressed matrix; -1: none.
[[nodiscard]] inline int diagonal_place(const SparseMatrix& matrix, int column) {
    for (int k = matrix.outerIndexPtr()[column]; k < matrix.outerIndexPtr()[column + 1]; ++k)
        if (matrix.innerIndexPtr()[k] == column) return k;
    return -1;
}

/// Returns in words why a tangent cannot be factorised; empty where that does not show.
///
/// Weak springs at every coordinate make a tangent regular whose singular motions no constraint
/// holds; inverse iteration then finds the softest one. Where springs do not help, constraints
/// repeat each other.
/// @param solver  analysed for the matrix; it is left with another factorisation.
template <class LinearSolver>
[[nodiscard]] std::string singular_cause(const Layout& layout, const Numbering& numbering,
                                         int dimension, const SparseMatrix& tangent,
                                         LinearSolver& solver) {
    if (!all_finite(tangent)) return "";
    const std::vector<FreeComponent> all = free_components(layout, numbering, dimension);
    double stiffest[3] = {0.0, 0.0, 0.0};  // of each unit
    const auto unit_of = [](const FreeComponent& c) { return length_power(c.field) + 1; };
    for (const FreeComponent& c : all)
        if (const int place = diagonal_place(tangent, c.equation); place >= 0)
            stiffest[unit_of(c)] =
                std::max(stiffest[unit_of(c)], std::abs(tangent.valuePtr()[place]));
    for (const double part : {1e-12, 1e-9, 1e-6}) {
        SparseMatrix firm = tangent;
        VectorX spring = VectorX::Zero(numbering.unknowns());
        for (const FreeComponent& c : all) {
            const double unit = stiffest[unit_of(c)];
            spring[c.equation] = unit > 0.0 ? part * unit : part;
            if (const int place = diagonal_place(firm, c.equation); place >= 0)
                firm.valuePtr()[place] += spring[c.equation];
        }
        if (solver.factorize(firm).status != Status::converged) continue;
        VectorX mode = VectorX::Zero(numbering.unknowns()), image, next;
        for (std::size_t k = 0; k < all.size(); ++k)
            mode[all[k].equation] = std::cos(static_cast<double>(k * k));
        const auto weighted = [&](const VectorX& x) {
            VectorX product = spring;
            for (Eigen::Index k = 0; k < x.size(); ++k) product[k] *= x[k];
            return product;
        };
        double quotient = 0.0;  // of spring energy in the whole: 1 without any stiffness
        for (int sweep = 0; sweep < 5; ++sweep) {
            image = weighted(mode);
            solver.solve(image, next);
            if (!next.allFinite()) return "";
            const VectorX after = weighted(next);
            quotient = image.dot(next) / mode.dot(image);
            mode = next / std::sqrt(after.dot(next));
        }
        if (!(quotient > 0.5)) return "";
        const auto size = [&](const FreeComponent& c) {
            return std::sqrt(spring[c.equation]) * std::abs(mode[c.equation]);
        };
        const FreeComponent most = *std::max_element(
            all.begin(), all.end(),
            [&](const FreeComponent& a, const FreeComponent& b) { return size(a) < size(b); });
        const char* const names[] = {"x", "y", "z"};
        return joined({"a motion without stiffness moves ", to_string(most.field), " of node ",
                       most.node, " most, along ", names[most.component]});
    }
    return numbering.multipliers() > 0 ? "constraints repeat each other or a support" : "";
}

}  // namespace ancf::detail
