// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of umfpack.hpp.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/error.hpp>
#include <ancf/suitesparse/equilibrated.hpp>
#include <ancf/suitesparse/umfpack.hpp>

#include <umfpack.h>

#include <array>
#include <complex>
#include <new>
#include <vector>

namespace ancf::suitesparse {

namespace detail {

struct FreeSymbolicOfUmfpack {
    void operator()(void* symbolic) const noexcept { umfpack_di_free_symbolic(&symbolic); }
};
struct FreeNumericOfUmfpack {
    void operator()(void* numeric) const noexcept { umfpack_di_free_numeric(&numeric); }
};

}  // namespace detail

struct Umfpack::Session {
    explicit Session(const UmfpackOptions& options) {
        umfpack_di_defaults(control.data());
        control[UMFPACK_PRL] = 0.0;
        control[UMFPACK_SCALE] = UMFPACK_SCALE_NONE;
        control[UMFPACK_IRSTEP] = options.refinement_steps;
    }

    // Throws what a status of UMFPACK asks for; the warning of a singular matrix is none.
    static void check(int status) {
        if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
        ancf::detail::require(status >= UMFPACK_OK, "umfpack refused the matrix, status ", status);
    }

    std::array<double, UMFPACK_CONTROL> control;
    detail::Equilibrated<double> matrix;
    std::unique_ptr<void, detail::FreeSymbolicOfUmfpack> symbolic;
    std::unique_ptr<void, detail::FreeNumericOfUmfpack> numeric;
};

ANCF_INLINE void Umfpack::Finish::operator()(Session* session) const noexcept { delete session; }

ANCF_INLINE Umfpack::Umfpack(const UmfpackOptions& options) : options_(options) {
    ancf::detail::require(options.refinement_steps >= 0,
                          "refinement_steps must not be negative, got ", options.refinement_steps);
    ancf::detail::require_singular_rcond(options.singular_rcond);
}

ANCF_INLINE void Umfpack::analyze(const SparseMatrix& matrix) {
    ancf::detail::require_storage(name(), matrix, storage());
    stage_.reset();
    session_.reset(new Session(options_));
    if (matrix.cols() > 0) {
        detail::Equilibrated<double>& scaled = session_->matrix;
        scaled.analyze(matrix);
        void* symbolic = nullptr;  // by the pattern alone: the values may not be known yet
        const int status =
            umfpack_di_symbolic(scaled.size(), scaled.size(), scaled.outer(), scaled.inner(),
                                nullptr, &symbolic, session_->control.data(), nullptr);
        session_->symbolic.reset(symbolic);
        Session::check(status);
    }
    stage_.analysed(matrix);
}

ANCF_INLINE FactorReport Umfpack::factorize(const SparseMatrix& matrix) {
    stage_.begin_factorisation(name(), matrix);
    FactorReport report;
    if (!session_->matrix.take(matrix.valuePtr())) {
        report.status = Status::not_finite;
    } else if (matrix.cols() > 0) {
        factorize_numbers(matrix, report);
    } else {
        report.rcond = 1.0;
    }
    return stage_.finished(report);
}

ANCF_INLINE void Umfpack::factorize_numbers(const SparseMatrix& matrix, FactorReport& report) {
    detail::Equilibrated<double>& scaled = session_->matrix;
    void* numeric = nullptr;
    const int status =
        umfpack_di_numeric(scaled.outer(), scaled.inner(), scaled.values(),
                           session_->symbolic.get(), &numeric, session_->control.data(), nullptr);
    session_->numeric.reset(numeric);
    Session::check(status);
    if (status == UMFPACK_WARNING_singular_matrix) {
        ancf::detail::report_failure(matrix, -1, report);
    } else {
        ancf::detail::report_condition(
            matrix, options_.singular_rcond,
            [this](const VectorX& b, VectorX& x) { substitute(b, x); }, report);
    }
}

ANCF_INLINE void Umfpack::substitute(const VectorX& b, VectorX& x) const {
    detail::Equilibrated<double>& scaled = session_->matrix;
    VectorX right = b, solution(b.size());
    scaled.scale_right(right);
    Session::check(umfpack_di_solve(UMFPACK_A, scaled.outer(), scaled.inner(), scaled.values(),
                                    solution.data(), right.data(), session_->numeric.get(),
                                    session_->control.data(), nullptr));
    scaled.scale_solution(solution);
    x.swap(solution);
}

ANCF_INLINE void Umfpack::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    if (b.size() > 0) {
        substitute(b, x);
    } else {
        x = b;
    }
}

