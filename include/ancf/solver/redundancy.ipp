// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/error.hpp>
#include <ancf/solver/convergence.hpp>
#include <ancf/solver/redundancy.hpp>

#include <cmath>
#include <cstddef>
#include <utility>

namespace ancf::detail {

/// A row of a sparse triangular factor, columns ascending.
struct SparseRow {
    std::vector<int> columns;
    std::vector<double> values;
};

/// Rotates two rows that begin in the same column so that the second one loses it.
ANCF_INLINE void rotate(SparseRow& upper, SparseRow& lower) {
    const double length = std::hypot(upper.values[0], lower.values[0]);
    const double c = upper.values[0] / length, s = lower.values[0] / length;
    SparseRow turned, rest;
    std::size_t i = 0, j = 0;
    while (i < upper.columns.size() || j < lower.columns.size()) {
        const bool from_upper = j == lower.columns.size() ||
                                (i < upper.columns.size() && upper.columns[i] <= lower.columns[j]);
        const bool from_lower = i == upper.columns.size() ||
                                (j < lower.columns.size() && lower.columns[j] <= upper.columns[i]);
        const int column = from_upper ? upper.columns[i] : lower.columns[j];
        const double a = from_upper ? upper.values[i++] : 0.0;
        const double b = from_lower ? lower.values[j++] : 0.0;
        turned.columns.push_back(column);
        turned.values.push_back(c * a + s * b);
        if (turned.columns.size() == 1) continue;
        rest.columns.push_back(column);
        rest.values.push_back(c * b - s * a);
    }
    std::swap(upper, turned);
    std::swap(lower, rest);
}

/// Turns a row into a triangular factor whose row j, where there is one, begins in column j.
ANCF_INLINE void insert(std::vector<SparseRow>& factor, SparseRow row) {
    while (!row.columns.empty()) {
        SparseRow& upper = factor[row.columns[0]];
        if (upper.columns.empty()) {
            std::swap(upper, row);
        } else if (row.values[0] == 0.0) {
            row.columns.erase(row.columns.begin());
            row.values.erase(row.values.begin());
        } else {
            rotate(upper, row);
        }
    }
}

ANCF_INLINE std::vector<int> dependent_rows(const SparseMatrix& columns, const VectorX& scales,
                                            double tolerance) {
    const auto equations = static_cast<int>(columns.cols());
    std::vector<SparseRow> coordinates(static_cast<std::size_t>(columns.rows()));
    for (int j = 0; j < equations; ++j) {
        double square = 0.0;
        for (SparseMatrix::InnerIterator entry(columns, j); entry; ++entry)
            square += std::pow(entry.value() * scales[entry.row()], 2);
        for (SparseMatrix::InnerIterator entry(columns, j); entry; ++entry) {
            const double value = entry.value() * scales[entry.row()] / std::sqrt(square);
            if (entry.value() == 0.0) continue;
            coordinates[entry.row()].columns.push_back(j);
            coordinates[entry.row()].values.push_back(value);
        }
    }
    // in the order of their first equations: a row then ends soon in an empty row of the factor
    std::vector<SparseRow> factor(static_cast<std::size_t>(equations));
    for (int j = 0; j < equations; ++j)
        for (SparseMatrix::InnerIterator entry(columns, j); entry; ++entry) {
            SparseRow& row = coordinates[entry.row()];
            if (!row.columns.empty() && row.columns[0] == j) insert(factor, std::exchange(row, {}));
        }
    std::vector<int> dependent;
    for (int j = 0; j < equations; ++j) {
        SparseRow& row = factor[j];
        if (!row.columns.empty() && std::abs(row.values[0]) > tolerance) continue;
        dependent.push_back(j);
        if (row.columns.empty()) continue;
        SparseRow rest = std::exchange(row, {});
        rest.columns.erase(rest.columns.begin());
        rest.values.erase(rest.values.begin());
        insert(factor, std::move(rest));
    }
    return dependent;
}

ANCF_INLINE std::string describe_equation(const std::vector<AnyConstraint>& constraints,
                                          int equation) {
    std::size_t k = 0;
    for (; equation >= constraints[k].equations(); ++k) equation -= constraints[k].equations();
    return joined({"constraint ", k, " (", constraints[k].name(), "), equation ", equation});
}

ANCF_INLINE std::string repeated_constraints(const Scene& model, const Numbering& numbering,
                                             const SparseMatrix& tangent, Storage storage) {
    const int free = numbering.free_coordinates(), equations = numbering.multipliers();
    if (equations == 0 || storage == Storage::lower) return {};
    SparseMatrix columns(free, equations);
    for (int j = 0; j < equations; ++j) {
        columns.startVec(j);
        for (SparseMatrix::InnerIterator entry(tangent, free + j); entry && entry.row() < free;
             ++entry)
            columns.insertBack(entry.row(), j) = entry.value();
    }
    columns.finalize();
    const Layout& layout = model.layout();
    const double diagonal = diagonal_of(layout, model.dimension(), model.state().q, nullptr);
    const double length = diagonal > 0.0 && std::isfinite(diagonal) ? diagonal : 1.0;
    VectorX scales(free);
    for (int k = 0; k < numbering.coordinates(); ++k)
        if (const int row = numbering.equation(k); row >= 0)
            scales[row] = std::pow(length, length_power(layout.field_of(k)));
    std::string text;
    constexpr double tolerance = 1e-10;  // as ProblemOptions::redundancy_tolerance
    for (const int row : dependent_rows(columns, scales, tolerance)) {
        text += text.empty() ? "constraints repeat each other or a support: " : "; ";
        text += describe_equation(model.constraints(), row);
    }
    return text;
}

}  // namespace ancf::detail
