// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/error.hpp>
#include <ancf/solver/block_tridiagonal.hpp>
#include <ancf/solver/block_tridiagonal_kernel.hpp>
#include <ancf/solver/block_tridiagonal_layout.hpp>
#include <ancf/solver/complex_solver_for.hpp>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

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
        inner_.assign(pattern.innerIndexPtr(), pattern.innerIndexPtr() + pattern.nonZeros());
        panels_.resize(layout_.panel_entries());
    }

    [[nodiscard]] Status factorize(const std::vector<std::complex<double>>& values) override {
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
    std::vector<int> outer_, inner_;
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
        magnitudes_ = pattern;
        // column by column the places of both halves: rows ascend, as mirror images come first
        const auto size = static_cast<std::size_t>(pattern.cols());
        std::vector<std::vector<std::pair<int, int>>> columns(size);  // row, place
        for (int j = 0; j < pattern.cols(); ++j)
            for (int k = pattern.outerIndexPtr()[j]; k < pattern.outerIndexPtr()[j + 1]; ++k) {
                const int i = pattern.innerIndexPtr()[k];
                columns[j].emplace_back(i, k);
                if (storage_ == Storage::lower && i != j) columns[i].emplace_back(j, k);
            }
        matrix_.resize(pattern.rows(), pattern.cols());
        int count = 0;
        for (const auto& column : columns) count += static_cast<int>(column.size());
        matrix_.resizeNonZeros(count);
        count = 0;
        from_.clear();
        for (std::size_t j = 0; j < size; ++j) {
            matrix_.outerIndexPtr()[j] = count;
            for (const auto& [row, place] : columns[j]) {
                matrix_.innerIndexPtr()[count] = row;
                matrix_.valuePtr()[count++] = 1.0;
                from_.push_back(place);
            }
        }
        matrix_.outerIndexPtr()[size] = count;
        inverse_.resize(size);
        lu_ = std::make_unique<Eigen::SparseLU<Matrix, Ordering>>();
        if (size > 0) lu_->analyzePattern(matrix_);
    }

    [[nodiscard]] Status factorize(const std::vector<std::complex<double>>& values) override {
        const auto given = static_cast<std::size_t>(magnitudes_.nonZeros());
        require(lu_ != nullptr && values.size() == given, name(), ": expected ", given,
                " values, got ", values.size());
        for (std::size_t k = 0; k < given; ++k) magnitudes_.valuePtr()[k] = std::abs(values[k]);
        if (!all_finite(magnitudes_)) return Status::not_finite;
        // entries of a row compare where each unknown is measured by its own scale, as in EigenLu
        const VectorX scales = unit_scales(magnitudes_);
        std::fill(inverse_.begin(), inverse_.end(), 0.0);
        std::complex<double>* entries = matrix_.valuePtr();
        const auto row = [&](Eigen::Index k) -> double& {
            return inverse_[matrix_.innerIndexPtr()[k]];
        };
        for (Eigen::Index j = 0; j < matrix_.cols(); ++j)
            for (Eigen::Index k = matrix_.outerIndexPtr()[j]; k < matrix_.outerIndexPtr()[j + 1];
                 ++k) {
                const int place = from_[k];
                entries[k] = values[place];
                row(k) = std::max(row(k), magnitudes_.valuePtr()[place] * scales[j]);
            }
        for (double& inverse : inverse_) inverse = inverse > 0.0 ? 1.0 / inverse : 1.0;
        for (Eigen::Index k = 0; k < matrix_.nonZeros(); ++k) entries[k] *= row(k);
        if (matrix_.cols() == 0) return Status::converged;
        lu_->factorize(matrix_);
        return lu_->info() == Eigen::Success ? Status::converged : Status::singular;
    }

    void solve(ComplexVectorX& b) const override {
        require(lu_ != nullptr, name(), ": solve without a factorisation");
        if (b.size() == 0) return;
        for (Eigen::Index i = 0; i < b.size(); ++i) b[i] *= inverse_[i];
        const ComplexVectorX x = lu_->solve(b);
        b = x;
    }

    [[nodiscard]] std::string_view name() const noexcept override { return "complex eigen-lu"; }

private:
    using Matrix = Eigen::SparseMatrix<std::complex<double>, Eigen::ColMajor, int>;

    Storage storage_;
    Matrix matrix_;                // both halves
    std::vector<int> from_;        // of each value of the matrix its place in those given
    SparseMatrix magnitudes_;      // of the values given
    std::vector<double> inverse_;  // of each row's largest entry
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
