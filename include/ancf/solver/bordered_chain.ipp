// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/solver/bordered_chain.hpp>
#include <ancf/solver/direct_solver.hpp>
#include <ancf/solver/eigen_lu.hpp>

#include <complex>

namespace ancf {
namespace detail {

/// BorderedChain of complex matrices.
class ComplexBorderedChain final : public ComplexSolver {
public:
    explicit ComplexBorderedChain(std::unique_ptr<ComplexSolver> general)
        : general_(std::move(general)) {}

    void analyze(const SparseMatrix& pattern) override {
        require_storage(name(), pattern, Storage::full);
        is_chain_ = factors_.analyze(pattern);
        require(is_chain_ || general_, name(), " has no general solver: see complex_solver_for");
        by_chain_ = analysed_ = false;
        pattern_ = pattern;
    }

    [[nodiscard]] Status factorize(const List<std::complex<double>>& values) override {
        by_chain_ =
            is_chain_ && values.size() == factors_.entries() && factors_.factorize(values.data());
        if (by_chain_) return Status::converged;
        if (!general_) return Status::singular;
        if (!analysed_) general_->analyze(pattern_);
        analysed_ = true;
        return general_->factorize(values);
    }

    void solve(ComplexVectorX& b) const override {
        require(by_chain_ || analysed_, name(), " has no factorisation");
        by_chain_ ? factors_.solve(b.data()) : general_->solve(b);
    }

    [[nodiscard]] std::string_view name() const noexcept override {
        return is_chain_ || !general_ ? "complex bordered-chain" : general_->name();
    }
    void take_general(std::unique_ptr<ComplexSolver> general) override {
        if (!general_) general_ = std::move(general);
    }

private:
    std::unique_ptr<ComplexSolver> general_;
    BorderedFactors<std::complex<double>> factors_;
    SparseMatrix pattern_;
    bool is_chain_ = false, by_chain_ = false;
    bool analysed_ = false;  // by the general solver
};

}  // namespace detail

ANCF_LAZY BorderedChain::BorderedChain() : general_(std::make_unique<EigenLu>()) {}

ANCF_INLINE BorderedChain::BorderedChain(std::unique_ptr<LinearSolver> general,
                                         double singular_rcond)
    : general_(std::move(general)), singular_rcond_(singular_rcond) {
    detail::require_singular_rcond(singular_rcond);
    detail::require(general_ != nullptr, "BorderedChain needs a general solver, got none");
    detail::require(general_->storage() == Storage::full,
                    "BorderedChain needs a solver of any matrices, of full storage, got ",
                    general_->name());
}

ANCF_INLINE void BorderedChain::analyze(const SparseMatrix& matrix) {
    detail::require_storage("bordered-chain", matrix, storage());
    stage_.reset();
    is_chain_ = factors_.analyze(matrix);
    by_chain_ = false;
    detail::require(is_chain_ || general_, "BorderedChain was moved from: it takes chains alone");
    analysed_ = !is_chain_;
    if (analysed_) general_->analyze(matrix);
    stage_.analysed(matrix);
}

ANCF_INLINE FactorReport BorderedChain::factorize(const SparseMatrix& matrix) {
    stage_.begin_factorisation(name(), matrix);
    detail::require(!is_chain_ || factors_.has_pattern(matrix), name(),
                    " analysed another pattern");
    FactorReport report;
    by_chain_ = is_chain_ && factors_.factorize(matrix.valuePtr());
    if (by_chain_) {
        detail::report_condition(
            matrix, storage(), singular_rcond_,
            [this](const VectorX& b, VectorX& x) {
                x = b;
                factors_.solve(x.data());
            },
            report);
        by_chain_ = report.status == Status::converged;
    }
    if (!by_chain_ && !general_) detail::report_failure(matrix, -1, report);
    if (!by_chain_ && general_) {
        if (!analysed_) general_->analyze(matrix);
        analysed_ = true;
        report = general_->factorize(matrix);
    }
    return stage_.finished(report);
}

ANCF_INLINE void BorderedChain::solve(const VectorX& b, VectorX& x) const {
    stage_.require_solvable(name(), b);
    if (!by_chain_) return general_->solve(b, x);
    if (&x != &b) x = b;
    factors_.solve(x.data());
}

ANCF_INLINE std::unique_ptr<ComplexSolver> BorderedChain::complex_solver() const {
    return std::make_unique<detail::ComplexBorderedChain>(general_ ? general_->complex_solver()
                                                                   : nullptr);
}

}  // namespace ancf
