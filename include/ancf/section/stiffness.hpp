// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// The constant section matrix: stress resultants sigma = C s of the generalised section strains s.
///
/// The strain energy of [Dufva2006, Eq. 29] per length is s^T C s/2 for
///
///     e_xx   = eps + y b_y + z b_z + y^2 (a_yy/2) + y z a_yz + z^2 (a_zz/2)
///     2 e_xy = g_y + y h_yy + z h_zy          2 e_xz = g_z + y h_yz + z h_zz
///
/// so that C is three blocks of moments times a modulus, full where the section has odd moments.

#pragma once

#include <ancf/section/material.hpp>
#include <ancf/section/section.hpp>
#include <ancf/types.hpp>

namespace ancf {

/// The blocks of the section matrix, symmetric. Units: N times m^(degree of the row's + of the
/// column's monomial).
struct SectionStiffness {
    Matrix<double, 6> axial;    ///< E int p p^T dA of (eps, b_y, b_z, a_yy/2, a_yz, a_zz/2)
    Matrix<double, 3> shear_y;  ///< k_y G int p p^T dA, p = (1, y, z), of (g_y, h_yy, h_zy)
    Matrix<double, 3> shear_z;  ///< k_z G int p p^T dA, p = (1, y, z), of (g_z, h_yz, h_zz)
    double transverse_yy;       ///< E A of e_yy, N
    double transverse_zz;       ///< E A of e_zz, N
    double transverse_yz;       ///< (k_y + k_z)/2 G A of 2 e_yz, N
};

/// Returns the section matrix of a material and a section.
///
/// SectionModel::paper is the equation above: a twist rate om = h_yz = -h_zy meets
/// G (k_z int y^2 dA + k_y int z^2 dA).
///
/// SectionModel::saint_venant replaces the rows of the two strains that carry torsion. About the
/// centroid, with Iyy = int y^2 dA and Izz = int z^2 dA there, the diagonal entry of h_yz is
/// G J Iyy/(Iyy + Izz) and that of h_zy is G J Izz/(Iyy + Izz), without k; pure twist meets G J.
/// Their couplings with the in-plane strains h_zz and h_yy (int y z dA) are dropped: J holds the
/// whole torsional stiffness, and the blocks must stay positive definite however small it is.
/// For a reference axis elsewhere the shear forces meet the strains
///
///     g_y + y_c h_yy + z_s h_zy          g_z + y_s h_yz + z_c h_zz
///
/// of the centroid (y_c, z_c) and, in the twist, of the shear centre (y_s, z_s): a force through it
/// does not twist the section. The blocks are those of the centroid transported by this relation.
/// With Section::with_shear_centre() unset the centroid stands for it, as in the paper's model:
/// exact with two axes or a point of symmetry.
///
/// A section known to second order only (Moments::has_fourth_order) gives the terms quadratic in y
/// and z about its centroid no stiffness. With the centroid on the axis rows and columns 4 to 6 of
/// `axial` are zero; else they have what these terms add to the strain of the centroid.
/// @throws InvalidArgument if the material has a value that is not positive, or the model needs a
///         shear correction factor or torsion constant that the section leaves unset.
[[nodiscard]] SectionStiffness section_stiffness(const Material& material, const Section& section,
                                                 SectionModel model = SectionModel::paper);

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/section/stiffness.ipp>  // IWYU pragma: export
#endif
