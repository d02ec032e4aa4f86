// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The direct solver for chains (block_tridiagonal.hpp) of complex symmetric matrices.

#pragma once

#include <ancf/error.hpp>
#include <ancf/solver/block_tridiagonal_kernel.hpp>
#include <ancf/solver/block_tridiagonal_layout.hpp>
#include <ancf/solver/complex_solver.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <cmath>
#include <complex>
#include <string_view>
#include <vector>

namespace ancf {

/// L D L^T block by block of a complex symmetric matrix, without pivoting.
///
/// Stable where a factor exp(i phi) makes the real part positive definite; a vanishing pivot counts
/// as singular. The lower half is read.
class ComplexBlockTridiagonal final : public ComplexSolver {
public:
    /// @throws InvalidArgument unless square, compressed, lower, and of blocks up to
    ///         BlockTridiagonal::max_block.
    void analyze(const SparseMatrix& pattern) override {
        detail::require_storage(name(), pattern, Storage::lower);
        layout_ = detail::chain_layout(name(), pattern);
        outer_.assign(pattern.outerIndexPtr(), pattern.outerIndexPtr() + pattern.cols() + 1);
        inner_.assign(pattern.innerIndexPtr(), pattern.innerIndexPtr() + pattern.nonZeros());
        panels_.resize(layout_.panel_entries());
    }

    /// Factorises in the pattern analysed. @throws InvalidArgument for another number of values.
    [[nodiscard]] Status factorize(const std::vector<std::complex<double>>& values) override {
        detail::require(values.size() == inner_.size(), name(), ": expected ", inner_.size(),
                        " values, got ", values.size());
        for (const std::complex<double>& value : values)
            if (!std::isfinite(value.real()) || !std::isfinite(value.imag()))
                return Status::not_finite;
        const detail::PivotSummary summary = detail::factorize_chain<std::complex<double>>(
            layout_, {outer_.data(), inner_.data(), values.data()}, panels_.data(), nullptr,
            nullptr);
        return summary.failed_column >= 0 ? Status::singular : Status::converged;
    }

    /// Solves A x = b in place.
    void solve(ComplexVectorX& b) const override {
        detail::solve_chain(layout_, panels_.data(), b.data());
    }

    /// "complex block-tridiagonal".
    [[nodiscard]] std::string_view name() const noexcept override {
        return "complex block-tridiagonal";
    }

private:
    detail::BlockLayout layout_;
    std::vector<int> outer_, inner_;
    ComplexVectorX panels_;
};

}  // namespace ancf
