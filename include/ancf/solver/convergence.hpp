// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// How far a scene is from equilibrium, in numbers without units.
///
/// Forces and the moments that work on slopes are measured apart, each against the loads and
/// reactions of the scene, so that neither units nor slenderness decide when a solution stops.

#pragma once

#include <ancf/assembly/assembly.hpp>
#include <ancf/assembly/numbering.hpp>
#include <ancf/compiler.hpp>
#include <ancf/records.hpp>
#include <ancf/types.hpp>

namespace ancf {

namespace detail {

/// Returns the diagonal of the box around all positions, m; 0 of none.
/// @param exchange  of a part of a scene, whose other parts count too
[[nodiscard]] double diagonal_of(const Layout& layout, int dimension, const VectorX& q,
                                 const detail::Exchange* exchange = nullptr);

}  // namespace detail

/// Measures residuals and corrections of one scene.
class ConvergenceMonitor {
public:
    /// Measures the scene as it stands.
    ConvergenceMonitor(const Scene& model, const Numbering& numbering);

    /// Returns the violation of constraints of the last evaluation relative to what changes by the
    /// scene's size, of slopes by one, make of it.
    [[nodiscard]] double violation(const Assembly& assembly) const;

    /// Returns the larger of violation() and the residual of the last evaluation relative to loads,
    /// reactions and constraint forces.
    [[nodiscard]] double residual(const Assembly& assembly) const;

    /// Returns whether the residual is within the round-off of its own evaluation: below
    /// eps |K| |q|, what a relative change of every coordinate by eps makes of it. |K| is that of
    /// the free coordinates; what is held enters as docs/theory-statics.md says.
    [[nodiscard]] bool at_round_off(const Assembly& assembly, const VectorX& q) const;

    /// Returns the largest change of a position relative to the scene's size, of a slope, or of
    /// r_xx times the elements' length.
    [[nodiscard]] double correction(const VectorX& unknowns) const;

    /// Returns the diagonal of the scene, m.
    [[nodiscard]] double size() const noexcept { return size_; }

private:
    // Euclidean norms over positions, over slopes and what works on r_xx by the elements' length
    struct Norms {
        double force = 0.0;
        double moment = 0.0;
    };

    template <class Entry>
    [[nodiscard]] Norms norms(const Entry& entry) const;
    // Of the forces that no support takes.
    [[nodiscard]] Norms unbalanced(const Assembly& assembly) const;

    const Numbering& numbering_;
    const detail::Exchange* exchange_;  // of a part of a scene
    detail::Records<int> power_;        // of a length in the unit, per coordinate
    double size_ = 1.0;                 // diagonal of the scene, m
    double element_size_ = 1.0;         // mean reference length, m
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/convergence.ipp>
#endif
