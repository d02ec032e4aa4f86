// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Static condensation: a matrix less unknowns that few others see.

#pragma once

#include <ancf/types.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace ancf::detail {

/// Calls visit(i, j, k) for the entries of a matrix in rows[i] and columns[j], ascending; k is the
/// place of the stored entry, -1 where there is none.
template <class Visitor>
void visit_block(const SparseMatrix& matrix, const Eigen::VectorXi& rows,
                 const Eigen::VectorXi& columns, const Visitor& visit) {
    const int* const inner = matrix.innerIndexPtr();
    for (Eigen::Index j = 0; j < columns.size(); ++j) {
        const int* found = inner + matrix.outerIndexPtr()[columns[j]];
        const int* const end = inner + matrix.outerIndexPtr()[columns[j] + 1];
        for (Eigen::Index i = 0; i < rows.size(); ++i) {
            while (found != end && *found < rows[i]) ++found;
            visit(i, j, found != end && *found == rows[i] ? found - inner : -1);
        }
    }
}

/// Eliminates sets of unknowns, e, that few others, n, see: S = K_nn - K_ne K_ee^-1 K_en.
///
/// Members that end at a joint have a slope r_x of their own there; without it all nodes of a frame
/// are alike. Products are lazy: the matrices are small, and Eigen's others are slow to compile.
class Condensation {
public:
    Condensation() = default;

    /// @param pattern    of full storage.
    /// @param sets       ascending, apart, and without entries between two of them.
    /// @param symmetric  whether values are.
    Condensation(const SparseMatrix& pattern, const std::vector<std::vector<int>>& sets,
                 bool symmetric)
        : symmetric_(symmetric), skipped_(pattern.cols() + 1, 0) {
        const int* const outer = pattern.outerIndexPtr();
        SparseMatrix sum;  // with the entries of both sides
        if (!symmetric) sum = pattern + SparseMatrix(pattern.transpose());
        const SparseMatrix& both = symmetric ? pattern : sum;
        using Places = Eigen::Map<const Eigen::VectorXi>;
        for (const std::vector<int>& own : sets) {
            std::set<int> seen;
            std::vector<int> others;
            for (const int j : own) {
                seen.insert(both.innerIndexPtr() + both.outerIndexPtr()[j],
                            both.innerIndexPtr() + both.outerIndexPtr()[j + 1]);
                skipped_[j + 1] = outer[j + 1] - outer[j];
            }
            std::set_difference(seen.begin(), seen.end(), own.begin(), own.end(),
                                std::back_inserter(others));
            Set& set = sets_.emplace_back();
            set.own = Places(own.data(), own.size());
            set.others = Places(others.data(), others.size());
            visit_block(pattern, set.others, set.others, [&](auto i, auto j, auto k) {
                if (k < 0) filled_.emplace_back(others[i], others[j]);
            });
        }
        std::partial_sum(skipped_.begin(), skipped_.end(), skipped_.begin());
    }

    /// Tells whether an unknown is left.
    [[nodiscard]] bool keeps(int unknown) const {
        return skipped_[unknown] == skipped_[unknown + 1];
    }

    /// Returns row and column of the entries of S that the pattern lacks.
    [[nodiscard]] const std::vector<std::pair<int, int>>& filled() const { return filled_; }

    /// Writes the columns that are left, one after the other, with S in the rows that are left, and
    /// the entries of filled() after them.
    /// @return false where a set has no stiffness of its own.
    [[nodiscard]] bool reduce(const SparseMatrix& matrix, double* values) {
        const int* const outer = matrix.outerIndexPtr();
        for (int j = 0; j < matrix.cols(); ++j)
            if (keeps(j))
                std::copy(matrix.valuePtr() + outer[j], matrix.valuePtr() + outer[j + 1],
                          values + outer[j] - skipped_[j]);
        double* fill = values + outer[matrix.cols()] - skipped_.back();
        const auto copy = [&](const Eigen::VectorXi& rows, const Eigen::VectorXi& columns,
                              MatrixX& to) {
            to.setZero(rows.size(), columns.size());
            visit_block(matrix, rows, columns, [&](auto i, auto j, auto k) {
                if (k >= 0) to(i, j) = matrix.valuePtr()[k];
            });
        };
        MatrixX ee, ne, en, change;
        for (Set& set : sets_) {
            copy(set.own, set.own, ee);
            copy(set.others, set.own, ne);
            if (symmetric_)
                en = ne.transpose();
            else
                copy(set.own, set.others, en);
            set.inverse = ee.inverse();
            if (!set.inverse.allFinite()) return false;
            set.right = set.inverse.lazyProduct(en);
            if (!symmetric_) set.left = ne.lazyProduct(set.inverse);
            change = ne.lazyProduct(set.right);
            visit_block(matrix, set.others, set.others, [&](auto i, auto j, auto k) {
                if (k >= 0)
                    values[k - skipped_[set.others[j]]] -= change(i, j);
                else
                    *fill++ = -change(i, j);
            });
        }
        return true;
    }

    /// Returns what the sets add to the right-hand side, -K_ne K_ee^-1 b_e.
    [[nodiscard]] VectorX shift(const VectorX& b) const {
        VectorX out = VectorX::Zero(b.size());
        for (const Set& set : sets_) {
            const VectorX own = b(set.own);
            if (symmetric_)
                out(set.others) -= set.right.transpose().lazyProduct(own);
            else
                out(set.others) -= set.left.lazyProduct(own);
        }
        return out;
    }

    /// Sets the eliminated entries of a solution.
    void complete(const VectorX& b, VectorX& x) const {
        for (const Set& set : sets_)
            x(set.own) = set.inverse.lazyProduct(VectorX(b(set.own))) -
                         set.right.lazyProduct(VectorX(x(set.others)));
    }

private:
    struct Set {
        Eigen::VectorXi own, others;   // e and n
        MatrixX inverse, right, left;  // K_ee^-1, K_ee^-1 K_en, K_ne K_ee^-1 unless symmetric
    };

    bool symmetric_ = false;
    std::vector<int> skipped_;  // entries of eliminated columns before each column, and the end
    std::vector<Set> sets_;
    std::vector<std::pair<int, int>> filled_;
};

}  // namespace ancf::detail
