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

}  // namespace detail

ANCF_INLINE SectionStiffness section_stiffness(const Material& material, const Section& section,
                                               SectionModel model) {
    material.validate();
    const Moments& moments = section.moments();
    const double shear_y = section.shear_correction_y() * material.shear;
    const double shear_z = section.shear_correction_z() * material.shear;

    SectionStiffness stiffness;
    stiffness.axial = detail::moment_matrix<6>(moments, material.young);
    if (!moments.has_fourth_order()) {
        for (int i = 0; i < 6; ++i)
            for (int j = 3; j < 6; ++j) stiffness.axial(i, j) = stiffness.axial(j, i) = 0.0;
    }
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
