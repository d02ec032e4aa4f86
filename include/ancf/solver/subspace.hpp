// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Subspace iteration for eigenvalues of largest magnitude, with a factorised matrix as metric:
/// docs/theory-modal.md. [Bathe and Wilson, J. Eng. Mech. Div. 98 (1972)]

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/error.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace ancf::detail {

/// Largest eigenvalues of B x = th A x by subspace iteration with Rayleigh's quotients.
///
/// A template so that only a program that asks for modes compiles the eigenvalue solver.
/// @tparam Dense  MatrixX
template <class Dense>
class Subspace {
public:
    /// @param scales  of the unknowns, as many as A has rows: displacements of one size
    /// @param solver  has A factorised, or a matrix with the same solutions of A x = B y
    Subspace(const SparseMatrix& A, const SparseMatrix& B, VectorX scales,
             const LinearSolver& solver)
        : A_(A), B_(B), magnitude_(A.cwiseAbs()), scales_(std::move(scales)), solver_(solver) {}

    /// Iterates until no wanted value changes by more than the tolerance, relative, and the
    /// round-off of x^T A x.
    /// @param free  number of coordinates, at least 1; the rest of the unknowns are multipliers
    /// @return      singular where x^T A x is negative for a vector that the block contains, or is
    ///              round-off for a wanted mode: then A moves something without resistance
    [[nodiscard]] Status run(int free, int count, double tolerance, int max_iterations) {
        // what constraints leave; a block beyond it would be filled by round-off
        const Eigen::Index all = std::max<Eigen::Index>(2 * free - A_.rows(), 1);
        count = static_cast<int>(std::min<Eigen::Index>(count, all));
        const auto width = std::min<Eigen::Index>(2 * count + 8, all);
        constrained_ = free < A_.rows();
        vectors = mixtures(width);
        VectorX last = VectorX::Zero(count);
        for (iterations = 0; iterations < max_iterations;) {
            ++iterations;
            if (vectors.cols() < width) complete(width);
            const Dense image = product(B_, vectors);
            VectorX column;
            for (Eigen::Index k = 0; k < vectors.cols(); ++k) {
                solve(image.col(k), column);
                vectors.col(k) = column;
            }
            if (!vectors.allFinite()) return Status::not_finite;
            if (!reduce(count) || slides(free, count)) return Status::singular;
            // by magnitude: of a pair of either sign either may come first
            const VectorX wanted =
                values.head(std::min<Eigen::Index>(count, values.size())).cwiseAbs();
            if (wanted.size() == last.size()) {
                // the reduced problem knows all values to the round-off of the largest
                const VectorX round_off =
                    noise(vectors.leftCols(wanted.size())).cwiseProduct(wanted).array() +
                    std::numeric_limits<double>::epsilon() * wanted.maxCoeff();
                if (((wanted - last).cwiseAbs() - tolerance * wanted - round_off).maxCoeff() <= 0.0)
                    return Status::converged;
                if (values.size() == all && iterations > 1)
                    return Status::converged;  // they span all
            }
            last = wanted;
        }
        return Status::max_iterations;
    }

    /// Returns |B x - th A x|/(th |A x|) of mode k.
    [[nodiscard]] double residual(Eigen::Index k) const {
        const VectorX Ax = product(A_, vectors.col(k));
        return (product(B_, vectors.col(k)) - values[k] * Ax).norm() /
               (std::abs(values[k]) * Ax.norm());
    }

    /// Returns the round-off of x^T A x of some vectors, eps |x|^T |A| |x|.
    [[nodiscard]] VectorX noise(const Dense& of) const {
        const Dense x = of.cwiseAbs();
        return std::numeric_limits<double>::epsilon() *
               x.cwiseProduct(product(magnitude_, x)).colwise().sum().transpose();
    }

    VectorX values;  ///< by falling magnitude, of a pair of either sign the positive one first
    Dense vectors;   ///< columns, x^T A x = 1
    int iterations = 0;

private:
    // Returns fixed mixtures of all modes: results repeat bit for bit.
    [[nodiscard]] Dense mixtures(Eigen::Index count) {
        Dense mixed(A_.rows(), count);
        for (Eigen::Index k = 0; k < mixed.size(); ++k) {
            draw_ = std::fmod(997.0 * draw_ + 0.123456789, 1.0);
            mixed(k) = (draw_ - 0.5) * scales_[k % mixed.rows()];
        }
        return mixed;
    }

    // Refills a block that lost vectors to a far slower mode: new mixtures, without the modes that
    // it has.
    void complete(Eigen::Index width) {
        // modes whose values are round-off of the first one's say nothing
        const double least = std::numeric_limits<double>::epsilon() * std::abs(values[0]);
        Eigen::Index found = 0;
        while (found < vectors.cols() && std::abs(values[found]) > least) ++found;
        const Dense modes = vectors.leftCols(found), image = product(B_, modes);  // th A x
        const VectorX inverse = values.head(found).cwiseInverse();
        const auto remove_found = [&](Dense& x) {
            for (int pass = 0; pass < 2; ++pass) {
                Dense shares = transposed_times(image, x);
                for (Eigen::Index k = 0; k < found; ++k) shares.row(k) *= inverse[k];
                x -= times(modes, shares);
            }
        };
        Dense added = mixtures(width - found);
        remove_found(added);
        const Dense added_image = product(B_, added);
        VectorX column;
        Eigen::Index kept = 0;
        for (Eigen::Index k = 0; k < added.cols(); ++k) {
            solve(added_image.col(k), column);
            Dense x = column;
            remove_found(x);
            if (above_round_off(x)) added.col(kept++) = x;
        }
        vectors.conservativeResize(Eigen::NoChange, found + kept);
        vectors.rightCols(kept) = added.leftCols(kept);
    }

    // Solves A x = b, with constraints refined once. What a solution leaves of G x, times large
    // multipliers, can make x^T A x negative.
    void solve(const VectorX& b, VectorX& x) const {
        solve_with(solver_, b, x);
        if (!constrained_) return;
        const VectorX rest = b - product(A_, x).col(0);
        VectorX correction;
        solve_with(solver_, rest, correction);
        x += correction;
    }

    // Tells whether a vector without these modes is more than round-off.
    [[nodiscard]] bool above_round_off(const Dense& x) const {
        constexpr double round_off = std::numeric_limits<double>::epsilon();
        const Dense image = product(A_, x), size = x.cwiseAbs();
        const double energy = transposed_times(x, image)(0, 0);
        const double noise = round_off * transposed_times(size, product(magnitude_, size))(0, 0);
        return energy > std::max(4.0 * noise, std::pow(1e-12 * values[0], 2));
    }

    // One instance of each product for all calls: they are most of what this class compiles.
    [[nodiscard]] static Dense times(const Dense& a, const Dense& b) { return a * b; }
    [[nodiscard]] static Dense transposed_times(const Dense& a, const Dense& b) {
        return a.transpose() * b;
    }

    [[nodiscard]] Dense product(const SparseMatrix& matrix, const Dense& x) const {
        if (solver_.storage() == Storage::lower) return matrix.selfadjointView<Eigen::Lower>() * x;
        return matrix * x;
    }

    // Tells whether x^T A x = 1 of a wanted vector is below its round-off, multipliers aside.
    [[nodiscard]] bool slides(int free, Eigen::Index count) const {
        Dense wanted = vectors.leftCols(std::min(count, vectors.cols()));
        wanted.bottomRows(wanted.rows() - free).setZero();
        return noise(wanted).maxCoeff() >= 1.0;
    }

    // Solves the problem on the span of the vectors; those that add nothing are left out. Returns
    // false where the metric is not positive on the span, or nothing is left.
    [[nodiscard]] bool reduce(int count) {
        const Dense a = transposed_times(vectors, product(A_, vectors));
        // of unit diagonal: columns differ by the ratio of the eigenvalues
        const VectorX diagonal = a.diagonal();
        if (!(diagonal.minCoeff() > 0.0)) return false;
        const VectorX scale = diagonal.cwiseSqrt().cwiseInverse();
        const Dense unit = scale.asDiagonal() * a * scale.asDiagonal();
        const Eigen::SelfAdjointEigenSolver<Dense> metric(unit);
        const VectorX& weights = metric.eigenvalues();
        const double least = 1e-13 * weights[weights.size() - 1];
        const double round_off = noise(vectors).cwiseQuotient(diagonal).sum();
        if (weights[0] < -std::max(least, 4.0 * round_off)) return false;
        Eigen::Index first = 0;
        while (first < weights.size() && weights[first] <= least) ++first;
        const Eigen::Index rank = weights.size() - first;
        const Dense combination = scale.asDiagonal() * metric.eigenvectors().rightCols(rank) *
                                  weights.tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
        const Dense basis = times(vectors, combination);
        const Dense b = transposed_times(basis, product(B_, basis));
        const Dense symmetric = 0.5 * (b + b.transpose());
        const Eigen::SelfAdjointEigenSolver<Dense> reduced(symmetric);
        std::vector<Eigen::Index> order(static_cast<std::size_t>(rank));
        for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<Eigen::Index>(k);
        // pairs of either sign differ by less than this share
        const auto size = [&](Eigen::Index i) {
            const double value = reduced.eigenvalues()[i];
            return std::abs(value) * (value > 0.0 ? 1.0 + 1e-6 : 1.0);
        };
        std::sort(order.begin(), order.end(),
                  [&](Eigen::Index i, Eigen::Index j) { return size(i) > size(j); });
        Dense sorted(rank, rank);
        values.resize(rank);
        for (Eigen::Index k = 0; k < rank; ++k) {
            const Eigen::Index from = order[k];
            values[k] = reduced.eigenvalues()[from];
            sorted.col(k) = reduced.eigenvectors().col(from);
        }
        vectors = times(basis, sorted);
        return rank >= std::min<Eigen::Index>(count, 1);
    }

    const SparseMatrix& A_;
    const SparseMatrix& B_;
    SparseMatrix magnitude_;
    VectorX scales_;
    const LinearSolver& solver_;
    double draw_ = 0.5;  // of the mixtures
    bool constrained_ = false;
};

}  // namespace ancf::detail
