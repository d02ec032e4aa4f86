// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Matrices on which every linear solver is tried: chains, beams, saddle points, grids.

#pragma once

#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <support/random_state.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ancf::test {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Returns the square matrix of the triplets, equal positions added.
inline SparseMatrix sparse(int size, const Triplets& triplets) {
    SparseMatrix matrix(size, size);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
}

/// Returns the lower half of a dense symmetric matrix, zeros left out.
inline SparseMatrix sparse_lower(const MatrixX& symmetric) {
    Triplets triplets;
    for (int j = 0; j < symmetric.cols(); ++j)
        for (int i = j; i < symmetric.rows(); ++i)
            if (symmetric(i, j) != 0.0) triplets.emplace_back(i, j, symmetric(i, j));
    return sparse(static_cast<int>(symmetric.cols()), triplets);
}

/// Returns the part of a symmetric matrix that a storage holds, from its lower half.
inline SparseMatrix stored(const SparseMatrix& lower, Storage storage) {
    if (storage == Storage::lower) return lower;
    SparseMatrix full = lower.selfadjointView<Eigen::Lower>();
    full.makeCompressed();
    return full;
}

/// Returns A x of what a storage holds.
inline VectorX product(const SparseMatrix& matrix, Storage storage, const VectorX& x) {
    if (storage == Storage::full) return matrix * x;
    return matrix.selfadjointView<Eigen::Lower>() * x;
}

/// Returns |b - A x| / (|A| |x| + |b|) in the maximum norm: the backward error.
inline double backward_error(const SparseMatrix& matrix, Storage storage, const VectorX& x,
                             const VectorX& b) {
    const VectorX residual = b - product(matrix, storage, x);
    const SparseMatrix magnitudes = matrix.cwiseAbs();
    const VectorX scale = product(magnitudes, storage, x.cwiseAbs()) + b.cwiseAbs();
    return residual.lpNorm<Eigen::Infinity>() / scale.lpNorm<Eigen::Infinity>();
}

/// Returns a vector uniform in [-1, 1).
inline VectorX random_vector(int size, std::uint64_t seed) {
    Random random(seed);
    VectorX vector(size);
    for (int i = 0; i < size; ++i) vector[i] = random.uniform(-1.0, 1.0);
    return vector;
}

/// Returns the lower half of a chain of nodes of the given sizes: random symmetric, dominated by
/// its diagonal of about `diagonal` times +1, or -1 in every `flip`-th column.
inline SparseMatrix random_chain(const std::vector<int>& sizes, std::uint64_t seed,
                                 double diagonal = 40.0, int flip = 0) {
    Random random(seed);
    Triplets triplets;
    int first = 0;
    for (std::size_t node = 0; node < sizes.size(); ++node) {
        const int end = first + sizes[node] + (node + 1 < sizes.size() ? sizes[node + 1] : 0);
        for (int j = first; j < first + sizes[node]; ++j) {
            const double sign = flip > 0 && j % flip == flip - 1 ? -1.0 : 1.0;
            triplets.emplace_back(j, j, sign * (diagonal + random.uniform(-1.0, 1.0)));
            for (int i = j + 1; i < end; ++i)
                triplets.emplace_back(i, j, random.uniform(-1.0, 1.0));
        }
        first += sizes[node];
    }
    return sparse(first, triplets);
}

/// Returns the lower half of the five-point Laplacian of a square grid: positive definite.
inline SparseMatrix grid(int side) {
    Triplets triplets;
    for (int i = 0; i < side * side; ++i) {
        triplets.emplace_back(i, i, 4.0);
        if (i % side + 1 < side) triplets.emplace_back(i + 1, i, -1.0);
        if (i + side < side * side) triplets.emplace_back(i + side, i, -1.0);
    }
    return sparse(side * side, triplets);
}

/// A straight beam by the linearised cross-section element, 12 coordinates per node
/// [r r_x r_y r_z]; square section of side `height`, E = 2e11 Pa, nu = 0.
///
/// It lies askew to the axes, so that no round-off cancels by symmetry.
struct SampleBeam {
    int elements = 1;
    double length = 1.0;     ///< m
    double height = 0.01;    ///< m
    int clamped_first = 12;  ///< coordinates of the first node that are left out

    static constexpr double young = 2e11;

    /// Returns the axes of the beam: along, and the two directions of the section.
    [[nodiscard]] static Matrix<double, 3> axes() {
        return rotation(Vector<double, 3>(0.3, 0.6, 0.9));
    }

    /// Returns the tangent of one element, 24 x 24, along x; singular with six rigid motions.
    [[nodiscard]] Matrix<double, 24> element_tangent() const;

    /// Returns the lower half of the tangent; unknowns along the chain.
    [[nodiscard]] SparseMatrix tangent() const;

    [[nodiscard]] int size() const { return 12 * (elements + 1) - clamped_first; }

    /// Returns a unit force across the beam at its last node.
    [[nodiscard]] VectorX tip_load() const {
        VectorX load = VectorX::Zero(size());
        load.segment<3>(size() - 12) = axes().col(1);
        return load;
    }

