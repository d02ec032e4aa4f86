// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/solver/block_tridiagonal_kernel.hpp>
#include <ancf/solver/bordered_factors.hpp>
#include <ancf/solver/direct_solver.hpp>

#include <cmath>
#include <cstdint>

namespace ancf::detail {

/// Divides the unknowns into a chain and a border of at least this width; false where none does.
template <class Scalar>
bool BorderedFactors<Scalar>::divide(int least_border) {
    const auto size = static_cast<int>(pattern_.cols());
    int width = 0;
    int found = 0;
    for (int border = std::min(max_border, size - 1); border >= least_border; --border) {
        const int widest = widest_block(chain_starts(pattern_, size - border));
        if (widest > widest_compiled_block) break;  // as it is with more rows
        const int fitting = fitting_width(widest);
        if (width > 0 && fitting > width) break;
        width = fitting;
        found = border;
    }
    if (width == 0) return false;
    border_ = found;
    chain_ = size - border_;
    const int* outer = pattern_.outerIndexPtr();
    const int* inner = pattern_.innerIndexPtr();
    chain_outer_.assign(1, 0);
    for (auto* list : {&chain_inner_, &chain_slots_}) list->clear();
    for (auto* list : {&across_, &corner_}) list->clear();
    diagonal_.assign(static_cast<std::size_t>(size), -1);
    for (int column = 0; column < size; ++column) {
        for (int slot = outer[column]; slot < outer[column + 1]; ++slot) {
            const int row = inner[slot];
            if (row == column) diagonal_[row] = slot;
            if (row >= chain_ && column >= chain_) {
                corner_.push_back({row - chain_, column - chain_, slot});
            } else if (row >= chain_) {
                across_.push_back({row - chain_, column, slot});
            } else if (row >= column) {
                chain_inner_.push_back(row);
                chain_slots_.push_back(slot);
            }
        }
        if (column < chain_) chain_outer_.push_back(static_cast<int>(chain_inner_.size()));
    }
    layout_ = block_layout(chain_outer_.data(), chain_starts(pattern_, chain_), width);
    panels_.resize(static_cast<std::size_t>(layout_.panel_entries()));
    chain_values_.resize(chain_slots_.size());
    columns_.resize(static_cast<std::size_t>(chain_) * static_cast<std::size_t>(border_));
    scales_.resize(static_cast<std::size_t>(size));
    probe_.resize(static_cast<std::size_t>(size));
    roots_.resize(chain_);
    load_.resize(chain_);
    return true;
}

template <class Scalar>
bool BorderedFactors<Scalar>::factorize(const Scalar* values) {
    const int needed = border_of(values);
    if (needed > border_ && (needed > max_border || !divide(needed))) return false;
    return scale(values) && factorize_chain(values) && factorize_border(values) &&
           proves_right(values);
}

/// Returns the width of the border that leaves no zero on the diagonal of the chain.
template <class Scalar>
int BorderedFactors<Scalar>::border_of(const Scalar* values) const {
    for (int i = 0; i < chain_; ++i) {
        const int slot = diagonal_[i];
        if (slot < 0 || magnitude(values[slot]) == 0.0) return chain_ + border_ - i;
    }
    return border_;
}

/// Finds scales of the unknowns; returns whether there are.
template <class Scalar>
bool BorderedFactors<Scalar>::scale(const Scalar* values) {
    const auto size = [values](int slot) { return slot < 0 ? 0.0 : magnitude(values[slot]); };
    for (std::size_t i = 0; i < scales_.size(); ++i) scales_[i] = std::sqrt(size(diagonal_[i]));
    // of a multiplier: what its largest entry becomes one by
    const auto couple = [&](std::size_t row, std::size_t column, int slot) {
        if (row == column || size(diagonal_[row]) > 0.0 || !(scales_[column] > 0.0)) return;
        scales_[row] = std::max(scales_[row], size(slot) / scales_[column]);
    };
    const auto n = static_cast<std::size_t>(chain_);
    for (const Entry& entry : across_) couple(n + entry.row, entry.column, entry.slot);
    for (const Entry& entry : corner_) couple(n + entry.row, n + entry.column, entry.slot);
    for (double& root : scales_) {
        root = 1.0 / root;
        if (!std::isfinite(root)) return false;
    }
    return true;
}

template <class Scalar>
bool BorderedFactors<Scalar>::factorize_chain(const Scalar* values) {
    for (std::size_t k = 0; k < chain_slots_.size(); ++k)
        chain_values_[k] = values[chain_slots_[k]];
    return detail::factorize_chain<Scalar>(
               layout_, {chain_outer_.data(), chain_inner_.data(), chain_values_.data()},
               panels_.data(), roots_.data(), load_.data())
               .failed_column < 0;
}

/// Makes A^-1 B^T and the factors of S.
template <class Scalar>
bool BorderedFactors<Scalar>::factorize_border(const Scalar* values) {
    const auto m = static_cast<std::size_t>(border_), n = static_cast<std::size_t>(chain_);
    std::fill(columns_.begin(), columns_.end(), Scalar(0.0));
    DynamicMatrix<Scalar>& S = small_.factors;
    S.setZero(border_, border_);
    for (const Entry& entry : across_) columns_[entry.row * n + entry.column] = values[entry.slot];
    for (std::size_t k = 0; k < m; ++k)
        solve_chain(layout_, panels_.data(), columns_.data() + k * n);
    for (const Entry& entry : corner_) S(entry.row, entry.column) += values[entry.slot];
    for (const Entry& entry : across_) {
        const Scalar value = values[entry.slot];
        for (std::size_t k = 0; k < m; ++k)
            S.data()[entry.row + k * m] -= product(value, columns_[k * n + entry.column]);
    }
    return small_.factorize();
}

template <class Scalar>
void BorderedFactors<Scalar>::solve(Scalar* x) const {
    const auto m = static_cast<std::size_t>(border_), n = static_cast<std::size_t>(chain_);
    Scalar* y = x + n;
    for (std::size_t k = 0; k < m; ++k)  // c - B A^-1 b
        for (std::size_t i = 0; i < n; ++i) y[k] -= product(columns_[k * n + i], x[i]);
    small_.solve(y);
    solve_chain(layout_, panels_.data(), x);
    for (std::size_t k = 0; k < m; ++k)
        for (std::size_t i = 0; i < n; ++i) x[i] -= product(columns_[k * n + i], y[k]);
}

/// Returns whether a known vector comes back from a solution.
template <class Scalar>
bool BorderedFactors<Scalar>::proves_right(const Scalar* values) {
    constexpr double tolerance = 1e-9;  // of its entries
    const auto known = [this](std::size_t i) {
        return scales_[i] * probe_weight(static_cast<std::int64_t>(i));
    };
    std::fill(probe_.begin(), probe_.end(), Scalar(0.0));
    const int* outer = pattern_.outerIndexPtr();
    for (std::size_t column = 0; column < probe_.size(); ++column) {
        const double x = known(column);
        for (int slot = outer[column]; slot < outer[column + 1]; ++slot)
            probe_[pattern_.innerIndexPtr()[slot]] += values[slot] * x;
    }
    solve(probe_.data());
    for (std::size_t i = 0; i < probe_.size(); ++i)
        if (!(magnitude(probe_[i] - known(i)) <= tolerance * scales_[i])) return false;  // NaN, too
    return true;
}

#if defined(ANCF_SOURCE)
template class BorderedFactors<double>;
template class BorderedFactors<std::complex<double>>;
#endif

}  // namespace ancf::detail
