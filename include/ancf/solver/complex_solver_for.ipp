// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/block_tridiagonal_kernel.hpp>
#include <ancf/solver/block_tridiagonal_layout.hpp>
#include <ancf/solver/complex_solver_for.hpp>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseLU>

#include <cmath>
#include <complex>
#include <cstddef>
#include <numeric>
#include <string_view>

namespace ancf {
namespace detail {

/// L D L^T block by block of a complex symmetric matrix, without pivoting.
///
/// Stable where a factor exp(i phi) makes the real part positive definite; a vanishing pivot counts
/// as singular. The lower half is read.
class ComplexBlockTridiagonal final : public ComplexSolver {
public:
    void analyze(const SparseMatrix& pattern) override {
        require_storage(name(), pattern, Storage::lower);
        layout_ = chain_layout(name(), pattern);
        outer_.assign(pattern.outerIndexPtr(), pattern.outerIndexPtr() + pattern.cols() + 1);
        inner_.assign(pattern.innerIndexPtr(), pattern.innerIndexPtr() + entries(pattern));
        panels_.resize(layout_.panel_entries());
    }

    [[nodiscard]] Status factorize(const List<std::complex<double>>& values) override {
        require(values.size() == inner_.size(), name(), ": expected ", inner_.size(),
                " values, got ", values.size());
        for (const std::complex<double>& value : values)
            if (!std::isfinite(value.real()) || !std::isfinite(value.imag()))
                return Status::not_finite;
        const PivotSummary summary = factorize_chain<std::complex<double>>(
            layout_, {outer_.data(), inner_.data(), values.data()}, panels_.data(), nullptr,
            nullptr);
        return summary.failed_column >= 0 ? Status::singular : Status::converged;
    }

    void solve(ComplexVectorX& b) const override { solve_chain(layout_, panels_.data(), b.data()); }

    [[nodiscard]] std::string_view name() const noexcept override {
        return "complex block-tridiagonal";
    }

private:
    BlockLayout layout_;
    List<int> outer_, inner_;
    ComplexVectorX panels_;
};

/// L U with partial pivoting, columns ordered by COLAMD, rows scaled as those of EigenLu.
///
/// A template so that only a program that makes one compiles Eigen's factorisation.
/// @tparam Ordering  Eigen's, of the columns
template <class Ordering>
class EigenComplexLu final : public ComplexSolver {
public:
    /// @param storage  of the matrices to come; of the lower half the other one is filled in.
    explicit EigenComplexLu(Storage storage) : storage_(storage) {}

    void analyze(const SparseMatrix& pattern) override {
        require_storage(name(), pattern, storage_);
        given_ = static_cast<std::size_t>(entries(pattern));
        SparseMatrix places = pattern;  // from 1 on: none vanishes
        std::iota(places.valuePtr(), places.valuePtr() + given_, 1.0);
        magnitudes_ = leading_block(places, static_cast<int>(pattern.cols()), storage_);
        from_.clear();
        for (int k = 0; k < entries(magnitudes_); ++k)
            from_.push_back(static_cast<std::size_t>(magnitudes_.valuePtr()[k]));
        matrix_ = magnitudes_.cast<std::complex<double>>();
        lu_ = std::make_unique<Eigen::SparseLU<Matrix, Ordering>>();
        if (matrix_.cols() > 0) lu_->analyzePattern(matrix_);
    }

    [[nodiscard]] Status factorize(const List<std::complex<double>>& values) override {
        require(lu_ != nullptr && values.size() == given_, name(), ": expected ", given_,
                " values, got ", values.size());
        for (std::size_t k = 0; k < from_.size(); ++k) {
            matrix_.valuePtr()[k] = values[from_[k] - 1];
            magnitudes_.valuePtr()[k] = std::abs(matrix_.valuePtr()[k]);
        }
        if (!all_finite(magnitudes_)) return Status::not_finite;
        rows_ = row_scales(magnitudes_, unit_scales(magnitudes_));
        for (std::size_t k = 0; k < from_.size(); ++k)
            matrix_.valuePtr()[k] *= rows_[matrix_.innerIndexPtr()[k]];
        if (matrix_.cols() == 0) return Status::converged;
        lu_->factorize(matrix_);
        return lu_->info() == Eigen::Success ? Status::converged : Status::singular;
    }

    void solve(ComplexVectorX& b) const override {
        require(lu_ != nullptr, name(), ": solve without a factorisation");
        if (b.size() == 0) return;
        for (Eigen::Index i = 0; i < b.size(); ++i) b[i] *= rows_[i];
        const ComplexVectorX x = lu_->solve(b);
        b = x;
    }

    [[nodiscard]] std::string_view name() const noexcept override { return "complex eigen-lu"; }

private:
    using Matrix = Eigen::SparseMatrix<std::complex<double>, Eigen::ColMajor, int>;

    Storage storage_;
    std::size_t given_ = 0;
    Matrix matrix_;            // both halves
    List<std::size_t> from_;   // of each of its values the place, from 1 on, in those given
    SparseMatrix magnitudes_;  // of its values
    VectorX rows_;             // scales
    std::unique_ptr<Eigen::SparseLU<Matrix, Ordering>> lu_;
};

}  // namespace detail

ANCF_LAZY std::unique_ptr<ComplexSolver> complex_solver_for(const LinearSolver& solver,
                                                            const SparseMatrix& pattern) {
    using General = detail::EigenComplexLu<Eigen::COLAMDOrdering<int>>;
    std::unique_ptr<ComplexSolver> result = solver.complex_solver();
    if (result) result->take_general(std::make_unique<General>(solver.storage()));
    if (!result && solver.storage() == Storage::lower && BlockTridiagonal::accepts(pattern))
        result = std::make_unique<detail::ComplexBlockTridiagonal>();
    if (!result) result = std::make_unique<General>(solver.storage());
    result->analyze(pattern);
    return result;
}

}  // namespace ancf
