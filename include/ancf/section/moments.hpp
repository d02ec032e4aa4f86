// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The moments of a cross-section, int y^i z^j dA up to i + j = 4, about the beam's reference axis.
///
/// They are all that the section-integrated energy of [Dufva2006, Eq. 29] needs: the strains are
/// polynomials of second degree in (y, z), the energy one of fourth degree.

#pragma once

#include <ancf/types.hpp>

#include <array>

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
            const auto& p = monomials[i];
            const auto& q = monomials[j];
            matrix(i, j) = factor * table[p[0] + q[0]][p[1] + q[1]];
        }
    return matrix;
}

}  // namespace detail
}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/section/moments.ipp>  // IWYU pragma: export
#endif