    /// Returns the displacement of the last node along tip_load; m.
    [[nodiscard]] double tip(const VectorX& x) const {
        return x.segment<3>(size() - 12).dot(axes().col(1));
    }

    /// Returns tip(x) of the clamped beam under tip_load, by Timoshenko's theory with k = 1; m.
    [[nodiscard]] double tip_deflection() const {
        const double area = height * height;
        return length * length * length * 12.0 / (3.0 * young * area * area) +
               length * 2.0 / (young * area);
    }
};

inline Matrix<double, 24> SampleBeam::element_tangent() const {
    const double l = length / elements;
    const double area = height * height;
    const double inertia = area * area / 12.0;
    const double shear = young / 2.0;
    Matrix<double, 24> tangent = Matrix<double, 24>::Zero();
    const double offset = std::sqrt(0.6) / 2.0;
    const std::array<double, 3> points = {0.5 - offset, 0.5, 0.5 + offset};
    const std::array<double, 3> weights = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    for (std::size_t g = 0; g < points.size(); ++g) {
        const double x = points[g];
        const std::array<double, 2> linear = {1.0 - x, x};
        const std::array<double, 2> slope = {-1.0 / l, 1.0 / l};
        // first and second derivative of the cubic weights of r and r_x at both nodes
        const std::array<double, 2> r1 = {(6 * x * x - 6 * x) / l, (6 * x - 6 * x * x) / l};
        const std::array<double, 2> s1 = {1 - 4 * x + 3 * x * x, 3 * x * x - 2 * x};
        const std::array<double, 2> r2 = {(12 * x - 6) / (l * l), (6 - 12 * x) / (l * l)};
        const std::array<double, 2> s2 = {(6 * x - 4) / l, (6 * x - 2) / l};
        Matrix<double, 9, 24> strain = Matrix<double, 9, 24>::Zero();
        for (std::size_t n = 0; n < 2; ++n) {
            const int o = n == 0 ? 0 : 12;
            strain(0, o) = r1[n];  // u'
            strain(0, o + 3) = s1[n];
            for (int axis = 0; axis < 2; ++axis) {
                const int director = o + (axis == 0 ? 6 : 9);  // x component of r_y, r_z
                strain(1 + axis, o + 4 + axis) = linear[n];    // shear, linear between the nodes
                strain(1 + axis, director) = linear[n];
                strain(3 + axis, o + 1 + axis) = -r2[n];  // its slope minus the curvature
                strain(3 + axis, o + 4 + axis) = slope[n] - s2[n];
                strain(3 + axis, director) = slope[n];
            }
            strain(5, o + 8) = slope[n] / 2.0;  // twist rate
            strain(5, o + 10) = -slope[n] / 2.0;
            strain(6, o + 7) = linear[n];  // r_y . y, r_z . z, and the shear of the section
            strain(7, o + 11) = linear[n];
            strain(8, o + 8) = linear[n];
            strain(8, o + 10) = linear[n];
        }
        Vector<double, 9> stiffness;
        stiffness << young * area, shear * area, shear * area, young * inertia, young * inertia,
            2.0 * shear * inertia, young * area, young * area, shear * area;
        tangent += weights[g] * l * strain.transpose() * stiffness.asDiagonal() * strain;
    }
    return tangent;
}

inline SparseMatrix SampleBeam::tangent() const {
    Matrix<double, 24> turn = Matrix<double, 24>::Zero();
    for (int k = 0; k < 24; k += 3) turn.block<3, 3>(k, k) = axes();
    const Matrix<double, 24> element = turn * element_tangent() * turn.transpose();
    Triplets triplets;
    triplets.reserve(static_cast<std::size_t>(elements) * 300);
    for (int e = 0; e < elements; ++e)
        for (int j = 0; j < 24; ++j)
            for (int i = j; i < 24; ++i) {
                const int row = 12 * e + i - clamped_first;
                const int column = 12 * e + j - clamped_first;
                if (column >= 0) triplets.emplace_back(row, column, element(i, j));
            }
    return sparse(size(), triplets);
}

/// A saddle point [K, G^T; G, 0] of a random positive definite chain K and random constraints on
/// `coordinates` unknowns each, no two on the same.
struct SaddlePoint {
    SparseMatrix lower;
    int unknowns;
    int constraints;
};

inline SaddlePoint saddle_point(int nodes, int constraints, std::uint64_t seed,
                                int coordinates = 6) {
    const SparseMatrix chain =
        random_chain(std::vector<int>(static_cast<std::size_t>(nodes), 12), seed);
    Triplets triplets;
    for (int j = 0; j < chain.cols(); ++j)
        for (SparseMatrix::InnerIterator entry(chain, j); entry; ++entry)
            triplets.emplace_back(static_cast<int>(entry.row()), j, entry.value());
    const int unknowns = static_cast<int>(chain.cols());
    Random random(seed + 1000);
    for (int c = 0; c < constraints; ++c)
        for (int k = 0; k < coordinates; ++k)
            triplets.emplace_back(unknowns + c, c * coordinates + k, random.uniform(0.5, 1.5));
    return {sparse(unknowns + constraints, triplets), unknowns, constraints};
}

}  // namespace ancf::test
