// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The direct solver for chains (block_tridiagonal.hpp) of complex symmetric matrices.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/solver/block_tridiagonal_layout.hpp>
#include <ancf/solver/complex_solver.hpp>
#include <ancf/types.hpp>

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
    ANCF_INLINE_VIRTUAL void analyze(const SparseMatrix& pattern) override;

    /// Factorises in the pattern analysed. @throws InvalidArgument for another number of values.
    [[nodiscard]] ANCF_INLINE_VIRTUAL Status
    factorize(const std::vector<std::complex<double>>& values) override;

    /// Solves A x = b in place.
    ANCF_INLINE_VIRTUAL void solve(ComplexVectorX& b) const override;

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

#if !defined(ANCF_COMPILED)
#include <ancf/solver/complex_block_tridiagonal.ipp>  // IWYU pragma: export
#endif
