// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The moments of a cross-section, int y^i z^j dA up to i + j = 4, about the beam's reference axis.
///
/// They are all that the section-integrated energy of [Dufva2006, Eq. 29] needs: the strains are
/// polynomials of second degree in (y, z), the energy one of fourth degree.

#pragma once

#include <ancf/error.hpp>
#include <ancf/types.hpp>

#include <array>
#include <cmath>

namespace ancf {

/// The moments int y^i z^j dA; a member's name spells its integrand: yyz is int y^2 z dA, in m^5.
struct Moments {
    double area = 0.0;  ///< m^2
    double y = 0.0;     ///< m^3
    double z = 0.0;     ///< m^3
    double yy = 0.0;    ///< m^4
    double yz = 0.0;    ///< m^4
    double zz = 0.0;    ///< m^4
    double yyy = 0.0;   ///< m^5
    double yyz = 0.0;   ///< m^5
    double yzz = 0.0;   ///< m^5
    double zzz = 0.0;   ///< m^5
    double yyyy = 0.0;  ///< m^6
    double yyyz = 0.0;  ///< m^6
    double yyzz = 0.0;  ///< m^6
    double yzzz = 0.0;  ///< m^6
    double zzzz = 0.0;  ///< m^6

    /// Returns int (y^2 + z^2) dA, m^4.
    [[nodiscard]] constexpr double polar() const noexcept { return yy + zz; }

    /// Tells whether third and fourth moments are known. Where all of them are zero, which no area
    /// can have, the section is given by its first and second moments alone.
    [[nodiscard]] constexpr bool has_fourth_order() const noexcept {
        return yyy != 0.0 || yyz != 0.0 || yzz != 0.0 || zzz != 0.0 || yyyy != 0.0 || yyyz != 0.0 ||
               yyzz != 0.0 || yzzz != 0.0 || zzzz != 0.0;
    }
};

/// Returns the moments of the area moved by (dy, dz), m: int (y + dy)^i (z + dz)^j dA.
/// Moments given to second order stay so.
[[nodiscard]] Moments translated(const Moments& moments, double dy, double dz) noexcept;

/// Returns the moments about the centroid.
/// @pre area > 0
[[nodiscard]] Moments centroidal(const Moments& moments) noexcept;

/// Throws unless the moments can belong to an area: all finite and their matrices positive
/// definite, int p p^T dA with p = (1, y, z) always, and with p = (1, y, z, y^2, y z, z^2) when
/// has_fourth_order().
/// @throws InvalidArgument naming what is wrong.
void validate(const Moments& moments);

namespace detail {

/// Moments by their exponents: table[i][j] = int y^i z^j dA for i + j <= 4.
using MomentTable = std::array<std::array<double, 5>, 5>;

/// The monomials (1, y, z, y^2, y z, z^2) by exponents of y and z.
inline constexpr std::array<std::array<int, 2>, 6> monomials{
    {{{0, 0}}, {{1, 0}}, {{0, 1}}, {{2, 0}}, {{1, 1}}, {{0, 2}}}};

constexpr MomentTable to_table(const Moments& m) noexcept {
    return {{{{m.area, m.z, m.zz, m.zzz, m.zzzz}},
             {{m.y, m.yz, m.yzz, m.yzzz, 0.0}},
             {{m.yy, m.yyz, m.yyzz, 0.0, 0.0}},
             {{m.yyy, m.yyyz, 0.0, 0.0, 0.0}},
             {{m.yyyy, 0.0, 0.0, 0.0, 0.0}}}};
}

constexpr Moments from_table(const MomentTable& t) noexcept {
    Moments m;
    m.area = t[0][0];
    m.y = t[1][0], m.z = t[0][1];
    m.yy = t[2][0], m.yz = t[1][1], m.zz = t[0][2];
    m.yyy = t[3][0], m.yyz = t[2][1], m.yzz = t[1][2], m.zzz = t[0][3];
    m.yyyy = t[4][0], m.yyyz = t[3][1], m.yyzz = t[2][2], m.yzzz = t[1][3], m.zzzz = t[0][4];
    return m;
}

/// Binomial coefficients up to 4.
inline constexpr std::array<std::array<int, 5>, 5> binomial{{{{1, 0, 0, 0, 0}},
                                                             {{1, 1, 0, 0, 0}},
                                                             {{1, 2, 1, 0, 0}},
                                                             {{1, 3, 3, 1, 0}},
                                                             {{1, 4, 6, 4, 1}}}};

/// Returns value^exponent for a small exponent; 1 for exponent 0.
constexpr double power(double value, int exponent) noexcept {
    double product = 1.0;
    for (int k = 0; k < exponent; ++k) product *= value;
    return product;
}

/// Returns factor int p p^T dA over the first Count monomials.
template <int Count>
[[nodiscard]] Matrix<double, Count> moment_matrix(const Moments& moments,
                                                  double factor = 1.0) noexcept {
    static_assert(Count <= 6, "six monomials up to second degree");
    const MomentTable table = to_table(moments);
    Matrix<double, Count> matrix;
    for (int i = 0; i < Count; ++i)
        for (int j = 0; j < Count; ++j) {
            const auto& p = monomials[static_cast<std::size_t>(i)];
            const auto& q = monomials[static_cast<std::size_t>(j)];
            matrix(i, j) =
                factor *
                table[static_cast<std::size_t>(p[0] + q[0])][static_cast<std::size_t>(p[1] + q[1])];
        }
    return matrix;
}

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

inline Moments translated(const Moments& moments, double dy, double dz) noexcept {
    const int order = moments.has_fourth_order() ? 4 : 2;
    const detail::MomentTable old = detail::to_table(moments);
    detail::MomentTable table{};
    for (int i = 0; i <= order; ++i)
        for (int j = 0; i + j <= order; ++j) {
            double sum = 0.0;
            for (int a = 0; a <= i; ++a)
                for (int b = 0; b <= j; ++b)
                    sum +=
                        detail::binomial[static_cast<std::size_t>(i)][static_cast<std::size_t>(a)] *
                        detail::binomial[static_cast<std::size_t>(j)][static_cast<std::size_t>(b)] *
                        detail::power(dy, i - a) * detail::power(dz, j - b) *
                        old[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
            table[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = sum;
        }
    return detail::from_table(table);
}

inline Moments centroidal(const Moments& moments) noexcept {
    return translated(moments, -moments.y / moments.area, -moments.z / moments.area);
}

inline void validate(const Moments& moments) {
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
