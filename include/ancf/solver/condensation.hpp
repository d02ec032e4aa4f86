// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Static condensation: a matrix less unknowns that few others see.

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/list.hpp>
#include <ancf/solver/dense_lu.hpp>
#include <ancf/types.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace ancf::detail {

/// Calls visit(i, j, k) for the entries of a matrix in rows[i] and columns[j], ascending; k is the
/// place of the stored entry, -1 where there is none.
template <class Visitor>
void visit_block(const SparseMatrix& matrix, const List<int>& rows, const List<int>& columns,
                 const Visitor& visit) {
    const int* const inner = matrix.innerIndexPtr();
    for (std::size_t j = 0; j < columns.size(); ++j) {
        const int* found = inner + matrix.outerIndexPtr()[columns[j]];
        const int* const end = inner + matrix.outerIndexPtr()[columns[j] + 1];
        for (std::size_t i = 0; i < rows.size(); ++i) {
            while (found != end && *found < rows[i]) ++found;
            visit(i, j, found != end && *found == rows[i] ? found - inner : -1);
        }
    }
}

/// Eliminates sets of unknowns, e, that few others, n, see: S = K_nn - K_ne K_ee^-1 K_en.
///
/// Members that end at a joint have a slope r_x of their own there; without it all nodes of a frame
/// are alike. Eigen's own inverse, products and lists of indices would take a
/// header-only unit seconds and 80 MB to compile.
class Condensation {
public:
    Condensation() = default;

    /// @param pattern    of full storage.
    /// @param sets       ascending, apart, and without entries between two of them.
    /// @param symmetric  whether values are.
    Condensation(const SparseMatrix& pattern, const List<List<int>>& sets, bool symmetric)
        : symmetric_(symmetric), skipped_(pattern.cols() + 1, 0) {
        const int* const outer = pattern.outerIndexPtr();
        SparseMatrix sum;  // with the entries of both sides
        if (!symmetric) sum = pattern + SparseMatrix(pattern.transpose());
        const SparseMatrix& both = symmetric ? pattern : sum;
        for (const List<int>& own : sets) {
            List<int> seen;
            Set& set = sets_.emplace_back();
            set.own = own;
            for (const int j : own) {
                seen.insert(seen.end(), both.innerIndexPtr() + both.outerIndexPtr()[j],
                            both.innerIndexPtr() + both.outerIndexPtr()[j + 1]);
                skipped_[j + 1] = outer[j + 1] - outer[j];
            }
            std::sort(seen.begin(), seen.end());
            for (const int k : seen)
                if ((set.others.empty() || set.others.back() != k) &&
                    !std::binary_search(own.begin(), own.end(), k))
                    set.others.push_back(k);
            visit_block(pattern, set.others, set.others, [&](auto i, auto j, auto k) {
                if (k < 0) filled_.emplace_back(set.others[i], set.others[j]);
            });
        }
        std::partial_sum(skipped_.begin(), skipped_.end(), skipped_.begin());
    }

    /// Tells whether an unknown is left.
    [[nodiscard]] bool keeps(int unknown) const {
        return skipped_[unknown] == skipped_[unknown + 1];
    }

    /// Returns row and column of the entries of S that the pattern lacks.
    [[nodiscard]] const List<std::pair<int, int>>& filled() const { return filled_; }

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
        const auto copy = [&](const List<int>& rows, const List<int>& columns, MatrixX& to) {
            to.setZero(rows.size(), columns.size());
            visit_block(matrix, rows, columns, [&](auto i, auto j, auto k) {
                if (k >= 0) to(i, j) = matrix.valuePtr()[k];
            });
        };
        DenseLu<double> ee;
        MatrixX ne, en, change;
        for (Set& set : sets_) {
            copy(set.own, set.own, ee.factors);
            copy(set.others, set.own, ne);
            if (symmetric_)
                en = ne.transpose();
            else
                copy(set.own, set.others, en);
            if (!ee.factorize()) return false;
            set.inverse = ee.inverse();
            if (!set.inverse.allFinite()) return false;
            set.right = product(set.inverse, en);
            if (!symmetric_) set.left = product(ne, set.inverse);
            change = product(ne, set.right);
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
            const VectorX own = picked(b, set.own);
            const MatrixX left = symmetric_ ? MatrixX(set.right.transpose()) : set.left;
            add(multiply(left, own), -1.0, set.others, out);
        }
        return out;
    }

    /// Sets the eliminated entries of a solution.
    void complete(const VectorX& b, VectorX& x) const {
        for (const Set& set : sets_) {
            const VectorX others = picked(x, set.others);
            for (const int k : set.own) x[k] = 0.0;
            add(multiply(set.inverse, picked(b, set.own)), 1.0, set.own, x);
            add(multiply(set.right, others), -1.0, set.own, x);
        }
    }

private:
    [[nodiscard]] static MatrixX product(const MatrixX& A, const MatrixX& B) {
        MatrixX result(A.rows(), B.cols());
        for (Eigen::Index j = 0; j < B.cols(); ++j) result.col(j) = multiply(A, B.col(j));
        return result;
    }

    [[nodiscard]] static VectorX picked(const VectorX& from, const List<int>& places) {
        VectorX result(places.size());
        for (std::size_t k = 0; k < places.size(); ++k) result[k] = from[places[k]];
        return result;
    }
    static void add(const VectorX& entries, double factor, const List<int>& places, VectorX& to) {
        for (std::size_t k = 0; k < places.size(); ++k) to[places[k]] += factor * entries[k];
    }

    struct Set {
        List<int> own, others;         // e and n
        MatrixX inverse, right, left;  // K_ee^-1, K_ee^-1 K_en, K_ne K_ee^-1 unless symmetric
    };

    bool symmetric_ = false;
    List<int> skipped_;  // entries of eliminated columns before each column, and the end
    List<Set> sets_;
    List<std::pair<int, int>> filled_;
};

}  // namespace ancf::detail
