// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The continuum beam's material law, integrated over the cross-section once and for all.
///
/// Every strain is a polynomial in (y, z) whose coefficients are dot products of the vectors r0',
/// r_y', r_z', r_y, r_z, so the energy per length is a constant quadratic form in those dot
/// products (docs/theory-continuum.md).

#pragma once

#include <ancf/error.hpp>
#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

#include <array>
#include <string_view>

namespace ancf {

/// How the continuum beam's stress follows from its Green strain.
enum class ContinuumMaterial {
    diagonal,  ///< E on the normal strains, k G on the three shears: no Poisson effect
    hooke,  ///< isotropic Hooke's law, k on 2 e_xy and 2 e_xz only; locks in bending unless nu = 0
    enhanced  ///< the diagonal law over the section, Hooke's law on the line of centroids
};

/// Returns the word that command lines and tables use.
[[nodiscard]] constexpr std::string_view to_string(ContinuumMaterial material) noexcept {
    switch (material) {
        case ContinuumMaterial::diagonal: return "diagonal";
        case ContinuumMaterial::hooke: return "hooke";
        case ContinuumMaterial::enhanced: return "enhanced";
    }
    return "unknown";
}

namespace detail {

/// The stiffness of a point of the solid: S = stiffness times Green strain, Pa. S_xx and the normal
/// stresses across share `normal` (own strain) and `coupling` (each other normal strain).
struct PointStiffness {
    double normal;
    double coupling;
    std::array<double, 2> shear;  ///< k_y G of 2 e_xy, k_z G of 2 e_xz
    double transverse_shear;      ///< of 2 e_yz
};

/// Returns the diagonal law: E, k_y G, k_z G and their mean for 2 e_yz.
[[nodiscard]] inline PointStiffness diagonal_stiffness(const Material& material,
                                                       const Section& section) {
    const double k_y = section.shear_correction_y();
    const double k_z = section.shear_correction_z();
    return {material.young,
            0.0,
            {k_y * material.shear, k_z * material.shear},
            0.5 * (k_y + k_z) * material.shear};
}

/// Returns Hooke's law: in three dimensions the solid's, in two that of plane stress, S_zz = 0.
/// @throws InvalidArgument unless Poisson's ratio is in (-1, 1/2), in two dimensions (-1, 1/2].
template <int Dimension>
[[nodiscard]] PointStiffness hooke_stiffness(const Material& material, const Section& section) {
    const double poisson = material.poisson();
    require(poisson > -1.0 && (Dimension == 2 ? poisson <= 0.5 : poisson < 0.5),
            "Hooke's law needs Poisson's ratio E/(2 G) - 1 in ",
            Dimension == 2 ? "(-1, 0.5], got " : "(-1, 0.5), got ", poisson);
    const double normal = Dimension == 2 ? material.young / (1.0 - poisson * poisson)
                                         : material.young * (1.0 - poisson) /
                                               ((1.0 + poisson) * (1.0 - 2.0 * poisson));
    const double coupling = Dimension == 2 ? poisson * normal : poisson / (1.0 - poisson) * normal;
    return {normal,
            coupling,
            {section.shear_correction_y() * material.shear,
             section.shear_correction_z() * material.shear},
            material.shear};
}

/// Returns the moments of the section's whole area gathered in its centroid.
[[nodiscard]] inline Moments lumped(const Moments& moments) noexcept {
    const double y = moments.y / moments.area;
    const double z = moments.z / moments.area;
    MomentTable table{};
    for (int i = 0; i <= 4; ++i)
        for (int j = 0; i + j <= 4; ++j) table[i][j] = moments.area * power(y, i) * power(z, j);
    return from_table(table);
}

/// The law of a cross-section: stress resultants conjugate to the strain coefficients, per length.
///
/// With v = (r0', r_y', r_z'), a = (r_y, r_z), phi = (1, y, z) the strain coefficients are
///     e_xx = sum_{i<=j} phi_i phi_j axial(ij)      axial(ij) = v_i . v_j (i < j), v_i . v_i/2
///     2 e_xy, 2 e_xz = sum_i phi_i shear(i, c)     shear(i, c) = v_i . a_c, c = 0, 1
///     e_yy, e_zz = normal(c), 2 e_yz = transverse  normal(c) = a_c . a_c/2, transverse = a_0 . a_1
/// each less its value in the reference. Pairs count (00), (01), (02), (11), (12), (22).
template <int Dimension>
struct ContinuumLaw {
    static constexpr int slopes = Dimension - 1;
    static constexpr int pairs = Dimension * (Dimension + 1) / 2;