namespace detail {

struct FreeComplexSymbolicOfUmfpack {
    void operator()(void* symbolic) const noexcept { umfpack_zi_free_symbolic(&symbolic); }
};
struct FreeComplexNumericOfUmfpack {
    void operator()(void* numeric) const noexcept { umfpack_zi_free_numeric(&numeric); }
};

/// UMFPACK of complex matrices. Its interface takes pairs of doubles where the imaginary parts are
/// a null pointer.
class ComplexUmfpack final : public ComplexSolver {
public:
    explicit ComplexUmfpack(int refinement_steps) {
        umfpack_zi_defaults(control_.data());
        control_[UMFPACK_PRL] = 0.0;
        control_[UMFPACK_SCALE] = UMFPACK_SCALE_NONE;
        control_[UMFPACK_IRSTEP] = refinement_steps;
    }

    void analyze(const SparseMatrix& pattern) override {
        ancf::detail::require_storage(name(), pattern, Storage::full);
        matrix_.analyze(pattern);
        numeric_.reset();
        void* symbolic = nullptr;
        const int status =
            umfpack_zi_symbolic(matrix_.size(), matrix_.size(), matrix_.outer(), matrix_.inner(),
                                nullptr, nullptr, &symbolic, control_.data(), nullptr);
        symbolic_.reset(symbolic);
        check(status);
    }

    [[nodiscard]] Status factorize(const std::vector<std::complex<double>>& values) override {
        ancf::detail::require(values.size() == matrix_.entries(), name(), ": expected ",
                              matrix_.entries(), " values, got ", values.size());
        numeric_.reset();
        if (!matrix_.take(values.data())) return Status::not_finite;
        void* numeric = nullptr;
        const int status =
            umfpack_zi_numeric(matrix_.outer(), matrix_.inner(), matrix_.values(), nullptr,
                               symbolic_.get(), &numeric, control_.data(), nullptr);
        numeric_.reset(numeric);
        check(status);
        return status == UMFPACK_WARNING_singular_matrix ? Status::singular : Status::converged;
    }

    void solve(ComplexVectorX& b) const override {
        ComplexVectorX x(b.size());
        matrix_.scale_right(b);
        check(umfpack_zi_solve(UMFPACK_A, matrix_.outer(), matrix_.inner(), matrix_.values(),
                               nullptr, reinterpret_cast<double*>(x.data()), nullptr,
                               reinterpret_cast<const double*>(b.data()), nullptr, numeric_.get(),
                               control_.data(), nullptr));
        b.swap(x);
        matrix_.scale_solution(b);
    }

    [[nodiscard]] std::string_view name() const noexcept override { return "complex umfpack"; }

private:
    static void check(int status) {
        if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
        ancf::detail::require(status >= UMFPACK_OK, "umfpack refused the matrix, status ", status);
    }

    std::array<double, UMFPACK_CONTROL> control_;
    mutable Equilibrated<std::complex<double>> matrix_;  // UMFPACK only reads it
    std::unique_ptr<void, FreeComplexSymbolicOfUmfpack> symbolic_;
    std::unique_ptr<void, FreeComplexNumericOfUmfpack> numeric_;
};

}  // namespace detail

ANCF_INLINE std::unique_ptr<ComplexSolver> Umfpack::complex_solver() const {
    return std::make_unique<detail::ComplexUmfpack>(options_.refinement_steps);
}

}  // namespace ancf::suitesparse
