// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/algebra.hpp>
#include <ancf/list.hpp>
#include <ancf/solver/subspace.hpp>
#include <ancf/solver/symmetric_modes.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace ancf::detail {

ANCF_LAZY Subspace::Subspace(const SparseMatrix& A, const SparseMatrix& B, VectorX scales,
                             const LinearSolver& solver)
    : A_(A), B_(B), magnitude_(A.cwiseAbs()), scales_(std::move(scales)), solver_(solver) {}

ANCF_LAZY Status Subspace::run(int free, int count, double tolerance, int max_iterations) {
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
        const MatrixX image = product(B_, vectors);
        VectorX column;
        for (Eigen::Index k = 0; k < vectors.cols(); ++k) {
            solve(image.col(k), column);
            vectors.col(k) = column;
        }
        if (!vectors.allFinite()) return Status::not_finite;
        if (!reduce(count) || slides(free, count)) return Status::singular;
        // by magnitude: of a pair of either sign either may come first
        const VectorX wanted = values.head(std::min<Eigen::Index>(count, values.size())).cwiseAbs();
        if (wanted.size() == last.size()) {
            // the reduced problem knows all values to the round-off of the largest
            const VectorX round_off =
                noise(vectors.leftCols(wanted.size())).cwiseProduct(wanted).array() +
                std::numeric_limits<double>::epsilon() * wanted.maxCoeff();
            if (((wanted - last).cwiseAbs() - tolerance * wanted - round_off).maxCoeff() <= 0.0)
                return Status::converged;
            if (values.size() == all && iterations > 1) return Status::converged;  // they span all
        }
        last = wanted;
    }
    return Status::max_iterations;
}

ANCF_LAZY double Subspace::residual(Eigen::Index k) const {
    const VectorX Ax = product(A_, vectors.col(k));
    return (product(B_, vectors.col(k)) - values[k] * Ax).norm() /
           (std::abs(values[k]) * Ax.norm());
}

ANCF_LAZY VectorX Subspace::noise(const MatrixX& of) const {
    const MatrixX x = of.cwiseAbs();
    return std::numeric_limits<double>::epsilon() *
           x.cwiseProduct(product(magnitude_, x)).colwise().sum().transpose();
}

ANCF_LAZY MatrixX Subspace::mixtures(Eigen::Index count) {
    MatrixX mixed(A_.rows(), count);
    for (Eigen::Index k = 0; k < mixed.size(); ++k) {
        draw_ = std::fmod(997.0 * draw_ + 0.123456789, 1.0);
        mixed(k) = (draw_ - 0.5) * scales_[k % mixed.rows()];
    }
    return mixed;
}

ANCF_LAZY void Subspace::complete(Eigen::Index width) {
    // modes whose values are round-off of the first one's say nothing
    const double least = std::numeric_limits<double>::epsilon() * std::abs(values[0]);
    Eigen::Index found = 0;
    while (found < vectors.cols() && std::abs(values[found]) > least) ++found;
    const MatrixX modes = vectors.leftCols(found), image = product(B_, modes);  // th A x
    const VectorX inverse = values.head(found).cwiseInverse();
    const auto remove_found = [&](MatrixX& x) {
        for (int pass = 0; pass < 2; ++pass) {
            MatrixX shares = transposed_times(image, x);
            for (Eigen::Index k = 0; k < found; ++k) shares.row(k) *= inverse[k];
            x -= times(modes, shares);
        }
    };
    MatrixX added = mixtures(width - found);
    remove_found(added);
    const MatrixX added_image = product(B_, added);
    VectorX column;
    Eigen::Index kept = 0;
    for (Eigen::Index k = 0; k < added.cols(); ++k) {
        solve(added_image.col(k), column);
        MatrixX x = column;
        remove_found(x);
        if (above_round_off(x)) added.col(kept++) = x;
    }
    vectors.conservativeResize(Eigen::NoChange, found + kept);
    vectors.rightCols(kept) = added.leftCols(kept);
}

