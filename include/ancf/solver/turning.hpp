// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Corrections whose rotations stay rotations: docs/theory-statics.md, "Corrections that turn".
///
/// Adding a linear correction stretches a slope that turns by tan of the angle. Here a correction
/// turns slopes and chords instead, by what it says or by what adding would have turned them. All
/// agree to first order, so Newton's method keeps its speed.

#pragma once

#include <ancf/assembly/numbering.hpp>
#include <ancf/compiler.hpp>
#include <ancf/element/vec3.hpp>
#include <ancf/list.hpp>
#include <ancf/model/layout.hpp>
#include <ancf/model/scene.hpp>
#include <ancf/solver/sparse_ldlt.hpp>
#include <ancf/types.hpp>

#include <array>

namespace ancf {

/// By how much a correction of d across a vector of length 1 turns it.
enum class TurnBy {
    angle,   ///< d: right where moments prescribe rotations
    tangent  ///< atan d, as adding does: right where forces do, whose directions do not turn
};

/// Replaces the sum of coordinates and correction by one in which things turn.
class Turning {
public:
    /// Finds what turns in a scene.
    Turning(const Scene& model, const Numbering& numbering);

    /// Turns slopes about the tangents alone: what a twist does.
    /// @param before,change  coordinates and correction, all coordinates
    /// @param q              before + change on entry
    void twist(const VectorX& before, const VectorX& change, VectorX& q) const;

    /// Turns slopes by their rotation, their rates along the line with the tangent, and the chords
    /// of elements by theirs; positions follow the chords as well as they can, in least squares.
    void turn(const VectorX& before, const VectorX& change, VectorX& q, TurnBy by = TurnBy::angle);

    /// Adds what turning instead of adding makes of the tangent: residual . d2q/dx2, where q
    /// depends on the correction x as turn() has it, r_xx and r_xy left out;
    /// docs/theory-statics.md, "The tangent of a turn".
    /// @param q         coordinates where the tangent was taken
    /// @param residual  there, of the unknowns, of the stresses that the tangent has
    /// @param pattern   of the tangent, all of it or its lower half
    /// @param values    its values
    /// @param chords    of positions too, not of slopes alone
    void add_curvature(const VectorX& q, const VectorX& residual, const SparseMatrix& pattern,
                       double* values, bool chords = true);

    /// Returns the largest angle by which a correction turns a slope, to first order.
    [[nodiscard]] double largest_angle(const VectorX& before, const VectorX& change) const;

private:
    // The slopes of a node.
    struct Slopes {
        int first;   // coordinate
        int count;   // of vectors
        bool whole;  // a frame, or one less r_z, all of it free
    };

    // What ties the same component of all positions together.
    struct Component {
        List<int> unknown;  // of each node, -1 where there is none
        int count = 0;
        detail::SparseLdlt factors;
    };

    static constexpr Field slope_rates[] = {Field::r_xx, Field::r_xy};

    [[nodiscard]] Slopes slopes(int node) const;
    // Of a vector, by its first coordinate.
    [[nodiscard]] bool is_free(int first) const {
        for (int k = first; k < first + dimension_; ++k)
            if (numbering_.equation(k) < 0) return false;
        return true;
    }
    [[nodiscard]] detail::Vec3<double> vector_of(const std::array<int, 2>& chord,
                                                 const VectorX& x) const;
    [[nodiscard]] double twist(const std::array<int, 2>& chord, const VectorX& before,
                               const VectorX& change) const;
    void add_curvature_of_slope(int first, const VectorX& q, const VectorX& residual,
                                const SparseMatrix& pattern, double* values) const;
    void add_curvature_of_rate(int rate, const Slopes& at, const VectorX& q,
                               const VectorX& residual, const SparseMatrix& pattern,
                               double* values) const;
    void add_curvature_of_chord(const std::array<int, 2>& chord, const double* forces,
                                const VectorX& q, const SparseMatrix& pattern,
                                double* values) const;
    [[nodiscard]] List<double> chord_forces(const VectorX& residual) const;
    void factorize() {
        for (int k = 0; !factorised_ && k < dimension_; ++k) factorize(k);
        factorised_ = true;
    }
    void factorize(int component);
    void shift(int component, const List<double>& wanted, VectorX& q);

    const Layout& layout_;
    const Numbering& numbering_;
    int dimension_;
    List<std::array<int, 2>> chords_;
    std::array<Component, 3> components_;
    bool factorised_ = false;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/solver/turning.ipp>
#endif
