// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// UMFPACK: sparse LU factorisation of any square matrix, analysed once, factorised often.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/solver/direct_solver.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <memory>
#include <string_view>

namespace ancf::suitesparse {

/// How Umfpack works.
struct UmfpackOptions {
    int refinement_steps = 2;                        ///< at most, in each solve
    double singular_rcond = default_singular_rcond;  ///< 0 refuses zero pivots only
};

/// Solves unsymmetric systems and saddle points by UMFPACK.
///
/// Rows and columns are scaled so that nothing depends on units, pivots chosen for size and
/// sparsity, each solution refined. Keeps a copy of the matrix for the refinement.
class Umfpack final : public ancf::detail::DirectSolver {
public:
    /// @throws InvalidArgument for negative refinement steps or a singular_rcond outside [0, 1).
    explicit Umfpack(const UmfpackOptions& options = {});

    /// All entries are read.
    [[nodiscard]] Storage storage() const noexcept override { return Storage::full; }

    [[nodiscard]] std::string_view name() const noexcept override { return "umfpack"; }

    /// UMFPACK of complex matrices, with the same options.
    [[nodiscard]] ANCF_INLINE_VIRTUAL std::unique_ptr<ComplexSolver> complex_solver()
        const override;

private:
    struct Session;  // the state of UMFPACK

    ANCF_INLINE_VIRTUAL void analyze_pattern(const SparseMatrix& matrix) override;
    [[nodiscard]] ANCF_INLINE_VIRTUAL FactorReport
    factorize_values(const SparseMatrix& matrix) override;
    ANCF_INLINE_VIRTUAL void substitute(const VectorX& b, VectorX& x) const override;

    UmfpackOptions options_;
    ancf::detail::Hidden<Session> session_{nullptr, nullptr};
};

}  // namespace ancf::suitesparse

#if !defined(ANCF_COMPILED)
#include <ancf/suitesparse/umfpack.ipp>  // IWYU pragma: export
#endif
