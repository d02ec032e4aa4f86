// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// LAPACK's banded LU factorisation with partial pivoting, beside the solver for chains.

#pragma once

#include <ancf/error.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

extern "C" {
void dgbtrf_(const int* rows, const int* columns, const int* below, const int* above, double* band,
             const int* stride, int* pivots, int* info);
void dgbtrs_(const char* transposed, const int* size, const int* below, const int* above,
             const int* sides, const double* band, const int* stride, const int* pivots, double* x,
             const int* x_stride, int* info, std::size_t transposed_length);
}

namespace ancf::bench {

/// Solves symmetric systems in the given order of the unknowns, within their band.
class LapackBanded final : public LinearSolver {
public:
    /// The lower half is read.
    [[nodiscard]] Storage storage() const noexcept override { return Storage::lower; }

    void analyze(const SparseMatrix& lower) override {
        size_ = static_cast<int>(lower.cols());
        width_ = 0;
        each_entry(lower,
                   [&](int row, int column, double) { width_ = std::max(width_, row - column); });
        stride_ = 3 * width_ + 1;
        band_.resize(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(size_));
        pivots_.resize(static_cast<std::size_t>(size_));
    }

    [[nodiscard]] FactorReport factorize(const SparseMatrix& lower) override {
        std::fill(band_.begin(), band_.end(), 0.0);
        each_entry(lower, [&](int row, int column, double value) {
            at(row, column) = value;
            at(column, row) = value;
        });
        int info = 0;
        dgbtrf_(&size_, &size_, &width_, &width_, band_.data(), &stride_, pivots_.data(), &info);
        FactorReport report;
        report.status = info == 0 ? Status::converged : Status::singular;
        return report;
    }

    void solve(const VectorX& b, VectorX& x) const override {
        x = b;
        const int sides = 1;
        int info = 0;
        dgbtrs_("N", &size_, &width_, &width_, &sides, band_.data(), &stride_, pivots_.data(),
                x.data(), &size_, &info, 1);
        detail::require(info == 0, "dgbtrs refused argument ", -info);
    }

    [[nodiscard]] std::string_view name() const noexcept override { return "lapack-banded"; }

private:
    template <class Action>
    static void each_entry(const SparseMatrix& matrix, const Action& action) {
        for (int column = 0; column < matrix.outerSize(); ++column)
            for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
                action(static_cast<int>(entry.row()), column, entry.value());
    }

    // The place of an entry in the band, of which the first width_ rows are room for pivoting.
    double& at(int row, int column) {
        return band_[static_cast<std::size_t>(column) * static_cast<std::size_t>(stride_) +
                     static_cast<std::size_t>(2 * width_ + row - column)];
    }

    int size_ = 0, width_ = 0, stride_ = 1;
    std::vector<double> band_;
    std::vector<int> pivots_;
};

}  // namespace ancf::bench
