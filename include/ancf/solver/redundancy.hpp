// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Which equations of constraints follow from others or from supports.

#pragma once

#include <ancf/assembly/numbering.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/constraint.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/solver/convergence.hpp>
#include <ancf/types.hpp>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace ancf::detail {

/// An entry of a row of a sparse triangular factor.
struct RowEntry {
    int column;
    double value;
};

/// Such a row, columns ascending.
using SparseRow = List<RowEntry>;

inline void drop_first(SparseRow& row) {
    SparseRow rest;
    for (std::size_t k = 1; k < row.size(); ++k) rest.push_back(row[k]);
    row = std::move(rest);
}

/// Rotates two rows that begin in the same column so that the second one loses it.
inline void rotate(SparseRow& upper, SparseRow& lower) {
    const double length = std::hypot(upper[0].value, lower[0].value);
    const double c = upper[0].value / length, s = lower[0].value / length;
    SparseRow turned, rest;
    const RowEntry *a = upper.begin(), *b = lower.begin();
    while (a != upper.end() || b != lower.end()) {
        const bool both = a != upper.end() && b != lower.end();
        const bool from_upper = both ? a->column <= b->column : a != upper.end();
        const bool from_lower = both ? b->column <= a->column : b != lower.end();
        const int column = from_upper ? a->column : b->column;
        const double u = from_upper ? (a++)->value : 0.0, l = from_lower ? (b++)->value : 0.0;
        turned.push_back({column, c * u + s * l});
        if (turned.size() > 1) rest.push_back({column, c * l - s * u});
    }
    upper = std::move(turned);
    lower = std::move(rest);
}

/// Turns a row into a triangular factor whose row j, where there is one, begins in column j.
inline void insert(List<SparseRow>& factor, SparseRow& row) {
    while (!row.empty()) {
        SparseRow& upper = factor[row[0].column];
        if (upper.empty()) {
            upper = std::move(row);  // exchanges them
        } else if (row[0].value == 0.0) {
            drop_first(row);
        } else {
            rotate(upper, row);
        }
    }
}

/// Returns the rows of G that depend on the rows before them, ascending.
///
/// Each row is measured with the coordinates scaled and against its own length: a row is dependent
/// when what remains of it off the span of the earlier ones is not longer than the tolerance,
/// relative. The triangle of G^T = Q R is built by rotations, without Q (George and Heath, Linear
/// Algebra and its Applications 34, 1980); where its diagonal vanishes, the rest of that row goes
/// back into it.
/// @param matrix     compressed; G^T stands in its first rows, from column `first` on.
/// @param scales     sizes of the coordinates, one for each row of G^T, positive.
/// @param tolerance  from 0 to 1.
[[nodiscard]] inline List<int> dependent_rows(const SparseMatrix& matrix, int first,
                                              const VectorX& scales, double tolerance) {
    const auto equations = static_cast<int>(matrix.cols()) - first;
    const int *const start = matrix.outerIndexPtr() + first, *const row = matrix.innerIndexPtr();
    List<SparseRow> coordinates(static_cast<std::size_t>(scales.size()));
    for (int j = 0; j < equations; ++j) {
        double square = 0.0;
        for (int k = start[j]; k < start[j + 1] && row[k] < scales.size(); ++k)
            square += std::pow(matrix.valuePtr()[k] * scales[row[k]], 2);
        for (int k = start[j]; k < start[j + 1] && row[k] < scales.size(); ++k)
            if (const double value = matrix.valuePtr()[k]; value != 0.0)
                coordinates[row[k]].push_back({j, value * scales[row[k]] / std::sqrt(square)});
    }
    // in the order of their first equations: a row then ends soon in an empty row of the factor
    List<SparseRow> factor(static_cast<std::size_t>(equations));
    for (int j = 0; j < equations; ++j)
        for (int k = start[j]; k < start[j + 1] && row[k] < scales.size(); ++k)
            if (SparseRow& own = coordinates[row[k]]; !own.empty() && own[0].column == j)
                insert(factor, own);
    List<int> dependent;
    for (int j = 0; j < equations; ++j) {
        if (!factor[j].empty() && std::abs(factor[j][0].value) > tolerance) continue;
        dependent.push_back(j);
        SparseRow rest = std::move(factor[j]);
        if (rest.empty()) continue;
        drop_first(rest);
        insert(factor, rest);
    }
    return dependent;
}

/// Returns an equation in words: the constraint, its name, and which of its equations it is.
[[nodiscard]] inline std::string describe_equation(const List<AnyConstraint>& constraints,
                                                   int equation) {
    std::size_t k = 0;
    for (; equation >= constraints[k].equations(); ++k) equation -= constraints[k].equations();
    return joined({"constraint ", k, " (", constraints[k].name(), "), equation ", equation});
}

/// Returns in words which constraints of a scene follow from others or from supports, by the G in
/// its tangent; empty where none does, and for more than 200 equations: where these come in any
/// order the comparison may take longer than all else.
[[nodiscard]] inline std::string repeated_constraints(const Scene& model,
                                                      const Numbering& numbering,
                                                      const SparseMatrix& tangent) {
    const int free = numbering.free_coordinates();
    if (numbering.multipliers() == 0 || numbering.multipliers() > 200) return {};
    const Layout& layout = model.layout();
    const double diagonal = diagonal_of(layout, model.dimension(), model.state().q, nullptr);
    const double length = diagonal > 0.0 && std::isfinite(diagonal) ? diagonal : 1.0;
    const VectorX scales = length_powers(length, layout, numbering);
    std::string text;
    constexpr double tolerance = 1e-10;  // as ProblemOptions::redundancy_tolerance
    for (const int row : dependent_rows(tangent, free, scales, tolerance)) {
        text += text.empty() ? "constraints repeat each other or a support: " : "; ";
        text += describe_equation(model.constraints(), row);
    }
    return text;
}

}  // namespace ancf::detail
