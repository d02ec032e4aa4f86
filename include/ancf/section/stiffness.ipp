// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/section/moments.hpp>
#include <ancf/section/stiffness.hpp>

namespace ancf {

namespace detail {

/// Returns the 3 x 3 shear block of the Saint-Venant model about the reference axis.
/// @param shear    k G, Pa
/// @param torsion  stiffness of the twisting strain, N m^2
/// @param twist    the place of the twisting strain: 2 (h_zy) in shear_y, 1 (h_yz) in shear_z
/// @param arm      of the shear centre, which that strain multiplies: z or y, m
ANCF_INLINE Matrix<double, 3> saint_venant_block(const Moments& moments, double shear,
                                                 double torsion, int twist, double arm) noexcept {
    Matrix<double, 3> centred = moment_matrix<3>(centroidal(moments), shear);
    for (int k = 0; k < 3; ++k) {
        centred(twist, k) = centred(k, twist) = 0.0;
        if (k > 0) centred(0, k) = centred(k, 0) = 0.0;  // round-off about the centroid
    }
    centred(twist, twist) = torsion;
    // T^T centred T with T = I + e_0 (0, y_c, z_c), the arm in the place of the twist: centred
    // couples nothing to its first place, so that only its first entry is transported
    double c[3] = {1.0, moments.y / moments.area, moments.z / moments.area};
    c[twist] = arm;
    Matrix<double, 3> block = centred;
    block(0, 0) = 0.0;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) block(i, j) += c[i] * centred(0, 0) * c[j];
    return block;
}

/// Returns the axial block of a section known to second order: E int p p^T dA, p = (1, y, z), about
/// the centroid (y_c, z_c), of its strain eps + y_c b_y + ... + z_c^2 (a_zz/2) and of the slopes
/// b_y + y_c a_yy + z_c a_yz and b_z + y_c a_yz + z_c a_zz of the strain there.
ANCF_INLINE Matrix<double, 6> second_order_block(const Moments& moments, double young) noexcept {
    Matrix<double, 3> centred = moment_matrix<3>(centroidal(moments), young);
    for (int k = 1; k < 3; ++k) centred(0, k) = centred(k, 0) = 0.0;  // round-off
    const double y = moments.y / moments.area, z = moments.z / moments.area;
    const double at[3][6] = {{1.0, y, z, y * y, y * z, z * z},
                             {0.0, 1.0, 0.0, 2.0 * y, z, 0.0},
                             {0.0, 0.0, 1.0, 0.0, y, 2.0 * z}};
    Matrix<double, 6> block;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j <= i; ++j) {
            double sum = 0.0;
            for (int a = 0; a < 3; ++a)
                for (int b = 0; b < 3; ++b) sum += at[a][i] * centred(a, b) * at[b][j];
            block(i, j) = block(j, i) = sum;
        }
    return block;
}

}  // namespace detail

ANCF_INLINE SectionStiffness section_stiffness(const Material& material, const Section& section,
                                               SectionModel model) {
    material.validate();
    const Moments& moments = section.moments();
    const double shear_y = section.shear_correction_y() * material.shear;
    const double shear_z = section.shear_correction_z() * material.shear;

    SectionStiffness stiffness;
    stiffness.axial = moments.has_fourth_order()
                          ? detail::moment_matrix<6>(moments, material.young)
                          : detail::second_order_block(moments, material.young);
    if (model == SectionModel::saint_venant) {
        const Moments centred = centroidal(moments);
        const SectionPoint centre = section.shear_centre();
        const double torsion = material.shear * section.torsion_constant() / centred.polar();
        stiffness.shear_y =
            detail::saint_venant_block(moments, shear_y, torsion * centred.zz, 2, centre.z);
        stiffness.shear_z =
            detail::saint_venant_block(moments, shear_z, torsion * centred.yy, 1, centre.y);
    } else {
        stiffness.shear_y = detail::moment_matrix<3>(moments, shear_y);
        stiffness.shear_z = detail::moment_matrix<3>(moments, shear_z);
    }
    stiffness.transverse_yy = stiffness.transverse_zz = material.young * moments.area;
    stiffness.transverse_yz = (shear_y + shear_z) / 2.0 * moments.area;
    return stiffness;
}

}  // namespace ancf
