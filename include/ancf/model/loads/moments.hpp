// SPDX-FileCopyrightText: 2026 The ancf authors
// SPDX-License-Identifier: BSD-3-Clause

/// @file
/// Moments on one slope of a node, with their exact stiffness.
///
/// A moment acts on slopes, so its generalised force depends on them. docs/theory-statics.md
/// derives each.

#pragma once

#include <ancf/element/fields.hpp>
#include <ancf/model/load.hpp>
#include <ancf/model/node.hpp>
#include <ancf/types.hpp>
#include <ancf/vector_argument.hpp>

namespace ancf {

/// A moment m about a fixed unit axis n that works through the angle of one slope a, N m.
///
///     Q_a = m (n x a_p)/|a_p|^2,    a_p = a - (a.n) n
///
/// It is a moment about n while the slope stays normal to n: in planar bending and in pure twist.
/// A slope parallel to n has no angle about it; a run that comes there ends as not_finite.
/// Its potential is -m times that angle.
class SlopeMoment {
public:
    static constexpr int dimension = 3;                ///< of the model it belongs to
    static constexpr bool symmetric_stiffness = true;  ///< its stiffness is symmetric

    /// @param slope   r_x, r_y or r_z.
    /// @param axis    of any length but zero.
    /// @param moment  N m.
    /// @throws InvalidArgument for another field, an axis of no length, or a value that is not
    ///         finite.
    SlopeMoment(NodeId node, Field slope, const VectorArgument<3>& axis, double moment);

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, slope_}}; }

    /// Returns the generalised force on the slope, 3 x 1, N m.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, 3> force(const Vector<Scalar, 3>& slope) const;

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    NodeId node_;
    Field slope_;
    Vector<double, 3> axis_;
    double moment_;
};

/// The moment of SlopeMoment in the plane: counterclockwise positive, N m; of potential -m times
/// the slope's angle.
class PlanarSlopeMoment {
public:
    static constexpr int dimension = 2;                ///< of the model it belongs to
    static constexpr bool symmetric_stiffness = true;  ///< its stiffness is symmetric

    /// @param slope   r_x or r_y.
    /// @param moment  N m.
    /// @throws InvalidArgument for another field or a moment that is not finite.
    PlanarSlopeMoment(NodeId node, Field slope, double moment);

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, slope_}}; }

    /// Returns the generalised force on the slope, 2 x 1, N m.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, 2> force(const Vector<Scalar, 2>& slope) const;

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    NodeId node_;
    Field slope_;
    double moment_;
};

/// A moment vector fixed in space on a node that has no slope but r_x, N m.
///
/// Only the part of m normal to the tangent does work: Q_rx = (m x t)/|r_x|.
class TangentMoment {
public:
    static constexpr int dimension = 3;  ///< of the model it belongs to

    /// @throws InvalidArgument unless the moment is finite.
    TangentMoment(NodeId node, const VectorArgument<3>& moment);

    /// Returns the nodal vectors it acts on.
    [[nodiscard]] Coupling coupling() const { return {{node_, Field::r_x}}; }

    /// Returns the generalised force on r_x, 3 x 1, N m.
    template <class Scalar>
    [[nodiscard]] Vector<Scalar, 3> force(const Vector<Scalar, 3>& slope) const;

    /// Evaluates it where it stands.
    void evaluate(const LoadState& state, LoadResult& out) const;

private:
    NodeId node_;
    Vector<double, 3> moment_;
};

}  // namespace ancf

#if !defined(ANCF_COMPILED)
#include <ancf/model/loads/moments.ipp>  // IWYU pragma: export
#endif
