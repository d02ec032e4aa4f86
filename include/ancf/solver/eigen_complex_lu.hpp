// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Eigen's sparse factorisation of any complex square matrix.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/solver/complex_solver.hpp>
#include <ancf/types.hpp>

#include <complex>
#include <memory>
#include <string_view>
#include <vector>

namespace ancf {

/// L U with partial pivoting, columns ordered by COLAMD, rows scaled as those of EigenLu.
class EigenComplexLu final : public ComplexSolver {
public:
    /// @param storage  of the matrices to come; of the lower half the other one is filled in.
    explicit EigenComplexLu(Storage storage) : storage_(storage) {}

    /// @throws InvalidArgument unless square, compressed and of the storage.
    ANCF_INLINE_VIRTUAL void analyze(const SparseMatrix& pattern) override;

    /// Factorises in the pattern analysed. @throws InvalidArgument for another number of values.
    [[nodiscard]] ANCF_INLINE_VIRTUAL Status
    factorize(const std::vector<std::complex<double>>& values) override;

    /// Solves A x = b in place.
    ANCF_INLINE_VIRTUAL void solve(ComplexVectorX& b) const override;

    /// The word that tables print.
    [[nodiscard]] std::string_view name() const noexcept override { return "complex eigen-lu"; }

private:
    struct Factors;  // Eigen's class and its matrix
    struct Free {
        void operator()(Factors* factors) const noexcept;
    };

    Storage storage_;
    std::unique_ptr<Factors, Free> factors_;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/eigen_complex_lu.ipp>  // IWYU pragma: export
#endif
