// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/error.hpp>
#include <ancf/suitesparse/cholmod.hpp>

#include <cholmod.h>

#include <cstddef>
#include <new>

namespace ancf::suitesparse {

namespace detail {

// CHOLMOD before version 4 has a fixed number of threads. Its OpenMP is there if it is threaded;
// names of its own, as a header of OpenMP may be there too and differ.
#if defined(__linux__) && CHOLMOD_MAIN_VERSION < 4
[[gnu::weak]] int openmp_levels() __asm__("omp_get_max_active_levels");
[[gnu::weak]] void set_openmp_levels(int levels) __asm__("omp_set_max_active_levels");
#define ANCF_CHOLMOD_LEVELS 1
#endif

/// While it lives, OpenMP starts no threads on behalf of the calling one.
class Unthreaded {
public:
    /// @param wanted  false: leaves all as it is
    explicit Unthreaded([[maybe_unused]] bool wanted) noexcept {
#if defined(ANCF_CHOLMOD_LEVELS)
        if (!wanted || openmp_levels == nullptr || set_openmp_levels == nullptr) return;
        levels_ = openmp_levels();
        set_openmp_levels(0);
#endif
    }
    ~Unthreaded() {
#if defined(ANCF_CHOLMOD_LEVELS)
        if (levels_ >= 0) set_openmp_levels(levels_);
#endif
    }
    Unthreaded(const Unthreaded&) = delete;
    Unthreaded& operator=(const Unthreaded&) = delete;

private:
    [[maybe_unused]] int levels_ = -1;  // allowed before, -1: unchanged
};

#undef ANCF_CHOLMOD_LEVELS

/// Returns CHOLMOD's view of a matrix, which it does not write to.
[[nodiscard]] ANCF_INLINE cholmod_sparse view(const SparseMatrix& lower) noexcept {
    cholmod_sparse view = {};
    view.nrow = static_cast<std::size_t>(lower.rows());
    view.ncol = static_cast<std::size_t>(lower.cols());
    view.nzmax = static_cast<std::size_t>(lower.nonZeros());
    view.p = const_cast<int*>(lower.outerIndexPtr());
    view.i = const_cast<int*>(lower.innerIndexPtr());
    view.x = const_cast<double*>(lower.valuePtr());
    view.stype = -1;  // symmetric, lower half stored
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    return view;
}

/// Returns the number of negative entries of D; none in L L^T.
[[nodiscard]] ANCF_INLINE int negative_pivots(const cholmod_factor& factor) noexcept {
    if (factor.is_ll != 0) return 0;
    const auto* start = static_cast<const int*>(factor.p);
    const auto* value = static_cast<const double*>(factor.x);
    int count = 0;
    for (std::size_t k = 0; k < factor.n; ++k) count += value[start[k]] < 0.0 ? 1 : 0;
    return count;
}

}  // namespace detail

/// The state of CHOLMOD: parameters, factor and the workspace of solve.
class Cholmod::Session {
public:
    /// Nothing is printed, no handler called.
    explicit Session(const CholmodOptions& options) {
        cholmod_start(&common_);
        common_.print = 0;
        common_.error_handler = nullptr;
        switch (options.mode) {
            case CholmodMode::automatic: common_.supernodal = CHOLMOD_AUTO; break;
            case CholmodMode::simplicial: common_.supernodal = CHOLMOD_SIMPLICIAL; break;
            case CholmodMode::supernodal: common_.supernodal = CHOLMOD_SUPERNODAL; break;
        }
        if (options.ordering == CholmodOrdering::automatic) return;
        const bool natural = options.ordering == CholmodOrdering::natural;
        common_.nmethods = 1;
        common_.method[0].ordering = natural ? CHOLMOD_NATURAL : CHOLMOD_AMD;
        common_.postorder = natural ? 0 : 1;
    }
    ~Session() {
        cholmod_free_factor(&factor_, &common_);
        for (cholmod_dense** const dense : {&x_, &y_, &e_}) cholmod_free_dense(dense, &common_);
        cholmod_finish(&common_);
    }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Returns the factor; null before analyze.
    [[nodiscard]] const cholmod_factor* factor() const noexcept { return factor_; }

    /// Called once.
    void analyze(cholmod_sparse matrix) {
        factor_ = cholmod_analyze(&matrix, &common_);
        check();
    }

    void factorize(cholmod_sparse matrix) {
        cholmod_factorize(&matrix, factor_, &common_);
        check();
    }

    /// Solves with the factor; returns the solution, owned by the session.
    const double* solve(cholmod_dense& b) {
        cholmod_solve2(CHOLMOD_A, factor_, &b, nullptr, &x_, nullptr, &y_, &e_, &common_);
        check();
        return static_cast<const double*>(x_->x);
    }

private:
    // Throws what the last call's status asks for: bad_alloc, or InvalidArgument.
    void check() const {
        const int status = common_.status;
        if (status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
        ancf::detail::require(status >= CHOLMOD_OK, "cholmod refused the matrix, status ", status,
                              status == CHOLMOD_TOO_LARGE ? ": too large for 32-bit indices" : "");
    }

    cholmod_common common_;
    cholmod_factor* factor_ = nullptr;
    cholmod_dense *x_ = nullptr, *y_ = nullptr, *e_ = nullptr;
};

ANCF_INLINE bool Cholmod::supernodal() const noexcept {
    return session_ && session_->factor() != nullptr && session_->factor()->is_super != 0;
}

ANCF_INLINE void Cholmod::analyze_pattern(const SparseMatrix& lower) {
    session_ = ancf::detail::hidden<Session>(options_);
    session_->analyze(detail::view(lower));
}

ANCF_INLINE FactorReport Cholmod::factorize_values(const SparseMatrix& lower) {
    const detail::Unthreaded unthreaded(!options_.threads);
    session_->factorize(detail::view(lower));
    const cholmod_factor& factor = *session_->factor();
    FactorReport report;
    if (factor.minor < factor.n)
        ancf::detail::report_failure(lower, static_cast<const int*>(factor.Perm)[factor.minor],
                                     report);
    else
        report.negative_pivots = detail::negative_pivots(factor);
    return report;
}

ANCF_INLINE void Cholmod::substitute(const VectorX& b, VectorX& x) const {
    const detail::Unthreaded unthreaded(!options_.threads);
    cholmod_dense right = {};
    right.nrow = right.nzmax = right.d = static_cast<std::size_t>(b.size());
    right.ncol = 1;
    right.x = const_cast<double*>(b.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    x = Eigen::Map<const VectorX>(session_->solve(right), b.size());
}

}  // namespace ancf::suitesparse
