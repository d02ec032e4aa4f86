// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Forces of a step that do exactly the work by which an energy changes, without moving momenta.
///
/// With the middle e_m of a step, the change De and its part D that no rigid motion at e_m
/// explains, u the mean of both ends without their turn, S the symmetric part of half that turn
/// (HalfTurn) and x the nodal vectors of e_m:
///
///     f = f_0 + s W D,   f_0 = S grad U(u) + W (mu x x),   s = (U(e_1) - U(e_0) - f_0.De)/(D.W D).
///
/// f.De = U(e_1) - U(e_0), and f has neither a resultant nor a moment. docs/theory-dynamics.md.

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/dynamics/rigid_modes.hpp>
#include <ancf/model/element_group.hpp>
#include <ancf/types.hpp>

#include <vector>

namespace ancf::detail {

/// What a step needs of one element, and the memory to compute it; of its dofs() coordinates.
struct StepForce {
    double energy = 0.0;                                              ///< U(e_1), J
    double force[ElementGroup::max_dofs];                             ///< f
    double tangent[ElementGroup::max_dofs * ElementGroup::max_dofs];  ///< df/de_1, by columns
    RigidModes modes;                                                 ///< at the middle
};

/// How much of the tangent is wanted.
enum class StepTangent {
    none,
    symmetric,  ///< K(u)/2: what a solver of symmetric matrices can take
    exact       ///< with the derivative of s W D, unsymmetric
};

/// Evaluates one element, given by its prototype, over a step.
/// @param before  U(e_0), J.
void step_force(const ElementGroup& group, int prototype, const double* e0, const double* e1,
                double before, StepTangent wanted, StepForce& out);

/// Corrects the middle's gradient G_m of one function of a few nodal vectors to the discrete
/// gradient.
/// @param difference    g(q_1) - g(q_0).
/// @param length_power  of each vector's unit.
/// @param invariant     whether rigid motions leave g as it is: then the correction moves no
///                      momentum.
void correct_gradient(int dimension, double difference, const VectorX& middle,
                      const VectorX& change, bool invariant, const std::vector<int>& length_power,
                      double length, VectorX& gradient);

}  // namespace ancf::detail

#if !defined(ANCF_COMPILED)
#include <ancf/dynamics/discrete_gradient.ipp>  // IWYU pragma: export
#endif
