// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// KLU: sparse LU factorisation entry by entry, for small or very sparse matrices.
///
/// Where a scene has tens of elements, not thousands, it is several times as fast as UMFPACK, whose
/// dense blocks have to pay first. Its licence is the LGPL.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/error.hpp>
#include <ancf/solver/conditioning.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <klu.h>

#include <memory>
#include <new>
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
/// Rows are scaled by their largest entries. Each factorisation chooses its pivots anew, so that it
/// depends on the matrix alone.
class Klu {
public:
    static constexpr Storage storage = Storage::full;  ///< all entries are read

    /// @throws InvalidArgument for options outside their ranges.
    explicit Klu(const KluOptions& options = {});

    /// @throws InvalidArgument unless square and compressed; std::bad_alloc.
    void analyze(const SparseMatrix& matrix);

    /// Factorises in the pattern analysed.
    /// @throws InvalidArgument if its size or the number of entries in a column differs;
    ///         std::bad_alloc.
    [[nodiscard]] FactorReport factorize(const SparseMatrix& matrix);

    /// Solves A x = b. @throws InvalidArgument unless factorised and b has its size.
    void solve(const VectorX& b, VectorX& x) const;

    /// The word that tables print.
    [[nodiscard]] static constexpr std::string_view name() noexcept { return "klu"; }

private:
    // What KLU allocated it frees by any common of its own kind.
    struct Free {
        void operator()(klu_symbolic* symbolic) const noexcept {
            klu_common common;
            klu_defaults(&common);
            klu_free_symbolic(&symbolic, &common);
        }
        void operator()(klu_numeric* numeric) const noexcept {
            klu_common common;
            klu_defaults(&common);
            klu_free_numeric(&numeric, &common);
        }
    };

    void check() const;
    void substitute(const VectorX& b, VectorX& x) const;

    KluOptions options_;
    mutable klu_common common_;  // a solve leaves its status there
    std::unique_ptr<klu_symbolic, Free> symbolic_;
    std::unique_ptr<klu_numeric, Free> numeric_;
    ancf::detail::SolverStage stage_;
};

inline Klu::Klu(const KluOptions& options) : options_(options) {
    ancf::detail::require(options.pivot_tolerance > 0.0 && options.pivot_tolerance <= 1.0,
                          "pivot_tolerance must be in (0, 1], got ", options.pivot_tolerance);
    ancf::detail::require_singular_rcond(options.singular_rcond);
    klu_defaults(&common_);
    common_.tol = options.pivot_tolerance;
}

/// Throws what KLU's status asks for; a singular matrix is none of it.
inline void Klu::check() const {
    if (common_.status == KLU_OUT_OF_MEMORY) throw std::bad_alloc();
    ancf::detail::require(common_.status >= KLU_OK, name(), " refused the matrix, status ",
                          common_.status);
}

inline void Klu::analyze(const SparseMatrix& matrix) {
    ancf::detail::require_storage(name(), matrix, storage);
    stage_.reset();
    numeric_.reset();
    symbolic_.reset();
    if (matrix.cols() > 0) {
        // KLU's interface takes its inputs as not constant; it does not write to them
        symbolic_.reset(klu_analyze(static_cast<int>(matrix.cols()),
                                    const_cast<int*>(matrix.outerIndexPtr()),
                                    const_cast<int*>(matrix.innerIndexPtr()), &common_));
        check();
    }
    stage_.analysed(matrix);
}

inline FactorReport Klu::factorize(const SparseMatrix& matrix) {
    stage_.begin_factorisation(name(), matrix);
    FactorReport report;
    numeric_.reset();
    if (!ancf::detail::all_finite(matrix)) {
        report.status = Status::not_finite;
    } else if (matrix.cols() == 0) {
        report.rcond = 1.0;
    } else if (!symbolic_) {
        ancf::detail::report_failure(matrix, -1, report);  // no pivots whatever the values
    } else {
        numeric_.reset(klu_factor(
            const_cast<int*>(matrix.outerIndexPtr()), const_cast<int*>(matrix.innerIndexPtr()),
            const_cast<double*>(matrix.valuePtr()), symbolic_.get(), &common_));
        check();
        if (common_.status == KLU_SINGULAR) {
            // which column is left without a pivot depends on KLU's order, not on the scene
            ancf::detail::report_failure(matrix, -1, report);
        } else {
            ancf::detail::report_condition(
                matrix, options_.singular_rcond,
                [this](const VectorX& b, VectorX& x) { substitute(b, x); }, report);
        }
    }
    return stage_.finished(report);
}

inline void Klu::substitute(const VectorX& b, VectorX& x) const {
    x = b;
    klu_solve(symbolic_.get(), numeric_.get(), static_cast<int>(x.size()), 1, x.data(), &common_);
    check();
}

inline void Klu::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    if (b.size() > 0) {
        substitute(b, x);
    } else {
        x = b;
    }
}

}  // namespace ancf::suitesparse