ANCF_LAZY void Subspace::solve(const VectorX& b, VectorX& x) const {
    solve_with(solver_, b, x);
    if (!constrained_) return;
    const VectorX rest = b - product(A_, x).col(0);
    VectorX correction;
    solve_with(solver_, rest, correction);
    x += correction;
}

ANCF_LAZY bool Subspace::above_round_off(const MatrixX& x) const {
    constexpr double round_off = std::numeric_limits<double>::epsilon();
    const MatrixX image = product(A_, x), size = x.cwiseAbs();
    const double energy = transposed_times(x, image)(0, 0);
    const double noise = round_off * transposed_times(size, product(magnitude_, size))(0, 0);
    return energy > std::max(4.0 * noise, std::pow(1e-12 * values[0], 2));
}

ANCF_LAZY MatrixX Subspace::times(const MatrixX& a, const MatrixX& b) { return a * b; }

ANCF_LAZY MatrixX Subspace::transposed_times(const MatrixX& a, const MatrixX& b) {
    return a.transpose() * b;
}

ANCF_LAZY MatrixX Subspace::product(const SparseMatrix& matrix, const MatrixX& x) const {
    if (solver_.storage() == Storage::lower) return matrix.selfadjointView<Eigen::Lower>() * x;
    return matrix * x;
}

ANCF_LAZY bool Subspace::slides(int free, Eigen::Index count) const {
    MatrixX wanted = vectors.leftCols(std::min(count, vectors.cols()));
    wanted.bottomRows(wanted.rows() - free).setZero();
    return noise(wanted).maxCoeff() >= 1.0;
}

ANCF_LAZY bool Subspace::reduce(int count) {
    const MatrixX a = transposed_times(vectors, product(A_, vectors));
    // of unit diagonal: columns differ by the ratio of the eigenvalues
    const VectorX diagonal = a.diagonal();
    if (!(diagonal.minCoeff() > 0.0)) return false;
    const VectorX scale = diagonal.cwiseSqrt().cwiseInverse();
    const MatrixX unit = scale.asDiagonal() * a * scale.asDiagonal();
    const SymmetricModes metric = symmetric_modes(unit);
    const VectorX& weights = metric.values;
    const double least = 1e-13 * weights[weights.size() - 1];
    const double round_off = noise(vectors).cwiseQuotient(diagonal).sum();
    if (weights[0] < -std::max(least, 4.0 * round_off)) return false;
    Eigen::Index first = 0;
    while (first < weights.size() && weights[first] <= least) ++first;
    const Eigen::Index rank = weights.size() - first;
    const MatrixX combination = scale.asDiagonal() * metric.vectors.rightCols(rank) *
                                weights.tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
    const MatrixX basis = times(vectors, combination);
    const MatrixX b = transposed_times(basis, product(B_, basis));
    const MatrixX symmetric = 0.5 * (b + b.transpose());
    const SymmetricModes reduced = symmetric_modes(symmetric);
    List<Eigen::Index> order(static_cast<std::size_t>(rank));
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<Eigen::Index>(k);
    // pairs of either sign differ by less than this share
    const auto size = [&](Eigen::Index i) {
        const double value = reduced.values[i];
        return std::abs(value) * (value > 0.0 ? 1.0 + 1e-6 : 1.0);
    };
    std::sort(order.begin(), order.end(),
              [&](Eigen::Index i, Eigen::Index j) { return size(i) > size(j); });
    MatrixX sorted(rank, rank);
    values.resize(rank);
    for (Eigen::Index k = 0; k < rank; ++k) {
        const Eigen::Index from = order[k];
        values[k] = reduced.values[from];
        sorted.col(k) = reduced.vectors.col(from);
    }
    vectors = times(basis, sorted);
    return rank >= std::min<Eigen::Index>(count, 1);
}

}  // namespace ancf::detail
