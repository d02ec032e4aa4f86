// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Static condensation: unknowns that few others see are eliminated before a system is solved.
///
/// Each set e of such unknowns touches others, n: S = K_nn - K_ne K_ee^-1 K_en. Members that end at
/// a joint have a slope r_x of their own there; without it all nodes of a frame are alike.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/types.hpp>

#include <cstddef>
#include <vector>

namespace ancf::petsc::detail {

/// Eliminates sets of unknowns from matrices of one pattern.
class Condensation {
public:
    Condensation() = default;

    /// @param pattern    of full storage; it couples all that a set touches.
    /// @param sets       sorted, apart, and without entries between two of them.
    /// @param symmetric  whether values are.
    Condensation(const SparseMatrix& pattern, std::vector<std::vector<int>> sets, bool symmetric);

    /// Tells whether an unknown is left.
    [[nodiscard]] bool keeps(int unknown) const noexcept {
        return kept_[static_cast<std::size_t>(unknown)] != 0;
    }
    /// Returns the number of entries between unknowns that are left.
    [[nodiscard]] std::size_t entries() const noexcept { return entries_; }

    /// Writes those entries of S, column by column.
    /// @return false where a set has no stiffness of its own.
    [[nodiscard]] bool reduce(const SparseMatrix& matrix, double* values);

    /// Writes what the sets add to the right-hand side, -K_ne K_ee^-1 b_e.
    void shift(const VectorX& b, VectorX& out) const;

    /// Sets the eliminated entries of a solution.
    void complete(const VectorX& b, VectorX& x) const;

private:
    struct Set {
        std::vector<int> own, others;  // e and n
        std::size_t first;             // in factors_: K_ee^-1, K_ee^-1 K_en, K_ne K_ee^-1
    };

    bool symmetric_ = false;
    std::size_t entries_ = 0;
    std::vector<char> kept_;
    std::vector<std::size_t> start_;  // first kept entry of each column
    std::vector<Set> sets_;
    std::vector<double> factors_;
};

}  // namespace ancf::petsc::detail

#if !defined(ANCF_COMPILED)
#include <ancf/petsc/condensation.ipp>  // IWYU pragma: export
#endif
