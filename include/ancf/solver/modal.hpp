// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Natural frequencies about any state, and linear buckling: docs/theory-modal.md.
///
/// Both are the largest eigenvalues th of B x = th A x with A factorised once: A = K - shift M and
/// B = M for vibration, A = K_0 and B = -dK/df for buckling. Constraints stay in A.

#pragma once

#include <ancf/assembly/assembly.hpp>
#include <ancf/compiler.hpp>
#include <ancf/constants.hpp>
#include <ancf/error.hpp>
#include <ancf/list.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/solver/linear_solver.hpp>
#include <ancf/types.hpp>

#include <cmath>
#include <optional>
#include <string>

namespace ancf {

/// What modes are wanted and how well.
struct ModalOptions {
    int count = 6;             ///< number of modes
    double factor = 1.0;       ///< vibration: load factor of the state that the model is in, which
                               ///< is State::time after statics and paths
    double shift = 0.0;        ///< rad^2/s^2, below all wanted; negative for bodies that can move
    double tolerance = 1e-10;  ///< relative change of the eigenvalues
    int max_iterations = 500;  ///< of the subspace

    /// @throws InvalidArgument naming the first value that cannot be meant.
    void check() const;
};

/// One mode.
struct Mode {
    double value;     ///< vibration: omega^2, rad^2/s^2; buckling: the load factor
    double residual;  ///< |B x - th A x|/(th |A x|)
    VectorX shape;    ///< all coordinates; of unit modal mass, or x^T K_0 x = 1

    /// Returns omega/(2 pi), Hz; negative where the square is.
    [[nodiscard]] double frequency() const noexcept {
        return std::copysign(std::sqrt(std::abs(value)), value) / (2.0 * pi);
    }
};

/// What an eigenvalue analysis reports.
struct ModalReport {
    Status status = Status::converged;  ///< why it ended
    List<Mode> modes;            ///< by rising value, of buckling by rising magnitude; none where
                                 ///< supports hold everything, of vibrations also where constraints
                                 ///< do, or the status is neither converged nor max_iterations
    int iterations = 0;          ///< solutions with the whole subspace
    std::optional<Fault> fault;  ///< the element that failed, for degenerate and not_finite
    std::string message = {};    ///< what failed; of a singular tangent, what moves without
                                 ///< stiffness; of vibrations also why fewer than are wanted are
                                 ///< there, whether the state is out of balance or violates
                                 ///< constraints, whether loads have no potential. Else empty
};

/// Returns the lowest natural modes of small vibrations about the model's state, undamped.
///
/// The state counts as one of rest: of a body that spins its stresses count, not its gyroscopic and
/// centrifugal terms.
/// @param model   in the state to vibrate about; it is left as it is.
/// @param solver  any linear solver (linear_solver.hpp).
/// @return        at most options.count modes; omega^2 in rad^2/s^2, shapes of unit modal mass.
/// @throws InvalidArgument for options that cannot be meant, or a scene that the solver's storage
///         does not suit.
/// @note  a state with an element that is no beam (docs/limits.md, "Directors") has no modes, and
///        no buckling loads either: status degenerate.
/// @note  the factorised K - shift M must be positive definite on what constraints allow: status
///        singular where it is not; lower the shift. Solvers that iterate find that out from the
///        modes sought alone. Of unsymmetric load stiffness the symmetric part counts.
ANCF_LAZY [[nodiscard]] ModalReport natural_modes(const Scene& model, LinearSolver& solver,
                                                  const ModalOptions& options = {});

/// Returns the load factors at which the stresses of a load make the tangent singular; negative
/// ones are of the reversed load.
///
/// The model stands in equilibrium without load. Stresses and multipliers grow with the load factor
/// as linear theory has it. Elements that evaluate a tangent at given stresses keep their place; of
/// others and of springs the deflection counts as well, which must then be small:
/// docs/theory-modal.md.
/// @param model   unloaded in its state; it is left as it is.
/// @param solver  any linear solver (linear_solver.hpp).
/// @return        at most options.count modes; load factors, 1, of a pair of either sign the
///                positive one first; shapes with x^T K_0 x = 1.
/// @throws InvalidArgument for options that cannot be meant, a scene that the solver's storage does
///         not suit, supports or constraints that move with the load factor, loads whose part in
///         the tangent is not symmetric, and a state with more than a hundredth of the load found.
ANCF_LAZY [[nodiscard]] ModalReport buckling_modes(const Scene& model, LinearSolver& solver,
                                                   const ModalOptions& options = {});

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/modal.ipp>
#endif
