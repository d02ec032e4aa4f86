// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// KLU: sparse LU factorisation entry by entry, for small or very sparse matrices.
///
/// Where a scene has tens of elements, not thousands, it is several times as fast as UMFPACK, whose
/// dense blocks have to pay first. Its licence is the LGPL.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/solver/direct_solver.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <memory>
#include <string_view>

namespace ancf::suitesparse {

/// How Klu works.
struct KluOptions {
    /// Share of a column's largest entry from which its diagonal is taken as pivot, in (0, 1].
    double pivot_tolerance = 0.1;
    double singular_rcond = default_singular_rcond;  ///< 0 refuses zero pivots only
};

/// Solves unsymmetric systems and saddle points by KLU.
///
/// Rows are scaled by their largest entries, measured so that no pivot depends on units. Each
/// factorisation chooses its pivots anew, so that it depends on the matrix alone.
class Klu final : public ancf::detail::DirectSolver {
public:
    /// @throws InvalidArgument for options outside their ranges.
    explicit Klu(const KluOptions& options = {})
        : DirectSolver(options.singular_rcond), options_(options) {
        ancf::detail::require(options.pivot_tolerance > 0.0 && options.pivot_tolerance <= 1.0,
                              "pivot_tolerance must be in (0, 1], got ", options.pivot_tolerance);
    }

    /// All entries are read.
    [[nodiscard]] Storage storage() const noexcept override { return Storage::full; }

    [[nodiscard]] std::string_view name() const noexcept override { return "klu"; }

    /// KLU of complex matrices, with the same options.
    [[nodiscard]] ANCF_INLINE_VIRTUAL std::unique_ptr<ComplexSolver> complex_solver()
        const override;

private:
    struct Session;  // the state of KLU

    ANCF_INLINE_VIRTUAL void analyze_pattern(const SparseMatrix& matrix) override;
    [[nodiscard]] ANCF_INLINE_VIRTUAL FactorReport
    factorize_values(const SparseMatrix& matrix) override;
    ANCF_INLINE_VIRTUAL void substitute(const VectorX& b, VectorX& x) const override;

    KluOptions options_;
    ancf::detail::Hidden<Session> session_{nullptr, nullptr};
};

}  // namespace ancf::suitesparse

#if !defined(ANCF_COMPILED)
#include <ancf/suitesparse/klu.ipp>  // IWYU pragma: export
#endif
