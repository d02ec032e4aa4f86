// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// What elements return: energy, elastic force and tangent of one pass; resultants of a section.

#pragma once

#include <ancf/types.hpp>

namespace ancf {

/// Energy and its first and second derivative with respect to the nodal coordinates e.
///
/// An aggregate: `const auto [energy, force, tangent] = element.evaluate(e);`
template <class Scalar, int Dofs>
struct Evaluation {
    Scalar energy;                 ///< U, J
    Vector<Scalar, Dofs> force;    ///< Q = dU/de, N for positions and N m for slopes
    Matrix<Scalar, Dofs> tangent;  ///< K = dQ/de, symmetric
};

/// The same with the tangent of mixed integration points.
template <class Scalar, int Dofs>
struct MixedEvaluation : Evaluation<Scalar, Dofs> {
    Vector<Scalar, Dofs> predicted;  ///< B^T sigma of the stresses that the tangent has
};

/// Force and moment about the centre line that the part at larger x exerts on the part at smaller
/// x.
///
/// Resolved in the orthonormal frame (t, n, c) of the deformed section: t is the unit tangent, n
/// and c = t x n are nearest to the slopes r_y and r_z projected on the normal plane. In the plane
/// only axial, shear_y and moment_z are not zero.
struct SectionForces {
    double axial = 0.0;     ///< N = int sigma dA, positive in tension; N
    double shear_y = 0.0;   ///< Q_y, along n; N
    double shear_z = 0.0;   ///< Q_z, along c; N
    double torque = 0.0;    ///< T, about t; N m
    double moment_y = 0.0;  ///< M_y = int z sigma dA, about n; N m
    double moment_z = 0.0;  ///< M_z = -int y sigma dA, about c; N m
};

}  // namespace ancf
