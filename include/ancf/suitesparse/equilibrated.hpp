// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// A matrix R A C of comparable rows, for the solvers of SuiteSparse.
///
/// Their own scaling sums or compares the entries of a row as they are. Lengths and slopes stand in
/// one row, so the pivots then depend on the units. R and C are of powers of two: exact.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/solver/complex_solver.hpp>
#include <ancf/solver/fixed_column.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <complex>
#include <cstddef>
#include <string_view>

namespace ancf::suitesparse::detail {

/// A copy of a square matrix, its rows and columns scaled.
/// @tparam Scalar  double or std::complex<double>
template <class Scalar>
class Equilibrated {
public:
    /// Takes a compressed pattern.
    void analyze(const SparseMatrix& pattern) {
        magnitudes_ = pattern;
        values_.resize(static_cast<std::size_t>(ancf::detail::entries(pattern)));
    }

    /// Takes values in the order of the pattern's. @return false where one is not finite.
    [[nodiscard]] bool take(const Scalar* values) {
        double* magnitudes = magnitudes_.valuePtr();
        for (std::size_t k = 0; k < values_.size(); ++k)
            magnitudes[k] = ancf::detail::magnitude(values[k]);
        if (!ancf::detail::all_finite(magnitudes_)) return false;
        columns_ = ancf::detail::unit_scales(magnitudes_);
        rows_ = ancf::detail::row_scales(magnitudes_, columns_);
        for (int j = 0; j < size(); ++j)
            for (int k = outer()[j]; k < outer()[j + 1]; ++k)
                values_[k] = values[k] * (rows_[inner()[k]] * columns_[j]);
        return true;
    }

    [[nodiscard]] int size() const noexcept { return static_cast<int>(magnitudes_.cols()); }
    [[nodiscard]] std::size_t entries() const noexcept { return values_.size(); }
    // the interfaces take arrays that are not constant; none is written to
    [[nodiscard]] int* outer() noexcept { return magnitudes_.outerIndexPtr(); }
    [[nodiscard]] int* inner() noexcept { return magnitudes_.innerIndexPtr(); }
    /// Of complex numbers pairs of doubles.
    [[nodiscard]] double* values() noexcept { return reinterpret_cast<double*>(values_.data()); }

    /// Turns b into R b.
    template <class Column>
    void scale_right(Column& b) const {
        for (int i = 0; i < size(); ++i) b[i] *= rows_[i];
    }
    /// Turns y, R A C y = R b, into x = C y.
    template <class Column>
    void scale_solution(Column& y) const {
        for (int i = 0; i < size(); ++i) y[i] *= columns_[i];
    }

private:
    SparseMatrix magnitudes_;
    List<Scalar> values_;
    VectorX rows_, columns_;
};

/// A solver of complex matrices.
/// @tparam Factors  of a scalar: the matrix and its factors in one of the libraries
template <template <class> class Factors>
class ComplexDirect final : public ComplexSolver {
public:
    template <class Setting>
    ComplexDirect(std::string_view name, Setting setting) : name_(name), factors_(setting) {}

    void analyze(const SparseMatrix& pattern) override {
        ancf::detail::require_storage(name_, pattern, Storage::full);
        factors_.analyze(pattern);
    }
    [[nodiscard]] Status factorize(const List<std::complex<double>>& values) override {
        ancf::detail::require(values.size() == factors_.entries(), name_, ": expected ",
                              factors_.entries(), " values, got ", values.size());
        return factors_.factorize(values.data());
    }
    void solve(ComplexVectorX& b) const override { factors_.solve(b); }
    [[nodiscard]] std::string_view name() const noexcept override { return name_; }

private:
    std::string_view name_;
    Factors<std::complex<double>> factors_;
};

}  // namespace ancf::suitesparse::detail
