// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/error.hpp>
#include <ancf/suitesparse/equilibrated.hpp>
#include <ancf/suitesparse/umfpack.hpp>

#include <umfpack.h>

#include <array>
#include <new>
#include <type_traits>

namespace ancf::suitesparse {

namespace detail {

/// The state of UMFPACK: a matrix, scaled, and its factors. Of complex numbers its interface takes
/// pairs of doubles where the imaginary parts are a null pointer.
/// @tparam Scalar  double or std::complex<double>
template <class Scalar>
class UmfpackFactors {
public:
    using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

    explicit UmfpackFactors(int refinement_steps) {
        real ? umfpack_di_defaults(control_.data()) : umfpack_zi_defaults(control_.data());
        control_[UMFPACK_PRL] = 0.0;
        control_[UMFPACK_SCALE] = UMFPACK_SCALE_NONE;
        control_[UMFPACK_IRSTEP] = refinement_steps;
    }

    void analyze(const SparseMatrix& pattern) {
        matrix_.analyze(pattern);
        numeric_.reset();
        const int n = matrix_.size();
        int *outer = matrix_.outer(), *inner = matrix_.inner();
        void* symbolic = nullptr;  // by the pattern alone: the values may not be known yet
        const int status = real ? umfpack_di_symbolic(n, n, outer, inner, nullptr, &symbolic,
                                                      control_.data(), nullptr)
                                : umfpack_zi_symbolic(n, n, outer, inner, nullptr, nullptr,
                                                      &symbolic, control_.data(), nullptr);
        symbolic_.reset(symbolic);
        check(status);
    }

    [[nodiscard]] Status factorize(const Scalar* values) {
        numeric_.reset();
        if (!matrix_.take(values)) return Status::not_finite;
        int *outer = matrix_.outer(), *inner = matrix_.inner();
        void* numeric = nullptr;
        const int status =
            real ? umfpack_di_numeric(outer, inner, matrix_.values(), symbolic_.get(), &numeric,
                                      control_.data(), nullptr)
                 : umfpack_zi_numeric(outer, inner, matrix_.values(), nullptr, symbolic_.get(),
                                      &numeric, control_.data(), nullptr);
        numeric_.reset(numeric);
        check(status);
        return status == UMFPACK_WARNING_singular_matrix ? Status::singular : Status::converged;
    }

    /// Replaces b by the solution.
    void solve(Column& b) const {
        Column solution(b.size());
        matrix_.scale_right(b);
        int *outer = matrix_.outer(), *inner = matrix_.inner();
        auto* x = reinterpret_cast<double*>(solution.data());
        auto* right = reinterpret_cast<double*>(b.data());
        check(real
                  ? umfpack_di_solve(UMFPACK_A, outer, inner, matrix_.values(), x, right,
                                     numeric_.get(), control_.data(), nullptr)
                  : umfpack_zi_solve(UMFPACK_A, outer, inner, matrix_.values(), nullptr, x, nullptr,
                                     right, nullptr, numeric_.get(), control_.data(), nullptr));
        b.swap(solution);
        matrix_.scale_solution(b);
    }

    /// Returns the number of values.
    [[nodiscard]] std::size_t entries() const noexcept { return matrix_.entries(); }

private:
    static constexpr bool real = std::is_same_v<Scalar, double>;

    // Frees what UMFPACK allocated.
    template <auto OfReal, auto OfComplex>
    struct Free {
        void operator()(void* object) const noexcept { (real ? OfReal : OfComplex)(&object); }
    };

    // Throws what a status of UMFPACK asks for; the warning of a singular matrix is none.
    static void check(int status) {
        if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
        ancf::detail::require(status >= UMFPACK_OK, "umfpack refused the matrix, status ", status);
    }

    std::array<double, UMFPACK_CONTROL> control_;
    mutable Equilibrated<Scalar> matrix_;  // UMFPACK only reads it
    std::unique_ptr<void, Free<umfpack_di_free_symbolic, umfpack_zi_free_symbolic>> symbolic_;
    std::unique_ptr<void, Free<umfpack_di_free_numeric, umfpack_zi_free_numeric>> numeric_;
};

}  // namespace detail

struct Umfpack::Session : detail::UmfpackFactors<double> {
    using UmfpackFactors::UmfpackFactors;
};

ANCF_INLINE Umfpack::Umfpack(const UmfpackOptions& options)
    : DirectSolver(options.singular_rcond), options_(options) {
    ancf::detail::require(options.refinement_steps >= 0,
                          "refinement_steps must not be negative, got ", options.refinement_steps);
}

ANCF_INLINE void Umfpack::analyze_pattern(const SparseMatrix& matrix) {
    session_ = ancf::detail::hidden<Session>(options_.refinement_steps);
    session_->analyze(matrix);
}

ANCF_INLINE FactorReport Umfpack::factorize_values(const SparseMatrix& matrix) {
    return {session_->factorize(matrix.valuePtr())};
}

ANCF_INLINE void Umfpack::substitute(const VectorX& b, VectorX& x) const {
    x = b;
    session_->solve(x);
}

ANCF_INLINE std::unique_ptr<ComplexSolver> Umfpack::complex_solver() const {
    return std::make_unique<detail::ComplexDirect<detail::UmfpackFactors>>(
        "complex umfpack", options_.refinement_steps);
}

}  // namespace ancf::suitesparse