    Matrix<double, pairs> axial;          ///< e_xx with itself, int E phi_i phi_j phi_k phi_l dA
    Matrix<double, pairs, slopes> shear;  ///< int k G phi_i phi_j dA, k = k_y, k_z
    Vector<double, pairs> coupling;       ///< e_xx with each of e_yy, e_zz
    double normal = 0.0;                  ///< e_yy with itself, e_zz with itself
    double normal_coupling = 0.0;         ///< e_yy with e_zz
    double transverse_shear = 0.0;        ///< 2 e_yz

    ContinuumLaw() noexcept {
        axial.setZero();
        shear.setZero();
        coupling.setZero();
    }

    /// Returns the place of the pair (i, j), i <= j.
    [[nodiscard]] static constexpr int pair(int i, int j) noexcept {
        return i * Dimension - i * (i + 1) / 2 + j;
    }

    /// Adds factor times the law of an area with the given moments and stiffness.
    void add(double factor, const PointStiffness& stiffness, const Moments& moments) noexcept {
        const MomentTable table = to_table(moments);
        const auto moment = [&](int i, int j, int k, int l) {
            const int y = (i == 1) + (j == 1) + (k == 1) + (l == 1);
            const int z = (i == 2) + (j == 2) + (k == 2) + (l == 2);
            return factor * table[y][z];
        };
        for (int i = 0; i < Dimension; ++i)
            for (int j = i; j < Dimension; ++j) {
                for (int k = 0; k < Dimension; ++k)
                    for (int l = k; l < Dimension; ++l)
                        axial(pair(i, j), pair(k, l)) += stiffness.normal * moment(i, j, k, l);
                for (int c = 0; c < slopes; ++c)
                    shear(pair(i, j), c) += stiffness.shear[c] * moment(i, j, 0, 0);
                coupling(pair(i, j)) += stiffness.coupling * moment(i, j, 0, 0);
            }
        normal += factor * stiffness.normal * moments.area;
        normal_coupling += factor * stiffness.coupling * moments.area;
        transverse_shear += factor * stiffness.transverse_shear * moments.area;
    }

    /// Returns `factor` times the law for y and z measured in units of `unit`, m.
    [[nodiscard]] ContinuumLaw scaled(double factor, double unit) const noexcept {
        ContinuumLaw result;
        for (int i = 0, p = 0; i < Dimension; ++i)
            for (int j = i; j < Dimension; ++j, ++p) {
                const double scale_p = (i > 0 ? 1.0 / unit : 1.0) * (j > 0 ? 1.0 / unit : 1.0);
                for (int k = 0, q = 0; k < Dimension; ++k)
                    for (int l = k; l < Dimension; ++l, ++q) {
                        const double scale_q =
                            (k > 0 ? 1.0 / unit : 1.0) * (l > 0 ? 1.0 / unit : 1.0);
                        result.axial(p, q) = factor * scale_p * scale_q * axial(p, q);
                    }
                for (int c = 0; c < slopes; ++c)
                    result.shear(p, c) = factor * scale_p * shear(p, c);
                result.coupling(p) = factor * scale_p * coupling(p);
            }
        result.normal = factor * normal;
        result.normal_coupling = factor * normal_coupling;
        result.transverse_shear = factor * transverse_shear;
        return result;
    }
};

/// Returns the law of a section.
///
/// The enhanced one is exact as a split: diagonal law of the whole section + (Hooke - diagonal) of
/// its area gathered in the centroid. Only the line of centroids knows Poisson's ratio.
/// Source: Gerstmayr, Matikainen, Mikkola, Multibody Syst. Dyn. 20 (2008) 359-384, for centred
/// sections.
/// @throws InvalidArgument for a material that Hooke's law cannot take, or a section without fourth
///         moments or shear correction factors.
template <int Dimension>
[[nodiscard]] ContinuumLaw<Dimension> continuum_law(const Material& material,
                                                    const Section& section,
                                                    ContinuumMaterial kind) {
    material.validate();
    const Moments& moments = section.moments();
    require(moments.has_fourth_order(),
            "a continuum beam needs the section's moments up to fourth order, got a section "
            "given to second order");
    ContinuumLaw<Dimension> law;
    if (kind == ContinuumMaterial::hooke) {
        law.add(1.0, hooke_stiffness<Dimension>(material, section), moments);
        return law;
    }
    law.add(1.0, diagonal_stiffness(material, section), moments);
    if (kind == ContinuumMaterial::enhanced) {
        law.add(1.0, hooke_stiffness<Dimension>(material, section), lumped(moments));
        law.add(-1.0, diagonal_stiffness(material, section), lumped(moments));
    }
    return law;
}

}  // namespace detail
}  // namespace ancf
