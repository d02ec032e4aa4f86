// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// UMFPACK: sparse LU factorisation of any square matrix, analysed once, factorised often.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/error.hpp>
#include <ancf/solver/conditioning.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <umfpack.h>

#include <array>
#include <memory>
#include <new>
#include <string_view>

namespace ancf::suitesparse {

/// How Umfpack works.
struct UmfpackOptions {
    int refinement_steps = 2;                        ///< at most, in each solve
    double singular_rcond = default_singular_rcond;  ///< 0 refuses zero pivots only
};

/// Solves unsymmetric systems and saddle points by UMFPACK.
///
/// Rows are scaled, pivots chosen for size and sparsity, each solution refined. Keeps a copy of the
/// matrix for the refinement.
class Umfpack {
public:
    static constexpr Storage storage = Storage::full;  ///< all entries are read

    /// @throws InvalidArgument for negative refinement steps or a singular_rcond outside [0, 1).
    explicit Umfpack(const UmfpackOptions& options = {});

    /// @throws InvalidArgument unless square and compressed.
    void analyze(const SparseMatrix& matrix);

    /// Factorises in the pattern analysed.
    /// @throws InvalidArgument if its size or the number of entries in a column differs.
    [[nodiscard]] FactorReport factorize(const SparseMatrix& matrix);

    /// Solves A x = b. @throws InvalidArgument unless factorised and b has its size.
    void solve(const VectorX& b, VectorX& x) const;

    /// The word that tables print.
    [[nodiscard]] static constexpr std::string_view name() noexcept { return "umfpack"; }

private:
    struct FreeSymbolic {
        void operator()(void* symbolic) const noexcept { umfpack_di_free_symbolic(&symbolic); }
    };
    struct FreeNumeric {
        void operator()(void* numeric) const noexcept { umfpack_di_free_numeric(&numeric); }
    };
    using Control = std::array<double, UMFPACK_CONTROL>;

    static void check(int status);
    [[nodiscard]] FactorReport factorize_numbers();
    void substitute(const VectorX& b, VectorX& x) const;

    UmfpackOptions options_;
    Control control_;
    std::unique_ptr<void, FreeSymbolic> symbolic_;
    std::unique_ptr<void, FreeNumeric> numeric_;
    SparseMatrix matrix_;
    ancf::detail::SolverStage stage_;
};

inline Umfpack::Umfpack(const UmfpackOptions& options) : options_(options) {
    ancf::detail::require(options.refinement_steps >= 0,
                          "refinement_steps must not be negative, got ", options.refinement_steps);
    ancf::detail::require_singular_rcond(options.singular_rcond);
    umfpack_di_defaults(control_.data());
    control_[UMFPACK_PRL] = 0.0;
    control_[UMFPACK_IRSTEP] = options.refinement_steps;
}

/// Throws what a status of UMFPACK asks for; the warning of a singular matrix is none.
inline void Umfpack::check(int status) {
    if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
    ancf::detail::require(status >= UMFPACK_OK, name(), " refused the matrix, status ", status);
}

inline void Umfpack::analyze(const SparseMatrix& matrix) {
    ancf::detail::require_storage(name(), matrix, storage);
    stage_.reset();
    numeric_.reset();
    symbolic_.reset();
    if (matrix.cols() > 0) {
        const int size = static_cast<int>(matrix.cols());
        void* symbolic = nullptr;  // by the pattern alone: the values may not be known yet
        const int status =
            umfpack_di_symbolic(size, size, matrix.outerIndexPtr(), matrix.innerIndexPtr(), nullptr,
                                &symbolic, control_.data(), nullptr);
        symbolic_.reset(symbolic);
        check(status);
    }
    stage_.analysed(matrix);
}

inline FactorReport Umfpack::factorize(const SparseMatrix& matrix) {
    stage_.begin_factorisation(name(), matrix);
    FactorReport report;
    if (!ancf::detail::all_finite(matrix)) {
        report.status = Status::not_finite;
    } else if (matrix.cols() > 0) {
        matrix_ = matrix;
        report = factorize_numbers();
    } else {
        report.rcond = 1.0;
    }
    return stage_.finished(report);
}

inline FactorReport Umfpack::factorize_numbers() {
    void* numeric = nullptr;
    const int status =
        umfpack_di_numeric(matrix_.outerIndexPtr(), matrix_.innerIndexPtr(), matrix_.valuePtr(),
                           symbolic_.get(), &numeric, control_.data(), nullptr);
    numeric_.reset(numeric);
    check(status);
    FactorReport report;
    if (status == UMFPACK_WARNING_singular_matrix) {
        ancf::detail::report_failure(matrix_, -1, report);
    } else {
        ancf::detail::report_condition(
            matrix_, options_.singular_rcond,
            [this](const VectorX& b, VectorX& x) { substitute(b, x); }, report);
    }
    return report;
}

inline void Umfpack::substitute(const VectorX& b, VectorX& x) const {
    VectorX solution(b.size());
    check(umfpack_di_solve(UMFPACK_A, matrix_.outerIndexPtr(), matrix_.innerIndexPtr(),
                           matrix_.valuePtr(), solution.data(), b.data(), numeric_.get(),
                           control_.data(), nullptr));
    x.swap(solution);
}

inline void Umfpack::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    if (b.size() > 0) {
        substitute(b, x);
    } else {
        x = b;
    }
}

}  // namespace ancf::suitesparse
