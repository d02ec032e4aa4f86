// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/suitesparse/equilibrated.hpp>
#include <ancf/suitesparse/klu.hpp>

#include <klu.h>

#include <new>
#include <type_traits>

namespace ancf::suitesparse {

namespace detail {

/// The state of KLU: a matrix, scaled, and its factors.
/// @tparam Scalar  double or std::complex<double>
template <class Scalar>
class KluFactors {
public:
    using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

    explicit KluFactors(double pivot_tolerance) {
        klu_defaults(&common_);
        common_.tol = pivot_tolerance;
        common_.scale = -1;
    }
    KluFactors(const KluFactors&) = delete;
    KluFactors& operator=(const KluFactors&) = delete;
    ~KluFactors() {
        free_numeric();
        klu_free_symbolic(&symbolic_, &common_);
    }

    void analyze(const SparseMatrix& pattern) {
        matrix_.analyze(pattern);
        free_numeric();
        klu_free_symbolic(&symbolic_, &common_);
        symbolic_ = klu_analyze(matrix_.size(), matrix_.outer(), matrix_.inner(), &common_);
        check();
    }

    /// Which column is left without a pivot depends on KLU's order, not on the scene: untold.
    [[nodiscard]] Status factorize(const Scalar* values) {
        free_numeric();
        if (!matrix_.take(values)) return Status::not_finite;
        if (symbolic_ == nullptr) return Status::singular;  // no pivots whatever the values
        constexpr auto factor = real ? klu_factor : klu_z_factor;
        numeric_ = factor(matrix_.outer(), matrix_.inner(), matrix_.values(), symbolic_, &common_);
        check();
        const bool regular = common_.status != KLU_SINGULAR && numeric_ != nullptr;
        return regular ? Status::converged : Status::singular;
    }

    /// Replaces b by the solution.
    void solve(Column& b) const {
        constexpr auto substitute = real ? klu_solve : klu_z_solve;
        matrix_.scale_right(b);
        substitute(symbolic_, numeric_, static_cast<int>(b.size()), 1,
                   reinterpret_cast<double*>(b.data()), &common_);
        check();
        matrix_.scale_solution(b);
    }

    /// Returns the number of values.
    [[nodiscard]] std::size_t entries() const noexcept { return matrix_.entries(); }

private:
    static constexpr bool real = std::is_same_v<Scalar, double>;

    // The functions of KLU that free leave a null pointer.
    void free_numeric() noexcept {
        real ? klu_free_numeric(&numeric_, &common_) : klu_z_free_numeric(&numeric_, &common_);
    }

    // Throws what KLU's status asks for; a singular matrix is none of it.
    void check() const {
        if (common_.status == KLU_OUT_OF_MEMORY) throw std::bad_alloc();
        ancf::detail::require(common_.status >= KLU_OK, "klu refused the matrix, status ",
                              common_.status);
    }

    mutable klu_common common_;
    Equilibrated<Scalar> matrix_;
    klu_symbolic* symbolic_ = nullptr;
    klu_numeric* numeric_ = nullptr;
};

}  // namespace detail

struct Klu::Session : detail::KluFactors<double> {
    using KluFactors::KluFactors;
};

ANCF_INLINE void Klu::analyze_pattern(const SparseMatrix& matrix) {
    session_ = ancf::detail::hidden<Session>(options_.pivot_tolerance);
    session_->analyze(matrix);
}

ANCF_INLINE FactorReport Klu::factorize_values(const SparseMatrix& matrix) {
    return {session_->factorize(matrix.valuePtr())};
}

ANCF_INLINE void Klu::substitute(const VectorX& b, VectorX& x) const {
    x = b;
    session_->solve(x);
}

ANCF_INLINE std::unique_ptr<ComplexSolver> Klu::complex_solver() const {
    return std::unique_ptr<ComplexSolver>(
        new detail::ComplexDirect<detail::KluFactors>("complex klu", options_.pivot_tolerance));
}

}  // namespace ancf::suitesparse
