// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of klu.hpp.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/error.hpp>
#include <ancf/suitesparse/equilibrated.hpp>
#include <ancf/suitesparse/klu.hpp>

#include <klu.h>

#include <complex>
#include <new>
#include <vector>

namespace ancf::suitesparse {

namespace detail {

/// Frees what KLU allocated, by any common of its own kind.
struct FreeOfKlu {
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

}  // namespace detail

struct Klu::Session {
    explicit Session(double pivot_tolerance) {
        klu_defaults(&common);
        common.tol = pivot_tolerance;
        common.scale = -1;
    }

    // Throws what KLU's status asks for; a singular matrix is none of it.
    void check() const {
        if (common.status == KLU_OUT_OF_MEMORY) throw std::bad_alloc();
        ancf::detail::require(common.status >= KLU_OK, "klu refused the matrix, status ",
                              common.status);
    }

    klu_common common;
    detail::Equilibrated<double> matrix;
    std::unique_ptr<klu_symbolic, detail::FreeOfKlu> symbolic;
    std::unique_ptr<klu_numeric, detail::FreeOfKlu> numeric;
};

ANCF_INLINE void Klu::Finish::operator()(Session* session) const noexcept { delete session; }

ANCF_INLINE Klu::Klu(const KluOptions& options) : options_(options) {
    ancf::detail::require(options.pivot_tolerance > 0.0 && options.pivot_tolerance <= 1.0,
                          "pivot_tolerance must be in (0, 1], got ", options.pivot_tolerance);
    ancf::detail::require_singular_rcond(options.singular_rcond);
}

ANCF_INLINE void Klu::analyze(const SparseMatrix& matrix) {
    ancf::detail::require_storage(name(), matrix, storage());
    stage_.reset();
    session_.reset(new Session(options_.pivot_tolerance));
    if (matrix.cols() > 0) {
        detail::Equilibrated<double>& scaled = session_->matrix;
        scaled.analyze(matrix);
        session_->symbolic.reset(
            klu_analyze(scaled.size(), scaled.outer(), scaled.inner(), &session_->common));
        session_->check();
    }
    stage_.analysed(matrix);
}

ANCF_INLINE FactorReport Klu::factorize(const SparseMatrix& matrix) {
    stage_.begin_factorisation(name(), matrix);
    FactorReport report;
    session_->numeric.reset();
    detail::Equilibrated<double>& scaled = session_->matrix;
    if (!scaled.take(matrix.valuePtr())) {
        report.status = Status::not_finite;
    } else if (matrix.cols() == 0) {
        report.rcond = 1.0;
    } else if (!session_->symbolic) {
        ancf::detail::report_failure(matrix, -1, report);  // no pivots whatever the values
    } else {
        session_->numeric.reset(klu_factor(scaled.outer(), scaled.inner(), scaled.values(),
                                           session_->symbolic.get(), &session_->common));
        session_->check();
        if (session_->common.status == KLU_SINGULAR) {
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

ANCF_INLINE void Klu::substitute(const VectorX& b, VectorX& x) const {
    x = b;
    session_->matrix.scale_right(x);
    klu_solve(session_->symbolic.get(), session_->numeric.get(), static_cast<int>(x.size()), 1,
              x.data(), &session_->common);
    session_->check();
    session_->matrix.scale_solution(x);
}

ANCF_INLINE void Klu::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    if (b.size() > 0) {
        substitute(b, x);
    } else {
        x = b;
    }
}

namespace detail {

/// Frees what KLU allocated for a complex matrix.
struct FreeOfComplexKlu {
    void operator()(klu_numeric* numeric) const noexcept {
        klu_common common;
        klu_defaults(&common);
        klu_z_free_numeric(&numeric, &common);
    }
};

/// KLU of complex matrices.
class ComplexKlu final : public ComplexSolver {
public:
    explicit ComplexKlu(double pivot_tolerance) {
        klu_defaults(&common_);
        common_.tol = pivot_tolerance;
        common_.scale = -1;
    }

    void analyze(const SparseMatrix& pattern) override {
        ancf::detail::require_storage(name(), pattern, Storage::full);
        matrix_.analyze(pattern);
        numeric_.reset();
        symbolic_.reset(klu_analyze(matrix_.size(), matrix_.outer(), matrix_.inner(), &common_));
        check();
    }

    [[nodiscard]] Status factorize(const std::vector<std::complex<double>>& values) override {
        ancf::detail::require(values.size() == matrix_.entries(), name(), ": expected ",
                              matrix_.entries(), " values, got ", values.size());
        numeric_.reset();
        if (!matrix_.take(values.data())) return Status::not_finite;
        if (!symbolic_) return Status::singular;
        numeric_.reset(klu_z_factor(matrix_.outer(), matrix_.inner(), matrix_.values(),
                                    symbolic_.get(), &common_));
        check();
        return common_.status == KLU_SINGULAR || !numeric_ ? Status::singular : Status::converged;
    }

    void solve(ComplexVectorX& b) const override {
        matrix_.scale_right(b);
        klu_z_solve(symbolic_.get(), numeric_.get(), static_cast<int>(b.size()), 1,
                    reinterpret_cast<double*>(b.data()), &common_);
        check();
        matrix_.scale_solution(b);
    }

    [[nodiscard]] std::string_view name() const noexcept override { return "complex klu"; }

private:
    void check() const {
        if (common_.status == KLU_OUT_OF_MEMORY) throw std::bad_alloc();
        ancf::detail::require(common_.status >= KLU_OK, "klu refused the matrix, status ",
                              common_.status);
    }

    mutable klu_common common_;
    Equilibrated<std::complex<double>> matrix_;
    std::unique_ptr<klu_symbolic, FreeOfKlu> symbolic_;
    std::unique_ptr<klu_numeric, FreeOfComplexKlu> numeric_;
};

}  // namespace detail

ANCF_INLINE std::unique_ptr<ComplexSolver> Klu::complex_solver() const {
    return std::make_unique<detail::ComplexKlu>(options_.pivot_tolerance);
}

}  // namespace ancf::suitesparse
