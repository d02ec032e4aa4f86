// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// LAPACK's banded Cholesky factorisation as a linear solver: what the solver for chains is
/// measured against.

#pragma once

#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

extern "C" {
void dpbtrf_(const char* uplo, const int* n, const int* kd, double* ab, const int* ldab, int* info);
void dpbtrs_(const char* uplo, const int* n, const int* kd, const int* nrhs, const double* ab,
             const int* ldab, double* b, const int* ldb, int* info);
}

namespace ancf::bench {

/// Positive definite matrices only.
class LapackBanded {
public:
    static constexpr Storage storage = Storage::lower;

    void analyze(const SparseMatrix& lower) {
        size_ = static_cast<int>(lower.cols());
        width_ = 0;
        for (int column = 0; column < size_; ++column)
            for (SparseMatrix::InnerIterator entry(lower, column); entry; ++entry)
                width_ = std::max(width_, static_cast<int>(entry.row()) - column);
        band_.resize(static_cast<std::size_t>(size_) * static_cast<std::size_t>(width_ + 1));
    }

    [[nodiscard]] FactorReport factorize(const SparseMatrix& lower) {
        std::fill(band_.begin(), band_.end(), 0.0);
        const int rows = width_ + 1;
        for (int column = 0; column < size_; ++column) {
            double* const own = band_.data() + static_cast<std::ptrdiff_t>(column) * rows;
            for (SparseMatrix::InnerIterator entry(lower, column); entry; ++entry)
                own[entry.row() - column] = entry.value();
        }
        int info = 0;
        dpbtrf_("L", &size_, &width_, band_.data(), &rows, &info);
        return {info == 0 ? Status::converged : Status::singular};
    }

    void solve(const VectorX& b, VectorX& x) const {
        x = b;
        const int rows = width_ + 1, one = 1;
        int info = 0;
        dpbtrs_("L", &size_, &width_, &one, band_.data(), &rows, x.data(), &size_, &info);
    }

    [[nodiscard]] static constexpr std::string_view name() noexcept { return "lapack-banded"; }

private:
    int size_ = 0, width_ = 0;
    std::vector<double> band_;
};

}  // namespace ancf::bench
