// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Definitions of eigen_complex_lu.hpp.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/error.hpp>
#include <ancf/solver/eigen_complex_lu.hpp>

#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ancf {

template <class Ordering>
struct BasicEigenComplexLu<Ordering>::Factors {
    using Matrix = Eigen::SparseMatrix<std::complex<double>, Eigen::ColMajor, int>;

    Matrix matrix;                // both halves
    std::vector<int> from;        // of each value of the matrix its place in those given
    SparseMatrix magnitudes;      // of the values given
    std::vector<double> inverse;  // of each row's largest entry
    Eigen::SparseLU<Matrix, Ordering> lu;
};

template <class Ordering>
void BasicEigenComplexLu<Ordering>::analyze(const SparseMatrix& pattern) {
    detail::require_storage(name(), pattern, storage_);
    factors_ = detail::hidden<Factors>();
    factors_->magnitudes = pattern;
    // column by column the places of both halves: rows ascend, as mirror images come first
    const auto size = static_cast<std::size_t>(pattern.cols());
    std::vector<std::vector<std::pair<int, int>>> columns(size);  // row, place
    for (int j = 0; j < pattern.cols(); ++j)
        for (int k = pattern.outerIndexPtr()[j]; k < pattern.outerIndexPtr()[j + 1]; ++k) {
            const int i = pattern.innerIndexPtr()[k];
            columns[j].emplace_back(i, k);
            if (storage_ == Storage::lower && i != j) columns[i].emplace_back(j, k);
        }
    typename Factors::Matrix& matrix = factors_->matrix;
    matrix.resize(pattern.rows(), pattern.cols());
    int count = 0;
    for (const auto& column : columns) count += static_cast<int>(column.size());
    matrix.resizeNonZeros(count);
    count = 0;
    for (std::size_t j = 0; j < size; ++j) {
        matrix.outerIndexPtr()[j] = count;
        for (const auto& [row, place] : columns[j]) {
            matrix.innerIndexPtr()[count] = row;
            matrix.valuePtr()[count++] = 1.0;
            factors_->from.push_back(place);
        }
    }
    matrix.outerIndexPtr()[size] = count;
    factors_->inverse.resize(size);
    if (size > 0) factors_->lu.analyzePattern(matrix);
}

template <class Ordering>
Status BasicEigenComplexLu<Ordering>::factorize(const std::vector<std::complex<double>>& values) {
    const auto given = static_cast<std::size_t>(factors_ ? factors_->magnitudes.nonZeros() : 0);
    detail::require(factors_ && values.size() == given, name(), ": expected ", given,
                    " values, got ", values.size());
    Factors& own = *factors_;
    for (std::size_t k = 0; k < given; ++k) own.magnitudes.valuePtr()[k] = std::abs(values[k]);
    if (!detail::all_finite(own.magnitudes)) return Status::not_finite;
    // entries of a row compare where each unknown is measured by its own scale, as in EigenLu
    const VectorX scales = detail::unit_scales(own.magnitudes);
    std::fill(own.inverse.begin(), own.inverse.end(), 0.0);
    std::complex<double>* entries = own.matrix.valuePtr();
    const auto row = [&](Eigen::Index k) -> double& {
        return own.inverse[own.matrix.innerIndexPtr()[k]];
    };
    for (Eigen::Index j = 0; j < own.matrix.cols(); ++j)
        for (Eigen::Index k = own.matrix.outerIndexPtr()[j]; k < own.matrix.outerIndexPtr()[j + 1];
             ++k) {
            const int place = own.from[k];
            entries[k] = values[place];
            row(k) = std::max(row(k), own.magnitudes.valuePtr()[place] * scales[j]);
        }
    for (double& inverse : own.inverse) inverse = inverse > 0.0 ? 1.0 / inverse : 1.0;
    for (Eigen::Index k = 0; k < own.matrix.nonZeros(); ++k) entries[k] *= row(k);
    if (own.matrix.cols() == 0) return Status::converged;
    own.lu.factorize(own.matrix);
    return own.lu.info() == Eigen::Success ? Status::converged : Status::singular;
}

template <class Ordering>
void BasicEigenComplexLu<Ordering>::solve(ComplexVectorX& b) const {
    detail::require(factors_ != nullptr, name(), ": solve without a factorisation");
    if (b.size() == 0) return;
    for (Eigen::Index i = 0; i < b.size(); ++i) b[i] *= factors_->inverse[i];
    const ComplexVectorX x = factors_->lu.solve(b);
    b = x;
}

#if defined(ANCF_SOURCE)
template class BasicEigenComplexLu<Eigen::COLAMDOrdering<int>>;
#endif

}  // namespace ancf
