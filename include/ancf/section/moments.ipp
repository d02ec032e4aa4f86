// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/error.hpp>
#include <ancf/section/moments.hpp>

#include <cmath>

namespace ancf {

namespace detail {

/// Returns the least pivot of the Cholesky factorisation of a symmetric matrix scaled to unit
/// diagonal, or the first that is not positive. 1 for a diagonal matrix, 0 for a singular one.
template <int Count>
[[nodiscard]] double least_scaled_pivot(const Matrix<double, Count>& matrix) noexcept {
    for (int i = 0; i < Count; ++i)
        if (!(matrix(i, i) > 0.0)) return 0.0;
    Matrix<double, Count> lower = matrix;
    for (int i = 0; i < Count; ++i)
        for (int j = 0; j < Count; ++j)
            lower(i, j) /= std::sqrt(matrix(i, i)) * std::sqrt(matrix(j, j));
    double least = 1.0;
    for (int k = 0; k < Count; ++k) {
        double pivot = lower(k, k);
        for (int j = 0; j < k; ++j) pivot -= lower(k, j) * lower(k, j);
        if (!(pivot > 0.0)) return pivot;
        least = pivot < least ? pivot : least;
        lower(k, k) = std::sqrt(pivot);
        for (int i = k + 1; i < Count; ++i) {
            for (int j = 0; j < k; ++j) lower(i, k) -= lower(i, j) * lower(k, j);
            lower(i, k) /= lower(k, k);
        }
    }
    return least;
}

}  // namespace detail

ANCF_INLINE Moments translated(const Moments& moments, double dy, double dz) noexcept {
    const int order = moments.has_fourth_order() ? 4 : 2;
    const detail::MomentTable old = detail::to_table(moments);
    detail::MomentTable table{};
    for (int i = 0; i <= order; ++i)
        for (int j = 0; i + j <= order; ++j) {
            double sum = 0.0;
            for (int a = 0; a <= i; ++a)
                for (int b = 0; b <= j; ++b)
                    sum += detail::binomial[i][a] * detail::binomial[j][b] *
                           detail::power(dy, i - a) * detail::power(dz, j - b) * old[a][b];
            table[i][j] = sum;
        }
    return detail::from_table(table);
}

ANCF_INLINE Moments centroidal(const Moments& moments) noexcept {
    return translated(moments, -moments.y / moments.area, -moments.z / moments.area);
}

ANCF_INLINE void validate(const Moments& moments) {
    constexpr double tolerance = 1e-12;  // round-off of given numbers; 1 is a diagonal matrix
    detail::require_positive("area", moments.area);
    for (const auto& row : detail::to_table(moments))
        for (const double value : row) detail::require_finite("every moment of the section", value);
    detail::require_positive("yy (int y^2 dA)", moments.yy);
    detail::require_positive("zz (int z^2 dA)", moments.zz);
    const Moments centred = centroidal(moments);
    detail::require(
        detail::least_scaled_pivot<3>(detail::moment_matrix<3>(centred)) > tolerance,
        "the moments up to second order belong to no area: their matrix must be positive definite "
        "about the centroid, got yy ",
        centred.yy, ", yz ", centred.yz, ", zz ", centred.zz);
    if (!moments.has_fourth_order()) return;
    detail::require(
        detail::least_scaled_pivot<6>(detail::moment_matrix<6>(centred)) > tolerance,
        "the moments up to fourth order belong to no area: the matrix int p p^T dA with "
        "p = (1, y, z, y^2, y z, z^2) must be positive definite, got yyyy ",
        moments.yyyy, ", yyzz ", moments.yyzz, ", zzzz ", moments.zzzz, " for area ", moments.area,
        ", yy ", moments.yy, ", zz ", moments.zz);
}

}  // namespace ancf
