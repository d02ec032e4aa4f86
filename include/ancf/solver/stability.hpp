// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Whether an equilibrium is stable: docs/theory-statics.md, "Stability".

#pragma once

#include <ancf/compiler.hpp>
#include <ancf/list.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/solver/sparse_ldlt.hpp>
#include <ancf/types.hpp>

#include <string_view>

namespace ancf {

class Assembly;

/// What the second variation of the energy says of an equilibrium.
enum class Stability {
    unknown,  ///< not judged; or loads without a potential decide, or the state is too close to a
              ///< critical point to tell
    stable,   ///< positive for all displacements that supports and constraints allow
    unstable  ///< negative for one: a bifurcation or limit point was passed, or the mesh has a
              ///< branch of its own
};

/// The word that tables print.
[[nodiscard]] constexpr std::string_view to_string(Stability stability) noexcept {
    switch (stability) {
        case Stability::stable: return "stable";
        case Stability::unstable: return "unstable";
        case Stability::unknown: break;
    }
    return "unknown";
}

/// Judges the state of an assembly's last evaluation, with its tangent, by the signs of its pivots.
///
/// Under loads without a potential the symmetric part decides one way: where it is positive, the
/// state is stable against any static disturbance.
/// @param counted  the factorisation of that tangent, of which a count of negative pivots serves
///                 where it is well conditioned; without it, one more factorisation
/// @param solver   has the factors counted where they are of an earlier state's tangent: the count
///                 then serves only where no sign can have changed since
[[nodiscard]] Stability stability(const Assembly& assembly, const FactorReport& counted = {},
                                  const LinearSolver* solver = nullptr);

namespace detail {

/// Returns for each free coordinate the largest stiffness among those of its unit. Where that is
/// zero, it is what resists a displacement by the scene's size as the stiffest of all does.
/// @param diagonal  of the tangent, free coordinates alone
[[nodiscard]] VectorX stiffest_of_unit(const Assembly& assembly, const VectorX& diagonal);

/// Appends the lower half of the stiffness of constraints as springs.
/// @param tangent    of full storage: its last columns hold the constraints' gradients
/// @param stiffness  how many times a spring is as stiff as what it holds
/// @param held       stiffness of each free coordinate
/// @param otherwise  what counts instead where a constraint holds none that is positive
/// @param diagonal   of the tangent; grows with the springs
/// @return false where nothing has a stiffness.
bool add_springs(const SparseMatrix& tangent, double stiffness, const VectorX& held,
                 const VectorX& otherwise, VectorX& diagonal, List<MatrixEntry>& entries);

/// In how many directions that constraints allow a tangent is negative.
struct NegativeDirections {
    int count = -1;        ///< -1 = unknown
    bool certain = false;  ///< whether no pivot and no energy is round-off
};

/// Counts those of the symmetric part of a tangent by its pivots. Constraints are springs, and rows
/// of the matrix where springs do not prove that there are none.
/// @param tangent    in the pattern of the assembly's
/// @param symmetric  whether it is
[[nodiscard]] NegativeDirections negative_directions(const Assembly& assembly,
                                                     const SparseMatrix& tangent, bool symmetric);

/// Returns those of a symmetric tangent that a solver has factorised, as the solver counts them
/// where it does; unknown where it only iterates.
[[nodiscard]] NegativeDirections negative_directions(const Assembly& assembly,
                                                     const SparseMatrix& tangent,
                                                     const FactorReport& factor,
                                                     const LinearSolver& solver);

/// Tells whether an assembly's tangent K is so near an earlier one K_0, whose factors a solver has,
/// that both have the same signs: no eigenvalue of K_0^-1 (K - K_0) is of the size of 1.
[[nodiscard]] bool has_same_signs(const Assembly& assembly, const LinearSolver& solver);

/// Tells whether a displacement meets no stiffness: the energy of the softest one is round-off
/// beside that of its vectors' stiffnesses, each by itself. Slenderness and direction count less
/// than in the condition of the tangent.
/// @param solver  has the tangent factorised
[[nodiscard]] bool moves_freely(const Assembly& assembly, const LinearSolver& solver);

/// Tells whether supports alone keep every part of a scene in the plane, joined by its elements,
/// from moving rigidly; not of scenes with attached nodes.
[[nodiscard]] bool supports_hold(const Assembly& assembly);

/// Tells whether the softest motions of D dx/dt = -K x decay, D the diagonal of the tangent K: what
/// pivots of the symmetric part do not say under loads without a potential.
/// @param solver  has the tangent factorised, or one near it
[[nodiscard]] bool softest_decay(const Assembly& assembly, const LinearSolver& solver);

}  // namespace detail

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/stability.ipp>
#endif
